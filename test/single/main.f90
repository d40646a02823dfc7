!> Runs VUINTER's suites against asperity_vuinter_single.f90, the build for single precision.
program test_single
   use asperity_abaqus_vuinter_precision, only: vp
   use funit, only: SerialContext, TestResult, TestRunner, TestSuite
   use test_vuinter, only: suite_vuinter
   use test_vuinter_agreement, only: suite_vuinter_agreement
   implicit none
   type(TestSuite) :: all_suites
   type(TestRunner) :: runner
   type(TestResult) :: outcome
   integer :: failed

   if (storage_size(1.0_vp) /= 32) error stop 'this is not the build for single precision'
   all_suites = TestSuite('asperity in single precision')
   call all_suites%addTest(suite_vuinter())
   call all_suites%addTest(suite_vuinter_agreement())
   runner = TestRunner()
   outcome = runner%run(all_suites, SerialContext())
   failed = outcome%failureCount() + outcome%errorCount()
   write (*, '(i0, a, i0, a)') outcome%runCount() - failed, ' passed, ', failed, ' failed'
   if (failed > 0 .or. outcome%runCount() == 0) stop 1, quiet=.true.
end program test_single
