!> Tests of src/law.
program test_law
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_law_compile_range, only: suite_compile_range
   use test_law_compiled_energy, only: suite_compiled_energy
   use test_law_compiled_law, only: suite_compiled_law
   use test_law_compiled_unloading, only: suite_compiled_unloading
   use test_law_compiled_unloading_limits, only: suite_compiled_unloading_limits
   use test_law_exponential, only: suite_exponential
   use test_law_fixed_pieces, only: suite_fixed_pieces
   use test_law_gaussian_tail, only: suite_gaussian_tail
   use test_law_hermite_polynomial, only: suite_hermite_polynomial
   use test_law_johnson, only: suite_johnson
   use test_law_normal_inverse, only: suite_normal_inverse
   use test_law_normal_law, only: suite_normal_law
   use test_law_normal_law_reference, only: suite_normal_law_reference
   use test_law_normal_properties, only: suite_properties
   use test_law_pairs, only: suite_presets
   use test_law_plastic_ratio, only: suite_plastic_ratio
   use test_law_plausibility, only: suite_plausibility
   use test_law_single_asperity, only: suite_single_asperity
   use test_law_unloading_energy, only: suite_unloading_energy
   use test_law_unloading_law, only: suite_unloading_law
   use test_law_unloading_reference, only: suite_unloading_reference
   use test_law_unloading_summit, only: suite_unloading_summit
   use test_law_validity, only: suite_validity
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('law')
   call suite%addTest(suite_properties())
   call suite%addTest(suite_plausibility())
   call suite%addTest(suite_presets())
   call suite%addTest(suite_single_asperity())
   call suite%addTest(suite_exponential())
   call suite%addTest(suite_gaussian_tail())
   call suite%addTest(suite_hermite_polynomial())
   call suite%addTest(suite_fixed_pieces())
   call suite%addTest(suite_normal_law())
   call suite%addTest(suite_validity())
   call suite%addTest(suite_normal_law_reference())
   call suite%addTest(suite_normal_inverse())
   call suite%addTest(suite_compiled_law())
   call suite%addTest(suite_compile_range())
   call suite%addTest(suite_plastic_ratio())
   call suite%addTest(suite_johnson())
   call suite%addTest(suite_compiled_energy())
   call suite%addTest(suite_compiled_unloading())
   call suite%addTest(suite_compiled_unloading_limits())
   call suite%addTest(suite_unloading_summit())
   call suite%addTest(suite_unloading_law())
   call suite%addTest(suite_unloading_energy())
   call suite%addTest(suite_unloading_reference())
   call run_suite(suite)
end program test_law
