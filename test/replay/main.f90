!> Tests of src/replay.
program test_replay
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_replay_abaqus_host, only: suite_replay_host
   use test_replay_memory, only: suite_memory
   use test_replay_path, only: suite_replay_path
   use test_replay_press, only: suite_press
   use test_replay_shear_box, only: suite_shear_box
   use test_replay_sizes, only: suite_sizes
   use test_replay_tenon_energy, only: suite_tenon_energy
   use test_replay_tenon_forms, only: suite_tenon_forms
   use test_replay_tenon_joint, only: suite_tenon_joint
   use test_replay_tenon_laws, only: suite_tenon_laws
   use test_replay_tenon_limits, only: suite_tenon_limits
   use test_replay_tenon_solver, only: suite_tenon_solver
   use test_replay_tenon_stick, only: suite_tenon_stick
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('replay')
   call suite%addTest(suite_replay_host())
   call suite%addTest(suite_replay_path())
   call suite%addTest(suite_press())
   call suite%addTest(suite_shear_box())
   call suite%addTest(suite_sizes())
   call suite%addTest(suite_memory())
   call suite%addTest(suite_tenon_forms())
   call suite%addTest(suite_tenon_laws())
   call suite%addTest(suite_tenon_energy())
   call suite%addTest(suite_tenon_joint())
   call suite%addTest(suite_tenon_limits())
   call suite%addTest(suite_tenon_solver())
   call suite%addTest(suite_tenon_stick())
   call run_suite(suite)
end program test_replay
