!> Runs every suite. It uses pFUnit's own names only, so it works with the real pFUnit as well.
program test_main
   use funit, only: SerialContext, TestResult, TestRunner, TestSuite
   use test_compiled_energy, only: suite_compiled_energy
   use test_compiled_law, only: suite_compiled_law
   use test_compiled_points, only: suite_compiled_points
   use test_contact_energy, only: suite_contact_energy
   use test_contact_point, only: suite_contact_point
   use test_contact_points, only: suite_contact_points
   use test_contact_states, only: suite_contact_states
   use test_contact_tangent, only: suite_contact_tangent
   use test_deck_meshes, only: suite_deck_meshes
   use test_deck_models, only: suite_deck_models
   use test_exponential, only: suite_exponential
   use test_finite, only: suite_finite
   use test_fixed_pieces, only: suite_fixed_pieces
   use test_friction, only: suite_friction
   use test_gaussian_tail, only: suite_gaussian_tail
   use test_hermite_polynomial, only: suite_hermite_polynomial
   use test_hysteresis, only: suite_hysteresis
   use test_hysteresis_borders, only: suite_hysteresis_borders
   use test_hysteresis_envelopes, only: suite_hysteresis_envelopes
   use test_hysteresis_kinds, only: suite_hysteresis_kinds
   use test_hysteresis_programmes, only: suite_hysteresis_programmes
   use test_hysteresis_records, only: suite_hysteresis_records
   use test_hysteresis_samples, only: suite_hysteresis_samples
   use test_hysteresis_skeletons, only: suite_hysteresis_skeletons
   use test_law_table, only: suite_law_table
   use test_map_faults, only: suite_map_faults
   use test_map_files, only: suite_map_files
   use test_map_headers, only: suite_map_headers
   use test_map_layouts, only: suite_map_layouts
   use test_map_numbers, only: suite_map_numbers
   use test_map_x3p, only: suite_map_x3p
   use test_normal_inverse, only: suite_normal_inverse
   use test_normal_law, only: suite_normal_law
   use test_normal_law_reference, only: suite_normal_law_reference
   use test_plausibility, only: suite_plausibility
   use test_presets, only: suite_presets
   use test_press, only: suite_press
   use test_properties, only: suite_properties
   use test_replay_host, only: suite_replay_host
   use test_shear_box, only: suite_shear_box
   use test_single_asperity, only: suite_single_asperity
   use test_sizes, only: suite_sizes
   use test_surface_chain, only: suite_surface_chain
   use test_surface_cholesky, only: suite_surface_cholesky
   use test_surface_fourier, only: suite_surface_fourier
   use test_surface_gaussian_filter, only: suite_surface_gaussian_filter
   use test_surface_holes, only: suite_surface_holes
   use test_surface_level, only: suite_surface_level
   use test_surface_pair, only: suite_surface_pair
   use test_surface_random, only: suite_surface_random
   use test_surface_reference, only: suite_surface_reference
   use test_surface_statistics, only: suite_surface_statistics
   use test_surface_sum_map, only: suite_surface_sum_map
   use test_surface_summits, only: suite_surface_summits
   use test_tenon_energy, only: suite_tenon_energy
   use test_tenon_forms, only: suite_tenon_forms
   use test_tenon_joint, only: suite_tenon_joint
   use test_tenon_solver, only: suite_tenon_solver
   use test_uinter, only: suite_uinter
   use test_validity, only: suite_validity
   use test_vuinter, only: suite_vuinter
   use test_vuinter_agreement, only: suite_vuinter_agreement
   implicit none
   type(TestSuite) :: all_suites
   type(TestRunner) :: runner
   type(TestResult) :: outcome
   integer :: failed

   all_suites = TestSuite('asperity')
   call all_suites%addTest(suite_properties())
   call all_suites%addTest(suite_plausibility())
   call all_suites%addTest(suite_presets())
   call all_suites%addTest(suite_single_asperity())
   call all_suites%addTest(suite_finite())
   call all_suites%addTest(suite_exponential())
   call all_suites%addTest(suite_gaussian_tail())
   call all_suites%addTest(suite_hermite_polynomial())
   call all_suites%addTest(suite_fixed_pieces())
   call all_suites%addTest(suite_normal_law())
   call all_suites%addTest(suite_validity())
   call all_suites%addTest(suite_normal_law_reference())
   call all_suites%addTest(suite_normal_inverse())
   call all_suites%addTest(suite_compiled_law())
   call all_suites%addTest(suite_friction())
   call all_suites%addTest(suite_contact_point())
   call all_suites%addTest(suite_contact_energy())
   call all_suites%addTest(suite_contact_tangent())
   call all_suites%addTest(suite_contact_points())
   call all_suites%addTest(suite_contact_states())
   call all_suites%addTest(suite_compiled_points())
   call all_suites%addTest(suite_compiled_energy())
   call all_suites%addTest(suite_uinter())
   call all_suites%addTest(suite_replay_host())
   call all_suites%addTest(suite_vuinter())
   call all_suites%addTest(suite_vuinter_agreement())
   call all_suites%addTest(suite_press())
   call all_suites%addTest(suite_shear_box())
   call all_suites%addTest(suite_sizes())
   call all_suites%addTest(suite_law_table())
   call all_suites%addTest(suite_deck_meshes())
   call all_suites%addTest(suite_deck_models())
   call all_suites%addTest(suite_map_numbers())
   call all_suites%addTest(suite_map_files())
   call all_suites%addTest(suite_map_layouts())
   call all_suites%addTest(suite_map_headers())
   call all_suites%addTest(suite_map_faults())
   call all_suites%addTest(suite_map_x3p())
   call all_suites%addTest(suite_hysteresis())
   call all_suites%addTest(suite_hysteresis_skeletons())
   call all_suites%addTest(suite_hysteresis_records())
   call all_suites%addTest(suite_hysteresis_programmes())
   call all_suites%addTest(suite_hysteresis_kinds())
   call all_suites%addTest(suite_hysteresis_borders())
   call all_suites%addTest(suite_hysteresis_envelopes())
   call all_suites%addTest(suite_hysteresis_samples())
   call all_suites%addTest(suite_surface_statistics())
   call all_suites%addTest(suite_surface_random())
   call all_suites%addTest(suite_surface_pair())
   call all_suites%addTest(suite_surface_chain())
   call all_suites%addTest(suite_tenon_forms())
   call all_suites%addTest(suite_tenon_energy())
   call all_suites%addTest(suite_tenon_joint())
   call all_suites%addTest(suite_tenon_solver())
   call all_suites%addTest(suite_surface_fourier())
   call all_suites%addTest(suite_surface_cholesky())
   call all_suites%addTest(suite_surface_level())
   call all_suites%addTest(suite_surface_holes())
   call all_suites%addTest(suite_surface_gaussian_filter())
   call all_suites%addTest(suite_surface_summits())
   call all_suites%addTest(suite_surface_sum_map())
   call all_suites%addTest(suite_surface_reference())
   runner = TestRunner()
   outcome = runner%run(all_suites, SerialContext())
   failed = outcome%failureCount() + outcome%errorCount()
   write (*, '(i0, a, i0, a)') outcome%runCount() - failed, ' passed, ', failed, ' failed'
   if (failed > 0 .or. outcome%runCount() == 0) stop 1, quiet=.true.
end program test_main
