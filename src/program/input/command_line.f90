!> Parses the command line, and nothing else, into one type.
module asperity_program_input_command_line
   use asperity_base_error, only: error_type, fatal_error
   use asperity_program_input_help, only: usage_text
   use asperity_program_input_keys, only: belongs, command_citation, command_curve, &
      command_deck_shear, command_deck_tenon, command_help, command_hysteresis, command_names, &
      command_pairs, command_press, command_shear, command_surface, command_table, command_tenon, &
      command_version, find_key
   use asperity_program_input_option, only: parse_option
   use asperity_program_input_settings, only: settings_type
   use asperity_program_system_strings, only: nearest_name, quoted, starts_with, string_type
   implicit none
   private
   public :: command_line_type, parse_command_line

   !> What the command line asks for.
   type :: command_line_type
      !> One of the commands of `asperity_program_input_keys`
      integer :: command = 0
      !> Command that help is asked about, zero for all
      integer :: topic = 0
      !> Path of the case file, empty when there is none
      character(len=:), allocatable :: case_path
      !> Values given as options
      type(settings_type) :: options
   end type command_line_type

   character(len=*), parameter :: command_words(*) = [character(len=10) :: &
      'curve', 'press', 'shear', 'tenon', 'table', 'deck shear', 'deck tenon', 'hysteresis', &
      'surface', 'pairs', 'version', 'help', '--version', '--help', '-h', '--citation']
   integer, parameter :: command_codes(*) = [command_curve, command_press, command_shear, &
      command_tenon, command_table, command_deck_shear, command_deck_tenon, command_hysteresis, &
      command_surface, command_pairs, &
      command_version, command_help, command_version, command_help, command_help, &
      command_citation]

   !> First word of the commands that have two
   character(len=*), parameter :: deck = 'deck'

contains

   !> Parse the arguments of the program.
   subroutine parse_command_line(line, error)
      !> What they ask for
      type(command_line_type), intent(out) :: line
      !> Set when they are faulty
      type(error_type), allocatable, intent(out) :: error
      type(string_type), allocatable :: arguments(:)
      integer :: i

      line%case_path = ''
      call get_arguments(arguments)
      if (size(arguments) == 0) then
         call fatal_error(error, 'no command is given'//usage_text())
         return
      end if
      call join_words(arguments, 1)
      call find_command(arguments(1)%text, line%command, error)
      if (allocated(error)) return
      if (line%command == command_help) call join_words(arguments, 2)
      do i = 2, size(arguments)
         if (arguments(i)%text /= '--help' .and. arguments(i)%text /= '-h') cycle
         line%topic = line%command
         line%command = command_help
         return
      end do

      select case (line%command)
      case (command_help)
         call parse_topic(line, arguments(2:), error)
      case default
         call parse_arguments(line, arguments(2:), error)
      end select
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

   !> Make one word of `deck` and the model that follows it.
   pure subroutine join_words(arguments, place)
      type(string_type), allocatable, intent(inout) :: arguments(:)
      integer, intent(in) :: place

      if (size(arguments) <= place) return
      if (arguments(place)%text /= deck .or. starts_with(arguments(place + 1)%text, '-')) return
      arguments(place)%text = deck//' '//arguments(place + 1)%text
      arguments = [arguments(:place), arguments(place + 2:)]
   end subroutine join_words

   !> Command of a word.
   pure subroutine find_command(word, command, error)
      character(len=*), intent(in) :: word
      integer, intent(out) :: command
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: nearest
      integer :: i

      command = 0
      do i = 1, size(command_words)
         if (command_words(i) == word) command = command_codes(i)
      end do
      if (command /= 0) return
      if (word == deck) then
         call fatal_error(error, 'deck needs a model: deck shear or deck tenon')
         return
      end if
      nearest = nearest_name(word, command_words)
      if (nearest == '') then
         nearest = '; see asperity help'
      else
         nearest = '; did you mean '//nearest//'?'
      end if
      call fatal_error(error, 'unknown command '//quoted(word)//nearest)
   end subroutine find_command

   !> `asperity help [command]`.
   pure subroutine parse_topic(line, arguments, error)
      type(command_line_type), intent(inout) :: line
      type(string_type), intent(in) :: arguments(:)
      type(error_type), allocatable, intent(out) :: error

      if (size(arguments) > 1) then
         call fatal_error(error, quoted(arguments(2)%text)//': help takes one command')
      else if (size(arguments) == 1) then
         call find_command(arguments(1)%text, line%topic, error)
      end if
   end subroutine parse_topic

   !> Options and case file of a command.
   subroutine parse_arguments(line, arguments, error)
      type(command_line_type), intent(inout) :: line
      type(string_type), intent(in) :: arguments(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      i = 0
      do while (i < size(arguments))
         i = i + 1
         if (starts_with(arguments(i)%text, '-')) then
            call parse_option(line%options, line%command, arguments, i, error)
         else if (line%command == command_hysteresis) then
            call take_file(line, 'record_file', 'record', arguments(i)%text, error)
         else if (line%command == command_surface &
               .and. line%options%given('map_file')) then
            call take_file(line, 'second_map', 'second map', arguments(i)%text, error)
         else if (line%command == command_surface) then
            call take_file(line, 'map_file', 'map', arguments(i)%text, error)
         else
            call take_case(line, arguments(i)%text, error)
         end if
         if (allocated(error)) return
      end do
   end subroutine parse_arguments

   !> The one argument that is not an option.
   pure subroutine take_case(line, path, error)
      type(command_line_type), intent(inout) :: line
      character(len=*), intent(in) :: path
      type(error_type), allocatable, intent(out) :: error

      if (.not. belongs(find_key('pair'), line%command)) then
         call fatal_error(error, quoted(path)//': '//command_names(line%command)// &
            ' takes no case file')
      else if (line%case_path /= '') then
         call fatal_error(error, quoted(path)//': there is already the case file '// &
            quoted(line%case_path)//', only one is taken')
      else if (path == '') then
         call fatal_error(error, 'the name of the case file is empty')
      else
         line%case_path = path
      end if
   end subroutine take_case

   !> A file to read that is not an option.
   pure subroutine take_file(line, name, what, path, error)
      type(command_line_type), intent(inout) :: line
      character(len=*), intent(in) :: name, what, path
      type(error_type), allocatable, intent(out) :: error

      associate (setting => line%options%of(find_key(name)))
         if (setting%given) then
            call fatal_error(error, quoted(path)//': there is already the '//what//' '// &
               quoted(setting%text)//', no further one is taken')
         else if (path == '') then
            call fatal_error(error, 'the name of the '//what//' is empty')
         else
            setting%given = .true.
            setting%has_value = .true.
            setting%source = 'argument'
            setting%text = path
         end if
      end associate
   end subroutine take_file

end module asperity_program_input_command_line
