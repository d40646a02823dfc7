!> Values of the keys (see keys.f90): what was given, where, and its conversion from text.
module asperity_program_input_settings
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_input_keys, only: find_key, key_type, keys, kind_choice, kind_file, &
      kind_integer, kind_list, kind_logical, kind_real, kind_sweep, kind_text, n_keys
   use asperity_program_input_ranges, only: longest_list, split_words
   use asperity_program_input_values, only: read_integer, read_logical, read_real, refuse, word_type
   use asperity_program_system_strings, only: escaped, lower_case, quoted
   implicit none
   private
   public :: setting_type, settings_type, assign_words, assign_values, forget, default_settings, &
      take_defaults

   !> Value of one key.
   type :: setting_type
      !> Given in the case file or as an option
      logical :: given = .false.
      !> Has a value: given, or by default
      logical :: has_value = .false.
      !> Not given, and made from another key
      logical :: follows = .false.
      !> Of no effect on this run, so that no listing shows it
      logical :: unused = .false.
      !> Where the value comes from, such as `case.nml:4`, `--sigma` or `default`
      character(len=:), allocatable :: source
      !> Value of a text, a choice or a file; sweeps, separated by blanks
      character(len=:), allocatable :: text
      !> Values of a list, value of a real number
      real(wp), allocatable :: values(:)
      !> Value of a whole number
      integer :: whole = 0
      !> Value of a logical
      logical :: switch = .false.
   end type setting_type

   !> Values of all keys.
   type :: settings_type
      !> In the order of the table of keys
      type(setting_type) :: of(n_keys)
   contains
      !> Whether a key was given
      procedure :: given
      !> Value of a real number
      procedure :: real_of
      !> Value of a text, a choice or a file; empty when there is none
      procedure :: text_of
      !> Value of a logical or of a request
      procedure :: switch_of
      !> Value of a whole number
      procedure :: whole_of
      !> Unit of a key, empty for none
      procedure :: unit_of
   end type settings_type

contains

   !> Settings with the defaults of the table.
   pure function default_settings() result(settings)
      type(settings_type) :: settings
      type(word_type), allocatable :: words(:)
      type(error_type), allocatable :: error
      integer :: key

      do key = 1, n_keys
         associate (setting => settings%of(key))
            setting%source = 'default'
            if (keys(key)%default == '') cycle
            call split_words(trim(keys(key)%default), 'default', words, error)
            words%in_quotes = any(keys(key)%kind == [kind_text, kind_choice])
            call assign_words(setting, keys(key), words, error)
            setting%given = .false.
         end associate
      end do
   end function default_settings

   !> Give every key that was not given as an option its default.
   pure subroutine take_defaults(settings)
      !> Options on entry, settings in effect on return
      type(settings_type), intent(inout) :: settings
      type(settings_type) :: defaults
      integer :: key

      defaults = default_settings()
      do key = 1, n_keys
         if (.not. settings%of(key)%given) settings%of(key) = defaults%of(key)
      end do
   end subroutine take_defaults

   !> Give a key the value that some words mean. `error` names their place.
   pure subroutine assign_words(setting, key, words, error)
      !> The setting to fill
      type(setting_type), intent(inout) :: setting
      !> Its row in the table
      type(key_type), intent(in) :: key
      !> What was written; of no matter for a request
      type(word_type), intent(in) :: words(:)
      !> Set when the words do not fit the key
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      setting%given = .true.
      setting%has_value = .true.
      setting%source = words(1)%source
      if (key%kind /= kind_list .and. size(words) > 1) then
         call refuse(error, words(2), trim(key%name)//' takes one value, found also '// &
            quoted(words(2)%text))
         return
      end if

      select case (key%kind)
      case (kind_text, kind_choice, kind_file)
         call assign_text(setting, key, words(1), error)
      case (kind_real, kind_list)
         if (size(words) > longest_list) then
            call refuse(error, words(1), trim(key%name)//' has too many values')
            return
         end if
         if (allocated(setting%values)) deallocate (setting%values)
         allocate (setting%values(size(words)))
         do i = 1, size(words)
            call read_real(words(i), trim(key%name), setting%values(i), error)
            if (allocated(error)) return
         end do
      case (kind_integer)
         call read_integer(words(1), trim(key%name), setting%whole, error)
      case (kind_logical)
         call read_logical(words(1), trim(key%name), setting%switch, error)
      case (kind_sweep)
         ! One after the other, as it may be given again
         if (allocated(setting%text)) then
            setting%text = setting%text//' '//words(1)%text
         else
            setting%text = words(1)%text
         end if
      case default
         setting%switch = .true.
      end select
   end subroutine assign_words

   pure subroutine assign_text(setting, key, word, error)
      type(setting_type), intent(inout) :: setting
      type(key_type), intent(in) :: key
      type(word_type), intent(in) :: word
      type(error_type), allocatable, intent(out) :: error

      if (.not. word%in_quotes) then
         call refuse(error, word, trim(key%name)//' is a text and needs quotes: '// &
            trim(key%name)//" = '"//word%text//"'")
         return
      end if
      setting%text = word%text
      if (key%kind == kind_choice) then
         setting%text = lower_case(word%text)
         if (index(' '//trim(key%choices)//' ', ' '//setting%text//' ') == 0 &
            .or. setting%text == '') call refuse(error, word, trim(key%name)//' = '// &
            quoted(word%text)//' is unknown; known: '//escaped(trim(key%choices), ' ', ', '))
      else if (word%text == '') then
         call refuse(error, word, trim(key%name)//' is empty')
      end if
   end subroutine assign_text

   !> Give a key values that come from elsewhere than the user.
   pure subroutine assign_values(setting, values, source)
      !> The setting to fill
      type(setting_type), intent(inout) :: setting
      !> Its values; one for a real number
      real(wp), intent(in) :: values(:)
      !> Where they come from
      character(len=*), intent(in) :: source

      setting%has_value = .true.
      setting%source = source
      if (allocated(setting%values)) deallocate (setting%values)
      allocate (setting%values, source=values)
   end subroutine assign_values

   !> Take the value of a key away that has no default.
   pure subroutine forget(setting)
      !> The setting
      type(setting_type), intent(inout) :: setting

      setting%given = .false.
      setting%has_value = .false.
      setting%source = 'default'
      if (allocated(setting%text)) deallocate (setting%text)
      if (allocated(setting%values)) deallocate (setting%values)
   end subroutine forget

   !> Whether a key was given.
   pure logical function given(self, name)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name

      given = self%of(find_key(name))%given
   end function given

   !> Value of a real number.
   pure real(wp) function real_of(self, name)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name

      real_of = self%of(find_key(name))%values(1)
   end function real_of

   !> Value of a text, a choice or a file; empty when there is none.
   pure function text_of(self, name) result(text)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: text

      text = ''
      if (allocated(self%of(find_key(name))%text)) text = self%of(find_key(name))%text
   end function text_of

   !> Value of a logical or of a request.
   pure logical function switch_of(self, name)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name

      switch_of = self%of(find_key(name))%switch
   end function switch_of

   !> Value of a whole number.
   pure integer function whole_of(self, name)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Name of the key
      character(len=*), intent(in) :: name

      whole_of = self%of(find_key(name))%whole
   end function whole_of

   !> Unit of a key, empty for none. That of `peak` follows from `control`.
   pure function unit_of(self, key) result(unit)
      !> The settings
      class(settings_type), intent(in) :: self
      !> Place of the key in the table
      integer, intent(in) :: key
      character(len=:), allocatable :: unit

      unit = trim(keys(key)%unit)
      if (keys(key)%name == 'peak') &
         unit = trim(merge('mm ', 'MPa', self%text_of('control') == 'overclosure'))
   end function unit_of

end module asperity_program_input_settings
