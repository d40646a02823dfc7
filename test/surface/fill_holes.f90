!> Filling of missing points.
module test_surface_fill_holes
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_prepare_fill_holes, only: fill_missing, missing_share
   use extremes, only: largest_of
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use map_cases, only: flat_map, punch_holes, random_map, random_whole
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_holes

   integer(int64), parameter :: seed = 577215_int64

contains

   function suite_surface_holes() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_holes')
      call suite%addTest(TestMethod('no summits or pits arise in holes', test_no_summits))
      call suite%addTest(TestMethod('nor beside spikes', test_spikes))
      call suite%addTest(TestMethod('a saddle is continued across a hole', test_saddle))
      call suite%addTest(TestMethod('one measured point fills the map', test_one_point))
      call suite%addTest(TestMethod('shares, full maps and empty ones', test_shares))
   end function suite_surface_holes

   !> Random maps of independent heights, the roughest there are, with scattered holes and a large
   !> one that may reach the border.
   subroutine test_no_summits()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: before(:, :)
      integer :: trial, i, j, k, l

      stream = random_stream(seed)
      do trial = 1, 60
         call random_map(map, stream, random_whole(stream, 5, 60), random_whole(stream, 5, 60), &
            1.0_wp, 1.0_wp)
         call punch_holes(map, stream, stream%uniform(0.0_wp, 0.9_wp))
         associate (nx => size(map%heights, 1), ny => size(map%heights, 2))
            i = random_whole(stream, 1, nx)
            j = random_whole(stream, 1, ny)
            k = random_whole(stream, 0, nx/2)
            l = random_whole(stream, 0, ny/2)
            map%heights(i:min(i + k, nx), j:min(j + l, ny)) = none
            map%heights(1 + modulo(i, nx), 1 + modulo(j + ny/2, ny)) = 0.5_wp
         end associate
         if (allocated(before)) deallocate (before)
         allocate (before, source=map%heights)
         call fill_missing(map, error)
         call assertFalse(allocated(error))
         associate (measured => before < none)
            call assertTrue(all(abs(map%heights - before) < tiny(1.0_wp) .or. .not. measured), &
               message='measured heights stay')
            call assertTrue(all(map%heights <= maxval(before, measured)) &
               .and. all(map%heights >= minval(before, measured)), message='within the measured')
         end associate
         call assertEqual(0, extremes(map%heights, before), message='summits and pits, map '// &
            to_text(trial)//' of seed '//to_text(int(seed)))
      end do
   end subroutine test_no_summits

   !> Heights to the 80th power: few spikes up or down, beside which rounds over all grids alone
   !> leave summits and pits of little relief, in one such map of three.
   subroutine test_spikes()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: before(:, :)
      integer :: trial

      stream = random_stream(seed + 1)
      allocate (before(100, 100))
      do trial = 1, 10
         call random_map(map, stream, 100, 100, 1.0_wp, 1.0_wp)
         map%heights = max(0.001_wp, abs(map%heights))**80
         if (modulo(trial, 2) == 0) map%heights = -map%heights
         call punch_holes(map, stream, 0.4_wp)
         before = map%heights
         call fill_missing(map, error)
         call assertFalse(allocated(error))
         call assertEqual(0, extremes(map%heights, before), message='summits and pits, map '// &
            to_text(trial)//' of seed '//to_text(int(seed + 1)))
      end do
   end subroutine test_spikes

   !> Filled points above or below all their neighbours.
   integer function extremes(z, before)
      real(wp), intent(in) :: z(:, :), before(:, :)
      integer :: i, j, k, l, higher, lower, around

      extremes = 0
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (before(i, j) < none) cycle
            higher = 0
            lower = 0
            around = -1
            do l = max(j - 1, 1), min(j + 1, size(z, 2))
               do k = max(i - 1, 1), min(i + 1, size(z, 1))
                  around = around + 1
                  if (z(k, l) > z(i, j)) higher = higher + 1
                  if (z(k, l) < z(i, j)) lower = lower + 1
               end do
            end do
            if (higher == around .or. lower == around) extremes = extremes + 1
         end do
      end do
   end function extremes

   !> x^2 - y^2 is the mean of its four neighbours everywhere, so the membrane should be it. Across
   !> a hole of 40 points it ranges over 800. Six rounds, each of which halves the error at least,
   !> leave a thousandth of a start that is off by a twentieth.
   subroutine test_saddle()
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp) :: exact(81, 75), worst
      integer :: i, j

      call flat_map(map, 81, 75, 1.0_wp, 1.0_wp)
      do j = 1, 75
         do i = 1, 81
            exact(i, j) = real(i - 41, wp)**2 - real(j - 38, wp)**2
         end do
      end do
      map%heights = exact
      map%heights(21:60, 18:57) = none
      map%heights(3, 3) = none
      call fill_missing(map, error)
      call assertFalse(allocated(error))
      worst = largest_of(map%heights - exact)/800.0_wp
      call record('surface.holes.saddle', worst)
      call assertLessThan(worst, 1.0e-3_wp)
      ! a hole of one point is exact
      call assertLessThan(abs(map%heights(3, 3) - exact(3, 3)), 1.0e-10_wp)
   end subroutine test_saddle

   subroutine test_one_point()
      type(height_map) :: map
      type(error_type), allocatable :: error

      call flat_map(map, 13, 6, 1.0_wp, 1.0_wp)
      map%heights = none
      map%heights(11, 5) = 2.5_wp
      call fill_missing(map, error)
      call assertFalse(allocated(error))
      call assertLessThan(largest_of(map%heights - 2.5_wp), 1.0e-14_wp)
   end subroutine test_one_point

   subroutine test_shares()
      type(height_map) :: map
      type(error_type), allocatable :: error

      call flat_map(map, 8, 5, 1.0_wp, 1.0_wp)
      call assertEqual(0.0_wp, missing_share(map), tolerance=0.0_wp)
      call fill_missing(map, error)
      call assertFalse(allocated(error))
      call assertLessThan(largest_of(map%heights), tiny(1.0_wp))
      map%heights(2:6, 3) = none
      map%heights(1, 1:5) = none
      call assertEqual(0.25_wp, missing_share(map), tolerance=1.0e-15_wp)
      map%heights = none
      call assertEqual(1.0_wp, missing_share(map), tolerance=1.0e-15_wp)
      call fill_missing(map, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertEqual('test map: every point is missing, so nothing '// &
         'tells how to fill them', error%message)
   end subroutine test_shares

end module test_surface_fill_holes
