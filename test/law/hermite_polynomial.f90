!> The polynomial of degree seven from values and slopes at four points: it gives back every
!> polynomial of that degree, and the values and slopes of any function.
module test_law_hermite_polynomial
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_law_hermite_polynomial, only: degree, hermite_points, hermite_polynomial
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hermite_polynomial

   integer(int64), parameter :: seed = 31415926_int64
   real(wp), parameter :: eps = epsilon(1.0_wp)
   !> Half widths far beyond any use: their seventh power is still a normal number
   real(wp), parameter :: narrow = 1.0e-30_wp, broad = 1.0e30_wp

contains

   function suite_hermite_polynomial() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hermite polynomial')
      call suite%addTest(TestMethod('the four points', test_points))
      call suite%addTest(TestMethod('gives back each power', test_powers))
      call suite%addTest(TestMethod('gives back any polynomial', test_polynomials))
      call suite%addTest(TestMethod('has the given values and slopes', test_values))
      call suite%addTest(TestMethod('remainder for exp', test_remainder))
   end function suite_hermite_polynomial

   !> Ends, and roots of the derivative of Legendre's polynomial of degree three.
   subroutine test_points()
      call assertEqual([-1.0_wp, 1.0_wp], hermite_points([1, 4]), 0.0_wp, 'ends')
      call assertEqual(0.2_wp, hermite_points(2:3)**2, eps, '1/5')
      call assertEqual(-hermite_points(4:1:-1), hermite_points, 0.0_wp, 'symmetric')
      call assertTrue(all(hermite_points(:3) < hermite_points(2:)), 'ascending')
   end subroutine test_points

   !> (t/half width)^k for k = 0 to 7. The four factors of 1/width, 1.25 each, and their sums
   !> enlarge round-off to some ten times eps.
   subroutine test_powers()
      real(wp), parameter :: half_widths(5) = [narrow, 1.0_wp/48, 0.5_wp, 3.0_wp, broad]
      real(wp) :: wanted(0:degree), found(0:degree)
      integer :: i, k

      do i = 1, size(half_widths)
         do k = 0, degree
            wanted = 0.0_wp
            wanted(k) = 1.0_wp
            found = back(wanted, half_widths(i))
            call assertEqual(wanted, found, 30.0_wp*eps, 'power')
         end do
      end do
   end subroutine test_powers

   !> Random coefficients and half widths. The rounding of values and slopes, some ten eps of the
   !> largest coefficient for sums of eight terms, is enlarged as above.
   subroutine test_polynomials()
      real(wp), parameter :: allowed = 200.0_wp*eps
      type(random_stream) :: stream
      real(wp) :: wanted(0:degree), found(0:degree), worst
      integer :: i, k

      stream = random_stream(seed)
      worst = 0.0_wp
      do i = 1, 20000
         do k = 0, degree
            wanted(k) = stream%uniform(-1.0_wp, 1.0_wp)
         end do
         found = back(wanted, stream%log_uniform(narrow, broad))
         call worsen(worst, largest_of(found - wanted)/largest_of(wanted))
      end do
      call record('hermite_polynomial.coefficient_error', worst)
      write (*, '(5x, a, i0)') 'seed ', seed
      call assertLessThan(worst, allowed, 'over the largest coefficient')
   end subroutine test_polynomials

   !> Random values and slopes, which no polynomial of lower degree fits: both at all four points.
   !> The coefficients reach some 20, the terms of a slope at an end 7 times that, each of which
   !> brings a few eps of its own.
   subroutine test_values()
      real(wp), parameter :: allowed = 1000.0_wp*eps
      type(random_stream) :: stream
      real(wp) :: values(4), slopes(4), c(0:degree), half_width, worst(2), t
      integer :: i, k

      stream = random_stream(seed + 1)
      worst = 0.0_wp
      do i = 1, 20000
         half_width = stream%log_uniform(narrow, broad)
         do k = 1, 4
            values(k) = stream%uniform(-1.0_wp, 1.0_wp)
            slopes(k) = stream%uniform(-1.0_wp, 1.0_wp)/half_width
         end do
         c = hermite_polynomial(values, slopes, half_width)
         do k = 1, 4
            t = half_width*hermite_points(k)
            call worsen(worst(1), abs(value_of(c, t) - values(k)))
            call worsen(worst(2), half_width*abs(slope_of(c, t) - slopes(k)))
         end do
      end do
      call record('hermite_polynomial.value_error', worst(1))
      call record('hermite_polynomial.slope_error', worst(2))
      call assertLessThan(worst(1), allowed, 'values')
      call assertLessThan(worst(2), allowed, 'slopes')
   end subroutine test_values

   !> The remainder in the middle of the interval: half_width^8/25 times the divided difference
   !> over the four points, each twice, and the middle, which for exp(t) is
   !> 1/8! + 2.4 half_width^2/10! + ..., the rest being 2e-5 of it.
   subroutine test_remainder()
      real(wp), parameter :: half_width = 0.5_wp
      real(wp), parameter :: remainder = 0.04_wp*half_width**8/40320.0_wp &
         *(1.0_wp + 2.4_wp*half_width**2/90.0_wp)
      real(wp) :: x(4), c(0:degree)

      x = half_width*hermite_points
      c = hermite_polynomial(exp(x), exp(x), half_width)
      call assertRelativelyEqual(remainder, 1.0_wp - c(0), 1.0e-4_wp, 'remainder')
   end subroutine test_remainder

   !> Coefficients in t/half_width of what values and slopes of a polynomial give back.
   function back(coefficients, half_width) result(found)
      real(wp), intent(in) :: coefficients(0:degree), half_width
      real(wp) :: found(0:degree), values(4), slopes(4)
      integer :: i

      do i = 1, 4
         values(i) = value_of(coefficients, hermite_points(i))
         slopes(i) = slope_of(coefficients, hermite_points(i))/half_width
      end do
      found = hermite_polynomial(values, slopes, half_width)
      do i = 1, degree
         found(i) = found(i)*half_width**i
      end do
   end function back

   !> Sum of c(i) t^i, term by term.
   pure real(wp) function value_of(c, t)
      real(wp), intent(in) :: c(0:degree), t
      integer :: i

      value_of = c(0)
      do i = 1, degree
         value_of = value_of + c(i)*t**i
      end do
   end function value_of

   !> Its derivative, term by term.
   pure real(wp) function slope_of(c, t)
      real(wp), intent(in) :: c(0:degree), t
      integer :: i

      slope_of = c(1)
      do i = 2, degree
         slope_of = slope_of + i*c(i)*t**(i - 1)
      end do
   end function slope_of

end module test_law_hermite_polynomial
