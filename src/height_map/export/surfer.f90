!> Surfer's ASCII grid: `DSAA`, points along x and y, ranges of x, y and z, and the heights in rows
!> from the least y on, which may be broken into lines. From 1.70141e38 on they are blanked. It has
!> no units. Learnt from the format's public description and from GDAL's reader and writer.
module asperity_height_map_export_surfer
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_export_header_lines, only: next_header_line, numbers_in, read_size, &
      start_numbers
   use asperity_height_map_file_errors, only: line_error
   use asperity_height_map_text_header, only: text_header
   use asperity_height_map_units, only: map_hints, unit_of_length
   implicit none
   private
   public :: read_surfer_start, surfer_mark

   character(len=*), parameter :: surfer_mark = 'DSAA'
   real(wp), parameter :: blanked = 1.70141e38_wp
   !> Largest coordinate of either sign, and smallest length
   real(wp), parameter :: largest = 1.0e15_wp, smallest = 1.0e-15_wp
   character(len=*), parameter :: ranges(3) = ['x', 'y', 'z']

contains

   !> Read what stands before the heights. Then the current line is the first of them.
   subroutine read_surfer_start(source, hints, header, error)
      !> The file, its lines started
      type(byte_source), intent(inout), target :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> What it says
      type(text_header), intent(inout) :: header
      !> Set when it is faulty
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: line
      real(wp) :: by_user(2), lengths(size(ranges)), pair(2)
      integer :: axis, count

      header%layout%format = 'Surfer grid (DSAA)'
      header%layout%has_broken_rows = .true.
      header%layout%missing_from = blanked
      call next_header_line(source, line, error)
      if (.not. allocated(error)) call next_header_line(source, line, error)
      if (allocated(error)) return
      call numbers_in(line, pair, count)
      do axis = 1, 2
         call read_size(source, pair(axis), header%sizes(axis), error)
         if (allocated(error)) return
      end do
      lengths = 0.0_wp
      do axis = 1, size(ranges)
         call next_header_line(source, line, error)
         if (allocated(error)) return
         call numbers_in(line, pair, count)
         if (all(abs(pair) < largest)) lengths(axis) = pair(2) - pair(1)
         ! all heights may be the same, or blanked
         if (count == size(pair) .and. (lengths(axis) > smallest .or. axis == size(ranges))) cycle
         call line_error(error, source, source%first, 'the range of '//ranges(axis)//' must be '// &
            'two numbers here, the lesser one first')
         return
      end do
      where (header%sizes > 1_int64) &
         header%steps = lengths(:2)/real(header%sizes - 1_int64, wp)
      by_user = [hints%step_x, hints%step_y]
      if (hints%lateral_unit == '' .and. all(by_user > 0.0_wp) .and. all(header%steps > 0.0_wp)) &
         then
         ! the unit in which the file agrees with the user
         header%step_units = unit_of_length(by_user/header%steps, [.true., .true.])
         if (header%step_units(1) == '') then
            call line_error(error, source, source%first, '--step contradicts the ranges of x '// &
               'and y, by which the steps are '//to_text(header%steps(1), 6)//' and '// &
               to_text(header%steps(2), 6)//': in no unit are they the same; leave it out and '// &
               'say the unit with --lateral-unit')
            return
         end if
      end if
      call next_header_line(source, line, error)
      if (.not. allocated(error)) call start_numbers(source, header, error, separator=' ')
   end subroutine read_surfer_start

end module asperity_height_map_export_surfer
