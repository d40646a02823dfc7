!> The robust L filter: Gaussian regression of order 2 (ISO 16610-31 along a profile, -71 on a map)
!> whose points have Tukey's weights (1 - (r/c)^2)^2 of their distance r from the line, none beyond
!> c = 4.4478 times the median of |r|, three standard deviations of Gaussian r. So pores, which are
!> far below, do not pull it down. Line and weights follow from each other until no point of the
!> line moves by more than c/10000. The first weights are of lines of order 0, as a parabola would
!> follow a pore at an end.
module asperity_surface_prepare_robust_filter
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_prepare_gaussian_filter, only: check_cutoff
   use asperity_surface_prepare_regression, only: regress
   implicit none
   private
   public :: filter_long_robust, median

   !> c over the median of |r|
   real(wp), parameter :: reach = 4.4478_wp
   !> Iterations of order 0
   integer, parameter :: first_ones = 3
   !> Change of the line over c at which it is settled, and iterations after which it is not
   real(wp), parameter :: settled = 1.0e-4_wp
   integer, parameter :: most_iterations = 200
   !> c over the largest height below which more than half of the points are on the line
   real(wp), parameter :: rounding = 1.0e-12_wp
   !> Arrays of the map's size that are there at once: heights, weights, lines, sums and residuals
   integer(int64), parameter :: copies = 14_int64

contains

   !> Take waves longer than the cutoff away.
   subroutine filter_long_robust(map, cutoff, error)
      !> The map, or the profile; unchanged after an error
      type(height_map), intent(inout) :: map
      !> Length of the wave of which half is left, mm
      real(wp), intent(in) :: cutoff
      !> Set when the cutoff is not allowed, or no line is found
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: before(:, :), line(:, :), z(:, :), weights(:, :)
      real(wp) :: change, distance
      integer :: iteration

      call check_cutoff(map, 'long_cutoff', cutoff, error)
      if (allocated(error)) return
      call check_room(map%source, copies*8_int64*size(map%heights, kind=int64), error)
      if (allocated(error)) return
      z = map%heights
      allocate (before, line, weights, mold=z)
      weights = 1.0_wp
      where (z >= none)
         z = 0.0_wp
         weights = 0.0_wp
      end where
      before = 0.0_wp
      do iteration = 1, most_iterations
         call regress(z, weights, cutoff/map%step_x, cutoff/map%step_y, &
            merge(0, 2, iteration <= first_ones), line)
         if (any(line >= none .and. map%heights < none)) then
            call fatal_error(error, map%source//': in a part wider than long_cutoff = '// &
               to_text(cutoff)//' mm every point is far from any line that the robust filter '// &
               'finds: raise it, or take --long-filter gaussian', subject='long_cutoff')
            return
         end if
         distance = reach*median(pack(abs(z - line), map%heights < none))
         if (distance <= rounding*maxval(abs(z))) then
            if (iteration > first_ones) exit
            cycle
         end if
         change = maxval(abs(line - before), mask=map%heights < none)
         if (iteration > first_ones + 1 .and. change <= settled*distance) exit
         where (map%heights < none .and. abs(z - line) < distance)
            weights = (1.0_wp - ((z - line)/distance)**2)**2
         else where
            weights = 0.0_wp
         end where
         before = line
      end do
      if (iteration > most_iterations) then
         call fatal_error(error, map%source//': the robust filter has not settled after '// &
            to_text(most_iterations)//' iterations: take --long-filter gaussian', &
            computation_error)
         return
      end if
      where (map%heights < none) map%heights = map%heights - line
   end subroutine filter_long_robust

   !> The median, by Hoare's partition about a middle value again and again.
   pure real(wp) function median(values)
      !> The values; of none it is zero
      real(wp), intent(in) :: values(:)
      real(wp), allocatable :: v(:)
      integer :: n

      median = 0.0_wp
      n = size(values)
      if (n < 1) return
      allocate (v, source=values)
      call select(v, n/2 + 1)
      median = v(n/2 + 1)
      if (mod(n, 2) == 0) median = 0.5_wp*(median + maxval(v(:n/2)))
   end function median

   !> Move the values so that the one at `k` is where it is in their order, smaller ones before it.
   pure subroutine select(v, k)
      real(wp), intent(inout) :: v(:)
      integer, intent(in) :: k
      real(wp) :: middle, moved
      integer :: first, i, j, last

      first = 1
      last = size(v)
      do while (first < last)
         ! the middle one of three, so that values in order do no harm
         middle = max(min(v(first), v(last)), min(max(v(first), v(last)), v((first + last)/2)))
         i = first
         j = last
         do
            do while (v(i) < middle)
               i = i + 1
            end do
            do while (middle < v(j))
               j = j - 1
            end do
            if (i <= j) then
               moved = v(i)
               v(i) = v(j)
               v(j) = moved
               i = i + 1
               j = j - 1
            end if
            if (i > j) exit
         end do
         if (k <= j) then
            last = j
         else if (k >= i) then
            first = i
         else
            return
         end if
      end do
   end subroutine select

end module asperity_surface_prepare_robust_filter
