!> The routine that is checked, from its file to libraries that can be called: what its source and
!> its symbols tell is found on the way.
module asperity_program_commands_check_subject
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_letter_case, only: lower_case, upper_case
   use asperity_check_argument_lists, only: check_argument_list
   use asperity_check_argument_types, only: caller_of, check_argument_types, type_options
   use asperity_check_finding, only: finding_list, rule_argument_list, severity_error
   use asperity_check_source_form, only: gfortran_options
   use asperity_check_source_includes, only: double_kind, single_kind
   use asperity_check_source_scan, only: has_external, scan_source, source_scan
   use asperity_check_source_text, only: read_source, source_text
   use asperity_check_source_units, only: source_routine
   use asperity_check_source_user_routine, only: find_user_routine
   use asperity_program_commands_check_library, only: find_commons, find_statics, &
      library_symbols, read_symbols
   use asperity_program_commands_routine_compile, only: build_routine, build_stubs, fill_none, &
      fill_others, fill_zeros, find_compiler, routine_compiler, write_file
   use asperity_program_commands_routine_messages, only: message_type
   use asperity_program_system_child_command, only: run_command
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_file_facts, only: facts_of, file_facts
   use asperity_program_system_path, only: resolved_path
   use asperity_program_system_strings, only: shell_word
   implicit none
   private
   public :: check_subject, prepare_subject, build_others, uninitialised_messages

   !> The routine.
   type :: check_subject
      !> Its file as given, and the absolute path of its source, empty for a library
      character(len=:), allocatable :: path, source_path
      !> `uinter` or `vuinter`
      character(len=:), allocatable :: routine
      !> Takes single precision
      logical :: single = .false.
      !> It may be called: its arguments are ABAQUS'
      logical :: is_callable = .true.
      !> UEXTERNALDB of the same file is called
      logical :: calls_uexternaldb = .false.
      !> Paths of its library, and of that of ABAQUS' utilities, empty for none
      character(len=:), allocatable :: library, utilities
      !> What the compiler warns of
      type(message_type), allocatable :: messages(:)
      !> The compiler, and its options for the form of the source
      type(routine_compiler) :: compiler
      character(len=:), allocatable :: form_options
   end type check_subject

contains

   !> Read and compile the file. `error` is set when there is nothing that can be checked.
   subroutine prepare_subject(subject, folder, findings, error)
      !> With path, routine (empty to be found) and precision on entry
      type(check_subject), intent(inout) :: subject
      !> Where files go
      type(temporary_folder), intent(inout) :: folder
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(file_facts) :: facts
      type(library_symbols) :: symbols
      character(len=:), allocatable :: ending

      subject%source_path = ''
      subject%library = ''
      subject%utilities = ''
      allocate (subject%messages(0))
      facts = facts_of(subject%path)
      if (.not. facts%exists) then
         call fatal_error(error, subject%path//': there is no such file', file_error)
         return
      else if (.not. facts%is_regular) then
         call fatal_error(error, subject%path//' is a folder, pipe or device, and no file', &
            file_error)
         return
      end if
      ending = lower_case(subject%path(max(scan(subject%path, './', back=.true.), 1):))
      if (ending == '.so') then
         subject%library = resolved_path(subject%path)
      else
         call prepare_source(subject, folder, findings, error)
         if (allocated(error) .or. .not. subject%is_callable) return
      end if
      call read_symbols(folder, subject%library, subject%path, symbols, error)
      if (.not. allocated(error) .and. ending == '.so') call choose_routine(subject, &
         symbols%has_uinter, symbols%has_vuinter, error)
      if (allocated(error)) return
      subject%calls_uexternaldb = symbols%has_uexternaldb .and. subject%routine == 'uinter'
      call find_commons(symbols, subject%messages, findings)
      call find_statics(symbols, findings)
      if (.not. symbols%calls_utilities) return
      if (ending == '.so') call find_compiler(folder, real_kind(subject), subject%compiler, error)
      if (.not. allocated(error)) &
         call build_stubs(folder, subject%compiler, subject%utilities, error)
   end subroutine prepare_subject

   !> From a source to a library.
   subroutine prepare_source(subject, folder, findings, error)
      type(check_subject), intent(inout) :: subject
      type(temporary_folder), intent(inout) :: folder
      type(finding_list), intent(inout) :: findings
      type(error_type), allocatable, intent(out) :: error
      type(source_text) :: source
      type(source_scan) :: found
      type(source_routine) :: routine

      call read_source(subject%path, source, error)
      if (allocated(error)) return
      call scan_source(source%text, source%form, found)
      call choose_routine(subject, has_external(found, 'uinter'), has_external(found, 'vuinter'), &
         error)
      if (.not. allocated(error)) &
         call find_user_routine(source, found, subject%routine, routine, error)
      if (allocated(error)) return
      subject%source_path = resolved_path(subject%path)
      subject%form_options = trim(gfortran_options(source%form, source%text))
      call check_argument_list(subject%routine, routine%arguments, source%place(routine%line), &
         findings)
      subject%is_callable = .not. has_list_error(findings)
      call find_compiler(folder, real_kind(subject), subject%compiler, error)
      if (.not. allocated(error)) call build_routine(folder, subject%compiler, subject%path, &
         subject%form_options, fill_zeros, subject%library, subject%messages, error)
      if (allocated(error) .or. .not. subject%is_callable) return
      call check_types(subject, folder, source, source%place(routine%line), findings, error)
      subject%is_callable = .not. has_list_error(findings)
   end subroutine prepare_source

   !> Which of the two routines is meant, when none is named.
   subroutine choose_routine(subject, has_uinter, has_vuinter, error)
      type(check_subject), intent(inout) :: subject
      logical, intent(in) :: has_uinter, has_vuinter
      type(error_type), allocatable, intent(out) :: error

      if (subject%routine == '' .and. has_uinter .and. has_vuinter) then
         call fatal_error(error, subject%path//' has both UINTER and VUINTER: name one by '// &
            '--routine', subject='routine')
      else if (subject%routine == '') then
         subject%routine = 'uinter'
         if (has_vuinter) subject%routine = 'vuinter'
      end if
      if (allocated(error) .or. subject%source_path /= '' .or. subject%library == '') return
      if (.not. merge(has_vuinter, has_uinter, subject%routine == 'vuinter')) &
         call fatal_error(error, subject%path//' has no subroutine '//upper_case(subject%routine))
   end subroutine choose_routine

   !> Whether the list of arguments has an error.
   pure logical function has_list_error(findings)
      type(finding_list), intent(in) :: findings
      integer :: i

      has_list_error = any([(findings%items(i)%rule == rule_argument_list .and. &
         findings%items(i)%severity == severity_error, i=1, findings%n)])
   end function has_list_error

   !> Kind of the reals that ABAQUS passes.
   pure function real_kind(subject) result(kind)
      type(check_subject), intent(in) :: subject
      character(len=:), allocatable :: kind

      kind = double_kind
      if (subject%single) kind = single_kind
   end function real_kind

   !> Ask the compiler whether the types of the arguments are ABAQUS'.
   subroutine check_types(subject, folder, source, place, findings, error)
      type(check_subject), intent(in) :: subject
      type(temporary_folder), intent(inout) :: folder
      type(source_text), intent(in) :: source
      character(len=*), intent(in) :: place
      type(finding_list), intent(inout) :: findings
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: caller, alone, called

      call caller_of(subject%routine, source%form, real_kind(subject), caller)
      call ask_for_types(subject, folder, source%text, alone, error)
      if (.not. allocated(error)) &
         call ask_for_types(subject, folder, source%text//caller, called, error)
      if (.not. allocated(error)) &
         call check_argument_types(subject%routine, alone, called, place, findings)
   end subroutine check_types

   !> What the compiler says of the types in a text.
   subroutine ask_for_types(subject, folder, text, said, error)
      type(check_subject), intent(in) :: subject
      type(temporary_folder), intent(inout) :: folder
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: said
      type(error_type), allocatable, intent(out) :: error
      integer :: status

      call write_file(folder%path//'/types.f', text, error)
      if (.not. allocated(error)) call run_command(folder, subject%compiler%words// &
         ' '//type_options//' '//subject%form_options//' -I'//shell_word(folder%path)//' -I'// &
         shell_word(subject%source_path(:scan(subject%source_path, '/', back=.true.)))// &
         ' -o /dev/null '//shell_word(folder%path//'/types.f'), said, status, error)
   end subroutine ask_for_types

   !> Build the routine again, with other numbers in variables that nothing is given to.
   subroutine build_others(subject, folder, library, error)
      !> The routine
      type(check_subject), intent(in) :: subject
      !> Where files go
      type(temporary_folder), intent(inout) :: folder
      !> Path of the library
      character(len=:), allocatable, intent(out) :: library
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(message_type), allocatable :: messages(:)

      call build_routine(folder, subject%compiler, subject%path, subject%form_options, &
         fill_others, library, messages, error)
   end subroutine build_others

   !> What the compiler warns of when it fills nothing.
   subroutine uninitialised_messages(subject, folder, messages, error)
      !> The routine
      type(check_subject), intent(in) :: subject
      !> Where files go
      type(temporary_folder), intent(inout) :: folder
      !> The warnings
      type(message_type), allocatable, intent(out) :: messages(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: library

      call build_routine(folder, subject%compiler, subject%path, subject%form_options, &
         fill_none, library, messages, error)
   end subroutine uninitialised_messages

end module asperity_program_commands_check_subject
