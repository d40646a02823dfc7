!> Tests of src/hysteresis.
program test_hysteresis
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_hysteresis_analysis, only: suite_hysteresis
   use test_hysteresis_borders, only: suite_hysteresis_borders
   use test_hysteresis_envelopes, only: suite_hysteresis_envelopes
   use test_hysteresis_halves, only: suite_hysteresis_halves
   use test_hysteresis_kinds, only: suite_hysteresis_kinds
   use test_hysteresis_programmes, only: suite_hysteresis_programmes
   use test_hysteresis_records, only: suite_hysteresis_records
   use test_hysteresis_samples, only: suite_hysteresis_samples
   use test_hysteresis_skeletons, only: suite_hysteresis_skeletons
   use test_hysteresis_standards, only: suite_hysteresis_standards
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('hysteresis')
   call suite%addTest(suite_hysteresis())
   call suite%addTest(suite_hysteresis_skeletons())
   call suite%addTest(suite_hysteresis_records())
   call suite%addTest(suite_hysteresis_programmes())
   call suite%addTest(suite_hysteresis_kinds())
   call suite%addTest(suite_hysteresis_borders())
   call suite%addTest(suite_hysteresis_envelopes())
   call suite%addTest(suite_hysteresis_samples())
   call suite%addTest(suite_hysteresis_halves())
   call suite%addTest(suite_hysteresis_standards())
   call run_suite(suite)
end program test_hysteresis
