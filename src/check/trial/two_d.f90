!> Rule `two_d`: with NDIR = 2 and MCRD = 2 a routine writes to two components alone, sets all of
!> their outputs, and answers as in three dimensions without slip in the third direction.
module asperity_check_trial_two_d
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine, repeats
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_layout, only: entry_name, is_output, same_bits
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: point_answer, same_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_two_d, severity_error, severity_warning
   use asperity_check_settings, only: check_settings
   use asperity_check_trial_guard, only: damage_text
   use asperity_check_trial_tangent, only: check_tangent
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_two_d

   !> What tractions may be off those in three dimensions, of the largest: rounding, with room for a
   !> routine in single precision
   real(wp), parameter :: tolerance = 1.0e-5_wp

contains

   !> Run the trial.
   subroutine check_two_d(plane, solid, settings, findings)
      !> The routine with two components and with three
      type(driven_routine), intent(in) :: plane, solid
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(motion_path) :: path
      type(drive_record) :: record, full
      real(wp) :: largest
      integer :: i, found_before

      found_before = findings%n
      path = main_path(settings)
      path%slip(2, :) = 0.0_wp
      call drive(plane, path, 1, record)
      call drive(solid, path, 1, full)
      do i = 1, record%n
         if (is_damaged_too(full, record%items(i)%answer)) cycle
         call check_damage(plane, record%items(i), findings)
      end do
      if (findings%n > found_before) return
      do i = 1, record%n
         if (i > full%n) exit
         call check_unset(plane, solid, record%items(i), full%items(i), findings)
      end do
      if (findings%n > found_before) return
      largest = largest_stress(full)
      do i = 1, min(record%n, full%n)
         associate (item => record%items(i))
            if (all(abs(item%answer%stress(:2) - full%items(i)%answer%stress(:2)) &
                  <= tolerance*largest)) cycle
            if (.not. repeats(plane, item%start, item%motion)) return
            call findings%add(rule_two_d, severity_warning, 'STRESS with NDIR = 2, '// &
               place_of(item), text_of(full%items(i)%answer)//', as with NDIR = 3 and the same '// &
               'motion', text_of(item%answer), 'two-dimensional models answer otherwise than '// &
               'three-dimensional ones of the same motion')
            return
         end associate
      end do
      if (record%n < full%n) call findings%add(rule_two_d, severity_error, 'NDIR = 2, '// &
         place_of(record%refused), 'an answer, as with NDIR = 3 and the same motion', 'none', &
         'two-dimensional models do not get through')
      if (findings%n == found_before .and. associated(plane%uinter)) &
         call check_stiffness(plane, solid, settings, findings)
   end subroutine check_two_d

   !> A tangent that is right in three dimensions alone.
   subroutine check_stiffness(plane, solid, settings, findings)
      type(driven_routine), intent(in) :: plane, solid
      type(check_settings), intent(in) :: settings
      type(finding_list), intent(inout) :: findings
      type(finding_list) :: of_plane, of_solid

      call check_tangent(solid, settings, of_solid)
      call check_tangent(plane, settings, of_plane)
      if (of_plane%n == 0 .or. of_solid%n > 0) return
      associate (f => of_plane%items(1))
         call findings%add(rule_two_d, f%severity, f%place//', with NDIR = 2', f%expected, &
            f%found, f%effect)
      end associate
   end subroutine check_stiffness

   function text_of(answer) result(text)
      type(point_answer), intent(in) :: answer
      character(len=:), allocatable :: text

      text = to_text(answer%stress(1), 5)//' and '//to_text(answer%stress(2), 5)//' MPa'
   end function text_of

   !> Whether the same argument is written to wrongly in three dimensions, which is another rule's.
   pure logical function is_damaged_too(full, answer)
      type(drive_record), intent(in) :: full
      type(point_answer), intent(in) :: answer
      integer :: i

      is_damaged_too = .false.
      do i = 1, full%n
         is_damaged_too = is_damaged_too .or. full%items(i)%answer%damaged_slot &
            == answer%damaged_slot .and. full%items(i)%answer%changed == answer%changed
      end do
   end function is_damaged_too

   subroutine check_damage(routine, item, findings)
      type(driven_routine), intent(in) :: routine
      type(driven_increment), intent(in) :: item
      type(finding_list), intent(inout) :: findings

      if (item%answer%damaged_slot == 0 .and. item%answer%changed == '') return
      call findings%add(rule_two_d, severity_error, damage_text(routine, item%answer)// &
         ', with NDIR = 2', 'nothing is written there', 'written to in '//place_of(item), &
         'in two-dimensional models memory that is not the routine''s is overwritten')
   end subroutine check_damage

   !> What is left in two dimensions and set in three.
   subroutine check_unset(plane, solid, flat_item, item, findings)
      type(driven_routine), intent(in) :: plane, solid
      type(driven_increment), intent(in) :: flat_item, item
      type(finding_list), intent(inout) :: findings
      type(driven_routine) :: other
      type(point_answer) :: flat_again, again
      integer :: i, k

      other = plane
      other%poison = 2
      call call_routine(other, flat_item%start, flat_item%motion, flat_again)
      ! what differs without a poison is another rule's
      call call_routine(plane, flat_item%start, flat_item%motion, again)
      if (.not. same_answer(again, flat_item%answer)) return
      other = solid
      other%poison = 2
      call call_routine(other, item%start, item%motion, again)
      do i = 1, size(plane%layout%slots)
         associate (p => plane%layout%slots(i), s => solid%layout%slots(i))
            if (p%role /= is_output) cycle
            if (.not. all(same_bits(item%answer%numbers(s%number:s%number + s%length - 1), &
                  again%numbers(s%number:s%number + s%length - 1)))) cycle
            do k = 1, p%length
               if (same_bits(flat_item%answer%numbers(p%number + k - 1), &
                     flat_again%numbers(p%number + k - 1))) cycle
               call findings%add(rule_two_d, severity_error, entry_name(p, k)//' with NDIR = 2', &
                  'set in every call, as with NDIR = 3', 'left as it was, or added to, in '// &
                  place_of(flat_item), 'two-dimensional models get what the memory held')
            end do
         end associate
      end do
   end subroutine check_unset

end module asperity_check_trial_two_d
