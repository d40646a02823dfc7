!> The remark on heights that are not Gaussian: told by what they do to the pressure.
module test_surface_heights_remarks
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: heights_johnson, new_normal_properties, &
      normal_properties
   use asperity_surface_parameters_parameters, only: n_parameters, p_sku, p_ssk
   use asperity_surface_remarks_on_heights, only: add_height_effect, remark_heights
   use asperity_surface_remarks_remark, only: remark_type
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_surface_heights_remarks

contains

   function suite_surface_heights_remarks() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface heights_remarks')
      call suite%addTest(TestMethod('effect on the pressure', test_effect))
      call suite%addTest(TestMethod('from a fifth on', test_limit))
      call suite%addTest(TestMethod('uncertainty', test_uncertainty))
      call suite%addTest(TestMethod('own summits', test_own_summits))
   end function suite_surface_heights_remarks

   !> Factors that were integrated independently (Johnson's SU fitted by its moments, adaptive
   !> quadrature), to the three figures that the remark has.
   subroutine test_effect()
      call check_factors(cross_on_tangential(), 3.61_wp, ' 4.94 and 2.89 times')
      call check_factors(two_tangential(), 3.43_wp, ' 2.14 and 1.50 times')
      ! within 2 %: nothing to tell
      call check_factors(cross_on_tangential(), 3.01_wp, '')
      call check_factors(cross_on_tangential(), 3.0_wp, '')
   end subroutine test_effect

   subroutine check_factors(law, kurtosis, expected)
      type(normal_properties), intent(in) :: law
      real(wp), intent(in) :: kurtosis
      character(len=*), intent(in) :: expected
      character(len=:), allocatable :: text
      real(wp) :: separations(2)
      logical :: is_told

      allocate (text, source='')
      call add_height_effect(text, law, 0.0_wp, kurtosis, separations, is_told)
      call assertTrue(is_told .eqv. expected /= '', 'whether it is told')
      call assertTrue(index(text, expected) > 0, text)
   end subroutine check_factors

   !> The limit, found by bisection on the law itself: not told below, told above.
   subroutine test_limit()
      type(normal_properties) :: law
      character(len=:), allocatable :: text
      real(wp) :: low, high, middle, separations(2)
      logical :: is_told
      integer :: i

      law = cross_on_tangential()
      low = 3.0_wp
      high = 3.61_wp
      do i = 1, 40
         middle = 0.5_wp*(low + high)
         if (factor_of(law, middle) > 1.2_wp) then
            high = middle
         else
            low = middle
         end if
      end do
      allocate (text, source='')
      call add_height_effect(text, law, 0.0_wp, low - 1.0e-6_wp, separations, is_told)
      call assertFalse(is_told, 'below')
      call add_height_effect(text, law, 0.0_wp, high + 1.0e-6_wp, separations, is_told)
      call assertTrue(is_told, 'above')
   end subroutine test_limit

   !> Pressure over that of Gaussian heights, where these have 0.05 MPa.
   real(wp) function factor_of(law, kurtosis) result(factor)
      type(normal_properties), intent(in) :: law
      real(wp), intent(in) :: kurtosis
      type(normal_properties) :: johnson
      type(normal_response) :: response
      type(error_type), allocatable :: error
      real(wp) :: separation

      call separation_for_pressure(law, 0.05_wp, separation, error)
      call new_normal_properties(johnson, law%eta, law%modulus, law%radius, law%hardness, &
         law%yield_factor, law%sigma, error, height_distribution=heights_johnson, &
         skewness=0.0_wp, kurtosis=kurtosis)
      response = evaluate_normal_law(johnson, separation)
      factor = response%pressure/0.05_wp
   end function factor_of

   !> Heights that may be Gaussian, or nearly so, are not remarked on.
   subroutine test_uncertainty()
      call check_remarks(0.0_wp, none, 3.61_wp, 0.62_wp, 0)
      ! 3.03, whose effect is small
      call check_remarks(0.0_wp, none, 3.61_wp, 0.58_wp, 0)
      call check_remarks(0.0_wp, none, 3.61_wp, 0.4_wp, 1)
      call check_remarks(0.0_wp, none, 3.61_wp, none, 1)
      call check_remarks(0.3_wp, 0.1_wp, 3.0_wp, 0.6_wp, 1)
      call check_remarks(0.3_wp, 0.4_wp, 3.0_wp, 0.6_wp, 0)
      call check_remarks(none, none, 3.61_wp, none, 0)
      ! two peaks
      call check_remarks(0.0_wp, none, 1.2_wp, none, 1)
   end subroutine test_uncertainty

   subroutine check_remarks(ssk, u_ssk, sku, u_sku, expected)
      real(wp), intent(in) :: ssk, u_ssk, sku, u_sku
      integer, intent(in) :: expected
      real(wp) :: values(n_parameters), uncertainty(n_parameters)
      type(remark_type), allocatable :: remarks(:)

      values = none
      uncertainty = none
      values([p_ssk, p_sku]) = [ssk, sku]
      uncertainty([p_ssk, p_sku]) = [u_ssk, u_sku]
      allocate (remarks(0))
      call remark_heights(cross_on_tangential(), values, uncertainty, [0.0_wp], [1.0_wp], 1.0_wp, &
         remarks)
      call assertEqual(expected, size(remarks), 'remarks')
      if (expected > 0) call assertEqual('heights', trim(remarks(1)%code), 'code')
   end subroutine check_remarks

   !> One plastic summit, N = 2 pi R H w with its own radius, on an area where it gives 0.1 MPa.
   subroutine test_own_summits()
      type(normal_properties) :: law
      type(error_type), allocatable :: error
      type(remark_type), allocatable :: remarks(:)
      real(wp) :: values(n_parameters), uncertainty(n_parameters), separation(2)
      real(wp), parameter :: own = 0.01_wp, pi = acos(-1.0_wp)

      law = cross_on_tangential()
      call separation_for_pressure(law, 0.05_wp, separation(1), error)
      call separation_for_pressure(law, 0.2_wp, separation(2), error)
      values = none
      uncertainty = none
      values([p_ssk, p_sku]) = [0.0_wp, 3.61_wp]
      allocate (remarks(0))
      call remark_heights(law, values, uncertainty, [separation(1) + 0.1_wp], [1.0_wp/own], &
         2.0_wp*pi*own*law%hardness*0.1_wp/0.1_wp, remarks)
      call assertTrue(index(remarks(1)%text, 'own radius, give 2.00 times') > 0, remarks(1)%text)
   end subroutine test_own_summits

   function cross_on_tangential() result(law)
      type(normal_properties) :: law
      type(error_type), allocatable :: error

      call new_normal_properties(law, 206.0_wp, 297.0_wp, 0.1477_wp, 24.53_wp, 0.4_wp, 0.0593_wp, &
         error)
   end function cross_on_tangential

   function two_tangential() result(law)
      type(normal_properties) :: law
      type(error_type), allocatable :: error

      call new_normal_properties(law, 134.0_wp, 263.0_wp, 0.1142_wp, 12.14_wp, 0.4_wp, 0.0416_wp, &
         error)
   end function two_tangential

end module test_surface_heights_remarks
