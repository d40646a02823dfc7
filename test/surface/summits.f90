!> Summits and peaks: on closed forms, and on random small maps against the words of the
!> definitions, which are slow: islands by flooding from each top, and Wolf's pruning step by step.
module test_surface_summits
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_summits_find, only: find_summits, summit_set
   use asperity_surface_summits_saddle_order, only: saddle_type, sort_saddles
   use extremes, only: largest_of
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use map_cases, only: flat_map, punch_holes, random_map, random_whole
   use random_inputs, only: random_stream
   use summit_models, only: reliefs_by_flooding, wolf_pruned
   implicit none
   private
   public :: suite_surface_summits

   real(wp), parameter :: pi = 4.0_wp*atan(1.0_wp)
   integer(int64), parameter :: seed = 141421_int64

contains

   function suite_surface_summits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_summits')
      call suite%addTest(TestMethod('random maps against flooding', test_flooding))
      call suite%addTest(TestMethod('random maps against Wolf pruning', test_wolf))
      call suite%addTest(TestMethod('egg crates: number, height, curvature', test_egg_crate))
      call suite%addTest(TestMethod('pruning takes ripples, not hills', test_ripples))
      call suite%addTest(TestMethod('tops on the border prune but do not count', test_border))
      call suite%addTest(TestMethod('flat maps, thin maps, empty maps', test_degenerate))
      call suite%addTest(TestMethod('order of saddles', test_order))
      call suite%addTest(TestMethod('refused shares', test_refused))
   end function suite_surface_summits

   !> A small map: few levels make plateaus, on some nothing is missing.
   subroutine small_map(map, stream, trial)
      type(height_map), intent(out) :: map
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: trial
      integer :: nx, ny

      nx = random_whole(stream, 5, 13)
      ny = random_whole(stream, 5, 13)
      select case (modulo(trial, 4))
      case (0)
         call random_map(map, stream, nx, ny, 0.1_wp, 0.2_wp)
      case (1)
         call random_map(map, stream, nx, ny, 0.1_wp, 0.2_wp, levels=3)
      case (2)
         call random_map(map, stream, nx, ny, 0.1_wp, 0.2_wp, levels=9)
         call punch_holes(map, stream, 0.1_wp)
      case default
         call random_map(map, stream, nx, ny, 0.1_wp, 0.2_wp)
         call punch_holes(map, stream, 0.3_wp)
      end select
   end subroutine small_map

   !> Summits are the inner tops, with the relief that is found for each on its own, and peaks those
   !> for which it is enough.
   subroutine test_flooding()
      type(random_stream) :: stream
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      real(wp), allocatable :: relief(:, :)
      real(wp) :: share
      integer :: trial, i, j, n
      logical :: is_same

      stream = random_stream(seed)
      do trial = 1, 400
         call small_map(map, stream, trial)
         share = stream%uniform(0.0_wp, 0.7_wp)
         call find_summits(map, share, summits, error)
         call assertFalse(allocated(error))
         call reliefs_by_flooding(map%heights, relief)
         is_same = .true.
         n = 0
         do j = 2, size(map%heights, 2) - 1
            do i = 2, size(map%heights, 1) - 1
               if (relief(i, j) < 0.0_wp) cycle
               if (any(map%heights(i - 1:i + 1, j - 1:j + 1) >= none)) cycle
               n = n + 1
               is_same = is_same .and. n <= size(summits%i)
               if (.not. is_same) cycle
               is_same = summits%i(n) == i .and. summits%j(n) == j &
                  .and. .not. abs(summits%relief(n) - relief(i, j)) > 0.0_wp &
                  .and. (summits%is_peak(n) .eqv. relief(i, j) >= summits%pruned_below)
            end do
         end do
         call assertTrue(is_same .and. n == size(summits%i), message='map '//to_text(trial)// &
            ' of seed '//to_text(int(seed)))
      end do
   end subroutine test_flooding

   !> The same peaks as by joining the hill of the smallest difference again and again.
   subroutine test_wolf()
      type(random_stream) :: stream
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      logical, allocatable :: stays(:, :)
      real(wp) :: share
      integer :: trial, n
      logical :: is_same

      stream = random_stream(seed + 1)
      do trial = 1, 400
         call small_map(map, stream, trial)
         share = stream%uniform(0.0_wp, 0.7_wp)
         call find_summits(map, share, summits, error)
         call assertFalse(allocated(error))
         call wolf_pruned(map%heights, summits%pruned_below, stays)
         is_same = .true.
         do n = 1, size(summits%i)
            is_same = is_same .and. (stays(summits%i(n), summits%j(n)) .eqv. summits%is_peak(n))
         end do
         call assertTrue(is_same, message='map '//to_text(trial)//' of seed '// &
            to_text(int(seed + 1)))
      end do
   end subroutine test_wolf

   !> cos x + cos y: a peak of height 2 a wave either way, saddles at 0, pits at -2: relief 2, half
   !> the range, but for the highest, the last in storage of equal ones. Curvature by three points.
   subroutine test_egg_crate()
      integer, parameter :: waves_x = 6, waves_y = 4, points = 16
      real(wp), parameter :: step_x = 0.01_wp, step_y = 0.02_wp
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      real(wp) :: curvature

      call egg_crate(map, waves_x, waves_y, points, step_x, step_y)
      call find_summits(map, 0.49_wp, summits, error)
      call assertFalse(allocated(error))
      call assertEqual(waves_x*waves_y, size(summits%i))
      call assertEqual(waves_x*waves_y, count(summits%is_peak))
      call assertLessThan(largest_of(summits%height - 2.0_wp), 1.0e-12_wp)
      curvature = (1.0_wp - cos(2.0_wp*pi/points))*(1.0_wp/step_x**2 + 1.0_wp/step_y**2)
      call assertLessThan(largest_of(summits%curvature/curvature - 1.0_wp), 1.0e-10_wp)
      call assertEqual(1.96_wp, summits%pruned_below, tolerance=1.0e-12_wp)
      call assertTrue(all(modulo(summits%i - 1, points) == points/2))
      call assertTrue(all(modulo(summits%j - 1, points) == points/2))
      call find_summits(map, 0.51_wp, summits, error)
      call assertEqual(1, count(summits%is_peak))
      call assertEqual(waves_x*waves_y, size(summits%i))
   end subroutine test_egg_crate

   !> Waves with their pits at the border.
   subroutine egg_crate(map, waves_x, waves_y, points, step_x, step_y)
      type(height_map), intent(out) :: map
      integer, intent(in) :: waves_x, waves_y, points
      real(wp), intent(in) :: step_x, step_y
      integer :: i, j

      call flat_map(map, waves_x*points + 1, waves_y*points + 1, step_x, step_y)
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            map%heights(i, j) = -cos(2.0_wp*pi*(i - 1)/points) - cos(2.0_wp*pi*(j - 1)/points)
         end do
      end do
   end subroutine egg_crate

   !> Ripples of 2.5 % of the range on an egg crate: many more summits, the same number of peaks.
   subroutine test_ripples()
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      integer :: i, j

      call egg_crate(map, 3, 3, 96, 1.0_wp, 1.0_wp)
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            map%heights(i, j) = map%heights(i, j) + 0.05_wp*cos(1.1_wp*i)*cos(1.2_wp*j)
         end do
      end do
      call find_summits(map, 0.05_wp, summits, error)
      call assertFalse(allocated(error))
      call assertGreaterThan(size(summits%i), 5*9, message='ripples make summits')
      call assertEqual(9, count(summits%is_peak))
      call find_summits(map, 0.0_wp, summits, error)
      call assertTrue(all(summits%is_peak), message='nothing pruned')
   end subroutine test_ripples

   !> A ridge along x with tops at 1 (border), 3 and 5: heights 9, 8, 5, saddles 7 and 1.
   subroutine test_border()
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error

      call flat_map(map, 6, 5, 1.0_wp, 1.0_wp)
      map%heights(:, 3) = [9.0_wp, 7.0_wp, 8.0_wp, 1.0_wp, 5.0_wp, 0.0_wp]
      call find_summits(map, 0.2_wp, summits, error)
      call assertFalse(allocated(error))
      call assertEqual([3, 5], summits%i)
      call assertEqual([3, 3], summits%j)
      call assertTrue(all(summits%is_peak .eqv. [.false., .true.]), message='relief 1 and 4 of 9')
      call assertEqual(0.5_wp*(8.0_wp + 16.0_wp), summits%curvature(1), tolerance=1.0e-12_wp)
      ! a relief of just the least one, 4 of 8, stays
      map%heights(1, 3) = 8.0_wp
      map%heights(3, 3) = 7.5_wp
      call find_summits(map, 0.5_wp, summits, error)
      call assertTrue(all(summits%is_peak .eqv. [.false., .true.]), message='relief 0.5 and 4 of 8')
      ! without the higher top, the second is the highest; beside a missing point is no summit
      map%heights(1, 3) = none
      call find_summits(map, 0.2_wp, summits, error)
      call assertTrue(all(summits%is_peak), message='the highest stays')
      map%heights(6, 2) = none
      call find_summits(map, 0.2_wp, summits, error)
      call assertEqual([3], summits%i)
   end subroutine test_border

   subroutine test_degenerate()
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error

      ! the last point of a flat map is its top, at the border
      call flat_map(map, 7, 6, 1.0_wp, 1.0_wp)
      call find_summits(map, 0.05_wp, summits, error)
      call assertFalse(allocated(error))
      call assertEqual(0, size(summits%i))
      ! a plateau is one summit, its last point
      map%heights(3:4, 3:4) = 1.0_wp
      call find_summits(map, 0.05_wp, summits, error)
      call assertEqual([4], summits%i)
      call assertEqual([4], summits%j)
      map%heights = none
      call find_summits(map, 0.05_wp, summits, error)
      call assertFalse(allocated(error))
      call assertEqual(0, size(summits%i))
      call flat_map(map, 9, 1, 1.0_wp, 1.0_wp)
      map%heights(4, 1) = 1.0_wp
      call find_summits(map, 0.05_wp, summits, error)
      call assertEqual(0, size(summits%i))
   end subroutine test_degenerate

   !> Random ones, equal ones, and orders that make the split about a median of three go wrong.
   subroutine test_order()
      integer, parameter :: n = 3000
      type(random_stream) :: stream
      type(saddle_type) :: saddles(n)
      integer :: kind, i
      logical :: is_sorted

      stream = random_stream(seed + 2)
      do kind = 1, 5
         do i = 1, n
            saddles(i) = saddle_type(0.0_wp, i, 7)
            select case (kind)
            case (1)
               saddles(i)%height = stream%uniform(0.0_wp, 1.0_wp)
            case (2)
               saddles(i)%height = real(random_whole(stream, 1, 5), wp)
            case (3)
               saddles(i)%height = real(i, wp)
            case (4)
               saddles(i)%height = real(min(i, n - i), wp)
            case default
               saddles(i)%height = 0.0_wp
            end select
         end do
         if (kind == 5) call make_median_fail(saddles)
         call sort_saddles(saddles)
         is_sorted = .true.
         do i = 2, n
            is_sorted = is_sorted .and. (saddles(i - 1)%height > saddles(i)%height &
               .or. (.not. saddles(i - 1)%height < saddles(i)%height &
               .and. saddles(i - 1)%place > saddles(i)%place))
         end do
         call assertTrue(is_sorted, message='kind '//to_text(kind))
         call assertEqual(n*(n + 1)/2, sum(saddles%place), message='none lost or doubled')
      end do
   end subroutine test_order

   !> Odd places rise, even ones follow above them: the known order that a median of the first, the
   !> middle and the last always splits next to an end.
   subroutine make_median_fail(saddles)
      type(saddle_type), intent(inout) :: saddles(:)
      integer :: i, half

      half = size(saddles)/2
      do i = 1, half
         if (modulo(i, 2) == 1) then
            saddles(i)%height = real(i, wp)
            saddles(i + 1)%height = real(half + i, wp)
         end if
         saddles(half + i)%height = real(2*i, wp)
      end do
   end subroutine make_median_fail

   subroutine test_refused()
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error

      call flat_map(map, 7, 6, 1.0_wp, 1.0_wp)
      call find_summits(map, -0.01_wp, summits, error)
      call check('pruning share '//to_text(-0.01_wp)//' is not allowed: from 0 to 1')
      call find_summits(map, 1.5_wp, summits, error)
      call check('pruning share 1.5 is not allowed: from 0 to 1')
      call find_summits(map, transfer(int(z'7FF8000000000000', int64), 1.0_wp), summits, error)
      call check('pruning share NaN is not allowed: from 0 to 1')

   contains

      subroutine check(expected)
         character(len=*), intent(in) :: expected

         call assertTrue(allocated(error), message=expected)
         if (allocated(error)) call assertEqual(expected, error%message)
      end subroutine check

   end subroutine test_refused

end module test_surface_summits
