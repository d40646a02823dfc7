!> Settings of the tenon joint: sizes, wood, axial rule, resolution and load programme.
!>
!> The drawing, symbols and signs are in geometry.f90. What the paper does not print is marked
!> as chosen. Sizes that follow from others are allocatable: `complete_tenon_settings` sets
!> those that are not allocated, and a run does it by itself.
module asperity_replay_tenon_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_paper_joint, only: joint_amplitudes, joint_cycles
   use asperity_paper_wood, only: wood_strength_across, wood_strength_along, young_moduli
   use asperity_replay_sizes, only: check_between, check_size, range_of, size_range
   use asperity_replay_tenon_turns, only: check_amplitudes, check_displacement
   implicit none
   private
   public :: tenon_settings, complete_tenon_settings, check_tenon_settings, tenon_amplitudes, &
      tenon_face_arm

   !> Sizes, wood, axial rule, resolution and load programme of one joint.
   type :: tenon_settings
      !> Length of the tenon in the mortise, which is the column's depth, mm; chosen
      real(wp) :: length = 300.0_wp
      !> Height of the tenon, mm; chosen
      real(wp) :: height = 300.0_wp
      !> Width of the tenon, mm; chosen
      real(wp) :: width = 105.0_wp
      !> Clearance above and below the tenon, mm, as `gap` defines it; chosen
      real(wp) :: clearance_above = 0.5_wp, clearance_below = 0.5_wp
      !> Length of full material that runs on past the column face, mm; a fifth of `height` when not
      !> allocated; no use with shoulders
      real(wp), allocatable :: extension
      !> Distance of the load point from `arm_datum`, mm
      real(wp) :: arm = 500.0_wp
      !> Where the arm is measured from, and the moment is taken about: `column_face` or
      !> `column_axis`, which lies length/2 inside the face
      character(len=16) :: arm_datum = 'column_face'
      !> What the clearance means: distance of the `mean_plane` of the summits to the other face, or
      !> motion until `first_touch` (separation d0); the same for hard contact
      character(len=16) :: gap = 'mean_plane'
      !> Pressure on the two side faces, MPa; none when zero; chosen
      real(wp) :: side_pressure = 0.2_wp
      !> What holds the tenon along its axis: `spring`, `fixed`, `free`, or a given `force`, through
      !> the middle of the tenon at the column face
      character(len=16) :: axial_rule = 'spring'
      !> Stiffness of the spring, N/mm; chosen
      real(wp) :: axial_stiffness = 500.0_wp
      !> The given force on the tenon, N; positive pulls it out
      real(wp) :: axial_force = 0.0_wp
      !> Whether shoulders above and below the tenon bear on the column face
      logical :: shoulders = .false.
      !> Height of each shoulder, mm; a sixth of `height` when not allocated
      real(wp), allocatable :: shoulder_height
      !> Gap between each shoulder and the column face, mm
      real(wp) :: shoulder_gap = 0.0_wp
      !> Vertical load of the column, N, for information only
      real(wp) :: column_load = 0.0_wp
      !> Bearing of the tenon perpendicular to grain: modulus, MPa, over depth, mm, is its
      !> stiffness. The modulus is the paper's in whole
      !> MPa, as that of the column; the depth is chosen, half of `height` when not
      !> allocated
      real(wp) :: bearing_modulus = anint(young_moduli(2))
      real(wp), allocatable :: bearing_depth
      !> Its yield pressure fc90, MPa
      real(wp) :: bearing_strength = wood_strength_across
      !> Its hardening over its stiffness; zero or more; chosen
      real(wp) :: hardening = 0.02_wp
      !> Bearing of the column parallel to grain: modulus, MPa (zero: rigid), and depth, mm, chosen
      !> as that of the tenon
      real(wp) :: column_modulus = anint(young_moduli(1))
      real(wp), allocatable :: column_depth
      !> Its yield pressure fc0, MPa, and hardening over its stiffness
      real(wp) :: column_strength = wood_strength_along, column_hardening = 0.02_wp
      !> Contact points along each face over `length`, along each side of a side face, and over each
      !> shoulder's height
      integer :: points = 100, side_points = 12, shoulder_points = 16
      !> Largest step of the displacement, mm
      real(wp) :: displacement_increment = 0.8_wp
      !> `rough` or `hard`: a rigid interface with the same friction
      character(len=16) :: contact = 'rough'
      !> Whether every contact point of the rough joint is run through UINTER
      logical :: through_uinter = .false.
      !> Amplitudes, mm, and how many cycles of each; the paper's when not allocated: 0.5, 1, 2,
      !> 4 mm once; 8, 16, 24, 32, 48 mm three times
      real(wp), allocatable :: amplitudes(:)
      integer, allocatable :: cycles(:)
      !> Recorded displacements of the load point, mm, in place of amplitudes
      real(wp), allocatable :: displacement(:)
      !> Let sizes outside the ranges of `asperity_replay_sizes` and rotations outside those of
      !> `asperity_replay_tenon_turns` pass
      logical :: accept_sizes = .false.
   end type tenon_settings

   !> What follows from the height of the tenon, over it
   real(wp), parameter :: depth_ratio = 0.5_wp, extension_ratio = 0.2_wp, &
      shoulder_ratio = 1.0_wp/6.0_wp
   !> Largest clearance over the height: with more, the tenon lies in its mortise at an angle
   real(wp), parameter :: clearance_ratio = 0.1_wp
   !> Most points of a face
   integer, parameter :: max_points = 100000
   real(wp), parameter :: largest = 1.0e9_wp, huge_value = 1.0e20_wp

contains

   !> Give sizes that follow from the height their values unless they have some.
   pure subroutine complete_tenon_settings(settings)
      !> Settings
      type(tenon_settings), intent(inout) :: settings

      associate (s => settings)
         if (.not. allocated(s%bearing_depth)) s%bearing_depth = depth_ratio*s%height
         if (.not. allocated(s%column_depth)) s%column_depth = depth_ratio*s%height
         if (.not. allocated(s%extension)) s%extension = extension_ratio*s%height
         if (.not. allocated(s%shoulder_height)) s%shoulder_height = shoulder_ratio*s%height
      end associate
   end subroutine complete_tenon_settings

   !> Distance of the load point from the column face, mm.
   pure real(wp) function tenon_face_arm(settings)
      !> Settings
      type(tenon_settings), intent(in) :: settings

      tenon_face_arm = settings%arm
      if (settings%arm_datum == 'column_axis') &
         tenon_face_arm = settings%arm - 0.5_wp*settings%length
   end function tenon_face_arm

   !> The amplitudes and cycles of the settings, or the paper's.
   pure subroutine tenon_amplitudes(settings, amplitudes, cycles)
      !> Settings
      type(tenon_settings), intent(in) :: settings
      !> Amplitudes, mm
      real(wp), allocatable, intent(out) :: amplitudes(:)
      !> Cycles of each
      integer, allocatable, intent(out) :: cycles(:)

      if (allocated(settings%amplitudes)) then
         amplitudes = settings%amplitudes
         if (allocated(settings%cycles)) then
            cycles = settings%cycles
         else
            allocate (cycles(size(amplitudes)), source=1)
         end if
      else
         amplitudes = joint_amplitudes
         cycles = joint_cycles
         if (allocated(settings%cycles)) cycles = settings%cycles
      end if
   end subroutine tenon_amplitudes

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

      call need_positive(error, 'bearing_modulus', s%bearing_modulus, 'MPa')
      call need_positive(error, 'bearing_depth', s%bearing_depth, 'mm')
      call need_positive(error, 'bearing_strength', s%bearing_strength, 'MPa')
      call need_range(error, 'hardening', s%hardening, 0.0_wp, largest, '')
      call need_range(error, 'column_modulus', s%column_modulus, 0.0_wp, huge_value, ' MPa')
      call need_positive(error, 'column_depth', s%column_depth, 'mm')
      call need_positive(error, 'column_strength', s%column_strength, 'MPa')
      call need_range(error, 'column_hardening', s%column_hardening, 0.0_wp, largest, '')
      call need_range(error, 'side_pressure', s%side_pressure, 0.0_wp, 1.0e6_wp, ' MPa')
      call need_range(error, 'column_load', s%column_load, -huge_value, huge_value, ' N')
   end subroutine check_wood

   !> Refuse sizes that are most likely in another unit.
   pure subroutine check_ranges(s, error)
      type(tenon_settings), intent(in) :: s
      type(error_type), allocatable, intent(inout) :: error
      type(size_range) :: clearance
      character(len=22), parameter :: names(*) = [character(len=22) :: 'length', 'height', &
         'width', 'arm', 'displacement_increment', 'bearing_depth', 'bearing_modulus', &
         'bearing_strength', 'column_depth', 'column_modulus', 'column_strength', &
         'side_pressure', 'column_load', 'extension', 'shoulder_height', 'shoulder_gap']
      real(wp) :: values(size(names))
      integer :: i

      values = [s%length, s%height, s%width, s%arm, s%displacement_increment, s%bearing_depth, &
         s%bearing_modulus, s%bearing_strength, s%column_depth, s%column_modulus, &
         s%column_strength, s%side_pressure, s%column_load, &
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

end module asperity_replay_tenon_settings
