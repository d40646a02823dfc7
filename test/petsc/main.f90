!> Tests of what needs PETSc.
program test_petsc
   use asperity_base_error, only: error_type
   use asperity_solid_engine_petsc, only: load_petsc, unload_petsc
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_petsc_engine, only: petsc
   use test_petsc_frame, only: suite_frame
   use test_petsc_joint_checkpoint, only: suite_joint_checkpoint
   use test_petsc_joint_equations, only: suite_joint_equations
   use test_petsc_joint_failure, only: suite_joint_failure
   use test_petsc_joint_programme, only: suite_joint_programme
   use test_petsc_joint_record, only: suite_joint_record
   use test_petsc_linear_solver, only: suite_linear_solver
   use test_petsc_two_blocks, only: suite_two_blocks
   implicit none
   type(TestSuite) :: suite
   type(error_type), allocatable :: error

   call load_petsc(petsc, error)
   if (allocated(error)) then
      ! ctest takes this status for a suite that is left out
      print '(a)', error%message
      stop 77, quiet=.true.
   end if
   suite = TestSuite('petsc')
   call suite%addTest(suite_linear_solver())
   call suite%addTest(suite_joint_equations())
   call suite%addTest(suite_two_blocks())
   call suite%addTest(suite_joint_programme())
   call suite%addTest(suite_joint_record())
   call suite%addTest(suite_joint_failure())
   call suite%addTest(suite_joint_checkpoint())
   call suite%addTest(suite_frame())
   call run_suite(suite)
   call unload_petsc(petsc)
end program test_petsc
