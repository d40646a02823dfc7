!> The precision of VUINTER's arguments, which is that of the run of ABAQUS/Explicit that calls it.
module asperity_abaqus_vuinter_precision
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private

   !> Kind of VUINTER's real arguments; all computing is done in `wp`. It is set here alone:
   !> cmake/abaqus.cmake writes a second file from the same sources with the other kind
   integer, parameter, public :: vp = real64

end module asperity_abaqus_vuinter_precision
