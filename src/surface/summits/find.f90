!> Summits of a map, and which of them are peaks: tops of the hills left after Wolf pruning.
module asperity_surface_summits_find
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_summits_hills, only: find_hills
   implicit none
   private
   public :: find_summits, summit_set

   !> Summits, points above all eight neighbours, all of them measured; of equal heights the later
   !> in storage counts as higher. In the order of storage.
   type :: summit_set
      !> Their points
      integer, allocatable :: i(:), j(:)
      !> Heights, mm, and mean curvatures -(z_xx + z_yy)/2, 1/mm
      real(wp), allocatable :: height(:), curvature(:)
      !> Relief of its hill, mm, and whether that is left after pruning
      real(wp), allocatable :: relief(:)
      logical, allocatable :: is_peak(:)
      !> Hills of less relief than this were pruned, mm
      real(wp) :: pruned_below = 0.0_wp
   end type summit_set

contains

   !> Find all summits. Hills with their top on the border or beside a missing point take part in
   !> the pruning, but their tops are no summits.
   pure subroutine find_summits(map, share, summits, error)
      !> The map
      type(height_map), intent(in) :: map
      !> Hills of less relief than this share of the map's height range are pruned; from 0 to 1
      real(wp), intent(in) :: share
      !> The summits
      type(summit_set), intent(out) :: summits
      !> Set when the share is not allowed or the map has too many points to number
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: tops(:)
      real(wp), allocatable :: relief(:)
      logical, allocatable :: is_inner(:)
      integer :: n, inner
      logical :: is_allowed

      is_allowed = is_finite(share)
      if (is_allowed) is_allowed = share >= 0.0_wp .and. share <= 1.0_wp
      if (.not. is_allowed) then
         call fatal_error(error, 'pruning share '//to_text(share)//' is not allowed: from 0 to 1', &
            subject='pruning')
         return
      end if
      if (size(map%heights, kind=int64) > huge(1)) then
         call fatal_error(error, map%source//': more than '//to_text(huge(1))//' points')
         return
      end if
      summits%pruned_below = share*height_range(map%heights)
      call find_hills(map%heights, map%source, tops, relief, error)
      ! 36 bytes a summit, and 4 whether it is inside
      if (.not. allocated(error)) &
         call check_room(map%source, 40_int64*size(tops, kind=int64), error)
      if (allocated(error)) return
      associate (nx => size(map%heights, 1))
         allocate (is_inner(size(tops)))
         do n = 1, size(tops)
            is_inner(n) = is_surrounded(map%heights, modulo(tops(n) - 1, nx) + 1, &
               (tops(n) - 1)/nx + 1)
         end do
         inner = count(is_inner)
         allocate (summits%i(inner), summits%j(inner), summits%height(inner), &
            summits%curvature(inner), summits%relief(inner), summits%is_peak(inner))
         inner = 0
         do n = 1, size(tops)
            if (.not. is_inner(n)) cycle
            inner = inner + 1
            summits%i(inner) = modulo(tops(n) - 1, nx) + 1
            summits%j(inner) = (tops(n) - 1)/nx + 1
            summits%relief(inner) = relief(n)
            summits%is_peak(inner) = relief(n) >= summits%pruned_below
         end do
      end associate
      do n = 1, inner
         summits%height(n) = map%heights(summits%i(n), summits%j(n))
         summits%curvature(n) = curvature_at(map, summits%i(n), summits%j(n))
      end do
   end subroutine find_summits

   !> Highest less lowest measured height; 0 when none was measured.
   pure real(wp) function height_range(z)
      real(wp), intent(in), contiguous :: z(:, :)
      real(wp) :: lowest, highest
      integer :: i, j

      lowest = huge(1.0_wp)
      highest = -huge(1.0_wp)
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (z(i, j) >= none) cycle
            lowest = min(lowest, z(i, j))
            highest = max(highest, z(i, j))
         end do
      end do
      height_range = 0.0_wp
      if (highest > lowest) height_range = highest - lowest
   end function height_range

   !> Whether a point has eight measured neighbours.
   pure logical function is_surrounded(z, i, j)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: i, j

      is_surrounded = i > 1 .and. i < size(z, 1) .and. j > 1 .and. j < size(z, 2)
      if (is_surrounded) is_surrounded = all(z(i - 1:i + 1, j - 1:j + 1) < none)
   end function is_surrounded

   !> Mean curvature by three points either way, 1/mm.
   pure real(wp) function curvature_at(map, i, j)
      type(height_map), intent(in) :: map
      integer, intent(in) :: i, j

      associate (z => map%heights)
         curvature_at = 0.5_wp*((2.0_wp*z(i, j) - z(i - 1, j) - z(i + 1, j))/map%step_x**2 &
            + (2.0_wp*z(i, j) - z(i, j - 1) - z(i, j + 1))/map%step_y**2)
      end associate
   end function curvature_at

end module asperity_surface_summits_find
