!> Filling missing points: a membrane across each hole, held by the points around it.
!>
!> Every filled height is the mean of its neighbours' heights, up to rounding and the iteration's
!> end, and a mean is neither above nor below all of them: no summits arise in holes, nor pits.
!> Starting values come from the same problem on a map of half the points either way, and so on
!> down to a map without holes.
module asperity_surface_prepare_fill_holes
   use, intrinsic :: iso_fortran_env, only: int64, int8
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_surface_prepare_membrane, only: mean_around, relax
   implicit none
   private
   public :: fill_missing, missing_share

   !> Rounds over all grids, each of which leaves less than half of the error before it
   integer, parameter :: coarse_rounds = 1, fine_rounds = 6
   !> Sweeps to remove the last summits and pits, which the first few do
   integer, parameter :: most_repairs = 200

contains

   !> Missing points by all points of a map.
   pure real(wp) function missing_share(map)
      !> The map
      type(height_map), intent(in) :: map

      missing_share = real(count(map%heights >= none, kind=int64), wp) &
         /real(size(map%heights, kind=int64), wp)
   end function missing_share

   !> Fill all missing points.
   pure subroutine fill_missing(map, error)
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when nothing was measured
      type(error_type), allocatable, intent(out) :: error

      if (all(map%heights >= none)) then
         call fatal_error(error, map%source//': every point is missing, so nothing tells how '// &
            'to fill them')
         return
      end if
      call fill(map%heights, fine_rounds)
   end subroutine fill_missing

   !> Fill an array of heights, one of them measured at least.
   pure recursive subroutine fill(z, rounds)
      real(wp), intent(inout), contiguous :: z(:, :)
      !> Rounds over this grid and all coarser ones
      integer, intent(in) :: rounds
      real(wp), allocatable :: coarse(:, :), load(:)
      integer(int8), allocatable :: is_hole(:, :)
      integer, allocatable :: holes(:, :)
      integer :: i, j, n

      n = 0
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (z(i, j) >= none) n = n + 1
         end do
      end do
      if (n == 0) return
      allocate (holes(2, n))
      n = 0
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (z(i, j) < none) cycle
            n = n + 1
            holes(:, n) = [i, j]
         end do
      end do
      call coarsen(z, coarse)
      call fill(coarse, coarse_rounds)
      do n = 1, size(holes, 2)
         z(holes(1, n), holes(2, n)) = interpolated(coarse, holes(1, n), holes(2, n))
      end do
      deallocate (coarse)
      allocate (load(size(holes, 2)), is_hole(size(z, 1), size(z, 2)))
      load = 0.0_wp
      is_hole = 0_int8
      do n = 1, size(holes, 2)
         is_hole(holes(1, n), holes(2, n)) = 1_int8
      end do
      do i = 1, rounds
         call relax(z, is_hole, holes, load)
      end do
      call repair(z, holes)
   end subroutine fill

   !> A map of half the points either way: means of the measured of four each.
   pure subroutine coarsen(z, coarse)
      real(wp), intent(in), contiguous :: z(:, :)
      real(wp), allocatable, intent(out) :: coarse(:, :)
      real(wp) :: total
      integer :: i, j, k, l, n

      allocate (coarse((size(z, 1) + 1)/2, (size(z, 2) + 1)/2))
      do j = 1, size(coarse, 2)
         do i = 1, size(coarse, 1)
            total = 0.0_wp
            n = 0
            do l = 2*j - 1, min(2*j, size(z, 2))
               do k = 2*i - 1, min(2*i, size(z, 1))
                  if (z(k, l) >= none) cycle
                  n = n + 1
                  total = total + z(k, l)
               end do
            end do
            coarse(i, j) = none
            if (n > 0) coarse(i, j) = total/real(n, wp)
         end do
      end do
   end subroutine coarsen

   !> Height of a coarse map at a point of the fine one: linear between the centres of its cells,
   !> constant beyond the outermost.
   pure real(wp) function interpolated(coarse, i, j)
      real(wp), intent(in), contiguous :: coarse(:, :)
      integer, intent(in) :: i, j
      integer :: k, l, k2, l2

      k = (i + 1)/2
      l = (j + 1)/2
      k2 = min(max(k + 2*modulo(i + 1, 2) - 1, 1), size(coarse, 1))
      l2 = min(max(l + 2*modulo(j + 1, 2) - 1, 1), size(coarse, 2))
      interpolated = 0.0625_wp*(9.0_wp*coarse(k, l) + 3.0_wp*(coarse(k2, l) + coarse(k, l2)) &
         + coarse(k2, l2))
   end function interpolated

   !> Sweep over the holes that are still above or below all their neighbours until there are none.
   pure subroutine repair(z, holes)
      real(wp), intent(inout), contiguous :: z(:, :)
      integer, intent(in), contiguous :: holes(:, :)
      integer :: n, round, repaired

      do round = 1, most_repairs
         repaired = 0
         do n = 1, size(holes, 2)
            associate (i => holes(1, n), j => holes(2, n))
               if (.not. is_extreme(z, i, j)) cycle
               z(i, j) = mean_around(z, i, j)
               repaired = repaired + 1
            end associate
         end do
         if (repaired == 0) return
      end do
   end subroutine repair

   !> Whether a point is above or below all its neighbours.
   pure logical function is_extreme(z, i, j)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: i, j
      logical :: is_above, is_below
      integer :: k, l

      is_above = .true.
      is_below = .true.
      do l = max(j - 1, 1), min(j + 1, size(z, 2))
         do k = max(i - 1, 1), min(i + 1, size(z, 1))
            if (k == i .and. l == j) cycle
            is_above = is_above .and. z(k, l) < z(i, j)
            is_below = is_below .and. z(k, l) > z(i, j)
         end do
      end do
      is_extreme = is_above .or. is_below
   end function is_extreme

end module asperity_surface_prepare_fill_holes
