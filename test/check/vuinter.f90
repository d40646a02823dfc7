!> Faults of a VUINTER, each found by its rule and by no other.
module test_check_vuinter
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_energy, rule_guard, rule_names, &
      rule_no_surface, rule_no_traction, rule_repeat, rule_rotation, rule_sign, rule_step_size, &
      rule_unset_output, severity_error, severity_note, severity_warning
   use asperity_check_settings, only: check_settings
   use explicit_law, only: ages_by_increment, counts_calls, energy_left, energy_of_increment, &
      explicit, explicit_in_single, fault, first_node_alone, flux_left, glued, ignores_turn, &
      never_presses, no_fault, pulls, shares_pressure, state_beyond, stress_left
   use funit, only: assertEqual, assertFalse, TestMethod, TestSuite
   use run_trials, only: findings_of_vuinter, text_of
   implicit none
   private
   public :: suite_check_vuinter

contains

   function suite_check_vuinter() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('VUINTER')
      call suite%addTest(TestMethod('a right law is clean', test_right))
      call suite%addTest(TestMethod('in single precision', test_single))
      call suite%addTest(TestMethod('each fault by its rule', test_faults))
   end function suite_check_vuinter

   subroutine set(settings, ndir)
      type(check_settings), intent(out) :: settings
      integer, intent(in) :: ndir

      allocate (settings%properties(3))
      settings%properties = [100.0_wp, 60.0_wp, 0.4_wp]
      settings%nstatv = 4
      settings%ndir = ndir
   end subroutine set

   subroutine test_right()
      type(check_settings) :: settings
      type(finding_list) :: findings
      integer :: ndir

      fault = no_fault
      do ndir = 0, 3
         if (ndir == 1) cycle
         call set(settings, ndir)
         call findings_of_vuinter(explicit, settings, findings)
         call assertEqual('', text_of(findings), 'NDIR '//to_text(ndir))
      end do
   end subroutine test_right

   subroutine test_single()
      type(check_settings) :: settings
      type(finding_list) :: findings

      fault = no_fault
      call set(settings, 0)
      settings%single_precision = .true.
      call findings_of_vuinter(explicit_in_single(), settings, findings)
      call assertEqual('', text_of(findings))
      fault = flux_left
      call findings_of_vuinter(explicit_in_single(), settings, findings)
      fault = no_fault
      call assertEqual(1, findings%n)
      if (findings%n == 1) call assertEqual('fluxMst', findings%items(1)%place)
   end subroutine test_single

   !> The fault has findings of this rule and severity, and no other.
   subroutine expect(which, name, rule, severity)
      integer, intent(in) :: which
      character(len=*), intent(in) :: name
      integer, intent(in) :: rule, severity
      type(check_settings) :: settings
      type(finding_list) :: findings
      integer :: i

      fault = which
      call set(settings, 0)
      call findings_of_vuinter(explicit, settings, findings)
      fault = no_fault
      call assertFalse(findings%n == 0, name//': not found')
      do i = 1, findings%n
         if (findings%items(i)%rule == rule .and. findings%items(i)%severity == severity) cycle
         call assertEqual('', text_of(findings), name//': by '//trim(rule_names( &
            findings%items(i)%rule)))
         return
      end do
   end subroutine expect

   subroutine test_faults()
      call expect(flux_left, 'flux left', rule_unset_output, severity_warning)
      call expect(energy_left, 'energy left', rule_unset_output, severity_note)
      call expect(stress_left, 'shear left', rule_unset_output, severity_error)
      call expect(state_beyond, 'written after STATEV', rule_guard, severity_error)
      call expect(first_node_alone, 'first node alone', rule_repeat, severity_error)
      call expect(shares_pressure, 'nodes share', rule_repeat, severity_error)
      call expect(counts_calls, 'counts calls', rule_repeat, severity_error)
      call expect(never_presses, 'no traction', rule_no_traction, severity_error)
      call expect(glued, 'nothing opposite', rule_no_surface, severity_error)
      call expect(ignores_turn, 'DROT', rule_rotation, severity_warning)
      call expect(pulls, 'pulls', rule_sign, severity_error)
      call expect(energy_of_increment, 'SED of the increment', rule_energy, severity_warning)
      call expect(ages_by_increment, 'ages', rule_step_size, severity_error)
   end subroutine test_faults

end module test_check_vuinter
