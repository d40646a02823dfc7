!> Runs the tests of what interface/calculix computes itself; they need no CalculiX.
program test_calculix
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_areas, only: suite_areas
   use test_keyword, only: suite_keyword
   use test_masters, only: suite_masters
   use test_outputs, only: suite_outputs
   use test_springs, only: suite_springs
   implicit none
   type(TestSuite) :: all_suites

   all_suites = TestSuite('asperity in CalculiX')
   call all_suites%addTest(suite_springs())
   call all_suites%addTest(suite_keyword())
   call all_suites%addTest(suite_masters())
   call all_suites%addTest(suite_areas())
   call all_suites%addTest(suite_outputs())
   call run_suite(all_suites)
end program test_calculix
