!> Tests of src/base.
program test_base
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_base_finite, only: suite_finite
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('base')
   call suite%addTest(suite_finite())
   call run_suite(suite)
end program test_base
