!> Tests of src/base.
program test_base
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_base_error, only: suite_error
   use test_base_finite, only: suite_finite
   use test_base_no_value, only: suite_no_value
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('base')
   call suite%addTest(suite_error())
   call suite%addTest(suite_finite())
   call suite%addTest(suite_no_value())
   call run_suite(suite)
end program test_base
