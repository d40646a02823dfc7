!> Options of the command line: which key one means, and its value.
module asperity_program_input_options
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_program_input_key, only: assign_words, given_as_option, key_type, kind_choice, &
      kind_counts, kind_file, kind_list, kind_logical, kind_paths, kind_picture, kind_place, &
      kind_request, kind_sweep, kind_text, option_name
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_ranges, only: read_range, split_words
   use asperity_program_input_values, only: word_type
   use asperity_program_system_strings, only: starts_with, string_type
   implicit none
   private
   public :: find_option, parse_option

contains

   !> Place of the key that an option means, zero for none.
   pure subroutine find_option(keys, option, place, negated)
      !> Keys of the command
      type(key_list), intent(in) :: keys
      !> The option, without its value
      character(len=*), intent(in) :: option
      !> Place of its key
      integer, intent(out) :: place
      !> It is `--no-name`
      logical, intent(out) :: negated
      character(len=:), allocatable :: name

      do place = keys%n, 1, -1
         name = option_name(keys%rows(place)%name)
         negated = keys%rows(place)%kind == kind_logical .and. '--no-'//name(3:) == option
         if (name == option .or. negated) return
      end do
   end subroutine find_option

   !> The option at `arguments(i)`: `--name value`, `--name=value`, `--name` or `--no-name`; paths
   !> are all up to the next option. `error` names the option.
   pure subroutine parse_option(keys, arguments, i, is_known, error)
      !> Keys of the command; that of the option takes the value
      type(key_list), intent(inout) :: keys
      !> All arguments
      type(string_type), intent(in) :: arguments(:)
      !> Place of the option; on return that of its value, if it took the next argument
      integer, intent(inout) :: i
      !> Whether the command has such an option; nothing is done if it has not
      logical, intent(out) :: is_known
      !> Set when the option or its value is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: option, value
      integer :: place, equals
      logical :: has_value, negated

      value = ''
      option = arguments(i)%text
      equals = index(option, '=')
      has_value = equals > 0
      if (has_value) then
         value = option(equals + 1:)
         option = option(:equals - 1)
      end if
      call find_option(keys, option, place, negated)
      is_known = place > 0
      if (.not. is_known) return
      associate (key => keys%rows(place))
         if (keys%given(place) .and. all(key%kind /= [kind_paths, kind_sweep])) then
            call fatal_error(error, option//': is given twice')
            return
         end if

         if (key%kind == kind_request .or. negated) then
            if (has_value) then
               call fatal_error(error, option//': takes no value')
               return
            end if
            value = trim(merge('false', 'true ', negated))
         else if (key%kind == kind_logical) then
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
         call assign_option(key, option, value, error)
         if (key%kind /= kind_paths) return
         do while (i < size(arguments) .and. .not. allocated(error))
            if (starts_with(arguments(i + 1)%text, '-')) exit
            i = i + 1
            call assign_option(key, option, arguments(i)%text, error)
         end do
      end associate
   end subroutine parse_option

   !> Give an option its value: a word, `a,b,c` or `start:stop:count`.
   pure subroutine assign_option(key, option, value, error)
      type(key_type), intent(inout) :: key
      character(len=*), intent(in) :: option, value
      type(error_type), allocatable, intent(out) :: error
      type(word_type), allocatable :: words(:)
      real(wp), allocatable :: values(:)

      if (key%kind /= kind_list .and. key%kind /= kind_counts) then
         allocate (words(1))
         words(1)%text = value
         words(1)%source = option
         words(1)%in_quotes = any(key%kind == [kind_text, kind_choice, kind_paths, kind_file, &
            kind_picture, kind_place])
         call assign_words(key, words, given_as_option, error)
      else if (index(value, ':') > 0) then
         call read_range(value, trim(key%name), option, values, error)
         if (allocated(error)) return
         key%values = values
         key%source = option
         key%given = given_as_option
         key%has_value = .true.
      else
         call split_words(value, option, words, error)
         if (.not. allocated(error)) call assign_words(key, words, given_as_option, error)
      end if
   end subroutine assign_option

end module asperity_program_input_options
