!> Reads columns of numbers from a text file as loggers and spreadsheets write them: separated by
!> commas, semicolons, tabs or blanks; with or without column names, units and comments; one test,
!> or several below each other.
module asperity_program_record_file
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory, check_work
   use asperity_base_number_text, only: to_text
   use asperity_program_record_columns, only: choose_columns, record_column
   use asperity_program_record_conditions, only: condition_type, is_wanted, test_type
   use asperity_program_record_layout, only: find_layout, headings_text, layout_type
   use asperity_program_record_lines, only: field_count, find_field, next_line, place_text, &
      place_type
   use asperity_program_record_numbers, only: decimal_of, looks_like_number, read_number
   use asperity_program_record_tests, only: find_tests, read_conditions
   use asperity_program_system_files, only: read_file
   use asperity_program_system_strings, only: newline, quoted
   implicit none
   private
   public :: record_format, read_record, read_rows, read_text

   !> How the file is written, and what of it is read.
   type :: record_format
      !> `comma`, `semicolon`, `tab`, `blank`, or `auto`: the first of tab, semicolon, comma and
      !> blank that the first line has
      character(len=12) :: separator = 'auto'
      !> Decimal sign: `point`, `comma`, or `auto`: comma if numbers have one that is no separator
      character(len=12) :: decimal = 'auto'
      !> Lines passed over at the beginning
      integer :: skip_lines = 0
      !> Conditions `name=value,...` of the rows that are read, empty for all
      character(len=:), allocatable :: where
   end type record_format

   !> Largest file, characters
   integer, parameter :: largest = 256*1024*1024
   !> Steps of a logger's time are equal to this part of them
   real(wp), parameter :: equal_steps = 0.01_wp
   !> Beginnings of texts in UTF-16
   character(len=2), parameter :: utf_16(2) = [char(255)//char(254), char(254)//char(255)]

contains

   !> Read columns of a file. `error` names file, line and column.
   subroutine read_record(path, format, quantities, columns, tests, error)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> How it is written; the decimal sign that was found is set
      type(record_format), intent(inout) :: format
      !> What the columns may hold together, one list a column; the first that the file has is taken
      integer, intent(in) :: quantities(:, :)
      !> Columns wanted; what was found is set
      type(record_column), intent(inout) :: columns(:)
      !> The tests of the file, as rows of the columns
      type(test_type), allocatable, intent(out) :: tests(:)
      !> Set when the file cannot be read or is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text
      type(condition_type), allocatable :: conditions(:)
      type(layout_type) :: layout
      integer :: i

      call read_text(path, text, error)
      if (allocated(error)) return
      call find_layout(text, path, format%separator, format%skip_lines, &
         any([(is_name(columns(i)%wanted), i=1, size(columns))]), layout, error)
      if (.not. allocated(error)) call choose_columns(layout, quantities, columns, error)
      if (.not. allocated(error)) &
         call read_conditions(text, layout, format%where, conditions, error)
      if (allocated(error)) return
      if (format%decimal == 'auto') &
         format%decimal = decimal_of(text, layout%start, (columns%place))
      if (format%decimal == '') then
         call fatal_error(error, path//': every number with a comma has three figures behind it: '&
            //'if that is the decimal sign, give --decimal comma')
         return
      end if
      call find_tests(text, layout, conditions, minval(columns%place) - 1, tests)
      call read_rows(text, layout%start, format%decimal, conditions, columns, error)
      if (allocated(error)) return
      if (size(tests) == 1) tests(1)%last = size(columns(1)%values)
      call check_time(layout, columns, error)
   end subroutine read_record

   !> Read the whole file.
   subroutine read_text(path, text, error)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> What it holds
      character(len=:), allocatable, intent(out) :: text
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: reason

      call read_file(path, largest + 1, text, reason)
      if (allocated(reason)) then
         call fatal_error(error, path//': cannot be read: '//reason, file_error)
      else if (len(text) > largest) then
         call fatal_error(error, path//': is larger than 256 MiB')
      else if (any(utf_16 == text(:min(2, len(text))))) then
         call fatal_error(error, path//': is in UTF-16: save it as UTF-8')
      end if
   end subroutine read_text

   !> Whether a column is asked for by name.
   pure logical function is_name(wanted)
      character(len=*), intent(in) :: wanted

      is_name = verify(wanted, '0123456789') > 0
   end function is_name

   !> Read the line at the place and all that follow.
   pure subroutine read_rows(text, start, decimal, conditions, columns, error)
      !> The whole file
      character(len=*), intent(in) :: text
      !> Its first line of numbers
      type(place_type), intent(in) :: start
      !> Decimal sign, `point` or `comma`
      character(len=*), intent(in) :: decimal
      !> What rows must fulfil
      type(condition_type), intent(in) :: conditions(:)
      !> The columns, with name and place; their values are set
      type(record_column), intent(inout) :: columns(:)
      !> Set, with file and line, when something is no number
      type(error_type), allocatable, intent(out) :: error
      type(place_type) :: place
      real(wp), allocatable :: values(:, :)
      character(len=:), allocatable :: what
      integer(int64) :: bytes
      integer :: i, n, status

      place = start
      n = 1
      do i = place%first, len(text)
         if (text(i:i) == newline) n = n + 1
      end do
      what = start%path//': '//to_text(n)//' rows'
      bytes = int(storage_size(values)/8, int64)*n*size(columns)
      allocate (values(n, size(columns)), stat=status)
      call check_memory(status, what, bytes, error)
      ! as much again for the columns
      call check_work(what, bytes, error)
      if (allocated(error)) return
      n = 0
      do while (place%next > 0)
         if (is_wanted(text(place%first:place%last), place, conditions)) then
            n = n + 1
            call read_row(text(place%first:place%last), place, decimal, columns, values(n, :), &
               error)
            if (allocated(error)) return
         end if
         call next_line(text, place)
      end do
      do i = 1, size(columns)
         allocate (columns(i)%values(n))
         columns(i)%values(:) = values(:n, i)
      end do
   end subroutine read_rows

   !> Read one line.
   pure subroutine read_row(line, place, decimal, columns, values, error)
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      character(len=*), intent(in) :: decimal
      type(record_column), intent(in) :: columns(:)
      real(wp), intent(out) :: values(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: what
      integer :: i, first, last

      do i = 1, size(columns)
         call find_field(line, place%separator, columns(i)%place, first, last)
         if (first > 0 .and. last >= first) then
            call read_number(line(first:last), decimal, values(i), error)
            if (.not. allocated(error)) cycle
         end if
         what = place_text(place)//': '//columns(i)%name//' (column '// &
            to_text(columns(i)%place)//')'
         if (first == 0) then
            call fatal_error(error, what//' is missing: the line has '// &
               to_text(field_count(line, place%separator))//' columns')
         else if (last < first) then
            call fatal_error(error, what//' is empty')
         else
            error%message = what//' = '//quoted(line(first:last))//' is not a finite number'
            if (decimal == 'point' .and. index(line(first:last), ',') > 0 &
               .and. looks_like_number(line(first:last))) &
               error%message = error%message//'; for decimal commas use --decimal comma'
         end if
         return
      end do
   end subroutine read_row

   !> Refuse a first column that nothing names and that looks like time among others.
   pure subroutine check_time(layout, columns, error)
      type(layout_type), intent(in) :: layout
      type(record_column), intent(in) :: columns(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: step
      integer :: n

      associate (x => columns(1)%values)
         n = size(x)
         if (columns(1)%chosen_by /= 'position' .or. n < 3 &
            .or. size(layout%columns) <= size(columns)) return
         step = (x(n) - x(1))/real(n - 1, wp)
         if (.not. abs(step) > 0.0_wp) return
         if (any(abs(x(2:) - x(:n - 1) - step) > equal_steps*abs(step))) return
         call fatal_error(error, layout%path//': column 1 goes on in equal steps of '// &
            to_text(step, 4)//', as time does, and nothing says what columns hold: choose with '// &
            columns(1)%option//'; '//headings_text(layout))
      end associate
   end subroutine check_time

end module asperity_program_record_file
