!> Finds the first line of numbers of a text file, and reads the lines before it.
module asperity_height_map_text_start
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line, start_lines
   use asperity_height_map_file_errors, only: line_error, line_text, map_error
   use asperity_height_map_text_ending, only: line_other, line_type
   use asperity_height_map_text_fields, only: choose_separator, field_error, field_missing, &
      field_number, field_text, is_colour, read_field, skip_field
   use asperity_height_map_text_header, only: note_unknown, read_header_line, text_header
   use asperity_height_map_text_header_fields, only: narrow_colons
   use asperity_height_map_text_numbers, only: count_figures
   use asperity_height_map_type, only: fewest_points
   implicit none
   private
   public :: count_fields, read_text_start

   integer, parameter :: looked_at = 4096, most_lines = 1000
   character(len=*), parameter :: tab = achar(9)
   !> Numbers behind a word from which a line is one of numbers, with a word in its corner
   integer, parameter :: fewest_numbers = 4

contains

   !> Read the header. Then the current line is the first of numbers.
   subroutine read_text_start(source, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What it says
      type(text_header), intent(out) :: header
      !> Set when it is faulty, or there are no numbers
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      logical :: found, has_numbers
      integer :: at

      do
         call next_line(source, found, error)
         if (allocated(error)) return
         if (.not. found) then
            call map_error(error, source, &
               'has no line of numbers: heights are read from SDF, X3P, '// &
               'SUR, and from text with three columns x, y, z or with a matrix; profiles from '// &
               'two columns, x and z, or one')
            return
         else if (source%line > most_lines) then
            call line_error(error, source, source%first, &
               'no line of numbers among the first 1000: take comments out if this is a '// &
               'file of heights')
            return
         end if
         call line_text(source, looked_at, line)
         call narrow_colons(line)
         at = verify(line, ' '//tab)
         if (at == 0) cycle
         if (scan(line(at:at), '#%!\') > 0 .or. index(line(at:), '//') == 1) then
            call read_header_line(source, line, header, error)
         else
            call read_line(source, line, header, has_numbers, error)
            if (has_numbers) exit
         end if
         if (allocated(error)) return
      end do
      call count_fields(source, header, error)
      if (allocated(error) .or. any(header%sizes > 0_int64)) return
      if (header%fields == 1_int64) call skip_count(source, line, header, error)
      if (header%fields == 2_int64 .and. .not. allocated(error)) &
         call check_pairs(source, header, error)
   end subroutine read_text_start

   !> A number alone before lines of several is that of the points.
   subroutine skip_count(source, line, header, error)
      type(byte_source), intent(inout), target :: source
      character(len=*), intent(in) :: line
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: next
      integer(int64) :: number, offset
      logical :: found

      number = source%line
      offset = source%start + source%first - 1
      call next_line(source, found, error)
      if (allocated(error)) return
      if (found) then
         call line_text(source, looked_at, next)
         header%separator = choose_separator(next)
         header%fields = 0_int64
         call count_fields(source, header, error)
         if (allocated(error)) return
      end if
      if (header%fields == 1_int64) then
         call return_to(source, offset, number, error)
      else
         call note_unknown(header, line)
      end if
   end subroutine skip_count

   !> Two numbers in each of the first lines, which is what a profile has.
   subroutine check_pairs(source, header, error)
      type(byte_source), intent(inout), target :: source
      type(text_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: number, offset
      integer :: i
      logical :: found

      number = source%line
      offset = source%start + source%first - 1
      do i = 2, fewest_points
         call next_line(source, found, error)
         if (allocated(error)) return
         if (.not. found) exit
         if (line_type(source) /= line_other) cycle
         header%fields = 0_int64
         call count_fields(source, header, error)
         if (allocated(error)) return
         if (header%fields == 2_int64) cycle
         call line_error(error, source, source%first, 'row of '//to_text(header%fields)// &
            ' fields after one of 2: the header is of no format that is known')
         return
      end do
      call return_to(source, offset, number, error)
   end subroutine check_pairs

   !> Make a line that was read the current one again.
   subroutine return_to(source, offset, number, error)
      type(byte_source), intent(inout), target :: source
      !> Bytes before it, and its number
      integer(int64), intent(in) :: offset, number
      type(error_type), allocatable, intent(out) :: error
      logical :: found

      call start_lines(source, offset, error)
      source%line = number - 1_int64
      if (.not. allocated(error)) call next_line(source, found, error)
   end subroutine return_to

   !> A line that is no comment: numbers, a key with a value, or names of columns; a number among
   !> words that are no key is a line of numbers with a fault.
   subroutine read_line(source, line, header, has_numbers, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      type(text_header), intent(inout) :: header
      logical, intent(out) :: has_numbers
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value
      integer :: at, first, kind, fields, numbers, words
      logical :: is_last

      header%separator = choose_separator(line)
      at = source%first
      call read_field(source%block, at, source%last, header%separator, value, first, is_last)
      has_numbers = first == field_number
      if (has_numbers) return
      if (first > field_text) then
         call field_error(error, source, at, first)
         return
      end if
      numbers = 0
      words = 0
      fields = 0
      at = source%first
      is_last = .false.
      do while (.not. is_last .and. at <= source%last)
         call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
         fields = fields + 1
         if (kind == field_number) numbers = numbers + 1
         if (kind <= field_missing) cycle
         words = words + 1
         call skip_field(source%block, at, source%last, header%separator, is_last)
      end do
      has_numbers = words == 0 .or. (first == field_missing .and. numbers > 0)
      if (has_numbers) return
      if (scan(line, ':=') > 0 .or. numbers == 0 .or. (numbers == 1 .and. fields == 2)) then
         call read_header_line(source, line, header, error)
      else if (words == 1 .and. numbers == fields - 1 .and. numbers >= fewest_numbers) then
         header%has_corner_word = .true.
         has_numbers = .true.
      else
         call field_error(error, source, source%first, field_text)
      end if
   end subroutine read_line

   !> Count the fields of the first line of numbers.
   subroutine count_fields(source, header, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> The number of fields is added to
      type(text_header), intent(inout) :: header
      !> Set when one holds no number
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value
      integer :: at, before, decimals, figures, kind
      logical :: has_hole, is_last, may_be_colour(6)

      at = source%first
      is_last = .false.
      may_be_colour = .false.
      has_hole = .false.
      do while (.not. is_last)
         before = at
         call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
         header%fields = header%fields + 1_int64
         if (header%fields <= 6_int64) then
            call count_figures(source%block, before, source%last, figures, decimals)
            may_be_colour(header%fields) = is_colour(value) .and. decimals == 0
            has_hole = has_hole .or. kind /= field_number
         end if
         if (kind <= field_missing) cycle
         if ((header%fields == 1_int64 .and. header%has_corner_word) .or. &
            (kind == field_text .and. all(header%names%places([1, 3]) > 0) .and. &
            all(header%names%places /= header%fields))) then
            call skip_field(source%block, at, source%last, header%separator, is_last)
         else
            call field_error(error, source, at, kind)
            return
         end if
      end do
      header%has_colours = header%fields == 6_int64 .and. all(may_be_colour(4:)) .and. .not. &
         (all(may_be_colour(:3)) .or. has_hole .or. any(header%steps + header%lengths > 0.0_wp))
   end subroutine count_fields

end module asperity_height_map_text_start
