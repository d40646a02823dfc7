!> Finite numbers, infinities and what is not a number, by their bits.
module test_base_finite
   use, intrinsic :: ieee_arithmetic, only: ieee_negative_inf, ieee_positive_inf, ieee_quiet_nan, &
      ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_finite, only: all_finite, is_finite, is_nan
   use asperity_base_kinds, only: wp
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_finite

contains

   function suite_finite() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('finite')
      call suite%addTest(TestMethod('finite numbers', test_numbers))
      call suite%addTest(TestMethod('infinities', test_infinities))
      call suite%addTest(TestMethod('not a number', test_nan))
      call suite%addTest(TestMethod('every exponent', test_exponents))
      call suite%addTest(TestMethod('arrays', test_arrays))
      call suite%addTest(TestMethod('no NaN hides in the largest error of a test', test_extremes))
   end function suite_finite

   subroutine test_numbers()
      real(wp) :: x(10)

      x = [0.0_wp, -0.0_wp, 1.0_wp, -1.5_wp, huge(1.0_wp), -huge(1.0_wp), tiny(1.0_wp), &
         -tiny(1.0_wp), smallest(), -smallest()]
      call assertTrue(all(is_finite(x)), 'finite')
      call assertFalse(any(is_nan(x)), 'numbers')
   end subroutine test_numbers

   subroutine test_infinities()
      real(wp) :: x(2)

      x = [ieee_value(1.0_wp, ieee_positive_inf), ieee_value(1.0_wp, ieee_negative_inf)]
      call assertFalse(any(is_finite(x)), 'not finite')
      call assertFalse(any(is_nan(x)), 'but not NaN')
   end subroutine test_infinities

   !> The quiet one, and others by their bits: a payload in the highest bits or in the lowest alone,
   !> of both signs.
   subroutine test_nan()
      integer(int64), parameter :: bits(4) = [int(z'7FF8000000000000', int64), &
         int(z'7FFFFFFFFFFFFFFF', int64), int(z'7FF8000000000001', int64), &
         int(z'7FF8000080000000', int64)]
      real(wp) :: x
      integer :: i

      x = ieee_value(1.0_wp, ieee_quiet_nan)
      call assertFalse(is_finite(x), 'quiet')
      call assertTrue(is_nan(x), 'quiet')
      do i = 1, size(bits)
         call assertTrue(is_nan(transfer(bits(i), 1.0_wp)), 'positive')
         call assertTrue(is_nan(transfer(ibset(bits(i), 63), 1.0_wp)), 'negative')
         call assertFalse(is_finite(transfer(bits(i), 1.0_wp)), 'positive')
         call assertFalse(is_finite(transfer(ibset(bits(i), 63), 1.0_wp)), 'negative')
      end do
   end subroutine test_nan

   !> One number of each of the 2048 exponents, with an even and an odd fraction: only the last
   !> exponent is not finite.
   subroutine test_exponents()
      integer(int64) :: bits
      integer :: exponent, finite, numbers

      finite = 0
      numbers = 0
      do exponent = 0, 2047
         bits = ior(ishft(int(exponent, int64), 52), int(z'000A5A5A5A5A5A5B', int64))
         if (is_finite(transfer(bits, 1.0_wp))) finite = finite + 1
         if (.not. is_nan(transfer(bits, 1.0_wp))) numbers = numbers + 1
         if (exponent == 2046) call assertEqual(2047, finite, 'all but the last')
      end do
      call assertEqual(2047, finite, 'finite')
      call assertEqual(2047, numbers, 'numbers')
   end subroutine test_exponents

   !> One that is not finite, in each place of an array, is found; and of no numbers all are finite.
   subroutine test_arrays()
      integer, parameter :: n = 11
      real(wp) :: values(n), bad(3)
      integer :: i, j

      bad = [ieee_value(1.0_wp, ieee_quiet_nan), ieee_value(1.0_wp, ieee_positive_inf), &
         ieee_value(1.0_wp, ieee_negative_inf)]
      values = [(real(i, wp), i=1, n)]
      values(3) = smallest()
      values(4) = -huge(1.0_wp)
      call assertTrue(all_finite(values(:0)), 'empty')
      call assertTrue(all_finite(values), 'mixed')
      call assertTrue(all_finite([0.0_wp]), 'one')
      do j = 1, 3
         do i = 1, n
            values = 1.0_wp
            values(i) = bad(j)
            call assertFalse(all_finite(values), 'one of all')
            call assertTrue(all_finite(values(:i - 1)), 'those before it')
            call assertTrue(all_finite(values(i + 1:)), 'those after it')
            call assertFalse(all_finite(values(i:n:2)), 'a section that has it')
            call assertTrue(all_finite(values(i + 1:n:2)), 'a section that has not')
         end do
         call assertFalse(all_finite(bad(j:j)), 'it alone')
      end do
   end subroutine test_arrays

   !> The smallest denormal number, by its bits: no operation that would trap.
   pure real(wp) function smallest()
      smallest = transfer(1_int64, 1.0_wp)
   end function smallest

   !> Where only some or all are no numbers, in any place, before and after larger ones.
   subroutine test_extremes()
      real(wp) :: bad, worst, each(2)

      bad = ieee_value(1.0_wp, ieee_quiet_nan)
      call assertEqual([4.0_wp, 0.0_wp, 4.0_wp], [largest_of([1.0_wp, -4.0_wp]), &
         largest_of([real(wp) ::]), largest_of(reshape([-4.0_wp, 1.0_wp], [1, 2]))])
      call assertEqual([huge(bad), huge(bad), huge(bad)], [largest_of([bad, 1.0_wp]), &
         largest_of([1.0_wp, bad, 2.0_wp]), largest_of([bad, bad])])
      worst = 0.0_wp
      call worsen(worst, [2.0_wp, 1.0_wp])
      call worsen(worst, 1.5_wp)
      call assertEqual(2.0_wp, worst)
      call worsen(worst, bad)
      call worsen(worst, 3.0_wp)
      call assertEqual(huge(worst), worst)
      each = 1.0_wp
      call worsen(each, [bad, 2.0_wp])
      call assertEqual([huge(worst), 2.0_wp], each)
   end subroutine test_extremes

end module test_base_finite
