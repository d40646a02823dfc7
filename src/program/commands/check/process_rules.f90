!> What the end and the output of a child process tell of the user routine that ran in it.
module asperity_program_commands_check_process_rules
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_crash, rule_prints, rule_timeout, &
      severity_error, severity_note, severity_warning
   use asperity_program_commands_routine_stubs, only: ended_status, level_end, level_error, &
      messages_file
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_child_run, only: child_finished, child_killed, child_late, &
      child_limits, child_outcome, child_stopped
   use asperity_program_system_files, only: read_file
   use asperity_program_system_posix, only: sigkill, sigxfsz
   use asperity_program_system_strings, only: quoted, split_lines, starts_with, string_type
   implicit none
   private
   public :: judge_outcome

   !> Signals that have names here, and what they mean
   integer, parameter :: signals(*) = [4, 6, 7, 8, int(sigkill), 11, int(sigxfsz)]
   character(len=*), parameter :: signal_names(*) = [character(len=60) :: &
      'SIGILL (no such instruction)', 'SIGABRT (it gave up)', &
      'SIGBUS (no such memory)', 'SIGFPE (arithmetic)', 'SIGKILL', &
      'SIGSEGV (memory that is not its own)', 'SIGXFSZ (it wrote more than 64 MB)']
   !> Characters of an output that a finding shows
   integer, parameter :: shown = 100, most_read = 100000
   !> Fortran units of user routines: ABAQUS/Standard may be written to at 6 and 7, Explicit at 6;
   !> their own are 15 to 18 and above 100, with Explicit 16 to 18 and above 100 ending in 5 to 9
   character(len=*), parameter :: units_of_routines = '6, 7, 15 to 18, or above 100', &
      units_of_explicit = '6, 16 to 18, or above 100 and ending in 5 to 9'

contains

   !> Add what an outcome tells.
   subroutine judge_outcome(outcome, folder, limits, trial, path, is_explicit, findings)
      !> The outcome
      type(child_outcome), intent(in) :: outcome
      !> Where the child ran
      type(temporary_folder), intent(in) :: folder
      !> Its limits
      type(child_limits), intent(in) :: limits
      !> Name of the trial
      character(len=*), intent(in) :: trial
      !> Absolute path of the source
      character(len=*), intent(in) :: path
      !> Whether the routine is VUINTER
      logical, intent(in) :: is_explicit
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      type(string_type), allocatable :: lines(:)
      logical :: is_told

      ! gfortran warns of its bounds otherwise
      allocate (lines(0))
      call split_lines(outcome%output, lines)
      call judge_messages(outcome, folder, trial, findings, is_told)
      select case (outcome%ending)
      case (child_finished)
         if (size(lines) > 0) call findings%add(rule_prints, severity_note, 'standard output', &
            'nothing printed', to_text(count_lines(lines))//' lines in trial '//trial// &
            ', the first '//quoted(cut(lines(1)%text)), 'each call of each point prints: the '// &
            '.dat or .log file grows and the analysis is slow')
         call judge_files(outcome, trial, is_explicit, findings)
      case (child_stopped)
         if (.not. (is_told .and. outcome%code == ended_status)) call findings%add(rule_crash, &
            severity_error, place_of(lines, path, trial), 'a return from every call', &
            'STOP, EXIT or an error of Fortran in trial '//trial//': exit status '// &
            to_text(outcome%code)//said(lines), 'ABAQUS ends without a message of its own')
      case (child_killed)
         if (outcome%code == sigxfsz) then
            call findings%add(rule_prints, severity_error, 'standard output, or a file', &
               'nothing printed', 'ended in trial '//trial//' by '//signal_name(outcome%code), &
               'the disk fills')
         else
            call findings%add(rule_crash, severity_error, place_of(lines, path, trial), &
               'a return from every call', 'ended in trial '//trial//' by '// &
               signal_name(outcome%code), 'ABAQUS ends with a system error')
         end if
      case (child_late)
         call findings%add(rule_timeout, severity_error, 'trial '//trial, 'an end within '// &
            to_text(limits%seconds)//' s (--time-limit)', 'no end', &
            'ABAQUS hangs, or takes as long at every call')
      case default
         return
      end select
   end subroutine judge_outcome

   !> Errors that the routine itself told ABAQUS, and the end of the job. `is_told` says whether
   !> there is one.
   subroutine judge_messages(outcome, folder, trial, findings, is_told)
      type(child_outcome), intent(in) :: outcome
      type(temporary_folder), intent(in) :: folder
      character(len=*), intent(in) :: trial
      type(finding_list), intent(inout) :: findings
      logical, intent(out) :: is_told
      type(string_type), allocatable :: lines(:)
      character(len=:), allocatable :: text, reason
      integer :: i, level, status

      is_told = .false.
      if (.not. any([(outcome%files(i)%text == messages_file, i=1, size(outcome%files))])) return
      call read_file(folder%path//'/work/'//messages_file, most_read, text, reason)
      if (allocated(reason)) return
      call split_lines(text, lines)
      do i = 1, size(lines)
         read (lines(i)%text, *, iostat=status) level
         if (status /= 0 .or. level > level_error) cycle
         call findings%add(rule_crash, severity_error, 'message of the routine in trial '//trial, &
            'no error at these properties and this path', &
            lines(i)%text(index(lines(i)%text, ' ') + 1:), &
            trim(merge('ABAQUS ends the job   ', 'ABAQUS counts an error', level == level_end)))
         is_told = .true.
         return
      end do
   end subroutine judge_messages

   !> Files that the routine left.
   subroutine judge_files(outcome, trial, is_explicit, findings)
      type(child_outcome), intent(in) :: outcome
      character(len=*), intent(in) :: trial
      logical, intent(in) :: is_explicit
      type(finding_list), intent(inout) :: findings
      character(len=:), allocatable :: units
      integer :: i, status, unit
      logical :: allowed

      units = units_of_routines
      if (is_explicit) units = units_of_explicit
      do i = 1, size(outcome%files)
         associate (name => outcome%files(i)%text)
            if (name == '' .or. name == messages_file) cycle
            unit = 0
            status = 0
            if (starts_with(name, 'fort.')) read (name(6:), *, iostat=status) unit
            if (status /= 0) unit = 0
            allowed = unit == 7 .or. (unit >= 15 .and. unit <= 18) .or. unit > 100
            if (is_explicit) allowed = (unit >= 16 .and. unit <= 18) .or. &
               (unit > 100 .and. mod(unit, 10) >= 5)
            if (unit > 0 .and. .not. allowed) then
               call findings%add(rule_prints, severity_warning, 'unit '//to_text(unit), &
                  'units of user routines: '//units, 'written to in trial '//trial, &
                  'ABAQUS may use the unit for a file of its own')
            else
               call findings%add(rule_prints, severity_note, 'file '//name, 'no file', &
                  'written in trial '//trial, 'each call of each point writes: the file grows '// &
                  'and the analysis is slow')
            end if
         end associate
      end do
   end subroutine judge_files

   !> Where a backtrace has the first line of the source, else the trial.
   pure function place_of(lines, path, trial) result(place)
      type(string_type), intent(in) :: lines(:)
      character(len=*), intent(in) :: path, trial
      character(len=:), allocatable :: place
      integer :: at, i, line, status

      place = 'trial '//trial
      if (path == '') return
      do i = 1, size(lines)
         at = index(lines(i)%text, 'at '//path//':')
         if (at == 0) cycle
         read (lines(i)%text(at + 4 + len(path):), *, iostat=status) line
         if (status /= 0) cycle
         place = 'line '//to_text(line)
         return
      end do
   end function place_of

   !> What a routine said before its end: an error of Fortran, else its first line.
   pure function said(lines) result(text)
      type(string_type), intent(in) :: lines(:)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(lines)
         if (text == '' .and. lines(i)%text /= '') text = ', '//cut(lines(i)%text)
         if (index(lines(i)%text, 'runtime error') == 0) cycle
         text = ', '//cut(lines(i)%text)
         return
      end do
   end function said

   !> How many lines there are, without an empty one at the end.
   pure integer function count_lines(lines)
      type(string_type), intent(in) :: lines(:)

      count_lines = size(lines)
      if (lines(count_lines)%text == '') count_lines = count_lines - 1
   end function count_lines

   !> The beginning of a text.
   pure function cut(text) result(beginning)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: beginning

      beginning = trim(adjustl(text))
      if (len(beginning) > shown) beginning = beginning(:shown)//' ...'
   end function cut

   !> A signal in words.
   pure function signal_name(signal) result(name)
      integer, intent(in) :: signal
      character(len=:), allocatable :: name
      integer :: i

      name = 'signal '//to_text(signal)
      i = findloc(signals, signal, dim=1)
      if (i > 0) name = trim(signal_names(i))
   end function signal_name

end module asperity_program_commands_check_process_rules
