!> Half a cycle of OpenSees' Pinching4, three lines between four points: where it turns, where it is
!> unloaded, where reloading begins, and the largest displacement of the other side so far. Seen so
!> that displacement falls. What moves the points where they lie ill is that of version 3.7.1.2,
!> which this follows to round-off.
module asperity_frame_pinching4_path
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: force_along, shape_path

   !> Unloading and reloading that pass each other end so far from the force half way, as a share
   real(wp), parameter :: evened = 0.01_wp
   !> Below this a slope is none
   real(wp), parameter :: least_slope = 1.0e-8_wp

contains

   !> Set where it is unloaded, and move points that lie ill.
   pure subroutine shape_path(px, pf, unloading, first, ends_negative)
      !> Displacements; the second is set
      real(wp), intent(inout) :: px(4)
      !> Forces
      real(wp), intent(inout) :: pf(4)
      !> Stiffness of unloading, and the first one of the side ahead, the most that reloading has
      real(wp), intent(in) :: unloading, first
      !> Whether the last point is one of the negative side
      logical, intent(in) :: ends_negative
      real(wp) :: slope
      integer :: negative

      px(2) = px(1) - (pf(1) - pf(2))/unloading
      px(3) = max(px(4) + (pf(3) - pf(4))/first, px(3))
      slope = slope_of(px(2:3), pf(2:3))
      if (.not. px(1) > 0.0_wp .or. px(3) > px(1)) then
         call straighten(px, pf)
      else if (px(2) > px(1)) then
         call skip(px, pf, 2, 3)
      else if (slope > max(unloading, first)) then
         call straighten(px, pf)
      else if (px(2) < px(3) .or. slope < 0.0_wp) then
         if (px(2) < 0.0_wp) then
            call skip(px, pf, 2, 3)
         else if (px(3) > 0.0_wp) then
            call skip(px, pf, 3, 2)
         else
            call even_out(px, pf)
         end if
      end if
      if (.not. any(px(2:) > px(:3) .or. pf(2:) > pf(:3))) return
      call straighten(px, pf)
      ! through zero if that line is less stiff than the secant of the end on the negative side
      slope = slope_of(px([1, 4]), pf([1, 4]))
      negative = merge(4, 1, ends_negative)
      if (.not. (slope > least_slope .and. slope*px(negative)**2 < pf(negative)*px(negative))) &
         return
      px(2:3) = 0.0_wp
      pf(2:3) = 0.0_wp
   end subroutine shape_path

   !> Slope from one point to the next; huge where the second lies below the first.
   pure real(wp) function slope_of(px, pf) result(slope)
      real(wp), intent(in) :: px(2), pf(2)

      if (abs(px(1) - px(2)) > 0.0_wp) then
         slope = (pf(1) - pf(2))/(px(1) - px(2))
      else
         slope = sign(huge(slope), pf(1) - pf(2))
      end if
   end function slope_of

   !> One line from the first point to the last.
   pure subroutine straighten(px, pf)
      real(wp), intent(inout) :: px(4), pf(4)

      px(2:3) = px(4)
      pf(2:3) = pf(4)
   end subroutine straighten

   !> Leave out a point: it goes where another is.
   pure subroutine skip(px, pf, point, to)
      real(wp), intent(inout) :: px(4), pf(4)
      integer, intent(in) :: point, to

      px(point) = px(to)
      pf(point) = pf(to)
   end subroutine skip

   !> Unloading and reloading that pass each other meet half way in force, nearly.
   pure subroutine even_out(px, pf)
      real(wp), intent(inout) :: px(4), pf(4)
      real(wp) :: unloading, reloading, middle

      unloading = slope_of(px(:2), pf(:2))
      reloading = slope_of(px(3:), pf(3:))
      middle = 0.5_wp*(pf(2) + pf(3))
      pf(2:3) = middle + abs(middle)*[evened, -evened]
      px(2) = px(1) - (pf(1) - pf(2))/unloading
      px(3) = px(4) + (pf(3) - pf(4))/reloading
   end subroutine even_out

   !> Force between the points.
   pure real(wp) function force_along(px, pf, displacement) result(force)
      !> Displacements, falling, and forces
      real(wp), intent(in) :: px(4), pf(4)
      !> Between the first and the last
      real(wp), intent(in) :: displacement
      integer :: i

      force = pf(1)
      do i = 2, 4
         if (displacement < px(i) .or. .not. px(i) < px(i - 1)) cycle
         force = pf(i) + (pf(i - 1) - pf(i))*(displacement - px(i))/(px(i - 1) - px(i))
         exit
      end do
   end function force_along

end module asperity_frame_pinching4_path
