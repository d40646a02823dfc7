!> Validity flags of the normal law's results, and their texts.
module test_law_validity
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_law_plausibility, only: roughness_number_measured, roughness_number_min
   use asperity_law_validity, only: area_above_nominal, closure_above_half_radius, &
      implausible_property, pressure_above_hardness, roughness_number_high, roughness_number_low, &
      stiffer_than_hertz, valid, validity_remark, validity_text
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use gsl_quadrature, only: gaussian_moment
   use random_inputs, only: normal_of_pair
   implicit none
   private
   public :: suite_validity

contains

   function suite_validity() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('validity')
      call suite%addTest(TestMethod('each flag by a case of its own', test_flags))
      call suite%addTest(TestMethod('flags change at their limits', test_flag_limits))
      call suite%addTest(TestMethod('texts', test_texts))
      call suite%addTest(TestMethod('texts name the limits that are kept', test_limits))
   end function suite_validity

   !> Numbers in the remarks are those of the checks; the yield factor's, 2/sqrt(110), is the last
   !> without its flag but for rounding.
   subroutine test_limits()
      real(wp), parameter :: factor = 2.0_wp/sqrt(110.0_wp)
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      integer :: i

      call assertTrue(index(validity_remark(roughness_number_low), 'eta*radius*sigma below '// &
         to_text(roughness_number_min, 3)//':') == 1, 'lowest eta R sigma')
      call assertTrue(index(validity_remark(roughness_number_high), 'eta*radius*sigma above '// &
         to_text(nint(roughness_number_measured))//':') == 1, 'highest eta R sigma')
      call assertEqual(roughness_number_measured, anint(roughness_number_measured), 0.0_wp)
      call assertTrue(index(validity_remark(stiffer_than_hertz), &
         'yield_factor below 2/sqrt(plastic_ratio):') == 1, 'yield factor')
      do i = -1, 1, 2
         call new_normal_properties(p, 206.0_wp, 297.0_wp, 0.1477_wp, 24.53_wp, &
            factor*(1.0_wp + i*1.0e-14_wp), 0.0593_wp, error)
         call assertEqual(merge(stiffer_than_hertz, valid, i < 0), p%validity)
      end do
   end subroutine test_limits

   !> Each flag raised by a case made for it, and no other. A pressure above the hardness needs a
   !> real area above the nominal one, since no summit carries more than the hardness.
   subroutine test_flags()
      call check(206.0_wp, 297.0_wp, 24.53_wp, 0.4_wp, 3.0_wp, valid)
      call check(206.0_wp, 1.0_wp, 24.53_wp, 1.0_wp, 0.3_wp, &
         area_above_nominal + implausible_property)
      call check(206.0_wp, 1.0e4_wp, 24.53_wp, 0.4_wp, 1.5_wp, valid)
      call check(206.0_wp, 297.0_wp, 24.53_wp, 0.4_wp, -0.3_wp, &
         area_above_nominal + pressure_above_hardness)
      call check(206.0_wp, 297.0_wp, 24.53_wp, 0.4_wp, -1.5_wp, &
         area_above_nominal + pressure_above_hardness + closure_above_half_radius)
      call check(206.0_wp, 297.0_wp, 24.53_wp, 0.19_wp, 3.0_wp, stiffer_than_hertz)
      call check(206.0_wp, 297.0_wp, 24.53_wp, 0.191_wp, 3.0_wp, valid)
      call check(206.0_wp*2.3_wp, 297.0_wp, 24.53_wp, 0.4_wp, 4.0_wp, roughness_number_high)
      call check(1.5_wp, 297.0_wp, 24.53_wp, 0.4_wp, 3.0_wp, roughness_number_low)
      call check(1.5_wp, 297.0_wp, 24.53_wp, 0.4_wp, -1.5_wp, &
         roughness_number_low + closure_above_half_radius)
   end subroutine test_flags

   !> Each flag of the transverse-tangential pair changes where its limit is passed, not elsewhere:
   !> area 1, pressure H, mean closure of touching summits sigma F_1/F_0 = R/2.
   subroutine test_flag_limits()
      type(normal_properties) :: p
      type(normal_response) :: r
      real(wp) :: near, far, h, limit(3)
      integer :: i, j
      integer, parameter :: flags(3) = [area_above_nominal, pressure_above_hardness, &
         closure_above_half_radius]

      p = normal_of_pair('transverse-tangential')
      do i = 1, 3
         near = -5.0_wp
         far = 5.0_wp
         do j = 1, 60
            h = 0.5_wp*(near + far)
            r = evaluate_normal_law(p, h*p%sigma)
            limit = [r%area_fraction, r%pressure/p%hardness, &
               gaussian_moment(1.0_wp, h)/gaussian_moment(0.0_wp, h)*2.0_wp*p%sigma/p%radius]
            if (limit(i) > 1.0_wp) near = h
            if (limit(i) <= 1.0_wp) far = h
         end do
         r = evaluate_normal_law(p, (h - 1.0e-9_wp)*p%sigma)
         call assertTrue(iand(r%validity, flags(i)) /= 0, 'raised past the limit')
         r = evaluate_normal_law(p, (h + 1.0e-9_wp)*p%sigma)
         call assertTrue(iand(r%validity, flags(i)) == 0, 'not raised before the limit')
      end do
   end subroutine test_flag_limits

   !> The law of the transverse-tangential radius and sigma at h raises exactly `flags`.
   subroutine check(eta, modulus, hardness, yield_factor, h, flags)
      real(wp), intent(in) :: eta, modulus, hardness, yield_factor, h
      integer, intent(in) :: flags
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error

      call new_normal_properties(p, eta, modulus, 0.1477_wp, hardness, yield_factor, 0.0593_wp, &
         error, accept_unphysical=.true.)
      r = evaluate_normal_law(p, h*p%sigma)
      call assertEqual(flags, r%validity)
   end subroutine check

   subroutine test_texts()
      call assertEqual('valid', validity_text(valid))
      call assertEqual('', validity_remark(valid))
      call assertEqual('stiffer_than_hertz+roughness_number_low', &
         validity_text(stiffer_than_hertz + roughness_number_low))
      call assertTrue(index(validity_remark(roughness_number_high), 'above 4') > 0)
   end subroutine test_texts

end module test_law_validity
