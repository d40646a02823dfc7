!> Old wood: each factor acts on its properties and on no other, neutral ones leave every bit, and
!> what is no factor is refused by its name.
module test_faces_ageing
   use asperity, only: wp
   use asperity_base_error, only: error_type
   use asperity_wood_ageing, only: aged_wood, ageing_factors, ageing_names, ageing_values, &
      check_aged_wood, check_ageing, n_factors, set_ageing_values
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_values, only: n_values, wood_values
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_faces_ageing

   !> Values of a wood that each factor acts on, by `wood_values`, first and last; 1, 0 for none
   integer, parameter :: first(n_factors) = [1, 2, 7, 21, 10, 11, 13, 14, 16, 1], &
      last(n_factors) = [1, 3, 9, 22, 10, 12, 13, 15, 18, 0]

contains

   function suite_faces_ageing() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('old wood')
      call suite%addTest(TestMethod('neutral factors', test_neutral))
      call suite%addTest(TestMethod('each factor', test_each))
      call suite%addTest(TestMethod('curves of hardening', test_curves))
      call suite%addTest(TestMethod('what is refused', test_refused))
      call suite%addTest(TestMethod('moduli that no longer go together', test_energy))
   end function suite_faces_ageing

   !> Larch with curves that begin at its strengths.
   function larch() result(wood)
      type(wood_properties) :: wood

      allocate (wood%hardening_curve(2, 3), wood%hardening_curve_along(2, 2))
      wood%hardening_curve(:, :) = reshape([0.0_wp, 4.7_wp, 0.1_wp, 5.3_wp, 0.4_wp, 9.1_wp], [2, 3])
      wood%hardening_curve_along(:, :) = reshape([0.0_wp, 50.1_wp, 0.2_wp, 51.7_wp], [2, 2])
   end function larch

   !> Wood with neutral factors is the same to the bit.
   subroutine test_neutral()
      type(wood_properties) :: wood, old
      type(ageing_factors) :: neutral

      wood = larch()
      old = aged_wood(wood, neutral)
      call assertEqual(1.0_wp, ageing_values(neutral))
      call assertEqual(wood_values(wood), wood_values(old))
      call assertEqual(wood%hardening_curve(2, :), old%hardening_curve(2, :))
      call assertEqual(wood%hardening_curve_along(2, :), old%hardening_curve_along(2, :))
      call assertEqual(wood%criterion, old%criterion)
   end subroutine test_neutral

   !> A factor multiplies its values, and leaves the others to the bit; ratios and slopes of
   !> hardening are under none.
   subroutine test_each()
      type(wood_properties) :: wood, old
      type(ageing_factors) :: ageing
      real(wp) :: values(n_factors), expected(n_values)
      integer :: i

      do i = 1, n_factors
         values = 1.0_wp
         values(i) = 0.7_wp
         call set_ageing_values(ageing, values)
         call assertEqual(values, ageing_values(ageing))
         old = aged_wood(wood, ageing)
         expected = wood_values(wood)
         expected(first(i):last(i)) = 0.7_wp*expected(first(i):last(i))
         call assertEqual(expected, wood_values(old), trim(ageing_names(i)))
         call assertFalse(allocated(old%hardening_curve) .or. allocated(old%hardening_curve_along))
      end do
   end subroutine test_each

   !> Curves begin at the strengths of the old wood, or it would be refused.
   subroutine test_curves()
      type(wood_properties) :: wood, old
      type(error_type), allocatable :: error

      wood = larch()
      old = aged_wood(wood, ageing_factors(strength_compression_across=0.5_wp, &
         strength_compression_along=0.25_wp))
      call assertEqual(0.5_wp*wood%hardening_curve(2, :), old%hardening_curve(2, :))
      call assertEqual(wood%hardening_curve(1, :), old%hardening_curve(1, :))
      call assertEqual(0.25_wp*wood%hardening_curve_along(2, :), old%hardening_curve_along(2, :))
      call check_wood_properties(old, error)
      call assertFalse(allocated(error))
      old%hardening_curve = wood%hardening_curve
      call check_wood_properties(old, error)
      call assertTrue(allocated(error))
   end subroutine test_curves

   !> Factors outside of 0.01 to 10, and what is no number; the limits themselves pass.
   subroutine test_refused()
      type(ageing_factors) :: ageing
      type(error_type), allocatable :: error
      real(wp) :: values(n_factors), wrong(6)
      integer :: i, k

      wrong = [0.0_wp, -0.5_wp, 0.0099_wp, 73.0_wp, ieee_value(1.0_wp, ieee_quiet_nan), &
         ieee_value(1.0_wp, ieee_positive_inf)]
      do i = 1, n_factors
         do k = 1, size(wrong)
            values = 1.0_wp
            values(i) = wrong(k)
            call set_ageing_values(ageing, values)
            call check_ageing(ageing, error)
            call assertTrue(allocated(error), trim(ageing_names(i)))
            if (.not. allocated(error)) cycle
            call assertEqual(trim(ageing_names(i)), error%subject)
            call assertTrue(fits_subject(error), error%message)
         end do
         do k = 1, 2
            values(i) = merge(0.01_wp, 10.0_wp, k == 1)
            call set_ageing_values(ageing, values)
            call check_ageing(ageing, error)
            call assertFalse(allocated(error), trim(ageing_names(i)))
         end do
      end do
      call check_ageing(ageing_factors(hardness=73.0_wp), error)
      call assertEqual('ageing_hardness = 73.0 is not allowed: it must be a factor between '// &
         '0.01 and 10.0, of old wood over new; write 0.8 for 80 per cent', error%message)
   end subroutine test_refused

   !> Ratios stay, so that moduli along the grain that fall alone may give energy away; refused.
   subroutine test_energy()
      type(wood_properties) :: wood
      type(error_type), allocatable :: error

      call check_aged_wood(wood, ageing_factors(stiffness_along=0.1_wp), error)
      call assertFalse(allocated(error))
      call check_aged_wood(wood, ageing_factors(stiffness_along=0.03_wp), error)
      call assertTrue(allocated(error))
      if (.not. allocated(error)) return
      call assertTrue(fits_subject(error), error%message)
      call assertTrue(index(error%message, 'old wood') > 0, error%message)
      call assertTrue(index(error%subject, 'ageing_stiffness_along') > 0, error%subject)
      ! a wood that cannot be is not for its age to refuse
      wood%young_moduli(1) = -1.0_wp
      call check_aged_wood(wood, ageing_factors(stiffness_along=0.03_wp), error)
      call assertFalse(allocated(error))
   end subroutine test_energy

end module test_faces_ageing
