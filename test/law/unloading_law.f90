!> Identities of the law with memory on random faces, over its whole range: it meets the virgin
!> branch, its stiffness and pressure are slopes, it never rises, and nothing breaks far out.
module test_law_unloading_law
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: ieee_exceptions, only: ieee_divide_by_zero, ieee_get_flag, ieee_invalid, &
      ieee_overflow, ieee_set_flag
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_branch, evaluate_unloading_law, &
      unloading_stiffness
   use asperity_law_unloading_summit, only: elastic_recovery
   use asperity_law_validity, only: closure_above_half_radius, memory_beyond_data, valid
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, properties_with, random_properties, random_stream
   implicit none
   private
   public :: suite_unloading_law, random_unloading

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_unloading_law() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('unloading law')
      call suite%addTest(TestMethod('meets the virgin branch', test_continuity))
      call suite%addTest(TestMethod('virgin branch', test_virgin))
      call suite%addTest(TestMethod('stiffness and pressure are slopes', test_slopes))
      call suite%addTest(TestMethod('never rises, never above the virgin branch', test_monotone))
      call suite%addTest(TestMethod('elastic summits have no memory', test_elastic))
      call suite%addTest(TestMethod('three times stiffer', test_stiffer))
      call suite%addTest(TestMethod('finite, without exceptions', test_exceptions))
      call suite%addTest(TestMethod('zero where it underflows', test_far_away))
      call suite%addTest(TestMethod('memory beyond data', test_flags))
   end function suite_unloading_law

   !> A random face, closest separation, and retraction at which the pressure is 1e-12 to 1 of that
   !> there: every other one uniform in the logarithm of either.
   subroutine random_unloading(stream, i, p, d, u)
      type(random_stream), intent(inout) :: stream
      !> Number of the case
      integer, intent(in) :: i
      type(normal_properties), intent(out) :: p
      !> Closest separation and retraction, mm
      real(wp), intent(out) :: d, u
      type(normal_response) :: r

      call random_properties(stream, p, 1.0e-6_wp, 1.0e2_wp, 0.1908_wp)
      d = p%sigma*stream%uniform(-8.0_wp, 8.0_wp)
      r = evaluate_normal_law(p, d)
      if (mod(i, 2) == 0) then
         u = retraction_for_pressure(p, d, r%pressure*stream%log_uniform(1.0e-12_wp, 1.0_wp))
      else
         u = stream%log_uniform(1.0e-8_wp, 1.0_wp) &
            *retraction_for_pressure(p, d, 1.0e-12_wp*r%pressure)
      end if
   end subroutine random_unloading

   !> Both branches at the closest separation, by different quadratures; also where the face is
   !> pressed flat. There deformations are rounded to eps |d|, over which the density changes by up
   !> to 9.5 times as much in sigma, in either.
   subroutine test_continuity()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: virgin, r
      real(wp) :: d, u, difference, worst
      integer :: i

      stream = random_stream(71)
      worst = 0.0_wp
      do i = 1, 3000
         call random_unloading(stream, i, p, d, u)
         if (mod(i, 3) == 0) d = 5.0_wp*min(d, 0.0_wp)
         virgin = evaluate_unloading_law(p, d, 0.0_wp)
         call evaluate_unloading_branch(p, d, 0.0_wp, r)
         difference = largest_of([r%pressure/virgin%pressure, r%area_fraction &
            /virgin%area_fraction, r%contact_density/virgin%contact_density, &
            r%energy/virgin%energy] - 1.0_wp)
         call worsen(worst, difference)
         call assertLessThan(difference, 1.0e-13_wp + 19.0_wp*eps*abs(d)/p%sigma, 'difference')
         call assertLessThanOrEqual((1.0_wp - 1.0e-12_wp)*virgin%stiffness, r%stiffness, 'stiffer')
         call assertEqual(r%stiffness, unloading_stiffness(p, d), 0.0_wp, 'its own name')
         call assertEqual(virgin%validity, r%validity, 'validity')
      end do
      call record('unloading_law.continuity', worst)
   end subroutine test_continuity

   !> Today's law; its work is what is recoverable and what is not.
   subroutine test_virgin()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: plain, r
      real(wp) :: d, u, worst
      integer :: i

      stream = random_stream(72)
      worst = 0.0_wp
      do i = 1, 3000
         call random_unloading(stream, i, p, d, u)
         plain = evaluate_normal_law(p, d)
         r = evaluate_unloading_law(p, d + u, -u)
         call assertRelativelyEqual(plain%pressure, r%pressure, &
            1.0e-12_wp + 100.0_wp*eps*(abs(d) + u)/p%sigma, 'rounded separation')
         r = evaluate_unloading_law(p, d, 0.0_wp)
         call assertEqual([plain%pressure, plain%stiffness, plain%area_fraction, &
            plain%contact_density, plain%elastic_share, plain%elastoplastic_share, &
            plain%plastic_share], [r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%elastic_share, r%elastoplastic_share, r%plastic_share], 0.0_wp, 'the same')
         call worsen(worst, abs((r%energy + r%plastic_dissipation)/plain%energy - 1.0_wp))
      end do
      call record('unloading_law.work_error', worst)
      call assertLessThan(worst, 1.0e-13_wp, 'work = recoverable + dissipated')
   end subroutine test_virgin

   !> stiffness = -dp/du and pressure = -d(energy)/du by the five-point rule. The step is 5e-4 of
   !> the length over which the pressure changes, on which the rule errs by 1e-12; round-off of
   !> 1e-13 over the step adds 2e-10. Steps across the retractions where the last elastic or the
   !> last elasto-plastic summit loses contact are left out: there the third derivative is infinite.
   subroutine test_slopes()
      real(wp), parameter :: rule(4) = [1.0_wp, -8.0_wp, 8.0_wp, -1.0_wp]/12.0_wp
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r, near(4)
      real(wp) :: d, u, step, edges(2), worst(2)
      integer :: i, tried

      stream = random_stream(73)
      worst = 0.0_wp
      tried = 0
      do i = 1, 3000
         call random_unloading(stream, i, p, d, u)
         r = evaluate_unloading_law(p, d, u)
         step = 5.0e-4_wp*r%pressure/r%stiffness
         if (.not. u > 2.0_wp*step) cycle
         edges = [p%w1, elastic_recovery(p, p%w2)]
         if (any(abs(u - edges) < 20.0_wp*step)) cycle
         tried = tried + 1
         near = evaluate_unloading_law(p, d, [u - 2.0_wp*step, u - step, u + step, &
            u + 2.0_wp*step])
         call worsen(worst(1), abs(-sum(rule*near%pressure)/step/r%stiffness - 1.0_wp))
         call worsen(worst(2), abs(-sum(rule*near%energy)/step/r%pressure - 1.0_wp))
      end do
      call assertGreaterThan(tried, 2000, message='cases')
      call record('unloading_law.stiffness.difference_error', worst(1))
      call record('unloading_law.energy.difference_error', worst(2))
      call assertLessThan(worst(1), 1.0e-9_wp, 'stiffness')
      call assertLessThan(worst(2), 1.0e-9_wp, 'energy')
   end subroutine test_slopes

   !> Steps above round-off's size, 1e-12 of the retraction or of the length over which the pressure
   !> changes; the virgin branch lies higher, but for the round-off of both.
   subroutine test_monotone()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r, further, virgin
      real(wp) :: d, u, step
      integer :: i, n_rising, n_above

      stream = random_stream(74)
      n_rising = 0
      n_above = 0
      do i = 1, 10000
         call random_unloading(stream, i, p, d, u)
         r = evaluate_unloading_law(p, d, u)
         step = max(u, r%pressure/r%stiffness)*stream%log_uniform(1.0e-12_wp, 10.0_wp)
         further = evaluate_unloading_law(p, d, u + step)
         if (.not. further%pressure <= r%pressure) n_rising = n_rising + 1
         if (.not. further%area_fraction <= r%area_fraction) n_rising = n_rising + 1
         virgin = evaluate_normal_law(p, d + u)
         if (.not. r%pressure <= virgin%pressure*(1.0_wp + 1.0e-12_wp)) n_above = n_above + 1
         call assertLessThan(abs(r%elastic_share + r%elastoplastic_share + r%plastic_share &
            - 1.0_wp), 3.0_wp*eps, 'shares')
      end do
      call assertEqual(0, n_rising, 'rising pressures or areas')
      call assertEqual(0, n_above, 'above the virgin branch')
   end subroutine test_monotone

   !> w1 = 100 sigma: all summits are elastic, and the law is that without memory; the elastic
   !> share of others is its elastic piece up to w1 - u, checked by the tables.
   subroutine test_elastic()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: plain, r
      real(wp) :: d, u
      integer :: i

      stream = random_stream(75)
      p = properties_with(100.0_wp, 0.4_wp)
      do i = 1, 300
         d = p%sigma*stream%uniform(-8.0_wp, 8.0_wp)
         u = p%sigma*stream%log_uniform(1.0e-6_wp, 8.0_wp)
         plain = evaluate_normal_law(p, d + u)
         r = evaluate_unloading_law(p, d, u)
         call assertRelativelyEqual([plain%pressure, plain%stiffness, plain%area_fraction, &
            plain%contact_density, plain%energy], [r%pressure, r%stiffness, r%area_fraction, &
            r%contact_density, r%energy], 1.0e-12_wp, 'without memory')
         call assertLessThanOrEqual(r%plastic_dissipation, tiny(1.0_wp), 'nothing lost')
         call assertEqual(1.0_wp, r%elastic_share, 1.0e-15_wp, 'elastic')
      end do
   end subroutine test_elastic

   !> For the first pair near zero separation.
   subroutine test_stiffer()
      type(normal_properties) :: p
      type(normal_response) :: virgin

      p = normal_of_pair('transverse-tangential')
      virgin = evaluate_normal_law(p, 0.0_wp)
      call assertEqual(3.0_wp, unloading_stiffness(p, 0.0_wp)/virgin%stiffness, 0.5_wp, 'ratio')
   end subroutine test_stiffer

   !> No NaN, no infinity, nothing negative and no flag, at any separation and retraction; underflow
   !> is expected.
   subroutine test_exceptions()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: top, u
      logical :: raised(3)
      integer :: i

      stream = random_stream(76)
      call ieee_set_flag([ieee_invalid, ieee_overflow, ieee_divide_by_zero], .false.)
      do i = 1, 20000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.1908_wp)
         top = merge(1.0e6_wp, 45.0_wp, mod(i, 2) == 0)
         u = p%sigma*exp(stream%uniform(-680.0_wp, merge(680.0_wp, 5.0_wp, mod(i, 4) == 0)))
         r = evaluate_unloading_law(p, p%sigma*stream%uniform(-top, top), u)
         call assertTrue(all(ieee_is_finite([r%pressure, r%stiffness, r%area_fraction, &
            r%contact_density, r%energy, r%plastic_dissipation, r%elastic_share, &
            r%elastoplastic_share, r%plastic_share])), 'all finite')
         call assertTrue(all([r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy, r%plastic_dissipation] >= 0.0_wp), 'none negative')
         if (anyExceptions()) exit
      end do
      call ieee_get_flag([ieee_invalid, ieee_overflow, ieee_divide_by_zero], raised)
      call assertFalse(raised, 'invalid, overflow, divide by zero')
   end subroutine test_exceptions

   !> Where no summit touches all is zero, and no flag is raised.
   subroutine test_far_away()
      real(wp), parameter :: h(4) = [45.0_wp, 1.0e3_wp, 1.0e6_wp, 1.0e100_wp]
      type(normal_properties) :: p
      type(normal_response) :: r
      integer :: i

      p = properties_with(1.0e-6_wp, 0.4_wp)
      do i = 1, size(h)
         r = evaluate_unloading_law(p, h(i)*p%sigma, 0.1_wp*p%sigma)
         call assertEqual(0.0_wp, [r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy, r%plastic_dissipation])
         call assertEqual(valid, r%validity)
         r = evaluate_unloading_law(p, 0.0_wp, h(i)*p%sigma)
         call assertEqual(0.0_wp, [r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy])
      end do
   end subroutine test_far_away

   !> Mean deformation of the summits in contact, sigma F_1/F_0 at the closest separation, above
   !> 170 w1: the separation is found by bisection; the retraction plays no part.
   subroutine test_flags()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: near, far, d, moments(0:2)
      integer :: i

      p = normal_of_pair('transverse-tangential')
      near = -10.0_wp*p%sigma
      far = 10.0_wp*p%sigma
      do i = 1, 60
         d = 0.5_wp*(near + far)
         call find_tail_moments(d/p%sigma, moments)
         if (p%sigma*moments(1)/moments(0) > 170.0_wp*p%w1) then
            near = d
         else
            far = d
         end if
      end do
      do i = -1, 1, 2
         r = evaluate_unloading_law(p, d + i*1.0e-9_wp*p%sigma, 0.0_wp)
         call assertTrue((iand(r%validity, memory_beyond_data) /= 0) .eqv. i < 0, 'virgin')
         r = evaluate_unloading_law(p, d + i*1.0e-9_wp*p%sigma, p%sigma)
         call assertTrue((iand(r%validity, memory_beyond_data) /= 0) .eqv. i < 0, 'unloading')
      end do
      r = evaluate_unloading_law(p, -3.0_wp*p%sigma, 20.0_wp*p%sigma)
      call assertEqual(memory_beyond_data + closure_above_half_radius, r%validity, 'remembered')
   end subroutine test_flags

end module test_law_unloading_law
