!> Rule `rotation`: when the slip directions turn (DROT) and nothing else moves, the shear turns
!> with them. RDISP is given in the turned directions, as ABAQUS gives it.
module asperity_check_trial_rotation
   use asperity_base_finite, only: all_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_left, only: stress_left
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: has_surface, motion_to, next_start, point_answer, &
      point_motion, point_start
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_rotation, severity_warning
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_rotation

   !> A quarter turn: the first direction's shear becomes the second's
   real(wp), parameter :: quarter(2, 2) = reshape([0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp], [2, 2])
   !> What the shear may be off, of its size; single precision has no more digits
   real(wp), parameter :: tolerance = 1.0e-5_wp

contains

   !> Run the trial, in three dimensions.
   subroutine check_rotation(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      integer :: i, found_before

      if (routine%ndir /= 3) return
      found_before = findings%n
      call drive(routine, main_path(settings), 1, record)
      do i = 1, record%n
         if (.not. has_surface(record%items(i)%motion%rdisp(1))) cycle
         ! a shear that is never set is another rule's
         if (any(stress_left(routine, record%items(i), largest_stress(record)))) cycle
         call turn(routine, record%items(i), findings)
         if (findings%n > found_before) return
      end do
   end subroutine check_rotation

   !> Turn after an increment, and compare with the same time without a turn.
   subroutine turn(routine, item, findings)
      type(driven_routine), intent(in) :: routine
      type(driven_increment), intent(in) :: item
      type(finding_list), intent(inout) :: findings
      type(point_start) :: start
      type(point_motion) :: motion
      type(point_answer) :: still, turned
      real(wp) :: expected(2), shear

      call next_start(item%start, item%motion, item%answer, start)
      motion = motion_to(start, start%rdisp, item%motion%dtime, kit=1)
      call call_routine(routine, start, motion, still)
      motion%drot = quarter
      motion%rdisp(2:3) = matmul(quarter, motion%rdisp(2:3))
      call call_routine(routine, start, motion, turned)
      if (.not. all_finite(still%stress) .or. .not. all_finite(turned%stress)) return
      expected = matmul(quarter, still%stress(2:3))
      shear = hypot(expected(1), expected(2))
      if (all(abs(turned%stress(2:3) - expected) <= tolerance*max(shear, &
            maxval(abs(turned%stress))))) return
      call findings%add(rule_rotation, severity_warning, 'STRESS(2:3) turned by DROT after '// &
         place_of(item), to_text(expected(1), 5)//' and '//to_text(expected(2), 5)//' MPa', &
         to_text(turned%stress(2), 5)//' and '//to_text(turned%stress(3), 5)//' MPa', &
         'where contact turns by a finite angle, the shear points in a wrong direction')
   end subroutine turn

end module asperity_check_trial_rotation
