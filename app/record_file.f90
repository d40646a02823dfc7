!> Reads columns of numbers from a text file as loggers and spreadsheets write them: separated by
!> commas, semicolons, tabs or blanks; with or without column names, units and comments.
module app_record_file
   use asperity, only: error_type, file_error, wp
   use asperity_error, only: fatal_error
   use asperity_text, only: to_text
   use app_record_lines, only: field, field_count, find_field, next_line, place_text, place_type, &
      separator_of, start_reading
   use app_strings, only: lower_case, nearest_name, newline, quoted
   use app_system, only: read_file
   use app_words, only: read_real, word_type
   implicit none
   private
   public :: record_column, record_format, read_record

   !> One column to read.
   type :: record_column
      !> What it holds, for messages, such as `force`
      character(len=:), allocatable :: name
      !> Its name in the file or its number, from one
      character(len=:), allocatable :: wanted
      !> Option that chose it, for messages
      character(len=:), allocatable :: source
      !> Its place in a line
      integer :: place = 0
      !> Name in the file, empty if there are no names
      character(len=:), allocatable :: heading
      !> Unit in the file, empty if there is none
      character(len=:), allocatable :: unit
      !> The numbers
      real(wp), allocatable :: values(:)
   end type record_column

   !> How the file is written.
   type :: record_format
      !> `comma`, `semicolon`, `tab`, `blank`, or `auto`: the first of tab, semicolon, comma and
      !> blank that the first line has
      character(len=:), allocatable :: separator
      !> Decimal sign, `point` or `comma`
      character(len=:), allocatable :: decimal
      !> Lines passed over at the beginning
      integer :: skip_lines = 0
   end type record_format

   !> Largest file, characters
   integer, parameter :: largest = 256*1024*1024
   integer, parameter :: longest_heading = 80

contains

   !> Read columns of a file. `error` names file, line and column.
   subroutine read_record(path, format, columns, error)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> How it is written
      type(record_format), intent(in) :: format
      !> Columns wanted; what was found is set
      type(record_column), intent(inout) :: columns(:)
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text, reason
      type(place_type) :: place

      call read_file(path, largest + 1, text, reason)
      if (allocated(reason)) then
         call fatal_error(error, path//': cannot be read: '//reason, file_error)
         return
      else if (len(text) > largest) then
         call fatal_error(error, path//': is larger than 256 MiB')
         return
      end if
      call start_reading(text, path, format%skip_lines, place)
      call next_line(text, place)
      if (place%next == 0) then
         call fatal_error(error, path//': has no line of data')
         return
      end if
      place%separator = separator_of(format%separator, text(place%first:place%last))
      call find_columns(text, place, format%decimal, columns, error)
      if (.not. allocated(error)) call read_rows(text, place, format%decimal, columns, error)
   end subroutine read_record

   !> Find the places of the columns, their names and units. The place is then at the first line
   !> of numbers.
   pure subroutine find_columns(text, place, decimal, columns, error)
      character(len=*), intent(in) :: text
      type(place_type), intent(inout) :: place
      character(len=*), intent(in) :: decimal
      type(record_column), intent(inout) :: columns(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(columns)
         columns(i)%place = number_of(columns(i)%wanted)
         columns(i)%heading = ''
         columns(i)%unit = ''
      end do
      if (any(columns%place == 0) .or. is_heading(text(place%first:place%last), place, decimal, &
         columns, need_all=.false.)) then
         do i = 1, size(columns)
            call find_heading(text(place%first:place%last), place, columns(i), error)
            if (allocated(error)) return
         end do
         call next_line(text, place)
         if (place%next > 0) then
            if (is_heading(text(place%first:place%last), place, decimal, columns, &
               need_all=.true.)) then
               do i = 1, size(columns)
                  columns(i)%unit = unbracketed(field(text(place%first:place%last), place, &
                     columns(i)%place))
               end do
               call next_line(text, place)
            end if
         end if
      end if
      if (place%next == 0) call fatal_error(error, place%path//': has no line of numbers')
   end subroutine find_columns

   !> The number that a text is, zero for a name.
   pure integer function number_of(text)
      character(len=*), intent(in) :: text

      number_of = 0
      if (verify(text, '0123456789') == 0 .and. len(text) < 6) read (text, *) number_of
   end function number_of

   !> Whether a line holds texts in the columns, whose places are known, and no number; some may be
   !> missing or empty, unless all are needed.
   pure logical function is_heading(line, place, decimal, columns, need_all)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      character(len=*), intent(in) :: decimal
      type(record_column), intent(in) :: columns(:)
      logical, intent(in) :: need_all
      type(error_type), allocatable :: error
      real(wp) :: value
      integer :: i, texts

      is_heading = .false.
      texts = 0
      do i = 1, size(columns)
         if (field(line, place, columns(i)%place) == '') cycle
         call read_number(field(line, place, columns(i)%place), decimal, place, columns(i), value, &
            error)
         if (.not. allocated(error)) return
         texts = texts + 1
      end do
      is_heading = texts == size(columns) .or. (texts > 0 .and. .not. need_all)
   end function is_heading

   !> Find a column in the line of names.
   pure subroutine find_heading(line, place, column, error)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      type(record_column), intent(inout) :: column
      type(error_type), allocatable, intent(out) :: error
      character(len=longest_heading), allocatable :: names(:)
      character(len=:), allocatable :: nearest
      integer :: i, n

      if (column%place == 0) then
         n = field_count(line, place%separator)
         allocate (names(n))
         do i = 1, n
            names(i) = lower_case(without_unit(field(line, place, i)))
            if (names(i) /= lower_case(column%wanted) &
               .and. lower_case(field(line, place, i)) /= lower_case(column%wanted)) cycle
            if (column%place > 0) then
               call fatal_error(error, place_text(place)//': there is more than one column '// &
                  quoted(column%wanted)//', give the number of the one meant')
               return
            end if
            column%place = i
         end do
         if (column%place == 0) then
            nearest = nearest_name(lower_case(column%wanted), names)
            if (nearest /= '') nearest = '; did you mean '//nearest//'?'
            call fatal_error(error, place_text(place)//': there is no column '// &
               quoted(column%wanted)//' for '//column%name//nearest)
            return
         end if
      end if
      column%heading = without_unit(field(line, place, column%place))
      column%unit = unit_in(field(line, place, column%place))
   end subroutine find_heading

   !> A heading without the unit in brackets at its end.
   pure function without_unit(heading) result(name)
      character(len=*), intent(in) :: heading
      character(len=:), allocatable :: name

      name = heading
      if (unit_in(heading) /= '') name = trim(heading(:scan(heading, '([', back=.true.) - 1))
   end function without_unit

   !> The unit in brackets at the end of a heading, empty if there is none.
   pure function unit_in(heading) result(unit)
      character(len=*), intent(in) :: heading
      character(len=:), allocatable :: unit
      integer :: open

      unit = ''
      open = scan(heading, '([', back=.true.)
      if (open < 2) return
      if (scan(heading(len(heading):), ')]') == 0) return
      unit = trim(adjustl(heading(open + 1:len(heading) - 1)))
   end function unit_in

   !> A text without brackets around it.
   pure function unbracketed(text) result(inside)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: inside

      inside = text
      if (len(text) < 3) return
      if (scan(text(1:1), '([') == 1 .and. scan(text(len(text):), ')]') == 1) &
         inside = text(2:len(text) - 1)
   end function unbracketed

   !> Read the line at the place and all that follow.
   pure subroutine read_rows(text, place, decimal, columns, error)
      character(len=*), intent(in) :: text
      type(place_type), intent(inout) :: place
      character(len=*), intent(in) :: decimal
      type(record_column), intent(inout) :: columns(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:, :)
      integer :: i, n, first, last

      n = 1
      do i = place%first, len(text)
         if (text(i:i) == newline) n = n + 1
      end do
      allocate (values(n, size(columns)))
      n = 0
      do while (place%next > 0)
         n = n + 1
         associate (line => text(place%first:place%last))
            do i = 1, size(columns)
               call find_field(line, place%separator, columns(i)%place, first, last)
               if (first == 0) then
                  call fatal_error(error, place_text(place)//': '//column_text(columns(i))// &
                     ' is missing: the line has '//to_text(field_count(line, place%separator))// &
                     ' columns')
               else if (last < first) then
                  call fatal_error(error, place_text(place)//': '//column_text(columns(i))// &
                     ' is empty')
               else
                  call read_number(line(first:last), decimal, place, columns(i), values(n, i), &
                     error)
               end if
               if (allocated(error)) return
            end do
         end associate
         call next_line(text, place)
      end do
      do i = 1, size(columns)
         allocate (columns(i)%values, source=values(:n, i))
      end do
   end subroutine read_rows

   !> The number in a field.
   pure subroutine read_number(text, decimal, place, column, value, error)
      character(len=*), intent(in) :: text, decimal
      type(place_type), intent(in) :: place
      type(record_column), intent(in) :: column
      real(wp), intent(out) :: value
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: word
      integer :: comma

      word%text = text
      comma = index(text, ',')
      if (decimal == 'comma' .and. comma > 0) then
         word%text(comma:comma) = '.'
         ! a point beside a comma marks thousands, which nobody else reads so
         if (index(text, '.') > 0) word%text = '?'//text
      end if
      word%source = ''
      call read_real(word, '', value, error)
      if (.not. allocated(error)) return
      error%message = place_text(place)//': '//column_text(column)//' = '//quoted(text)// &
         ' is not a finite number'
      if (decimal == 'point' .and. comma > 0 .and. verify(text, '+-0123456789,eE') == 0) &
         error%message = error%message//'; for decimal commas use --decimal comma'
   end subroutine read_number

   !> What a column holds, and its number.
   pure function column_text(column) result(text)
      type(record_column), intent(in) :: column
      character(len=:), allocatable :: text

      text = column%name//' (column '//to_text(column%place)//')'
   end function column_text

end module app_record_file
