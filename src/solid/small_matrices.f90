!> Vectors and matrices of three, as elements and contact need them.
module asperity_solid_small_matrices
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: cross, skew, invert

contains

   !> Vector product.
   pure function cross(a, b) result(c)
      !> Factors
      real(wp), intent(in) :: a(3), b(3)
      real(wp) :: c(3)

      c(1) = a(2)*b(3) - a(3)*b(2)
      c(2) = a(3)*b(1) - a(1)*b(3)
      c(3) = a(1)*b(2) - a(2)*b(1)
   end function cross

   !> The matrix whose product with a vector is the vector product: skew(v) w = v x w.
   pure function skew(v) result(matrix)
      !> First factor
      real(wp), intent(in) :: v(3)
      real(wp) :: matrix(3, 3)

      matrix(:, 1) = [0.0_wp, v(3), -v(2)]
      matrix(:, 2) = [-v(3), 0.0_wp, v(1)]
      matrix(:, 3) = [v(2), -v(1), 0.0_wp]
   end function skew

   !> Inverse and determinant. The inverse of a singular matrix is not set.
   pure subroutine invert(matrix, inverse, determinant)
      !> The matrix
      real(wp), intent(in) :: matrix(3, 3)
      !> Its inverse
      real(wp), intent(out) :: inverse(3, 3)
      !> Its determinant, zero when there is no inverse
      real(wp), intent(out) :: determinant

      inverse(1, :) = cross(matrix(:, 2), matrix(:, 3))
      inverse(2, :) = cross(matrix(:, 3), matrix(:, 1))
      inverse(3, :) = cross(matrix(:, 1), matrix(:, 2))
      determinant = dot_product(inverse(1, :), matrix(:, 1))
      if (abs(determinant) > 0.0_wp) inverse = inverse/determinant
   end subroutine invert

end module asperity_solid_small_matrices
