!> Tests of src/check.
program test_check
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_check_argument_lists, only: suite_argument_lists
   use test_check_argument_types, only: suite_argument_types
   use test_check_findings, only: suite_findings
   use test_check_ours, only: suite_ours
   use test_check_rules, only: suite_rules
   use test_check_source_forms, only: suite_source_forms
   use test_check_source_scan, only: suite_source_scan
   use test_check_source_text, only: suite_source_text
   use test_check_vuinter, only: suite_check_vuinter
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('check')
   call suite%addTest(suite_findings())
   call suite%addTest(suite_source_forms())
   call suite%addTest(suite_source_scan())
   call suite%addTest(suite_source_text())
   call suite%addTest(suite_argument_lists())
   call suite%addTest(suite_argument_types())
   call suite%addTest(suite_ours())
   call suite%addTest(suite_rules())
   call suite%addTest(suite_check_vuinter())
   call run_suite(suite)
end program test_check
