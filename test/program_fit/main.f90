!> Tests of what `asperity fit` does beside what the shell tests see.
program test_program_fit
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_program_fit_joint, only: suite_fit_joint
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('program_fit')
   call suite%addTest(suite_fit_joint())
   call run_suite(suite)
end program test_program_fit
