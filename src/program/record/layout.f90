!> How a record is written: what separates its columns, their names and units, and where its numbers
!> begin.
module asperity_program_record_layout
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_record_headings, only: heading_type, is_unit_of, read_heading
   use asperity_program_record_lines, only: field, field_count, next_line, place_text, place_type, &
      separator_of, start_reading
   use asperity_program_record_names, only: holds_unknown
   use asperity_program_record_numbers, only: looks_like_number
   use asperity_program_record_units, only: find_unit, unit_type, unit_unknown
   use asperity_program_system_strings, only: quoted, string_type
   use asperity_program_system_utf8, only: utf8_text
   implicit none
   private
   public :: layout_type, find_layout, headings_text

   !> A file of columns.
   type :: layout_type
      !> Path of the file
      character(len=:), allocatable :: path
      !> Whether it names its columns
      logical :: has_names = .false.
      !> Its columns
      type(heading_type), allocatable :: columns(:)
      !> Its first line of numbers
      type(place_type) :: start
   end type layout_type

   !> Columns that a message lists
   integer, parameter :: most_listed = 12

contains

   !> Find names, units and the first line of numbers. `error` names file and line.
   pure subroutine find_layout(text, path, separator, skip_lines, is_named, layout, error)
      !> The whole file, and its path
      character(len=*), intent(in) :: text, path
      !> Name of what separates columns, or `auto`
      character(len=*), intent(in) :: separator
      !> Lines passed over at the beginning
      integer, intent(in) :: skip_lines
      !> Whether columns are asked for by name, so that the first line must have names
      logical, intent(in) :: is_named
      !> What was found
      type(layout_type), intent(out) :: layout
      !> Set when there are no numbers
      type(error_type), allocatable, intent(out) :: error
      type(place_type) :: names
      integer :: i

      layout%path = path
      associate (place => layout%start)
         call start_reading(text, path, skip_lines, place)
         call next_line(text, place)
         if (place%next == 0) then
            call fatal_error(error, path//': has no line of data')
            return
         end if
         place%separator = separator_of(separator, text(place%first:place%last))
         if (separator == 'auto' .and. place%separator == ',') then
            if (comma_is_none(text(place%first:place%last))) place%separator = ' '
         end if
         call read_headings(fields_of(text(place%first:place%last), place), layout%columns)
         layout%has_names = is_named .or. are_names(layout%columns)
         if (.not. layout%has_names) then
            do i = 1, size(layout%columns)
               call read_heading('', layout%columns(i))
            end do
            return
         end if
         names = place
         call next_line(text, place)
         if (place%next > 0) then
            call read_headings(names_of(text(names%first:names%last), names, &
               field_count(text(place%first:place%last), place%separator)), layout%columns)
            call take_units(text, layout)
         end if
         if (place%next == 0) then
            call fatal_error(error, path//': has no line of numbers')
         else
            call check_width(text, layout, error)
         end if
      end associate
   end subroutine find_layout

   !> Whether the commas of a line separate nothing: they are decimal, between blanks, or stand
   !> before a unit.
   pure logical function comma_is_none(line)
      character(len=*), intent(in) :: line
      type(heading_type), allocatable :: columns(:)
      type(place_type) :: place
      integer :: i

      comma_is_none = is_of_numbers(line, ' ') .and. .not. is_of_numbers(line, ',')
      place%separator = ','
      call read_headings(fields_of(line, place), columns)
      do i = 2, size(columns)
         comma_is_none = comma_is_none .or. (columns(i - 1)%unit == '' &
            .and. is_unit_of(columns(i - 1)%holds, columns(i)%text))
      end do
   end function comma_is_none

   !> All fields of a line.
   pure function fields_of(line, place) result(fields)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      type(string_type), allocatable :: fields(:)
      integer :: i

      allocate (fields(field_count(line, place%separator)))
      do i = 1, size(fields)
         fields(i)%text = field(line, place, i)
      end do
   end function fields_of

   !> The names of a line over so many columns: one for a single column; between blanks, with the
   !> units in brackets that stand behind them.
   pure function names_of(line, place, n) result(names)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      integer, intent(in) :: n
      type(string_type), allocatable :: names(:)
      character(len=:), allocatable :: part
      integer :: i, n_fields, count
      logical :: is_open

      if (n == 1) then
         allocate (names(1))
         names(1)%text = trim(line)
         return
      end if
      n_fields = field_count(line, place%separator)
      count = 0
      is_open = .false.
      allocate (names(n_fields))
      do i = 1, n_fields
         part = field(line, place, i)
         if (is_open .or. (place%separator == ' ' .and. count > 0 &
            .and. scan(part, '([') == 1)) then
            names(count)%text = names(count)%text//' '//part
            is_open = scan(part, ')]') == 0
         else
            count = count + 1
            names(count)%text = part
         end if
      end do
      names = names(:count)
   end function names_of

   !> What all headings say.
   pure subroutine read_headings(names, columns)
      type(string_type), intent(in) :: names(:)
      type(heading_type), allocatable, intent(out) :: columns(:)
      integer :: i

      allocate (columns(size(names)))
      do i = 1, size(names)
         call read_heading(names(i)%text, columns(i))
      end do
   end subroutine read_headings

   !> Whether all fields of a line are numbers.
   pure logical function is_of_numbers(line, separator)
      character(len=*), intent(in) :: line
      character(len=1), intent(in) :: separator
      type(place_type) :: place
      integer :: i

      place%separator = separator
      is_of_numbers = all([(looks_like_number(field(line, place, i)), &
         i=1, field_count(line, separator))])
   end function is_of_numbers

   !> Whether the fields of a line are names: no number among them, or a name that is known.
   pure logical function are_names(columns)
      type(heading_type), intent(in) :: columns(:)
      logical :: number(size(columns)), text(size(columns))
      integer :: i

      do i = 1, size(columns)
         number(i) = looks_like_number(columns(i)%text)
         text(i) = columns(i)%text /= '' .and. .not. number(i)
      end do
      are_names = any(text) .and. (.not. any(number) .or. any(columns%holds /= holds_unknown))
   end function are_names

   !> Take the line at the place for one of units if it is one: none of its fields is a number, and
   !> one of them is a unit that is known or stands in brackets.
   pure subroutine take_units(text, layout)
      character(len=*), intent(in) :: text
      type(layout_type), intent(inout) :: layout
      character(len=:), allocatable :: cell
      type(unit_type) :: unit
      integer :: i
      logical :: is_line_of_units

      is_line_of_units = .false.
      associate (line => text(layout%start%first:layout%start%last))
         do i = 1, size(layout%columns)
            cell = utf8_text(field(line, layout%start, i))
            if (looks_like_number(cell)) return
            is_line_of_units = is_line_of_units .or. unbracketed(cell) /= cell &
               .or. is_known(cell)
         end do
         if (.not. is_line_of_units) return
         do i = 1, size(layout%columns)
            cell = unbracketed(utf8_text(field(line, layout%start, i)))
            if (cell == '' .or. cell == '-') cycle
            unit = find_unit(cell)
            layout%columns(i)%unit = cell
            layout%columns(i)%measures = unit%measures
         end do
      end associate
      call next_line(text, layout%start)
   end subroutine take_units

   pure logical function is_known(text)
      character(len=*), intent(in) :: text

      associate (unit => find_unit(text))
         is_known = unit%measures /= unit_unknown
      end associate
   end function is_known

   !> A text without brackets around it.
   pure function unbracketed(text) result(inside)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: inside

      inside = text
      if (len(text) < 3) return
      if (scan(text(1:1), '([') == 1 .and. scan(text(len(text):), ')]') == 1) &
         inside = text(2:len(text) - 1)
   end function unbracketed

   !> Refuse a first line of numbers with more fields than there are names, or between blanks with
   !> fewer: its columns are not where the names say.
   pure subroutine check_width(text, layout, error)
      character(len=*), intent(in) :: text
      type(layout_type), intent(in) :: layout
      type(error_type), allocatable, intent(out) :: error
      integer :: i, n

      associate (line => text(layout%start%first:layout%start%last))
         n = field_count(line, layout%start%separator)
         do i = n, size(layout%columns) + 1, -1
            if (field(line, layout%start, i) /= '') exit
         end do
         if (i > size(layout%columns)) then
            call fatal_error(error, place_text(layout%start)//': the line has '//to_text(n)// &
               ' fields for '//to_text(size(layout%columns))//' names; if commas are decimal, '// &
               'columns need another separator')
         else if (layout%start%separator == ' ' .and. n < size(layout%columns)) then
            call fatal_error(error, place_text(layout%start)//': the line has '//to_text(n)// &
               ' fields for '//to_text(size(layout%columns))//' names: those with blanks need '// &
               'quotes, or pass over them with --skip-lines')
         end if
      end associate
   end subroutine check_width

   !> The columns of a file for a message: number, name, unit.
   pure function headings_text(layout) result(text)
      !> The file
      type(layout_type), intent(in) :: layout
      character(len=:), allocatable :: text
      integer :: i

      text = 'its columns are'
      do i = 1, min(size(layout%columns), most_listed)
         if (i > 1) text = text//','
         text = text//' '//to_text(i)
         if (layout%columns(i)%name /= '') text = text//' '//quoted(layout%columns(i)%name)
         if (layout%columns(i)%unit /= '') text = text//' in '//layout%columns(i)%unit
      end do
      if (size(layout%columns) > most_listed) text = text//' ... '// &
         to_text(size(layout%columns))
   end function headings_text

end module asperity_program_record_layout
