!> Faces of solid elements: shape functions with their derivatives, and the point of a face that a
!> position projects onto.
module asperity_calculix_faces
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: face_point, has_face, point_of_face, project_onto_face, shape_functions

   !> Most nodes that a face has
   integer, parameter, public :: most_nodes = 8

   !> Point of a face: where it is, and what varies around it.
   type :: face_point
      !> Natural coordinates
      real(wp) :: xi(2) = 0.0_wp
      !> Shape functions of the nodes
      real(wp) :: n(most_nodes) = 0.0_wp
      !> Their first derivatives (node, coordinate)
      real(wp) :: dn(most_nodes, 2) = 0.0_wp
      !> Their second derivatives (node, 11 12 22)
      real(wp) :: ddn(most_nodes, 3) = 0.0_wp
      !> Position
      real(wp) :: position(3) = 0.0_wp
      !> First derivatives of the position (component, coordinate)
      real(wp) :: tangent(3, 2) = 0.0_wp
      !> Second derivatives of the position (component, 11 12 22)
      real(wp) :: curvature(3, 3) = 0.0_wp
   end type face_point

contains

   !> Whether faces of so many nodes are known: triangles of 3 and 6, quadrilaterals of 4 and 8.
   pure logical function has_face(nodes)
      !> Number of nodes
      integer, intent(in) :: nodes

      has_face = any(nodes == [3, 4, 6, 8])
   end function has_face

   !> Project a position onto a face, or onto its smooth continuation past the edges: Newton's
   !> method on the two orthogonality conditions.
   pure function project_onto_face(nodes, position, start) result(point)
      !> Positions of the face's nodes (3, number of nodes), corners first
      real(wp), intent(in) :: nodes(:, :)
      !> What is projected
      real(wp), intent(in) :: position(3)
      !> Natural coordinates to begin at; the middle of the face unless given
      real(wp), intent(in), optional :: start(2)
      type(face_point) :: point
      !> A Newton step is no longer than this; a face is 2 long
      real(wp), parameter :: longest = 1.0_wp
      !> Steps shorter than this are round-off
      real(wp), parameter :: shortest = 1.0e-14_wp
      integer, parameter :: most_steps = 50
      real(wp) :: residual(2), hessian(3), gap(3), step(2), xi(2), determinant, length
      integer :: i

      xi = 0.0_wp
      if (size(nodes, 2) == 3 .or. size(nodes, 2) == 6) xi = 1.0_wp/3.0_wp
      if (present(start)) xi = start
      do i = 1, most_steps
         point = point_of_face(nodes, xi)
         gap = position - point%position
         residual = matmul(gap, point%tangent)
         call orthogonality(point, gap, hessian)
         determinant = hessian(1)*hessian(3) - hessian(2)**2
         if (.not. abs(determinant) > 0.0_wp) return
         step = -[hessian(3)*residual(1) - hessian(2)*residual(2), &
            hessian(1)*residual(2) - hessian(2)*residual(1)]/determinant
         length = norm2(step)
         if (length > longest) step = step*(longest/length)
         if (.not. length > shortest) return
         xi = xi + step
      end do
      point = point_of_face(nodes, xi)
   end function project_onto_face

   !> Derivatives of (gap . tangent) by the natural coordinates: 11, 12, 22.
   pure subroutine orthogonality(point, gap, hessian)
      !> Point of the face
      type(face_point), intent(in) :: point
      !> From the point to the position that is projected
      real(wp), intent(in) :: gap(3)
      !> The derivatives
      real(wp), intent(out) :: hessian(3)

      hessian = matmul(gap, point%curvature) - [dot_product(point%tangent(:, 1), &
         point%tangent(:, 1)), dot_product(point%tangent(:, 1), point%tangent(:, 2)), &
         dot_product(point%tangent(:, 2), point%tangent(:, 2))]
   end subroutine orthogonality

   !> Everything at one pair of natural coordinates.
   pure function point_of_face(nodes, xi) result(point)
      !> Positions of the nodes
      real(wp), intent(in) :: nodes(:, :)
      !> Natural coordinates
      real(wp), intent(in) :: xi(2)
      type(face_point) :: point
      integer :: m

      m = size(nodes, 2)
      point%xi = xi
      call shape_functions(m, xi, point%n, point%dn, point%ddn)
      point%position = matmul(nodes, point%n(:m))
      point%tangent = matmul(nodes, point%dn(:m, :))
      point%curvature = matmul(nodes, point%ddn(:m, :))
   end function point_of_face

   !> Shape functions of a face with 3, 4, 6 or 8 nodes, corners first, in the usual order.
   pure subroutine shape_functions(nodes, xi, n, dn, ddn)
      !> Number of nodes
      integer, intent(in) :: nodes
      !> Natural coordinates: 0 to 1 in triangles, -1 to 1 in quadrilaterals
      real(wp), intent(in) :: xi(2)
      !> Shape functions
      real(wp), intent(out) :: n(most_nodes)
      !> First derivatives
      real(wp), intent(out) :: dn(most_nodes, 2)
      !> Second derivatives 11, 12, 22
      real(wp), intent(out) :: ddn(most_nodes, 3)

      n = 0.0_wp
      dn = 0.0_wp
      ddn = 0.0_wp
      select case (nodes)
      case (3)
         n(:3) = [1.0_wp - xi(1) - xi(2), xi(1), xi(2)]
         dn(:3, 1) = [-1.0_wp, 1.0_wp, 0.0_wp]
         dn(:3, 2) = [-1.0_wp, 0.0_wp, 1.0_wp]
      case (4)
         call bilinear(xi, n(:4), dn(:4, :), ddn(:4, :))
      case (6)
         call quadratic_triangle(xi, n(:6), dn(:6, :), ddn(:6, :))
      case (8)
         call serendipity(xi, n, dn, ddn)
      case default
         continue
      end select
   end subroutine shape_functions

   !> Signs of the natural coordinates at the corners of a quadrilateral.
   pure function corner_signs() result(s)
      real(wp) :: s(4, 2)

      s(:, 1) = [-1.0_wp, 1.0_wp, 1.0_wp, -1.0_wp]
      s(:, 2) = [-1.0_wp, -1.0_wp, 1.0_wp, 1.0_wp]
   end function corner_signs

   !> Four nodes.
   pure subroutine bilinear(xi, n, dn, ddn)
      real(wp), intent(in) :: xi(2)
      real(wp), intent(out) :: n(4), dn(4, 2), ddn(4, 3)
      real(wp) :: s(4, 2)

      s = corner_signs()
      n = 0.25_wp*(1.0_wp + s(:, 1)*xi(1))*(1.0_wp + s(:, 2)*xi(2))
      dn(:, 1) = 0.25_wp*s(:, 1)*(1.0_wp + s(:, 2)*xi(2))
      dn(:, 2) = 0.25_wp*s(:, 2)*(1.0_wp + s(:, 1)*xi(1))
      ddn = 0.0_wp
      ddn(:, 2) = 0.25_wp*s(:, 1)*s(:, 2)
   end subroutine bilinear

   !> Six nodes: corners, then the middles of edges 1-2, 2-3, 3-1.
   pure subroutine quadratic_triangle(xi, n, dn, ddn)
      real(wp), intent(in) :: xi(2)
      real(wp), intent(out) :: n(6), dn(6, 2), ddn(6, 3)
      real(wp) :: a(3), da(3, 2)
      integer :: i, j

      a = [1.0_wp - xi(1) - xi(2), xi(1), xi(2)]
      da(:, 1) = [-1.0_wp, 1.0_wp, 0.0_wp]
      da(:, 2) = [-1.0_wp, 0.0_wp, 1.0_wp]
      do i = 1, 3
         j = mod(i, 3) + 1
         n(i) = a(i)*(2.0_wp*a(i) - 1.0_wp)
         dn(i, :) = (4.0_wp*a(i) - 1.0_wp)*da(i, :)
         ddn(i, :) = 4.0_wp*[da(i, 1)**2, da(i, 1)*da(i, 2), da(i, 2)**2]
         n(i + 3) = 4.0_wp*a(i)*a(j)
         dn(i + 3, :) = 4.0_wp*(a(i)*da(j, :) + a(j)*da(i, :))
         ddn(i + 3, :) = 4.0_wp*[2.0_wp*da(i, 1)*da(j, 1), da(i, 1)*da(j, 2) + da(j, 1)*da(i, 2), &
            2.0_wp*da(i, 2)*da(j, 2)]
      end do
   end subroutine quadratic_triangle

   !> Eight nodes: corners, then the middles of edges 1-2, 2-3, 3-4, 4-1.
   pure subroutine serendipity(xi, n, dn, ddn)
      real(wp), intent(in) :: xi(2)
      real(wp), intent(out) :: n(8), dn(8, 2), ddn(8, 3)
      real(wp) :: s(4, 2), a, b, x, y
      integer :: i, k

      s = corner_signs()
      x = xi(1)
      y = xi(2)
      do i = 1, 4
         a = s(i, 1)
         b = s(i, 2)
         n(i) = 0.25_wp*(1.0_wp + a*x)*(1.0_wp + b*y)*(a*x + b*y - 1.0_wp)
         dn(i, :) = 0.25_wp*[a*(1.0_wp + b*y)*(2.0_wp*a*x + b*y), &
            b*(1.0_wp + a*x)*(2.0_wp*b*y + a*x)]
         ddn(i, :) = 0.25_wp*[2.0_wp*(1.0_wp + b*y), a*b*(2.0_wp*a*x + 2.0_wp*b*y + 1.0_wp), &
            2.0_wp*(1.0_wp + a*x)]
      end do
      do k = 1, 2
         ! the edges at y = -1 and 1
         i = 3 + 2*k
         b = 2.0_wp*k - 3.0_wp
         n(i) = 0.5_wp*(1.0_wp - x**2)*(1.0_wp + b*y)
         dn(i, :) = [-x*(1.0_wp + b*y), 0.5_wp*b*(1.0_wp - x**2)]
         ddn(i, :) = [-(1.0_wp + b*y), -b*x, 0.0_wp]
         ! the edges at x = 1 and -1
         i = i + 1
         a = -b
         n(i) = 0.5_wp*(1.0_wp + a*x)*(1.0_wp - y**2)
         dn(i, :) = [0.5_wp*a*(1.0_wp - y**2), -y*(1.0_wp + a*x)]
         ddn(i, :) = [0.0_wp, -a*y, -(1.0_wp + a*x)]
      end do
   end subroutine serendipity

end module asperity_calculix_faces
