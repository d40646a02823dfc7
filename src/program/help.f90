!> Help texts, made from the commands and their keys.
module asperity_program_help
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_registry, only: command_entry, list_commands, n_commands
   use asperity_program_input_key, only: key_type, kind_choice, kind_counts, kind_file, &
      kind_integer, kind_list, kind_logical, kind_paths, kind_picture, kind_place, kind_real, &
      kind_sweep, kind_text, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_strings, only: escaped, newline, starts_with, wrapped
   implicit none
   private
   public :: usage_text, overview, topic_help, command_help
   public :: option_words, key_words, group_title, in_group, case_words, status_words

   !> Columns at which the explanations of options and of commands start
   integer, parameter :: option_column = 30, command_column = 14
   !> Characters of a line of an error
   integer, parameter :: error_width = 80
   !> Groups of keys in help: properties, test, output
   integer, parameter, public :: n_groups = 3
   !> What a case file is, and what the exit status means
   character(len=*), parameter :: case_words = 'A case file holds one group &asperity ... / of '// &
      'key = value; every key is also an option, with - for _, which overrides it; values '// &
      'override --surface, that --pair. asperity COMMAND --print-case writes a case file of '// &
      'all input; - reads one from standard input.', status_words = 'Exit status: 0 done, 1 '// &
      'computation failed, 2 bad input, 3 file not read or written.'

contains

   !> How to call the program, in a few lines; begins with a line break.
   function usage_text() result(text)
      character(len=:), allocatable :: text
      type(command_entry) :: list(n_commands)
      type(growing_text) :: b, names
      integer :: i

      call list_commands(list)
      do i = 1, size(list)
         call names%add(trim(list(i)%command%name)//', ')
      end do
      call b%line()
      call b%line('usage: asperity COMMAND [FILE] [options]')
      call b%line(wrapped('commands: '//names%text()//'version, help', error_width, 0))
      call b%add('help: asperity help [COMMAND]')
      text = b%text()
   end function usage_text

   !> The overview of all commands.
   function overview(width) result(text)
      !> Columns of the terminal
      integer, intent(in) :: width
      character(len=:), allocatable :: text
      type(command_entry) :: list(n_commands)
      type(growing_text) :: b
      integer :: i

      call list_commands(list)
      call b%line('asperity '//version//': elasto-plastic contact of rough timber faces')
      call b%line()
      call b%line('usage: asperity COMMAND [CASE.nml] [options]')
      call b%line()
      do i = 1, size(list)
         call add_item(b, trim(list(i)%command%name), trim(list(i)%command%summary), &
            command_column, width)
      end do
      call add_item(b, 'version', 'version, also --version and -V', command_column, width)
      call add_item(b, 'help', 'this text; asperity help COMMAND for one command', &
         command_column, width)
      call b%line()
      call add_item(b, '--citation', 'what to cite', command_column, width)
      call b%line()
      call b%line(wrapped(case_words, width, 0))
      call b%line()
      call b%line(wrapped(status_words, width, 0))
      text = b%text()
   end function overview

   !> The commands that begin with a word.
   function topic_help(topic, width) result(text)
      !> The word, such as `deck`
      character(len=*), intent(in) :: topic
      !> Columns of the terminal
      integer, intent(in) :: width
      character(len=:), allocatable :: text
      type(command_entry) :: list(n_commands)
      type(growing_text) :: b
      integer :: i

      call list_commands(list)
      do i = 1, size(list)
         associate (command => list(i)%command)
            if (starts_with(trim(command%name), topic//' ')) &
               call add_item(b, trim(command%name), trim(command%summary), command_column, width)
         end associate
      end do
      call b%line()
      call b%line('help: asperity help '//topic//' MODEL')
      text = b%text()
   end function topic_help

   !> Usage, purpose and options of one command.
   function command_help(command, width) result(text)
      !> The command
      class(command_type), intent(in) :: command
      !> Columns of the terminal
      integer, intent(in) :: width
      character(len=:), allocatable :: text
      class(command_type), allocatable :: own
      type(key_list) :: keys
      type(growing_text) :: b
      integer :: i, group

      allocate (own, source=command)
      call own%declare(keys)
      call b%line('usage: asperity '//trim(command%name)//' '//escaped(command%usage, newline, &
         newline//'       asperity '//trim(command%name)//' '))
      call b%line()
      call b%line(wrapped(command%purpose, width, 0))
      do group = 1, n_groups
         if (count([(in_group(keys%rows(i), group), i=1, keys%n)]) == 0) cycle
         call b%line()
         call b%line(group_title(command, group)//':')
         do i = 1, keys%n
            if (in_group(keys%rows(i), group)) call add_item(b, option_words(keys%rows(i)), &
               key_words(keys%rows(i)), option_column, width)
         end do
      end do
      text = b%text()
   end function command_help

   !> Heading of a group of keys.
   pure function group_title(command, group) result(text)
      !> The command
      class(command_type), intent(in) :: command
      !> The group
      integer, intent(in) :: group
      character(len=:), allocatable :: text

      text = 'Output'
      if (group < n_groups) text = trim(command%headings(group))
   end function group_title

   !> Whether a key is shown among the properties (1), the test (2) or the output (3).
   pure logical function in_group(key, group)
      !> The key
      type(key_type), intent(in) :: key
      !> The group
      integer, intent(in) :: group
      integer :: own

      own = 2
      if (key%is_property) own = 1
      if (key%kind >= kind_file) own = n_groups
      in_group = own == group
   end function in_group

   !> An option and its value.
   pure function option_words(key) result(text)
      !> Its key
      type(key_type), intent(in) :: key
      character(len=:), allocatable :: text

      text = option_name(key%name)
      select case (key%kind)
      case (kind_logical)
         text = '--[no-]'//text(3:)
      case (kind_text, kind_choice)
         text = text//' NAME'
      case (kind_real)
         text = text//' NUMBER'
      case (kind_integer)
         text = text//' COUNT'
      case (kind_list, kind_counts)
         text = text//' LIST'
      case (kind_paths)
         text = text//' FILES'
      case (kind_file, kind_picture)
         text = text//' FILE'
      case (kind_place)
         text = text//' PATH'
      case (kind_sweep)
         text = text//' NAME=VALUES'
      case default
         continue
      end select
   end function option_words

   !> What a key is: explanation, choices, unit, default.
   pure function key_words(key) result(text)
      !> The key
      type(key_type), intent(in) :: key
      character(len=:), allocatable :: text

      text = trim(key%help)
      if (key%choices /= '') text = text//': '//escaped(trim(key%choices), ' ', ' or ')
      if (key%unit /= '') text = text//', '//trim(key%unit)
      if (key%default /= '') text = text//' ['//trim(key%default)//']'
   end function key_words

   !> A name and, from a column on, what it is.
   pure subroutine add_item(b, name, words, column, width)
      type(growing_text), intent(inout) :: b
      character(len=*), intent(in) :: name, words
      integer, intent(in) :: column, width
      character(len=:), allocatable :: left

      left = '  '//name
      if (len(left) + 1 >= column) then
         call b%line(left)
         left = ''
      end if
      call b%line(wrapped(left//repeat(' ', column - 1 - len(left))//words, width, column - 1))
   end subroutine add_item

end module asperity_program_help
