!> Which settings of the tenon joint are allowed.
module asperity_replay_tenon_check_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_sizes, only: check_between, check_size, range_of, size_range
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_amplitudes, &
      tenon_face_arm, tenon_settings
   use asperity_replay_tenon_turns, only: check_amplitudes, check_displacement
   use asperity_wood_properties, only: criteria
   implicit none
   private
   public :: check_tenon_settings

   !> Largest clearance over the height: with more, the tenon lies in its mortise at an angle
   real(wp), parameter :: clearance_ratio = 0.1_wp
   !> Most points of a face
   integer, parameter :: max_points = 100000
   real(wp), parameter :: largest = 1.0e9_wp, huge_value = 1.0e20_wp

contains

   !> `error` is set when a setting is not allowed.
   pure subroutine check_tenon_settings(settings, error, joint_only)
      !> Settings
      type(tenon_settings), intent(in) :: settings
      !> Set when a setting is refused
      type(error_type), allocatable, intent(out) :: error
      !> Leave out amplitudes and displacements, which are not known yet
      logical, intent(in), optional :: joint_only
      type(tenon_settings) :: complete
      real(wp), allocatable :: amplitudes(:)
      integer, allocatable :: cycles(:)

      complete = settings
      call complete_tenon_settings(complete)
      call check_sizes(complete, error)
      call check_wood(complete, error)
      call check_choices(complete, error)
      call check_ranges(complete, error)
      if (allocated(error)) return
      if (present(joint_only)) then
         if (joint_only) return
      end if
      if (allocated(settings%displacement)) then
         call check_displacement(settings%displacement, settings%arm, &
            settings%displacement_increment, settings%accept_sizes, error)
      else
         call tenon_amplitudes(settings, amplitudes, cycles)
         call check_amplitudes(amplitudes, cycles, settings%arm, settings%displacement_increment, &
            settings%accept_sizes, error)
      end if
   end subroutine check_tenon_settings

   pure subroutine check_sizes(s, error)
      type(tenon_settings), intent(in) :: s
      type(error_type), allocatable, intent(inout) :: error

      call need_positive(error, 'length', s%length, 'mm')
      call need_positive(error, 'height', s%height, 'mm')
      call need_positive(error, 'width', s%width, 'mm')
      call need_positive(error, 'arm', s%arm, 'mm')
      call need_positive(error, 'displacement_increment', s%displacement_increment, 'mm')
      call need_range(error, 'clearance_above', s%clearance_above, 0.0_wp, largest, ' mm')
      call need_range(error, 'clearance_below', s%clearance_below, 0.0_wp, largest, ' mm')
      call need_range(error, 'extension', s%extension, 0.0_wp, largest, ' mm')
      call need_range(error, 'shoulder_gap', s%shoulder_gap, 0.0_wp, largest, ' mm')
      if (s%shoulders) call need_positive(error, 'shoulder_height', s%shoulder_height, 'mm')
      call need_range(error, 'points', real(s%points, wp), 1.0_wp, real(max_points, wp), '')
      call need_range(error, 'side_points', real(s%side_points, wp), 1.0_wp, 1000.0_wp, '')
      call need_range(error, 'shoulder_points', real(s%shoulder_points, wp), 1.0_wp, &
         real(max_points, wp), '')
      if (allocated(error)) return
      if (.not. tenon_face_arm(s) > 0.0_wp) call fatal_error(error, 'arm = '//to_text(s%arm)// &
         ' mm from the column axis ends inside the column: it must be above length/2 = '// &
         to_text(0.5_wp*s%length)//' mm', subject='arm length')
   end subroutine check_sizes

   pure subroutine check_wood(s, error)
      type(tenon_settings), intent(in) :: s
      type(error_type), allocatable, intent(inout) :: error

      ! what a plane joint takes of its wood
      associate (w => s%wood)
         call need_positive(error, 'young_modulus_l', w%young_moduli(1), 'MPa')
         call need_positive(error, 'young_modulus_r', w%young_moduli(2), 'MPa')
         call need_positive(error, 'compression_strength_l', w%compression_strengths(1), 'MPa')
         call need_positive(error, 'compression_strength_r', w%compression_strengths(2), 'MPa')
         call need_range(error, 'hardening_along', w%hardening_along, 0.0_wp, largest, '')
         call need_range(error, 'hardening_across', w%hardening_across, 0.0_wp, largest, '')
      end associate
      call need_positive(error, 'bearing_depth', s%bearing_depth, 'mm')
      call need_positive(error, 'column_depth', s%column_depth, 'mm')
      call need_range(error, 'side_pressure', s%side_pressure, 0.0_wp, 1.0e6_wp, ' MPa')
      call need_range(error, 'column_load', s%column_load, -huge_value, huge_value, ' N')
   end subroutine check_wood

   !> Refuse sizes that are most likely in another unit.
   pure subroutine check_ranges(s, error)
      type(tenon_settings), intent(in) :: s
      type(error_type), allocatable, intent(inout) :: error
      type(size_range) :: clearance
      character(len=22), parameter :: names(*) = [character(len=22) :: 'length', 'height', &
         'width', 'arm', 'displacement_increment', 'young_modulus_l', 'young_modulus_r', &
         'compression_strength_l', 'compression_strength_r', 'bearing_depth', 'column_depth', &
         'side_pressure', 'column_load', 'extension', 'shoulder_height', 'shoulder_gap']
      real(wp) :: values(size(names))
      integer :: i

      values = [s%length, s%height, s%width, s%arm, s%displacement_increment, &
         s%wood%young_moduli(:2), s%wood%compression_strengths(:2), s%bearing_depth, &
         s%column_depth, s%side_pressure, s%column_load, &
         merge(0.0_wp, s%extension, s%shoulders), &
         merge([s%shoulder_height, s%shoulder_gap], 0.0_wp, s%shoulders)]
      do i = 1, size(names)
         call check_size(error, trim(names(i)), values(i), s%accept_sizes)
      end do
      clearance = range_of('clearance_above')
      clearance%highest = min(clearance%highest, clearance_ratio*s%height)
      call check_between(error, 'clearance_above', s%clearance_above, clearance%lowest, &
         clearance%highest, 'mm', s%accept_sizes)
      call check_between(error, 'clearance_below', s%clearance_below, clearance%lowest, &
         clearance%highest, 'mm', s%accept_sizes)
   end subroutine check_ranges

   !> As `check_positive` and `check_range`, unless `error` is set.
   pure subroutine need_positive(error, name, value, unit)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name, unit
      real(wp), intent(in) :: value

      if (.not. allocated(error)) call check_positive(error, name, value, unit)
   end subroutine need_positive

   pure subroutine need_range(error, name, value, lowest, highest, unit)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name, unit
      real(wp), intent(in) :: value, lowest, highest

      if (.not. allocated(error)) call check_range(error, name, value, lowest, highest, unit)
   end subroutine need_range

   pure subroutine check_choices(s, error)
      type(tenon_settings), intent(in) :: s
      type(error_type), allocatable, intent(inout) :: error

      call check_choice(error, 'arm_datum', s%arm_datum, ['column_face', 'column_axis'])
      call check_choice(error, 'gap', s%gap, ['mean_plane ', 'first_touch'])
      call check_choice(error, 'contact', s%contact, ['rough', 'hard '])
      call check_choice(error, 'column', s%column, ['elastic', 'rigid  '])
      call check_choice(error, 'criterion', s%wood%criterion, criteria)
      call check_choice(error, 'axial_rule', s%axial_rule, &
         ['spring', 'fixed ', 'free  ', 'force '])
      if (allocated(error)) return
      if (s%axial_rule == 'spring') &
         call need_positive(error, 'axial_stiffness', s%axial_stiffness, 'N/mm')
      if (s%axial_rule == 'force') &
         call need_range(error, 'axial_force', s%axial_force, -huge_value, huge_value, ' N')
      if (allocated(error)) return
      if (s%through_uinter .and. s%contact /= 'rough') call fatal_error(error, &
         "through_uinter needs contact = 'rough': UINTER has no hard contact", &
         subject='through_uinter')
   end subroutine check_choices

   !> Set `error`, unless it is set, when a text is none of those known.
   pure subroutine check_choice(error, name, value, known)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name, value, known(:)
      character(len=:), allocatable :: list
      integer :: i

      if (allocated(error) .or. any(known == value)) return
      list = trim(known(1))
      do i = 2, size(known)
         list = list//', '//trim(known(i))
      end do
      call fatal_error(error, name//" = '"//trim(value)//"' is unknown: it must be one of "//list, &
         subject=name)
   end subroutine check_choice

end module asperity_replay_tenon_check_settings
