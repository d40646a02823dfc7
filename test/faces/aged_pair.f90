!> Pairs of the paper when their wood is old.
module test_faces_aged_pair
   use asperity, only: evaluate_normal_law, new_normal_properties, normal_properties, &
      normal_response, pair_preset, pairs, wp
   use asperity_base_error, only: error_type
   use asperity_faces_aged_pair, only: age_pair
   use asperity_wood_ageing, only: ageing_factors
   use asperity_wood_properties, only: wood_properties
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   use measurements, only: record
   implicit none
   private
   public :: suite_faces_aged_pair

contains

   function suite_faces_aged_pair() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('pairs of old wood')
      call suite%addTest(TestMethod('neutral factors', test_neutral))
      call suite%addTest(TestMethod('E* by Eq. 4', test_modulus))
      call suite%addTest(TestMethod('hardness and friction', test_others))
      call suite%addTest(TestMethod('one factor scales the pressure', test_scaling))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_faces_aged_pair

   function aged(which, ageing) result(pair)
      integer, intent(in) :: which
      type(ageing_factors), intent(in) :: ageing
      type(pair_preset) :: pair
      type(wood_properties) :: larch
      type(error_type), allocatable :: error

      pair = pairs(which)
      call age_pair(pair, larch, ageing, error)
      call assertFalse(allocated(error))
   end function aged

   !> Numbers of a pair that age may change, and those that it may not
   pure function changing(pair) result(values)
      type(pair_preset), intent(in) :: pair
      real(wp) :: values(3)

      values = [pair%modulus, pair%hardness, pair%friction_coefficient]
   end function changing

   pure function staying(pair) result(values)
      type(pair_preset), intent(in) :: pair
      real(wp) :: values(5)

      values = [pair%eta, pair%radius, pair%sigma, pair%yield_factor, pair%critical_slip]
   end function staying

   !> The same bits, and strengths are no matter of faces.
   subroutine test_neutral()
      integer :: i

      do i = 1, size(pairs)
         call assertEqual(changing(pairs(i)), changing(aged(i, ageing_factors())))
         call assertEqual(changing(pairs(i)), changing(aged(i, ageing_factors( &
            strength_compression_across=0.5_wp, stiffness_shear=0.5_wp))))
      end do
   end subroutine test_neutral

   !> E* = E*_paper Eq4(old)/Eq4(new): E_L, nu_LT of the transverse section, E_R, nu_RT of the
   !> tangential one, by numbers of Table 1.
   subroutine test_modulus()
      type(pair_preset) :: pair
      real(wp), parameter :: transverse = (1.0_wp - 0.42_wp**2)/3727.12_wp, &
         tangential = (1.0_wp - 0.35_wp**2)/351.01_wp

      pair = aged(1, ageing_factors(stiffness_along=0.5_wp))
      call assertRelativelyEqual(297.0_wp*(transverse + tangential) &
         /(transverse/0.5_wp + tangential), pair%modulus, 1.0e-14_wp)
      call assertEqual(274.69_wp, pair%modulus, 0.005_wp)
      call assertEqual(staying(pairs(1)), staying(pair))
      pair = aged(1, ageing_factors(stiffness_across=0.8_wp))
      call assertRelativelyEqual(297.0_wp*(transverse + tangential) &
         /(transverse + tangential/0.8_wp), pair%modulus, 1.0e-14_wp)
      ! no section of the second pair is transverse
      pair = aged(2, ageing_factors(stiffness_along=0.5_wp))
      call assertEqual(263.0_wp, pair%modulus)
      pair = aged(2, ageing_factors(stiffness_across=0.8_wp))
      call assertRelativelyEqual(0.8_wp*263.0_wp, pair%modulus, 1.0e-14_wp)
      call record('ageing.modulus.relative_error', abs(pair%modulus/(0.8_wp*263.0_wp) - 1.0_wp))
   end subroutine test_modulus

   subroutine test_others()
      type(pair_preset) :: pair

      pair = aged(1, ageing_factors(hardness=0.8_wp, friction=0.6_wp))
      call assertEqual([297.0_wp, 0.8_wp*24.53_wp, 0.6_wp*0.5_wp], changing(pair))
      call assertEqual(staying(pairs(1)), staying(pair))
   end subroutine test_others

   !> With one factor on E* and H the pressure at any separation is scaled by it, and nothing that
   !> has no unit changes: to the bit for a power of two.
   subroutine test_scaling()
      type(normal_properties) :: new, old
      type(normal_response) :: law, of_old
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      real(wp), parameter :: factors(3) = [0.5_wp, 0.7_wp, 1.3_wp]
      real(wp) :: error_found
      integer :: which, k, i

      error_found = 0.0_wp
      do which = 1, size(pairs)
         call new_normal_properties(new, pairs(which), error)
         do k = 1, size(factors)
            pair = aged(which, ageing_factors(stiffness_along=factors(k), &
               stiffness_across=factors(k), hardness=factors(k)))
            call new_normal_properties(old, pair, error)
            call assertFalse(allocated(error))
            do i = -4, 8
               law = evaluate_normal_law(new, 0.5_wp*i*new%sigma)
               of_old = evaluate_normal_law(old, 0.5_wp*i*new%sigma)
               if (k == 1) then
                  call assertEqual(0.5_wp*law%pressure, of_old%pressure)
                  call assertEqual(law%area_fraction, of_old%area_fraction)
                  call assertEqual(law%elastoplastic_share, of_old%elastoplastic_share)
               end if
               call assertRelativelyEqual(factors(k)*law%pressure, of_old%pressure, 1.0e-13_wp)
               error_found = max(error_found, &
                  abs(of_old%pressure/(factors(k)*law%pressure) - 1.0_wp))
               call assertRelativelyEqual(law%area_fraction, of_old%area_fraction, 1.0e-13_wp)
            end do
         end do
      end do
      call record('ageing.pressure.relative_error', error_found)
   end subroutine test_scaling

   !> A wood that cannot be, when factors say that it is to be looked at.
   subroutine test_refused()
      type(pair_preset) :: pair
      type(wood_properties) :: wood
      type(error_type), allocatable :: error

      pair = pairs(1)
      call age_pair(pair, wood, ageing_factors(stiffness_along=0.02_wp), error)
      call assertTrue(allocated(error))
      wood%young_moduli(1) = 0.0_wp
      call age_pair(pair, wood, ageing_factors(hardness=0.9_wp), error)
      call assertTrue(allocated(error))
      call assertEqual(changing(pairs(1)), changing(pair))
      call age_pair(pair, wood, ageing_factors(), error)
      call assertFalse(allocated(error))
      wood = wood_properties()
      pair%name = 'two faces'
      call age_pair(pair, wood, ageing_factors(hardness=0.9_wp), error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertEqual('pair', error%subject)
      call assertEqual(changing(pairs(1)), changing(pair))
   end subroutine test_refused

end module test_faces_aged_pair
