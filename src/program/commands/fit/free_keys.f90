!> What --free, --fix, --bounds and --start say: names, and names with values, between commas.
module asperity_program_commands_fit_free_keys
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_program_input_key, only: assign_words, given_as_option, key_type, kind_choice, &
      kind_counts, kind_file, kind_list, kind_real, kind_text
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_nearest_key, only: nearest_key
   use asperity_program_input_ranges, only: split_words
   use asperity_program_input_values, only: read_real, word_type
   use asperity_program_system_strings, only: escaped, lower_case, quoted, string_type
   implicit none
   private
   public :: fix_keys, read_free, set_bounds, set_starts

contains

   !> Give the keys of `name=value,name=value` their values.
   subroutine fix_keys(text, keys, error)
      !> The text, empty for none
      character(len=*), intent(in) :: text
      !> Keys of the model
      type(key_list), intent(inout) :: keys
      !> Set when a key is unknown or a value does not fit it
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: option = '--fix'
      type(word_type), allocatable :: words(:)
      type(word_type) :: value(1)
      character(len=:), allocatable :: name
      integer :: i, place

      if (text == '') return
      call split_words(text, option, words, error)
      if (allocated(error)) return
      do i = 1, size(words)
         call split_pair(words(i)%text, option, 'VALUE', name, value(1)%text, error)
         if (.not. allocated(error)) call find_key(name, option, 'fixed', keys, place, error)
         if (allocated(error)) return
         associate (key => keys%rows(place))
            if (key%given == given_as_option) then
               call fatal_error(error, option//': '//name//' is given twice')
               return
            end if
            value(1)%source = option
            value(1)%in_quotes = any(key%kind == [kind_text, kind_choice])
            call assign_words(key, value, given_as_option, error)
         end associate
         if (allocated(error)) return
      end do
   end subroutine fix_keys

   !> The free keys of `name,name`.
   subroutine read_free(text, keys, free, error)
      !> The text
      character(len=*), intent(in) :: text
      !> Keys of the model, with what is fixed
      type(key_list), intent(in) :: keys
      !> Names of the keys
      type(string_type), allocatable, intent(out) :: free(:)
      !> Set when one is unknown, no real number, fixed, or named twice
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: option = '--free'
      type(word_type), allocatable :: words(:)
      integer :: i, j, place

      if (text == '') then
         call fatal_error(error, 'nothing is free: name keys of the model by '//option//' KEY,...')
         return
      end if
      call split_words(text, option, words, error)
      if (allocated(error)) return
      allocate (free(size(words)))
      do i = 1, size(words)
         call find_key(words(i)%text, option, 'free', keys, place, error)
         if (allocated(error)) return
         free(i)%text = trim(keys%rows(place)%name)
         if (keys%rows(place)%kind /= kind_real) then
            call fatal_error(error, option//': '//free(i)%text//' is no real number')
         else if (keys%rows(place)%given == given_as_option) then
            call fatal_error(error, option//': '//free(i)%text//' is also fixed, by '// &
               keys%rows(place)%source)
         else if (any([(free(j)%text == free(i)%text, j=1, i - 1)])) then
            call fatal_error(error, option//': '//free(i)%text//' is named twice')
         end if
         if (allocated(error)) return
      end do
   end subroutine read_free

   !> Set the bounds of `name=low:high,...`.
   subroutine set_bounds(text, parameters, error)
      !> The text, empty for none
      character(len=*), intent(in) :: text
      !> The free parameters
      type(fit_parameter), intent(inout) :: parameters(:)
      !> Set when one is not free or the bounds are faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: option = '--bounds'
      type(word_type), allocatable :: words(:)
      character(len=:), allocatable :: name, bounds
      logical :: given(size(parameters))
      real(wp) :: low, high
      integer :: colon, i, place

      if (text == '') return
      call split_words(text, option, words, error)
      if (allocated(error)) return
      given = .false.
      do i = 1, size(words)
         call split_pair(words(i)%text, option, 'LOW:HIGH', name, bounds, error)
         if (allocated(error)) return
         colon = index(bounds, ':')
         if (colon == 0) then
            call fatal_error(error, option//': '//quoted(words(i)%text)//' is not KEY=LOW:HIGH')
            return
         end if
         call find_parameter(name, option, parameters, given, place, error)
         if (.not. allocated(error)) call read_value(bounds(:colon - 1), name, option, low, error)
         if (.not. allocated(error)) call read_value(bounds(colon + 1:), name, option, high, error)
         if (allocated(error)) return
         associate (p => parameters(place))
            if (.not. low < high .or. (p%by_ratio .and. .not. low > 0.0_wp)) then
               call fatal_error(error, option//': '//quoted(words(i)%text)//': the first must '// &
                  'be below the second'//trim(merge(', and both above 0', '                  ', &
                  p%by_ratio)))
               return
            end if
            p%lower = low
            p%upper = high
            ! what was in the middle goes there again
            if (.not. (p%start > low .and. p%start < high)) then
               p%start = 0.5_wp*(low + high)
               if (p%by_ratio) p%start = sqrt(low)*sqrt(high)
            end if
         end associate
      end do
   end subroutine set_bounds

   !> Set the starts of `name=value,...`.
   subroutine set_starts(text, parameters, error)
      !> The text, empty for none
      character(len=*), intent(in) :: text
      !> The free parameters, with their bounds
      type(fit_parameter), intent(inout) :: parameters(:)
      !> Set when one is not free or no number
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: option = '--start'
      type(word_type), allocatable :: words(:)
      character(len=:), allocatable :: name, value
      logical :: given(size(parameters))
      integer :: i, place

      if (text == '') return
      call split_words(text, option, words, error)
      if (allocated(error)) return
      given = .false.
      do i = 1, size(words)
         call split_pair(words(i)%text, option, 'VALUE', name, value, error)
         if (.not. allocated(error)) &
            call find_parameter(name, option, parameters, given, place, error)
         if (.not. allocated(error)) &
            call read_value(value, name, option, parameters(place)%start, error)
         if (allocated(error)) return
      end do
   end subroutine set_starts

   !> The real number of a text.
   pure subroutine read_value(text, name, option, value, error)
      character(len=*), intent(in) :: text, name, option
      real(wp), intent(out) :: value
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: word

      word%text = text
      word%source = option
      call read_real(word, name, value, error)
   end subroutine read_value

   !> Both sides of `name=value`.
   pure subroutine split_pair(text, option, form, name, value, error)
      character(len=*), intent(in) :: text, option, form
      character(len=:), allocatable, intent(out) :: name, value
      type(error_type), allocatable, intent(out) :: error
      integer :: equals

      equals = index(text, '=')
      if (equals < 2) then
         call fatal_error(error, option//': '//quoted(text)//' is not KEY='//form)
         return
      end if
      name = text(:equals - 1)
      value = text(equals + 1:)
   end subroutine split_pair

   !> Place of a free parameter, which is given once.
   pure subroutine find_parameter(name, option, parameters, given, place, error)
      character(len=*), intent(in) :: name, option
      type(fit_parameter), intent(in) :: parameters(:)
      !> Which of them were given before
      logical, intent(inout) :: given(:)
      integer, intent(out) :: place
      type(error_type), allocatable, intent(out) :: error

      place = findloc(parameters%name == plain(name), .true., 1)
      if (place == 0) then
         call fatal_error(error, option//': '//quoted(name)//' is not free: name '// &
            'it by --free, too')
      else if (given(place)) then
         call fatal_error(error, option//': '//name//' is given twice')
      else
         given(place) = .true.
      end if
   end subroutine find_parameter

   !> Place of a key of the model; `error` says why it cannot be fixed or free.
   pure subroutine find_key(name, option, what, keys, place, error)
      character(len=*), intent(in) :: name, option, what
      type(key_list), intent(in) :: keys
      integer, intent(out) :: place
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: nearest

      place = keys%find(plain(name))
      if (place > 0) then
         if (.not. is_single(keys%rows(place))) &
            call fatal_error(error, option//': '//plain(name)//' cannot be '//what)
         return
      end if
      nearest = nearest_key(plain(name), pack(keys%rows(:keys%n)%name, &
         is_single(keys%rows(:keys%n))))
      if (nearest /= '') nearest = '; did you mean '//nearest//'?'
      call fatal_error(error, option//': the model has no key '//quoted(name)//nearest)
   end subroutine find_key

   !> Whether a key has one value.
   pure elemental logical function is_single(key)
      type(key_type), intent(in) :: key

      is_single = key%kind < kind_file .and. all(key%kind /= [kind_list, kind_counts])
   end function is_single

   !> A name as in case files.
   pure function plain(name)
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: plain

      plain = escaped(lower_case(name), '-', '_')
   end function plain

end module asperity_program_commands_fit_free_keys
