!> One option of the command line: which key it means, and its value.
module asperity_program_input_option
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_program_input_keys, only: belongs, command_names, keys, kind_choice, kind_file, &
      kind_list, kind_logical, kind_request, kind_sweep, kind_text, n_keys, option_name
   use asperity_program_input_ranges, only: read_range, split_words
   use asperity_program_input_settings, only: assign_values, assign_words, setting_type, &
      settings_type
   use asperity_program_input_values, only: word_type
   use asperity_program_system_strings, only: nearest_name, starts_with, string_type
   implicit none
   private
   public :: parse_option

contains

   !> The option at `arguments(i)`: `--name value`, `--name=value`, `--name` or `--no-name`.
   !> `error` names the option.
   pure subroutine parse_option(options, command, arguments, i, error)
      !> Values given as options so far
      type(settings_type), intent(inout) :: options
      !> Command that the option is for
      integer, intent(in) :: command
      !> All arguments
      type(string_type), intent(in) :: arguments(:)
      !> Place of the option; on return that of its value, if it took the next argument
      integer, intent(inout) :: i
      !> Set when the option or its value is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: option, value
      integer :: key, equals
      logical :: has_value, negated

      value = ''
      option = arguments(i)%text
      equals = index(option, '=')
      has_value = equals > 0
      if (has_value) then
         value = option(equals + 1:)
         option = option(:equals - 1)
      end if
      call find_option(command, option, key, negated, error)
      if (allocated(error)) return
      if (options%of(key)%given .and. keys(key)%kind /= kind_sweep) then
         call fatal_error(error, option//': is given twice')
         return
      end if

      if (keys(key)%kind == kind_request .or. negated) then
         if (has_value) then
            call fatal_error(error, option//': takes no value')
            return
         end if
         value = trim(merge('false', 'true ', negated))
      else if (keys(key)%kind == kind_logical) then
         if (.not. has_value) value = 'true'
      else if (.not. has_value) then
         if (i < size(arguments)) has_value = .not. starts_with(arguments(i + 1)%text, '--')
         if (.not. has_value) then
            call fatal_error(error, option//': needs a value')
            return
         end if
         i = i + 1
         value = arguments(i)%text
      end if

      call assign_option(options%of(key), key, option, value, error)
   end subroutine parse_option

   !> Key of an option; `error` suggests the nearest or names the command it belongs to.
   pure subroutine find_option(command, option, key, negated, error)
      integer, intent(in) :: command
      character(len=*), intent(in) :: option
      integer, intent(out) :: key
      logical, intent(out) :: negated
      type(error_type), allocatable, intent(out) :: error
      character(len=32) :: names(n_keys)
      character(len=:), allocatable :: nearest
      integer :: i
      logical :: is_negated

      key = 0
      negated = .false.
      do i = 1, n_keys
         names(i) = ''
         if (belongs(i, command)) names(i) = option_name(i)
         nearest = option_name(i)
         is_negated = keys(i)%kind == kind_logical .and. '--no-'//nearest(3:) == option
         if (option /= nearest .and. .not. is_negated) cycle
         ! of two keys of one name, that of the command
         if (key > 0 .and. .not. belongs(i, command)) cycle
         key = i
         negated = is_negated
         if (belongs(i, command)) exit
      end do
      if (key == 0) then
         nearest = nearest_name(option, names)
         if (nearest /= '') nearest = '; did you mean '//nearest//'?'
         call fatal_error(error, option//': unknown option of '//command_names(command)//nearest)
      else if (.not. belongs(key, command)) then
         call fatal_error(error, option//': is an option of '// &
            command_names(keys(key)%commands)//', not of '//command_names(command))
      end if
   end subroutine find_option

   !> Give an option its value.
   pure subroutine assign_option(setting, key, option, value, error)
      type(setting_type), intent(inout) :: setting
      integer, intent(in) :: key
      character(len=*), intent(in) :: option, value
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: word
      real(wp), allocatable :: values(:)

      if (keys(key)%kind /= kind_list) then
         word%text = value
         word%source = option
         word%in_quotes = any(keys(key)%kind == [kind_text, kind_choice, kind_file])
         call assign_words(setting, keys(key), [word], error)
      else if (index(value, ':') > 0) then
         call read_range(value, trim(keys(key)%name), option, values, error)
         if (allocated(error)) return
         call assign_values(setting, values, option)
         setting%given = .true.
      else
         call assign_list(setting, key, option, value, error)
      end if
   end subroutine assign_option

   !> Give an option the values of `a,b,c`.
   pure subroutine assign_list(setting, key, option, value, error)
      type(setting_type), intent(inout) :: setting
      integer, intent(in) :: key
      character(len=*), intent(in) :: option, value
      type(error_type), allocatable, intent(out) :: error
      type(word_type), allocatable :: words(:)

      call split_words(value, option, words, error)
      if (allocated(error)) return
      call assign_words(setting, keys(key), words, error)
   end subroutine assign_list

end module asperity_program_input_option
