!> What a check of a user routine is told: its properties, its state, the sizes of its motions.
module asperity_check_settings
   use asperity_base_kinds, only: wp
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_settings

   !> Lengths in mm, times in s; of another system of units if all properties are.
   type :: check_settings
      !> PROPS
      real(wp), allocatable :: properties(:)
      !> Length of STATEV
      integer :: nstatv = 0
      !> Components of the relative motion; both numbers are tried where this is zero
      integer :: ndir = 0
      !> How far the faces pass each other, how far they part, how far they slip
      real(wp) :: largest_overclosure = 0.1_wp, largest_gap = 0.1_wp, largest_slip = 0.1_wp
      !> Length of an increment
      real(wp) :: time_increment = 1.0_wp
      !> Whether a VUINTER takes single precision
      logical :: single_precision = .false.
      !> A path in place of ours; not allocated components for none
      type(motion_path) :: path
   end type check_settings

end module asperity_check_settings
