!> Where the load point of the tenon joint turns: the paper's amplitudes, and what is refused of
!> amplitudes and of recorded displacements.
module replay_tenon_turns
   use asperity, only: error_type, wp
   use asperity_error, only: fatal_error
   use asperity_properties, only: check_positive, check_range
   use asperity_text, only: to_text
   implicit none
   private
   public :: check_amplitudes, check_displacement

   !> The paper's programme: amplitudes, mm, and how many cycles of each
   real(wp), parameter, public :: default_amplitudes(9) = &
      [0.5_wp, 1.0_wp, 2.0_wp, 4.0_wp, 8.0_wp, 16.0_wp, 24.0_wp, 32.0_wp, 48.0_wp]
   integer, parameter, public :: default_cycles(9) = [1, 1, 1, 1, 3, 3, 3, 3, 3]

   !> Most steps of a programme
   integer, parameter :: max_steps = 1000000

contains

   !> Amplitudes rise and are above zero, with one count each, and within reach of the arm.
   pure subroutine check_amplitudes(amplitudes, cycles, arm, increment, error)
      !> Amplitudes, mm, and cycles of each
      real(wp), intent(in) :: amplitudes(:)
      integer, intent(in) :: cycles(:)
      !> Distance of the load point, and largest step, mm
      real(wp), intent(in) :: arm, increment
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (size(amplitudes) == 0) then
         call fatal_error(error, 'amplitudes is empty: give at least one in mm')
      else if (size(cycles) /= size(amplitudes)) then
         call fatal_error(error, 'cycles has '//to_text(size(cycles))//' entries, but there are '&
            //to_text(size(amplitudes))//' amplitudes: give one count an amplitude')
      end if
      do i = 1, size(amplitudes)
         if (allocated(error)) return
         call check_positive(error, 'amplitudes', amplitudes(i), 'mm')
         if (.not. allocated(error)) &
            call check_range(error, 'amplitudes', amplitudes(i), 0.0_wp, arm, ' mm')
         if (allocated(error)) return
         if (cycles(i) < 1 .or. cycles(i) > max_steps) call fatal_error(error, 'cycles = '// &
            to_text(cycles(i))//' is not allowed: it must be 1 or more')
      end do
      do i = 2, size(amplitudes)
         if (allocated(error)) return
         if (amplitudes(i) < amplitudes(i - 1)) call fatal_error(error, 'amplitudes = '// &
            to_text(amplitudes(i))//' mm after '//to_text(amplitudes(i - 1))// &
            ' mm is out of order: they must not fall; give a history instead')
      end do
      if (allocated(error)) return
      call check_steps(sum(4.0_wp*cycles*amplitudes), 4.0_wp*sum(real(cycles, wp)), increment, &
         error)
   end subroutine check_amplitudes

   !> A recorded history is not empty and within reach of the arm.
   pure subroutine check_displacement(displacement, arm, increment, error)
      !> Displacements, distance of the load point, and largest step, mm
      real(wp), intent(in) :: displacement(:), arm, increment
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i, n

      n = size(displacement)
      if (n == 0) then
         call fatal_error(error, 'displacement is empty: give at least one in mm')
         return
      end if
      do i = 1, n
         call check_range(error, 'displacement', displacement(i), -arm, arm, ' mm')
         if (allocated(error)) return
      end do
      call check_steps(abs(displacement(1)) + sum(abs(displacement(2:) - displacement(:n - 1))), &
         real(n, wp), increment, error)
   end subroutine check_displacement

   pure subroutine check_steps(travel, turns, increment, error)
      real(wp), intent(in) :: travel, turns, increment
      type(error_type), allocatable, intent(out) :: error

      if (travel/increment + turns > max_steps) call fatal_error(error, &
         'displacement_increment = '//to_text(increment)// &
         ' mm gives more than '//to_text(max_steps)//' steps; make it larger')
   end subroutine check_steps

end module replay_tenon_turns
