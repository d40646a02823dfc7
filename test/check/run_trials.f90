!> Runs all trials of a routine, for the tests.
module run_trials
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_check_finding, only: finding_list, rule_names, severity_names
   use asperity_check_settings, only: check_settings
   use asperity_check_trials, only: run_uinter_trial, run_vuinter_trial, uinter_trials, &
      vuinter_trials
   implicit none
   private
   public :: findings_of_uinter, findings_of_vuinter, text_of

contains

   subroutine findings_of_uinter(routine, settings, findings)
      procedure(uinter_interface) :: routine
      type(check_settings), intent(in) :: settings
      type(finding_list), intent(out) :: findings
      integer :: i

      do i = 1, size(uinter_trials)
         call run_uinter_trial(i, routine, settings, findings)
      end do
   end subroutine findings_of_uinter

   subroutine findings_of_vuinter(routine, settings, findings)
      procedure(vuinter_interface) :: routine
      type(check_settings), intent(in) :: settings
      type(finding_list), intent(out) :: findings
      integer :: i

      do i = 1, size(vuinter_trials)
         call run_vuinter_trial(i, routine, settings, findings)
      end do
   end subroutine findings_of_vuinter

   !> All findings, a line each.
   function text_of(findings) result(text)
      type(finding_list), intent(in) :: findings
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, findings%n
         associate (f => findings%items(i))
            text = text//new_line('a')//trim(rule_names(f%rule))//' '// &
               trim(severity_names(f%severity))//' | '//f%place//' | '//f%expected//' | '// &
               f%found//' | '//f%effect
         end associate
      end do
   end function text_of

end module run_trials
