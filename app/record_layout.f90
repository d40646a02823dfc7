!> How a record is written: what separates its columns, their names and units, and where its numbers
!> begin.
module app_record_layout
   use asperity, only: error_type
   use asperity_error, only: fatal_error
   use asperity_text, only: to_text
   use app_record_headings, only: heading_type, read_heading
   use app_record_lines, only: field, field_count, next_line, place_text, place_type, &
      separator_of, start_reading
   use app_record_names, only: holds_unknown
   use app_record_numbers, only: looks_like_number
   use app_record_units, only: find_unit, unit_type, unit_unknown
   use app_strings, only: quoted
   use app_utf8, only: utf8_text
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
            if (is_of_numbers(text(place%first:place%last), ' ') .and. .not. &
               is_of_numbers(text(place%first:place%last), ',')) place%separator = ' '
         end if
         allocate (layout%columns(field_count(text(place%first:place%last), place%separator)))
         do i = 1, size(layout%columns)
            call read_heading(field(text(place%first:place%last), place, i), layout%columns(i))
         end do
         layout%has_names = is_named .or. are_names(layout%columns)
         if (layout%has_names) then
            call next_line(text, place)
            if (place%next > 0) call take_units(text, layout)
            if (place%next == 0) then
               call fatal_error(error, path//': has no line of numbers')
            else
               call check_width(text, layout, error)
            end if
         else
            do i = 1, size(layout%columns)
               call read_heading('', layout%columns(i))
            end do
         end if
      end associate
   end subroutine find_layout

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

   !> Refuse a first line of numbers with more fields than there are names: its columns are not
   !> where the names say.
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
         if (i <= size(layout%columns)) return
         call fatal_error(error, place_text(layout%start)//': the line has '//to_text(n)// &
            ' fields for '//to_text(size(layout%columns))//' names; if commas are decimal, '// &
            'columns need another separator')
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

end module app_record_layout
