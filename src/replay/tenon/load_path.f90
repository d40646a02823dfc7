!> Load programme of the tenon joint: displacements of the load point, step by step.
module asperity_replay_tenon_load_path
   use asperity_base_kinds, only: wp
   use asperity_replay_steps, only: steps_to_turn
   use asperity_replay_tenon_settings, only: tenon_amplitudes, tenon_settings
   implicit none
   private
   public :: tenon_programme

contains

   !> Displacements from the joint at rest on, and the cycle that each belongs to.
   pure subroutine tenon_programme(settings, path, cycle_of)
      !> Checked settings
      type(tenon_settings), intent(in) :: settings
      !> Displacements, mm, from 0
      real(wp), allocatable, intent(out) :: path(:)
      !> Cycle of each, from 0; 0 at rest
      integer, allocatable, intent(out) :: cycle_of(:)
      real(wp), allocatable :: turns(:), amplitudes(:)
      integer, allocatable :: cycles(:), cycle_of_turn(:), steps(:)
      integer :: i, j, n, next

      if (allocated(settings%displacement)) then
         allocate (turns, source=settings%displacement)
         allocate (cycle_of_turn(size(turns)))
         call count_cycles(turns, cycle_of_turn)
      else
         call tenon_amplitudes(settings, amplitudes, cycles)
         allocate (turns(3*sum(cycles)), cycle_of_turn(3*sum(cycles)))
         n = 0
         do i = 1, size(cycles)
            do j = 1, cycles(i)
               turns(3*n + 1:3*n + 3) = [amplitudes(i), -amplitudes(i), 0.0_wp]
               n = n + 1
               cycle_of_turn(3*n - 2:3*n) = n
            end do
         end do
      end if

      ! a turn of zero length is one step
      allocate (steps(size(turns)))
      steps = [(max(1, steps_to_turn(turns, i, settings%displacement_increment)), i=1, size(turns))]
      allocate (path(0:sum(steps)), source=0.0_wp)
      allocate (cycle_of(0:sum(steps)), source=0)
      next = 0
      do i = 1, size(turns)
         n = steps(i)
         do j = 1, n
            path(next + j) = path(next) + (turns(i) - path(next))*(real(j, wp)/n)
            cycle_of(next + j) = cycle_of_turn(i)
         end do
         ! what follows starts at the turn itself
         path(next + n) = turns(i)
         next = next + n
      end do
   end subroutine tenon_programme

   !> A cycle of a recorded history begins where the record passes zero upwards.
   pure subroutine count_cycles(turns, cycle_of_turn)
      real(wp), intent(in) :: turns(:)
      integer, intent(out) :: cycle_of_turn(:)
      integer :: i, n

      n = 1
      cycle_of_turn(1) = n
      do i = 2, size(turns)
         if (turns(i - 1) <= 0.0_wp .and. turns(i) > 0.0_wp .and. any(turns(:i - 1) < 0.0_wp)) &
            n = n + 1
         cycle_of_turn(i) = n
      end do
   end subroutine count_cycles

end module asperity_replay_tenon_load_path
