!> Settings of the shear box: specimen, load and path.
module asperity_replay_shear_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_paper_shear_test, only: disc_diameter, disc_normal_stress, disc_rate
   use asperity_replay_sizes, only: check_between, check_size, slip_text
   use asperity_replay_steps, only: steps_to_turn
   implicit none
   private
   public :: shear_settings, check_shear_settings, box_path, overlap_area, current_area

   !> Displacement when none is given, mm
   real(wp), parameter, public :: default_displacement = 3.0_wp

   !> Specimen, load and path.
   type :: shear_settings
      !> Diameter of both discs, mm
      real(wp) :: diameter = disc_diameter
      !> Normal stress of the dead weight on the full disc, MPa
      real(wp) :: normal_stress = disc_normal_stress
      !> Speed of the lower box, mm/min
      real(wp) :: rate = disc_rate
      !> Turning points of the lower box, mm; `default_displacement` when not allocated
      real(wp), allocatable :: displacement(:)
      !> Largest step, mm
      real(wp) :: displacement_increment = 0.02_wp
      !> Whether the discs' overlap shrinks with displacement
      logical :: shrinking_overlap = .true.
      !> Shear compliance of the two specimens together, mm/N
      real(wp) :: shear_compliance = 0.0_wp
      !> Let sizes outside the ranges of `asperity_replay_sizes` pass
      logical :: accept_sizes = .false.
   end type shear_settings

   integer, parameter :: max_steps = 1000000
   real(wp), parameter :: largest_compliance = 1.0e20_wp, largest = 1.0e9_wp
   !> Range of the largest displacement over the diameter: hardly any overlap is left, and hardly
   !> any motion seen, which can be let pass
   real(wp), parameter :: longest_way = 0.9_wp, shortest_way = 0.00091_wp

contains

   !> `error` is set when a setting is not allowed.
   pure subroutine check_shear_settings(settings, turns, error)
      !> Settings
      type(shear_settings), intent(in) :: settings
      !> Turning points, mm
      real(wp), intent(in) :: turns(:)
      !> Set when a setting is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      call check_positive(error, 'diameter', settings%diameter, 'mm')
      if (.not. allocated(error)) &
         call check_positive(error, 'normal_stress', settings%normal_stress, 'MPa')
      if (.not. allocated(error)) call check_positive(error, 'rate', settings%rate, 'mm/min')
      if (.not. allocated(error)) call check_positive(error, 'displacement_increment', &
         settings%displacement_increment, 'mm')
      if (allocated(error)) return
      call check_range(error, 'shear_compliance', settings%shear_compliance, 0.0_wp, &
         largest_compliance, ' mm/N')
      do i = 1, size(turns)
         if (.not. allocated(error)) call check_range(error, 'displacement', turns(i), &
            -largest, largest, ' mm')
      end do
      if (allocated(error)) return
      if (size(turns) == 0) then
         call fatal_error(error, 'displacement is empty: give at least one turning '// &
            'point in mm', subject='displacement')
         return
      end if
      associate (accepted => settings%accept_sizes)
         call check_size(error, 'diameter', settings%diameter, accepted)
         call check_size(error, 'normal_stress', settings%normal_stress, accepted)
         call check_size(error, 'displacement_increment', settings%displacement_increment, accepted)
         call check_way(error, turns(maxloc(abs(turns), 1)), settings%diameter, accepted)
      end associate
      if (allocated(error)) return
      if (sum([(real(steps_to_turn(turns, i, settings%displacement_increment), wp), &
            i=1, size(turns))]) > max_steps) then
         call fatal_error(error, 'displacement_increment = '// &
            to_text(settings%displacement_increment)//' mm gives more than '// &
            to_text(max_steps)//' steps; make it larger', subject='displacement_increment')
      end if
   end subroutine check_shear_settings

   !> Refuse a largest displacement at which the discs hardly overlap, and one that is most likely
   !> in another unit.
   pure subroutine check_way(error, displacement, diameter, accepted)
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: displacement, diameter
      logical, intent(in) :: accepted

      associate (low => shortest_way*diameter, high => longest_way*diameter)
         if (abs(displacement) <= high) then
            call check_between(error, 'displacement', displacement, low, high, 'mm', accepted)
         else if (.not. allocated(error)) then
            call fatal_error(error, 'displacement = '//to_text(displacement)// &
               ' mm is not allowed: the discs overlap up to '//to_text(high)//' mm; '// &
               trim(slip_text(displacement, low, high, 'mm')), subject='displacement')
         end if
      end associate
   end subroutine check_way

   !> Area in contact at a displacement of the box, mm^2.
   pure real(wp) function current_area(settings, displacement)
      !> Settings
      type(shear_settings), intent(in) :: settings
      !> Displacement of the box, mm
      real(wp), intent(in) :: displacement

      current_area = overlap_area(settings%diameter, &
         merge(displacement, 0.0_wp, settings%shrinking_overlap))
   end function current_area

   !> Overlap of two discs of one diameter whose centres are apart, mm^2.
   pure elemental real(wp) function overlap_area(diameter, displacement)
      !> Diameter and distance of the centres, mm
      real(wp), intent(in) :: diameter, displacement
      real(wp) :: ratio

      ratio = min(abs(displacement)/diameter, 1.0_wp)
      overlap_area = 0.5_wp*diameter**2*(acos(ratio) - ratio*sqrt(1.0_wp - ratio**2))
   end function overlap_area

   !> Positions of the box from zero through the turning points in equal steps each.
   pure subroutine box_path(turns, increment, path)
      !> Turning points and largest step, mm
      real(wp), intent(in) :: turns(:), increment
      !> Positions, mm, the first of them zero
      real(wp), allocatable, intent(out) :: path(:)
      real(wp) :: from
      integer :: i, j, n, next

      allocate (path(1 + sum([(steps_to_turn(turns, i, increment), i=1, size(turns))])))
      path(1) = 0.0_wp
      next = 2
      do i = 1, size(turns)
         from = path(next - 1)
         n = steps_to_turn(turns, i, increment)
         do j = 1, n
            path(next) = from + (turns(i) - from)*(real(j, wp)/n)
            next = next + 1
         end do
      end do
   end subroutine box_path

end module asperity_replay_shear_settings
