!> Eigenvalues of symmetric matrices of three, once a material: no library is linked for them.
module asperity_solid_material_eigenvectors
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: find_eigenvectors

   !> Rounds of rotations; after five nothing is left to clear
   integer, parameter :: n_sweeps = 10

contains

   !> Eigenvalues and orthonormal eigenvectors, by Jacobi's rotations, each of which clears an
   !> element beside the diagonal (Golub, Van Loan, Matrix Computations, section 8.5).
   pure subroutine find_eigenvectors(matrix, values, vectors)
      !> Symmetric matrix
      real(wp), intent(in) :: matrix(3, 3)
      !> Its eigenvalues, in no order
      real(wp), intent(out) :: values(3)
      !> Their eigenvectors, in columns
      real(wp), intent(out) :: vectors(3, 3)
      real(wp) :: a(3, 3), rotation(2, 2), ratio, tangent, cosine
      integer :: sweep, p, q

      a = matrix
      vectors = 0.0_wp
      do p = 1, 3
         vectors(p, p) = 1.0_wp
      end do
      do sweep = 1, n_sweeps
         do p = 1, 2
            do q = p + 1, 3
               ! cleared, or too small to be seen
               if (abs(a(p, q)) <= epsilon(1.0_wp)**2*maxval(abs(a))) cycle
               ratio = (a(q, q) - a(p, p))/(2.0_wp*a(p, q))
               tangent = sign(1.0_wp, ratio)/(abs(ratio) + sqrt(1.0_wp + ratio**2))
               cosine = 1.0_wp/sqrt(1.0_wp + tangent**2)
               rotation = reshape(cosine*[1.0_wp, -tangent, tangent, 1.0_wp], [2, 2])
               a(:, [p, q]) = matmul(a(:, [p, q]), rotation)
               a([p, q], :) = matmul(transpose(rotation), a([p, q], :))
               a(p, q) = 0.0_wp
               a(q, p) = 0.0_wp
               vectors(:, [p, q]) = matmul(vectors(:, [p, q]), rotation)
            end do
         end do
      end do
      do p = 1, 3
         values(p) = a(p, p)
      end do
   end subroutine find_eigenvectors

end module asperity_solid_material_eigenvectors
