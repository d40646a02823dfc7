!> Height maps for tests.
module map_cases
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use random_inputs, only: random_stream
   implicit none
   private
   public :: flat_map, kept_map, punch_holes, random_map, random_whole

contains

   !> A map of zeros.
   subroutine flat_map(map, points_x, points_y, step_x, step_y)
      type(height_map), intent(out) :: map
      integer, intent(in) :: points_x, points_y
      real(wp), intent(in) :: step_x, step_y

      allocate (map%heights(points_x, points_y))
      map%heights = 0.0_wp
      map%step_x = step_x
      map%step_y = step_y
      map%source = 'test map'
      map%format = 'none'
   end subroutine flat_map

   !> A map of independent heights between -1 and 1, or of so many different ones only.
   subroutine random_map(map, stream, points_x, points_y, step_x, step_y, levels)
      type(height_map), intent(out) :: map
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: points_x, points_y
      real(wp), intent(in) :: step_x, step_y
      integer, intent(in), optional :: levels
      integer :: i, j

      call flat_map(map, points_x, points_y, step_x, step_y)
      do j = 1, points_y
         do i = 1, points_x
            map%heights(i, j) = stream%uniform(-1.0_wp, 1.0_wp)
            if (present(levels)) map%heights(i, j) = &
               real(floor(0.5_wp*levels*(map%heights(i, j) + 1.0_wp)), wp)
         end do
      end do
   end subroutine random_map

   !> Take points away at random.
   subroutine punch_holes(map, stream, share)
      type(height_map), intent(inout) :: map
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: share
      integer :: i, j

      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (stream%uniform(0.0_wp, 1.0_wp) < share) map%heights(i, j) = none
         end do
      end do
   end subroutine punch_holes

   !> A whole number from `lowest` to `highest`.
   integer function random_whole(stream, lowest, highest)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: lowest, highest

      random_whole = min(highest, floor(stream%uniform(real(lowest, wp), real(highest + 1, wp))))
   end function random_whole

   !> Whether a map has just these heights.
   logical function kept_map(map, heights)
      type(height_map), intent(in) :: map
      real(wp), intent(in) :: heights(:, :)

      kept_map = all(abs(map%heights - heights) < tiny(1.0_wp))
   end function kept_map

end module map_cases
