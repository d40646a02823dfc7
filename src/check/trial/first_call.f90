!> Rule `first_call`: in its first call of an increment ABAQUS passes DRDISP = 0 and the last
!> converged RDISP, which must give numbers; and no answer may rest on what that call alone does.
module asperity_check_trial_first_call
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine, repeats
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_layout, only: entry_name, is_input
   use asperity_check_driven_paths, only: main_path, motion_sizes, sizes_of
   use asperity_check_driven_point, only: has_surface, motion_to, point_answer, point_motion
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_first_call, severity_error
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_first_call

   !> Tractions of two iterations with the same motion may differ by this, of the largest one
   real(wp), parameter :: tolerance = 1.0e-9_wp
   !> A motion that is nearly none, of the sizes of the motion; and what tractions may change over
   !> it, of the largest one
   real(wp), parameter :: nearly_none = 1.0e-8_wp, jump = 1.0e-3_wp

contains

   !> Run the trial.
   subroutine check_first_call(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      integer :: i, found_before

      found_before = findings%n
      call drive(routine, main_path(settings), 1, record)
      do i = 1, record%n
         call try_item(routine, sizes_of(settings), record%items(i), largest_stress(record), &
            findings)
         if (findings%n > found_before) return
      end do
      if (record%unusable) call try_item(routine, sizes_of(settings), record%refused, &
         largest_stress(record), findings)
   end subroutine check_first_call

   subroutine try_item(routine, sizes, item, largest, findings)
      type(driven_routine), intent(in) :: routine
      type(motion_sizes), intent(in) :: sizes
      type(driven_increment), intent(in) :: item
      real(wp), intent(in) :: largest
      type(finding_list), intent(inout) :: findings
      type(point_answer) :: still, first
      type(point_motion) :: motion
      integer :: i, k, found_before

      found_before = findings%n
      call call_routine(routine, item%start, motion_to(item%start, item%start%rdisp, &
         item%motion%dtime, kit=0), still)
      do i = 1, size(routine%layout%slots)
         associate (slot => routine%layout%slots(i))
            if (slot%role == is_input) cycle
            do k = 1, slot%length
               if (is_finite(still%numbers(slot%number + k - 1))) cycle
               call findings%add(rule_first_call, severity_error, entry_name(slot, k)// &
                  ' with DRDISP = 0 at the start of '//place_of(item), 'a number', &
                  to_text(still%numbers(slot%number + k - 1)), &
                  'the first call of every increment has DRDISP = 0: the job fails at once')
               return
            end do
         end associate
      end do
      call check_jump(routine, sizes, item, still, largest, findings)
      if (findings%n > found_before) return
      if (.not. repeats(routine, item%start, item%motion)) return
      motion = item%motion
      motion%kit = 0
      call call_routine(routine, item%start, motion, first)
      if (.not. all(is_finite([first%stress, item%answer%stress]))) return
      if (all(abs(first%stress - item%answer%stress) <= tolerance*largest)) return
      k = maxloc(abs(first%stress - item%answer%stress), dim=1)
      call findings%add(rule_first_call, severity_error, 'STRESS('//to_text(k)//'), '// &
         place_of(item), 'the same traction in iteration 0 and later, for the same motion', &
         to_text(first%stress(k), 5)//' MPa with KIT = 0, '//to_text(item%answer%stress(k), 5)// &
         ' with KIT = 1', 'what the first call alone sets is gone in the next, which '// &
         'begins from the start again')
   end subroutine try_item

   !> The traction without motion is between those of small motions to both sides, unless these
   !> differ, as at a change of status.
   subroutine check_jump(routine, sizes, item, still, largest, findings)
      type(driven_routine), intent(in) :: routine
      type(motion_sizes), intent(in) :: sizes
      type(driven_increment), intent(in) :: item
      type(point_answer), intent(in) :: still
      real(wp), intent(in) :: largest
      type(finding_list), intent(inout) :: findings
      type(point_answer) :: answers(2)
      real(wp) :: position(3), allowed
      integer :: j, k, side

      if (.not. has_surface(item%start%rdisp(1)) .or. still%pnewdt < 1.0_wp) return
      allowed = jump*largest
      do k = 1, routine%ndir
         do side = 1, 2
            position = item%start%rdisp
            position(k) = position(k) + merge(-nearly_none, nearly_none, side == 1) &
               *merge(sizes%overclosure, sizes%slip, k == 1)
            call call_routine(routine, item%start, motion_to(item%start, position, &
               item%motion%dtime, kit=1), answers(side))
         end do
         if (any(answers%pnewdt < 1.0_wp) .or. .not. (all_finite(answers(1)%stress) &
            .and. all_finite(answers(2)%stress))) cycle
         do j = 1, routine%ndir
            associate (left => answers(1)%stress(j), right => answers(2)%stress(j))
               if (.not. abs(left - right) <= allowed) cycle
               if (abs(still%stress(j) - left) <= allowed) cycle
               call findings%add(rule_first_call, severity_error, 'STRESS('//to_text(j)// &
                  ') with DRDISP = 0 at the start of '//place_of(item), to_text(left, 5)// &
                  ' MPa, as with the smallest motion', to_text(still%stress(j), 5)//' MPa', &
                  'the first call of every increment has DRDISP = 0: it begins from other '// &
                  'forces than the last one ended with')
               return
            end associate
         end do
      end do
   end subroutine check_jump

end module asperity_check_trial_first_call
