!> Tests of src/solid.
program test_solid
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_solid_frame_mesh, only: suite_frame_mesh
   use test_solid_joint_mesh, only: suite_joint_mesh
   use test_solid_brick, only: suite_brick
   use test_solid_brick_limits, only: suite_brick_limits
   use test_solid_brick_logarithmic, only: suite_brick_logarithmic
   use test_solid_brick_structures, only: suite_brick_structures
   use test_solid_brick_tangent, only: suite_brick_tangent
   use test_solid_contact_energy, only: suite_contact_energy
   use test_solid_contact_failure, only: suite_contact_failure
   use test_solid_contact_geometry, only: suite_contact_geometry
   use test_solid_contact_history, only: suite_contact_history
   use test_solid_contact_patch, only: suite_contact_patch
   use test_solid_contact_paths, only: suite_contact_paths
   use test_solid_contact_tangent, only: suite_contact_tangent
   use test_solid_vtu, only: suite_vtu
   use test_solid_logarithm, only: suite_logarithm
   use test_solid_material_elasticity, only: suite_material_elasticity
   use test_solid_material_return, only: suite_material_return
   use test_solid_material_strengths, only: suite_material_strengths
   use test_solid_material_tangent, only: suite_material_tangent
   use test_solid_pattern, only: suite_pattern
   use test_solid_rigid_motions, only: suite_rigid_motions
   use test_solid_small_matrices, only: suite_small_matrices
   use test_solid_wood_check, only: suite_wood_check
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('solid')
   call suite%addTest(suite_small_matrices())
   call suite%addTest(suite_joint_mesh())
   call suite%addTest(suite_frame_mesh())
   call suite%addTest(suite_vtu())
   call suite%addTest(suite_pattern())
   call suite%addTest(suite_rigid_motions())
   call suite%addTest(suite_wood_check())
   call suite%addTest(suite_material_elasticity())
   call suite%addTest(suite_material_strengths())
   call suite%addTest(suite_material_return())
   call suite%addTest(suite_material_tangent())
   call suite%addTest(suite_logarithm())
   call suite%addTest(suite_brick())
   call suite%addTest(suite_brick_limits())
   call suite%addTest(suite_brick_tangent())
   call suite%addTest(suite_brick_structures())
   call suite%addTest(suite_brick_logarithmic())
   call suite%addTest(suite_contact_geometry())
   call suite%addTest(suite_contact_patch())
   call suite%addTest(suite_contact_paths())
   call suite%addTest(suite_contact_energy())
   call suite%addTest(suite_contact_failure())
   call suite%addTest(suite_contact_history())
   call suite%addTest(suite_contact_tangent())
   call run_suite(suite)
end program test_solid
