!> Tests of src/faces and of the sections of wood.
program test_faces
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_faces_aged_pair, only: suite_faces_aged_pair
   use test_faces_ageing, only: suite_faces_ageing
   use test_faces_sections, only: suite_faces_sections
   use test_faces_two_faces, only: suite_faces_two_faces
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('faces')
   call suite%addTest(suite_faces_sections())
   call suite%addTest(suite_faces_two_faces())
   call suite%addTest(suite_faces_ageing())
   call suite%addTest(suite_faces_aged_pair())
   call run_suite(suite)
end program test_faces
