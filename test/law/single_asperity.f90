!> One summit: stages, continuity, exponents, derivatives and energy, from the paper's formulas.
module test_law_single_asperity
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_single_asperity, only: asperity_response, evaluate_asperity, stage_elastic, &
      stage_elastoplastic, stage_open, stage_plastic
   use asperity_law_validity, only: closure_above_half_radius
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertLessThan, assertRelativelyEqual, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   implicit none
   private
   public :: suite_single_asperity

   integer, parameter :: n_random = 500

contains

   function suite_single_asperity() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('single asperity')
      call suite%addTest(TestMethod('elastic stage is Hertz', test_elastic))
      call suite%addTest(TestMethod('plastic stage carries the hardness', test_plastic))
      call suite%addTest(TestMethod('elasto-plastic stage is a power law', test_elastoplastic))
      call suite%addTest(TestMethod('exponents of the paper', test_exponents))
      call suite%addTest(TestMethod('continuous at w1 and w2', test_continuity))
      call suite%addTest(TestMethod('derivatives against differences', test_derivatives))
      call suite%addTest(TestMethod('force table of the literature comparison', test_table))
      call suite%addTest(TestMethod('open summit', test_open))
      call suite%addTest(TestMethod('closure above half the radius is flagged', test_validity))
   end function suite_single_asperity

   !> Eqs 1-3 written with E*, not with N1; 1e-14 is round-off of a few operations.
   subroutine test_elastic()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(asperity_response) :: r
      real(wp) :: w
      integer :: i

      stream = random_stream(11)
      do i = 1, n_random
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         w = p%w1*stream%uniform(1.0e-6_wp, 0.999_wp)
         r = evaluate_asperity(p, w)
         call assertEqual(stage_elastic, r%stage)
         call assertRelativelyEqual(4.0_wp/3.0_wp*p%modulus*sqrt(p%radius)*w*sqrt(w), r%force, &
            1.0e-14_wp, 'force')
         call assertRelativelyEqual(pi*p%radius*w, r%area, 1.0e-14_wp, 'area')
         call assertRelativelyEqual(4.0_wp*p%modulus/(3.0_wp*pi)*sqrt(w/p%radius), &
            r%mean_pressure, 1.0e-14_wp, 'mean pressure')
         if (anyExceptions()) return
      end do
   end subroutine test_elastic

   !> Eqs 10, 12, 13.
   subroutine test_plastic()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(asperity_response) :: r
      real(wp) :: w
      integer :: i

      stream = random_stream(12)
      do i = 1, n_random
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         w = p%w1*stream%log_uniform(110.001_wp, 1.0e5_wp)
         r = evaluate_asperity(p, w)
         call assertEqual(stage_plastic, r%stage)
         call assertRelativelyEqual(2.0_wp*pi*p%radius*w, r%area, 1.0e-14_wp, 'area')
         call assertRelativelyEqual(p%hardness, r%mean_pressure, 1.0e-14_wp, 'mean pressure')
         call assertRelativelyEqual(p%hardness*r%area, r%force, 1.0e-14_wp, 'force')
         if (anyExceptions()) return
      end do
   end subroutine test_plastic

   !> Eqs 20-22: in the elasto-plastic stage each quantity is a power of w whose exponent follows
   !> from its values at both ends: k H to H, pi R w1 to 2 pi R w2.
   subroutine test_elastoplastic()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(asperity_response) :: r
      real(wp) :: fraction, area_1, area_2
      integer :: i

      stream = random_stream(13)
      do i = 1, n_random
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         fraction = stream%uniform(0.001_wp, 0.999_wp)
         r = evaluate_asperity(p, p%w1*110.0_wp**fraction)
         call assertEqual(stage_elastoplastic, r%stage)
         area_1 = pi*p%radius*p%w1
         area_2 = 2.0_wp*pi*p%radius*110.0_wp*p%w1
         call assertRelativelyEqual(area_1**(1.0_wp - fraction)*area_2**fraction, r%area, &
            1.0e-13_wp, 'area')
         call assertRelativelyEqual(p%hardness*p%yield_factor**(1.0_wp - fraction), &
            r%mean_pressure, 1.0e-13_wp, 'mean pressure')
         call assertRelativelyEqual(r%area*r%mean_pressure, r%force, 1.0e-13_wp, 'force')
         if (anyExceptions()) return
      end do
   end subroutine test_elastoplastic

   !> The exponents for k = 0.4 to the digits known, and Eqs 14-19 through two logarithms.
   subroutine test_exponents()
      type(normal_properties) :: p

      p = normal_of_pair('transverse-tangential')
      call assertEqual(0.19494_wp, p%b1, 0.5e-5_wp, 'b1')
      call assertEqual(1.14746_wp, p%b2, 0.5e-5_wp, 'b2')
      call assertEqual(1.34240_wp, p%b3, 0.5e-5_wp, 'b3')
      call assertEqual(p%b1 + p%b2, p%b3, 1.0e-15_wp, 'force is pressure times area')
   end subroutine test_exponents

   !> Force, area, mean pressure and energy just before and at the ends of the stages; 2e-14 is
   !> the round-off of a power of 110.
   subroutine test_continuity()
      type(random_stream) :: stream
      type(normal_properties) :: p
      real(wp) :: worst
      integer :: i

      stream = random_stream(14)
      worst = 0.0_wp
      do i = 1, n_random
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         call worsen(worst, [jump(p, p%w1), jump(p, p%w2)])
      end do
      call record('single_asperity.jump', worst)
      call assertLessThan(worst, 2.0e-14_wp, 'largest relative jump')
   end subroutine test_continuity

   function jump(p, w) result(largest)
      type(normal_properties), intent(in) :: p
      real(wp), intent(in) :: w
      real(wp) :: largest
      type(asperity_response) :: before, after

      before = evaluate_asperity(p, nearest(w, -1.0_wp))
      after = evaluate_asperity(p, w)
      call assertEqual(after%stage, before%stage + 1, 'the stage changes here')
      largest = max(abs(before%force/after%force - 1.0_wp), &
         abs(before%area/after%area - 1.0_wp), &
         abs(before%mean_pressure/after%mean_pressure - 1.0_wp), &
         abs(before%energy/after%energy - 1.0_wp))
   end function jump

   !> Slopes against central differences in each stage, the energy's slope being the force. With a
   !> relative step of 1e-5 the difference errs by 1e-10 (truncation) and 1e-10 (round-off).
   subroutine test_derivatives()
      type(random_stream) :: stream
      real(wp), parameter :: lower(3) = [0.01_wp, 1.01_wp, 111.0_wp]
      real(wp), parameter :: upper(3) = [0.99_wp, 109.0_wp, 1.0e4_wp]
      type(normal_properties) :: p
      type(asperity_response) :: r, left, right
      real(wp) :: w, a, b, worst
      integer :: i, stage

      stream = random_stream(15)
      worst = 0.0_wp
      do i = 1, n_random
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         do stage = 1, 3
            w = p%w1*stream%log_uniform(lower(stage), upper(stage))
            a = w*(1.0_wp - 1.0e-5_wp)
            b = w*(1.0_wp + 1.0e-5_wp)
            r = evaluate_asperity(p, w)
            left = evaluate_asperity(p, a)
            right = evaluate_asperity(p, b)
            call assertEqual(stage, r%stage)
            call worsen(worst, [&
               abs((right%force - left%force)/(b - a)/r%force_slope - 1.0_wp), &
               abs((right%area - left%area)/(b - a)/r%area_slope - 1.0_wp), &
               abs((right%energy - left%energy)/(b - a)/r%force - 1.0_wp), &
               abs((right%mean_pressure - left%mean_pressure)/(b - a) - r%mean_pressure_slope) &
               /(r%mean_pressure/w)])
         end do
      end do
      call record('single_asperity.derivative', worst)
      call assertLessThan(worst, 1.0e-9_wp, 'largest relative error of a derivative')
   end subroutine test_derivatives

   !> N/N1 at w/w1 for k = 0.4 to three or four figures; the value at 110 is 2*110/k.
   subroutine test_table()
      real(wp), parameter :: w(6) = [2.0_wp, 6.0_wp, 20.0_wp, 54.0_wp, 110.0_wp, 500.0_wp]
      real(wp), parameter :: force(6) = [2.54_wp, 11.08_wp, 55.8_wp, 212.0_wp, 550.0_wp, 2500.0_wp]
      real(wp), parameter :: half_digit(6) = [0.005_wp, 0.005_wp, 0.05_wp, 0.5_wp, 0.5_wp, 0.5_wp]
      type(normal_properties) :: p
      type(asperity_response) :: r
      integer :: i

      p = normal_of_pair('tangential-tangential')
      do i = 1, size(w)
         r = evaluate_asperity(p, w(i)*p%w1)
         call assertEqual(force(i), r%force/p%n1, half_digit(i))
      end do
   end subroutine test_table

   subroutine test_open()
      real(wp), parameter :: w(3) = [0.0_wp, -1.0e-300_wp, -1.0e300_wp]
      type(asperity_response) :: r
      integer :: i

      do i = 1, size(w)
         r = evaluate_asperity(normal_of_pair('transverse-tangential'), w(i))
         call assertEqual(stage_open, r%stage)
         call assertEqual(0.0_wp, [r%force, r%force_slope, r%area, r%area_slope, &
            r%mean_pressure, r%mean_pressure_slope, r%energy])
      end do
   end subroutine test_open

   subroutine test_validity()
      type(normal_properties) :: p
      type(asperity_response) :: r

      p = normal_of_pair('transverse-tangential')
      r = evaluate_asperity(p, 0.499_wp*p%radius)
      call assertEqual(0, r%validity, 'below half the radius')
      r = evaluate_asperity(p, 0.501_wp*p%radius)
      call assertEqual(closure_above_half_radius, r%validity, 'above half the radius')
   end subroutine test_validity

end module test_law_single_asperity
