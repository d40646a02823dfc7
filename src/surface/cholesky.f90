!> Small symmetric positive definite systems by Cholesky's method: the normal equations of a form
!> have at most 45 unknowns. LAPACK would do, but a library of threads that every command of the
!> program then loads at its start is too much for so few.
module asperity_surface_cholesky
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: factorize, solve, reciprocal_condition

contains

   !> Replace the lower half of a matrix A by L of A = L L^T.
   pure subroutine factorize(matrix, is_definite)
      !> A, of which only the lower half is read; L on return
      real(wp), intent(inout) :: matrix(:, :)
      !> Whether A is positive definite; L is incomplete otherwise
      logical, intent(out) :: is_definite
      real(wp) :: square
      integer :: i, j

      is_definite = .true.
      do j = 1, size(matrix, 2)
         square = matrix(j, j) - dot_product(matrix(j, :j - 1), matrix(j, :j - 1))
         is_definite = square > 0.0_wp
         if (.not. is_definite) return
         matrix(j, j) = sqrt(square)
         do i = j + 1, size(matrix, 1)
            matrix(i, j) = (matrix(i, j) - dot_product(matrix(i, :j - 1), matrix(j, :j - 1))) &
               /matrix(j, j)
         end do
      end do
   end subroutine factorize

   !> Solve A x = b.
   pure subroutine solve(factor, right)
      !> L of `factorize`
      real(wp), intent(in) :: factor(:, :)
      !> b; x on return
      real(wp), intent(inout) :: right(:)
      integer :: i

      do i = 1, size(right)
         right(i) = (right(i) - dot_product(factor(i, :i - 1), right(:i - 1)))/factor(i, i)
      end do
      do i = size(right), 1, -1
         right(i) = (right(i) - dot_product(factor(i + 1:, i), right(i + 1:)))/factor(i, i)
      end do
   end subroutine solve

   !> 1/(|A| |A^-1|) in the norm of column sums, from all columns of A^-1.
   pure real(wp) function reciprocal_condition(factor, norm) result(condition)
      !> L of `factorize`
      real(wp), intent(in) :: factor(:, :)
      !> |A|, the largest sum of the absolute values of a column
      real(wp), intent(in) :: norm
      real(wp) :: column(size(factor, 1)), norm_of_inverse
      integer :: i

      norm_of_inverse = 0.0_wp
      do i = 1, size(column)
         column = 0.0_wp
         column(i) = 1.0_wp
         call solve(factor, column)
         norm_of_inverse = max(norm_of_inverse, sum(abs(column)))
      end do
      condition = 1.0_wp/(norm*norm_of_inverse)
   end function reciprocal_condition

end module asperity_surface_cholesky
