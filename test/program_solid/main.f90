!> Tests of what `asperity solid` shows, on joints made by formulas.
program test_program_solid
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_program_solid_pictures, only: suite_pictures
   use test_program_solid_remarks, only: suite_remarks
   use test_program_solid_snapshots, only: suite_snapshots
   use test_program_solid_tables, only: suite_tables
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('program_solid')
   call suite%addTest(suite_tables())
   call suite%addTest(suite_snapshots())
   call suite%addTest(suite_pictures())
   call suite%addTest(suite_remarks())
   call run_suite(suite)
end program test_program_solid
