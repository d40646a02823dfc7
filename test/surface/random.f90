!> Random numbers and random surfaces: known values, autocorrelation, moments, skewness and
!> kurtosis of ensembles against what was asked for, within the scatter of the seeds.
module test_surface_random
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_type, only: height_map
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_surface_fourier, only: transform_backward_2d
   use asperity_surface_generate_height_distribution, only: distorted_correlation, &
      marginal_height, marginal_type, new_marginal
   use asperity_surface_generate_map, only: generate_surface, surface_settings
   use asperity_surface_generate_random_stream, only: fill_normal, new_random, next_uniform, &
      random_type
   use asperity_surface_generate_settings, only: check_surface_settings
   use asperity_surface_generate_spectrum, only: distort_spectrum, fill_spectrum
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_surface_random

   !> Seeds of an ensemble; a mean further off than 4 standard errors has a chance of 1e-4
   integer, parameter :: n_seeds = 200

contains

   function suite_surface_random() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('random surfaces')
      call suite%addTest(TestMethod('random numbers', test_numbers))
      call suite%addTest(TestMethod('Gaussian numbers', test_normal))
      call suite%addTest(TestMethod('seeds', test_seeds))
      call suite%addTest(TestMethod('Gaussian autocorrelation', test_gaussian))
      call suite%addTest(TestMethod('exponential autocorrelation', test_exponential))
      call suite%addTest(TestMethod('self-affine spectrum', test_self_affine))
      call suite%addTest(TestMethod('heights of given skewness and kurtosis', test_marginal))
      call suite%addTest(TestMethod('distorted autocorrelation', test_distorted))
      call suite%addTest(TestMethod('skewed surfaces', test_skewed))
      call suite%addTest(TestMethod('settings refused', test_refused))
   end function suite_surface_random

   !> First numbers of MRG32k3a with all state 12345, as published with it.
   subroutine test_numbers()
      type(random_type) :: stream
      real(wp) :: x(3)
      integer :: i

      stream%a = 12345
      stream%b = 12345
      do i = 1, 3
         call next_uniform(stream, x(i))
      end do
      call assertRelativelyEqual([0.12701112204657714_wp, 0.3185275653967945_wp, &
         0.3091860155832701_wp], x, 1.0e-15_wp, 'MRG32k3a')
   end subroutine test_numbers

   !> Moments and neighbours' correlation of 2e5 numbers within 4 standard errors, and chi^2 of 20
   !> equally likely classes below its 99.99 % point.
   subroutine test_normal()
      integer, parameter :: n = 200000, classes = 20
      type(random_type) :: stream
      real(wp), allocatable :: x(:)
      integer :: counts(classes), i, k

      allocate (x(n))
      call new_random(stream, 3)
      call fill_normal(stream, x)
      call assertEqual(0.0_wp, sum(x)/n, 4.0_wp/sqrt(real(n, wp)), 'mean')
      call assertEqual(1.0_wp, sum(x**2)/n, 4.0_wp*sqrt(2.0_wp/n), 'variance')
      call assertEqual(0.0_wp, sum(x**3)/n, 4.0_wp*sqrt(15.0_wp/n), 'skewness')
      call assertEqual(3.0_wp, sum(x**4)/n, 4.0_wp*sqrt(96.0_wp/n), 'kurtosis')
      do k = 1, 3
         call assertEqual(0.0_wp, sum(x(:n - k)*x(1 + k:))/n, 4.0_wp/sqrt(real(n, wp)), &
            'neighbours')
      end do
      counts = 0
      do i = 1, n
         k = min(classes, 1 + int(classes*0.5_wp*erfc(-x(i)/sqrt(2.0_wp))))
         counts(k) = counts(k) + 1
      end do
      call assertLessThan(sum((counts - real(n/classes, wp))**2)*classes/n, 51.0_wp, 'chi^2')
   end subroutine test_normal

   !> One seed, one surface; other seeds, surfaces that have nothing to do with it.
   subroutine test_seeds()
      integer, parameter :: seeds(4) = [1, 2, -1, huge(1)]
      type(surface_settings) :: settings
      type(height_map) :: map, again
      type(error_type), allocatable :: error
      real(wp), allocatable :: all(:, :)
      integer :: i, j

      settings%points_x = 200
      settings%points_y = 161
      settings%correlation_length_x = 0.02_wp
      settings%correlation_length_y = 0.02_wp
      allocate (all(200*161, size(seeds)))
      do i = 1, size(seeds)
         settings%seed = seeds(i)
         call generate_surface(settings, map, error)
         call assertTrue(.not. allocated(error), 'generated')
         call generate_surface(settings, again, error)
         call assertEqual(0.0_wp, largest_of(map%heights - again%heights), 'the same again')
         call assertEqual(161, size(map%heights, 2), 'points')
         call assertRelativelyEqual([0.005_wp, 0.005_wp], [map%step_x, map%step_y], 1.0e-15_wp, &
            'steps')
         all(:, i) = pack(map%heights, .true.)/settings%sq
      end do
      ! 32200 points of 8 correlated ones each: standard error 0.02
      do i = 1, size(seeds)
         do j = 1, i - 1
            call assertLessThan(abs(sum(all(:, i)*all(:, j))/size(all, 1)), 0.08_wp, 'correlation')
         end do
      end do
   end subroutine test_seeds

   !> Compare means over seeds with what is expected, and report the worst in standard errors.
   subroutine check_ensemble(key, expected, found)
      character(len=*), intent(in) :: key
      !> (quantity), (quantity, seed)
      real(wp), intent(in) :: expected(:), found(:, :)
      real(wp) :: mean, error, worst
      integer :: i, n

      worst = 0.0_wp
      n = size(found, 2)
      do i = 1, size(expected)
         mean = sum(found(i, :))/n
         error = sqrt(sum((found(i, :) - mean)**2)/(n - 1))/sqrt(real(n, wp))
         call worsen(worst, abs(mean - expected(i))/error)
      end do
      call record('surface.random.'//key//'.standard_errors', worst)
      call assertLessThan(worst, 4.0_wp, key)
   end subroutine check_ensemble

   !> Mean products at lags, and mean squares of slopes and curvatures by differences, of one map.
   pure function measured(map, lags) result(found)
      type(height_map), intent(in) :: map
      integer, intent(in) :: lags(:, :)
      real(wp) :: found(size(lags, 2) + 4)
      integer :: i, n, nx, ny

      nx = size(map%heights, 1)
      ny = size(map%heights, 2)
      n = size(lags, 2)
      associate (z => map%heights, hx => map%step_x, hy => map%step_y)
         do i = 1, n
            associate (k => lags(1, i), l => lags(2, i))
               found(i) = sum(z(:nx - k, :ny - l)*z(1 + k:, 1 + l:))/((nx - k)*(ny - l))
            end associate
         end do
         found(n + 1) = sum((z(2:, :) - z(:nx - 1, :))**2)/((nx - 1)*ny)/hx**2
         found(n + 2) = sum((z(:, 2:) - z(:, :ny - 1))**2)/((ny - 1)*nx)/hy**2
         found(n + 3) = sum((z(3:, :) - 2.0_wp*z(2:nx - 1, :) + z(:nx - 2, :))**2) &
            /((nx - 2)*ny)/hx**4
         found(n + 4) = sum((z(:, 3:) - 2.0_wp*z(:, 2:ny - 1) + z(:, :ny - 2))**2) &
            /((ny - 2)*nx)/hy**4
      end associate
   end function measured

   !> What `measured` should be on average, of an autocorrelation at the lags and at one and two
   !> steps along x and y.
   pure function expected_of(at_lags, along_x, along_y, step) result(expected)
      real(wp), intent(in) :: at_lags(:), along_x(2), along_y(2), step
      real(wp) :: expected(size(at_lags) + 4)

      associate (r0 => at_lags(1))
         expected = [at_lags, 2.0_wp*(r0 - along_x(1))/step**2, 2.0_wp*(r0 - along_y(1))/step**2, &
            (6.0_wp*r0 - 8.0_wp*along_x(1) + 2.0_wp*along_x(2))/step**4, &
            (6.0_wp*r0 - 8.0_wp*along_y(1) + 2.0_wp*along_y(2))/step**4]
      end associate
   end function expected_of

   !> Autocorrelation, also from end to end of the map, and the moments of the differences.
   subroutine test_gaussian()
      integer, parameter :: lags(2, 6) = reshape([0, 0, 3, 0, 0, 5, 4, 4, 12, 3, 47, 0], [2, 6])
      type(surface_settings) :: s
      real(wp), allocatable :: found(:, :)
      real(wp) :: angle

      s%points_x = 48
      s%points_y = 40
      s%step = 0.01_wp
      s%correlation_length_x = 0.03_wp
      s%correlation_length_y = 0.09_wp
      s%direction = 25.0_wp
      angle = s%direction*pi/180.0_wp
      call run(s, lags, found)
      call check_ensemble('gaussian', expected_of(r(lags(1, :), lags(2, :)), r([1, 2], [0, 0]), &
         r([0, 0], [1, 2]), s%step), found)
   contains
      elemental real(wp) function r(k, l)
         integer, intent(in) :: k, l
         real(wp) :: u, v

         u = s%step*(k*cos(angle) + l*sin(angle))/s%correlation_length_x
         v = s%step*(l*cos(angle) - k*sin(angle))/s%correlation_length_y
         r = s%sq**2*exp(-u*u - v*v)
      end function r
   end subroutine test_gaussian

   subroutine test_exponential()
      integer, parameter :: lags(2, 6) = reshape([0, 0, 3, 0, 0, 5, 4, 4, 12, 3, 47, 0], [2, 6])
      type(surface_settings) :: s
      real(wp), allocatable :: found(:, :)
      real(wp) :: angle

      s%points_x = 48
      s%points_y = 40
      s%step = 0.01_wp
      s%spectrum = 'exponential'
      s%correlation_length_x = 0.03_wp
      s%correlation_length_y = 0.06_wp
      s%direction = -50.0_wp
      angle = s%direction*pi/180.0_wp
      call run(s, lags, found)
      call check_ensemble('exponential', expected_of(r(lags(1, :), lags(2, :)), &
         r([1, 2], [0, 0]), r([0, 0], [1, 2]), s%step), found)
   contains
      elemental real(wp) function r(k, l)
         integer, intent(in) :: k, l

         r = s%sq**2*exp(-s%step*hypot( &
            (k*cos(angle) + l*sin(angle))/s%correlation_length_x, &
            (l*cos(angle) - k*sin(angle))/s%correlation_length_y))
      end function r
   end subroutine test_exponential

   !> The autocorrelation is the integral of the isotropic spectrum times J0, here by the midpoint
   !> rule. The spectrum is sampled by waves that fit the larger map: 1 % of the variance is allowed
   !> for that, as standard errors are 2 %.
   subroutine test_self_affine()
      integer, parameter :: lags(2, 5) = reshape([0, 0, 3, 0, 0, 6, 8, 8, 30, 0], [2, 5])
      integer, parameter :: n = 4000
      type(surface_settings) :: s
      real(wp), allocatable :: found(:, :)
      real(wp) :: k(n), weight(n), kl, ks
      integer :: i

      s%points_x = 64
      s%points_y = 60
      s%step = 0.01_wp
      s%spectrum = 'self_affine'
      s%hurst = 0.7_wp
      s%longest_wave = 0.3_wp
      s%shortest_wave = 0.06_wp
      kl = 2.0_wp*pi*s%step/s%longest_wave
      ks = 2.0_wp*pi*s%step/s%shortest_wave
      k = [(ks*(i - 0.5_wp)/n, i=1, n)]
      weight = k*max(k, kl)**(-2.0_wp - 2.0_wp*s%hurst)
      weight = s%sq**2*weight/sum(weight)
      call run(s, lags, found)
      call check_ensemble('self_affine', expected_of(r(lags(1, :), lags(2, :)), r([1, 2], [0, 0]), &
         r([0, 0], [1, 2]), s%step), found)
   contains
      elemental real(wp) function r(l, m)
         integer, intent(in) :: l, m

         r = sum(weight*bessel_j0(k*hypot(real(l, wp), real(m, wp))))
      end function r
   end subroutine test_self_affine

   !> Measure the maps of all seeds.
   subroutine run(settings, lags, found)
      type(surface_settings), intent(in) :: settings
      integer, intent(in) :: lags(:, :)
      real(wp), allocatable, intent(out) :: found(:, :)
      type(surface_settings) :: s
      type(height_map) :: map
      type(error_type), allocatable :: error
      integer :: i

      allocate (found(size(lags, 2) + 4, n_seeds))
      s = settings
      do i = 1, n_seeds
         s%seed = i
         call generate_surface(s, map, error)
         if (allocated(error)) error stop 'test_surface_random: '//error%message
         found(:, i) = measured(map, lags)
      end do
   end subroutine run

   !> Over all that is said to be reached: moments by Gauss-Legendre rules, which the solver does
   !> not use, and a rising function, so that correlations are turned back.
   subroutine test_marginal()
      real(wp), parameter :: highest(6) = [3.0_wp, 6.0_wp, 12.0_wp, 20.0_wp, 40.0_wp, 60.0_wp]
      type(marginal_type) :: g
      type(error_type), allocatable :: error
      real(wp) :: ssk, sku, moments(4), worst, x, z, last, r
      integer :: i, j, k, panel

      worst = 0.0_wp
      do i = -8, 8
         ssk = 0.5_wp*i
         do j = 0, size(highest)
            sku = 1.1_wp*ssk**2 + 1.3_wp
            if (j > 0) sku = max(sku, highest(max(j, 1)))
            call new_marginal(g, ssk, sku, error)
            call assertTrue(.not. allocated(error), 'reached')
            if (allocated(error)) return
            moments = 0.0_wp
            last = -huge(1.0_wp)
            do panel = -12, 11
               do k = 1, n_points
                  x = panel + 0.5_wp + 0.5_wp*nodes(k)
                  z = marginal_height(g, x)
                  call assertTrue(z >= last, 'rising')
                  last = z
                  moments = moments + 0.5_wp*weights(k)*exp(-0.5_wp*x*x)/sqrt(2.0_wp*pi) &
                     *[z, z**2, z**3, z**4]
               end do
            end do
            call worsen(worst, largest_of((moments - [0.0_wp, 1.0_wp, ssk, sku])/(1.0_wp + sku)))
         end do
      end do
      call record('surface.marginal.moments', worst)
      call assertLessThan(worst, 1.0e-6_wp, 'mean, variance, ssk, sku')
      ! the product of two heights by quadrature over both, at a correlation turned back
      call new_marginal(g, -1.2_wp, 5.0_wp, error)
      do i = -1, 3
         r = distorted_correlation(g, 0.25_wp*i)
         z = 0.0_wp
         do j = 1, n_points
            do k = 1, n_points
               x = 7.0_wp*nodes(j)
               last = 7.0_wp*nodes(k)
               z = z + 49.0_wp*weights(j)*weights(k)*exp(-0.5_wp*(x*x + last*last))/(2.0_wp*pi) &
                  *marginal_height(g, x)*marginal_height(g, r*x + sqrt(1.0_wp - r*r)*last)
            end do
         end do
         call assertEqual(0.25_wp*i, z, 1.0e-8_wp, 'correlation of heights')
      end do
   end subroutine test_marginal

   !> The distorted spectrum is that of the distorted autocorrelation at every place, also of one
   !> without a mirror line; what is dropped as no variance is 1e-4 of it at most.
   subroutine test_distorted()
      integer, parameter :: nx = 48, ny = 40
      type(surface_settings) :: s
      type(marginal_type) :: g
      type(error_type), allocatable :: error
      complex(wp) :: spectrum(nx/2 + 1, ny)
      real(wp) :: field(nx, ny), expected(nx, ny), largest_step

      s%step = 0.01_wp
      s%correlation_length_x = 0.02_wp
      s%correlation_length_y = 0.06_wp
      s%direction = 30.0_wp
      call new_marginal(g, -0.5_wp, 3.5_wp, error)
      call fill_spectrum(s, spectrum, field)
      call transform_backward_2d(spectrum, field)
      expected = distorted_correlation(g, field)
      largest_step = largest_of(expected - field)
      call fill_spectrum(s, spectrum, field)
      call distort_spectrum(g, spectrum, field)
      call transform_backward_2d(spectrum, field)
      call record('surface.distorted', largest_of(field - expected))
      call assertEqual(reshape(expected, [nx*ny]), reshape(field, [nx*ny]), 1.0e-4_wp, &
         'autocorrelation')
      call assertTrue(largest_step > 2.0e-3_wp, 'is another')
   end subroutine test_distorted

   !> Skewness, kurtosis and autocorrelation of surfaces that are not Gaussian, unbounded and
   !> bounded ones.
   subroutine test_skewed()
      real(wp), parameter :: targets(2, 3) = reshape([-1.0_wp, 4.5_wp, 0.0_wp, 2.2_wp, 0.7_wp, &
         6.0_wp], [2, 3])
      integer, parameter :: lags(2, 3) = reshape([0, 0, 3, 0, 2, 6], [2, 3])
      character(len=1), parameter :: names(3) = ['1', '2', '3']
      type(surface_settings) :: s
      type(height_map) :: map
      type(error_type), allocatable :: error
      integer, parameter :: n_skewed = 100
      real(wp) :: found(5, n_skewed)
      integer :: i, k, lag

      s%points_x = 64
      s%points_y = 64
      s%step = 0.01_wp
      s%correlation_length_x = 0.03_wp
      s%correlation_length_y = 0.05_wp
      do k = 1, 3
         s%ssk = targets(1, k)
         s%sku = targets(2, k)
         do i = 1, n_skewed
            s%seed = i
            call generate_surface(s, map, error)
            if (allocated(error)) error stop 'test_skewed: '//error%message
            map%heights = map%heights/s%sq
            found(1, i) = sum(map%heights**3)/size(map%heights)
            found(2, i) = sum(map%heights**4)/size(map%heights)
            do lag = 1, 3
               associate (a => lags(1, lag), b => lags(2, lag), z => map%heights)
                  found(2 + lag, i) = sum(z(:64 - a, :64 - b)*z(1 + a:, 1 + b:)) &
                     /((64 - a)*(64 - b))
               end associate
            end do
         end do
         call check_ensemble('skewed_'//names(k), [s%ssk, s%sku, &
            exp(-(lags(1, :)/3.0_wp)**2 - (lags(2, :)/5.0_wp)**2)], found)
      end do
   end subroutine test_skewed

   !> Every setting out of its range is refused with its name.
   subroutine test_refused()
      type(surface_settings) :: s
      type(error_type), allocatable :: error

      s%points_x = 4
      call refuse(s, 'points_x')
      s = surface_settings(points_y=1000000)
      call refuse(s, 'points_y')
      s = surface_settings(step=0.0_wp)
      call refuse(s, 'step')
      s = surface_settings(sq=-1.0_wp)
      call refuse(s, 'sq')
      s = surface_settings(correlation_length_x=0.009_wp)
      call refuse(s, 'correlation_length_x')
      s = surface_settings(correlation_length_y=3.0_wp)
      call refuse(s, 'correlation_length_y')
      s = surface_settings(spectrum='white')
      call refuse(s, 'spectrum')
      s = surface_settings(spectrum='self_affine', hurst=1.2_wp)
      call refuse(s, 'hurst')
      s = surface_settings(spectrum='self_affine', longest_wave=4.0_wp)
      call refuse(s, 'longest_wave')
      s = surface_settings(spectrum='self_affine', shortest_wave=0.6_wp)
      call refuse(s, 'shortest_wave', 'longest_wave shortest_wave')
      s = surface_settings(ssk=2.0_wp, sku=4.9_wp)
      call refuse(s, 'ssk^2 + 1', 'ssk sku')
      s = surface_settings(ssk=0.0_wp, sku=1.01_wp)
      call refuse(s, 'cannot be reached', 'ssk sku')
      s = surface_settings(sku=1.0e9_wp)
      call refuse(s, 'sku')
      s = surface_settings(ssk=0.0_wp, sku=1.0e5_wp)
      call refuse(s, 'cannot be reached', 'ssk sku')
      s = surface_settings(points_x=100000, points_y=100000)
      call refuse(s, 'memory', '')
      s = surface_settings(direction=huge(1.0_wp))
      call refuse(s, 'direction')
      s = surface_settings(points_x=8, points_y=8, correlation_length_x=0.02_wp, &
         correlation_length_y=0.02_wp, direction=1.0e6_wp)
      call refuse(s, 'number below 1e6', 'direction')
      s%direction = nearest(s%direction, -1.0_wp)
      call check_surface_settings(s, error)
      call assertFalse(allocated(error), 'just below')
   end subroutine test_refused

   !> The message holds the word, which is the subject unless that is given.
   subroutine refuse(settings, word, subject)
      type(surface_settings), intent(in) :: settings
      character(len=*), intent(in) :: word
      character(len=*), intent(in), optional :: subject
      type(height_map) :: map
      type(error_type), allocatable :: error

      call generate_surface(settings, map, error)
      call assertTrue(allocated(error), word//' is refused')
      if (.not. allocated(error)) return
      call assertTrue(index(error%message, word) > 0, error%message)
      if (present(subject)) then
         call assertEqual(subject, error%subject)
      else
         call assertEqual(word, error%subject)
      end if
   end subroutine refuse

end module test_surface_random
