!> How a slave node lies and moves over a master face: overclosure, slip and local axes, with their
!> derivatives by the positions of all nodes. Node order: those of the face, then the slave node.
module asperity_calculix_kinematics
   use asperity_base_kinds, only: wp
   use asperity_calculix_faces, only: face_point, most_nodes, point_of_face, project_onto_face
   implicit none
   private
   public :: frame_type, motion_type, variation_type, find_motion, find_variation, frame_at

   !> Most degrees of freedom of a spring
   integer, parameter, public :: most_freedoms = 3*(most_nodes + 1)

   !> A point of a face with its normal and slip directions.
   type :: frame_type
      !> The point
      type(face_point) :: point
      !> Normal out of the master, then the two slip directions (columns)
      real(wp) :: axes(3, 3) = 0.0_wp
      !> Length of the product of the two tangents that the normal is made from
      real(wp) :: size_of_normal = 0.0_wp
      !> Global direction that the first slip direction is the projection of
      real(wp) :: reference(3) = 0.0_wp
   end type frame_type

   !> One slave node over its face in an increment.
   type :: motion_type
      !> Number of nodes of the face
      integer :: nodes = 0
      !> The slave node's projection at the end, and the same point of the face at the start
      type(frame_type) :: frame, start
      !> From those to the slave node
      real(wp) :: gap(3) = 0.0_wp, start_gap(3) = 0.0_wp
      !> Overclosure at the end and at the start, positive for penetration
      real(wp) :: overclosure = 0.0_wp, start_overclosure = 0.0_wp
      !> Motion in the two slip directions
      real(wp) :: slip(2) = 0.0_wp
      !> Rotation of the face about its normal, seen in the slip directions
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

   !> Where the slave node is, and how it moved. The slip is what lay between the slave node and its
   !> projection at the start of the increment, turned with the face, so that neither a rotation of
   !> both nor a strain of what slipped before is slip.
   pure function find_motion(positions, start_positions) result(motion)
      !> Positions at the end (3, node), and at the start of the increment
      real(wp), intent(in) :: positions(:, :), start_positions(:, :)
      type(motion_type) :: motion
      type(frame_type) :: before
      integer :: m, s

      s = size(positions, 2)
      m = s - 1
      motion%nodes = m
      motion%frame = frame_at(project_onto_face(positions(:, :m), positions(:, s)))
      associate (point => motion%frame%point, axes => motion%frame%axes, start => motion%start)
         motion%gap = positions(:, s) - point%position
         motion%overclosure = -dot_product(motion%gap, axes(:, 1))
         start = frame_at(point_of_face(start_positions(:, :m), point%xi))
         motion%start_gap = start_positions(:, s) - start%point%position
         motion%rotation = rotation_between(tangents_in_axes(start), tangents_in_axes(motion%frame))
         motion%slip = -matmul(motion%rotation, matmul(motion%start_gap, start%axes(:, 2:)))
         before = frame_at(project_onto_face(start_positions(:, :m), start_positions(:, s), &
            point%xi))
      end associate
      motion%start_overclosure = -dot_product(start_positions(:, s) - before%point%position, &
         before%axes(:, 1))
   end function find_motion

   !> Normal and slip directions: the first is global x projected on the face, or z where x lies
   !> within 0.1 degrees of the normal, as in ABAQUS.
   pure function frame_at(point) result(frame)
      !> Point of the face
      type(face_point), intent(in) :: point
      type(frame_type) :: frame
      real(wp), parameter :: cosine = 1.0_wp - 1.5231e-6_wp

      frame%point = point
      associate (axes => frame%axes, reference => frame%reference)
         axes(:, 1) = cross(point%tangent(:, 1), point%tangent(:, 2))
         frame%size_of_normal = norm2(axes(:, 1))
         axes(:, 1) = axes(:, 1)/frame%size_of_normal
         reference = [1.0_wp, 0.0_wp, 0.0_wp]
         if (abs(axes(1, 1)) > cosine) reference = [0.0_wp, 0.0_wp, 1.0_wp]
         axes(:, 2) = reference - dot_product(reference, axes(:, 1))*axes(:, 1)
         axes(:, 2) = axes(:, 2)/norm2(axes(:, 2))
         axes(:, 3) = cross(axes(:, 1), axes(:, 2))
      end associate
   end function frame_at

   !> Tangents of the natural coordinates (columns) in the slip directions.
   pure function tangents_in_axes(frame) result(tangents)
      !> The frame
      type(frame_type), intent(in) :: frame
      real(wp) :: tangents(2, 2)

      tangents = matmul(transpose(frame%axes(:, 2:)), frame%point%tangent)
   end function tangents_in_axes

   !> Rotation part (polar decomposition) of the map from one pair of tangents to another, each in
   !> its own slip directions.
   pure function rotation_between(from, to) result(rotation)
      !> Tangents at the start and at the end, as columns
      real(wp), intent(in) :: from(2, 2), to(2, 2)
      real(wp) :: rotation(2, 2), turn(2)

      turn = cosine_and_sine(from, to)
      turn = turn/norm2(turn)
      rotation(:, 1) = turn
      rotation(:, 2) = [-turn(2), turn(1)]
   end function rotation_between

   !> Cosine and sine of that rotation, with a factor in common. Linear in either of the tangents.
   pure function cosine_and_sine(from, to) result(turn)
      real(wp), intent(in) :: from(2, 2), to(2, 2)
      real(wp) :: turn(2)
      real(wp) :: adjoint(2, 2), map(2, 2)

      ! the determinant is positive: the slip directions go round as the tangents do
      adjoint(:, 1) = [from(2, 2), -from(2, 1)]
      adjoint(:, 2) = [-from(1, 2), from(1, 1)]
      map = matmul(to, adjoint)
      turn = [map(1, 1) + map(2, 2), map(2, 1) - map(1, 2)]
   end function cosine_and_sine

   !> Derivatives of what `find_motion` found.
   pure function find_variation(motion) result(variation)
      !> The motion
      type(motion_type), intent(in) :: motion
      type(variation_type) :: variation
      real(wp) :: inverse(2, 2), share, unit(3), right(2), tangents(3, 2), start_tangents(3, 2)
      real(wp) :: start_axes(3, 3)
      integer :: k, i, c, m

      m = motion%nodes
      inverse = inverse_of_projection(motion)
      associate (p => motion%frame%point, axes => motion%frame%axes)
         do k = 1, m + 1
            share = 1.0_wp
            if (k <= m) share = -p%n(k)
            do i = 1, 3
               c = 3*(k - 1) + i
               unit = 0.0_wp
               unit(i) = 1.0_wp
               right = share*p%tangent(i, :)
               if (k <= m) right = right + motion%gap(i)*p%dn(k, :)
               associate (xi => variation%xi(:, c))
                  xi = -matmul(inverse, right)
                  tangents = tangents_along(p, xi)
                  if (k <= m) tangents(i, :) = tangents(i, :) + p%dn(k, :)
                  variation%axes(:, :, c) = change_of_axes(motion%frame, tangents)
                  start_tangents = tangents_along(motion%start%point, xi)
                  start_axes = change_of_axes(motion%start, start_tangents)
                  ! the gap is along the normal
                  variation%motion(1, c) = -share*axes(i, 1)
                  variation%motion(2:, c) = change_of_slip(motion, xi, variation%axes(:, :, c), &
                     tangents, start_axes, start_tangents)
               end associate
            end do
         end do
      end associate
   end function find_variation

   !> Inverse of the derivatives of (gap . tangent) by the natural coordinates.
   pure function inverse_of_projection(motion) result(inverse)
      type(motion_type), intent(in) :: motion
      real(wp) :: inverse(2, 2), h(3)

      associate (t => motion%frame%point%tangent, q => motion%frame%point%curvature)
         h = matmul(motion%gap, q) - [dot_product(t(:, 1), t(:, 1)), &
            dot_product(t(:, 1), t(:, 2)), dot_product(t(:, 2), t(:, 2))]
      end associate
      inverse(1, :) = [h(3), -h(2)]
      inverse(2, :) = [-h(2), h(1)]
      inverse = inverse/(h(1)*h(3) - h(2)**2)
   end function inverse_of_projection

   !> Change of the tangents when the point moves over its face.
   pure function tangents_along(point, xi) result(change)
      type(face_point), intent(in) :: point
      real(wp), intent(in) :: xi(2)
      real(wp) :: change(3, 2)

      change(:, 1) = matmul(point%curvature(:, 1:2), xi)
      change(:, 2) = matmul(point%curvature(:, 2:3), xi)
   end function tangents_along

   !> Change of normal and slip directions with that of the tangents.
   pure function change_of_axes(frame, tangents) result(change)
      type(frame_type), intent(in) :: frame
      real(wp), intent(in) :: tangents(3, 2)
      real(wp) :: change(3, 3)
      real(wp) :: along, normal(3), direction(3)

      associate (n => frame%axes(:, 1), t1 => frame%axes(:, 2), e => frame%reference, &
            t => frame%point%tangent)
         normal = cross(tangents(:, 1), t(:, 2)) + cross(t(:, 1), tangents(:, 2))
         normal = (normal - dot_product(n, normal)*n)/frame%size_of_normal
         along = dot_product(e, n)
         direction = -along*normal - dot_product(e, normal)*n
         direction = direction/norm2(e - along*n)
         change(:, 1) = normal
         change(:, 2) = direction - dot_product(t1, direction)*t1
         change(:, 3) = cross(normal, t1) + cross(n, change(:, 2))
      end associate
   end function change_of_axes

   !> Change of the slip with that of everything it is made from.
   pure function change_of_slip(motion, xi, axes, tangents, start_axes, start_tangents) &
         result(change)
      type(motion_type), intent(in) :: motion
      real(wp), intent(in) :: xi(2), axes(3, 3), tangents(3, 2), start_axes(3, 3)
      real(wp), intent(in) :: start_tangents(3, 2)
      real(wp) :: change(2), from(2, 2), to(2, 2), turn(2), turning(2), angle, local(2)

      associate (frame => motion%frame, start => motion%start)
         from = tangents_in_axes(start)
         to = tangents_in_axes(frame)
         turn = cosine_and_sine(from, to)
         turning = cosine_and_sine(from, matmul(transpose(axes(:, 2:)), frame%point%tangent) &
            + matmul(transpose(frame%axes(:, 2:)), tangents)) &
            + cosine_and_sine(matmul(transpose(start_axes(:, 2:)), start%point%tangent) &
            + matmul(transpose(start%axes(:, 2:)), start_tangents), to)
         angle = (turn(1)*turning(2) - turn(2)*turning(1))/dot_product(turn, turn)
         local = matmul(motion%start_gap, start_axes(:, 2:)) - matmul(from, xi)
      end associate
      change = angle*[-motion%slip(2), motion%slip(1)] - matmul(motion%rotation, local)
   end function change_of_slip

   pure function cross(a, b) result(c)
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)

      c = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function cross

end module asperity_calculix_kinematics
