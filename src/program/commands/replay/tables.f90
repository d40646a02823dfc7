!> A replay as a table, which as CSV is a path with expected values, and in words.
module asperity_program_commands_replay_tables
   use asperity_abaqus_statev, only: state_from_statev
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list
   use asperity_contact_state, only: contact_state
   use asperity_program_input_key, only: name_length
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, column_status, column_validity, &
      new_table, table_type
   use asperity_replay_abaqus_record, only: optional_outputs
   use asperity_replay_motion_path, only: motion_path, traction_names
   use asperity_replay_path_replay, only: path_step
   implicit none
   private
   public :: replay_table, shown_columns, add_remarks

   !> Columns of the files alone
   character(len=*), parameter :: hidden(*) = [character(len=19) :: 'plastic_dissipation', &
      'viscous_dissipation', 'creep_dissipation']
   !> Rows that a remark lists
   integer, parameter :: most_listed = 12

contains

   !> One row an increment: motion, tractions, energies, what UINTER says of its state.
   pure function replay_table(path, steps, ndir, is_ours) result(table)
      !> The motion
      type(motion_path), intent(in) :: path
      !> What UINTER answered
      type(path_step), intent(in) :: steps(:)
      !> Components, 2 or 3
      integer, intent(in) :: ndir
      !> Whether it was asperity's UINTER, whose state is known
      logical, intent(in) :: is_ours
      type(table_type) :: table
      integer :: i, variables

      variables = size(steps(1)%statev)
      table = new_table(columns=2*ndir + merge(6, 9 + variables, is_ours), rows=size(steps))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call table%add_numbers('time', 's', path%time)
      call table%add_numbers('overclosure', 'mm', path%overclosure)
      do i = 1, ndir - 1
         call table%add_numbers('slip_'//to_text(i), 'mm', (path%slip(i, :)))
      end do
      do i = 1, ndir
         call table%add_numbers(trim(traction_names(i)), 'MPa', (steps%traction(i)))
      end do
      call table%add_numbers('stored_energy', 'N/mm', (steps%stored_energy))
      call table%add_numbers('friction_dissipation', 'N/mm', (steps%dissipation(1)))
      call table%add_numbers('plastic_dissipation', 'N/mm', (steps%dissipation(2)))
      if (is_ours) then
         call add_own_state(table, steps)
         return
      end if
      call table%add_numbers('viscous_dissipation', 'N/mm', (steps%dissipation(3)))
      call table%add_numbers('creep_dissipation', 'N/mm', (steps%dissipation(4)))
      call table%add_codes('lopenclose', column_counts, (steps%lopenclose))
      call table%add_codes('lstate', column_counts, (steps%lstate))
      call table%add_codes('parts', column_counts, (steps%parts))
      do i = 1, variables
         call table%add_numbers('statev_'//to_text(i), '-', variable(steps, i))
      end do
   end function replay_table

   !> What asperity's UINTER says.
   pure subroutine add_own_state(table, steps)
      type(table_type), intent(inout) :: table
      type(path_step), intent(in) :: steps(:)
      type(contact_state) :: state
      integer, dimension(size(steps)) :: status, validity
      integer :: i

      do i = 1, size(steps)
         call state_from_statev(steps(i)%statev, state)
         status(i) = state%status
         validity(i) = state%validity
      end do
      call table%add_codes('status', column_status, status)
      call table%add_codes('validity', column_validity, validity)
   end subroutine add_own_state

   !> One entry of STATEV over all rows.
   pure function variable(steps, which) result(values)
      type(path_step), intent(in) :: steps(:)
      integer, intent(in) :: which
      real(wp) :: values(size(steps))
      integer :: i

      do i = 1, size(steps)
         values(i) = steps(i)%statev(which)
      end do
   end function variable

   !> Columns that the terminal shows: not all of STATEV, nor energies that are seldom looked at.
   pure function shown_columns(table) result(names)
      !> The table
      type(table_type), intent(in) :: table
      character(len=name_length), allocatable :: names(:)
      integer :: i, n

      allocate (names(table%set))
      n = 0
      do i = 1, table%set
         if (index(table%columns(i)%name, 'statev_') == 1) exit
         if (any(table%columns(i)%name == hidden)) cycle
         n = n + 1
         names(n) = table%columns(i)%name
      end do
      names = names(:n)
   end function shown_columns

   !> What UINTER left unset, and where it asked for shorter increments.
   pure subroutine add_remarks(report, steps, unset, findings)
      !> Remarks are added
      type(report_type), intent(inout) :: report
      !> What UINTER answered
      type(path_step), intent(in) :: steps(:)
      !> Which of the optional outputs it has left unset
      logical, intent(in) :: unset(:)
      !> What else was found
      type(finding_list), intent(in) :: findings
      character(len=:), allocatable :: list
      integer :: i, listed

      list = ''
      do i = 1, size(unset)
         if (unset(i)) list = list//', '//trim(optional_outputs(i))
      end do
      if (list /= '') call report%add_remark('UINTER left unset, which counts as zero here: '// &
         list(3:)//'. ABAQUS needs some of them in some procedures (asperity check).')
      do i = 1, findings%n
         associate (finding => findings%items(i))
            call report%add_remark('UINTER, '//finding%place//': '//finding%found//'. '// &
               finding%effect)
         end associate
      end do
      list = ''
      listed = 0
      do i = 1, size(steps)
         if (steps(i)%parts == 1) cycle
         listed = listed + 1
         if (listed <= most_listed) list = list//', '//to_text(i)
      end do
      if (listed > most_listed) list = list//', ...'
      if (listed > 0) call report%add_remark('UINTER asked for shorter increments by PNEWDT: '// &
         to_text(listed)//' of '//to_text(size(steps))//' were computed in parts, rows '// &
         list(3:)//'.')
   end subroutine add_remarks

end module asperity_program_commands_replay_tables
