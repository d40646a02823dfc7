!> Load programme of the tenon joint: displacements of the load point, step by step.
module asperity_replay_tenon_load_path
   use asperity_base_kinds, only: wp
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
      integer, allocatable :: cycles(:), cycle_of_turn(:)
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

      n = 0
      do i = 1, size(turns)
         n = n + steps_between(turns, i, settings%displacement_increment)
      end do
      allocate (path(0:n), source=0.0_wp)
      allocate (cycle_of(0:n), source=0)
      next = 0
      do i = 1, size(turns)
         n = steps_between(turns, i, settings%displacement_increment)
         do j = 1, n
            path(next + j) = path(next) + (turns(i) - path(next))*(real(j, wp)/n)
            cycle_of(next + j) = cycle_of_turn(i)
         end do
         ! what follows starts at the turn itself
         path(next + n) = turns(i)
         next = next + n
      end do
   end subroutine tenon_programme

   !> Steps from turn i - 1 (or rest) to i: a turn of zero length is one step.
   pure integer function steps_between(turns, i, increment)
      real(wp), intent(in) :: turns(:), increment
      integer, intent(in) :: i
      real(wp) :: from

      from = 0.0_wp
      if (i > 1) from = turns(i - 1)
      ! the small part keeps 48/0.1 at 480
      steps_between = max(1, ceiling(abs(turns(i) - from)/increment*(1.0_wp - 1.0e-12_wp)))
   end function steps_between

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
