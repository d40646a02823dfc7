!> Tests of src/solid.
program test_solid
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_solid_small_matrices, only: suite_small_matrices
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('solid')
   call suite%addTest(suite_small_matrices())
   call run_suite(suite)
end program test_solid
