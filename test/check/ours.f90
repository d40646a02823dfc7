!> The project's own UINTER and VUINTER, in all their settings, without a finding.
module test_check_ours
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, friction_settings, rule_abaqus, rule_dissipative, &
      slip_backward_euler, slip_exact, stick_summits, unloading_elastic, unloading_reversible, wp
   use asperity_abaqus_props, only: props_from_properties
   use asperity_abaqus_statev, only: statev_needed
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list
   use asperity_check_settings, only: check_settings
   use contact_cases, only: pair_properties, random_contact
   use friction_cases, only: friction_properties, kinds, random_friction
   use funit, only: anyExceptions, assertEqual, TestMethod, TestSuite
   use random_inputs, only: random_stream
   use run_trials, only: findings_of_uinter, findings_of_vuinter, text_of
   implicit none
   private
   public :: suite_ours

   procedure(uinter_interface) :: uinter
   procedure(vuinter_interface) :: vuinter
   integer(int64), parameter :: seed = 31415926_int64
   integer, parameter :: n_random = 16

contains

   function suite_ours() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('ours')
      call suite%addTest(TestMethod('the pairs, both rules and integrations', test_pairs))
      call suite%addTest(TestMethod('memory', test_memory))
      call suite%addTest(TestMethod('friction of every kind', test_friction))
      call suite%addTest(TestMethod('summits that stick each for itself', test_summits))
      call suite%addTest(TestMethod('random contacts', test_random))
      call suite%addTest(TestMethod('far slip and small steps', test_sizes))
   end function suite_ours

   !> Metals to wood, pressed until the mean planes meet.
   subroutine test_random()
      type(random_stream) :: stream
      type(contact_properties) :: p
      integer :: i

      stream = random_stream(seed)
      do i = 1, n_random
         call random_contact(stream, p, 1 + mod(i, 2), 1 + mod(i/2, 2), merge(unloading_elastic, &
            unloading_reversible, mod(i/4, 2) == 1))
         call try(p, 'contact '//to_text(i), slip=p%critical_slip*stream%log_uniform(0.1_wp, &
            10.0_wp), overclosure=max(p%initial_separation, p%normal%sigma))
         if (anyExceptions()) return
      end do
   end subroutine test_random

   !> Both routines without a finding.
   subroutine try(properties, name, slip, overclosure)
      type(contact_properties), intent(in) :: properties
      character(len=*), intent(in) :: name
      real(wp), intent(in), optional :: slip, overclosure
      type(check_settings) :: settings
      type(finding_list) :: findings

      settings%properties = props_from_properties(properties)
      settings%nstatv = statev_needed(properties)
      if (present(slip)) settings%largest_slip = slip
      if (present(overclosure)) settings%largest_overclosure = overclosure
      call findings_of_uinter(uinter, settings, findings)
      call assertEqual('', text_of(findings), name)
      call findings_of_vuinter(vuinter, settings, findings)
      call assertEqual('', text_of(findings), name//', VUINTER')
   end subroutine try

   subroutine test_pairs()
      integer :: rule, integration

      do rule = rule_abaqus, rule_dissipative
         do integration = slip_exact, slip_backward_euler
            call try(pair_properties(rule, integration), 'rule '//to_text(rule)//', '// &
               to_text(integration))
         end do
      end do
      call try(pair_properties(pair='tangential-tangential'), 'another pair')
   end subroutine test_pairs

   subroutine test_memory()
      call try(pair_properties(unloading=unloading_elastic), 'memory')
   end subroutine test_memory

   subroutine test_friction()
      type(random_stream) :: stream
      type(friction_settings) :: settings
      integer, parameter :: rounds = 4
      integer :: kind, i

      stream = random_stream(seed)
      do i = 1, rounds
         do kind = 1, size(kinds)
            call random_friction(stream, kind, 0.5_wp, 0.31_wp, settings)
            call try(friction_properties(settings, 1 + mod(i, 2), 1 + mod(i/2, 2), &
               merge(unloading_elastic, unloading_reversible, i > rounds/2)), &
               trim(kinds(kind))//' '//to_text(i), slip=stream%log_uniform(0.03_wp, 3.0_wp))
            if (anyExceptions()) return
         end do
      end do
   end subroutine test_friction

   subroutine test_summits()
      type(friction_settings) :: settings

      settings = friction_settings(stick=stick_summits, shear_modulus=31.6_wp, stick_elements=8)
      call try(friction_properties(settings), 'summits', slip=0.05_wp)
   end subroutine test_summits

   subroutine test_sizes()
      call try(pair_properties(), 'ten critical slips', slip=3.1_wp)
      call try(pair_properties(), 'a hundredth', slip=0.001_wp, overclosure=0.001_wp)
   end subroutine test_sizes

end module test_check_ours
