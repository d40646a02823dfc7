!> Each fault is found by its rule and by no other.
module test_check_rules
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_cut_back, rule_energy, rule_first_call, &
      rule_guard, rule_names, rule_no_surface, rule_no_traction, rule_perturbation, rule_repeat, &
      rule_rotation, rule_sign, rule_step_size, rule_tangent, rule_two_d, rule_unset_output, &
      severity_error, severity_note, severity_warning
   use asperity_check_settings, only: check_settings
   use asperity_contact_state, only: no_opposite_surface
   use faulty_law, only: absolute, ages_by_increment, always_cuts, counts_calls, damping_left, &
      dissipation_left, dissipation_total, divides, energy_of_increment, fault, first_alone, &
      glued, heat_left, ignores_perturbation, ignores_turn, law, left_in_two_d, never_presses, &
      no_energy, no_fault, perturbation_moves_state, property_beyond, pulls, remembers_points, &
      shear_left_open, shear_reversed, state_beyond, stored_left, tangent_added, tangent_halved, &
      tangent_left, tangent_sign, tangent_symmetric, three_always, viscous_without_time
   use funit, only: assertEqual, assertFalse, TestMethod, TestSuite
   use run_trials, only: findings_of_uinter, text_of
   implicit none
   private
   public :: suite_rules

contains

   function suite_rules() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('rules')
      call suite%addTest(TestMethod('a right law is clean', test_right))
      call suite%addTest(TestMethod('a path of the user', test_path))
      call suite%addTest(TestMethod('unset outputs, graded', test_unset))
      call suite%addTest(TestMethod('guard', test_guard))
      call suite%addTest(TestMethod('tangent', test_tangent))
      call suite%addTest(TestMethod('repeat', test_repeat))
      call suite%addTest(TestMethod('no traction, no surface', test_none))
      call suite%addTest(TestMethod('first call, cut-back', test_calls))
      call suite%addTest(TestMethod('perturbation, rotation, two dimensions', test_procedures))
      call suite%addTest(TestMethod('sign', test_sign))
      call suite%addTest(TestMethod('energy', test_energy))
      call suite%addTest(TestMethod('step size', test_step_size))
   end function suite_rules

   !> K = 100 MPa/mm, shear stiffness 60 MPa/mm, mu = 0.4: slips after 0.067 mm at 0.1 mm.
   pure type(check_settings) function settings_of(ndir) result(settings)
      integer, intent(in) :: ndir

      allocate (settings%properties(3))
      settings%properties = [100.0_wp, 60.0_wp, 0.4_wp]
      settings%nstatv = 5
      settings%ndir = ndir
   end function settings_of

   !> The fault has findings of this rule and severity, and no other.
   subroutine expect(which, name, rule, severity, ndir)
      integer, intent(in) :: which
      character(len=*), intent(in) :: name
      integer, intent(in) :: rule, severity
      integer, intent(in), optional :: ndir
      type(finding_list) :: findings
      integer :: i, n

      fault = which
      n = 0
      if (present(ndir)) n = ndir
      call findings_of_uinter(law, settings_of(n), findings)
      fault = no_fault
      call assertFalse(findings%n == 0, name//': not found')
      do i = 1, findings%n
         if (findings%items(i)%rule == rule .and. findings%items(i)%severity == severity) cycle
         call assertEqual('', text_of(findings), name//': by '//trim(rule_names( &
            findings%items(i)%rule)))
         return
      end do
   end subroutine expect

   subroutine test_right()
      type(finding_list) :: findings
      integer :: ndir

      fault = no_fault
      do ndir = 0, 3
         if (ndir == 1) cycle
         call findings_of_uinter(law, settings_of(ndir), findings)
         call assertEqual('', text_of(findings), 'NDIR '//to_text(ndir))
      end do
   end subroutine test_right

   !> A path that begins without a surface and loses it again: a right law is clean, and a fault
   !> that shows there alone is found.
   subroutine test_path()
      type(check_settings) :: settings
      type(finding_list) :: findings

      settings = settings_of(0)
      settings%path%time = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 5.0_wp, 6.0_wp, 7.0_wp, 8.0_wp]
      settings%path%overclosure = [no_opposite_surface, no_opposite_surface, 0.02_wp, 0.05_wp, &
         0.05_wp, no_opposite_surface, -0.01_wp, 0.03_wp]
      allocate (settings%path%slip(2, 8), source=0.0_wp)
      settings%path%slip(1, 4:) = 0.002_wp
      settings%path%slip(2, 5:) = -0.1_wp
      fault = no_fault
      call findings_of_uinter(law, settings, findings)
      call assertEqual('', text_of(findings))
      fault = tangent_halved
      call findings_of_uinter(law, settings, findings)
      fault = no_fault
      call assertEqual(1, findings%n)
      if (findings%n == 1) call assertEqual(rule_tangent, findings%items(1)%rule)
   end subroutine test_path

   subroutine test_unset()
      call expect(tangent_left, 'DDSDDR(1,2) left', rule_unset_output, severity_error)
      call expect(tangent_added, 'DDSDDR added to', rule_unset_output, severity_error)
      call expect(shear_left_open, 'STRESS(2) left', rule_unset_output, severity_error)
      call expect(damping_left, 'DVISCOUS left', rule_unset_output, severity_warning)
      call expect(heat_left, 'FLUX left', rule_unset_output, severity_warning)
      call expect(dissipation_left, 'SPD left', rule_unset_output, severity_note)
      call expect(stored_left, 'SED left', rule_unset_output, severity_note)
   end subroutine test_unset

   subroutine test_guard()
      call expect(state_beyond, 'written after STATEV', rule_guard, severity_error, ndir=3)
      call expect(state_beyond, 'written after STATEV', rule_guard, severity_error, ndir=2)
      call expect(property_beyond, 'read after PROPS', rule_guard, severity_error)
   end subroutine test_guard

   subroutine test_tangent()
      call expect(tangent_halved, 'half', rule_tangent, severity_error)
      call expect(tangent_sign, 'sign', rule_tangent, severity_error)
      call expect(tangent_symmetric, 'symmetric', rule_tangent, severity_warning)
   end subroutine test_tangent

   subroutine test_repeat()
      call expect(counts_calls, 'counts calls', rule_repeat, severity_error)
      call expect(remembers_points, 'remembers the last point', rule_repeat, severity_error)
   end subroutine test_repeat

   subroutine test_none()
      call expect(never_presses, 'no traction', rule_no_traction, severity_error)
      call expect(glued, 'nothing opposite', rule_no_surface, severity_error)
   end subroutine test_none

   subroutine test_calls()
      call expect(divides, 'divides by DRDISP', rule_first_call, severity_error)
      call expect(first_alone, 'KIT = 0 alone', rule_first_call, severity_error)
      call expect(always_cuts, 'cuts for ever', rule_cut_back, severity_error)
   end subroutine test_calls

   subroutine test_procedures()
      call expect(ignores_perturbation, 'LINPER', rule_perturbation, severity_warning)
      call expect(perturbation_moves_state, 'STATEV', rule_perturbation, severity_warning)
      call expect(ignores_turn, 'DROT', rule_rotation, severity_warning)
      call expect(three_always, 'STRESS(3)', rule_two_d, severity_error)
      call expect(left_in_two_d, 'DDSDDR(1,2)', rule_two_d, severity_error)
   end subroutine test_procedures

   subroutine test_sign()
      call expect(pulls, 'pulls', rule_sign, severity_error)
      call expect(absolute, 'absolute value', rule_sign, severity_error)
      call expect(shear_reversed, 'shear', rule_sign, severity_error)
   end subroutine test_sign

   subroutine test_energy()
      call expect(energy_of_increment, 'SED of the increment', rule_energy, severity_warning)
      call expect(dissipation_total, 'SFD in total', rule_energy, severity_warning)
      call expect(no_energy, 'zeros', rule_energy, severity_note)
   end subroutine test_energy

   subroutine test_step_size()
      call expect(ages_by_increment, 'ages', rule_step_size, severity_error)
      call expect(viscous_without_time, 'viscous', rule_step_size, severity_error)
   end subroutine test_step_size

end module test_check_rules
