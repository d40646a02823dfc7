!> Tests of src/deck.
program test_deck
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_deck_law_rows, only: suite_law_table
   use test_deck_meshes, only: suite_deck_meshes
   use test_deck_models, only: suite_deck_models
   use test_deck_solver_friction, only: suite_solver_friction
   use test_deck_uinter_lines, only: suite_uinter_lines
   use test_deck_wood, only: suite_deck_wood
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('deck')
   call suite%addTest(suite_law_table())
   call suite%addTest(suite_deck_meshes())
   call suite%addTest(suite_deck_models())
   call suite%addTest(suite_deck_wood())
   call suite%addTest(suite_solver_friction())
   call suite%addTest(suite_uinter_lines())
   call run_suite(suite)
end program test_deck
