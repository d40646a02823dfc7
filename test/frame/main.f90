!> Tests of src/frame.
program test_frame
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_frame_fit, only: suite_frame_fit
   use test_frame_rules, only: suite_frame_rules
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('frame')
   call suite%addTest(suite_frame_rules())
   call suite%addTest(suite_frame_fit())
   call run_suite(suite)
end program test_frame
