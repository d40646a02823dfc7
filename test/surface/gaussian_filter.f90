!> The S and L filters against their transmission and against fits and means by the definition.
module test_surface_gaussian_filter
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_prepare_gaussian_filter, only: filter_long, filter_short
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   use map_cases, only: flat_map, kept_map, punch_holes, random_map, random_whole
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_gaussian_filter

   real(wp), parameter :: pi = 4.0_wp*atan(1.0_wp)
   !> Constant of ISO 16610-21, in its digits
   real(wp), parameter :: alpha = 0.469718639349826_wp
   integer(int64), parameter :: seed = 1618034_int64

contains

   function suite_surface_gaussian_filter() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_gaussian_filter')
      call suite%addTest(TestMethod('half of a wave of the cutoff passes', test_transmission))
      call suite%addTest(TestMethod('full maps: fits by the definition', test_fits))
      call suite%addTest(TestMethod('missing points: means by the definition', test_means))
      call suite%addTest(TestMethod('planes stay, to their ends', test_planes))
      call suite%addTest(TestMethod('S and L add up to the map', test_sum))
      call suite%addTest(TestMethod('ends of a slope with missing points', test_slope))
      call suite%addTest(TestMethod('refused cutoffs', test_refused))
   end function suite_surface_gaussian_filter

   !> A wave along x and one along y keep 2^-(cutoff/wave)^2 each, away from the ends: 1.7 cutoffs,
   !> where the weights end. Short and long cutoffs, summed directly and by transforms. Weights at
   !> points only, in place of an integral, err by 2^-(cutoff/step - 1)^2, 2e-15 here.
   subroutine test_transmission()
      real(wp), parameter :: step_x = 0.01_wp, step_y = 0.02_wp
      real(wp), parameter :: cutoffs(3) = [0.16_wp, 0.3_wp, 0.6_wp], &
         ratios(4) = [0.5_wp, 1.0_wp, 2.0_wp, 10.0_wp]
      type(height_map) :: map, long
      type(error_type), allocatable :: error
      real(wp) :: worst, passed_x, passed_y, expected, x, y
      integer :: cutoff, ratio, i, j, end_x, end_y

      worst = 0.0_wp
      do cutoff = 1, size(cutoffs)
         do ratio = 1, size(ratios)
            associate (wave_x => cutoffs(cutoff)*ratios(ratio), wave_y => 1.3_wp*cutoffs(cutoff))
               call flat_map(map, 240, 130, step_x, step_y)
               do j = 1, 130
                  do i = 1, 240
                     x = cos(2.0_wp*pi*i*step_x/wave_x)
                     y = cos(2.0_wp*pi*j*step_y/wave_y)
                     map%heights(i, j) = x + y
                  end do
               end do
               long = map
               call filter_short(map, cutoffs(cutoff), error)
               call assertFalse(allocated(error))
               call filter_long(long, cutoffs(cutoff), error)
               call assertFalse(allocated(error))
               passed_x = 0.5_wp**(1.0_wp/ratios(ratio)**2)
               passed_y = 0.5_wp**(1.0_wp/1.3_wp**2)
               end_x = ceiling(1.7_wp*cutoffs(cutoff)/step_x)
               end_y = ceiling(1.7_wp*cutoffs(cutoff)/step_y)
               do j = 1 + end_y, 130 - end_y
                  do i = 1 + end_x, 240 - end_x
                     x = cos(2.0_wp*pi*i*step_x/wave_x)
                     y = cos(2.0_wp*pi*j*step_y/wave_y)
                     expected = passed_x*x + passed_y*y
                     call worsen(worst, [abs(map%heights(i, j) - expected), &
                        abs(long%heights(i, j) - (x + y - expected))])
                  end do
               end do
            end associate
         end do
      end do
      call record('surface.filter.transmission', worst)
      ! 2^-49 along y at the shortest cutoff of 8 steps, and rounding
      call assertLessThan(worst, 1.0e-13_wp)
   end subroutine test_transmission

   !> At every point of a full map the filter gives the value of a + b x + c y + d x y fitted with
   !> the weights.
   subroutine test_fits()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: before(:, :)
      real(wp) :: cutoff, worst
      integer :: trial, check, i, j

      stream = random_stream(seed)
      worst = 0.0_wp
      do trial = 1, 12
         call random_map(map, stream, random_whole(stream, 40, 70), random_whole(stream, 30, 50), &
            0.1_wp, 0.15_wp)
         cutoff = stream%uniform(0.3_wp, min(3.9_wp, 0.15_wp*(size(map%heights, 2) - 1)))
         if (allocated(before)) deallocate (before)
         allocate (before, source=map%heights)
         call filter_short(map, cutoff, error)
         call assertFalse(allocated(error))
         do check = 1, 12
            ! the corners first
            i = merge(1, size(before, 1), modulo(check, 2) == 0)
            j = merge(1, size(before, 2), modulo(check, 4) < 2)
            if (check > 4) i = random_whole(stream, 1, size(before, 1))
            if (check > 8) j = random_whole(stream, 1, size(before, 2))
            call worsen(worst, abs(map%heights(i, j) &
               - fitted(before, i, j, cutoff/0.1_wp, cutoff/0.15_wp)))
         end do
      end do
      call record('surface.filter.fits', worst)
      ! heights of magnitude one; at corners the fit extrapolates and rounds the more
      call assertLessThan(worst, 1.0e-11_wp)
   end subroutine test_fits

   !> Weight of ISO 16610-21 at a distance.
   pure real(wp) function weight(distance, cutoff)
      integer, intent(in) :: distance
      real(wp), intent(in) :: cutoff

      weight = exp(-pi*(real(distance, wp)/(alpha*cutoff))**2)
   end function weight

   !> The fit's value at a point, by normal equations and elimination.
   pure real(wp) function fitted(z, i, j, cutoff_x, cutoff_y)
      real(wp), intent(in) :: z(:, :), cutoff_x, cutoff_y
      integer, intent(in) :: i, j
      real(wp) :: system(4, 5), terms(4), w
      integer :: k, l, n

      system = 0.0_wp
      do l = 1, size(z, 2)
         do k = 1, size(z, 1)
            w = weight(k - i, cutoff_x)*weight(l - j, cutoff_y)
            terms(:3) = [1.0_wp, (k - i)/cutoff_x, (l - j)/cutoff_y]
            terms(4) = terms(2)*terms(3)
            do n = 1, 4
               system(:, n) = system(:, n) + w*terms(n)*terms
            end do
            system(:, 5) = system(:, 5) + w*z(k, l)*terms
         end do
      end do
      ! upwards, so that the first unknown is left; the matrix is positive definite
      do n = 4, 2, -1
         do k = 1, n - 1
            system(k, :) = system(k, :) - system(n, :)*(system(k, n)/system(n, n))
         end do
      end do
      fitted = system(1, 5)/system(1, 1)
   end function fitted

   !> With missing points: the mean of the measured by their weights. Sums of weights are kept in
   !> single precision, so that heights of magnitude one err by 1e-7 or so.
   subroutine test_means()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: before(:, :)
      real(wp) :: cutoff, worst, total, weights, w
      integer :: trial, i, j, k, l

      stream = random_stream(seed + 1)
      worst = 0.0_wp
      do trial = 1, 4
         call random_map(map, stream, random_whole(stream, 25, 40), random_whole(stream, 25, 30), &
            0.1_wp, 0.08_wp)
         call punch_holes(map, stream, 0.5_wp)
         map%heights(3:9, 5:20) = none
         map%heights(6, 12) = 1.0_wp
         cutoff = merge(0.4_wp, 1.9_wp, trial <= 2)
         if (allocated(before)) deallocate (before)
         allocate (before, source=map%heights)
         call filter_short(map, cutoff, error)
         call assertFalse(allocated(error))
         do j = 1, size(before, 2)
            do i = 1, size(before, 1)
               if (before(i, j) >= none) then
                  call assertTrue(map%heights(i, j) >= none, message='stays missing')
                  cycle
               end if
               total = 0.0_wp
               weights = 0.0_wp
               do l = 1, size(before, 2)
                  do k = 1, size(before, 1)
                     if (before(k, l) >= none) cycle
                     w = weight(k - i, cutoff/0.1_wp)*weight(l - j, cutoff/0.08_wp)
                     weights = weights + w
                     total = total + w*before(k, l)
                  end do
               end do
               call worsen(worst, abs(map%heights(i, j) - total/weights))
            end do
         end do
      end do
      call record('surface.filter.means', worst)
      call assertLessThan(worst, 3.0e-7_wp)
   end subroutine test_means

   !> Products of a line along x and one along y are what order 1 keeps.
   subroutine test_planes()
      real(wp), parameter :: cutoffs(3) = [2.0_wp, 12.0_wp, 44.0_wp]
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp) :: exact(60, 45)
      integer :: cutoff, i, j

      do cutoff = 1, size(cutoffs)
         call flat_map(map, 60, 45, 1.0_wp, 1.0_wp)
         do j = 1, 45
            do i = 1, 60
               exact(i, j) = 1.0_wp + 0.02_wp*i - 0.03_wp*j + 0.001_wp*i*j
            end do
         end do
         map%heights = exact
         call filter_short(map, cutoffs(cutoff), error)
         call assertFalse(allocated(error))
         call assertLessThan(largest_of(map%heights - exact), 1.0e-12_wp)
         map%heights = exact
         call filter_long(map, cutoffs(cutoff), error)
         call assertLessThan(largest_of(map%heights), 1.0e-12_wp)
      end do
   end subroutine test_planes

   subroutine test_sum()
      type(random_stream) :: stream
      type(height_map) :: map, short, long
      type(error_type), allocatable :: error
      integer :: trial

      stream = random_stream(seed + 2)
      call random_map(map, stream, 50, 40, 0.01_wp, 0.01_wp)
      do trial = 1, 2
         short = map
         long = map
         call filter_short(short, 0.25_wp, error)
         call assertFalse(allocated(error))
         call filter_long(long, 0.25_wp, error)
         call assertFalse(allocated(error))
         associate (measured => map%heights < none)
            call assertLessThan(largest_of(pack(short%heights, measured) + &
               pack(long%heights, measured) - pack(map%heights, measured)), 1.0e-14_wp)
         end associate
         call assertTrue(all(map%heights >= none .eqv. long%heights >= none))
         call punch_holes(map, stream, 0.1_wp)
      end do
   end subroutine test_sum

   !> With a point missing far away, a slope of 1 is filtered at its end as alpha cutoff/pi further
   !> in, which the manual says; points in place of an integral change that by some percent.
   subroutine test_slope()
      type(height_map) :: map
      type(error_type), allocatable :: error
      integer :: i

      call flat_map(map, 200, 41, 1.0_wp, 1.0_wp)
      do i = 1, 200
         map%heights(i, :) = real(i, wp)
      end do
      map%heights(150, 20) = none
      call filter_short(map, 40.0_wp, error)
      call assertFalse(allocated(error))
      call assertEqual(alpha*40.0_wp/pi, map%heights(1, 20) - 1.0_wp, tolerance=0.4_wp)
      ! one cutoff away from the end nothing of that is left
      call assertEqual(45.0_wp, map%heights(45, 20), tolerance=1.0e-3_wp)
   end subroutine test_slope

   subroutine test_refused()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: kept(:, :)
      real(wp), parameter :: below = nearest(1.0_wp, -1.0_wp), above = nearest(1.5_wp, 1.0_wp)
      character(len=:), allocatable :: positive

      stream = random_stream(seed + 3)
      positive = ' mm is not allowed: it must be above 0 and finite'
      call random_map(map, stream, 9, 7, 0.5_wp, 0.25_wp)
      allocate (kept, source=map%heights)
      call check(0.0_wp, to_text(0.0_wp)//positive)
      call check(-1.0_wp, to_text(-1.0_wp)//positive)
      call check(transfer(int(z'7FF8000000000000', int64), 1.0_wp), 'NaN'//positive)
      call check(transfer(int(z'7FF0000000000000', int64), 1.0_wp), 'Infinity'//positive)
      call check(0.999_wp, '0.999 mm is below two steps of the map, 1.0 mm')
      call check(1.501_wp, '1.501 mm is longer than the map''s shorter side, 1.5 mm')
      map%step_x = 0.25_wp
      map%step_y = 0.4_wp
      call check(0.7_wp, '0.7 mm is below two steps of the map, 0.8 mm')
      call check(2.1_wp, '2.1 mm is longer than the map''s shorter side, 2.0 mm')
      map%step_x = 0.5_wp
      map%step_y = 0.25_wp
      call filter_short(map, 1.0_wp, error)
      call assertFalse(allocated(error))
      call filter_long(map, 1.5_wp, error)
      call assertFalse(allocated(error))
      map%heights = kept
      call check(below, to_text(below)//' mm is below two steps of the map, 1.0 mm')
      call check(above, to_text(above)//' mm is longer than the map''s shorter side, 1.5 mm')

   contains

      subroutine check(cutoff, expected)
         real(wp), intent(in) :: cutoff
         character(len=*), intent(in) :: expected

         call filter_short(map, cutoff, error)
         call assertTrue(allocated(error), message=expected)
         if (allocated(error)) call assertEqual('short_cutoff = '//expected, error%message)
         call filter_long(map, cutoff, error)
         call assertTrue(allocated(error), message=expected)
         if (allocated(error)) call assertEqual('long_cutoff = '//expected, error%message)
         call assertTrue(kept_map(map, kept), message='the map is kept')
      end subroutine check

   end subroutine test_refused

end module test_surface_gaussian_filter
