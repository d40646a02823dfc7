!> What a line before the numbers of a text file says: sizes, steps, units, a factor of heights, the
!> number that marks missing points, names of columns. Known are Esri's ASCII grid, Gwyddion's text
!> export, pixel sizes and factors as holography exports have them, and the lines that
!> `asperity_height_map_write` writes. What was not understood is kept, to be told.
module asperity_height_map_text_header
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_decode_heights, only: is_allowed_scale
   use asperity_height_map_file_errors, only: line_error, plain_excerpt
   use asperity_height_map_layout, only: export_layout
   use asperity_height_map_text_column_names, only: column_names, read_column_names
   use asperity_height_map_text_gwyddion_words, only: to_english
   use asperity_height_map_text_header_fields, only: next_pair, number_in, rounding_in, split_at
   use asperity_height_map_units, only: plain_unit, unit_length
   implicit none
   private
   public :: header_remark, marks_missing, note_unknown, read_header_line, text_header

   character(len=*), parameter :: tab = achar(9)
   !> Lines that were not understood are shown up to this many, and so many characters of each
   integer, parameter :: most_shown = 5, longest_shown = 60

   !> Share of a number that its printing may change
   real(wp), parameter :: same = 1.0e-12_wp

   !> What the header says.
   type :: text_header
      !> Points along x and y, 0 if it does not say
      integer(int64) :: sizes(2) = 0_int64
      !> Steps, or lengths of the whole map, along x and y, and their units. A length without a unit
      !> may be a number of points; it may be rounded by so much, in its unit
      real(wp) :: steps(2) = 0.0_wp, lengths(2) = 0.0_wp, roundings(2) = 0.0_wp
      character(len=8) :: step_units(2) = '', length_units(2) = ''
      !> Units of coordinates and of heights, empty if it does not say
      character(len=8) :: lateral_unit = '', height_unit = ''
      !> mm of a number, by a factor with a unit of its own; 0 without
      real(wp) :: factor = 0.0_wp
      !> Set where heights have a unit that is no length; only a factor helps
      type(error_type), allocatable :: no_length
      !> The number that marks missing points
      logical :: has_marker = .false.
      real(wp) :: marker = 0.0_wp
      !> Whether it is Esri's grid, whose first line is the one of the largest y
      logical :: is_esri = .false.
      !> Names of the columns
      type(column_names) :: names
      !> Lines that were not understood, the first of them in quotes
      integer :: unknown = 0
      character(len=:), allocatable :: unknown_lines
      !> What separates the fields, and how many there are in the first line of numbers
      character(len=1) :: separator = ' '
      integer(int64) :: fields = 0_int64
      !> Whether the first field of that line is a word, and all others are numbers; whether there
      !> are six, the last three alone whole numbers from 0 to 255: x, y, z and red, green, blue
      logical :: has_corner_word = .false., has_colours = .false.
      !> How an export differs
      type(export_layout) :: layout
   end type text_header

contains

   !> A line of the header: keys with values, or names of columns.
   recursive subroutine read_header_line(source, line, header, error, after)
      !> The file
      type(byte_source), intent(in) :: source
      !> The line, or what is left of it
      character(len=*), intent(in) :: line
      !> What is known; what the line says is added
      type(text_header), intent(inout) :: header
      !> Set when the line is faulty
      type(error_type), allocatable, intent(out) :: error
      !> Characters of the line before it
      integer, intent(in), optional :: after
      character(len=:), allocatable :: key, value, rest
      real(wp) :: number
      logical :: is_number
      integer :: before, next, place

      before = 0
      if (present(after)) before = after
      if (scan(line, ':=') > 0) then
         call split_at(line, ':=', key, value, place)
         next = next_pair(value)
         if (next > 1) then
            ! several pairs, such as h=18 w=24
            call read_header_line(source, line(:place + next - 2), header, error, before)
            if (.not. allocated(error)) call read_header_line(source, line(place + next - 1:), &
               header, error, before + place + next - 2)
            return
         end if
      else
         place = verify(line//'x', ' '//tab)
         before = before + place - 1
         call split_at(line(place:), ' '//tab, key, value, place)
      end if
      place = place + before
      call to_english(key)
      call number_in(value, number, is_number, rest)
      select case (key)
      case ('ncols', 'columns')
         header%is_esri = header%is_esri .or. key == 'ncols'
         if (key == 'columns' .and. .not. is_number) then
            call read_names(value)
         else
            call read_size(1)
         end if
      case ('nrows', 'rows')
         call read_size(2)
      case ('cellsize', 'step', 'stepsize', 'pixelsize', 'pixelspacing')
         call read_length(header%steps(1), header%step_units(1))
         header%steps(2) = header%steps(1)
         header%step_units(2) = header%step_units(1)
      case ('dx', 'stepx', 'xstep', 'pixelsizex', 'xpixelsize', 'pixelwidth')
         call read_length(header%steps(1), header%step_units(1))
      case ('dy', 'stepy', 'ystep', 'pixelsizey', 'ypixelsize', 'pixelheight')
         call read_length(header%steps(2), header%step_units(2))
      case ('width', 'w')
         call read_extent(1)
      case ('height', 'h')
         call read_extent(2)
      case ('heightunit', 'heightunits', 'valueunits', 'valueunit', 'zunit', 'zunits', 'dataunit', &
         'exportedimageunits')
         header%height_unit = plain_unit(value)
         if (header%height_unit == '') call no_length(value)
      case ('lateralunit', 'lateralunits', 'xyunit', 'xyunits')
         call read_unit(value, header%lateral_unit)
      case ('nodatavalue', 'nodata')
         header%has_marker = is_number .and. rest == ''
         header%marker = number
         if (.not. (header%has_marker .or. value == 'nan' .or. value == 'NaN')) &
            call line_error(error, source, source%first + place - 1, &
            'the number that marks missing points must be a number with a decimal point, or NaN')
      case ('xllcorner', 'yllcorner', 'xllcenter', 'yllcenter', 'channel', &
         'heights,alineforeachy,thefirstaty')
         continue
      case default
         if (index(key, 'heightconversionfactor') == 1 .or. index(key, 'heightfactor') == 1) then
            call read_factor()
         else
            call read_names(line)
         end if
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

      !> A length of the whole map, or a number of points.
      subroutine read_extent(axis)
         integer, intent(in) :: axis

         if (is_number) then
            call read_length(header%lengths(axis), header%length_units(axis))
            header%roundings(axis) = rounding_in(value)
         else
            call read_names(line)
         end if
      end subroutine read_extent

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

      !> A factor from numbers to heights; the unit of those behind an arrow or behind it
      subroutine read_factor()
         character(len=8) :: unit

         unit = plain_unit(rest)
         if (index(key, '->') > 0) unit = plain_unit(key(index(key, '->') + 2:))
         if (is_number) is_number = number > 0.0_wp .and. is_allowed_scale(number)
         if (is_number .and. unit /= '') then
            header%factor = number*unit_length(unit)
         else
            call line_error(error, source, source%first + place - 1, 'the factor of heights '// &
               'must be a number above 0 with a decimal point, and say to which unit it leads, '// &
               'm, cm, mm, um or nm')
         end if
      end subroutine read_factor

      subroutine read_names(text)
         character(len=*), intent(in) :: text
         type(column_names) :: names

         call read_column_names(text, names)
         if (all(names%places == 0)) then
            if (header%names%fields == 0) header%names = names
            call note_unknown(header, text)
            return
         end if
         header%names = names
         if (names%no_length /= '') call no_length(names%no_length)
         if (all(names%places > 0) .and. names%units(1) /= names%units(2)) then
            call line_error(error, source, source%first, 'x is in '//unit_name(1)//', y in '// &
               unit_name(2)//': both must be in the same unit')
            return
         end if
         if (names%units(1) /= '') header%lateral_unit = names%units(1)
         if (names%units(3) /= '') header%height_unit = names%units(3)
      end subroutine read_names

      function unit_name(axis) result(name)
         integer, intent(in) :: axis
         character(len=:), allocatable :: name

         name = trim(header%names%units(axis))
         if (name == '') name = 'no unit'
      end function unit_name

      subroutine no_length(unit)
         character(len=*), intent(in) :: unit

         call line_error(header%no_length, source, source%first + place - 1, &
            'the unit of this line, '//plain_excerpt(trim(unit), longest_shown)// &
            ', is unknown as one of heights: allowed are m, cm, mm, um and nm; export the '// &
            'heights themselves, or add the factor as a line such as '// &
            'height conversion factor (-> m) = 1e-7')
      end subroutine no_length

   end subroutine read_header_line

   !> Whether a number marks a missing point.
   pure logical function marks_missing(header, value)
      !> The header
      type(text_header), intent(in) :: header
      !> The number as it stands
      real(wp), intent(in) :: value

      marks_missing = value >= header%layout%missing_from
      if (header%has_marker .and. .not. marks_missing) &
         marks_missing = abs(value - header%marker) <= same*abs(header%marker)
   end function marks_missing

   !> Keep a line that was not understood.
   pure subroutine note_unknown(header, line)
      !> The header
      type(text_header), intent(inout) :: header
      !> The line; one without letter or digit says nothing
      character(len=*), intent(in) :: line
      character(len=*), parameter :: telling = 'abcdefghijklmnopqrstuvwxyz'// &
         'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789'

      if (scan(line, telling) == 0) return
      header%unknown = header%unknown + 1
      if (.not. allocated(header%unknown_lines)) header%unknown_lines = ''
      if (header%unknown > most_shown) return
      if (header%unknown > 1) header%unknown_lines = header%unknown_lines//', '
      header%unknown_lines = header%unknown_lines//''''//plain_excerpt(line, longest_shown)//''''
   end subroutine note_unknown

   !> What was not understood, in a sentence; empty if all was.
   pure subroutine header_remark(header, text)
      !> The header
      type(text_header), intent(in) :: header
      !> The sentence
      character(len=:), allocatable, intent(out) :: text

      text = ''
      if (header%unknown == 0) return
      text = 'not understood in its header, and not used: '//header%unknown_lines
      if (header%unknown > most_shown) text = text//' and '// &
         to_text(header%unknown - most_shown)//' lines more'
      text = text//'.'
   end subroutine header_remark

end module asperity_height_map_text_header
