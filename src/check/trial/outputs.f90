!> Rule `unset_output`: every entry of every output is set, whatever it held before.
module asperity_check_trial_outputs
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_driven_call, only: call_routine
   use asperity_check_driven_drive, only: drive, drive_record, driven_increment, largest_stress, &
      place_of
   use asperity_check_driven_layout, only: argument_slot, entry_name, is_output, same_bits
   use asperity_check_driven_left, only: stored_is_set, stress_left
   use asperity_check_driven_paths, only: main_path
   use asperity_check_driven_point, only: point_answer, same_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_finding, only: finding_list, rule_unset_output, severity_error, &
      severity_note, severity_warning
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: check_outputs

   !> How many calls left an entry, in how many it was added to what it held, and the first of them.
   type :: entry_count
      integer :: left = 0, added = 0, first = 0
   end type entry_count

   !> Outputs that matter alike, by the manual
   type :: output_group
      character(len=11) :: names(4) = ''
      integer :: severity = severity_error
      character(len=96) :: effect = ''
   end type output_group

contains

   !> Run the trial.
   subroutine check_outputs(routine, settings, findings)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(drive_record) :: record
      type(driven_routine) :: other
      type(point_answer) :: answer, again
      type(entry_count), allocatable :: counts(:)
      integer :: i, j

      call drive(routine, main_path(settings), 1, record)
      if (record%n == 0) return
      allocate (counts(routine%layout%numbers))
      other = routine
      other%poison = 2
      do i = 1, record%n
         call call_routine(other, record%items(i)%start, record%items(i)%motion, answer)
         ! what differs without a poison is another rule's
         call call_routine(routine, record%items(i)%start, record%items(i)%motion, again)
         if (.not. same_answer(again, record%items(i)%answer)) cycle
         do j = 1, size(routine%layout%slots)
            if (routine%layout%slots(j)%role == is_output) &
               call count_slot(routine%layout%slots(j), i, record%items(i)%answer, answer, counts)
         end do
      end do
      call report_groups(routine, record, counts, findings)
      call check_advanced(routine, record, findings)
   end subroutine check_outputs

   !> Count the entries of an output whose answers under two poisons are not the same.
   subroutine count_slot(slot, increment, a, b, counts)
      type(argument_slot), intent(in) :: slot
      integer, intent(in) :: increment
      type(point_answer), intent(in) :: a, b
      type(entry_count), intent(inout) :: counts(:)
      integer :: k

      do k = slot%number, slot%number + slot%length - 1
         if (same_bits(a%numbers(k), b%numbers(k))) cycle
         if (is_poison(a, k) .and. is_poison(b, k)) then
            counts(k)%left = counts(k)%left + 1
         else
            counts(k)%added = counts(k)%added + 1
         end if
         if (counts(k)%first == 0) counts(k)%first = increment
      end do
   end subroutine count_slot

   !> Whether an entry holds what it held before.
   pure logical function is_poison(answer, k)
      type(point_answer), intent(in) :: answer
      integer, intent(in) :: k

      is_poison = same_bits(answer%numbers(k), answer%before(k))
   end function is_poison

   !> One finding a group of outputs.
   subroutine report_groups(routine, record, counts, findings)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      type(entry_count), intent(in) :: counts(:)
      type(finding_list), intent(inout) :: findings
      type(output_group) :: groups(4)
      integer :: i

      groups(1)%names(1) = 'DDSDDR'
      groups(1)%effect = 'ABAQUS takes what the memory held for a stiffness: no convergence, '// &
         'or chance'
      groups(2)%names(1:2) = [character(len=11) :: 'DVISCOUS', 'DSTRUCTURAL']
      groups(2)%severity = severity_warning
      groups(2)%effect = 'required in steady-state dynamics and the like, where chance damps'
      groups(3)%names = [character(len=11) :: 'FLUX', 'DDFDDT', 'DDSDDT', 'DDFDDR']
      if (associated(routine%vuinter)) groups(3)%names = [character(len=11) :: 'fluxSlv', &
         'fluxMst', '', '']
      groups(3)%severity = severity_warning
      groups(3)%effect = 'required in heat transfer and coupled steps, where chance conducts'
      groups(4)%names = [character(len=11) :: 'SFD', 'SPD', 'SVD', 'SCD']
      if (associated(routine%vuinter)) groups(4)%names = [character(len=11) :: 'sfd', 'spd', &
         'svd', 'scd']
      groups(4)%severity = severity_note
      groups(4)%effect = 'optional: energies of the model''s output are chance'
      do i = 1, size(groups)
         call report_group(routine, record, counts, groups(i), findings)
      end do
   end subroutine report_groups

   subroutine report_group(routine, record, counts, group, findings)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      type(entry_count), intent(in) :: counts(:)
      type(output_group), intent(in) :: group
      type(finding_list), intent(inout) :: findings
      character(len=:), allocatable :: place, found
      integer :: i, k, unset, all_of_it, first, left

      place = ''
      first = huge(first)
      left = 0
      do i = 1, size(routine%layout%slots)
         associate (slot => routine%layout%slots(i))
            if (.not. any(group%names == slot%name)) cycle
            all_of_it = slot%length
            unset = 0
            do k = 1, slot%length
               associate (count => counts(slot%number + k - 1))
                  if (count%first == 0) cycle
                  unset = unset + 1
                  first = min(first, count%first)
                  left = left + count%left
               end associate
            end do
            if (unset == 0) cycle
            if (place /= '') place = place//', '
            if (unset == all_of_it) then
               place = place//trim(slot%name)
            else
               do k = 1, slot%length
                  if (counts(slot%number + k - 1)%first == 0) cycle
                  if (place /= '' .and. place(max(1, len(place)):) == ')') place = place//', '
                  place = place//entry_name(slot, k)
               end do
            end if
         end associate
      end do
      if (place == '') return
      found = 'left as it was'
      if (left == 0) found = 'added to what it held'
      call findings%add(rule_unset_output, group%severity, place, 'set in every call', found// &
         ', first in '//place_of(record%items(first)), trim(group%effect))
   end subroutine report_group

   !> STRESS and SED hold the values of the start.
   subroutine check_advanced(routine, record, findings)
      type(driven_routine), intent(in) :: routine
      type(drive_record), intent(in) :: record
      type(finding_list), intent(inout) :: findings
      logical :: is_left(3)
      integer :: i, k

      do i = 1, record%n
         associate (item => record%items(i))
            is_left = stress_left(routine, item, largest_stress(record))
            if (.not. any(is_left)) cycle
            k = findloc(is_left, .true., dim=1)
            call findings%add(rule_unset_output, severity_error, 'STRESS('//to_text(k)//')', &
               'set in every call', 'left as it was at the start, first in '//place_of(item), &
               'the traction stays what it was, whatever the faces do')
            exit
         end associate
      end do
      if (.not. stored_is_set(routine, record)) call findings%add(rule_unset_output, &
         severity_note, 'SED', 'the stored energy at the end of the increment', &
         'left as it was at the start', &
         'optional: the stored energy of the contact is missing in the model''s output')
   end subroutine check_advanced

end module asperity_check_trial_outputs
