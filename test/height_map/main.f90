!> Tests of src/height_map.
program test_height_map
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_height_map_binary, only: suite_map_binary
   use test_height_map_exports, only: suite_map_exports
   use test_height_map_faults, only: suite_map_faults
   use test_height_map_files, only: suite_map_files
   use test_height_map_formats, only: suite_map_formats
   use test_height_map_grids, only: suite_map_grids
   use test_height_map_headers, only: suite_map_headers
   use test_height_map_layouts, only: suite_map_layouts
   use test_height_map_limits, only: suite_limits
   use test_height_map_numbers, only: suite_map_numbers
   use test_height_map_profiles, only: suite_map_profiles
   use test_height_map_x3p, only: suite_map_x3p
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('height_map')
   call suite%addTest(suite_map_numbers())
   call suite%addTest(suite_map_files())
   call suite%addTest(suite_map_layouts())
   call suite%addTest(suite_map_headers())
   call suite%addTest(suite_map_grids())
   call suite%addTest(suite_map_exports())
   call suite%addTest(suite_map_profiles())
   call suite%addTest(suite_map_faults())
   call suite%addTest(suite_map_x3p())
   call suite%addTest(suite_map_binary())
   call suite%addTest(suite_map_formats())
   call suite%addTest(suite_limits())
   call run_suite(suite)
end program test_height_map
