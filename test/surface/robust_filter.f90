!> The robust L filter against fits by the definition, its transmission, and a profile with pores.
module test_surface_robust_filter
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_surface_prepare_gaussian_filter, only: filter_long
   use asperity_surface_prepare_regression, only: gamma_2, regress
   use asperity_surface_prepare_robust_filter, only: filter_long_robust, median
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use map_cases, only: flat_map, kept_map, punch_holes, random_map
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_robust_filter

   real(wp), parameter :: pi = 4.0_wp*atan(1.0_wp)
   integer(int64), parameter :: seed = 2718281_int64

contains

   function suite_surface_robust_filter() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_robust_filter')
      call suite%addTest(TestMethod('waves pass by (1 + u) exp(-u)', test_transmission))
      call suite%addTest(TestMethod('fits by the definition', test_fits))
      call suite%addTest(TestMethod('a settled line is the fit with its own weights', test_settled))
      call suite%addTest(TestMethod('parabolas with spikes come out again', test_spikes))
      call suite%addTest(TestMethod('pores bend the linear line and not the robust one', &
         test_pores))
      call suite%addTest(TestMethod('medians', test_median))
      call suite%addTest(TestMethod('refused cutoffs and holes', test_refused))
   end function suite_surface_robust_filter

   !> Away from the ends, with all weights 1. gamma as ISO 16610-31 has it, 0.7309.
   subroutine test_transmission()
      real(wp), parameter :: cutoff = 40.0_wp, ratios(4) = [0.5_wp, 1.0_wp, 2.0_wp, 5.0_wp]
      real(wp), allocatable :: z(:, :), line(:, :), ones(:, :)
      real(wp) :: u, worst
      integer :: i, k, middle, ny

      call assertEqual(0.7309_wp, gamma_2, 5.0e-5_wp)
      worst = 0.0_wp
      do ny = 1, 301, 300
         allocate (z(501, ny), line(501, ny), ones(501, ny))
         ones = 1.0_wp
         middle = (ny + 1)/2
         do k = 1, size(ratios)
            do i = 1, 501
               z(i, :) = cos(2.0_wp*pi*i/(ratios(k)*cutoff))
            end do
            call regress(z, ones, cutoff, cutoff, 2, line)
            u = pi*(gamma_2/ratios(k))**2
            do i = 110, 390
               call worsen(worst, [abs(line(i, middle) - (1.0_wp + u)*exp(-u)*z(i, 1))])
            end do
         end do
         deallocate (z, line, ones)
      end do
      call record('surface.regression.transmission', worst)
      call assertLessThan(worst, 1.0e-12_wp)
   end subroutine test_transmission

   !> The normal equations of every point summed directly and solved by elimination.
   pure function fit_at(z, weights, cutoff_x, cutoff_y, i, j) result(value)
      real(wp), intent(in) :: z(:, :), weights(:, :), cutoff_x, cutoff_y
      integer, intent(in) :: i, j
      real(wp) :: value, a(6, 7), t(6), x, y
      integer :: k, l, n, p

      n = merge(3, 6, size(z, 2) == 1)
      a = 0.0_wp
      do l = 1, size(z, 2)
         do k = 1, size(z, 1)
            x = (k - i)/(gamma_2*cutoff_x)
            y = (l - j)/(gamma_2*cutoff_y)
            t = [1.0_wp, x, x*x, y, x*y, y*y]
            do p = 1, n
               a(p, :n) = a(p, :n) + weights(k, l)*exp(-pi*(x*x + y*y))*t(p)*t(:n)
               a(p, 7) = a(p, 7) + weights(k, l)*exp(-pi*(x*x + y*y))*t(p)*z(k, l)
            end do
         end do
      end do
      do p = 1, n
         a(p, :) = a(p, :)/a(p, p)
         do k = 1, n
            if (k /= p) a(k, :) = a(k, :) - a(k, p)*a(p, :)
         end do
      end do
      value = a(1, 7)
   end function fit_at

   !> A profile and a map of unequal steps, whose weights are random and 0 in a third of the points,
   !> to their ends and corners.
   subroutine test_fits()
      type(random_stream) :: stream
      type(height_map) :: map
      real(wp), allocatable :: weights(:, :), line(:, :)
      real(wp) :: worst
      integer :: i, j, k
      integer, parameter :: nx(2) = [200, 40], ny(2) = [1, 27]

      stream = random_stream(seed)
      worst = 0.0_wp
      do k = 1, 2
         call random_map(map, stream, nx(k), ny(k), 1.0_wp, 1.5_wp)
         allocate (weights(nx(k), ny(k)), line(nx(k), ny(k)))
         do j = 1, ny(k)
            do i = 1, nx(k)
               weights(i, j) = max(stream%uniform(-0.5_wp, 1.0_wp), 0.0_wp)
            end do
         end do
         call regress(map%heights, weights, 15.0_wp, 10.0_wp, 2, line)
         do j = 1, ny(k)
            do i = 1, nx(k)
               call worsen(worst, [abs(line(i, j) - fit_at(map%heights, weights, 15.0_wp, &
                  10.0_wp, i, j))])
            end do
         end do
         deallocate (weights, line)
      end do
      call record('surface.regression.definition', worst)
      call assertLessThan(worst, 1.0e-11_wp)
   end subroutine test_fits

   !> What the filter leaves has weights; the fit with them is what it took away, to what the rule
   !> of convergence leaves: c/10000 an iteration.
   subroutine test_settled()
      type(random_stream) :: stream
      type(height_map) :: map, left
      type(error_type), allocatable :: error
      real(wp), allocatable :: line(:, :), again(:, :), weights(:, :)
      real(wp) :: c
      integer :: k

      stream = random_stream(seed)
      do k = 1, 2
         if (k == 1) then
            call random_map(map, stream, 400, 1, 0.1_wp, 0.1_wp)
         else
            call random_map(map, stream, 60, 50, 0.1_wp, 0.12_wp)
         end if
         call punch_holes(map, stream, 0.1_wp)
         map%heights(20:26, :) = map%heights(20:26, :) - 9.0_wp
         where (map%heights > 1.0e3_wp) map%heights = none
         left = map
         call filter_long_robust(left, 2.0_wp, error)
         call assertFalse(allocated(error))
         if (allocated(error)) return
         line = map%heights - left%heights
         c = 4.4478_wp*median(pack(abs(left%heights), map%heights < none))
         weights = max(1.0_wp - (min(left%heights, c)/c)**2, 0.0_wp)**2
         where (map%heights >= none) weights = 0.0_wp
         where (abs(left%heights) >= c) weights = 0.0_wp
         allocate (again, mold=line)
         call regress(merge(map%heights, 0.0_wp, map%heights < none), weights, 2.0_wp/map%step_x, &
            2.0_wp/map%step_y, 2, again)
         call assertLessThan(maxval(abs(again - line), mask=map%heights < none), 1.1e-4_wp*c)
         call assertTrue(all(left%heights >= none .eqv. map%heights >= none), 'holes stay')
         deallocate (again)
      end do
   end subroutine test_settled

   !> Most points are on a parabola: there nothing is left, at the others the spike.
   subroutine test_spikes()
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp) :: worst
      integer :: i

      call flat_map(map, 300, 1, 0.01_wp, 0.01_wp)
      do i = 1, 300
         map%heights(i, 1) = 1.0_wp - 0.02_wp*i + 3.0e-4_wp*i**2 - merge(5.0_wp, 0.0_wp, &
            mod(i, 10) < 3)
      end do
      call filter_long_robust(map, 0.8_wp, error)
      call assertFalse(allocated(error))
      worst = 0.0_wp
      do i = 1, 300
         call worsen(worst, [abs(map%heights(i, 1) + merge(5.0_wp, 0.0_wp, mod(i, 10) < 3))])
      end do
      call assertLessThan(worst, 1.0e-9_wp)
   end subroutine test_spikes

   !> Like wood: roughness of 3 um on a wave of 20 um, pores of 60 um in a fifth of the length. The
   !> line should be that of the same profile without pores.
   subroutine test_pores()
      type(random_stream) :: stream
      type(height_map) :: clean, left, linear, porous, robust
      type(error_type), allocatable :: error
      real(wp) :: bias(2), worst(2)
      integer :: i, k
      logical :: in_pore(1500)

      stream = random_stream(seed)
      call flat_map(clean, 1500, 1, 0.005_wp, 0.005_wp)
      do k = 1, 40
         ! waves of 0.05 to 0.3 mm
         clean%heights(:, 1) = clean%heights(:, 1) + 0.003_wp*sqrt(2.0_wp/40.0_wp) &
            *sin([(0.005_wp*i, i=1, 1500)]*2.0_wp*pi/stream%uniform(0.05_wp, 0.3_wp) &
            + stream%uniform(0.0_wp, 2.0_wp*pi))
      end do
      do i = 1, 1500
         clean%heights(i, 1) = clean%heights(i, 1) + 0.02_wp*sin(2.0_wp*pi*0.005_wp*i/6.0_wp)
         in_pore(i) = mod(i, 120) < 24
      end do
      porous = clean
      where (in_pore) porous%heights(:, 1) = porous%heights(:, 1) - 0.06_wp
      linear = porous
      robust = porous
      call filter_long(linear, 0.8_wp, error)
      call assertFalse(allocated(error))
      call filter_long_robust(robust, 0.8_wp, error)
      call assertFalse(allocated(error))
      ! what a filter leaves outside of pores is too high by what the pores pulled its line down
      left = clean
      call filter_long(left, 0.8_wp, error)
      call assertFalse(allocated(error))
      call compare(linear, bias(1), worst(1))
      left = clean
      call filter_long_robust(left, 0.8_wp, error)
      call assertFalse(allocated(error))
      call compare(robust, bias(2), worst(2))
      call record('surface.pores.linear_bias_um', 1.0e3_wp*bias(1))
      call record('surface.pores.robust_bias_um', 1.0e3_wp*bias(2))
      call record('surface.pores.linear_worst_um', 1.0e3_wp*worst(1))
      call record('surface.pores.robust_worst_um', 1.0e3_wp*worst(2))
      call assertGreaterThan(bias(1), 0.008_wp)
      call assertLessThan(abs(bias(2)), 0.03_wp*bias(1))
      call assertLessThan(worst(2), 0.25_wp*worst(1))

   contains

      subroutine compare(found, bias, worst)
         type(height_map), intent(in) :: found
         real(wp), intent(out) :: bias, worst

         bias = sum(found%heights(:, 1) - left%heights(:, 1), mask=.not. in_pore) &
            /count(.not. in_pore)
         worst = maxval(abs(found%heights(:, 1) - left%heights(:, 1)), mask=.not. in_pore)
      end subroutine compare

   end subroutine test_pores

   !> Against counting: as many below as above.
   subroutine test_median()
      type(random_stream) :: stream
      real(wp), allocatable :: v(:)
      real(wp) :: m
      integer :: i, n

      call assertEqual(3.0_wp, median([3.0_wp]), 0.0_wp)
      call assertEqual(2.5_wp, median([4.0_wp, 1.0_wp, 3.0_wp, 2.0_wp]), 0.0_wp)
      call assertEqual(7.0_wp, median([(7.0_wp, i=1, 50)]), 0.0_wp)
      call assertEqual(51.0_wp, median([(real(i, wp), i=1, 101)]), 0.0_wp)
      stream = random_stream(seed)
      do n = 2, 200
         allocate (v(n))
         do i = 1, n
            v(i) = real(floor(stream%uniform(0.0_wp, 30.0_wp)), wp)
         end do
         m = median(v)
         call assertTrue(count(v < m) <= n/2 .and. count(v > m) <= n/2, 'half on either side')
         deallocate (v)
      end do
   end subroutine test_median

   subroutine test_refused()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: before(:, :)

      stream = random_stream(seed)
      call random_map(map, stream, 200, 1, 0.1_wp, 0.1_wp)
      before = map%heights
      call filter_long_robust(map, 0.1_wp, error)
      call says(error, 'below two steps of the profile')
      call filter_long_robust(map, 20.0_wp, error)
      call says(error, 'longer than the profile')
      call filter_long_robust(map, -1.0_wp, error)
      call says(error, 'above 0')
      call assertTrue(kept_map(map, before))
      ! a part of another surface, wider than the weights reach
      map%heights(60:140:2, 1) = map%heights(60:140:2, 1) - 50.0_wp
      map%heights(61:140:2, 1) = map%heights(61:140:2, 1) + 50.0_wp
      before = map%heights
      call filter_long_robust(map, 1.0_wp, error)
      call says(error, 'in a part wider than long_cutoff')
      call assertTrue(kept_map(map, before))

   contains

      subroutine says(error, part)
         type(error_type), allocatable, intent(inout) :: error
         character(len=*), intent(in) :: part

         call assertTrue(allocated(error), 'must be refused: '//part)
         if (.not. allocated(error)) return
         call assertTrue(index(error%message, part) > 0, error%message)
         call assertEqual('long_cutoff', trim(error%subject))
         deallocate (error)
      end subroutine says

   end subroutine test_refused

end module test_surface_robust_filter
