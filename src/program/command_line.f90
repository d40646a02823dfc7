!> Parses the command line, and nothing else, into one type.
module asperity_program_command_line
   use asperity_base_error, only: error_type, fatal_error
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_registry, only: command_entry, find_command, &
      list_commands, n_commands, owners
   use asperity_program_help, only: usage_text
   use asperity_program_input_key, only: given_as_option, kind_paths, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_nearest_key, only: nearest_key
   use asperity_program_input_options, only: parse_option
   use asperity_program_system_strings, only: nearest_name, newline, quoted, starts_with, &
      string_type
   implicit none
   private
   public :: command_line_type, parse_command_line

   !> What is asked for
   enum, bind(c)
      enumerator :: asks_run = 1
      !> Help on all commands, or on those that begin with a word
      enumerator :: asks_help
      enumerator :: asks_version
      enumerator :: asks_citation
      enumerator :: asks_man
      enumerator :: asks_completion
   end enum
   public :: asks_run, asks_help, asks_version, asks_citation, asks_man, asks_completion

   !> What the command line asks for.
   type :: command_line_type
      !> One of the above
      integer :: action = asks_run
      !> The command to run, or that help is asked about
      class(command_type), allocatable :: command
      !> First word of the commands that help is asked about, empty for all
      character(len=:), allocatable :: topic
      !> Keys of the command, with the values given as options
      type(key_list) :: keys
   end type command_line_type

   !> How names of case files end
   character(len=*), parameter :: case_ending = '.nml'
   !> Standard input as an argument, and as a file
   character(len=*), parameter :: dash = '-'
   character(len=*), parameter, public :: standard_input = '/dev/stdin'
   character(len=*), parameter :: help_words(*) = [character(len=6) :: 'help', '--help', '-h']
   character(len=*), parameter :: version_words(*) = [character(len=9) :: 'version', '--version', &
      '-V']

contains

   !> Parse the arguments of the program.
   subroutine parse_command_line(line, error)
      !> What they ask for
      type(command_line_type), intent(out) :: line
      !> Set when they are faulty
      type(error_type), allocatable, intent(out) :: error
      type(string_type), allocatable :: arguments(:)
      integer :: i, used

      line%topic = ''
      line%keys%case_path = ''
      call get_arguments(arguments)
      if (size(arguments) == 0) then
         call fatal_error(error, 'no command is given'//usage_text())
      else if (any(help_words == arguments(1)%text)) then
         line%action = asks_help
         call parse_topic(line, arguments(2:), error)
      else if (any(version_words == arguments(1)%text)) then
         line%action = asks_version
         if (size(arguments) > 1) call refuse_argument('version', arguments(2)%text, error)
      else if (arguments(1)%text == '--citation') then
         line%action = asks_citation
         if (size(arguments) > 1) call refuse_argument('citation', arguments(2)%text, error)
      else
         associate (last => arguments(size(arguments)), &
               before => arguments(max(1, size(arguments) - 1)))
            if (last%text == 'help' .and. .not. starts_with(before%text, '-')) last%text = '--help'
         end associate
         if (any([(any(help_words(2:) == arguments(i)%text), i=2, size(arguments))])) &
            line%action = asks_help
         call find_words(line, arguments, used, error)
         if (allocated(error) .or. line%action == asks_help) return
         call line%command%declare(line%keys)
         call parse_arguments(line, arguments(used + 1:), error)
      end if
   end subroutine parse_command_line

   !> The arguments of the program as the system gives them.
   subroutine get_arguments(arguments)
      type(string_type), allocatable, intent(out) :: arguments(:)
      integer :: i, length

      allocate (arguments(command_argument_count()))
      do i = 1, size(arguments)
         call get_command_argument(i, length=length)
         arguments(i)%text = repeat(' ', length)
         associate (text => arguments(i)%text)
            if (length > 0) call get_command_argument(i, text)
         end associate
      end do
   end subroutine get_arguments

   !> The command of the first word or two. Help takes the first word of several commands, too.
   subroutine find_words(line, arguments, used, error)
      type(command_line_type), intent(inout) :: line
      type(string_type), intent(in) :: arguments(:)
      integer, intent(out) :: used
      type(error_type), allocatable, intent(out) :: error
      type(command_entry) :: list(n_commands)
      character(len=12) :: names(n_commands)
      character(len=:), allocatable :: first, nearest, models
      integer :: i

      used = 1
      call find_command(arguments(1)%text, line%command)
      if (allocated(line%command)) return
      first = arguments(1)%text
      if (size(arguments) > 1) then
         if (.not. starts_with(arguments(2)%text, '-')) then
            used = 2
            first = first//' '//arguments(2)%text
            call find_command(first, line%command)
            if (allocated(line%command)) return
         end if
      end if

      call list_commands(list)
      models = ''
      do i = 1, size(list)
         names(i) = list(i)%command%name
         if (.not. starts_with(trim(names(i)), arguments(1)%text//' ')) cycle
         if (models /= '') models = models//' or '
         models = models//trim(names(i))
      end do
      if (models /= '' .and. used == 1) then
         line%topic = arguments(1)%text
         if (line%action /= asks_help) call fatal_error(error, arguments(1)%text// &
            ' needs a model: '//models)
         return
      end if
      if (models == '') first = arguments(1)%text
      nearest = nearest_name(first, [character(len=12) :: names, 'version', 'help'])
      if (nearest == '') then
         nearest = '; see asperity help'
      else
         nearest = '; did you mean '//nearest//'?'
      end if
      call fatal_error(error, 'unknown command '//quoted(first)//nearest)
   end subroutine find_words

   !> What stands after `help`: nothing, a command, --man, or --completion bash.
   subroutine parse_topic(line, arguments, error)
      type(command_line_type), intent(inout) :: line
      type(string_type), intent(in) :: arguments(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: used

      if (size(arguments) == 0) return
      used = 1
      if (any(help_words == arguments(1)%text) .or. any(version_words == arguments(1)%text)) then
         continue
      else if (arguments(1)%text == '--man') then
         line%action = asks_man
      else if (arguments(1)%text == '--completion') then
         line%action = asks_completion
         used = 2
         if (size(arguments) < 2) then
            call fatal_error(error, '--completion: needs a shell: bash')
         else if (arguments(2)%text /= 'bash') then
            call fatal_error(error, '--completion: '//quoted(arguments(2)%text)// &
               ' is unknown; known: bash')
         end if
      else
         call find_words(line, arguments, used, error)
      end if
      if (.not. allocated(error) .and. size(arguments) > used) call fatal_error(error, &
         quoted(arguments(used + 1)%text)//': help takes one command')
   end subroutine parse_topic

   !> Options and files of a command.
   subroutine parse_arguments(line, arguments, error)
      type(command_line_type), intent(inout) :: line
      type(string_type), intent(in) :: arguments(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: first, i
      logical :: is_known

      i = 0
      do while (i < size(arguments))
         i = i + 1
         if (arguments(i)%text == dash) then
            call take_file(line, standard_input, error)
         else if (starts_with(arguments(i)%text, '-')) then
            first = i
            call parse_option(line%keys, arguments, i, is_known, error)
            if (.not. is_known) call refuse_option(line, arguments(first)%text, error)
         else
            call take_file(line, arguments(i)%text, error)
         end if
         if (allocated(error)) return
      end do
   end subroutine parse_arguments

   !> Refuse an option that the command has not: suggest the nearest, or name the commands that have
   !> it.
   subroutine refuse_option(line, argument, error)
      type(command_line_type), intent(in) :: line
      character(len=*), intent(in) :: argument
      type(error_type), allocatable, intent(out) :: error
      character(len=32) :: names(line%keys%n)
      character(len=:), allocatable :: option, nearest
      integer :: i

      option = argument(:index(argument//'=', '=') - 1)
      if (owners(option) /= '') then
         call refuse_argument(trim(line%command%name), option, error)
         return
      end if
      do i = 1, line%keys%n
         names(i) = option_name(line%keys%rows(i)%name)
      end do
      nearest = nearest_key(option, names)
      if (nearest /= '') nearest = '; did you mean '//nearest//'?'
      call fatal_error(error, option//': unknown option of '//trim(line%command%name)//nearest)
   end subroutine refuse_option

   !> Refuse an option or a file of what takes none.
   subroutine refuse_argument(name, argument, error)
      character(len=*), intent(in) :: name, argument
      type(error_type), allocatable, intent(out) :: error

      if (.not. starts_with(argument, '-')) then
         call fatal_error(error, quoted(argument)//': '//name//' takes no case file')
      else if (owners(argument) == '') then
         call fatal_error(error, argument//': unknown option of '//name)
      else
         call fatal_error(error, argument//': is an option of '//owners(argument)//', not of '// &
            name)
      end if
   end subroutine refuse_argument

   !> A file that is no option's: the case file, or the next that the command reads.
   subroutine take_file(line, path, error)
      type(command_line_type), intent(inout) :: line
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error
      integer :: i, last
      logical :: is_case

      is_case = line%command%takes_case
      ! a command that reads another file as well knows a case by its ending
      if (any(line%keys%rows(:line%keys%n)%is_argument)) is_case = is_case .and. ends_as_case(path)
      if (is_case) then
         if (line%keys%case_path /= '') then
            call fatal_error(error, quoted(path)//': there is already the case file '// &
               quoted(line%keys%case_path)//', only one is taken')
         else if (path == '') then
            call fatal_error(error, 'the name of the case file is empty')
         else
            line%keys%case_path = path
         end if
         return
      end if
      last = 0
      do i = 1, line%keys%n
         if (.not. line%keys%rows(i)%is_argument) cycle
         last = i
         if (.not. line%keys%given(i) .or. line%keys%rows(i)%kind == kind_paths) exit
      end do
      if (last == 0) then
         call refuse_argument(trim(line%command%name), path, error)
         return
      end if
      associate (key => line%keys%rows(last))
         if (line%keys%given(last) .and. key%kind /= kind_paths) then
            call fatal_error(error, quoted(path)//': there is already the '//trim(key%reads)// &
               ' '//quoted(key%text)//', no further one is taken')
         else if (path == '') then
            call fatal_error(error, 'the name of the '//trim(key%reads)//' is empty')
         else
            if (line%keys%given(last)) then
               key%text = key%text//newline//path
            else
               key%text = path
            end if
            key%given = given_as_option
            key%has_value = .true.
            key%source = 'argument'
         end if
      end associate
   end subroutine take_file

   !> Whether a file is a case by its name.
   pure logical function ends_as_case(path)
      character(len=*), intent(in) :: path

      ends_as_case = index(path, case_ending, back=.true.) == len(path) - len(case_ending) + 1 &
         .and. len(path) > len(case_ending)
   end function ends_as_case

end module asperity_program_command_line
