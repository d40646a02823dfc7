!> Tests of src/surface.
program test_surface
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_surface_chain, only: suite_surface_chain
   use test_surface_fill_holes, only: suite_surface_holes
   use test_surface_fourier, only: suite_surface_fourier
   use test_surface_gaussian_filter, only: suite_surface_gaussian_filter
   use test_surface_heights_remarks, only: suite_surface_heights_remarks
   use test_surface_level, only: suite_surface_level
   use test_surface_pair, only: suite_surface_pair
   use test_surface_profiles, only: suite_surface_profiles
   use test_surface_random, only: suite_surface_random
   use test_surface_reference, only: suite_surface_reference
   use test_surface_remarks, only: suite_surface_remarks
   use test_surface_robust_filter, only: suite_surface_robust_filter
   use test_surface_statistics, only: suite_surface_statistics
   use test_surface_sum_tiles, only: suite_surface_sum_map
   use test_surface_summits, only: suite_surface_summits
   use test_surface_unloading, only: suite_surface_unloading
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('surface')
   call suite%addTest(suite_surface_statistics())
   call suite%addTest(suite_surface_random())
   call suite%addTest(suite_surface_pair())
   call suite%addTest(suite_surface_unloading())
   call suite%addTest(suite_surface_chain())
   call suite%addTest(suite_surface_fourier())
   call suite%addTest(suite_surface_level())
   call suite%addTest(suite_surface_holes())
   call suite%addTest(suite_surface_gaussian_filter())
   call suite%addTest(suite_surface_robust_filter())
   call suite%addTest(suite_surface_profiles())
   call suite%addTest(suite_surface_summits())
   call suite%addTest(suite_surface_sum_map())
   call suite%addTest(suite_surface_reference())
   call suite%addTest(suite_surface_remarks())
   call suite%addTest(suite_surface_heights_remarks())
   call run_suite(suite)
end program test_surface
