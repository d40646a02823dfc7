!> Reads a matrix of heights from text: a line for each row of x, the first at y = 0; in Esri's
!> grid, and below an axis of falling y, the last; or a line for each x. Numbers and axes around the
!> heights are left out.
module asperity_height_map_text_matrix
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line, replace_in_line
   use asperity_height_map_bytes_number_chunks, only: number_store
   use asperity_height_map_decode_heights, only: height_message, scale_heights
   use asperity_height_map_file_errors, only: fits_memory, line_error
   use asperity_height_map_text_ending, only: check_text_end, line_type, line_blank, line_comment
   use asperity_height_map_text_fields, only: field_error, field_missing, field_number, &
      read_field, skip_field
   use asperity_height_map_text_frame, only: border_type, find_frame, frame_type
   use asperity_height_map_text_header, only: marks_missing, text_header
   use asperity_height_map_text_matrix_steps, only: check_size, check_units, settle_steps
   use asperity_height_map_type, only: allocate_heights, height_map
   use asperity_height_map_units, only: map_hints
   implicit none
   private
   public :: read_matrix

   !> What is gathered while the rows are read.
   type :: matrix_type
      !> Heights, mm, row by row
      type(number_store) :: store
      !> The first lines and columns as they stand
      type(border_type) :: border
      !> Faults in the first line and in the first column, which may be none of heights
      type(error_type), allocatable :: in_line, in_column
      !> Whether the corner is empty or a word
      logical :: is_open = .false.
      !> Fields of a row
      integer(int64) :: columns = 0_int64
      !> Whether every row ends with a separator, so that its last field is none
      logical :: is_narrower = .false.
   end type matrix_type

contains

   !> Read the rows, from the current line on.
   subroutine read_matrix(source, header, factor, hints, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> What its header says
      type(text_header), intent(in) :: header
      !> mm of a number
      real(wp), intent(in) :: factor
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(matrix_type) :: matrix
      type(frame_type) :: frame
      integer(int64) :: points(2)
      integer :: axis

      matrix%columns = header%fields
      if (any(header%sizes > 0_int64)) then
         ! each point takes a character at least
         call fits_memory(source, max(header%sizes(1), 1_int64), max(header%sizes(2), 1_int64), &
            source%size, 0_int64, error)
         if (allocated(error)) return
      end if
      ! rows of Esri's grid may be broken into lines anywhere
      if ((header%is_esri .or. header%layout%has_broken_rows) .and. all(header%sizes > 0_int64)) &
         matrix%columns = header%sizes(1)
      call check_units(source, header, hints, error)
      if (allocated(error)) return
      call read_rows(source, header, factor, matrix, error)
      if (allocated(error)) return
      points = [matrix%columns, matrix%store%count/matrix%columns]
      if (matrix%is_narrower) points(1) = points(1) - 1_int64
      if (.not. header%is_esri .and. header%layout%format == '') &
         call find_frame(matrix%border, int(points(1)), int(points(2)), &
         matrix%is_open, header%names%first_is_empty .or. &
         header%names%fields == points(1) - 1, frame)
      call check_border(matrix, header, frame, error)
      if (allocated(error)) return
      where (frame%is_axis([2, 1])) points = points - 1_int64
      if (header%layout%has_lines_of_x) points = points([2, 1])
      do axis = 1, 2
         call check_size(source, header, axis, points(axis), error)
         if (allocated(error)) return
      end do
      call settle_steps(source, header, hints, frame, points, map, error)
      if (allocated(error)) return
      call allocate_heights(source%name, points(1), points(2), map, error)
      if (allocated(error)) return
      call unload(matrix, header, frame, map)
   end subroutine read_matrix

   !> Faults in the first line and column count where those hold heights.
   subroutine check_border(matrix, header, frame, error)
      type(matrix_type), intent(inout) :: matrix
      type(text_header), intent(in) :: header
      type(frame_type), intent(in) :: frame
      type(error_type), allocatable, intent(out) :: error

      if (.not. frame%is_axis(1) .or. (header%has_corner_word .and. .not. all(frame%is_axis))) then
         if (allocated(matrix%in_line)) call move_alloc(matrix%in_line, error)
      end if
      if (.not. (frame%is_axis(2) .or. allocated(error))) then
         if (allocated(matrix%in_column)) call move_alloc(matrix%in_column, error)
      end if
   end subroutine check_border

   !> Read all rows, in mm.
   subroutine read_rows(source, header, factor, matrix, error)
      type(byte_source), intent(inout), target :: source
      type(text_header), intent(in) :: header
      real(wp), intent(in) :: factor
      type(matrix_type), intent(inout) :: matrix
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value(1)
      integer(int64) :: in_line, last_row, n, row, shape_of(2)
      integer :: at, before, kind
      logical :: found, is_broken, is_last

      is_broken = matrix%columns /= header%fields
      matrix%is_narrower = header%separator /= ' '
      found = .true.
      last_row = huge(row)
      if (header%layout%has_more) &
         last_row = header%sizes(merge(1, 2, header%layout%has_lines_of_x))
      row = 1_int64
      n = 0_int64
      ! fields of every line, and lines, of a grid whose lines may be broken
      shape_of = [header%fields, 0_int64]
      do while (found .and. row <= last_row)
         if (header%layout%has_decimal_commas) call replace_in_line(source, ',', '.')
         at = source%first
         in_line = 0_int64
         is_last = .false.
         select case (line_type(source))
         case (line_blank)
            is_last = .true.
         case (line_comment)
            call check_text_end(source, error)
            exit
         case default
            continue
         end select
         do while (.not. is_last)
            before = at
            in_line = in_line + 1_int64
            call read_field(source%block, at, source%last, header%separator, value(1), kind, &
               is_last)
            if (kind > field_missing) then
               call field_error(error, source, at, kind)
               if (.not. (header%has_corner_word .and. row == 1_int64 .and. n == 0_int64)) return
               call move_alloc(error, matrix%in_line)
               call skip_field(source%block, at, source%last, header%separator, is_last)
               kind = field_missing
            end if
            n = n + 1_int64
            if (row == 1_int64 .and. n == 1_int64) matrix%is_open = header%has_corner_word .or. &
               (kind == field_missing .and. header%separator /= ' ' .and. &
               scan(source%block(before), header%separator//'"') > 0)
            if (row <= 3_int64 .or. n <= 3_int64) then
               call matrix%border%keep(source, n, row, matrix%columns, value(1), error)
               if (allocated(error)) return
            end if
            if (kind == field_number) call convert(before)
            if (allocated(error)) return
            call matrix%store%add(value(1), source%name, error)
            if (allocated(error)) return
            if (is_broken .and. n == matrix%columns) call next_row()
            if (row > last_row .and. .not. is_last) then
               call line_error(error, source, at, 'the heights that the header promises end '// &
                  'here, and so must the line')
               return
            end if
         end do
         if (in_line > 0_int64) shape_of(2) = shape_of(2) + 1_int64
         if (in_line > 0_int64 .and. in_line /= header%fields) shape_of(1) = 0_int64
         if (n > 0_int64 .and. .not. is_broken) then
            matrix%is_narrower = matrix%is_narrower .and. value(1) >= none .and. &
               at > source%last
            if (matrix%is_narrower) &
               matrix%is_narrower = source%block(max(source%last, 1)) == header%separator
            if (n /= matrix%columns .or. matrix%store%count > huge(1)) then
               call line_error(error, source, source%first, &
                  'row of '//to_text(n)//' fields, '// &
                  'the first one has '//to_text(matrix%columns)// &
                  ': all rows must have the same, at '// &
                  'most '//to_text(huge(1))//' in all; write NaN where a height is missing')
               return
            end if
            call next_row()
         end if
         ! what follows the heights is another's to read
         if (row > last_row) return
         call next_line(source, found, error)
         if (allocated(error)) return
      end do
      if (allocated(error) .or. .not. is_broken) return
      if (all(shape_of == [header%fields, header%sizes(2)]) .or. &
         all(shape_of == [header%sizes(2), header%sizes(1)])) then
         ! whole rows, of another length than promised
         call check_size(source, header, 1, header%fields, error)
      else if (n > 0_int64) then
         call line_error(error, source, source%first, 'the last row has '//to_text(n)// &
            ' heights, the header promises '//to_text(matrix%columns)// &
            ' columns: the file was cut off, or the header is wrong')
      end if

   contains

      subroutine next_row()
         n = 0_int64
         row = row + 1_int64
      end subroutine next_row

      subroutine convert(place)
         integer, intent(in) :: place
         type(error_type), allocatable :: fault
         character(len=:), allocatable :: message
         integer :: bad

         if (marks_missing(header, value(1))) then
            value(1) = none
            return
         end if
         call scale_heights(value, factor, 0.0_wp, bad)
         if (bad == 0) return
         call height_message(value(1), factor, message)
         call line_error(fault, source, place, message)
         if (row > 1_int64 .and. n > 1_int64) then
            call move_alloc(fault, error)
         else if (row == 1_int64) then
            if (.not. allocated(matrix%in_line)) call move_alloc(fault, matrix%in_line)
         else if (.not. allocated(matrix%in_column)) then
            call move_alloc(fault, matrix%in_column)
         end if
         value(1) = none
      end subroutine convert

   end subroutine read_rows

   !> Move the numbers into the map, those around it left out.
   subroutine unload(matrix, header, frame, map)
      type(matrix_type), intent(inout) :: matrix
      type(text_header), intent(in) :: header
      type(frame_type), intent(in) :: frame
      type(height_map), intent(inout) :: map
      real(wp), allocatable :: values(:)
      logical :: is_reversed(2)
      integer :: chunk, i, j, k, left(2), length, nx, ny

      nx = size(map%heights, merge(2, 1, header%layout%has_lines_of_x))
      ny = size(map%heights)/nx
      is_reversed = frame%is_axis .and. frame%step < 0.0_wp
      is_reversed(2) = is_reversed(2) .or. header%is_esri
      ! the first column holds y
      left = merge(1, 0, frame%is_axis([2, 1]))
      i = -left(1)
      j = 1 - left(2)
      do chunk = 1, matrix%store%chunks
         call matrix%store%take(chunk, values, length)
         do k = 1, length
            i = i + 1
            if (i > matrix%columns - left(1)) then
               i = 1 - left(1)
               j = j + 1
            end if
            if (i < 1 .or. i > nx .or. j < 1) cycle
            if (header%layout%has_lines_of_x) then
               map%heights(j, i) = values(k)
            else
               map%heights(merge(nx + 1 - i, i, is_reversed(1)), &
                  merge(ny + 1 - j, j, is_reversed(2))) = values(k)
            end if
         end do
      end do
   end subroutine unload

end module asperity_height_map_text_matrix
