!> Rule `cut_back`: where a routine asks for a shorter increment, a shorter one is through, and it
!> asks for none where nothing moves.
module asperity_check_trial_cut_back
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, place_of
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: motion_to, point_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_cut_back, severity_error
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_cut_back

   character(len=*), parameter :: effect = &
      'ABAQUS cuts the increment until it gives up, and the job ends'

contains

   !> Run the trial.
   subroutine check_cut_back(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(point_answer) :: still
      integer :: i

      call drive(routine, main_path(settings), 1, record)
      if (record%stuck) then
         associate (item => record%refused)
            call findings%add(rule_cut_back, severity_error, 'PNEWDT, '//place_of(item), &
               '1 or more in an increment that is short enough', to_text(item%answer%pnewdt, 3)// &
               ' still in one of '//to_text(item%motion%dtime, 3)//' s', effect)
         end associate
         return
      end if
      do i = 1, record%n
         associate (item => record%items(i))
            call call_routine(routine, item%start, motion_to(item%start, item%start%rdisp, &
               item%motion%dtime, kit=0), still)
            if (still%pnewdt >= 1.0_wp) cycle
            call findings%add(rule_cut_back, severity_error, 'PNEWDT with DRDISP = 0 at the '// &
               'start of '//place_of(item), '1 or more where nothing moves', &
               to_text(still%pnewdt, 3), effect)
            return
         end associate
      end do
   end subroutine check_cut_back

end module asperity_check_trial_cut_back
