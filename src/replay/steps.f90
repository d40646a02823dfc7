!> Equal steps of a way that is to be gone.
module asperity_replay_steps
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: fewest_steps, steps_to_turn

contains

   !> Fewest equal steps, none of them longer than a largest one; no way has none.
   pure integer function fewest_steps(way, largest)
      !> Way and largest step, in one unit
      real(wp), intent(in) :: way, largest

      ! the small part keeps 3/0.02 at 150
      fewest_steps = ceiling(min(way/largest*(1.0_wp - 1.0e-12_wp), 1.0e9_wp))
   end function fewest_steps

   !> Steps from the turning point before, or from zero.
   pure integer function steps_to_turn(turns, i, largest)
      !> Turning points, and which of them
      real(wp), intent(in) :: turns(:)
      integer, intent(in) :: i
      !> Largest step
      real(wp), intent(in) :: largest
      real(wp) :: from

      from = 0.0_wp
      if (i > 1) from = turns(i - 1)
      steps_to_turn = fewest_steps(abs(turns(i) - from), largest)
   end function steps_to_turn

end module asperity_replay_steps
