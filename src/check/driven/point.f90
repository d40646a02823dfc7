!> A contact point that a user routine is called for: what it is given, and what it answers.
module asperity_check_driven_point
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_check_driven_layout, only: same_bits
   use asperity_contact_state, only: no_rotation, no_surface_limit
   implicit none
   private
   public :: point_start, point_motion, point_answer, motion_to, next_start, is_usable, &
      has_surface, same_answer

   !> What is known at the start of an increment.
   type :: point_start
      !> Tractions, MPa; relative position: overclosure, then slip since the start, mm
      real(wp) :: stress(3) = 0.0_wp, rdisp(3) = 0.0_wp
      !> State variables
      real(wp), allocatable :: statev(:)
      !> Stored energy, total, N/mm; time since the start, s
      real(wp) :: sed = 0.0_wp, time = 0.0_wp
      !> Number of the increment; flags of UINTER
      integer :: increment = 1, lopenclose = -1, lstate = -1
   end type point_start

   !> The motion of an increment.
   type :: point_motion
      !> Relative position at its end and the change, mm
      real(wp) :: rdisp(3) = 0.0_wp, drdisp(3) = 0.0_wp
      !> Rotation of the slip directions; length of the increment, s
      real(wp) :: drot(2, 2) = no_rotation, dtime = 1.0_wp
      !> Iteration, 0 first; 1 in a linear perturbation step
      integer :: kit = 1, linper = 0
   end type point_motion

   !> What a routine answers.
   type :: point_answer
      real(wp) :: stress(3) = 0.0_wp, ddsddr(3, 3) = 0.0_wp
      real(wp), allocatable :: statev(:)
      !> Stored energy, total, and all dissipation of the increment, N/mm
      real(wp) :: sed = 0.0_wp, dissipation = 0.0_wp
      !> Factor on the increment that is asked for
      real(wp) :: pnewdt = 1.0_wp
      integer :: lopenclose = -1, lstate = -1, lsdi = 0
      !> All numbers after the call, in the order of the routine's layout
      real(wp), allocatable :: numbers(:)
      !> The same before it
      real(wp), allocatable :: before(:)
      !> Argument and entry that was written to and must not be; zero for none
      integer :: damaged_slot = 0, damaged_entry = 0
      !> Integer or text that is an input and was written to; blank for none
      character(len=9) :: changed = ''
   end type point_answer

contains

   !> The motion from a start to an overclosure and slips.
   pure type(point_motion) function motion_to(start, rdisp, dtime, kit) result(motion)
      !> The start
      type(point_start), intent(in) :: start
      !> Relative position at the end, mm
      real(wp), intent(in) :: rdisp(3)
      !> Length of the increment, s
      real(wp), intent(in) :: dtime
      !> Iteration
      integer, intent(in) :: kit

      motion%rdisp = rdisp
      motion%drdisp = rdisp - start%rdisp
      motion%dtime = dtime
      motion%kit = kit
   end function motion_to

   !> The start of the increment after an accepted one.
   pure subroutine next_start(start, motion, answer, next)
      !> Its start, motion and answer
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      type(point_answer), intent(in) :: answer
      !> Result
      type(point_start), intent(out) :: next

      allocate (next%statev(size(answer%statev)))
      next%statev = answer%statev
      next%stress = answer%stress
      next%rdisp = motion%rdisp
      next%sed = answer%sed
      next%time = start%time + motion%dtime
      next%increment = start%increment + 1
      next%lopenclose = answer%lopenclose
      next%lstate = answer%lstate
   end subroutine next_start

   !> Whether tractions and state are numbers, so that a next increment can begin.
   pure logical function is_usable(answer)
      !> The answer
      type(point_answer), intent(in) :: answer

      is_usable = all(is_finite(answer%stress)) .and. all(is_finite(answer%statev))
   end function is_usable

   !> Whether there is a surface opposite.
   pure logical function has_surface(overclosure)
      !> RDISP(1), mm
      real(wp), intent(in) :: overclosure

      has_surface = overclosure > no_surface_limit
   end function has_surface

   !> Whether all numbers and flags of two answers are the same, bit for bit.
   pure logical function same_answer(a, b)
      !> The two
      type(point_answer), intent(in) :: a, b

      same_answer = all(same_bits(a%numbers, b%numbers)) .and. a%lopenclose == b%lopenclose &
         .and. a%lstate == b%lstate .and. a%lsdi == b%lsdi
   end function same_answer

end module asperity_check_driven_point
