!> Rule `rotation`: when the slip directions turn (DROT) and nothing else moves, the shear turns
!> with them. RDISP is given in the turned directions, as ABAQUS gives it. Friction with axes of its
!> own, which turn with the slip directions, answers otherwise after a quarter turn: half a turn is
!> then tried, which shows no wrong sense.
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
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_rotation

   !> A quarter turn: the first direction's shear becomes the second's
   real(wp), parameter :: quarter(2, 2) = reshape([0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp], [2, 2])
   !> Half a turn
   real(wp), parameter :: half(2, 2) = reshape([-1.0_wp, 0.0_wp, 0.0_wp, -1.0_wp], [2, 2])
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
      type(motion_path) :: path
      real(wp) :: rotation(2, 2)
      integer :: i, found_before

      if (routine%ndir /= 3) return
      found_before = findings%n
      path = main_path(settings)
      call drive(routine, path, 1, record)
      rotation = quarter
      if (.not. turns_with_path(routine, path, record, rotation)) rotation = half
      if (.not. turns_with_path(routine, path, record, rotation)) return
      do i = 1, record%n
         if (.not. has_surface(record%items(i)%motion%rdisp(1))) cycle
         ! a shear that is never set is another rule's
         if (any(stress_left(routine, record%items(i), largest_stress(record)))) cycle
         call turn(routine, record%items(i), rotation, findings)
         if (findings%n > found_before) return
      end do
   end subroutine check_rotation

   !> Whether a law answers a turned path with turned shear.
   logical function turns_with_path(routine, path, record, rotation) result(turns)
      type(driven_routine), intent(in) :: routine
      type(motion_path), intent(in) :: path
      !> Along the path as it is
      type(drive_record), intent(in) :: record
      real(wp), intent(in) :: rotation(2, 2)
      type(motion_path) :: turned_path
      type(drive_record) :: turned
      integer :: i

      turned_path = path
      turned_path%slip = matmul(rotation, path%slip)
      call drive(routine, turned_path, 1, turned)
      turns = turned%n == record%n
      if (.not. turns) return
      do i = 1, record%n
         turns = turns .and. all(abs(turned%items(i)%answer%stress(2:3) - matmul(rotation, &
            record%items(i)%answer%stress(2:3))) <= tolerance*largest_stress(record))
      end do
   end function turns_with_path

   !> Turn after an increment, and compare with the same time without a turn.
   subroutine turn(routine, item, rotation, findings)
      type(driven_routine), intent(in) :: routine
      type(driven_increment), intent(in) :: item
      real(wp), intent(in) :: rotation(2, 2)
      type(finding_list), intent(inout) :: findings
      type(point_start) :: start
      type(point_motion) :: motion
      type(point_answer) :: still, turned
      real(wp) :: expected(2), shear

      call next_start(item%start, item%motion, item%answer, start)
      motion = motion_to(start, start%rdisp, item%motion%dtime, kit=1)
      call call_routine(routine, start, motion, still)
      motion%drot = rotation
      motion%rdisp(2:3) = matmul(rotation, motion%rdisp(2:3))
      call call_routine(routine, start, motion, turned)
      if (.not. all_finite(still%stress) .or. .not. all_finite(turned%stress)) return
      expected = matmul(rotation, still%stress(2:3))
      shear = hypot(expected(1), expected(2))
      if (all(abs(turned%stress(2:3) - expected) <= tolerance*max(shear, &
            maxval(abs(turned%stress))))) return
      call findings%add(rule_rotation, severity_warning, 'STRESS(2:3) turned by DROT after '// &
         place_of(item), to_text(expected(1), 5)//' and '//to_text(expected(2), 5)//' MPa', &
         to_text(turned%stress(2), 5)//' and '//to_text(turned%stress(3), 5)//' MPa', &
         'where contact turns by a finite angle, the shear points in a wrong direction')
   end subroutine turn

end module asperity_check_trial_rotation
