!> Tests of what ranks do together: `mpirun -n N asperity_ranks_tests`, for any N. Every rank runs
!> all of them.
program test_ranks
   use asperity, only: error_type
   use asperity_solid_engine_petsc, only: load_petsc, unload_petsc
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_ranks_engine, only: petsc
   use test_ranks_joint, only: suite_joint
   use test_ranks_linear_solver, only: suite_linear_solver
   use test_ranks_team, only: suite_team
   implicit none
   type(TestSuite) :: suite
   type(error_type), allocatable :: error

   call load_petsc(petsc, error)
   if (allocated(error)) then
      ! ctest takes this status for a suite that is left out
      print '(a)', error%message
      stop 77, quiet=.true.
   end if
   suite = TestSuite('ranks')
   call suite%addTest(suite_team())
   call suite%addTest(suite_linear_solver())
   call suite%addTest(suite_joint())
   call run_suite(suite)
   call unload_petsc(petsc)
end program test_ranks
