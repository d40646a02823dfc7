!> Tests of src/check.
program test_check
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_check_findings, only: suite_findings
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('check')
   call suite%addTest(suite_findings())
   call run_suite(suite)
end program test_check
