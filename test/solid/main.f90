!> Tests of src/solid.
program test_solid
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_solid_joint_mesh, only: suite_joint_mesh
   use test_solid_small_matrices, only: suite_small_matrices
   use test_solid_vtu, only: suite_vtu
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('solid')
   call suite%addTest(suite_small_matrices())
   call suite%addTest(suite_joint_mesh())
   call suite%addTest(suite_vtu())
   call run_suite(suite)
end program test_solid
