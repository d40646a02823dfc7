!> Units of what the program writes, in those that it computes with (N, mm): one unit for one
!> quantity in every file.
module asperity_program_report_units
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> Moments are written in kN m: that many of them are 1 N mm
   real(wp), parameter, public :: kilonewton_metre = 1.0e-6_wp
   !> Energies are written in J: that many of them are 1 N mm
   real(wp), parameter, public :: joule = 1.0e-3_wp

end module asperity_program_report_units
