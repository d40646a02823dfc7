!> What the lines before the numbers of a text file say: sizes, steps, units, the number that marks
!> missing points. Known are Esri's ASCII grid, Gwyddion's text export, column names with units in
!> brackets, and the lines that `map_file_write` writes.
module map_file_text_header
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_error, only: error_type
   use asperity_kinds, only: wp
   use map_file_byte_source, only: byte_source, next_line
   use map_file_fields, only: choose_separator, field_error, field_missing, field_number, &
      field_text, read_field
   use map_file_places, only: line_error, line_text, map_error
   use map_file_units, only: plain_unit
   use map_file_words, only: number_in, split_at
   implicit none
   private
   public :: read_text_header, text_header

   integer, parameter :: looked_at = 4096, most_lines = 1000
   character(len=*), parameter :: tab = achar(9)

   !> What the header says.
   type :: text_header
      !> Points along x and y, 0 if it does not say
      integer(int64) :: sizes(2) = 0_int64
      !> Steps, or lengths of the whole map, along x and y, and their units
      real(wp) :: steps(2) = 0.0_wp, lengths(2) = 0.0_wp
      character(len=8) :: step_units(2) = '', length_units(2) = ''
      !> Units of coordinates and of heights, empty if it does not say
      character(len=8) :: lateral_unit = '', height_unit = ''
      !> The number that marks missing points
      logical :: has_marker = .false.
      real(wp) :: marker = 0.0_wp
      !> Whether it is Esri's grid, whose first line is the one of the largest y
      logical :: is_esri = .false.
      !> What separates the fields, and how many there are in the first line of numbers
      character(len=1) :: separator = ' '
      integer(int64) :: fields = 0_int64
   end type text_header

contains

   !> Read the header. Then the current line is the first of numbers.
   subroutine read_text_header(source, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(text_header), intent(out) :: header
      !> Set when it is faulty, or there are no numbers
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      real(wp) :: value
      integer :: at, kind
      logical :: found, is_last

      do
         call next_line(source, found, error)
         if (allocated(error)) return
         if (.not. found) then
            call map_error(error, source, &
               'has no line of numbers: heights are read from SDF, X3P, '// &
               'SUR, and from text with three columns x, y, z or with a matrix')
            return
         else if (source%line > most_lines) then
            call line_error(error, source, source%first, &
               'no line of numbers among the first 1000: take comments out if this is a '// &
               'file of heights')
            return
         end if
         call line_text(source, looked_at, line)
         if (verify(line, ' '//tab) == 0) cycle
         at = verify(line, ' '//tab)
         if (scan(line(at:at), '#%!"') > 0 .or. index(line(at:), '//') == 1) then
            call read_header_line(source, line, header, error)
         else
            header%separator = choose_separator(line)
            at = source%first
            call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
            if (kind <= field_missing) exit
            if (kind == field_text) then
               call read_names(source, line, header, error)
            else
               call field_error(error, source, at, kind)
            end if
         end if
         if (allocated(error)) return
      end do
      call count_fields(source, header, error)
   end subroutine read_text_header

   !> Count the fields of the first line of numbers.
   subroutine count_fields(source, header, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value
      integer :: at, kind
      logical :: is_last

      at = source%first
      is_last = .false.
      do while (.not. is_last)
         call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
         header%fields = header%fields + 1_int64
         if (kind <= field_missing) cycle
         call field_error(error, source, at, kind)
         return
      end do
   end subroutine count_fields

   !> A line that begins with a word: a key with a value, or names of columns; a number among words
   !> that are no key is a line of numbers with a fault.
   subroutine read_names(source, line, header, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value
      integer :: at, kind, numbers, fields
      logical :: is_last

      if (scan(line, ':=') > 0) then
         call read_header_line(source, line, header, error)
         return
      end if
      at = source%first
      is_last = .false.
      numbers = 0
      fields = 0
      do while (.not. is_last .and. at <= source%last)
         call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
         if (kind == field_number) numbers = numbers + 1
         fields = fields + 1
         if (kind <= field_missing) cycle
         ! past the word
         do while (at <= source%last)
            if (source%block(at) == header%separator .or. source%block(at) == tab) exit
            at = at + 1
         end do
         if (header%separator /= ' ' .and. at <= source%last) at = at + 1
         do while (at <= source%last)
            if (source%block(at) /= ' ' .and. source%block(at) /= tab) exit
            at = at + 1
         end do
         is_last = at > source%last
      end do
      if (numbers == 0 .or. (numbers == 1 .and. fields == 2)) then
         call read_header_line(source, line, header, error)
      else
         call field_error(error, source, source%first, field_text)
      end if
   end subroutine read_names

   !> A line of the header: a key with a value, or names of columns.
   subroutine read_header_line(source, line, header, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: key, value, rest
      real(wp) :: number
      logical :: is_number
      integer :: place

      if (scan(line, ':=') > 0) then
         call split_at(line, ':=', key, value, place)
      else
         place = verify(line, ' '//tab)
         call split_at(line(place:), ' '//tab, key, value, place)
      end if
      call number_in(value, number, is_number, rest)
      select case (key)
      case ('ncols', 'columns')
         header%is_esri = header%is_esri .or. key == 'ncols'
         call read_size(1)
      case ('nrows', 'rows')
         call read_size(2)
      case ('cellsize', 'step')
         call read_length(header%steps(1), header%step_units(1))
         header%steps(2) = header%steps(1)
         header%step_units(2) = header%step_units(1)
      case ('dx', 'stepx')
         call read_length(header%steps(1), header%step_units(1))
      case ('dy', 'stepy')
         call read_length(header%steps(2), header%step_units(2))
      case ('width')
         if (is_number) call read_length(header%lengths(1), header%length_units(1))
      case ('height')
         if (is_number) call read_length(header%lengths(2), header%length_units(2))
      case ('heightunit', 'valueunits', 'zunit')
         call read_unit(value, header%height_unit)
      case ('lateralunit', 'xyunit')
         call read_unit(value, header%lateral_unit)
      case ('nodatavalue', 'nodata')
         header%has_marker = is_number .and. rest == ''
         header%marker = number
         if (.not. header%has_marker) call line_error(error, source, source%first + place - 1, &
            'the number that marks missing points must be a number with a decimal point')
      case default
         call read_columns(source, line, header, error)
      end select

   contains

      subroutine read_size(axis)
         integer, intent(in) :: axis

         if (is_number .and. number >= 1.0_wp .and. number <= 1.0e15_wp .and. rest == '') then
            header%sizes(axis) = int(number, int64)
         else
            call line_error(error, source, source%first + place - 1, &
               'the number of points must '// &
               'be a whole number above 0')
         end if
      end subroutine read_size

      subroutine read_length(length, unit)
         real(wp), intent(out) :: length
         character(len=8), intent(out) :: unit

         length = number
         unit = ''
         if (.not. is_number .or. .not. number > 0.0_wp .or. number > 1.0e30_wp .or. &
            index(rest, ',') == 1) then
            call line_error(error, source, source%first + place - 1, &
               'the distance of points must '// &
               'be a number above 0 with a decimal point, with its unit behind it if it has one')
         else if (rest /= '') then
            call read_unit(rest, unit)
         end if
      end subroutine read_length

      subroutine read_unit(text, unit)
         character(len=*), intent(in) :: text
         character(len=8), intent(out) :: unit

         unit = plain_unit(text)
         if (unit == '') call line_error(error, source, source%first + place - 1, 'the unit of '// &
            'this line is unknown: allowed are m, cm, mm, um and nm')
      end subroutine read_unit

   end subroutine read_header_line

   !> Names of three columns with units in brackets, such as x [um], y [um], z [nm].
   subroutine read_columns(source, line, header, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=8) :: units(3), unit
      integer :: first, last, n

      n = 0
      first = 1
      do
         last = scan(line(first:), '[(')
         if (last == 0) exit
         first = first + last
         last = scan(line(first:), '])')
         if (last == 0) exit
         unit = plain_unit(line(first:first + last - 2))
         n = n + 1
         if (unit == '' .or. n > 3) return
         units(n) = unit
         first = first + last
      end do
      if (n < 3) return
      if (units(1) /= units(2)) then
         call line_error(error, source, source%first, 'x is in '//trim(units(1))//', y in '// &
            trim(units(2))//': both must be in the same unit')
         return
      end if
      header%lateral_unit = units(1)
      header%height_unit = units(3)
   end subroutine read_columns

end module map_file_text_header
