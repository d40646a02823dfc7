!> Part of a polygon that lies in a rectangle.
module asperity_solid_contact_geometry_polygon
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: clip_to_rectangle

   !> Most corners: each of four cuts adds one, and one more where the polygon is not convex
   integer, parameter :: largest = 12

contains

   !> Area and centroid of what a quadrilateral and a rectangle share, by cutting along one side of
   !> the rectangle after the other.
   pure subroutine clip_to_rectangle(corners, low, high, area, centroid)
      !> Corners of the quadrilateral, in turn
      real(wp), intent(in) :: corners(2, 4)
      !> Corners of the rectangle
      real(wp), intent(in) :: low(2), high(2)
      !> Area, with the sign of the quadrilateral's sense; zero when nothing is shared
      real(wp), intent(out) :: area
      !> Centroid; not set when the area is zero
      real(wp), intent(out) :: centroid(2)
      real(wp) :: polygon(2, largest)
      integer :: n, direction

      n = 4
      polygon(:, :4) = corners
      do direction = 1, 2
         call cut(polygon, n, direction, 1.0_wp, low(direction))
         call cut(polygon, n, direction, -1.0_wp, high(direction))
      end do
      call measure(polygon(:, :n), area, centroid)
   end subroutine clip_to_rectangle

   !> Keep what lies beyond a value of one coordinate, or before it.
   pure subroutine cut(polygon, n, direction, sense, value)
      real(wp), intent(inout) :: polygon(2, largest)
      integer, intent(inout) :: n
      integer, intent(in) :: direction
      real(wp), intent(in) :: sense, value
      real(wp) :: before(2, largest), height(largest)
      integer :: corners, i, j

      corners = n
      before = polygon
      height(:n) = sense*(polygon(direction, :n) - value)
      n = 0
      do i = 1, corners
         j = modulo(i, corners) + 1
         if (height(i) >= 0.0_wp) then
            n = n + 1
            polygon(:, n) = before(:, i)
         end if
         if (height(i)*height(j) < 0.0_wp) then
            n = n + 1
            polygon(:, n) = before(:, i) &
               + height(i)/(height(i) - height(j))*(before(:, j) - before(:, i))
         end if
      end do
   end subroutine cut

   pure subroutine measure(polygon, area, centroid)
      real(wp), intent(in) :: polygon(:, :)
      real(wp), intent(out) :: area, centroid(2)
      real(wp) :: a(2), b(2), part
      integer :: i

      area = 0.0_wp
      centroid = 0.0_wp
      do i = 2, size(polygon, 2) - 1
         a = polygon(:, i) - polygon(:, 1)
         b = polygon(:, i + 1) - polygon(:, 1)
         part = 0.5_wp*(a(1)*b(2) - a(2)*b(1))
         area = area + part
         centroid = centroid + part*(a + b)/3.0_wp
      end do
      if (abs(area) > 0.0_wp) centroid = polygon(:, 1) + centroid/area
   end subroutine measure

end module asperity_solid_contact_geometry_polygon
