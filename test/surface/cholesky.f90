!> Cholesky's method on Hilbert's matrices 1/(i + j - 1), whose condition numbers are known.
module test_surface_cholesky
   use asperity_base_kinds, only: wp
   use asperity_surface_cholesky, only: factorize, reciprocal_condition, solve
   use funit, only: assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_surface_cholesky

   !> Condition numbers of Hilbert's matrices of order 2 to 6 in the norm of column sums (Todd 1954)
   real(wp), parameter :: conditions(2:6) = &
      [27.0_wp, 748.0_wp, 28375.0_wp, 943656.0_wp, 29070279.0_wp]

contains

   function suite_surface_cholesky() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_cholesky')
      call suite%addTest(TestMethod('condition numbers and solutions of Hilbert''s matrices', &
         test_hilbert))
      call suite%addTest(TestMethod('what is not positive definite is refused', test_refused))
   end function suite_surface_cholesky

   !> x = 1, 2, ... comes back from its right-hand side, to the condition number in roundings.
   subroutine test_hilbert()
      real(wp), allocatable :: matrix(:, :), x(:), right(:)
      real(wp) :: norm
      logical :: is_definite
      integer :: n, i, j

      do n = lbound(conditions, 1), ubound(conditions, 1)
         allocate (matrix(n, n), x(n), right(n))
         matrix(:, :) = reshape([((1.0_wp/real(i + j - 1, wp), i=1, n), j=1, n)], [n, n])
         x(:) = [(real(i, wp), i=1, n)]
         right(:) = matmul(matrix, x)
         norm = maxval(sum(abs(matrix), 1))
         do j = 2, n
            matrix(:j - 1, j) = huge(1.0_wp)
         end do
         call factorize(matrix, is_definite)
         call assertTrue(is_definite)
         associate (roundings => epsilon(1.0_wp)*conditions(n))
            call assertLessThan(abs(reciprocal_condition(matrix, norm)*conditions(n) - 1.0_wp), &
               10.0_wp*roundings, 'condition')
            call solve(matrix, right)
            call assertTrue(all(abs(right - x) < 10.0_wp*n*roundings), 'solution')
         end associate
         deallocate (matrix, x, right)
      end do
   end subroutine test_hilbert

   subroutine test_refused()
      real(wp) :: matrix(2, 2)
      logical :: is_definite

      matrix = reshape([1.0_wp, 2.0_wp, 2.0_wp, 4.0_wp], [2, 2])
      call factorize(matrix, is_definite)
      call assertFalse(is_definite, 'singular')
      matrix = reshape([1.0_wp, 2.0_wp, 2.0_wp, 3.0_wp], [2, 2])
      call factorize(matrix, is_definite)
      call assertFalse(is_definite, 'indefinite')
   end subroutine test_refused

end module test_surface_cholesky
