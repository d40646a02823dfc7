!> Divided differences of the logarithm against integrals, and principal stretches against
!> gradients that are made of them.
module test_solid_logarithm
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_solid_element_logarithm, only: first_differences, second_differences
   use asperity_solid_element_principal_stretches, only: find_principal_stretches
   use brick_states, only: random_rotation
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_logarithm

   integer(int64), parameter :: seed = 31622776_int64

contains

   function suite_logarithm() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('logarithm')
      call suite%addTest(TestMethod('differences against integrals', test_differences))
      call suite%addTest(TestMethod('far from each other', test_far))
      call suite%addTest(TestMethod('principal stretches', test_stretches))
   end function suite_logarithm

   !> The divided difference of ln at several points is the integral over t > 0 of the product of
   !> 1/(x + t), with a minus for three of them. With t = exp(u) the trapezoidal rule is exact to
   !> rounding.
   pure real(wp) function integral(x)
      real(wp), intent(in) :: x(:)
      real(wp), parameter :: step = 0.25_wp, reach = 45.0_wp
      real(wp) :: t, first
      integer :: i

      integral = 0.0_wp
      first = log(minval(x)) - reach
      do i = 0, nint((log(maxval(x)) + reach - first)/step)
         t = exp(first + i*step)
         integral = integral + step*t/product(x + t)
      end do
      if (size(x) == 3) integral = -integral
   end function integral

   !> Values that are equal, or apart by 1e-16 to 10 of them, in all orders.
   subroutine test_differences()
      type(random_stream) :: stream
      real(wp) :: values(3), apart, errors(2)
      integer :: exponent, k

      stream = random_stream(seed)
      errors = 0.0_wp
      do exponent = -17, 1
         apart = 10.0_wp**exponent
         ! on either side of the limit between series and difference as well
         if (exponent == -2) apart = 0.0099_wp
         do k = 1, 30
            values = 1.0_wp
            values(1 + mod(k, 3)) = 1.0_wp + 2.0_wp*apart
            if (k > 6) values(1 + mod(k + 1, 3)) = 1.0_wp + 2.0_wp*apart*stream%uniform(0.0_wp, &
               1.0_wp)
            if (k > 18) values = values*[1.0_wp, 1.0_wp + 0.05_wp*apart, 1.0_wp]
            values = values*stream%log_uniform(0.01_wp, 100.0_wp)
            call compare(values, errors)
         end do
      end do
      values = 2.5_wp
      call compare(values, errors)
      call record('solid.logarithm.first', errors(1))
      call record('solid.logarithm.second', errors(2))
      call assertLessThan(errors(1), 1.0e-14_wp)
      call assertLessThan(errors(2), 1.0e-13_wp)
   end subroutine test_differences

   !> Largest relative errors so far.
   subroutine compare(values, errors)
      real(wp), intent(in) :: values(3)
      real(wp), intent(inout) :: errors(2)
      real(wp) :: first(3, 3), second(3, 3, 3), expected
      integer :: i, j, k

      first = first_differences(values)
      second = second_differences(values, first)
      do k = 1, 3
         do j = 1, 3
            expected = integral(values([j, k]))
            errors(1) = max(errors(1), abs(first(j, k)/expected - 1.0_wp))
            do i = 1, 3
               expected = integral(values([i, j, k]))
               errors(2) = max(errors(2), abs(second(i, j, k)/expected - 1.0_wp))
            end do
         end do
      end do
   end subroutine compare

   !> Stretches of a thousandth beside a thousandfold, and what no element bears.
   subroutine test_far()
      real(wp) :: errors(2)

      errors = 0.0_wp
      call compare([1.0e-6_wp, 1.0e6_wp, 1.0_wp], errors)
      call compare([1.0e-18_wp, 1.0_wp, 1.0_wp], errors)
      call compare([1.0_wp, 1.0e-18_wp, 1.0e-18_wp], errors)
      call assertLessThan(errors(1), 1.0e-13_wp)
      call assertLessThan(errors(2), 1.0e-13_wp)
   end subroutine test_far

   !> F = R N' diag(stretches) N: lengths of the images are the stretches, each to its own rounding.
   subroutine test_stretches()
      type(random_stream) :: stream
      real(wp) :: f(3, 3), axes(3, 3), stretches(3), n(3, 3), images(3, 3), found(3), mixed(3, 3)
      integer :: i, k

      stream = random_stream(seed + 1)
      do k = 1, 300
         axes = random_rotation(stream)
         do i = 1, 3
            stretches(i) = stream%log_uniform(1.0e-3_wp, 1.0e3_wp)
         end do
         if (mod(k, 3) == 0) stretches(2:) = stretches(1)
         if (mod(k, 3) == 1) stretches = 1.0_wp + 1.0e-9_wp*stretches
         f = matmul(random_rotation(stream), spread(stretches, 2, 3)*axes)
         call find_principal_stretches(f, n, images)
         call assertEqual(0.0_wp, maxval(abs(matmul(f, n) - images)), &
            tolerance=1.0e-14_wp*maxval(stretches))
         mixed = matmul(transpose(n), n)
         do i = 1, 3
            mixed(i, i) = mixed(i, i) - 1.0_wp
            found(i) = norm2(images(:, i))
         end do
         call assertEqual(0.0_wp, maxval(abs(mixed)), tolerance=1.0e-14_wp)
         mixed = matmul(transpose(images), images)
         do i = 1, 3
            mixed(i, i) = 0.0_wp
            mixed(:, i) = mixed(:, i)/(found*found(i))
            call assertEqual(0.0_wp, minval(abs(found - stretches(i))), &
               tolerance=1.0e-14_wp*maxval(stretches))
         end do
         call assertEqual(0.0_wp, maxval(abs(mixed)), tolerance=1.0e-14_wp)
         call assertEqual(product(stretches), product(found), &
            tolerance=1.0e-9_wp*product(stretches))
         call assertGreaterThan(minval(found), 0.0_wp)
      end do
   end subroutine test_stretches

end module test_solid_logarithm
