!> The S and the L filter of ISO 25178-3: the linear Gaussian filter of ISO 16610-61, whose weight
!> exp(-pi (x^2 + y^2)/(alpha cutoff)^2) is that of ISO 16610-21 along x times that along y.
!>
!> At the ends of a full map the filter keeps planes, and products of a line along x and one along
!> y: moment retainment of ISO 16610-28 of order 1, one direction after the other. With missing
!> points it divides the weighted sum by the sum of the weights of the measured points, which is
!> that of order 0: only constants are kept at ends and beside holes, and on a slope the value at
!> an end is that alpha cutoff/pi, 0.15 cutoff, further in. Filling holes first avoids that.
!>
!> Weights are the Gaussian's values at the points, 1 in total. From a cutoff of four steps on that
!> passes a wave of the cutoff's length by half to within 0.002; at three steps 0.56 of it, and at
!> two, where no wave is shorter, 0.89.
module asperity_surface_prepare_gaussian_filter
   use, intrinsic :: iso_fortran_env, only: int64, int8, real32
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory, check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map, missing_points
   use asperity_surface_prepare_line_filter, only: delete_line_filter, filter_lines, line_filter, &
      new_line_filter
   implicit none
   private
   public :: check_cutoff, filter_long, filter_short

   !> Lines filtered at a time, and their points unless one line has more
   integer, parameter :: most_lines = 16, most_points = 2**20
   !> Arrays of that size that are there at once
   integer(int64), parameter :: most_copies = 12_int64
   !> Shortest cutoff, in steps: the shortest wave that a map has
   real(wp), parameter :: shortest_cutoff = 2.0_wp

contains

   !> S filter: leave waves longer than the cutoff.
   subroutine filter_short(map, cutoff, error)
      !> The map; unchanged after an error
      type(height_map), intent(inout) :: map
      !> Length of the wave of which half is left, mm
      real(wp), intent(in) :: cutoff
      !> Set when the cutoff is not allowed
      type(error_type), allocatable, intent(out) :: error

      call check_cutoff(map, 'short_cutoff', cutoff, error)
      call check_room(map%source, bytes_of(map), error)
      if (allocated(error)) return
      call smooth(map%heights, cutoff/map%step_x, cutoff/map%step_y)
   end subroutine filter_short

   !> L filter: take waves longer than the cutoff away.
   subroutine filter_long(map, cutoff, error)
      !> The map; unchanged after an error
      type(height_map), intent(inout) :: map
      !> Length of the wave of which half is left, mm
      real(wp), intent(in) :: cutoff
      !> Set when the cutoff is not allowed
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: long(:, :)
      integer :: i, j, status

      call check_cutoff(map, 'long_cutoff', cutoff, error)
      allocate (long(size(map%heights, 1), size(map%heights, 2)), stat=status)
      call check_memory(status, map%source, 8_int64*size(map%heights, kind=int64), error)
      call check_room(map%source, bytes_of(map), error)
      if (allocated(error)) return
      long = map%heights
      call smooth(long, cutoff/map%step_x, cutoff/map%step_y)
      do j = 1, size(long, 2)
         do i = 1, size(long, 1)
            if (long(i, j) < none) map%heights(i, j) = map%heights(i, j) - long(i, j)
         end do
      end do
   end subroutine filter_long

   !> Set `error` unless the map has waves shorter and longer than the cutoff.
   pure subroutine check_cutoff(map, name, cutoff, error)
      !> The map
      type(height_map), intent(in) :: map
      !> Name of the cutoff
      character(len=*), intent(in) :: name
      !> Length, mm
      real(wp), intent(in) :: cutoff
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: side, what
      real(wp) :: shortest, longest
      logical :: is_allowed

      is_allowed = is_finite(cutoff)
      if (is_allowed) is_allowed = cutoff > 0.0_wp
      if (.not. is_allowed) then
         call fatal_error(error, name//' = '//to_text(cutoff)// &
            ' mm is not allowed: it must be above 0 and finite', subject=name)
         return
      end if
      what = 'profile'
      side = what
      shortest = shortest_cutoff*map%step_x
      longest = (size(map%heights, 1) - 1)*map%step_x
      if (size(map%heights, 2) > 1) then
         what = 'map'
         side = 'map''s shorter side'
         shortest = shortest_cutoff*max(map%step_x, map%step_y)
         longest = min(longest, (size(map%heights, 2) - 1)*map%step_y)
      end if
      if (cutoff < shortest) then
         call fatal_error(error, name//' = '//to_text(cutoff)//' mm is below two '// &
            'steps of the '//what//', '//to_text(shortest)//' mm', subject=name)
      else if (cutoff > longest) then
         call fatal_error(error, name//' = '//to_text(cutoff)//' mm is longer '// &
            'than the '//side//', '//to_text(longest)//' mm', subject=name)
      end if
   end subroutine check_cutoff

   !> What `smooth` takes: weights of points where some are missing, and blocks of lines with their
   !> spectra.
   pure integer(int64) function bytes_of(map)
      type(height_map), intent(in) :: map

      bytes_of = 5_int64*size(map%heights, kind=int64)
      if (missing_points(map) == 0) bytes_of = 0_int64
      bytes_of = bytes_of + most_copies*8_int64*max(most_points, maxval(shape(map%heights)))
   end function bytes_of

   !> Smooth measured heights; missing ones stay missing. Beside the map, missing points take 5
   !> bytes a point: the sum of weights need not be known better than to seven figures.
   subroutine smooth(z, cutoff_x, cutoff_y)
      real(wp), intent(inout), contiguous :: z(:, :)
      !> Cutoffs in steps
      real(wp), intent(in) :: cutoff_x, cutoff_y
      integer(int8), allocatable :: measured(:, :)
      real(real32), allocatable :: weights(:, :)
      integer :: i, j

      if (all(z < none)) then
         call smooth_along_x(z, cutoff_x)
         if (size(z, 2) > 1) call smooth_along_y(z, cutoff_y)
         return
      end if
      allocate (measured(size(z, 1), size(z, 2)), weights(size(z, 1), size(z, 2)))
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            measured(i, j) = merge(1_int8, 0_int8, z(i, j) < none)
            weights(i, j) = real(measured(i, j), real32)
            if (measured(i, j) == 0_int8) z(i, j) = 0.0_wp
         end do
      end do
      call smooth_along_x(z, cutoff_x, weights)
      if (size(z, 2) > 1) call smooth_along_y(z, cutoff_y, weights)
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (measured(i, j) == 0_int8) then
               z(i, j) = none
            else
               z(i, j) = z(i, j)/real(weights(i, j), wp)
            end if
         end do
      end do
   end subroutine smooth

   !> Filter all rows: to first order without weights, else heights and weights by plain sums.
   subroutine smooth_along_x(z, cutoff, weights)
      real(wp), intent(inout), contiguous :: z(:, :)
      !> In steps
      real(wp), intent(in) :: cutoff
      real(real32), intent(inout), contiguous, optional :: weights(:, :)
      type(line_filter) :: filter
      real(wp), allocatable :: block(:, :)
      integer :: first, last, block_lines

      block_lines = max(1, min(most_lines, most_points/size(z, 1)))
      allocate (block(size(z, 1), block_lines))
      call new_line_filter(filter, size(z, 1), block_lines, cutoff, .not. present(weights))
      do first = 1, size(z, 2), block_lines
         last = min(first + block_lines - 1, size(z, 2))
         associate (lines => last - first + 1)
            call filter_lines(filter, z(:, first:last))
            if (.not. present(weights)) cycle
            block(:, :lines) = real(weights(:, first:last), wp)
            call filter_lines(filter, block(:, :lines))
            weights(:, first:last) = real(block(:, :lines), real32)
         end associate
      end do
      call delete_line_filter(filter)
   end subroutine smooth_along_x

   !> The same with all columns.
   subroutine smooth_along_y(z, cutoff, weights)
      real(wp), intent(inout), contiguous :: z(:, :)
      !> In steps
      real(wp), intent(in) :: cutoff
      real(real32), intent(inout), contiguous, optional :: weights(:, :)
      type(line_filter) :: filter
      real(wp), allocatable :: block(:, :)
      integer :: first, last, block_lines, j

      block_lines = max(1, min(most_lines, most_points/size(z, 2)))
      allocate (block(size(z, 2), block_lines))
      call new_line_filter(filter, size(z, 2), block_lines, cutoff, .not. present(weights))
      do first = 1, size(z, 1), block_lines
         last = min(first + block_lines - 1, size(z, 1))
         associate (lines => last - first + 1)
            do j = 1, size(z, 2)
               block(j, :lines) = z(first:last, j)
            end do
            call filter_lines(filter, block(:, :lines))
            do j = 1, size(z, 2)
               z(first:last, j) = block(j, :lines)
            end do
            if (.not. present(weights)) cycle
            do j = 1, size(z, 2)
               block(j, :lines) = real(weights(first:last, j), wp)
            end do
            call filter_lines(filter, block(:, :lines))
            do j = 1, size(z, 2)
               weights(first:last, j) = real(block(j, :lines), real32)
            end do
         end associate
      end do
      call delete_line_filter(filter)
   end subroutine smooth_along_y

end module asperity_surface_prepare_gaussian_filter
