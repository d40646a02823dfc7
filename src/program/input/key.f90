!> One key: what may be set, and its value, given by the user or not.
module asperity_program_input_key
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_input_ranges, only: longest_list
   use asperity_program_input_values, only: read_integer, read_logical, read_real, refuse, word_type
   use asperity_program_system_strings, only: escaped, lower_case, newline, quoted
   implicit none
   private
   public :: key_type, assign_words, option_name, forget

   integer, parameter, public :: name_length = 34

   !> Kinds of values
   enum, bind(c)
      !> One text
      enumerator :: kind_text = 1
      !> One of the texts in `choices`
      enumerator :: kind_choice
      !> One real number
      enumerator :: kind_real
      !> One whole number
      enumerator :: kind_integer
      !> True or false
      enumerator :: kind_logical
      !> Real numbers
      enumerator :: kind_list
      !> Whole numbers of at least zero
      enumerator :: kind_counts
      !> Paths of files that are read
      enumerator :: kind_paths
      !> Path of a file that is written; an option only, as all that follow
      enumerator :: kind_file
      !> Path of a file that gnuplot draws
      enumerator :: kind_picture
      !> Folder, or stem of several paths, for files that the command itself writes
      enumerator :: kind_place
      !> Something asked for
      enumerator :: kind_request
      !> A key and its values, `name=values`, which may be given again
      enumerator :: kind_sweep
   end enum
   public :: kind_text, kind_choice, kind_real, kind_integer, kind_logical, kind_list, &
      kind_counts, kind_paths, kind_file, kind_picture, kind_place, kind_request, kind_sweep

   !> Where a value was given
   enum, bind(c)
      !> Nowhere
      enumerator :: given_nowhere = 0
      !> In the case file
      enumerator :: given_in_case
      !> As an option
      enumerator :: given_as_option
   end enum
   public :: given_nowhere, given_in_case, given_as_option

   !> A key and its value.
   type :: key_type
      !> Name in case files; the option has `-` for `_`
      character(len=name_length) :: name = ''
      !> One of the kinds above
      integer :: kind = kind_text
      !> A property of the faces rather than of the test done on them
      logical :: is_property = .false.
      !> Unit of the value, blank for none
      character(len=8) :: unit = ''
      !> Values allowed for `kind_choice`, separated by blanks
      character(len=40) :: choices = ''
      !> Value when not given, for help; blank when it follows from others
      character(len=32) :: default = ''
      !> What it is
      character(len=100) :: help = ''
      !> Names in the errors of the library that mean this key, separated by blanks
      character(len=64) :: subjects = ''
      !> What the file is that a text names and that is read, blank when it is none
      character(len=12) :: reads = ''
      !> An argument without an option does, too
      logical :: is_argument = .false.

      !> Where its value was given
      integer :: given = given_nowhere
      !> Has a value: given, or by default
      logical :: has_value = .false.
      !> Place of the key that gives the value where it is not given, zero for none
      integer :: leader = 0
      !> Not given, and to change with the leader, so that no case file fixes it
      logical :: follows = .false.
      !> Of no effect on this run, so that no listing shows it
      logical :: unused = .false.
      !> Where the value comes from, such as `case.nml:4`, `--sigma` or `default`
      character(len=:), allocatable :: source
      !> Value of a text, a choice or a file; sweeps, separated by blanks; paths, by line breaks
      character(len=:), allocatable :: text
      !> Values of a list, value of a real number
      real(wp), allocatable :: values(:)
      !> Value of a whole number
      integer :: whole = 0
      !> Value of a logical
      logical :: switch = .false.
   contains
      !> Whether it is part of the input of the run, as listings show it
      procedure :: is_input
   end type key_type

contains

   !> Whether it is part of the input of the run, as listings show it.
   pure logical function is_input(self)
      !> The key
      class(key_type), intent(in) :: self

      is_input = self%kind < kind_file .and. self%has_value .and. .not. self%unused
   end function is_input

   !> Name of the option of a key, such as `--yield-factor`.
   pure function option_name(name) result(option)
      !> Name as in case files
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: option

      option = '--'//escaped(trim(name), '_', '-')
   end function option_name

   !> Give a key the value that some words mean. `error` names their place.
   pure subroutine assign_words(key, words, given, error)
      !> The key
      type(key_type), intent(inout) :: key
      !> What was written; of no matter for a request
      type(word_type), intent(in) :: words(:)
      !> Where
      integer, intent(in) :: given
      !> Set when the words do not fit the key
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      key%given = given
      key%has_value = .true.
      key%source = words(1)%source
      if (all(key%kind /= [kind_list, kind_counts, kind_paths]) .and. size(words) > 1) then
         call refuse(error, words(2), trim(key%name)//' takes one value, found also '// &
            quoted(words(2)%text))
         return
      end if

      select case (key%kind)
      case (kind_text, kind_choice, kind_file, kind_picture, kind_place)
         call assign_text(key, words(1), error)
      case (kind_paths)
         do i = 1, size(words)
            if (.not. allocated(error)) call add_path(key, words(i), error)
         end do
      case (kind_real, kind_list, kind_counts)
         call assign_numbers(key, words, error)
      case (kind_integer)
         call read_integer(words(1), trim(key%name), key%whole, error)
      case (kind_logical)
         call read_logical(words(1), trim(key%name), key%switch, error)
      case (kind_sweep)
         ! One after the other, as it may be given again
         if (key%text /= '') key%text = key%text//' '
         key%text = key%text//words(1)%text
      case default
         key%switch = .true.
      end select
   end subroutine assign_words

   !> One number, or several.
   pure subroutine assign_numbers(key, words, error)
      type(key_type), intent(inout) :: key
      type(word_type), intent(in) :: words(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: values(size(words))
      integer :: i

      if (size(words) > longest_list) then
         call refuse(error, words(1), trim(key%name)//' has too many values')
         return
      end if
      do i = 1, size(words)
         call read_real(words(i), trim(key%name), values(i), error)
         if (allocated(error)) return
      end do
      key%values = values
   end subroutine assign_numbers

   pure subroutine assign_text(key, word, error)
      type(key_type), intent(inout) :: key
      type(word_type), intent(in) :: word
      type(error_type), allocatable, intent(out) :: error

      if (.not. word%in_quotes) then
         call refuse(error, word, trim(key%name)//' is a text and needs quotes: '// &
            trim(key%name)//" = '"//word%text//"'")
         return
      end if
      key%text = word%text
      if (key%kind == kind_choice) then
         key%text = lower_case(word%text)
         if (index(' '//trim(key%choices)//' ', ' '//key%text//' ') == 0 &
            .or. key%text == '') call refuse(error, word, trim(key%name)//' = '// &
            quoted(word%text)//' is unknown; known: '//escaped(trim(key%choices), ' ', ', '))
      else if (word%text == '') then
         call refuse(error, word, trim(key%name)//' is empty')
      end if
   end subroutine assign_text

   !> One path more.
   pure subroutine add_path(key, word, error)
      type(key_type), intent(inout) :: key
      type(word_type), intent(in) :: word
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: before

      before = key%text
      call assign_text(key, word, error)
      if (before /= '') key%text = before//newline//key%text
   end subroutine add_path

   !> Take the value that the user gave away.
   pure subroutine forget(key)
      !> The key
      type(key_type), intent(inout) :: key

      key%given = given_nowhere
      key%has_value = .false.
   end subroutine forget

end module asperity_program_input_key
