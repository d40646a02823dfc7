!> Vectors and matrices of three, against their definitions.
module test_solid_small_matrices
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_solid_small_matrices, only: cross, invert, skew
   use funit, only: assertEqual, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_small_matrices

   integer(int64), parameter :: seed = 17320508_int64

contains

   function suite_small_matrices() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('small matrices')
      call suite%addTest(TestMethod('vector product and its matrix', test_cross))
      call suite%addTest(TestMethod('inverse and determinant', test_invert))
   end function suite_small_matrices

   subroutine test_cross()
      real(wp), parameter :: a(3) = [1.0_wp, -2.0_wp, 0.5_wp], b(3) = [3.0_wp, 4.0_wp, -1.0_wp]

      call assertEqual([0.0_wp, 2.5_wp, 10.0_wp], cross(a, b))
      call assertEqual(cross(a, b), matmul(skew(a), b))
   end subroutine test_cross

   subroutine test_invert()
      type(random_stream) :: stream
      real(wp) :: m(3, 3), inverse(3, 3), determinant, product(3, 3)
      integer :: i, j, k

      stream = random_stream(seed)
      do k = 1, 20
         do j = 1, 3
            do i = 1, 3
               m(i, j) = stream%uniform(-1.0_wp, 1.0_wp)
            end do
            m(j, j) = m(j, j) + 3.0_wp
         end do
         call invert(m, inverse, determinant)
         product = matmul(m, inverse)
         do i = 1, 3
            product(i, i) = product(i, i) - 1.0_wp
         end do
         call assertEqual(0.0_wp, maxval(abs(product)), tolerance=1.0e-14_wp)
         call assertEqual(dot_product(m(:, 1), cross(m(:, 2), m(:, 3))), determinant, &
            tolerance=1.0e-13_wp)
      end do
      m(:, 3) = m(:, 2)
      call invert(m, inverse, determinant)
      call assertEqual(0.0_wp, determinant, tolerance=1.0e-14_wp)
   end subroutine test_invert

end module test_solid_small_matrices
