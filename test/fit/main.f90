!> Tests of src/fit.
program test_fit
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_fit_coverage, only: suite_fit_coverage
   use test_fit_least_squares, only: suite_fit_least_squares
   use test_fit_press, only: suite_fit_press
   use test_fit_traps, only: suite_fit_traps
   use test_fit_shear, only: suite_fit_shear
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('fit')
   call suite%addTest(suite_fit_least_squares())
   call suite%addTest(suite_fit_traps())
   call suite%addTest(suite_fit_press())
   call suite%addTest(suite_fit_coverage())
   call suite%addTest(suite_fit_shear())
   call run_suite(suite)
end program test_fit
