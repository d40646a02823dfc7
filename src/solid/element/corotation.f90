!> Forces and tangent of an element from those in a frame that turns with it.
!>
!> R is the rotation of the mean deformation gradient F = sum x_a b_a' = R U, with b_a the mean
!> gradients of the shape functions: so a field that is linear passes in elements of any shape.
!> With dx in the frame, the frame spins by W dx, W_a = H^-1 skew(b_a), H = tr(U) I - U, and the
!> displacements d = R'x - X change by P dx, P = I - S W, S_a = -skew(R'x_a). Forces R P'f0 are then
!> conjugate to dx where f0 are conjugate to d, and balance in force and moment.
module asperity_solid_element_corotation
   use asperity_base_kinds, only: wp
   use asperity_solid_element_rotation, only: polar_rotation
   use asperity_solid_small_matrices, only: cross, invert, skew
   implicit none
   private
   public :: element_frame, new_frame, balance_forces, complete_tangent

   !> Where an element is, and how it is turned.
   type :: element_frame
      !> Rotation R, stretch U and H^-1
      real(wp) :: rotation(3, 3), stretch(3, 3), spin_of_moment(3, 3)
      !> Places R'x of the corners in the frame, from the first corner, mm
      real(wp) :: places(3, 8)
      !> Displacements d of the corners in the frame, from the first corner, mm
      real(wp) :: displacements(3, 8)
      !> The element is turned inside out or flat: nothing else is set
      logical :: inverted
   end type element_frame

contains

   !> The frame of an element.
   pure subroutine new_frame(frame, corners, mean_gradients, positions)
      !> Result
      type(element_frame), intent(out) :: frame
      !> Corners of the undeformed element, from the first, mm
      real(wp), intent(in) :: corners(3, 8)
      !> Mean gradients b of the corners' shape functions, 1/mm
      real(wp), intent(in) :: mean_gradients(3, 8)
      !> Where the corners are now, mm
      real(wp), intent(in) :: positions(3, 8)
      real(wp) :: gradient(3, 3), h(3, 3), trace, determinant
      integer :: a, i, j

      gradient = 0.0_wp
      do a = 2, 8
         do j = 1, 3
            gradient(:, j) = gradient(:, j) &
               + (positions(:, a) - positions(:, 1))*mean_gradients(j, a)
         end do
      end do
      call polar_rotation(gradient, frame%rotation, frame%inverted)
      if (frame%inverted) return
      do j = 1, 3
         do i = 1, 3
            frame%stretch(i, j) = dot_product(frame%rotation(:, i), gradient(:, j))
         end do
      end do
      do a = 1, 8
         do i = 1, 3
            frame%places(i, a) = dot_product(frame%rotation(:, i), &
               positions(:, a) - positions(:, 1))
         end do
      end do
      frame%displacements = frame%places - corners
      trace = frame%stretch(1, 1) + frame%stretch(2, 2) + frame%stretch(3, 3)
      h = -frame%stretch
      do i = 1, 3
         h(i, i) = h(i, i) + trace
      end do
      call invert(h, frame%spin_of_moment, determinant)
   end subroutine new_frame

   !> Forces P'f0 from the forces f0 of the stresses, all in the frame: W' takes their moment away.
   pure subroutine balance_forces(frame, mean_gradients, forces, balanced, turned)
      !> The frame
      type(element_frame), intent(in) :: frame
      !> Mean gradients, 1/mm
      real(wp), intent(in) :: mean_gradients(3, 8)
      !> Forces f0, N
      real(wp), intent(in) :: forces(3, 8)
      !> Forces P'f0, N
      real(wp), intent(out) :: balanced(3, 8)
      !> H^-1 times the moment of f0, N mm
      real(wp), intent(out) :: turned(3)
      real(wp) :: moment(3)
      integer :: a

      moment = 0.0_wp
      do a = 2, 8
         moment = moment + cross(frame%places(:, a), forces(:, a))
      end do
      turned = matmul(frame%spin_of_moment, moment)
      do a = 1, 8
         balanced(:, a) = forces(:, a) - cross(turned, mean_gradients(:, a))
      end do
   end subroutine balance_forces

   !> From the stiffness K of d in the frame to the derivative of the forces by the positions in
   !> global axes,
   !> R [P'K P - skew(fh_a) W + W'(Q + (Z - skew(U h)) W)] R', where fh = P'f0, h is `turned`,
   !> Q_a = h b_a' - (b_a.h) I + skew(f0_a), Z = sum y_a f0_a' - (f0_a.y_a) I. It is symmetric.
   pure subroutine complete_tangent(frame, mean_gradients, forces, balanced, turned, tangent)
      !> The frame
      type(element_frame), intent(in) :: frame
      !> Mean gradients b, 1/mm
      real(wp), intent(in) :: mean_gradients(3, 8)
      !> Forces f0 and P'f0, N, and `turned` from balance_forces, N mm
      real(wp), intent(in) :: forces(3, 8), balanced(3, 8), turned(3)
      !> K, symmetric, and then the result, N/mm
      real(wp), intent(inout) :: tangent(24, 24)
      ! columns of K S, W' and what W' is multiplied by
      real(wp) :: ks(24, 3), spin(24, 3), left(24, 3), right(24, 3)
      real(wp) :: z(3, 3), block(3, 3), arm(3), force(3)
      integer :: a, i, j, k

      ks = 0.0_wp
      do a = 2, 8
         i = 3*a - 2
         arm = frame%places(:, a)
         ks(:, 1) = ks(:, 1) + arm(2)*tangent(:, i + 2) - arm(3)*tangent(:, i + 1)
         ks(:, 2) = ks(:, 2) + arm(3)*tangent(:, i) - arm(1)*tangent(:, i + 2)
         ks(:, 3) = ks(:, 3) + arm(1)*tangent(:, i + 1) - arm(2)*tangent(:, i)
      end do
      ! S'K S + Z - skew(U h)
      z = -skew(matmul(frame%stretch, turned))
      do a = 2, 8
         i = 3*a - 2
         arm = frame%places(:, a)
         force = forces(:, a)
         do k = 1, 3
            z(:, k) = z(:, k) + cross(arm, ks(i:i + 2, k)) + arm*force(k)
            z(k, k) = z(k, k) - dot_product(arm, force)
         end do
      end do
      do a = 1, 8
         i = 3*a - 2
         block = -skew(balanced(:, a))
         do k = 1, 3
            spin(i:i + 2, k) = cross(frame%spin_of_moment(:, k), mean_gradients(:, a))
            left(i:i + 2, k) = block(:, k) - ks(i:i + 2, k)
         end do
         block = skew(forces(:, a))
         do k = 1, 3
            right(i:i + 2, k) = turned(k)*mean_gradients(:, a) + block(k, :) - ks(i:i + 2, k)
            right(i + k - 1, k) = right(i + k - 1, k) &
               - dot_product(turned, mean_gradients(:, a))
         end do
      end do
      do k = 1, 3
         right(:, k) = right(:, k) + z(k, 1)*spin(:, 1) + z(k, 2)*spin(:, 2) + z(k, 3)*spin(:, 3)
      end do
      do j = 1, 24
         tangent(:, j) = tangent(:, j) &
            + left(:, 1)*spin(j, 1) + left(:, 2)*spin(j, 2) + left(:, 3)*spin(j, 3) &
            + spin(:, 1)*right(j, 1) + spin(:, 2)*right(j, 2) + spin(:, 3)*right(j, 3)
      end do
      call turn(tangent, frame%rotation)
   end subroutine complete_tangent

   !> R K R', corner by corner.
   pure subroutine turn(matrix, r)
      real(wp), intent(inout) :: matrix(24, 24)
      real(wp), intent(in) :: r(3, 3)
      real(wp) :: columns(24, 3), row(3)
      integer :: a, b, i, j, k

      do b = 1, 8
         j = 3*b - 2
         do k = 1, 3
            columns(:, k) = r(k, 1)*matrix(:, j) + r(k, 2)*matrix(:, j + 1) &
               + r(k, 3)*matrix(:, j + 2)
         end do
         do k = 1, 3
            do a = 1, 8
               i = 3*a - 2
               row = columns(i:i + 2, k)
               matrix(i:i + 2, j + k - 1) = r(:, 1)*row(1) + r(:, 2)*row(2) + r(:, 3)*row(3)
            end do
         end do
      end do
   end subroutine turn

end module asperity_solid_element_corotation
