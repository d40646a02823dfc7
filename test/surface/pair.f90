!> Two faces as one, the gap between them, the law of one summit summed over summits, and remarks.
module test_surface_pair
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity
   use asperity_surface_generate_random_stream, only: fill_normal, new_random, random_type
   use asperity_surface_pair_equivalent_surface, only: combine_values, map_correlation, &
      pair_uncertainties, sum_of_maps
   use asperity_surface_pair_first_touch_gap, only: find_gap, gap_distribution
   use asperity_surface_pair_law_on_summits, only: sum_over_summits, summit_curve
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_eta_nayak, &
      p_eta_paper, p_m0, p_m2, p_m2_across, p_m2_along, p_m2_x, p_m2_y, p_m4, p_m4_x, p_m4_y, &
      p_radius_nayak, p_radius_paper, p_sigma_nayak, p_sigma_paper, p_sku, p_sq, p_ssk, &
      p_summit_plane
   use asperity_surface_parameters_tile_sums, only: surface_sums_type
   use asperity_surface_parameters_uncertainty, only: uncertainties
   use asperity_surface_remarks_on_analysis, only: find_remarks, map_facts, remark_type
   use extremes, only: largest_of
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_stream
   implicit none
   private
   public :: suite_surface_pair

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_surface_pair() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface pair')
      call suite%addTest(TestMethod('equivalent surface', test_equivalent))
      call suite%addTest(TestMethod('faces with crossed lays', test_crossed))
      call suite%addTest(TestMethod('a lay turned over', test_turned))
      call suite%addTest(TestMethod('its uncertainty', test_uncertainty))
      call suite%addTest(TestMethod('sum of maps', test_sum))
      call suite%addTest(TestMethod('correlation', test_correlation))
      call suite%addTest(TestMethod('gap', test_gap))
      call suite%addTest(TestMethod('gap of a flat map', test_flat))
      call suite%addTest(TestMethod('sum over Gaussian summits', test_verify))
      call suite%addTest(TestMethod('sum over summits of own radius', test_own_radius))
      call suite%addTest(TestMethod('no summits', test_no_summits))
      call suite%addTest(TestMethod('remarks', test_remarks))
   end function suite_surface_pair

   !> Sums of a face whose profiles have these moments along x and y, over some points.
   pure function face(points, m0, m2_x, m2_y, m4_x, m4_y) result(sums)
      real(wp), intent(in) :: points, m0, m2_x, m2_y, m4_x, m4_y
      type(surface_sums_type) :: sums

      sums%points = points
      sums%second = points*(m0 + 0.25_wp)
      sums%first = 0.5_wp*points
      sums%pairs_x = points - 1.0_wp
      sums%pairs_y = points - 2.0_wp
      sums%slope_x = m2_x*sums%pairs_x
      sums%slope_y = m2_y*sums%pairs_y
      sums%triples_x = points - 3.0_wp
      sums%triples_y = points - 4.0_wp
      sums%curvature_x = m4_x*sums%triples_x
      sums%curvature_y = m4_y*sums%triples_y
      sums%inner = points - 5.0_wp
      sums%gradient_xx = m2_x*sums%inner
      sums%gradient_yy = m2_y*sums%inner
      sums%hessian_xx_xx = m4_x*sums%inner
      sums%hessian_yy_yy = m4_y*sums%inner
      sums%peaks%number = 7.0_wp
   end function face

   !> Moments add; two equal faces have the alpha and the eta of one, its R over sqrt(2) and its
   !> sigma times sqrt(2).
   subroutine test_equivalent()
      type(surface_sums_type) :: one
      real(wp) :: two(n_parameters), alone(n_parameters)

      one = face(20.0_wp, 0.04_wp, 0.3_wp, 0.3_wp, 5.0_wp, 5.0_wp)
      call combine_values(one, one, 'x', two)
      call assertRelativelyEqual([0.08_wp, 0.6_wp, 10.0_wp, 0.2_wp*sqrt(2.0_wp)], &
         two([p_m0, p_m2, p_m4, p_sigma_paper]), 32.0_wp*eps, 'added')
      call parameters_of(one, 1.0_wp, alone)
      call assertRelativelyEqual([1.0_wp, 1.0_wp, sqrt(0.5_wp), sqrt(2.0_wp), sqrt(2.0_wp)], &
         two([p_alpha, p_eta_nayak, p_radius_nayak, p_sigma_nayak, p_summit_plane]) &
         /alone([p_alpha, p_eta_nayak, p_radius_nayak, p_sigma_nayak, p_summit_plane]), &
         32.0_wp*eps, 'of one')
      call assertTrue(two(p_eta_paper) >= none, 'no rule for the paper''s eta')
   end subroutine test_equivalent

   !> Two faces with crossed lays make one without: moments along x add, and so do those along y.
   subroutine test_crossed()
      real(wp) :: values(n_parameters)

      call combine_values(face(20.0_wp, 0.04_wp, 0.5_wp, 0.005_wp, 300.0_wp, 0.03_wp), &
         face(30.0_wp, 0.04_wp, 0.005_wp, 0.5_wp, 0.03_wp, 300.0_wp), 'y', values)
      call assertRelativelyEqual([0.08_wp, 0.505_wp, 300.03_wp], values([p_m0, p_m2, p_m4]), &
         32.0_wp*eps, 'crossed')
      call combine_values(face(20.0_wp, 0.04_wp, 0.5_wp, 0.005_wp, 300.0_wp, 0.03_wp), &
         face(30.0_wp, 0.04_wp, 0.5_wp, 0.005_wp, 300.0_wp, 0.03_wp), 'y', values)
      call assertRelativelyEqual([0.08_wp, 0.1_wp, 6.0_wp], values([p_m0, p_m2, p_m4]), &
         32.0_wp*eps, 'along each other')
   end subroutine test_crossed

   !> A lay at an angle is at the opposite one on the face that is turned over.
   subroutine test_turned()
      type(surface_sums_type) :: oblique
      real(wp) :: one(n_parameters), same(n_parameters), turned(n_parameters)

      oblique = face(20.0_wp, 0.04_wp, 0.3_wp, 0.3_wp, 5.0_wp, 5.0_wp)
      oblique%gradient_xy = 0.9_wp*oblique%gradient_xx
      call parameters_of(oblique, 1.0_wp, one)
      call combine_values(oblique, oblique, 'none', same)
      call assertRelativelyEqual(2.0_wp*one([p_m2_across, p_m2_along]), &
         same([p_m2_across, p_m2_along]), 64.0_wp*eps, 'as it is')
      call combine_values(oblique, oblique, 'x', turned)
      call assertRelativelyEqual([0.6_wp, 0.6_wp], turned([p_m2_across, p_m2_along]), &
         32.0_wp*eps, 'turned over')
   end subroutine test_turned

   !> For m0 variances add; beside a face without scatter the pair has the half width of the other.
   subroutine test_uncertainty()
      type(surface_sums_type) :: a(5), b(5), same(5)
      real(wp) :: widths(n_parameters), one(n_parameters)
      integer :: i

      do i = 1, 5
         a(i)%points = 4.0_wp
         a(i)%inner = 4.0_wp
         a(i)%second = real(i*i, wp)
         b(i) = a(i)
         b(i)%second = real(modulo(7*i, 5), wp)
         same(i) = a(i)
         same(i)%second = 3.0_wp
      end do
      call uncertainties(a, 1.0_wp, one)
      call pair_uncertainties(a, same, 'x', widths)
      call assertRelativelyEqual(one(p_m0), widths(p_m0), 1.0e-12_wp, 'one scatters')
      call pair_uncertainties(a, a, 'x', widths)
      ! eight degrees of freedom against four
      call assertRelativelyEqual(one(p_m0)*sqrt(2.0_wp)*2.30600_wp/2.77645_wp, widths(p_m0), &
         1.0e-5_wp, 'both scatter')
      call pair_uncertainties(a(:1), b, 'x', widths)
      call assertTrue(all(widths >= none), 'one tile')
   end subroutine test_uncertainty

   pure function map_of(heights, step) result(map)
      real(wp), intent(in) :: heights(:, :), step
      type(height_map) :: map

      allocate (map%heights, source=heights)
      map%step_x = step
      map%step_y = 2.0_wp*step
      map%source = 'test'
   end function map_of

   subroutine test_sum()
      type(height_map) :: a, b, c
      type(error_type), allocatable :: error
      real(wp) :: z(6, 5), w(6, 5)
      integer :: i, j

      do j = 1, 5
         do i = 1, 6
            z(i, j) = sin(real(i + 7*j, wp))
            w(i, j) = cos(real(3*i + j*j, wp))
         end do
      end do
      w(2, 3) = none
      a = map_of(z, 0.1_wp)
      b = map_of(w, 0.1_wp)
      call sum_of_maps(a, b, 'none', c, error)
      call assertTrue(c%heights(2, 3) >= none, 'missing')
      c%heights(2, 3) = 0.0_wp
      z(2, 3) = 0.0_wp
      w(2, 3) = 0.0_wp
      call assertEqual(pack(z + w, .true.), pack(c%heights, .true.), 0.0_wp, 'none')
      a = map_of(z, 0.1_wp)
      b = map_of(w, 0.1_wp)
      call sum_of_maps(a, b, 'x', c, error)
      call assertEqual(pack(z + w(6:1:-1, :), .true.), pack(c%heights, .true.), 0.0_wp, 'x')
      call sum_of_maps(a, b, 'y', c, error)
      call assertEqual(pack(z + w(:, 5:1:-1), .true.), pack(c%heights, .true.), 0.0_wp, 'y')
      call assertFalse(allocated(error), 'no error')
      call sum_of_maps(a, b, 'z', c, error)
      call assertTrue(allocated(error), 'mirror')
      call sum_of_maps(a, map_of(w(:5, :), 0.1_wp), 'x', c, error)
      call assertTrue(allocated(error), 'points')
      call sum_of_maps(a, map_of(w, 0.1001_wp), 'x', c, error)
      call assertTrue(allocated(error), 'steps')
   end subroutine test_sum

   subroutine test_correlation()
      type(height_map) :: a, b
      type(error_type), allocatable :: error
      real(wp) :: z(20, 20), r
      integer :: i, j

      do j = 1, 20
         do i = 1, 20
            z(i, j) = sin(real(i, wp)*j) + 5.0_wp
         end do
      end do
      a = map_of(z, 0.1_wp)
      b = map_of(-3.0_wp*z(20:1:-1, :), 0.1_wp)
      call map_correlation(a, b, 'x', r, error)
      call assertRelativelyEqual(-1.0_wp, r, 1.0e-12_wp, 'mirrored')
      b = map_of(0.5_wp*z(:, 20:1:-1) + 7.0_wp, 0.1_wp)
      call map_correlation(a, b, 'y', r, error)
      call assertRelativelyEqual(1.0_wp, r, 1.0e-12_wp, 'mirrored in y')
      call map_correlation(a, b, 'none', r, error)
      associate (p => z - sum(z)/size(z), q => z(:, 20:1:-1) - sum(z)/size(z))
         call assertEqual(sum(p*q)/sum(p*p), r, 1.0e-12_wp, 'not mirrored')
      end associate
      b%heights = 1.0_wp
      call map_correlation(a, b, 'x', r, error)
      call assertEqual(0.0_wp, r, 1.0e-9_wp, 'flat')
   end subroutine test_correlation

   !> Heights -i^2 for i = 1 to 10000: quantiles are squares, to a bin of 1e8/65536.
   subroutine test_gap()
      real(wp), parameter :: shares(5) = [0.0_wp, 0.1_wp, 0.5_wp, 0.9_wp, 1.0_wp]
      real(wp) :: z(100, 100)
      type(gap_distribution) :: gap
      type(error_type), allocatable :: error
      integer :: i

      z = reshape([(-real(i, wp)**2, i=1, 10000)], [100, 100])
      call find_gap(map_of(z, 1.0_wp), shares, gap, error)
      call assertEqual((shares*1.0e4_wp)**2, gap%quantiles, 1.0e8_wp/65536, 'quantiles')
      call assertRelativelyEqual([-sum(z)/1.0e4_wp - 1.0_wp, 1.0e8_wp - 1.0_wp], &
         [gap%mean, gap%largest], 1.0e-12_wp, 'mean and largest')
      call assertRelativelyEqual(sqrt(sum((z - sum(z)/1.0e4_wp)**2)/1.0e4_wp), gap%sigma, &
         1.0e-12_wp, 'sigma')
      call assertRelativelyEqual(1.0_wp, sum(gap%density)*gap%ends(1), 1.0e-12_wp, 'density')
      z(1:50, :) = none
      call find_gap(map_of(z, 1.0_wp), [0.5_wp], gap, error)
      ! what is left are 51 to 100, 151 to 200 ... 9951 to 10000
      call assertRelativelyEqual(1.0e8_wp - 51.0_wp**2, gap%largest, 1.0e-12_wp, 'missing points')
      z = none
      call find_gap(map_of(z, 1.0_wp), [0.5_wp], gap, error)
      call assertTrue(allocated(error), 'all missing')
      z = 0.0_wp
      call find_gap(map_of(z, 1.0_wp), [1.5_wp], gap, error)
      call assertTrue(allocated(error), 'share')
      call find_gap(map_of(z, 1.0_wp), [0.5_wp, ieee_value(1.0_wp, ieee_quiet_nan)], gap, error)
      call assertTrue(allocated(error), 'a share that is no number')
   end subroutine test_gap

   subroutine test_flat()
      real(wp) :: z(10, 10)
      type(gap_distribution) :: gap
      type(error_type), allocatable :: error

      z = 3.0_wp
      call find_gap(map_of(z, 1.0_wp), [0.0_wp, 0.5_wp, 1.0_wp], gap, error)
      call assertEqual(0.0_wp, [gap%mean, gap%sigma, gap%largest, gap%quantiles], 'no gap')
   end subroutine test_flat

   !> Over 40000 summits with Gaussian heights the sum is the Gaussian law within 4 of its own
   !> standard errors, which shrink as they should: at the mean plane to 1 %.
   subroutine test_verify()
      integer, parameter :: n = 40000
      real(wp), parameter :: d(6) = [-2.0_wp, -1.0_wp, 0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp]
      type(normal_properties) :: p
      type(random_type) :: stream
      type(summit_curve) :: curve
      type(error_type), allocatable :: error
      real(wp), allocatable :: z(:), curvatures(:)
      real(wp) :: worst

      p = normal_of_pair('transverse-tangential')
      allocate (z(n), curvatures(n))
      call new_random(stream, 5)
      call fill_normal(stream, z)
      curvatures = 1.0_wp/p%radius
      call sum_over_summits(p, p%sigma*z, curvatures, n/p%eta, p%sigma*d, curve, error)
      worst = largest_of((curve%mean_radius - curve%gaussian)/curve%mean_radius_error)
      call record('surface.verify.standard_errors', worst)
      call assertLessThan(worst, 4.0_wp, 'pressure')
      call assertLessThan(curve%mean_radius_error(3)/curve%gaussian(3), 0.01_wp, 'standard error')
      call assertRelativelyEqual(curve%mean_radius, curve%own_radius, 1.0e-12_wp, 'equal radii')
      call assertLessThan(largest_of((curve%contact_density/curve%gaussian_density - 1.0_wp) &
         *sqrt(curve%gaussian_density/p%eta*n)), 4.0_wp, 'contact density')
      call assertEqual(0, curve%without_radius, 'all have a radius')
   end subroutine test_verify

   !> Against properties of its own for each summit, at all stages; a summit without curvature
   !> takes the mean radius and is counted. Standard errors are roots of sums of squares.
   subroutine test_own_radius()
      real(wp), parameter :: curvatures(5) = [20.0_wp, 3.0_wp, 0.2_wp, 0.0_wp, -1.0_wp]
      type(normal_properties) :: p, own
      type(asperity_response) :: summit
      type(summit_curve) :: curve
      type(error_type), allocatable :: error
      real(wp) :: expected(2), squares(2), radius, z(5), d(4)
      integer :: i, j

      p = normal_of_pair('transverse-tangential')
      z = p%sigma*[0.3_wp, -0.5_wp, 1.2_wp, 0.9_wp, 0.1_wp]
      ! elastic, elasto-plastic and plastic summits
      d = [z(1) - 0.5_wp*p%w1, z(1) - 5.0_wp*p%w1, z(1) - 200.0_wp*p%w1, 2.0_wp*p%sigma]
      call sum_over_summits(p, z, curvatures, 2.0_wp, d, curve, error)
      call assertFalse(allocated(error), 'no error')
      call assertEqual(2, curve%without_radius, 'without radius')
      do j = 1, 4
         expected = 0.0_wp
         squares = 0.0_wp
         do i = 1, 5
            radius = p%radius
            if (curvatures(i) > 0.0_wp) radius = 1.0_wp/curvatures(i)
            call new_normal_properties(own, p%eta, p%modulus, radius, p%hardness, &
               p%yield_factor, p%sigma, error, accept_unphysical=.true.)
            summit = evaluate_asperity(own, z(i) - d(j))
            expected(1) = expected(1) + 0.5_wp*summit%force
            squares(1) = squares(1) + (0.5_wp*summit%force)**2
            summit = evaluate_asperity(p, z(i) - d(j))
            expected(2) = expected(2) + 0.5_wp*summit%force
            squares(2) = squares(2) + (0.5_wp*summit%force)**2
         end do
         if (j < 4) then
            call assertRelativelyEqual(expected, [curve%own_radius(j), curve%mean_radius(j)], &
               1.0e-12_wp, 'pressures')
            call assertRelativelyEqual(sqrt(squares), [curve%own_radius_error(j), &
               curve%mean_radius_error(j)], 1.0e-12_wp, 'standard errors')
         else
            call assertEqual([0.0_wp, 0.0_wp], [curve%own_radius(j), curve%mean_radius(j)], 'open')
         end if
      end do
   end subroutine test_own_radius

   subroutine test_no_summits()
      type(summit_curve) :: curve
      type(error_type), allocatable :: error
      real(wp) :: none(0)

      call sum_over_summits(normal_of_pair('transverse-tangential'), none, none, 1.0_wp, [0.0_wp], &
         curve, error)
      call assertTrue(allocated(error), 'no summits')
   end subroutine test_no_summits

   !> Each remark is made where it should be, and none on an ordinary surface.
   subroutine test_remarks()
      real(wp) :: values(n_parameters), widths(n_parameters), coarse(n_parameters)
      type(map_facts) :: facts

      call ordinary(values, widths, facts)
      call expect('', values, widths, facts)
      facts%peaks = 12.0_wp
      call expect('few_peaks', values, widths, facts)
      facts%peaks = 0.0_wp
      call expect('no_peaks', values, widths, facts)
      call ordinary(values, widths, facts)
      values(p_eta_paper) = 2.0_wp*values(p_eta_nayak)
      call expect('routes', values, widths, facts)
      widths(p_eta_paper) = 1.2_wp*values(p_eta_nayak)
      call expect('', values, widths, facts)
      call ordinary(values, widths, facts)
      values(p_alpha) = 1.4_wp
      call expect('alpha', values, widths, facts)
      call ordinary(values, widths, facts)
      values(p_m2_along) = 0.1_wp*values(p_m2_across)
      call expect('anisotropic', values, widths, facts)
      call ordinary(values, widths, facts)
      values(p_sigma_nayak) = 0.9_wp*values(p_sigma_nayak)
      values(p_sigma_paper) = values(p_sigma_nayak)
      values([p_eta_nayak, p_eta_paper]) = 0.9_wp*values(p_eta_nayak)
      call expect('', values, widths, facts)
      call expect('roughness_number', values, widths, facts, route='paper')
      call ordinary(values, widths, facts)
      facts%tile_x = 2.0_wp
      call expect('few_waves', values, widths, facts)
      call ordinary(values, widths, facts)
      facts%step_y = 0.5_wp
      call expect('resolution', values, widths, facts)
      call ordinary(values, widths, facts)
      coarse = values
      call expect('', values, widths, facts, coarse)
      coarse(p_eta_nayak) = 1.2_wp*values(p_eta_nayak)
      call expect('step', values, widths, facts, coarse)
      ! nothing known is nothing to remark on but the peaks
      values = none
      widths = none
      facts%peaks = 0.0_wp
      call expect('no_peaks', values, widths, facts, values)
   end subroutine test_remarks

   !> A Gaussian surface of m0 = m2/2 = m4/12 = 1 whose routes agree.
   subroutine ordinary(values, widths, facts)
      real(wp), intent(out) :: values(n_parameters), widths(n_parameters)
      type(map_facts), intent(out) :: facts
      type(surface_sums_type) :: sums

      sums%points = 1.0_wp
      sums%second = 1.0_wp
      sums%fourth = 3.0_wp
      sums%pairs_x = 1.0_wp
      sums%pairs_y = 1.0_wp
      sums%triples_x = 1.0_wp
      sums%triples_y = 1.0_wp
      sums%inner = 1.0_wp
      sums%slope_x = 2.0_wp
      sums%slope_y = 2.0_wp
      sums%gradient_xx = 2.0_wp
      sums%gradient_yy = 2.0_wp
      sums%curvature_x = 12.0_wp
      sums%curvature_y = 12.0_wp
      sums%hessian_xx_xx = 12.0_wp
      sums%hessian_yy_yy = 12.0_wp
      sums%hessian_xx_yy = 4.0_wp
      sums%hessian_xy_xy = 4.0_wp
      call parameters_of(sums, 1.0_wp, values)
      values(p_eta_paper) = values(p_eta_nayak)
      values(p_radius_paper) = values(p_radius_nayak)
      values(p_sigma_paper) = values(p_sigma_nayak)
      widths = 0.05_wp*values
      where (values >= none) widths = none
      widths([p_ssk, p_sku]) = 0.1_wp
      facts = map_facts(step_x=0.1_wp, step_y=0.1_wp, tile_x=9.0_wp, tile_y=9.0_wp, &
         peaks=100.0_wp)
   end subroutine ordinary

   !> The one remark there should be, or none; each ends as a sentence does.
   subroutine expect(code, values, widths, facts, coarse, route)
      character(len=*), intent(in) :: code
      real(wp), intent(in) :: values(:), widths(:)
      type(map_facts), intent(in) :: facts
      real(wp), intent(in), optional :: coarse(:)
      !> nayak if absent
      character(len=*), intent(in), optional :: route
      type(remark_type), allocatable :: remarks(:)
      integer :: i

      if (present(route)) then
         call find_remarks(values, widths, facts, route, remarks, coarse)
      else
         call find_remarks(values, widths, facts, 'nayak', remarks, coarse)
      end if
      call assertEqual(merge(1, 0, len(code) > 0), size(remarks), code//': number of remarks')
      do i = 1, size(remarks)
         call assertEqual(code, trim(remarks(i)%code), remarks(i)%text)
         call assertTrue(index(remarks(i)%text, '.', back=.true.) == len(remarks(i)%text), &
            remarks(i)%text)
         call assertEqual(0, index(remarks(i)%text, '1.79'), 'no stand-ins: '//remarks(i)%text)
      end do
   end subroutine expect

end module test_surface_pair
