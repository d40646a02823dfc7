!> Runs a suite, counts, and ends the program. It uses pFUnit's own names only, so it works with the
!> real pFUnit as well.
module run_suites
   use funit, only: SerialContext, TestResult, TestRunner, TestSuite
   implicit none
   private
   public :: run_suite

contains

   !> Run every test of a suite, print `N passed, N failed`, and stop with status 1 when a test
   !> failed or there was none.
   subroutine run_suite(suite)
      !> The suite, with those that it is made of
      type(TestSuite), intent(inout) :: suite
      type(TestRunner) :: runner
      type(TestResult) :: outcome
      integer :: failed

      runner = TestRunner()
      outcome = runner%run(suite, SerialContext())
      failed = outcome%failureCount() + outcome%errorCount()
      write (*, '(i0, a, i0, a)') outcome%runCount() - failed, ' passed, ', failed, ' failed'
      if (failed > 0 .or. outcome%runCount() == 0) stop 1, quiet=.true.
   end subroutine run_suite

end module run_suites
