!> Tests of src/contact.
program test_contact
   use funit, only: TestSuite
   use run_suites, only: run_suite
   use test_contact_compiled_memory, only: suite_compiled_memory
   use test_contact_compiled_points, only: suite_compiled_points
   use test_contact_energy, only: suite_contact_energy
   use test_contact_friction, only: suite_friction
   use test_contact_friction_settings, only: suite_friction_settings
   use test_contact_general_friction, only: suite_general_friction
   use test_contact_general_path, only: suite_general_path
   use test_contact_general_tangent, only: suite_general_tangent
   use test_contact_memory, only: suite_contact_memory
   use test_contact_point, only: suite_contact_point
   use test_contact_points, only: suite_contact_points
   use test_contact_properties, only: suite_contact_properties
   use test_contact_slip_path, only: suite_slip_path
   use test_contact_states, only: suite_contact_states
   use test_contact_stick_elements, only: suite_stick_elements
   use test_contact_summit_stick, only: suite_summit_stick
   use test_contact_summit_stick_update, only: suite_summit_stick_update
   use test_contact_tangent, only: suite_contact_tangent
   implicit none
   type(TestSuite) :: suite

   suite = TestSuite('contact')
   call suite%addTest(suite_slip_path())
   call suite%addTest(suite_friction())
   call suite%addTest(suite_friction_settings())
   call suite%addTest(suite_general_friction())
   call suite%addTest(suite_general_path())
   call suite%addTest(suite_general_tangent())
   call suite%addTest(suite_contact_properties())
   call suite%addTest(suite_contact_point())
   call suite%addTest(suite_contact_energy())
   call suite%addTest(suite_contact_tangent())
   call suite%addTest(suite_contact_memory())
   call suite%addTest(suite_contact_points())
   call suite%addTest(suite_contact_states())
   call suite%addTest(suite_stick_elements())
   call suite%addTest(suite_summit_stick())
   call suite%addTest(suite_summit_stick_update())
   call suite%addTest(suite_compiled_points())
   call suite%addTest(suite_compiled_memory())
   call run_suite(suite)
end program test_contact
