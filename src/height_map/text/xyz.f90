!> Reads points x, y, z from text, in any order, and puts them on the grid that they are on; or a
!> profile, which is a map of one line: points x, z, or heights alone in their order.
!>
!> While reading, a point takes 12 bytes: its height and the numbers of its x and y among those
!> that differ. They are given back while the map fills, so that both together stay below three
!> times the map.
module asperity_height_map_text_xyz
   use, intrinsic :: iso_fortran_env, only: int32, int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_bytes_lines, only: next_line
   use asperity_height_map_bytes_number_chunks, only: number_store
   use asperity_height_map_decode_heights, only: height_message, scale_heights
   use asperity_height_map_file_errors, only: fits_memory, line_error, map_error
   use asperity_height_map_text_distinct_values, only: axis_type, most_coordinates, &
      number_of_coordinate, rounding_of
   use asperity_height_map_text_ending, only: check_text_end, line_blank, line_comment, line_type
   use asperity_height_map_text_fields, only: field_error, field_missing, field_number, &
      is_colour, read_field, skip_field
   use asperity_height_map_text_find_grid, only: find_grid
   use asperity_height_map_text_header, only: marks_missing, text_header
   use asperity_height_map_text_matrix_steps, only: settle_point_steps
   use asperity_height_map_text_numbers, only: count_figures
   use asperity_height_map_type, only: add_note, allocate_heights, height_map
   use asperity_height_map_units, only: map_hints, settle_unit
   implicit none
   private
   public :: read_xyz

   !> Grid points for a point of the file: fewer would take more memory than the map deserves
   integer(int64), parameter :: most_sparse = 4_int64
   !> Bytes of both axes at most; a smaller file has smaller ones
   integer(int64), parameter :: room_for_axes = 8_int64*2_int64**20
   !> Largest coordinate of either sign, in the units of the file
   real(wp), parameter :: largest_coordinate = 1.0e15_wp

contains

   !> Read the points, from the current line on.
   subroutine read_xyz(source, header, factor, hints, map, error)
      !> The file
      type(byte_source), intent(inout), target :: source
      !> What its header says, and which columns are x, y and z
      type(text_header), intent(in) :: header
      !> mm of a height
      real(wp), intent(in) :: factor
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(axis_type) :: axes(2)
      type(number_store) :: store
      integer(int64) :: points
      real(wp) :: unit

      unit = header%layout%coordinate
      ! numbers of points have none
      if (header%names%places(1) == 0) unit = 1.0_wp
      if (unit < 0.0_wp) call settle_unit(source%name, 'coordinates', '--lateral-unit', &
         header%lateral_unit, hints%lateral_unit, unit, error)
      if (allocated(error)) return
      if (any(header%sizes > 0_int64)) call fits_memory(source, header%sizes(1), &
         header%sizes(2), source%size, 0_int64, error)
      if (allocated(error)) return
      ! the coordinates, at most 65536 along either axis, and how they are found again
      if (source%size > room_for_axes) call check_room(source%name, room_for_axes, error)
      if (allocated(error)) return
      call read_points(source, header, factor, axes, store, points, error)
      if (allocated(error)) return
      call fill_map(source, header, axes, points, unit, hints, store, map, error)
   end subroutine read_xyz

   !> Read all points; heights in mm.
   subroutine read_points(source, header, factor, axes, store, points, error)
      type(byte_source), intent(inout), target :: source
      type(text_header), intent(in) :: header
      real(wp), intent(in) :: factor
      type(axis_type), intent(inout) :: axes(2)
      type(number_store), intent(inout) :: store
      integer(int64), intent(out) :: points
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: value, values(3)
      integer :: at, axes_of(header%fields), bad, before, decimals, fields(3), figures, i, kind, &
         kinds(3), known, n, numbers(2)
      logical :: found, is_last
      character(len=:), allocatable :: message

      n = int(header%fields)
      axes_of = 0
      do i = 1, 3
         if (header%names%places(i) > 0) axes_of(header%names%places(i)) = i
      end do
      values = 0.0_wp
      ! numbers of lines are not rounded
      where (header%names%places(:2) == 0)
         axes%figures = 17
         axes%decimals = 15
      end where
      points = 0_int64
      found = .true.
      lines: do while (found)
         select case (line_type(source))
         case (line_comment)
            call check_text_end(source, error)
            return
         case (line_blank)
            call next_line(source, found, error)
            if (allocated(error)) return
            cycle lines
         case default
            at = source%first
         end select
         is_last = .false.
         do i = 1, n
            if (is_last) exit
            before = at
            call read_field(source%block, at, source%last, header%separator, value, kind, is_last)
            associate (axis => axes_of(i))
               if (header%has_colours .and. axis == 0 .and. .not. is_colour(value)) then
                  call line_error(error, source, before, 'no whole number from 0 to 255, as '// &
                     'red, green and blue behind x, y and z are in the first line; if this is '// &
                     'a matrix, put lines such as # step_x: 2 um before it')
                  return
               else if (kind > field_missing .and. axis == 0) then
                  call skip_field(source%block, at, source%last, header%separator, is_last)
               else if (kind > field_missing) then
                  call field_error(error, source, at, kind)
                  return
               else if (axis == 1 .or. axis == 2) then
                  if (kind == field_missing) then
                     call line_error(error, source, before, 'a coordinate is missing: leave '// &
                        'the line out, or write NaN for its height')
                     return
                  end if
               end if
               if (axis > 0) then
                  values(axis) = value
                  kinds(axis) = kind
                  fields(axis) = before
               end if
            end associate
         end do
         if (i <= n .or. .not. is_last) then
            call line_error(error, source, merge(before, at, is_last), &
               'this line has not the '//to_text(n)//' fields that the first one has')
            return
         end if
         if (header%names%places(1) == 0) values(1) = real(points, wp)
         do i = 1, 2
            if (abs(values(i)) > largest_coordinate) then
               call line_error(error, source, fields(i), 'coordinates beyond 1e15 are not allowed')
               return
            end if
            known = axes(i)%count
            call number_of_coordinate(axes(i), values(i), numbers(i))
            if (axes(i)%count > known .and. header%names%places(i) > 0) then
               call count_figures(source%block, fields(i), source%last, figures, decimals)
               axes(i)%figures = max(axes(i)%figures, figures)
               axes(i)%decimals = max(axes(i)%decimals, decimals)
            end if
            if (numbers(i) > 0) cycle
            call line_error(error, source, before, 'more than '//to_text(most_coordinates)// &
               ' different values of '//merge('x', 'y', i == 1)//': the points are on no grid, '// &
               'or the map is too large for text: resample it, or save it as SDF')
            return
         end do
         points = points + 1_int64
         if (points > huge(1)) then
            call line_error(error, source, source%first, &
               'at most '//to_text(huge(1))//' points are read: cut the map')
            return
         end if
         if (marks_missing(header, values(3))) kinds(3) = field_missing
         if (kinds(3) == field_number) then
            call scale_heights(values(3:3), factor, 0.0_wp, bad)
            if (bad > 0) then
               call height_message(values(3), factor, message)
               call line_error(error, source, fields(3), message)
               return
            end if
            call store%add_placed(values(3), ior(ishft(int(numbers(2) - 1, int32), 16), &
               int(numbers(1) - 1, int32)), source%name, error)
            if (allocated(error)) return
         end if
         if (header%layout%has_more .and. points == product(header%sizes)) return
         call next_line(source, found, error)
         if (allocated(error)) return
      end do lines
      if (header%layout%has_end_mark .or. header%layout%has_more) &
         call line_error(error, source, source%first, 'the file ends behind '//to_text(points)// &
         ' of the '//to_text(header%sizes(1))//' x '//to_text(header%sizes(2))//' points that '// &
         'the header promises: it was cut off')
   end subroutine read_points

   !> Find the grid and put the points on it.
   subroutine fill_map(source, header, axes, points, unit, hints, store, map, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(in) :: header
      type(axis_type), intent(in) :: axes(2)
      integer(int64), intent(in) :: points
      real(wp), intent(in) :: unit
      type(map_hints), intent(in) :: hints
      type(number_store), intent(inout) :: store
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: columns(:), rows(:)
      integer(int64) :: nx, ny
      real(wp) :: steps(2)

      allocate (columns(axes(1)%count), rows(axes(2)%count))
      if (all(axes%count == 1)) then
         call allocate_heights(source%name, 1_int64, 1_int64, map, error)
         return
      end if
      call find_one('x', axes(1), columns, nx, steps(1))
      if (allocated(error)) return
      rows = 1
      ny = 1_int64
      steps(2) = header%steps(2)
      if (axes(2)%count > 1) call find_one('y', axes(2), rows, ny, steps(2))
      if (allocated(error)) return
      if (any(header%sizes > 0_int64 .and. [nx, ny] > header%sizes)) then
         call map_error(error, source, 'the points are on '//to_text(nx)//' x '//to_text(ny)// &
            ' lines, the header promises '//to_text(header%sizes(1))//' x '// &
            to_text(header%sizes(2))//': correct it')
         return
      end if
      if (nx*ny > most_sparse*points) then
         call map_error(error, source, &
            'the points are on no grid: '//to_text(points)//' points '// &
            'on '//to_text(nx)//' x '//to_text(ny)//' lines, at least every '// &
            to_text(int(most_sparse))//'th place must be taken: resample the map')
         return
      end if
      call settle_point_steps(source, header, hints, steps, unit, ny > 1_int64, map, error)
      if (allocated(error)) return
      call allocate_heights(source%name, nx, ny, map, error)
      if (allocated(error)) return
      map%heights = none
      call unload(source, store, axes, columns, rows, map, error)

   contains

      subroutine find_one(name, axis, places, lines, step)
         character(len=*), intent(in) :: name
         type(axis_type), intent(in) :: axis
         integer, intent(out) :: places(:)
         integer(int64), intent(out) :: lines
         real(wp), intent(out) :: step
         character(len=:), allocatable :: reason
         integer :: n
         logical :: is_rounded

         call find_grid(axis%values(:axis%count), rounding_of(axis), places, n, step, is_rounded, &
            reason)
         lines = n
         if (allocated(reason)) then
            call map_error(error, source, 'the points are on no regular grid '// &
               'in '//name//': '//reason//'; resample to equal steps, or export its '// &
               'coordinates with more figures')
         else if (is_rounded) then
            call add_note(map, name//' is rounded to '//to_text(2.0_wp*rounding_of(axis), 3)// &
               ' by its figures, with a step of '//to_text(step, 6)//': each point was taken '// &
               'to the nearest place of the grid.')
         end if
      end subroutine find_one

   end subroutine fill_map

   !> Move the heights to their places.
   subroutine unload(source, store, axes, columns, rows, map, error)
      type(byte_source), intent(in) :: source
      type(number_store), intent(inout) :: store
      type(axis_type), intent(in) :: axes(2)
      integer, intent(in) :: columns(:), rows(:)
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:)
      integer(int32), allocatable :: places(:)
      integer :: chunk, k, length, x, y

      do chunk = 1, store%chunks
         call store%take(chunk, values, length, places)
         do k = 1, length
            x = iand(places(k), 65535_int32) + 1
            y = ishft(places(k), -16) + 1
            associate (height => map%heights(columns(x), rows(y)))
               if (height < none .and. abs(height - values(k)) > 0.0_wp) then
                  call map_error(error, source, &
                     'two points at x = '//to_text(axes(1)%values(x), 9)// &
                     ', y = '//to_text(axes(2)%values(y), 9)//' with different heights, '// &
                     to_text(height, 9)//' and '//to_text(values(k), 9)//' mm: leave one out')
                  return
               end if
               height = values(k)
            end associate
         end do
      end do
   end subroutine unload

end module asperity_height_map_text_xyz
