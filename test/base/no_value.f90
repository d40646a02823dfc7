!> The one "no value": above every value, and nothing below it is none.
module test_base_no_value
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_value
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_no_value

contains

   function suite_no_value() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('no_value')
      call suite%addTest(TestMethod('none and its neighbour', test_neighbour))
      call suite%addTest(TestMethod('infinity', test_infinity))
      call suite%addTest(TestMethod('values of an array', test_array))
   end function suite_no_value

   subroutine test_neighbour()
      call assertTrue(is_none(none), 'none')
      call assertFalse(is_none(nearest(none, -1.0_wp)), 'the number below is a value')
      call assertFalse(is_none(-none), 'so is the lowest')
   end subroutine test_neighbour

   !> Not NaN: comparing it traps where the tests are built to trap.
   subroutine test_infinity()
      call assertTrue(is_none(ieee_value(1.0_wp, ieee_positive_inf)))
   end subroutine test_infinity

   subroutine test_array()
      call assertEqual(2, count(is_none([none, 0.0_wp, 1.0e300_wp, none])))
   end subroutine test_array

end module test_base_no_value
