!> The limits that UINTER's and VUINTER's messages name are those that are kept.
module test_abaqus_limits
   use asperity_abaqus_checks, only: computable, largest
   use asperity_base_kinds, only: wp
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_limits

contains

   function suite_limits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('limits')
      call suite%addTest(TestMethod('numbers of a host: below 1e30', test_largest))
   end function suite_limits

   subroutine test_largest()
      call assertEqual(1.0e30_wp, largest, 0.0_wp)
      call assertTrue(computable([0.0_wp, -nearest(largest, -1.0_wp)]))
      call assertFalse(computable([0.0_wp, largest]))
      call assertFalse(computable([-largest, 0.0_wp]))
   end subroutine test_largest

end module test_abaqus_limits
