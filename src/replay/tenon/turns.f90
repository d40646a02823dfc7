!> Where the load point of the tenon joint turns: the paper's amplitudes, and what is refused of
!> amplitudes and of recorded displacements.
module asperity_replay_tenon_turns
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_sizes, only: slip_text
   implicit none
   private
   public :: check_amplitudes, check_displacement

   !> Range of the largest rotation of a programme, rad, which can be let pass. The model takes the
   !> cosine of the angle between tenon and mortise for one in bearing and friction: it is 0.97 at
   !> 0.25, where the edges press in by a quarter of a bearing depth and wood densifies. Tests end
   !> at 0.1 to 0.2. The lower limit is just above a thousandth of that, 0.13 mm at an arm of
   !> 500 mm, where nothing touches yet: a displacement in metres, or a rotation, looks like that
   real(wp), parameter :: largest_rotation = 0.25_wp, least_rotation = 2.6e-4_wp

   !> Largest displacement and arm, mm
   real(wp), parameter :: largest = 1.0e9_wp
   !> Most steps of a programme
   integer, parameter :: max_steps = 1000000

contains

   !> Amplitudes rise and are above zero, with one count each, and within reach of the arm.
   pure subroutine check_amplitudes(amplitudes, cycles, arm, increment, accepted, error)
      !> Amplitudes, mm, and cycles of each
      real(wp), intent(in) :: amplitudes(:)
      integer, intent(in) :: cycles(:)
      !> Distance of the load point, and largest step, mm
      real(wp), intent(in) :: arm, increment
      !> Let any rotation pass
      logical, intent(in) :: accepted
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      if (size(amplitudes) == 0) then
         call fatal_error(error, 'amplitudes is empty: give at least one in mm', &
            subject='amplitudes')
      else if (size(cycles) /= size(amplitudes)) then
         call fatal_error(error, 'cycles has '//to_text(size(cycles))//' entries, but there are '&
            //to_text(size(amplitudes))//' amplitudes: give one count an amplitude', &
            subject='cycles amplitudes')
      end if
      do i = 1, size(amplitudes)
         if (allocated(error)) return
         call check_positive(error, 'amplitudes', amplitudes(i), 'mm')
         if (allocated(error)) return
         if (cycles(i) < 1 .or. cycles(i) > max_steps) call fatal_error(error, 'cycles = '// &
            to_text(cycles(i))//' is not allowed: it must be 1 or more', subject='cycles')
      end do
      do i = 2, size(amplitudes)
         if (allocated(error)) return
         if (amplitudes(i) < amplitudes(i - 1)) call fatal_error(error, 'amplitudes = '// &
            to_text(amplitudes(i))//' mm after '//to_text(amplitudes(i - 1))// &
            ' mm is out of order: they must not fall; give a history instead', subject='amplitudes')
      end do
      if (.not. allocated(error)) &
         call check_reach(error, 'amplitudes', maxval(amplitudes), arm, accepted)
      if (allocated(error)) return
      call check_steps(sum(4.0_wp*cycles*amplitudes), 4.0_wp*sum(real(cycles, wp)), increment, &
         error)
   end subroutine check_amplitudes

   !> A recorded history is not empty and within reach of the arm.
   pure subroutine check_displacement(displacement, arm, increment, accepted, error)
      !> Displacements, distance of the load point, and largest step, mm
      real(wp), intent(in) :: displacement(:), arm, increment
      !> Let any rotation pass
      logical, intent(in) :: accepted
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i, n

      n = size(displacement)
      if (n == 0) then
         call fatal_error(error, 'displacement is empty: give at least one in mm', &
            subject='displacement')
         return
      end if
      do i = 1, n
         call check_range(error, 'displacement', displacement(i), -largest, largest, ' mm')
         if (allocated(error)) return
      end do
      call check_reach(error, 'displacement', displacement(maxloc(abs(displacement), 1)), arm, &
         accepted)
      if (allocated(error)) return
      call check_steps(abs(displacement(1)) + sum(abs(displacement(2:) - displacement(:n - 1))), &
         real(n, wp), increment, error)
   end subroutine check_displacement

   !> Refuse a largest displacement that is most likely in another unit, or turns the joint further
   !> than the model goes, or beyond the arm.
   pure subroutine check_reach(error, name, reach, arm, accepted)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: reach, arm
      logical, intent(in) :: accepted
      character(len=:), allocatable :: slip

      if (abs(reach) >= least_rotation*arm .and. abs(reach) <= largest_rotation*arm) return
      if (accepted) then
         call check_range(error, name, reach, -arm, arm, ' mm')
         return
      end if
      slip = trim(slip_text(reach, least_rotation*arm, largest_rotation*arm, 'mm'))
      if (abs(reach) < least_rotation*arm .and. abs(reach) >= least_rotation .and. &
         abs(reach) <= largest_rotation) slip = slip//', or like a rotation in rad'
      if (abs(reach) > largest_rotation*arm .and. abs(reach) <= arm) &
         slip = 'check its unit and the arm'
      if (abs(reach) <= arm) slip = slip//'; accept_sizes lets it pass'
      call fatal_error(error, name//' = '//to_text(reach)//' mm is a rotation of '// &
         to_text(abs(reach)/arm, 3)//' rad at arm = '//to_text(arm)//' mm, outside '// &
         to_text(least_rotation)//' to '//to_text(largest_rotation)//' rad: '//slip, subject=name)
   end subroutine check_reach

   pure subroutine check_steps(travel, turns, increment, error)
      real(wp), intent(in) :: travel, turns, increment
      type(error_type), allocatable, intent(out) :: error

      if (travel/increment + turns > max_steps) call fatal_error(error, &
         'displacement_increment = '//to_text(increment)// &
         ' mm gives more than '//to_text(max_steps)//' steps; make it larger', &
         subject='displacement_increment')
   end subroutine check_steps

end module asperity_replay_tenon_turns
