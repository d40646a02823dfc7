!> Runs the tests of what interface/calculix computes itself; they need no CalculiX.
program test_calculix
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_calculix_areas, only: suite_areas
   use test_calculix_keyword, only: suite_keyword
   use test_calculix_master_faces, only: suite_master_faces
   use test_calculix_outputs, only: suite_outputs
   use test_calculix_springs, only: suite_springs
   implicit none
   type(TestSuite) :: all_suites

   all_suites = TestSuite('asperity in CalculiX')
   call all_suites%addTest(suite_springs())
   call all_suites%addTest(suite_keyword())
   call all_suites%addTest(suite_master_faces())
   call all_suites%addTest(suite_areas())
   call all_suites%addTest(suite_outputs())
   call run_suite(all_suites)
end program test_calculix
