!> Tests of interface/abaqus.
program test_abaqus
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_abaqus_friction, only: suite_abaqus_friction
   use test_abaqus_heads, only: suite_heads
   use test_abaqus_limits, only: suite_limits
   use test_abaqus_memory, only: suite_abaqus_memory
   use test_abaqus_uinter, only: suite_uinter
   use test_abaqus_vuinter, only: suite_vuinter
   use test_abaqus_vuinter_agreement, only: suite_vuinter_agreement
   use test_abaqus_vuinter_friction, only: suite_vuinter_friction
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('abaqus')
   call suite%addTest(suite_uinter())
   call suite%addTest(suite_vuinter())
   call suite%addTest(suite_vuinter_agreement())
   call suite%addTest(suite_limits())
   call suite%addTest(suite_abaqus_memory())
   call suite%addTest(suite_abaqus_friction())
   call suite%addTest(suite_vuinter_friction())
   call suite%addTest(suite_heads())
   call run_suite(suite)
end program test_abaqus
