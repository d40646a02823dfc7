!> Identities of the normal law on random inputs, its limits, and what the reference states.
module test_law_normal_law
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use, intrinsic :: ieee_exceptions, only: ieee_divide_by_zero, ieee_get_flag, ieee_invalid, &
      ieee_overflow, ieee_set_flag
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_law_validity, only: valid
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, properties_with, random_properties, random_stream
   implicit none
   private
   public :: suite_normal_law

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_normal_law() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('normal law')
      call suite%addTest(TestMethod('stiffness and pressure are slopes', test_slopes))
      call suite%addTest(TestMethod('shares sum to one', test_shares))
      call suite%addTest(TestMethod('never rises with separation', test_monotone))
      call suite%addTest(TestMethod('zero where it underflows', test_far_away))
      call suite%addTest(TestMethod('pressed flat', test_pressed_flat))
      call suite%addTest(TestMethod('finite, without exceptions', test_exceptions))
      call suite%addTest(TestMethod('scaling invariance', test_scaling))
      call suite%addTest(TestMethod('one factor on modulus and hardness', test_one_factor))
      call suite%addTest(TestMethod('separations of the reference', test_known_separations))
      call suite%addTest(TestMethod('limits of the paper''s pairs', test_known_limits))
   end function suite_normal_law

   !> stiffness = -dp/dd and pressure = -d(energy)/dd by the five-point rule. With steps of 2e-3
   !> sigma, 2e-3 sigma/h far away, it errs by step^4 = 2e-11 at most; the round-off of p, up to
   !> 1e-13, over the step adds 5e-11.
   subroutine test_slopes()
      integer, parameter :: n_cases = 2000
      real(wp), parameter :: rule(4) = [1.0_wp, -8.0_wp, 8.0_wp, -1.0_wp]/12.0_wp
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r, near(4)
      real(wp) :: h, d, step, worst_stiffness, worst_energy
      integer :: i

      stream = random_stream(21)
      worst_stiffness = 0.0_wp
      worst_energy = 0.0_wp
      do i = 1, n_cases
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         h = stream%uniform(-40.0_wp, 36.0_wp)
         d = h*p%sigma
         step = (d + 2.0e-3_wp*p%sigma/max(1.0_wp, h)) - d
         r = evaluate_normal_law(p, d)
         near = evaluate_normal_law(p, [d - 2.0_wp*step, d - step, d + step, d + 2.0_wp*step])
         if (r%energy < 1.0e10_wp*tiny(1.0_wp)) cycle
         call worsen(worst_stiffness, &
            abs(-sum(rule*near%pressure)/step/r%stiffness - 1.0_wp))
         call worsen(worst_energy, abs(-sum(rule*near%energy)/step/r%pressure - 1.0_wp))
      end do
      call record('normal_law.stiffness.difference_error', worst_stiffness)
      call record('normal_law.energy.difference_error', worst_energy)
      call assertLessThan(worst_stiffness, 1.0e-9_wp, 'stiffness')
      call assertLessThan(worst_energy, 1.0e-9_wp, 'energy')
   end subroutine test_slopes

   subroutine test_shares()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: worst
      integer :: i

      stream = random_stream(22)
      worst = 0.0_wp
      do i = 1, 5000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         r = evaluate_normal_law(p, p%sigma*stream%uniform(-50.0_wp, 50.0_wp))
         call assertTrue(min(r%elastic_share, r%elastoplastic_share, r%plastic_share) >= 0.0_wp)
         call worsen(worst, &
            abs(r%elastic_share + r%elastoplastic_share + r%plastic_share - 1.0_wp))
      end do
      call record('normal_law.shares.sum_error', worst)
      call assertLessThanOrEqual(worst, 3.0_wp*eps, 'sum of shares')
   end subroutine test_shares

   !> Two separations at least 64 eps max(sigma, |d|) apart: above the round-off of a pressure, and
   !> every larger step too, to 1000 sigma.
   subroutine test_monotone()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r(2)
      real(wp) :: d, unit
      integer :: i, n_bad

      stream = random_stream(23)
      n_bad = 0
      do i = 1, 20000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         d = p%sigma*stream%uniform(-40.0_wp, 40.0_wp)
         unit = max(p%sigma, abs(d))
         r = evaluate_normal_law(p, [d, d + unit*stream%log_uniform(64.0_wp*eps, 1.0e3_wp)])
         if (.not. r(2)%pressure <= r(1)%pressure) n_bad = n_bad + 1
      end do
      call assertEqual(0, n_bad, 'pairs with a rising pressure')
   end subroutine test_monotone

   !> phi(45) = 1e-440: everything is zero, and the shares go to their limit like exp(-h w1/sigma).
   subroutine test_far_away()
      real(wp), parameter :: h(4) = [45.0_wp, 1.0e3_wp, 1.0e6_wp, 1.0e100_wp]
      type(normal_response) :: r
      integer :: i

      do i = 1, size(h)
         r = evaluate_normal_law(properties_with(0.1_wp, 0.4_wp), h(i)*0.0593_wp)
         call assertEqual(0.0_wp, [r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy])
         call assertEqual(1.0_wp, r%elastic_share + r%elastoplastic_share + r%plastic_share, eps)
         call assertEqual(valid, r%validity)
         if (i == 1) cycle
         call assertEqual([1.0_wp, 0.0_wp, 0.0_wp], &
            [r%elastic_share, r%elastoplastic_share, r%plastic_share], 1.0e-15_wp, 'shares')
      end do
   end subroutine test_far_away

   !> All summits plastic, h = -1e6: p = 2 pi eta R H |d|, by F_1 -> |h|; density eta.
   subroutine test_pressed_flat()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: d

      p = normal_of_pair('transverse-tangential')
      d = -1.0e6_wp*p%sigma
      r = evaluate_normal_law(p, d)
      call assertRelativelyEqual(-2.0_wp*pi*p%eta*p%radius*p%hardness*d, r%pressure, 1.0e-14_wp)
      call assertRelativelyEqual(2.0_wp*pi*p%eta*p%radius*p%hardness, r%stiffness, 1.0e-14_wp)
      call assertRelativelyEqual(-2.0_wp*pi*p%eta*p%radius*d, r%area_fraction, 1.0e-14_wp)
      call assertRelativelyEqual(p%eta, r%contact_density, 1.0e-14_wp)
      call assertEqual(1.0_wp, r%plastic_share, 1.0e-15_wp)
   end subroutine test_pressed_flat

   !> No NaN, no infinity and no flag for h from -1e6 to 1e6; underflow is expected.
   subroutine test_exceptions()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: h, top
      logical :: invalid, overflow, by_zero
      integer :: i

      stream = random_stream(24)
      call ieee_set_flag([ieee_invalid, ieee_overflow, ieee_divide_by_zero], .false.)
      do i = 1, 20000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         top = merge(1.0e6_wp, 60.0_wp, mod(i, 2) == 0)
         h = stream%uniform(-top, top)
         r = evaluate_normal_law(p, h*p%sigma)
         call assertTrue(all(ieee_is_finite([r%pressure, r%stiffness, r%area_fraction, &
            r%contact_density, r%energy, r%elastic_share, r%elastoplastic_share, &
            r%plastic_share])), 'all finite')
         call assertTrue(all([r%pressure, r%stiffness, r%area_fraction, r%contact_density, &
            r%energy] >= 0.0_wp), 'none negative')
         if (anyExceptions()) exit
      end do
      call ieee_get_flag(ieee_invalid, invalid)
      call ieee_get_flag(ieee_overflow, overflow)
      call ieee_get_flag(ieee_divide_by_zero, by_zero)
      call assertFalse([invalid, overflow, by_zero], 'invalid, overflow, divide by zero')
   end subroutine test_exceptions

   !> sigma, R, d times s and eta by s^2 leave p(h), area and shares, divide stiffness by s and
   !> multiply energy by s; exactly so for a power of two.
   subroutine test_scaling()
      type(random_stream) :: stream
      type(normal_properties) :: p, q
      type(normal_response) :: a, b
      type(error_type), allocatable :: error
      real(wp) :: s, d
      integer :: i

      stream = random_stream(25)
      do i = 1, 500
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         s = 2.0_wp**nint(stream%uniform(-20.0_wp, 20.0_wp))
         d = p%sigma*stream%uniform(-20.0_wp, 20.0_wp)
         call new_normal_properties(q, p%eta/s**2, p%modulus, s*p%radius, p%hardness, &
            p%yield_factor, s*p%sigma, error, accept_unphysical=.true.)
         a = evaluate_normal_law(p, d)
         b = evaluate_normal_law(q, s*d)
         call assertRelativelyEqual([a%pressure, a%stiffness, a%area_fraction, a%energy], &
            [b%pressure, s*b%stiffness, b%area_fraction, b%energy/s], 1.0e-14_wp, 'scaled law')
         call assertEqual([a%elastic_share, a%plastic_share], [b%elastic_share, b%plastic_share], &
            1.0e-14_wp, 'shares')
         if (anyExceptions()) return
      end do
   end subroutine test_scaling

   !> A common factor on E* and H leaves w1 as it is and multiplies the pressure by itself at any
   !> separation: to the bit by a power of two, to round-off else, without memory, with it, and with
   !> heights that are not Gaussian.
   subroutine test_one_factor()
      real(wp), parameter :: factors(4) = [0.5_wp, 4.0_wp, 0.7_wp, 0.313_wp]
      type(normal_properties) :: p, q
      type(normal_response) :: r, s
      type(error_type), allocatable :: error
      real(wp) :: d, wanted(4), found(4), worst
      integer :: i, j, k

      worst = 0.0_wp
      do k = 0, 2
         do j = 1, size(factors)
            call scaled_pair(p, 1.0_wp, k, error)
            call scaled_pair(q, factors(j), k, error)
            call assertFalse(allocated(error), 'accepted')
            do i = -60, 60
               d = 0.1_wp*i*p%sigma
               if (k == 1) then
                  r = evaluate_unloading_law(p, d, 0.2_wp*p%w1)
                  s = evaluate_unloading_law(q, d, 0.2_wp*q%w1)
               else
                  r = evaluate_normal_law(p, d)
                  s = evaluate_normal_law(q, d)
               end if
               wanted = [r%pressure, r%stiffness, r%energy, r%plastic_dissipation]*factors(j)
               found = [s%pressure, s%stiffness, s%energy, s%plastic_dissipation]
               if (j <= 2) then
                  call assertEqual(wanted, found, 0.0_wp, 'to the bit')
                  call assertEqual(p%w1, q%w1, 0.0_wp, 'w1')
               else
                  call worsen(worst, abs(found - wanted)/max(wanted, tiny(1.0_wp)))
                  call assertRelativelyEqual(p%w1, q%w1, 2.0_wp*eps, 'w1')
               end if
               call assertRelativelyEqual(r%area_fraction, s%area_fraction, 1.0e-14_wp, 'area')
            end do
         end do
      end do
      call record('normal_law.one_factor', worst)
      call assertLessThan(worst, 1.0e-14_wp, 'one factor')
   end subroutine test_one_factor

   !> The first pair with a factor on modulus and hardness: 0 as it is, 1 with memory, 2 with
   !> heights that are not Gaussian.
   subroutine scaled_pair(p, factor, kind, error)
      type(normal_properties), intent(out) :: p
      real(wp), intent(in) :: factor
      integer, intent(in) :: kind
      type(error_type), allocatable, intent(out) :: error

      call new_normal_properties(p, 206.0_wp, factor*297.0_wp, 0.1477_wp, factor*24.53_wp, &
         0.4_wp, 0.0593_wp, error, unloading=merge(1, 0, kind == 1), &
         height_distribution=merge(1, 0, kind == 2), kurtosis=3.61_wp)
   end subroutine scaled_pair

   !> h at 0.05, 0.2 and 4.7 MPa to three figures: half a digit away on both sides, pressures
   !> bracket the value.
   subroutine test_known_separations()
      real(wp), parameter :: pressure(3) = [0.05_wp, 0.2_wp, 4.7_wp]
      real(wp), parameter :: h(3, 2) = reshape([3.09_wp, 2.69_wp, 1.60_wp, 2.67_wp, 2.22_wp, &
         0.89_wp], [3, 2])
      real(wp), parameter :: stiffness(3) = [3.1_wp, 11.3_wp, 195.0_wp]
      real(wp), parameter :: half_digit(3) = [0.05_wp, 0.05_wp, 0.5_wp]
      real(wp), parameter :: area(2) = [0.23_wp, 0.40_wp]
      type(normal_properties) :: p
      type(normal_response) :: above, below
      integer :: i, pair

      do pair = 1, 2
         p = normal_of_pair(merge('transverse-tangential', 'tangential-tangential', pair == 1))
         do i = 1, 3
            above = evaluate_normal_law(p, (h(i, pair) + 0.005_wp)*p%sigma)
            below = evaluate_normal_law(p, (h(i, pair) - 0.005_wp)*p%sigma)
            call assertLessThanOrEqual(above%pressure, pressure(i), 'half a digit above')
            call assertLessThanOrEqual(pressure(i), below%pressure, 'half a digit below')
            if (pair == 1) then
               call assertLessThanOrEqual(above%stiffness, stiffness(i) + half_digit(i))
               call assertLessThanOrEqual(stiffness(i) - half_digit(i), below%stiffness)
            end if
         end do
         call assertLessThanOrEqual(above%area_fraction, area(pair) + 0.005_wp)
         call assertLessThanOrEqual(area(pair) - 0.005_wp, below%area_fraction)
      end do
   end subroutine test_known_separations

   !> Real area reaches nominal area at h = 0.91, 21 MPa (0.34, 11.9 MPa), to a digit; the elastic
   !> share is below 0.1 % for h < 5 and 5.8 % at h = 37.
   subroutine test_known_limits()
      real(wp), parameter :: h(2) = [0.91_wp, 0.34_wp], pressure(2) = [21.0_wp, 11.9_wp]
      real(wp), parameter :: digit(2) = [1.0_wp, 0.1_wp]
      type(normal_properties) :: p
      type(normal_response) :: above, below, r
      integer :: pair, i

      do pair = 1, 2
         p = normal_of_pair(merge('transverse-tangential', 'tangential-tangential', pair == 1))
         above = evaluate_normal_law(p, (h(pair) + 0.01_wp)*p%sigma)
         below = evaluate_normal_law(p, (h(pair) - 0.01_wp)*p%sigma)
         call assertLessThanOrEqual(above%area_fraction, 1.0_wp)
         call assertLessThanOrEqual(1.0_wp, below%area_fraction)
         call assertLessThanOrEqual(above%pressure, pressure(pair) + digit(pair))
         call assertLessThanOrEqual(pressure(pair) - digit(pair), below%pressure)
      end do
      p = normal_of_pair('transverse-tangential')
      do i = -100, 49
         r = evaluate_normal_law(p, 0.1_wp*i*p%sigma)
         call assertLessThan(r%elastic_share, 1.0e-3_wp, 'elastic share below h = 5')
      end do
      r = evaluate_normal_law(p, 37.0_wp*p%sigma)
      call assertEqual(0.058_wp, r%elastic_share, 0.0005_wp, 'elastic share at h = 37')
   end subroutine test_known_limits

end module test_law_normal_law
