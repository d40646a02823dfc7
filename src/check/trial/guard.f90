!> Rule `guard`: nothing is written outside of an argument or to an input, and nothing is read from
!> outside.
module asperity_check_trial_guard
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine, repeats
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, place_of
   use asperity_check_driven_layout, only: entry_name, is_input
   use asperity_check_driven_paths, only: main_path, path_of, sizes_of
   use asperity_check_driven_point, only: point_answer, same_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_guard, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_contact_state, only: no_opposite_surface
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: check_guard, damage_text

contains

   !> Run the trial.
   subroutine check_guard(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(point_answer) :: again, answer
      type(driven_routine) :: other
      type(drive_record) :: lost
      type(motion_path) :: path
      integer :: i, slot

      ! no surface opposite, before and after contact
      path = path_of(sizes_of(settings), [-1.0_wp, 0.5_wp, 1.0_wp, -1.0_wp], [0.0_wp, 0.0_wp, &
         1.0_wp, 1.0_wp])
      path%overclosure([1, 4]) = no_opposite_surface
      call drive(routine, path, 1, lost)
      call drive(routine, main_path(settings), 1, record)
      if (record%stuck .or. record%unusable) call report_writing(record%refused)
      do i = 1, record%n
         call report_writing(record%items(i))
      end do
      if (lost%stuck .or. lost%unusable) call report_writing(lost%refused)
      do i = 1, lost%n
         call report_writing(lost%items(i))
      end do
      other = routine
      do slot = 0, size(routine%layout%slots)
         other%odd_guard = slot
         do i = 1, record%n
            associate (item => record%items(i))
               call call_routine(other, item%start, item%motion, answer)
               if (same_answer(answer, item%answer)) cycle
               if (.not. repeats(routine, item%start, item%motion)) cycle
               call call_routine(other, item%start, item%motion, answer)
               call call_routine(routine, item%start, item%motion, again)
               if (same_answer(answer, again)) cycle
               call findings%add(rule_guard, severity_error, name_of(slot)//', '// &
                  place_of(item), 'an answer that depends on the arguments alone', &
                  'another answer when the memory there holds other numbers', &
                  'the answer depends on memory that is not the routine''s: it may change from '// &
                  'run to run')
            end associate
            exit
         end do
      end do

   contains

      subroutine report_writing(item)
         type(driven_increment), intent(in) :: item

         if (item%answer%damaged_slot == 0 .and. item%answer%changed == '') return
         call findings%add(rule_guard, severity_error, damage_text(routine, item%answer), &
            'nothing is written there', 'written to in '//place_of(item), &
            'memory that is not the routine''s is overwritten: wrong results or a crash elsewhere')
      end subroutine report_writing

      function name_of(slot) result(name)
         integer, intent(in) :: slot
         character(len=:), allocatable :: name

         name = 'what stands before the first argument'
         if (slot > 0) name = 'what follows '//trim(routine%layout%slots(slot)%name)//', which '// &
            'has '//to_text(routine%layout%slots(slot)%length)//' numbers'
      end function name_of

   end subroutine check_guard

   !> What was written to and must not be.
   function damage_text(routine, answer) result(text)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> An answer with damage
      type(point_answer), intent(in) :: answer
      character(len=:), allocatable :: text

      if (answer%damaged_slot == 0) then
         text = trim(answer%changed)//', an input'
         return
      end if
      associate (slot => routine%layout%slots(answer%damaged_slot), k => answer%damaged_entry)
         text = entry_name(slot, k)
         if (slot%role == is_input .and. k >= 1 .and. k <= slot%length) then
            text = text//', an input'
         else
            text = text//', outside of '//trim(slot%name)//' with '//to_text(slot%length)// &
               ' numbers'
         end if
      end associate
   end function damage_text

end module asperity_check_trial_guard
