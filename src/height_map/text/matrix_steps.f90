!> The steps of a matrix: those that its header says, or that follow from the lengths of the whole
!> map or from axes around the heights, or what the user says.
module asperity_height_map_text_matrix_steps
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_file_errors, only: line_error, map_error
   use asperity_height_map_text_frame, only: frame_type
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_type, only: add_note, height_map
   use asperity_height_map_units, only: map_hints, settle_step, settle_unit, unit_of_length
   implicit none
   private
   public :: check_size, check_units, settle_point_steps, settle_steps

   character(len=*), parameter :: columns_rows(2) = [character(len=7) :: 'columns', 'rows']
   character(len=*), parameter :: axes(2) = ['x', 'y']
   !> Share of a step that is told if the rounding of a length can change it by as much
   real(wp), parameter :: noticed = 1.0e-3_wp
   character(len=*), parameter :: extents(2) = [character(len=6) :: 'Width', 'Height']

   !> Steps that differ by less are the same, as coordinates are rounded
   real(wp), parameter :: similar = 1.0e-2_wp

contains

   !> Check the number of columns or rows against the header.
   subroutine check_size(source, header, axis, found, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Its header
      type(text_header), intent(in) :: header
      !> Axis of the map
      integer, intent(in) :: axis
      !> How many there are
      integer(int64), intent(in) :: found
      !> Set when the header promises another number
      type(error_type), allocatable, intent(out) :: error

      if (header%sizes(axis) == 0_int64 .or. header%sizes(axis) == found) return
      call line_error(error, source, source%first, 'there are '//to_text(found)//' '// &
         trim(columns_rows(merge(3 - axis, axis, header%layout%has_lines_of_x)))// &
         ', the header promises '//to_text(header%sizes(axis))// &
         ': the file was cut off, or the header is wrong')
   end subroutine check_size

   !> Check that the units of what the header says are known, before the numbers are read.
   subroutine check_units(source, header, hints, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Its header
      type(text_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Set when a unit is missing or contradicts
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: unit
      integer :: i

      do i = 1, 2
         if (header%steps(i) > 0.0_wp) then
            call find_unit(source, header, hints, header%step_units(i), 'lengths', unit, error)
         else if (header%lengths(i) > 0.0_wp .and. header%length_units(i) /= '') then
            call find_unit(source, header, hints, header%length_units(i), 'lengths', unit, error)
         end if
         if (allocated(error)) return
      end do
   end subroutine check_units

   !> Set the steps.
   subroutine settle_steps(source, header, hints, frame, points, map, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Its header
      type(text_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Axes around the heights
      type(frame_type), intent(in) :: frame
      !> Points along x and y
      integer(int64), intent(in) :: points(2)
      !> Its steps are set, notes are added
      type(height_map), intent(inout) :: map
      !> Set when they are not known, or contradict
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: step(2), unit
      logical :: is_count(2), may_count(2)
      integer :: i

      step = 0.0_wp
      may_count = header%lengths > 0.0_wp .and. header%length_units == ''
      is_count = may_count .and. .not. abs(header%lengths - real(points, wp)) > 0.0_wp
      do i = 1, 2
         if (header%steps(i) > 0.0_wp) then
            call find_unit(source, header, hints, header%step_units(i), 'lengths', unit, error)
            if (allocated(error)) return
            step(i) = header%steps(i)*unit
         else if (is_count(i)) then
            cycle
         else if (may_count(i) .and. any(is_count)) then
            call map_error(error, source, trim(extents(3 - i))//' is the number of '// &
               trim(columns_rows(3 - i))//', but '//trim(extents(i))//' = '// &
               to_text(header%lengths(i))//' is not that of the '//trim(columns_rows(i))//', '// &
               to_text(points(i))//': the file was cut off, or the header lacks units')
            return
         else if (header%lengths(i) > 0.0_wp) then
            call find_unit(source, header, hints, header%length_units(i), 'lengths', unit, error)
            if (allocated(error)) return
            ! n points are n steps wide
            step(i) = header%lengths(i)*unit/real(points(i), wp)
            call take_rounding(header, i, merge(hints%step_x, hints%step_y, i == 1), step(i), map)
         end if
      end do
      call take_axes(source, header, hints, frame, step, map, error)
      if (.not. allocated(error)) call settle_step(source%name, 'x', step(1), hints%step_x, &
         map%step_x, error)
      if (.not. allocated(error)) call settle_step(source%name, 'y', step(2), hints%step_y, &
         map%step_y, error)
   end subroutine settle_steps

   !> A length is printed with few figures, by Gwyddion with as many as tell points apart: within
   !> them the user says the step.
   subroutine take_rounding(header, axis, by_user, step, map)
      type(text_header), intent(in) :: header
      integer, intent(in) :: axis
      real(wp), intent(in) :: by_user
      real(wp), intent(inout) :: step
      type(height_map), intent(inout) :: map
      real(wp) :: share
      character(len=9) :: unit

      share = header%roundings(axis)/header%lengths(axis)
      if (by_user > 0.0_wp) then
         if (abs(by_user - step) <= share*step) step = by_user
      else if (share > noticed) then
         unit = ' '//trim(header%length_units(axis))
         call add_note(map, trim(extents(axis))//' is '//to_text(header%lengths(axis))// &
            trim(unit)//', rounded to '//to_text(2.0_wp*header%roundings(axis), 2)//trim(unit)// &
            ' by its figures: the step in '//axes(axis)//', '//to_text(step, 6)// &
            ' mm, may be off by '//to_text(100.0_wp*share, 2)//' %; --step says it exactly.')
      end if
   end subroutine take_rounding

   !> Steps of axes, where the header says none. Without a unit it is the one in which they agree
   !> with the steps of the user. Numbers of columns and rows say no steps.
   subroutine take_axes(source, header, hints, frame, step, map, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(in) :: header
      type(map_hints), intent(in) :: hints
      type(frame_type), intent(in) :: frame
      real(wp), intent(inout) :: step(2)
      type(height_map), intent(inout) :: map
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: by_user(2), unit
      character(len=8) :: name
      logical :: is_scale(2)

      is_scale = frame%is_axis .and. .not. frame%counts
      if (any(is_scale) .and. any(is_scale .and. .not. step > 0.0_wp)) then
         by_user = [hints%step_x, hints%step_y]
         if (header%lateral_unit == '' .and. hints%lateral_unit == '' .and. &
            all(by_user > 0.0_wp)) then
            where (is_scale) by_user = by_user/abs(frame%step)
            name = unit_of_length(by_user, is_scale)
            if (name == '') then
               call map_error(error, source, '--step contradicts the axes around the heights, '// &
                  'whose steps are '//to_text(abs(frame%step(1)), 6)//' and '// &
                  to_text(abs(frame%step(2)), 6)//': in no unit are they the same; leave it '// &
                  'out and say the unit of the axes with --lateral-unit')
               return
            end if
            call settle_unit(source%name, 'axes', '--lateral-unit', name, '', unit, error)
         else
            call find_unit(source, header, hints, '', 'axes', unit, error)
         end if
         if (allocated(error)) return
         where (is_scale .and. .not. step > 0.0_wp) step = abs(frame%step)*unit
      end if
      call note_frame(frame, step, map)
   end subroutine take_axes

   !> Say what was taken for axes or numbers.
   subroutine note_frame(frame, step, map)
      type(frame_type), intent(in) :: frame
      real(wp), intent(in) :: step(2)
      type(height_map), intent(inout) :: map
      character(len=*), parameter :: lines(2) = [character(len=16) :: 'the first line', &
         'the first column']
      integer :: i

      do i = 1, 2
         if (.not. frame%is_axis(i)) cycle
         if (frame%counts(i)) then
            call add_note(map, trim(lines(i))//' counts the '// &
               trim(columns_rows(i))//' and is left out.')
         else
            call add_note(map, trim(lines(i))//' is the axis of '//axes(i)//', from '// &
               to_text(frame%first(i), 6)//' in steps of '//to_text(frame%step(i), 6)//': '// &
               to_text(step(i), 6)//' mm is the step, and it is left out of the heights.')
         end if
      end do
      if (frame%is_doubtful) call add_note(map, 'its first line or column goes in equal steps, '// &
         'as no heights do, and was taken for heights: if it numbers the others or is an axis, '// &
         'take it out.')
   end subroutine note_frame

   !> Length of the unit of a line of the header, or of the whole file.
   subroutine find_unit(source, header, hints, in_line, what, unit, error)
      type(byte_source), intent(in) :: source
      type(text_header), intent(in) :: header
      type(map_hints), intent(in) :: hints
      character(len=*), intent(in) :: in_line, what
      real(wp), intent(out) :: unit
      type(error_type), allocatable, intent(out) :: error
      character(len=8) :: in_file

      in_file = in_line
      if (in_file == '') in_file = header%lateral_unit
      call settle_unit(source%name, what, '--lateral-unit', in_file, hints%lateral_unit, unit, &
         error)
   end subroutine find_unit

   !> Set the steps of points, or that of a profile; heights alone have the step of the header.
   subroutine settle_point_steps(source, header, hints, steps, unit, has_lines, map, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Its header, and which columns are x, y and z
      type(text_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Steps by the coordinates
      real(wp), intent(in) :: steps(2)
      !> mm of a coordinate
      real(wp), intent(in) :: unit
      !> Whether there is more than one line
      logical, intent(in) :: has_lines
      !> Its steps are set
      type(height_map), intent(inout) :: map
      !> Set when they are not known, or contradict
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: step_x, length

      step_x = steps(1)*unit
      if (header%names%places(1) == 0) then
         step_x = 0.0_wp
         if (header%steps(1) > 0.0_wp) then
            call find_unit(source, header, hints, header%step_units(1), 'lengths', length, error)
            if (allocated(error)) return
            step_x = header%steps(1)*length
         end if
      else if (any(header%steps > 0.0_wp .and. abs(steps - header%steps) > similar*steps)) then
         call map_error(error, source, 'by their coordinates the steps of the points are '// &
            to_text(steps(1), 6)//' and '//to_text(steps(2), 6)//', by the header '// &
            to_text(header%steps(1), 6)//' and '//to_text(header%steps(2), 6)//': correct it')
         return
      end if
      call settle_step(source%name, 'x', step_x, hints%step_x, map%step_x, error)
      map%step_y = map%step_x
      if (has_lines .and. .not. allocated(error)) call settle_step(source%name, 'y', &
         steps(2)*unit, hints%step_y, map%step_y, error)
   end subroutine settle_point_steps

end module asperity_height_map_text_matrix_steps
