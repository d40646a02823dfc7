!> Reads a matrix of heights from text: a line for each row of x, the first at y = 0; in Esri's
!> grid the last.
module map_file_matrix
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_error, only: error_type
   use asperity_kinds, only: wp
   use map_file_byte_source, only: byte_source, next_line
   use map_file_fields, only: field_error, field_missing, field_number, read_field
   use map_file_heights, only: height_message, scale_heights
   use map_file_new_map, only: allocate_heights
   use map_file_number_store, only: number_store
   use map_file_places, only: count_text, fits_memory, line_error
   use map_file_text_header, only: text_header
   use map_file_units, only: map_hints, settle_step, settle_unit
   use surface_height_map, only: height_map, missing_height
   implicit none
   private
   public :: read_matrix

contains

   !> Read the rows, from the current line on.
   subroutine read_matrix(source, header, hints, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> What its header says
      type(text_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(number_store) :: store
      integer(int64) :: columns, nx, ny
      real(wp) :: factor
      logical :: is_narrower

      columns = header%fields
      call settle_unit(source%name, 'heights', '--height-unit', header%height_unit, &
         hints%height_unit, factor, error)
      if (allocated(error)) return
      if (any(header%sizes > 0_int64)) then
         ! each point takes a character at least
         call fits_memory(source, max(header%sizes(1), 1_int64), max(header%sizes(2), 1_int64), &
            source%size, 0_int64, error)
         if (allocated(error)) return
      end if
      call check_steps(source, header, hints, columns, 1_int64, map, error)
      if (allocated(error)) return
      call read_rows(source, header, factor, columns, store, is_narrower, error)
      if (allocated(error)) return
      nx = columns
      if (is_narrower) nx = nx - 1_int64
      ny = store%count/columns
      call check_size(source, header, 1, nx, error)
      if (allocated(error)) return
      call check_size(source, header, 2, ny, error)
      if (allocated(error)) return
      call check_steps(source, header, hints, nx, ny, map, error)
      if (allocated(error)) return
      call allocate_heights(source, nx, ny, map, error)
      if (allocated(error)) return
      call unload(store, columns, header%is_esri, map)
   end subroutine read_matrix

   !> Check the number of columns or rows against the header.
   subroutine check_size(source, header, axis, found, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(in) :: header
      integer, intent(in) :: axis
      integer(int64), intent(in) :: found
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: names(2) = ['columns', 'rows   ']

      if (header%sizes(axis) == 0_int64 .or. header%sizes(axis) == found) return
      call line_error(error, source, source%first, 'there are '//count_text(found)//' '// &
         trim(names(axis))//', the header promises '//count_text(header%sizes(axis))// &
         ': the file '// &
         'was cut off, or the header is wrong')
   end subroutine check_size

   !> Set the steps: those of the header, or the lengths of the whole map that it gives, or hints.
   subroutine check_steps(source, header, hints, nx, ny, map, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(in) :: header
      type(map_hints), intent(in) :: hints
      integer(int64), intent(in) :: nx, ny
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: step(2), unit
      integer :: i

      step = 0.0_wp
      do i = 1, 2
         if (header%steps(i) > 0.0_wp) then
            call find_unit(header%step_units(i))
            if (allocated(error)) return
            step(i) = header%steps(i)*unit
         else if (header%lengths(i) > 0.0_wp) then
            call find_unit(header%length_units(i))
            if (allocated(error)) return
            ! n points are n steps wide
            step(i) = header%lengths(i)*unit/real(merge(nx, ny, i == 1), wp)
         end if
      end do
      call settle_step(source%name, 'x', step(1), hints%step_x, map%step_x, error)
      if (.not. allocated(error)) call settle_step(source%name, 'y', step(2), hints%step_y, &
         map%step_y, error)

   contains

      subroutine find_unit(in_line)
         character(len=*), intent(in) :: in_line
         character(len=8) :: in_file

         in_file = in_line
         if (in_file == '') in_file = header%lateral_unit
         call settle_unit(source%name, 'lengths', '--lateral-unit', in_file, hints%lateral_unit, &
            unit, error)
      end subroutine find_unit

   end subroutine check_steps

   !> Read all rows into a store, in mm.
   subroutine read_rows(source, header, factor, columns, store, is_narrower, error)
      type(byte_source), intent(inout), target :: source
      type(text_header), intent(in) :: header
      real(wp), intent(in) :: factor
      integer(int64), intent(in) :: columns
      type(number_store), intent(inout) :: store
      !> Whether every row ends with a separator, so that its last field is none
      logical, intent(out) :: is_narrower
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value(1)
      integer(int64) :: n
      integer :: at, before, kind
      logical :: found, is_last

      is_narrower = header%separator /= ' '
      found = .true.
      do while (found)
         n = 0_int64
         at = source%first
         is_last = is_blank(source)
         do while (.not. is_last)
            before = at
            call read_field(source%block, at, source%last, header%separator, value(1), kind, &
               is_last)
            if (kind > field_missing) then
               call field_error(error, source, at, kind)
               return
            end if
            if (kind == field_number) call convert(before)
            if (allocated(error)) return
            call store%add(value(1))
            n = n + 1_int64
         end do
         if (n > 0_int64) then
            is_narrower = is_narrower .and. value(1) >= missing_height .and. at > source%last
            if (is_narrower) is_narrower = source%block(max(source%last, 1)) == header%separator
            if (n /= columns .or. store%count > huge(1)) then
               call line_error(error, source, source%first, &
                  'row of '//count_text(n)//' fields, '// &
                  'the first one has '//count_text(columns)// &
                  ': all rows must have the same, at '// &
                  'most 2147483647 in all; write NaN where a height is missing')
               return
            end if
         end if
         call next_line(source, found, error)
         if (allocated(error)) return
      end do

   contains

      subroutine convert(place)
         integer, intent(in) :: place
         character(len=:), allocatable :: message
         integer :: bad

         if (header%has_marker) then
            if (value(1) >= header%marker .and. value(1) <= header%marker) then
               value(1) = missing_height
               return
            end if
         end if
         call scale_heights(value, factor, 0.0_wp, bad)
         if (bad == 0) return
         call height_message(value(1), factor, message)
         call line_error(error, source, place, message)
      end subroutine convert

   end subroutine read_rows

   pure logical function is_blank(source)
      type(byte_source), intent(in) :: source
      integer :: i

      is_blank = .true.
      do i = source%first, source%last
         is_blank = source%block(i) == ' ' .or. source%block(i) == achar(9)
         if (.not. is_blank) return
      end do
   end function is_blank

   !> Move the numbers into the map.
   subroutine unload(store, columns, is_reversed, map)
      type(number_store), intent(inout) :: store
      integer(int64), intent(in) :: columns
      logical, intent(in) :: is_reversed
      type(height_map), intent(inout) :: map
      real(wp), allocatable :: values(:)
      integer :: chunk, i, j, k, length, ny

      ny = size(map%heights, 2)
      i = 0
      j = 1
      do chunk = 1, store%chunks
         call store%take(chunk, values, length)
         do k = 1, length
            i = i + 1
            if (i > columns) then
               i = 1
               j = j + 1
            end if
            if (i <= size(map%heights, 1)) map%heights(i, merge(ny + 1 - j, j, is_reversed)) = &
               values(k)
         end do
      end do
   end subroutine unload

end module map_file_matrix
