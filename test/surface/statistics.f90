!> Parameters from sums of points, Nayak's summits against quadrature over the Gaussian density of
!> the second derivatives, Student's t, and the jackknife over tiles.
module test_surface_statistics
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_faces_nayak, only: nayak_summits, nayak_type, summit_curvature_density
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_direction, &
      p_eta_nayak, p_eta_paper, p_m0, p_m2, p_m2_across, p_m2_along, p_m4, p_m4_across, &
      p_m4_along, p_peak_mean, p_peak_sigma, p_radius_nayak, p_radius_paper, p_sa, p_sdq, &
      p_sigma_nayak, p_sku, p_sp, p_spc, p_spd, p_sq, p_ssk, p_summit_density, p_summit_plane, &
      p_sv, p_sz
   use asperity_base_student, only: student_factor, student_share
   use asperity_surface_parameters_tile_sums, only: surface_sums_type
   use asperity_surface_parameters_uncertainty, only: jackknife, uncertainties
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_statistics

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_surface_statistics() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface statistics')
      call suite%addTest(TestMethod('heights', test_heights))
      call suite%addTest(TestMethod('principal axes', test_axes))
      call suite%addTest(TestMethod('summits and routes', test_summits))
      call suite%addTest(TestMethod('what does not exist', test_missing))
      call suite%addTest(TestMethod('Nayak by quadrature', test_nayak))
      call suite%addTest(TestMethod('Nayak, values known', test_nayak_values))
      call suite%addTest(TestMethod('Student', test_student))
      call suite%addTest(TestMethod('jackknife of a mean', test_mean))
      call suite%addTest(TestMethod('jackknife of unequal tiles', test_unequal))
      call suite%addTest(TestMethod('jackknife of a direction', test_direction))
      call suite%addTest(TestMethod('share of the pruning', test_pruning))
   end function suite_surface_statistics

   !> Sums of listed heights.
   pure function sums_of(z) result(sums)
      real(wp), intent(in) :: z(:)
      type(surface_sums_type) :: sums

      sums%points = size(z)
      sums%first = sum(z)
      sums%absolute = sum(abs(z))
      sums%second = sum(z**2)
      sums%third = sum(z**3)
      sums%fourth = sum(z**4)
      sums%lowest = minval(z)
      sums%highest = maxval(z)
   end function sums_of

   !> Sums of slopes and curvatures of a surface whose derivatives along axes turned by `angle` have
   !> the covariances of a Gaussian autocorrelation of lengths lx, ly and variance 1.
   pure function sums_of_lay(angle, lx, ly) result(sums)
      real(wp), intent(in) :: angle, lx, ly
      type(surface_sums_type) :: sums
      real(wp) :: c, s, u(3), v(3), w(3), covariance(3, 3)

      c = cos(angle)
      s = sin(angle)
      sums = sums_of([-1.0_wp, 1.0_wp])
      sums%pairs_x = 1.0_wp
      sums%pairs_y = 1.0_wp
      sums%triples_x = 1.0_wp
      sums%triples_y = 1.0_wp
      sums%inner = 1.0_wp
      sums%slope_x = 2.0_wp*(c*c/lx**2 + s*s/ly**2)
      sums%slope_y = 2.0_wp*(s*s/lx**2 + c*c/ly**2)
      sums%gradient_xx = sums%slope_x
      sums%gradient_yy = sums%slope_y
      sums%gradient_xy = 2.0_wp*c*s*(1.0_wp/lx**2 - 1.0_wp/ly**2)
      ! of z_uu, z_vv, z_uv
      covariance = 0.0_wp
      covariance(1, 1) = 12.0_wp/lx**4
      covariance(2, 2) = 12.0_wp/ly**4
      covariance(1, 2) = 4.0_wp/(lx*ly)**2
      covariance(2, 1) = covariance(1, 2)
      covariance(3, 3) = covariance(1, 2)
      ! z_xx, z_yy, z_xy in them
      u = [c*c, s*s, -2.0_wp*c*s]
      v = [s*s, c*c, 2.0_wp*c*s]
      w = [c*s, -c*s, c*c - s*s]
      sums%hessian_xx_xx = dot_product(u, matmul(covariance, u))
      sums%hessian_yy_yy = dot_product(v, matmul(covariance, v))
      sums%hessian_xx_yy = dot_product(u, matmul(covariance, v))
      sums%hessian_xy_xy = dot_product(w, matmul(covariance, w))
      sums%hessian_xx_xy = dot_product(u, matmul(covariance, w))
      sums%hessian_yy_xy = dot_product(v, matmul(covariance, w))
      sums%curvature_x = sums%hessian_xx_xx
      sums%curvature_y = sums%hessian_yy_yy
   end function sums_of_lay

   !> Against sums of powers of heights less their mean, which moving all heights leaves.
   subroutine test_heights()
      real(wp) :: z(50), values(n_parameters), centred(50), sq
      type(random_stream) :: stream
      integer :: i

      stream = random_stream(7)
      do i = 1, size(z)
         z(i) = stream%log_uniform(0.1_wp, 3.0_wp)
      end do
      centred = z - sum(z)/50
      sq = sqrt(sum(centred**2)/50)
      call parameters_of(sums_of(z), 1.0_wp, values)
      call assertRelativelyEqual([sq**2, sq, sum(centred**3)/50/sq**3, sum(centred**4)/50/sq**4], &
         values([p_m0, p_sq, p_ssk, p_sku]), 1.0e-13_wp, 'moved')
      call parameters_of(sums_of(centred), 1.0_wp, values)
      call assertRelativelyEqual([sum(abs(centred))/50, sq, sum(centred**3)/50/sq**3, &
         sum(centred**4)/50/sq**4, maxval(centred), -minval(centred), maxval(z) - minval(z)], &
         values([p_sa, p_sq, p_ssk, p_sku, p_sp, p_sv, p_sz]), 1.0e-13_wp, 'centred')
   end subroutine test_heights

   !> The lay is found at every angle, with m2 and m4 along its own axes. Rounding only.
   subroutine test_axes()
      real(wp), parameter :: lx = 0.3_wp, ly = 1.1_wp
      real(wp) :: values(n_parameters), angle, worst
      integer :: i

      worst = 0.0_wp
      do i = 0, 35
         angle = (5*i + 1)*pi/180.0_wp
         call parameters_of(sums_of_lay(angle, lx, ly), 1.0_wp, values)
         call assertEqual(5*i + 1.0_wp, values(p_direction), 1.0e-11_wp, 'direction')
         call worsen(worst, largest_of(values([p_m2_across, p_m2_along, p_m4_across, p_m4_along, &
            p_m2, p_m4, p_sdq])/[2.0_wp/lx**2, 2.0_wp/ly**2, 12.0_wp/lx**4, 12.0_wp/ly**4, &
            2.0_wp/(lx*ly), 12.0_wp/(lx*ly)**2, sqrt(2.0_wp/lx**2 + 2.0_wp/ly**2)] - 1.0_wp))
         call assertRelativelyEqual(3.0_wp, values(p_alpha), 1.0e-11_wp, 'alpha')
      end do
      call record('surface.axes', worst)
      call assertLessThan(worst, 1.0e-11_wp, 'moments along the axes')
   end subroutine test_axes

   !> Densities are per inner area, R is 1/Spc, Nayak's route follows from the moments.
   subroutine test_summits()
      type(surface_sums_type) :: sums
      real(wp) :: values(n_parameters)
      type(nayak_type) :: nayak

      sums = sums_of_lay(0.2_wp, 0.5_wp, 0.5_wp)
      sums%inner = 2.0_wp
      sums%peaks%number = 4.0_wp
      sums%peaks%height = 2.0_wp
      sums%peaks%height_2 = 1.5_wp
      sums%peaks%curvature = 8.0_wp
      sums%summits%number = 6.0_wp
      call parameters_of(sums, 0.25_wp, values)
      call assertRelativelyEqual( &
         [8.0_wp, 2.0_wp, 8.0_wp, 0.5_wp, 0.5_wp, sqrt(0.125_wp), 12.0_wp], &
         values([p_spd, p_spc, p_eta_paper, p_radius_paper, p_peak_mean, p_peak_sigma, &
         p_summit_density]), 4.0_wp*eps, 'peaks')
      nayak = nayak_summits(values(p_m0), values(p_m2), values(p_m4))
      call assertRelativelyEqual([nayak%density, 1.0_wp/nayak%curvature, sqrt(nayak%variance), &
         nayak%height], values([p_eta_nayak, p_radius_nayak, p_sigma_nayak, p_summit_plane]), &
         4.0_wp*eps, 'Nayak')
   end subroutine test_summits

   subroutine test_missing()
      type(surface_sums_type) :: sums
      real(wp) :: values(n_parameters), widths(n_parameters)

      call parameters_of(sums, 1.0_wp, values)
      call assertTrue(all(values >= none), 'no points')
      ! flat
      sums = sums_of([0.0_wp, 0.0_wp])
      sums%pairs_x = 1.0_wp
      sums%pairs_y = 1.0_wp
      sums%triples_x = 1.0_wp
      sums%triples_y = 1.0_wp
      sums%inner = 1.0_wp
      call parameters_of(sums, 1.0_wp, values)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], values([p_sq, p_sdq, p_m4, p_spd]), &
         'flat')
      call assertTrue(all(values([p_ssk, p_sku, p_direction, p_alpha, p_spc, p_eta_paper, &
         p_radius_paper, p_eta_nayak, p_sigma_nayak]) >= none), 'flat')
      call uncertainties([sums], 1.0_wp, widths)
      call assertTrue(all(widths >= none), 'one tile')
      call uncertainties([sums, sums], 1.0_wp, widths)
      call assertTrue(all(widths([p_sz, p_sp, p_sv, p_alpha]) >= none), 'extremes')
      call assertEqual(0.0_wp, widths(p_sq), 'two equal tiles')
      ! alpha below 0.8968 leaves Nayak no sigma
      sums = sums_of_lay(0.0_wp, 1.0_wp, 1.0_wp)
      sums%second = 0.25_wp*sums%second
      call parameters_of(sums, 1.0_wp, values)
      call assertTrue(values(p_sigma_nayak) >= none .and. values(p_alpha) < 0.76_wp, &
         'small alpha')
   end subroutine test_missing

   !> Density, mean curvature, mean height and variance of height by quadrature over t = z_xx + z_yy
   !> and q = (z_xx - z_yy)^2 + 4 z_xy^2: Gaussian with variance 8 m4/3, and exponential with mean
   !> 8 m4/3; the determinant is (t^2 - q)/4, z given t is Gaussian.
   subroutine test_nayak()
      real(wp), parameter :: m0 = 2.3_wp, m2 = 0.7_wp, m4 = 0.9_wp, v = 8.0_wp*m4/3.0_wp
      real(wp) :: t, q, factor, sums(0:3), ends, height, spread
      type(nayak_type) :: nayak
      integer :: i, j

      nayak = nayak_summits(m0, m2, m4)
      sums = 0.0_wp
      ends = 9.0_wp*sqrt(v)
      spread = m0 - 4.0_wp*m2**2/v
      do i = 1, n_points
         t = -0.5_wp*ends*(1.0_wp + nodes(i))
         height = -2.0_wp*m2/v*t
         do j = 1, n_points
            q = 0.5_wp*min(t*t, 40.0_wp*v)*(1.0_wp + nodes(j))
            factor = 0.25_wp*ends*min(t*t, 40.0_wp*v)*weights(i)*weights(j) &
               *exp(-0.5_wp*t*t/v)/sqrt(2.0_wp*pi*v)*exp(-q/v)/v*0.25_wp*(t*t - q)
            sums = sums + factor*[1.0_wp, -0.5_wp*t, height, height**2 + spread]
         end do
      end do
      sums(1:) = sums(1:)/sums(0)
      sums = [sums(0)/(2.0_wp*pi*m2), sums(1), sums(2), sums(3) - sums(2)**2] &
         /[nayak%density, nayak%curvature, nayak%height, nayak%variance] - 1.0_wp
      call record('surface.nayak.quadrature', largest_of(sums))
      call assertLessThan(largest_of(sums), 1.0e-11_wp, 'density, curvature, height, variance')
      ! the density of curvatures itself
      sums = 0.0_wp
      do i = 1, n_points
         t = 5.0_wp*(1.0_wp + nodes(i))
         sums = sums + 5.0_wp*weights(i)*summit_curvature_density(t)*[1.0_wp, t, t*t, 0.0_wp]
      end do
      factor = sqrt(2.0_wp*m4/3.0_wp)
      call assertRelativelyEqual([1.0_wp, nayak%curvature/factor, &
         (nayak%curvature_sigma**2 + nayak%curvature**2)/factor**2], sums(:2), 1.0e-11_wp, &
         'density of curvatures')
   end subroutine test_nayak

   !> Figures of the literature: McCool's radius and 0.8968, and the relation of alpha to
   !> eta R sigma with the sigma of the surface.
   subroutine test_nayak_values()
      type(nayak_type) :: nayak

      nayak = nayak_summits(1.0_wp, 2.0_wp, 10.0_wp)
      call assertRelativelyEqual(2.5_wp, nayak%alpha, 4.0_wp*eps, 'alpha')
      call assertRelativelyEqual(0.375_wp*sqrt(pi/10.0_wp), 1.0_wp/nayak%curvature, 4.0_wp*eps, 'R')
      call assertEqual(sqrt(1.0_wp - 0.8968_wp/2.5_wp), sqrt(nayak%variance), 2.0e-6_wp, 'sigma')
      call assertRelativelyEqual(2.5_wp, 2412.74_wp*(nayak%density/nayak%curvature)**2, 1.0e-5_wp, &
         'alpha by eta R sigma')
      call assertRelativelyEqual(1.0_wp - nayak%variance, &
         3.717e-4_wp*(nayak%curvature/nayak%density)**2, 1.0e-4_wp, 'sigma by eta R')
   end subroutine test_nayak_values

   !> Tables give five decimals.
   subroutine test_student()
      integer, parameter :: degrees(9) = [1, 2, 3, 5, 10, 24, 63, 120, 20000]
      real(wp), parameter :: factors(9) = [12.70620_wp, 4.30265_wp, 3.18245_wp, 2.57058_wp, &
         2.22814_wp, 2.06390_wp, 1.99834_wp, 1.97993_wp, 1.9600_wp]
      integer :: i

      do i = 1, size(degrees)
         call assertEqual(factors(i), student_factor(0.95_wp, degrees(i)), &
            merge(6.0e-6_wp, 3.0e-4_wp, i < 9), 'table')
         call assertEqual(0.99_wp, student_share(student_factor(0.99_wp, min(degrees(i), 999)), &
            min(degrees(i), 999)), 1.0e-12_wp, 'round trip')
      end do
      ! Cauchy
      call assertRelativelyEqual(0.5_wp, student_share(1.0_wp, 1), 4.0_wp*eps, 'quartiles')
   end subroutine test_student

   !> For m0 of tiles of mean zero it is the scatter of the tiles over sqrt(tiles (tiles - 1)),
   !> times Student's factor.
   subroutine test_mean()
      type(surface_sums_type) :: sums(8), empty
      real(wp) :: widths(n_parameters), square(8), scatter
      integer :: i

      square = [3.0_wp, 5.0_wp, 4.0_wp, 8.0_wp, 1.0_wp, 2.5_wp, 6.0_wp, 4.5_wp]
      do i = 1, 8
         sums(i)%points = 10.0_wp
         sums(i)%inner = 9.0_wp
         sums(i)%second = 10.0_wp*square(i)
      end do
      call uncertainties(sums, 1.0_wp, widths)
      scatter = sum((square - sum(square)/8)**2)
      call assertRelativelyEqual(2.36462_wp*sqrt(scatter/56), widths(p_m0), 1.0e-5_wp, 'm0')
      ! a tile without points changes nothing
      scatter = widths(p_m0)
      call uncertainties([sums, empty], 1.0_wp, widths)
      call assertRelativelyEqual(scatter, widths(p_m0), 4.0_wp*eps, 'empty tile')
   end subroutine test_mean

   !> For a mean of tiles of unequal weight the variance is right on average: 4000 draws, the
   !> standard error of their mean variance is 1.2 %.
   subroutine test_unequal()
      real(wp), parameter :: weights(5) = [0.1_wp, 0.3_wp, 0.15_wp, 0.25_wp, 0.2_wp]
      real(wp) :: left(n_parameters, 5), whole(n_parameters), variance(n_parameters), x(5), total
      type(random_stream) :: stream
      integer :: i, j, k

      stream = random_stream(11)
      total = 0.0_wp
      do i = 1, 4000
         do j = 1, 5
            ! variance 1/weight, by twelve uniform numbers
            x(j) = 0.0_wp
            do k = 1, 12
               x(j) = x(j) + stream%uniform(-0.5_wp, 0.5_wp)/sqrt(weights(j))
            end do
         end do
         whole = sum(weights*x)
         do j = 1, 5
            left(:, j) = (sum(weights*x) - weights(j)*x(j))/(1.0_wp - weights(j))
         end do
         call jackknife(whole, left, weights, variance)
         total = total + variance(p_m0)/4000
      end do
      call assertEqual(1.0_wp, total, 0.05_wp, 'variance of the mean is 1')
   end subroutine test_unequal

   !> Directions next to 0 and to 180 deg are next to each other.
   subroutine test_direction()
      type(surface_sums_type) :: sums(4)
      real(wp) :: widths(n_parameters), turned(n_parameters), left(n_parameters, 2)
      real(wp) :: whole(n_parameters), variance(n_parameters)
      real(wp), parameter :: degree = pi/180.0_wp, off(4) = [-2.0_wp, 1.0_wp, 2.0_wp, -1.0_wp]
      integer :: i

      do i = 1, 4
         sums(i) = sums_of_lay(off(i)*degree, 0.3_wp, 1.0_wp)
      end do
      call uncertainties(sums, 1.0_wp, widths)
      do i = 1, 4
         sums(i) = sums_of_lay((off(i) + 60.0_wp)*degree, 0.3_wp, 1.0_wp)
      end do
      call uncertainties(sums, 1.0_wp, turned)
      call assertRelativelyEqual(turned(p_direction), widths(p_direction), 1.0e-9_wp, 'turned')
      ! to first order it is that of a mean of the angles
      call assertRelativelyEqual(3.18245_wp*sqrt(10.0_wp/12.0_wp), widths(p_direction), 0.01_wp, &
         'half width')
      do i = 1, 4
         sums(i) = sums_of_lay(45.0_wp*i*degree, 0.3_wp, 1.0_wp)
      end do
      call uncertainties(sums(:3), 1.0_wp, widths)
      call assertEqual(90.0_wp, widths(p_direction), 'any direction')
      ! two halves that differ from the whole by 85 and by 95 deg, which is -85: of changes +-c the
      ! variance is c^2
      left = 0.0_wp
      left(p_direction, :) = [85.0_wp, 95.0_wp]
      whole = 0.0_wp
      call jackknife(whole, left, [0.5_wp, 0.5_wp], variance)
      call assertRelativelyEqual(85.0_wp**2, variance(p_direction), 1.0e-12_wp, 'past 90 deg')
   end subroutine test_direction

   !> Four tiles alike but for their extremes: what is left is Student's factor times the standard
   !> deviation of ln sz, from the scatter of tops and of bottoms, times the slope by ln of the
   !> height of pruning.
   subroutine test_pruning()
      real(wp), parameter :: rise = 1.1_wp
      type(surface_sums_type) :: sums(4), raised(4)
      real(wp) :: widths(n_parameters), scatter
      integer :: i

      do i = 1, 4
         sums(i) = sums_of_lay(0.2_wp, 0.5_wp, 0.5_wp)
         sums(i)%highest = 5.0_wp + 0.1_wp*(i - 1)
         sums(i)%lowest = -4.0_wp - 0.2_wp*modulo(i, 2)
      end do
      sums%peaks%number = 40.0_wp
      sums%peaks%curvature = 80.0_wp
      raised = sums
      raised%peaks%number = 30.0_wp
      raised%peaks%curvature = 66.0_wp
      call uncertainties(sums, 1.0_wp, widths, raised, rise)
      ! variances of 5.0, 5.1, 5.2, 5.3 and of -4.2, -4.0, -4.2, -4.0; sz is 5.3 + 4.2
      scatter = sqrt(0.05_wp/3.0_wp + 0.04_wp/3.0_wp)/9.5_wp
      call assertRelativelyEqual(3.182446_wp*scatter*[10.0_wp, 0.2_wp]/log(rise), &
         widths([p_spd, p_spc]), 1.0e-6_wp, 'spd and spc')
      call assertEqual(0.0_wp, widths(p_sq), 1.0e-12_wp, 'no share in sq')
   end subroutine test_pruning

end module test_surface_statistics
