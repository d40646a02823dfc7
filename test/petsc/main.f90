!> Tests of what needs PETSc.
program test_petsc
   use asperity_base_error, only: error_type
   use asperity_solid_engine_linear_solver, only: start_engine, stop_engine
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_petsc_linear_solver, only: suite_linear_solver
   implicit none
   type(TestSuite) :: suite
   type(error_type), allocatable :: error

   call start_engine(error)
   if (allocated(error)) error stop 'PETSc does not start'
   suite = TestSuite('petsc')
   call suite%addTest(suite_linear_solver())
   call run_suite(suite)
   call stop_engine()
end program test_petsc
