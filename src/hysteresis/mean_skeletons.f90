!> Mean of the skeletons of both sides.
!>
!> ASTM E2126, as it is commonly cited, takes the mean of the absolute displacements and forces of
!> both sides, cycle by cycle. Here the tips of the cycles that both skeletons have are those
!> points; between two of them, points at equal shares of the way on either side belong together.
!> Where both sides reach equally far, this is the mean force at each displacement.
module asperity_hysteresis_mean_skeletons
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: hysteresis_skeleton, negative_side, positive_side, &
      side_sign
   implicit none
   private
   public :: new_mean_skeleton

   !> Shares of the way that differ by less are the same
   real(wp), parameter :: same = 1.0e-12_wp

   !> The points of one side between two tips
   type :: stretch_type
      !> First and last point; the one before is the end of the stretch before, or the origin
      integer :: first = 1, last = 0
   end type stretch_type

contains

   !> The mean, to the last cycle that has points on both sides; without points if there is none.
   !> Displacement and force are positive.
   pure subroutine new_mean_skeleton(skeletons, mean)
      !> Skeletons of both sides
      type(hysteresis_skeleton), intent(in) :: skeletons(2)
      !> Its points are set
      type(hysteresis_skeleton), intent(out) :: mean
      type(stretch_type) :: stretch(2)
      real(wp), allocatable :: x(:), f(:)
      integer, allocatable :: origin(:)
      integer :: i, j, n, number

      n = size(skeletons(positive_side)%force) + size(skeletons(negative_side)%force)
      allocate (x(n), f(n), origin(n))
      n = 0
      j = 0
      associate (p => skeletons(positive_side)%cycle, q => skeletons(negative_side)%cycle)
         do i = 1, size(p)
            number = p(i)
            ! the tip of the cycle on this side, then on the other
            if (number == 0 .or. number == number_at(p, i + 1)) cycle
            do while (number_at(q, j + 1) <= number)
               j = j + 1
            end do
            if (number_at(q, j) /= number) cycle
            stretch%last = [i, j]
            call append_means(skeletons, stretch, number, x, f, origin, n)
            stretch%first = stretch%last + 1
         end do
      end associate
      allocate (mean%displacement, source=x(:n))
      allocate (mean%force, source=f(:n))
      allocate (mean%cycle, source=origin(:n))
   end subroutine new_mean_skeleton

   !> Cycle of a point; a very large number after the last one, zero before the first.
   pure integer function number_at(cycles, i)
      integer, intent(in) :: cycles(:), i

      number_at = 0
      if (i > size(cycles)) number_at = huge(number_at)
      if (i >= 1 .and. i <= size(cycles)) number_at = cycles(i)
   end function number_at

   !> Append the means of one stretch.
   pure subroutine append_means(skeletons, stretch, number, x, f, origin, n)
      type(hysteresis_skeleton), intent(in) :: skeletons(2)
      type(stretch_type), intent(in) :: stretch(2)
      integer, intent(in) :: number
      real(wp), intent(inout) :: x(:), f(:)
      integer, intent(inout) :: origin(:), n
      real(wp) :: share(2), next, point(2), other(2)
      integer :: i(2), side

      i = stretch%first
      do while (all(i <= stretch%last))
         do side = positive_side, negative_side
            share(side) = share_of(skeletons(side), stretch(side), i(side))
         end do
         next = minval(share)
         call point_at(skeletons(1), stretch(1), i(1), next, point)
         call point_at(skeletons(2), stretch(2), i(2), next, other)
         n = n + 1
         x(n) = 0.5_wp*(point(1)*side_sign(1) + other(1)*side_sign(2))
         f(n) = 0.5_wp*(point(2)*side_sign(1) + other(2)*side_sign(2))
         origin(n) = number
         where (share <= next + same) i = i + 1
      end do
   end subroutine append_means

   !> Share of the way at a point of a stretch.
   pure real(wp) function share_of(skeleton, stretch, i)
      type(hysteresis_skeleton), intent(in) :: skeleton
      type(stretch_type), intent(in) :: stretch
      integer, intent(in) :: i
      real(wp) :: from

      from = 0.0_wp
      if (stretch%first > 1) from = skeleton%displacement(stretch%first - 1)
      share_of = (skeleton%displacement(i) - from)/(skeleton%displacement(stretch%last) - from)
      if (i == stretch%last) share_of = 1.0_wp
   end function share_of

   !> Displacement and force at a share of the way, on the line that ends at a point.
   pure subroutine point_at(skeleton, stretch, i, share, point)
      type(hysteresis_skeleton), intent(in) :: skeleton
      type(stretch_type), intent(in) :: stretch
      integer, intent(in) :: i
      real(wp), intent(in) :: share
      real(wp), intent(out) :: point(2)
      real(wp) :: before(2), from, to, part

      before = 0.0_wp
      if (i > 1) before = [skeleton%displacement(i - 1), skeleton%force(i - 1)]
      from = 0.0_wp
      if (i > stretch%first) from = share_of(skeleton, stretch, i - 1)
      to = share_of(skeleton, stretch, i)
      part = 1.0_wp
      if (to - from > same) part = min(1.0_wp, (share - from)/(to - from))
      point = before + part*([skeleton%displacement(i), skeleton%force(i)] - before)
   end subroutine point_at

end module asperity_hysteresis_mean_skeletons
