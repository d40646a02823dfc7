!> `asperity check`: a user routine of ABAQUS' contact, driven and judged.
module asperity_program_commands_check_command
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, n_rules, rule_argument_list, rule_common, &
      rule_statics, severity_error
   use asperity_check_settings, only: check_settings
   use asperity_program_commands_check_subject, only: check_subject, prepare_subject
   use asperity_program_commands_check_tables, only: count_severity, report_findings
   use asperity_program_commands_check_trials, only: run_trials
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_replay_path_input, only: read_path
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_child_folder, only: create_folder, remove_folder, temporary_folder
   use asperity_program_system_child_run, only: child_limits
   implicit none
   private
   public :: check_command

   !> Checks a user routine.
   type, extends(command_type) :: check_command
      private
      !> File of the routine; path that it is driven along, empty for the usual one
      character(len=:), allocatable :: file, path
      !> `uinter` or `vuinter`; empty to be found
      character(len=8) :: routine = ''
      !> What it is driven with, and what a trial may take
      type(check_settings) :: settings
      type(child_limits) :: limits
      !> How many errors were found
      integer :: errors = 0
   contains
      procedure :: describe, declare, check, run, finish
   end type check_command

   !> Memory that the program itself may need, MB
   integer, parameter :: least_memory = 200
   !> Warnings of the compiler that are shown
   integer, parameter :: most_shown = 10

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(check_command), intent(inout) :: self

      self%name = 'check'
      self%summary = 'faults of a UINTER or VUINTER, without ABAQUS'
      self%usage = 'ROUTINE.f|.for|.f90|.so --properties P1,P2,... --nstatv N [options]'
      self%purpose = 'Drive a user routine of your own (UINTER or VUINTER) as ABAQUS would, '// &
         'and say what is wrong: argument list, outputs left unset, memory written that is not '// &
         'its own, tangent against differences, history lost or advanced at every call, '// &
         'variables that are not set, and more. It is compiled by gfortran and runs in child '// &
         'processes, in a temporary folder; it is your code that runs, with your rights.'
      self%headings(2) = 'The routine and how it is driven'
      self%takes_case = .false.
   end subroutine describe

   !> The routine and how it is driven.
   pure subroutine declare(self, keys)
      !> The command
      class(check_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call keys%text('file', self%file, &
         'the routine, Fortran or a shared library (.so), as a file without an option')
      call keys%reads('routine', is_argument=.true.)
      call keys%choice('routine', self%routine, 'uinter vuinter', &
         'which is meant, when the file has both')
      call keys%list('properties', self%settings%properties, '', &
         'PROPS, in its order; none when not given')
      call keys%whole('nstatv', self%settings%nstatv, 'length of STATEV, as DEPVAR says it')
      call keys%whole('ndir', self%settings%ndir, &
         'components of the motion, 2 or 3; 0 tries both')
      call keys%choice('precision', self%settings%single_precision, 'double single', &
         'of the numbers that VUINTER takes')
      call keys%real('largest_overclosure', self%settings%largest_overclosure, 'mm', &
         'how far the faces pass each other')
      call keys%real('largest_gap', self%settings%largest_gap, 'mm', 'how far they part')
      call keys%real('largest_slip', self%settings%largest_slip, 'mm', 'how far they slip')
      call keys%real('time_increment', self%settings%time_increment, 's', &
         'length of an increment')
      call keys%text('path', self%path, &
         'CSV of a path to drive it along, as replay reads it, in place of the usual one')
      call keys%reads('path', is_argument=.false.)
      call keys%whole('time_limit', self%limits%seconds, &
         'seconds of the processor that a trial may take; ten times as long by the clock')
      call keys%whole('memory_limit', self%limits%megabytes, 'memory that a trial may take, MB')
      call self%declare_outputs(keys, has_picture=.false.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the values.
   subroutine check(self, error)
      !> The command
      class(check_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      if (self%file == '') then
         call fatal_error(error, 'no routine is given: asperity check '//self%usage, subject='file')
      else if (all(self%settings%ndir /= [0, 2, 3])) then
         call fatal_error(error, 'ndir = '//to_text(self%settings%ndir)//' is not allowed: 2, '// &
            '3, or 0 for both', subject='ndir')
      else if (self%settings%nstatv < 0) then
         call fatal_error(error, 'nstatv = '//to_text(self%settings%nstatv)//' is not allowed: '// &
            'at least 0', subject='nstatv')
      end if
      associate (s => self%settings)
         if (.not. allocated(error)) &
            call check_positive(error, 'largest_overclosure', s%largest_overclosure, 'mm')
         if (.not. allocated(error)) call check_positive(error, 'largest_gap', s%largest_gap, 'mm')
         if (.not. allocated(error)) &
            call check_positive(error, 'largest_slip', s%largest_slip, 'mm')
         if (.not. allocated(error)) &
            call check_positive(error, 'time_increment', s%time_increment, 's')
      end associate
      if (.not. allocated(error) .and. self%limits%seconds < 1) call fatal_error(error, &
         'time_limit = '//to_text(self%limits%seconds)//' is not allowed: at least 1', &
         subject='time_limit')
      if (allocated(error)) return
      if (self%limits%megabytes < least_memory) then
         call fatal_error(error, 'memory_limit = '//to_text(self%limits%megabytes)//' is not '// &
            'allowed: at least '//to_text(least_memory)//', most of which is the program''s own', &
            subject='memory_limit')
         return
      end if
      if (.not. allocated(self%settings%properties)) allocate (self%settings%properties(0))
      if (self%path /= '') call read_path(self%path, self%settings%path, error)
   end subroutine check

   !> Check the routine and report what was found.
   subroutine run(self, report, error)
      !> The command
      class(check_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set when it cannot be checked
      type(error_type), allocatable, intent(out) :: error
      type(check_subject) :: subject
      type(finding_list) :: findings
      type(temporary_folder) :: folder
      logical :: is_tried(n_rules)

      subject%path = self%file
      subject%routine = trim(self%routine)
      subject%single = self%settings%single_precision
      is_tried = .false.
      call create_folder(folder, error)
      if (allocated(error)) return
      call prepare_subject(subject, folder, findings, error)
      if (.not. allocated(error)) then
         is_tried(rule_argument_list) = subject%source_path /= ''
         is_tried([rule_statics, rule_common]) = subject%is_callable
         if (subject%is_callable) call run_trials(subject, self%settings, self%limits, folder, &
            findings, is_tried, error)
      end if
      call remove_folder(folder)
      if (allocated(error)) return
      self%errors = count_severity(findings, severity_error)
      call report_findings(report, findings, is_tried)
      call add_remarks(subject, report)
   end subroutine run

   !> What else is to be said.
   subroutine add_remarks(subject, report)
      type(check_subject), intent(in) :: subject
      type(report_type), intent(inout) :: report
      integer :: i, n

      if (subject%source_path == '') call report%add_remark('A shared library does not tell '// &
         'the list of its arguments, and cannot be compiled again: argument_list and '// &
         'uninitialised are not tried.')
      if (.not. subject%is_callable) call report%add_remark('With other arguments than '// &
         'ABAQUS'' it is not called.')
      if (subject%calls_uexternaldb) call report%add_remark('UEXTERNALDB of the same file is '// &
         'called at start and end of analysis, step and increment.')
      n = size(subject%messages)
      do i = 1, min(n, most_shown)
         call report%add_remark('The compiler warns at '//subject%messages(i)%place//': '// &
            subject%messages(i)%text)
      end do
      if (n > most_shown) call report%add_remark('It warns of '//to_text(n - most_shown)// &
         ' things more.')
   end subroutine add_remarks

   !> Fail when there are errors.
   subroutine finish(self, error)
      !> The command
      class(check_command), intent(inout) :: self
      !> Set when errors were found
      type(error_type), allocatable, intent(out) :: error

      if (self%errors > 0) call fatal_error(error, self%file//': '//to_text(self%errors)// &
         trim(merge(' error  ', ' errors ', self%errors == 1))//' found', computation_error)
   end subroutine finish

end module asperity_program_commands_check_command
