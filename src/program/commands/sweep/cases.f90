!> What `--sweep NAME=values` asks for: every combination of the values of some keys.
module asperity_program_commands_sweep_cases
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_faces_read_faces, only: read_face
   use asperity_program_input_key, only: assign_words, given_as_option, key_type, kind_choice, &
      kind_counts, kind_file, kind_integer, kind_list, kind_paths, kind_real, kind_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_nearest_key, only: nearest_key
   use asperity_program_input_ranges, only: read_range, split_words
   use asperity_program_input_values, only: word_type
   use asperity_program_system_strings, only: escaped, lower_case, quoted
   implicit none
   private
   public :: axis_type, new_axes, combinations, places_of, set_case

   !> Most combinations
   integer, parameter :: most_cases = 100000
   character(len=*), parameter :: option = '--sweep'
   !> Keys that say how a record is read
   character(len=*), parameter :: of_record(*) = [character(len=20) :: 'history', &
      'history_quantity', 'displacement_column', 'where', 'separator', 'decimal', 'skip_lines', &
      'displacement_unit']

   !> A key and the values that it takes.
   type :: axis_type
      !> Place of the key
      integer :: key = 0
      !> The key with each value
      type(key_type), allocatable :: values(:)
   end type axis_type

contains

   !> Axes of all sweeps. `error` is set when one is faulty or there are too many combinations.
   subroutine new_axes(axes, text, keys, error)
      !> One axis per sweep, in the order given
      type(axis_type), allocatable, intent(out) :: axes(:)
      !> The sweeps, separated by blanks
      character(len=*), intent(in) :: text
      !> Keys of the command
      type(key_list), intent(in) :: keys
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(word_type), allocatable :: words(:)
      integer :: i, first, last

      first = 1
      allocate (axes(count([(text(i:i) == ' ', i=1, len(text))]) + 1))
      do i = 1, size(axes)
         last = first + index(text(first:)//' ', ' ') - 2
         call new_axis(axes(i), text(first:last), keys, words, error)
         if (allocated(error)) return
         if (any(axes(:i - 1)%key == axes(i)%key)) then
            call fatal_error(error, option//': '//trim(keys%rows(axes(i)%key)%name)// &
               ' is swept twice')
            return
         end if
         first = last + 2
      end do
      if (product([(real(size(axes(i)%values), wp), i=1, size(axes))]) > most_cases) &
         call fatal_error(error, option//': more than '//to_text(most_cases)//' combinations')
   end subroutine new_axes

   !> One axis from `name=values`.
   subroutine new_axis(axis, text, keys, words, error)
      type(axis_type), intent(inout) :: axis
      character(len=*), intent(in) :: text
      type(key_list), intent(in) :: keys
      type(word_type), allocatable, intent(inout) :: words(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: equals, i

      equals = index(text, '=')
      if (equals == 0) then
         call fatal_error(error, option//': '//quoted(text)//' is not NAME=values')
         return
      end if
      call find_axis(axis%key, text(:equals - 1), keys, error)
      if (.not. allocated(error)) &
         call read_values(words, text(equals + 1:), keys%rows(axis%key), error)
      if (allocated(error)) return
      allocate (axis%values(size(words)))
      do i = 1, size(words)
         associate (key => axis%values(i))
            key = keys%rows(axis%key)
            words(i)%source = option//' '//trim(key%name)//'='//words(i)%text
            words(i)%in_quotes = any(key%kind == [kind_text, kind_choice])
            call assign_words(key, words(i:i), given_as_option, error)
            if (.not. allocated(error)) call read_face(key, error)
         end associate
         if (allocated(error)) return
      end do
   end subroutine new_axis

   !> Key of a name, with `-` or `_`; `error` says why it cannot be swept.
   subroutine find_axis(place, name, keys, error)
      integer, intent(out) :: place
      character(len=*), intent(in) :: name
      type(key_list), intent(in) :: keys
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: plain, nearest

      plain = escaped(lower_case(name), '-', '_')
      place = keys%find(plain)
      if (place > 0) then
         if (.not. can_be_swept(keys%rows(place))) &
            call fatal_error(error, option//': '//plain//' cannot be swept')
         return
      end if
      nearest = nearest_key(plain, pack(keys%rows(:keys%n)%name, &
         can_be_swept(keys%rows(:keys%n))))
      if (nearest /= '') nearest = '; did you mean '//nearest//'?'
      call fatal_error(error, option//': unknown key '//quoted(name)//nearest)
   end subroutine find_axis

   !> Whether a key has one value, and not one that says how a record is read.
   pure elemental logical function can_be_swept(key)
      type(key_type), intent(in) :: key

      can_be_swept = key%kind < kind_file .and. all(key%name /= of_record) &
         .and. all(key%kind /= [kind_list, kind_counts, kind_paths])
   end function can_be_swept

   !> Values `a,b,c` or `start:stop:count` as words.
   subroutine read_values(words, text, key, error)
      type(word_type), allocatable, intent(inout) :: words(:)
      character(len=*), intent(in) :: text
      type(key_type), intent(in) :: key
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:)
      integer :: i

      if (index(text, ':') == 0 .or. all(key%kind /= [kind_real, kind_integer])) then
         call split_words(text, option, words, error)
         return
      end if
      call read_range(text, trim(key%name), option, values, error)
      if (allocated(error)) return
      if (allocated(words)) deallocate (words)
      allocate (words(size(values)))
      do i = 1, size(values)
         if (key%kind == kind_integer .and. .not. abs(values(i) - anint(values(i))) > 0.0_wp &
               .and. abs(values(i)) < 1.0e9_wp) then
            words(i)%text = to_text(nint(values(i)))
         else
            words(i)%text = to_text(values(i))
         end if
      end do
   end subroutine read_values

   !> How many combinations there are.
   pure integer function combinations(axes)
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      integer :: i

      combinations = product([(size(axes(i)%values), i=1, size(axes))])
   end function combinations

   !> Place of the value that one combination takes on each axis; the last axis varies fastest.
   pure function places_of(axes, which) result(chosen)
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> Combination, from 1
      integer, intent(in) :: which
      integer :: chosen(size(axes))
      integer :: i, rest

      rest = which - 1
      do i = size(axes), 1, -1
         chosen(i) = 1 + modulo(rest, size(axes(i)%values))
         rest = rest/size(axes(i)%values)
      end do
   end function places_of

   !> Set the keys of one combination.
   pure subroutine set_case(keys, axes, which)
      !> Keys, of which those swept take their values
      type(key_list), intent(inout) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> Combination, from 1
      integer, intent(in) :: which
      integer :: chosen(size(axes)), i

      chosen = places_of(axes, which)
      do i = 1, size(axes)
         keys%rows(axes(i)%key) = axes(i)%values(chosen(i))
      end do
   end subroutine set_case

end module asperity_program_commands_sweep_cases
