!> Lines before the numbers of an export: texts, numbers in a row, sizes, fields.
module asperity_height_map_export_header_lines
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_file_errors, only: line_error, line_text
   use asperity_height_map_text_fields, only: choose_separator
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_text_header_fields, only: number_in
   use asperity_height_map_text_start, only: count_fields
   implicit none
   private
   public :: next_header_line, numbers_in, read_size, start_numbers, start_points, &
      take_field

   !> Characters of a line that are looked at
   integer, parameter :: looked_at = 4096

contains

   !> Go to the next line, which must be there.
   subroutine next_header_line(source, line, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> The line
      character(len=:), allocatable, intent(out) :: line
      !> Set at the end of the file
      type(error_type), allocatable, intent(out) :: error
      logical :: found

      line = ''
      call next_line(source, found, error)
      if (allocated(error)) return
      if (.not. found) then
         call line_error(error, source, source%first, &
            'the file ends before its heights: it was cut off')
      else
         call line_text(source, looked_at, line)
      end if
   end subroutine next_header_line

   !> The numbers at the beginning of a line, between blanks.
   pure subroutine numbers_in(line, values, count)
      !> The line
      character(len=*), intent(in) :: line
      !> The first of them; 0 behind the last
      real(wp), intent(out) :: values(:)
      !> How many there are, up to the size of `values`
      integer, intent(out) :: count
      character(len=:), allocatable :: left, rest
      logical :: is_number

      values = 0.0_wp
      left = line
      do count = 0, size(values) - 1
         call number_in(left, values(count + 1), is_number, rest)
         if (.not. is_number) return
         left = rest
      end do
      count = size(values)
   end subroutine numbers_in

   !> A number of points that the current line promises.
   pure subroutine read_size(source, value, points, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> The number as it stands
      real(wp), intent(in) :: value
      !> Points
      integer(int64), intent(out) :: points
      !> Set when it cannot be one
      type(error_type), allocatable, intent(out) :: error

      points = 0_int64
      if (value >= 1.0_wp .and. value <= 1.0e15_wp .and. .not. abs(value - anint(value)) > 0.0_wp) &
         then
         points = nint(value, int64)
      else
         call line_error(error, source, source%first, 'the number of points must be a whole '// &
            'number above 0')
      end if
   end subroutine read_size

   !> Take the field at the beginning of a line out of it, without its quotes.
   pure subroutine take_field(line, separator, field)
      !> The line, then what follows the field
      character(len=:), allocatable, intent(inout) :: line
      !> What separates fields
      character(len=1), intent(in) :: separator
      !> The field; empty behind the last one
      character(len=:), allocatable, intent(out) :: field
      integer :: last

      last = index(line//separator, separator)
      if (len(line) > 0) then
         ! a quoted field may have separators in it
         if (line(1:1) == '"' .and. index(line(2:), '"') > 0) then
            last = index(line(2:), '"') + 1
            last = last + index(line(last + 1:)//separator, separator)
         end if
      end if
      field = trim(adjustl(line(:min(last - 1, len(line)))))
      if (len(field) > 1) then
         if (field(1:1) == '"' .and. field(len(field):) == '"') &
            field = trim(adjustl(field(2:len(field) - 1)))
      else if (field == '"') then
         field = ''
      end if
      line = line(min(last + 1, len(line) + 1):)
   end subroutine take_field

   !> The current line is the first of numbers: what separates them, and how many it has.
   subroutine start_numbers(source, header, error, separator)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Both are set
      type(text_header), intent(inout) :: header
      !> Set when it has none
      type(error_type), allocatable, intent(out) :: error
      !> What separates them, if that is known
      character(len=1), intent(in), optional :: separator
      character(len=:), allocatable :: line

      if (present(separator)) then
         header%separator = separator
      else
         call line_text(source, looked_at, line)
         header%separator = choose_separator(line)
      end if
      call count_fields(source, header, error)
   end subroutine start_numbers

   !> The current line is the first of points x, y, z.
   subroutine start_points(source, header, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> Which columns are which is set
      type(text_header), intent(inout) :: header
      !> Set when it is none
      type(error_type), allocatable, intent(out) :: error

      header%names%fields = 3
      header%names%places = [1, 2, 3]
      call start_numbers(source, header, error)
      if (header%fields == 3_int64 .or. allocated(error)) return
      call line_error(error, source, source%first, 'here are '//to_text(header%fields)// &
         ' fields, a point has three: x, y and its height')
   end subroutine start_points

end module asperity_height_map_export_header_lines
