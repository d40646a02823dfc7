!> Runs the tests of what interface/calculix computes itself; they need no CalculiX.
program test_calculix
   use funit, only: SerialContext, TestResult, TestRunner, TestSuite
   use test_areas, only: suite_areas
   use test_keyword, only: suite_keyword
   use test_masters, only: suite_masters
   use test_outputs, only: suite_outputs
   use test_springs, only: suite_springs
   implicit none
   type(TestSuite) :: all_suites
   type(TestRunner) :: runner
   type(TestResult) :: outcome
   integer :: failed

   all_suites = TestSuite('asperity in CalculiX')
   call all_suites%addTest(suite_springs())
   call all_suites%addTest(suite_keyword())
   call all_suites%addTest(suite_masters())
   call all_suites%addTest(suite_areas())
   call all_suites%addTest(suite_outputs())
   runner = TestRunner()
   outcome = runner%run(all_suites, SerialContext())
   failed = outcome%failureCount() + outcome%errorCount()
   write (*, '(i0, a, i0, a)') outcome%runCount() - failed, ' passed, ', failed, ' failed'
   if (failed > 0 .or. outcome%runCount() == 0) stop 1, quiet=.true.
end program test_calculix
