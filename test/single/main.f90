!> Runs VUINTER's suites against asperity_vuinter_single.f90, the build for single precision.
program test_single
   use asperity_abaqus_vuinter_precision, only: vp
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_abaqus_vuinter, only: suite_vuinter
   use test_abaqus_vuinter_agreement, only: suite_vuinter_agreement
   use test_abaqus_vuinter_friction, only: suite_vuinter_friction
   implicit none
   type(TestSuite) :: all_suites

   if (storage_size(1.0_vp) /= 32) error stop 'this is not the build for single precision'
   all_suites = TestSuite('asperity in single precision')
   call all_suites%addTest(suite_vuinter())
   call all_suites%addTest(suite_vuinter_agreement())
   call all_suites%addTest(suite_vuinter_friction())
   call run_suite(all_suites)
end program test_single
