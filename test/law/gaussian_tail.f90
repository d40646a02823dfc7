!> Moments of the Gaussian tail, F_n(y) = moments(n) exp(-max(y, 0)^2/2): against erfc, against the
!> integral F_1 = int F_0, F_2 = 2 int F_1, by reflection, against GSL, at the ends of the range.
module test_law_gaussian_tail
   use asperity_base_kinds, only: wp
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, assertRelativelyEqual, TestMethod, TestSuite
   use gsl_quadrature, only: gaussian_moment
   use measurements, only: record
   implicit none
   private
   public :: suite_gaussian_tail

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_gaussian_tail() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('gaussian tail')
      call suite%addTest(TestMethod('F_0 is half an erfc', test_erfc))
      call suite%addTest(TestMethod('F_1 and F_2 are integrals', test_integrals))
      call suite%addTest(TestMethod('reflection', test_reflection))
      call suite%addTest(TestMethod('GSL', test_gsl))
      call suite%addTest(TestMethod('values known', test_values))
      call suite%addTest(TestMethod('ends of the range', test_ends))
      call suite%addTest(TestMethod('Gauss-Legendre rule', test_rule))
   end function suite_gaussian_tail

   !> Multiplying by exp(-y^2/2) and rounding y/sqrt(2) err by y^2 eps.
   subroutine test_erfc()
      real(wp) :: y, moments(0:2)
      integer :: i

      do i = -400, 370
         y = 0.1_wp*i
         call find_tail_moments(y, moments)
         call assertRelativelyEqual(0.5_wp*erfc(sqrt(0.5_wp)*y), &
            moments(0)*exp(-0.5_wp*max(y, 0.0_wp)**2), (4.0_wp + y*y)*eps, 'F_0')
      end do
   end subroutine test_erfc

   !> For y >= 0, with F_n(y) = n int_y^inf F_(n-1), scaled, and 48 Gauss points to where the
   !> density is exp(-40) of that at y. A few units in the last place, as the inverse of the law
   !> needs it.
   subroutine test_integrals()
      real(wp) :: y, moments(0:2), inner(0:2), t, reach, factor, sums(2), worst
      integer :: i, j

      worst = 0.0_wp
      do i = 0, 2000
         y = 0.02_wp*i
         call find_tail_moments(y, moments)
         reach = 80.0_wp/(y + sqrt(y*y + 80.0_wp))
         sums = 0.0_wp
         do j = 1, n_points
            t = 0.5_wp*reach*(1.0_wp + nodes(j))
            call find_tail_moments(y + t, inner)
            factor = 0.5_wp*reach*weights(j)*exp(-t*(y + 0.5_wp*t))
            sums = sums + factor*[inner(0), 2.0_wp*inner(1)]
         end do
         call worsen(worst, largest_of(moments(1:)/sums - 1.0_wp))
      end do
      call record('gaussian_tail.relative_error', worst)
      call assertLessThan(worst, 5.0e-15_wp, 'F_1, F_2')
   end subroutine test_integrals

   !> F_0(-y) = 1 - F_0, F_1(-y) = y + F_1, F_2(-y) = 1 + y^2 - F_2.
   subroutine test_reflection()
      real(wp) :: y, above(0:2), below(0:2)
      integer :: i

      do i = 0, 400
         y = 0.1_wp*i
         call find_tail_moments(y, above)
         above = above*exp(-0.5_wp*y*y)
         call find_tail_moments(-y, below)
         call assertRelativelyEqual([1.0_wp - above(0), y + above(1), 1.0_wp + y*y - above(2)], &
            below, 8.0_wp*eps, 'F_n(-y)')
      end do
   end subroutine test_reflection

   !> GSL's U is good to 3e-13.
   subroutine test_gsl()
      real(wp) :: y, moments(0:2)
      integer :: i

      do i = -30, 60
         y = 0.1_wp*i
         call find_tail_moments(y, moments)
         call assertRelativelyEqual([gaussian_moment(0.0_wp, y), gaussian_moment(1.0_wp, y), &
            gaussian_moment(2.0_wp, y)], moments*exp(-0.5_wp*max(y, 0.0_wp)**2), &
            1.0e-12_wp, 'F_n')
      end do
   end subroutine test_gsl

   !> F_0(0) = 1/2, F_1(0) = 1/sqrt(2 pi), F_2(0) = 1/2, and F_1(2) to eight figures.
   subroutine test_values()
      real(wp) :: moments(0:2)

      call find_tail_moments(0.0_wp, moments)
      call assertRelativelyEqual([0.5_wp, 1.0_wp/sqrt(8.0_wp*atan(1.0_wp)), 0.5_wp], moments, &
         2.0_wp*eps)
      call find_tail_moments(2.0_wp, moments)
      call assertEqual(0.0084907026_wp, moments(1)*exp(-2.0_wp), 0.5e-10_wp)
   end subroutine test_values

   !> Far out F_n -> n! phi/y^(n+1); far below they are 1, |y|, y^2. No overflow in between.
   subroutine test_ends()
      real(wp), parameter :: y(3) = [1.0e10_wp, 1.0e50_wp, 1.0e100_wp]
      real(wp) :: moments(0:2)
      integer :: i

      do i = 1, size(y)
         call find_tail_moments(y(i), moments)
         call assertRelativelyEqual([1.0_wp/y(i), 1.0_wp/y(i)**2, 2.0_wp/y(i)**3] &
            /sqrt(8.0_wp*atan(1.0_wp)), moments, 4.0_wp*eps, 'far out')
         call find_tail_moments(-y(i), moments)
         call assertRelativelyEqual([1.0_wp, y(i), y(i)**2], moments, 4.0_wp*eps, 'far below')
      end do
   end subroutine test_ends

   !> Exact for x^(2n), 2n < 96: the integral over -1..1 is 2/(2n + 1). Odd powers cancel.
   subroutine test_rule()
      integer :: n

      do n = 0, 47
         call assertRelativelyEqual(2.0_wp/(2.0_wp*n + 1.0_wp), sum(weights*nodes**(2*n)), &
            2.0e-14_wp, 'even power')
         call assertEqual(0.0_wp, sum(weights*nodes**(2*n + 1)), 1.0e-15_wp, 'odd power')
      end do
   end subroutine test_rule

end module test_law_gaussian_tail
