!> Tests of the keys of src/program.
program test_program_input
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_program_input_commands, only: suite_commands
   use test_program_input_interrupts, only: suite_interrupts
   use test_program_input_key_list, only: suite_key_list
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('program_input')
   call suite%addTest(suite_key_list())
   call suite%addTest(suite_commands())
   call suite%addTest(suite_interrupts())
   call run_suite(suite)
end program test_program_input
