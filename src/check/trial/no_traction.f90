!> Rule `no_traction`: somewhere on the path there is a pressure, and all tractions are numbers.
module asperity_check_trial_no_traction
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, place_of
   use asperity_check_driven_layout, only: entry_name
   use asperity_check_driven_paths, only: main_path, motion_sizes, sizes_of
   use asperity_check_driven_point, only: is_usable, motion_to, point_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_no_traction, severity_error
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_no_traction

contains

   !> Run the trial.
   subroutine check_no_traction(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(motion_sizes) :: sizes
      integer :: i

      call drive(routine, main_path(settings), 1, record)
      if (record%unusable) call report_no_number(routine, record, findings)
      if (record%stuck .or. record%unusable) return
      do i = 1, record%n
         if (abs(record%items(i)%answer%stress(1)) > 0.0_wp) return
      end do
      sizes = sizes_of(settings)
      call findings%add(rule_no_traction, severity_error, 'STRESS(1), whole path', &
         'a pressure at an overclosure of up to '//to_text(sizes%overclosure, 3)//' mm', &
         'none at all (if the law acts at other lengths, say how far the faces move)', &
         'the faces pass through each other without a force, and the job ends as if all were well')
   end subroutine check_no_traction

   !> What is no number, unless it is so without motion too, which is another rule's.
   subroutine report_no_number(routine, record, findings)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      type(finding_list), intent(inout) :: findings
      type(point_answer) :: still
      integer :: i, k

      associate (item => record%refused)
         call call_routine(routine, item%start, motion_to(item%start, item%start%rdisp, &
            item%motion%dtime, kit=0), still)
         if (.not. is_usable(still)) return
         do i = 1, size(routine%layout%slots)
            associate (slot => routine%layout%slots(i))
               do k = 1, slot%length
                  if (is_finite(item%answer%numbers(slot%number + k - 1))) cycle
                  call findings%add(rule_no_traction, severity_error, place_of(item), &
                     'a number in '//entry_name(slot, k), &
                     to_text(item%answer%numbers(slot%number + k - 1)), &
                     'the job fails to converge, or ends (if the faces never come so close, '// &
                     'say how far they move)')
                  return
               end do
            end associate
         end do
      end associate
   end subroutine report_no_number

end module asperity_check_trial_no_traction
