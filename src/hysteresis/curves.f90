!> A skeleton as a curve outwards from the origin, and points on it.
module asperity_hysteresis_curves
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: hysteresis_skeleton
   implicit none
   private
   public :: cut_off, displacement_at, find_ultimate, outward, peak_of, rises_from_zero

   !> Forces that differ by less than this share are equally large
   real(wp), parameter :: same_force = 1.0e-9_wp
   !> A displacement below this share of the threshold is zero
   real(wp), parameter :: resolved = 0.1_wp

contains

   !> A skeleton outwards from the origin, both quantities positive.
   pure subroutine outward(s, skeleton, x, f)
      !> Sign of its side
      real(wp), intent(in) :: s
      !> The skeleton
      type(hysteresis_skeleton), intent(in) :: skeleton
      !> Its points, from 0
      real(wp), allocatable, intent(out) :: x(:), f(:)

      allocate (x(0:size(skeleton%force)), f(0:size(skeleton%force)), source=0.0_wp)
      x(1:) = s*skeleton%displacement
      f(1:) = s*skeleton%force
   end subroutine outward

   !> Point of the largest force; of equal ones the outermost.
   pure integer function peak_of(f) result(peak)
      !> Force of the points
      real(wp), intent(in) :: f(0:)
      real(wp) :: enough

      enough = (1.0_wp - same_force)*maxval(f)
      do peak = ubound(f, 1), 1, -1
         if (f(peak) >= enough) exit
      end do
   end function peak_of

   !> Whether a skeleton has a point of the rise to a share of its peak force.
   pure logical function rises_from_zero(x, f, peak, share, threshold)
      !> Points
      real(wp), intent(in) :: x(0:), f(0:)
      !> That of the peak
      integer, intent(in) :: peak
      !> Share of its force, and the distance from zero that counts as zero
      real(wp), intent(in) :: share, threshold

      rises_from_zero = x(1) > resolved*threshold .or. f(1) < share*f(peak)
   end function rises_from_zero

   !> Displacement at which the skeleton first has a force between zero and its peak.
   pure real(wp) function displacement_at(x, f, force)
      !> Points, and the force
      real(wp), intent(in) :: x(0:), f(0:), force
      integer :: i

      displacement_at = x(ubound(x, 1))
      do i = 1, ubound(x, 1)
         if (f(i) < force) cycle
         displacement_at = x(i - 1) + (x(i) - x(i - 1))*((force - f(i - 1))/(f(i) - f(i - 1)))
         return
      end do
   end function displacement_at

   !> Point past the peak where the force has fallen to a share of it, or the last point, and the
   !> area up to there.
   pure subroutine find_ultimate(x, f, peak, share, last_x, last_f, area, reached)
      !> Points, and the share
      real(wp), intent(in) :: x(0:), f(0:), share
      !> That of the peak
      integer, intent(in) :: peak
      !> The ultimate point, and the area
      real(wp), intent(out) :: last_x, last_f, area
      !> Whether the force falls so far
      logical, intent(out) :: reached
      integer :: i

      area = 0.0_wp
      reached = .false.
      last_x = x(0)
      last_f = f(0)
      do i = 1, ubound(x, 1)
         last_x = x(i)
         last_f = f(i)
         reached = i > peak .and. f(i) <= share*f(peak)
         if (reached) then
            last_f = share*f(peak)
            last_x = x(i - 1) + (x(i) - x(i - 1))*((last_f - f(i - 1))/(f(i) - f(i - 1)))
         end if
         area = area + 0.5_wp*(f(i - 1) + last_f)*(last_x - x(i - 1))
         if (reached) return
      end do
   end subroutine find_ultimate

   !> Cut a curve off at a displacement.
   pure subroutine cut_off(limit, x, f, is_cut)
      !> The displacement, which is positive
      real(wp), intent(in) :: limit
      !> Points, from 0, the first of which is the origin
      real(wp), allocatable, intent(inout) :: x(:), f(:)
      !> Whether the curve goes on
      logical, intent(out) :: is_cut
      real(wp), allocatable :: all_x(:), all_f(:)
      integer :: n

      is_cut = x(ubound(x, 1)) > limit
      if (.not. is_cut) return
      call move_alloc(x, all_x)
      call move_alloc(f, all_f)
      n = 1
      do while (.not. all_x(n) > limit)
         n = n + 1
      end do
      allocate (x(0:n), f(0:n))
      x(:) = all_x(:n)
      f(:) = all_f(:n)
      x(n) = limit
      f(n) = all_f(n - 1) + (all_f(n) - all_f(n - 1)) &
         *((limit - all_x(n - 1))/(all_x(n) - all_x(n - 1)))
   end subroutine cut_off

end module asperity_hysteresis_curves
