!> The list of findings.
module test_check_findings
   use asperity_check_finding, only: finding_list, n_rules, rule_guard, rule_names, rule_tangent, &
      rule_timeout, severity_error, severity_note
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_findings

contains

   function suite_findings() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('findings')
      call suite%addTest(TestMethod('one rule at one place is one finding', test_once))
      call suite%addTest(TestMethod('rules have their names', test_names))
   end function suite_findings

   subroutine test_once()
      type(finding_list) :: list
      character(len=8) :: place
      integer :: i

      do i = 1, 40
         write (place, '(a, i0)') 'place ', mod(i, 20)
         call list%add(rule_guard, severity_error, trim(place), 'a', 'b', 'c')
      end do
      call assertEqual(20, list%n)
      call list%add(rule_tangent, severity_note, 'place 1', 'a', 'b', 'c')
      call assertEqual(21, list%n)
      call assertEqual('place 0', list%items(20)%place)
      call assertEqual(severity_note, list%items(21)%severity)
   end subroutine test_once

   subroutine test_names()
      integer :: i

      call assertEqual('guard', trim(rule_names(rule_guard)))
      call assertEqual('timeout', trim(rule_names(rule_timeout)))
      do i = 2, n_rules
         call assertTrue(all(rule_names(:i - 1) /= rule_names(i)))
      end do
   end subroutine test_names

end module test_check_findings
