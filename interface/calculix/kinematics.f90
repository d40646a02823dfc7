!> How a slave node lies and moves over a master face: overclosure, slip and local axes, with their
!> derivatives by the positions of all nodes. Node order: those of the face, then the slave node.
module calculix_kinematics
   use asperity_kinds, only: wp
   use calculix_faces, only: face_point, most_nodes, project_onto_face
   implicit none
   private
   public :: motion_type, variation_type, find_motion, find_variation

   !> Most degrees of freedom of a spring
   integer, parameter, public :: most_freedoms = 3*(most_nodes + 1)

   !> One slave node over its face, at the end of an increment.
   type :: motion_type
      !> Number of nodes of the face
      integer :: nodes = 0
      !> The slave node's projection
      type(face_point) :: point
      !> Normal out of the master, then the two slip directions (columns)
      real(wp) :: axes(3, 3) = 0.0_wp
      !> Length of the product of the two tangents that the normal is made from
      real(wp) :: size_of_normal = 0.0_wp
      !> Global direction that the first slip direction is the projection of
      real(wp) :: reference(3) = 0.0_wp
      !> From the projection to the slave node
      real(wp) :: gap(3) = 0.0_wp
      !> Overclosure at the end and at the start, positive for penetration
      real(wp) :: overclosure = 0.0_wp, start_overclosure = 0.0_wp
      !> Displacement of the slave node against the face in the increment, at one projection
      real(wp) :: increment(3) = 0.0_wp
      !> The same of each node (3, node)
      real(wp) :: node_increments(3, most_nodes + 1) = 0.0_wp
      !> In the two slip directions
      real(wp) :: slip(2) = 0.0_wp
      !> Rotation of the face about its normal in the increment, seen in the slip directions
      real(wp) :: rotation(2, 2) = 0.0_wp
   end type motion_type

   !> Derivatives by every degree of freedom, 3 a node.
   type :: variation_type
      !> Of the natural coordinates of the projection
      real(wp) :: xi(2, most_freedoms) = 0.0_wp
      !> Of the normal and the two slip directions (component, axis, freedom)
      real(wp) :: axes(3, 3, most_freedoms) = 0.0_wp
      !> Of the overclosure and the two slips
      real(wp) :: motion(3, most_freedoms) = 0.0_wp
   end type variation_type

contains

   !> Where the slave node is, and how it moved. The slip is the difference of displacements since
   !> the start of the increment at the projection of its end, so that a strain or a rotation of
   !> what slipped before adds nothing.
   pure function find_motion(positions, start_positions) result(motion)
      !> Positions at the end (3, node), and at the start of the increment
      real(wp), intent(in) :: positions(:, :), start_positions(:, :)
      type(motion_type) :: motion
      type(face_point) :: start
      real(wp) :: start_axes(3, 3), length, reference(3)
      integer :: m, s

      s = size(positions, 2)
      m = s - 1
      motion%nodes = m
      motion%point = project_onto_face(positions(:, :m), positions(:, s))
      call axes_of_face(motion%point, motion%axes, motion%size_of_normal, motion%reference)
      motion%gap = positions(:, s) - motion%point%position
      motion%overclosure = -dot_product(motion%gap, motion%axes(:, 1))
      motion%node_increments(:, :s) = positions - start_positions
      motion%increment = motion%node_increments(:, s) &
         - matmul(motion%node_increments(:, :m), motion%point%n(:m))
      motion%slip = matmul(motion%increment, motion%axes(:, 2:))

      start = project_onto_face(start_positions(:, :m), start_positions(:, s), motion%point%xi)
      call axes_of_face(start, start_axes, length, reference)
      motion%start_overclosure = -dot_product(start_positions(:, s) - start%position, &
         start_axes(:, 1))
      motion%rotation = rotation_between(matmul(transpose(start_axes(:, 2:)), start%tangent), &
         matmul(transpose(motion%axes(:, 2:)), motion%point%tangent))
   end function find_motion

   !> Normal and slip directions: the first is global x projected on the face, or z where x lies
   !> within 0.1 degrees of the normal, as in ABAQUS.
   pure subroutine axes_of_face(point, axes, length, reference)
      !> Point of the face
      type(face_point), intent(in) :: point
      !> Normal and slip directions, as columns
      real(wp), intent(out) :: axes(3, 3)
      !> Length of the product of the tangents
      real(wp), intent(out) :: length
      !> The global direction that is projected
      real(wp), intent(out) :: reference(3)
      real(wp), parameter :: cosine = 1.0_wp - 1.5231e-6_wp

      axes(:, 1) = cross(point%tangent(:, 1), point%tangent(:, 2))
      length = norm2(axes(:, 1))
      axes(:, 1) = axes(:, 1)/length
      reference = [1.0_wp, 0.0_wp, 0.0_wp]
      if (abs(axes(1, 1)) > cosine) reference = [0.0_wp, 0.0_wp, 1.0_wp]
      axes(:, 2) = reference - dot_product(reference, axes(:, 1))*axes(:, 1)
      axes(:, 2) = axes(:, 2)/norm2(axes(:, 2))
      axes(:, 3) = cross(axes(:, 1), axes(:, 2))
   end subroutine axes_of_face

   !> Rotation part (polar decomposition) of the map from one pair of tangents to another, each in
   !> its own slip directions.
   pure function rotation_between(from, to) result(rotation)
      !> Tangents at the start and at the end, as columns
      real(wp), intent(in) :: from(2, 2), to(2, 2)
      real(wp) :: rotation(2, 2)
      real(wp) :: adjoint(2, 2), map(2, 2), c, s, length

      adjoint(:, 1) = [from(2, 2), -from(2, 1)]
      adjoint(:, 2) = [-from(1, 2), from(1, 1)]
      map = matmul(to, adjoint)
      if (from(1, 1)*from(2, 2) - from(1, 2)*from(2, 1) < 0.0_wp) map = -map
      c = map(1, 1) + map(2, 2)
      s = map(2, 1) - map(1, 2)
      length = hypot(c, s)
      rotation(:, 1) = [c, s]/length
      rotation(:, 2) = [-s, c]/length
   end function rotation_between

   !> Derivatives of what `find_motion` found. The rotation of the slip directions is taken as
   !> given.
   pure function find_variation(motion) result(variation)
      !> The motion
      type(motion_type), intent(in) :: motion
      type(variation_type) :: variation
      real(wp) :: hessian(2, 2), inverse(2, 2), share, normal(3), turn(3, 2), change(3), unit(3)
      real(wp) :: right(2), carried(3, 2)
      integer :: k, i, c, m

      m = motion%nodes
      associate (p => motion%point, t => motion%point%tangent, q => motion%point%curvature, &
            n => motion%axes(:, 1))
         hessian(1, 1) = dot_product(motion%gap, q(:, 1)) - dot_product(t(:, 1), t(:, 1))
         hessian(1, 2) = dot_product(motion%gap, q(:, 2)) - dot_product(t(:, 1), t(:, 2))
         hessian(2, 2) = dot_product(motion%gap, q(:, 3)) - dot_product(t(:, 2), t(:, 2))
         hessian(2, 1) = hessian(1, 2)
         inverse(1, :) = [hessian(2, 2), -hessian(1, 2)]
         inverse(2, :) = [-hessian(2, 1), hessian(1, 1)]
         inverse = inverse/(hessian(1, 1)*hessian(2, 2) - hessian(1, 2)*hessian(2, 1))
         turn(:, 1) = cross(q(:, 1), t(:, 2)) + cross(t(:, 1), q(:, 2))
         turn(:, 2) = cross(q(:, 2), t(:, 2)) + cross(t(:, 1), q(:, 3))
         ! what the projection moves over, of the face's own displacements
         carried = matmul(motion%node_increments(:, :m), p%dn(:m, :))
         do k = 1, m + 1
            share = 1.0_wp
            if (k <= m) share = -p%n(k)
            do i = 1, 3
               c = 3*(k - 1) + i
               unit = 0.0_wp
               unit(i) = 1.0_wp
               right = share*t(i, :)
               normal = 0.0_wp
               if (k <= m) then
                  right = right + motion%gap(i)*p%dn(k, :)
                  normal = p%dn(k, 1)*cross(unit, t(:, 2)) + p%dn(k, 2)*cross(t(:, 1), unit)
               end if
               variation%xi(:, c) = -matmul(inverse, right)
               normal = normal + matmul(turn, variation%xi(:, c))
               variation%axes(:, 1, c) = (normal - dot_product(n, normal)*n)/motion%size_of_normal
               call turn_axes(motion, variation%axes(:, :, c))
               change = share*unit - matmul(carried, variation%xi(:, c))
               ! the gap is along the normal
               variation%motion(1, c) = -share*n(i)
               variation%motion(2:, c) = matmul(change, motion%axes(:, 2:)) &
                  + matmul(motion%increment, variation%axes(:, 2:, c))
            end do
         end do
      end associate
   end function find_variation

   !> Derivatives of the slip directions from that of the normal.
   pure subroutine turn_axes(motion, axes)
      type(motion_type), intent(in) :: motion
      real(wp), intent(inout) :: axes(3, 3)
      real(wp) :: along, change(3)

      associate (n => motion%axes(:, 1), t1 => motion%axes(:, 2), e => motion%reference)
         along = dot_product(e, n)
         change = -along*axes(:, 1) - dot_product(e, axes(:, 1))*n
         change = change/norm2(e - along*n)
         axes(:, 2) = change - dot_product(t1, change)*t1
         axes(:, 3) = cross(axes(:, 1), t1) + cross(n, axes(:, 2))
      end associate
   end subroutine turn_axes

   pure function cross(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)

      c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function cross

end module calculix_kinematics
