!> What the symbols of a shared library tell of a user routine, as nm of the GNU binutils prints
!> them.
module asperity_program_commands_check_library
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_letter_case, only: lower_case
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_common, rule_statics, severity_error, &
      severity_warning
   use asperity_program_commands_routine_messages, only: message_type
   use asperity_program_commands_routine_stubs, only: stub_names
   use asperity_program_system_child_command, only: run_command
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_strings, only: shell_word, split_lines, starts_with, string_type
   implicit none
   private
   public :: library_symbols, read_symbols, find_statics, find_commons

   !> What a library has.
   type :: library_symbols
      !> It has a UINTER, a VUINTER, a UEXTERNALDB; it calls a utility of ABAQUS that can be stood
      !> in for
      logical :: has_uinter = .false., has_vuinter = .false., has_uexternaldb = .false., &
         calls_utilities = .false.
      !> Variables that last from call to call, with their bytes; COMMON blocks
      type(string_type), allocatable :: statics(:), commons(:)
      integer, allocatable :: bytes(:)
   end type library_symbols

   !> Beginnings of names that compiler and linker keep for themselves
   character(len=*), parameter :: own(*) = [character(len=22) :: '_DYNAMIC', &
      '_GLOBAL_OFFSET_TABLE_', '__TMC_END__', '__do_global_dtors_aux', '__dso_handle', &
      '__frame_dummy_init', 'completed.', &
      '_edata', '_end', '__bss_start', '_fini', '_init', '.', 'jumptable.', '_ITM', '__JCR']
   !> Variables that a finding names
   integer, parameter :: names_shown = 5
   !> How gfortran warns of two lengths of a block
   character(len=*), parameter :: other_length = 'shall be of the same size as elsewhere'

contains

   !> Read the symbols of a library. `error` is set when it is none.
   subroutine read_symbols(folder, path, name, symbols, error)
      !> Where files go
      type(temporary_folder), intent(inout) :: folder
      !> Absolute path of the library, and as messages have it
      character(len=*), intent(in) :: path, name
      !> What it has
      type(library_symbols), intent(out) :: symbols
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: output
      type(string_type), allocatable :: lines(:)
      integer :: i, status

      allocate (symbols%statics(0), symbols%commons(0), symbols%bytes(0))
      call run_command(folder, 'nm --format=posix '//shell_word(path)// &
         ' 2>/dev/null; nm -D --format=posix '//shell_word(path), output, status, error)
      if (allocated(error)) return
      if (status /= 0) then
         call fatal_error(error, name//': nm of the GNU binutils finds no symbols of a shared '// &
            'library in it')
         return
      end if
      call split_lines(output, lines)
      do i = 1, size(lines)
         call take_symbol(symbols, lines(i)%text)
      end do
   end subroutine read_symbols

   !> Take one line `NAME LETTER VALUE SIZE`.
   pure subroutine take_symbol(symbols, line)
      type(library_symbols), intent(inout) :: symbols
      character(len=*), intent(in) :: line
      character(len=:), allocatable :: name, kind
      integer :: blank, size_at, bytes, status
      type(string_type) :: text

      blank = index(line, ' ')
      if (blank < 2) return
      name = line(:blank - 1)
      kind = line(blank + 1:min(len(line), blank + 1))
      select case (kind)
      case ('T', 't', 'W', 'i')
         if (any(lower_case(name) == [character(len=8) :: 'uinter', 'uinter_'])) &
            symbols%has_uinter = .true.
         if (any(lower_case(name) == [character(len=8) :: 'vuinter', 'vuinter_'])) &
            symbols%has_vuinter = .true.
         if (name == 'uexternaldb_') symbols%has_uexternaldb = .true.
      case ('U')
         if (any(name == stub_names)) symbols%calls_utilities = .true.
      case ('B', 'b', 'C', 'D', 'd', 'S', 's')
         if (is_own(name)) return
         size_at = index(line, ' ', back=.true.)
         bytes = 0
         read (line(size_at + 1:), '(z20)', iostat=status) bytes
         ! what has no size is a mark of the linker
         if (status /= 0 .or. bytes == 0) return
         if (is_common(name)) then
            text%text = '/'//name(:len(name) - 1)//'/'
            if (name == '__BLNK__') text%text = '//'
            if (.not. any_is(symbols%commons, text%text)) symbols%commons = [symbols%commons, text]
         else
            text%text = variable_of(name)
            if (any_is(symbols%statics, text%text)) return
            symbols%statics = [symbols%statics, text]
            symbols%bytes = [symbols%bytes, bytes]
         end if
      case default
         return
      end select
   end subroutine take_symbol

   !> Whether a text is among others.
   pure logical function any_is(list, text)
      type(string_type), intent(in) :: list(:)
      character(len=*), intent(in) :: text
      integer :: i

      any_is = any([(list(i)%text == text, i=1, size(list))])
   end function any_is

   !> Whether a name is of the compiler or linker: its marks, constants, tables of types.
   pure logical function is_own(name)
      character(len=*), intent(in) :: name
      integer :: i

      is_own = any([(starts_with(name, trim(own(i))), i=1, size(own))]) &
         .or. index(name, '__vtab_') > 0 .or. index(name, '__def_init_') > 0
      if (starts_with(name, 'A.')) is_own = verify(name(3:), '0123456789.') == 0
   end function is_own

   !> Whether a name is that of a COMMON block: with gfortran and Intel's compiler NAME_, the blank
   !> one __BLNK__ or _BLNK_. Variables of modules are __M_MOD_NAME and m_mp_NAME_, those of
   !> procedures NAME.1 and p_$NAME.
   pure logical function is_common(name)
      character(len=*), intent(in) :: name

      is_common = name(len(name):) == '_' .and. scan(name, '.$') == 0 &
         .and. index(name, '_MOD_') == 0 .and. index(name, '_mp_') == 0
   end function is_common

   !> A variable in words, such as `counter` or `counter of module store`.
   pure function variable_of(name) result(text)
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: text
      integer :: at

      at = index(name, '_MOD_')
      if (starts_with(name, '__') .and. at > 3) then
         text = name(at + 5:)//' of module '//name(3:at - 1)
         return
      end if
      text = name
      at = index(name, '.')
      if (at > 1) text = name(:at - 1)
   end function variable_of

   !> Variables that last from call to call.
   pure subroutine find_statics(symbols, findings)
      !> What the library has
      type(library_symbols), intent(in) :: symbols
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      character(len=:), allocatable :: names
      integer :: i, n

      n = size(symbols%statics)
      if (n == 0) return
      names = symbols%statics(1)%text
      do i = 2, min(n, names_shown)
         names = names//', '//symbols%statics(i)%text
      end do
      if (n > names_shown) names = names//' and '//to_text(n - names_shown)//' more'
      call findings%add(rule_statics, severity_warning, names, &
         'no variable that lasts from call to call (SAVE, DATA, in a module): what a point '// &
         'remembers belongs in STATEV', to_text(sum(symbols%bytes))//' bytes that may be written', &
         'all points, attempts at an increment and threads share them: an attempt that is '// &
         'given up is not undone, and with several threads results change from run to run')
   end subroutine find_statics

   !> COMMON blocks, and those that the compiler finds to have several lengths.
   pure subroutine find_commons(symbols, messages, findings)
      !> What the library has
      type(library_symbols), intent(in) :: symbols
      !> What the compiler warned of; what becomes a finding is taken out
      type(message_type), allocatable, intent(inout) :: messages(:)
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      logical :: taken(size(messages))
      integer :: first, i, last

      do i = 1, size(messages)
         taken(i) = index(messages(i)%text, other_length) > 0
         if (.not. taken(i)) cycle
         first = index(messages(i)%text, "'") + 1
         last = first + index(messages(i)%text(first:), "'") - 2
         call findings%add(rule_common, severity_error, 'COMMON /'// &
            messages(i)%text(first:last)//'/', 'one length in all subroutines', &
            messages(i)%text(index(messages(i)%text, '(', back=.true.):)//' at '// &
            messages(i)%place, 'subroutines take the same memory for different variables')
      end do
      messages = pack(messages, .not. taken)
      do i = 1, size(symbols%commons)
         call findings%add(rule_common, severity_warning, 'COMMON '//symbols%commons(i)%text, &
            'no COMMON: what a point remembers belongs in STATEV', 'a COMMON block', &
            'all points, attempts at an increment and threads share it: an attempt that is '// &
            'given up is not undone, and with several threads results change from run to run')
      end do
   end subroutine find_commons

end module asperity_program_commands_check_library
