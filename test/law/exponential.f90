!> The vector exponential against power series in quadruple precision. The series take additions
!> and products only, which every compiler has in that precision, unlike an intrinsic exp.
module test_law_exponential
   use, intrinsic :: ieee_arithmetic, only: ieee_get_halting_mode, ieee_invalid, ieee_is_nan, &
      ieee_quiet_nan, ieee_set_halting_mode, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponential_block, exponentials
   use extremes, only: worsen
   use funit, only: assertEqual, assertLessThanOrEqual, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_exponential

   !> Quadruple precision, or double where there is none
   integer, parameter :: high = max(selected_real_kind(30), wp)
   !> The series are of x/2^halvings, below 1.6 in size
   integer, parameter :: halvings = 6, terms = 40
   !> Squarings double the relative error: what the reference errs by, in epsilon(1.0_wp)
   real(wp), parameter :: reference_error = &
      real(2**(halvings + 2)*epsilon(1.0_high)/epsilon(1.0_wp), wp)
   !> In eps, relative: half a one each from the power of two, the sum and the product
   real(wp), parameter :: allowed = 1.5_wp + reference_error
   real(wp), parameter :: eps = epsilon(1.0_wp)
   integer(int64), parameter :: seed = 27182818_int64

contains

   function suite_exponential() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('exponential')
      call suite%addTest(TestMethod('against series in higher precision', test_series))
      call suite%addTest(TestMethod('around each multiple of ln(2)/8', test_corners))
      call suite%addTest(TestMethod('not a number', test_nan))
      call suite%addTest(TestMethod('exp(0) = 1, and next to it', test_zero))
      call suite%addTest(TestMethod('every multiple of the block, in order', test_blocks))
      call suite%addTest(TestMethod('exp(x + y) = exp(x) exp(y)', test_products))
      call suite%addTest(TestMethod('the reference against known digits', test_reference))
   end function suite_exponential

   !> Random arguments over the whole range, and small ones.
   subroutine test_series()
      integer, parameter :: n = 1000*exponential_block
      type(random_stream) :: stream
      real(wp) :: x(n), values(n), worst
      integer :: i, part

      stream = random_stream(seed)
      worst = 0.0_wp
      do part = 1, 20
         do i = 1, n, 4
            x(i) = stream%uniform(-100.0_wp, 10.0_wp)
            x(i + 1) = stream%uniform(-4.0_wp, 4.0_wp)
            x(i + 2) = stream%log_uniform(1.0e-300_wp, 10.0_wp)
            x(i + 3) = -stream%log_uniform(1.0e-300_wp, 100.0_wp)
         end do
         call exponentials(n, x, values)
         call worsen(worst, error_in_eps(x, values))
      end do
      call record('exponential.error_in_eps', worst)
      write (*, '(5x, a, i0)') 'seed ', seed
      call assertLessThanOrEqual(worst, allowed, 'error in eps')
   end subroutine test_series

   !> There the argument of the polynomial is largest and the power of two changes.
   subroutine test_corners()
      integer, parameter :: below = -1150, above = 114, n = 4*(above - below + 1)
      real(wp) :: x(n), values(n), worst
      integer :: i, k

      k = 0
      do i = below, above
         x(k + 1) = i*(0.125_wp*log(2.0_wp))
         x(k + 2) = nearest(x(k + 1), 1.0_wp)
         x(k + 3) = nearest(x(k + 1), -1.0_wp)
         x(k + 4) = x(k + 1) + 0.01_wp
         k = k + 4
      end do
      call exponentials(n, x, values)
      worst = error_in_eps(x, values)
      call assertLessThanOrEqual(worst, allowed, 'error in eps')
   end subroutine test_corners

   !> Beside numbers, in each place; it must not become an index.
   subroutine test_nan()
      real(wp) :: x(4), values(4), bad
      logical :: halts
      integer :: i

      call ieee_get_halting_mode(ieee_invalid, halts)
      call ieee_set_halting_mode(ieee_invalid, .false.)
      bad = ieee_value(bad, ieee_quiet_nan)
      do i = 1, 4
         x = -1.0_wp
         x(i) = bad
         call exponentials(4, x, values)
         call assertTrue(ieee_is_nan(values(i)), 'not a number')
         values(i) = exp(-1.0_wp)
         call assertRelativelyEqual(exp(-1.0_wp), values, 2.0_wp*eps, 'the others')
      end do
      call ieee_set_halting_mode(ieee_invalid, halts)
   end subroutine test_nan

   subroutine test_zero()
      real(wp), parameter :: x(8) = [0.0_wp, -0.0_wp, tiny(1.0_wp), -tiny(1.0_wp), &
         eps, -eps, 0.25_wp*eps, -0.125_wp*eps]
      real(wp) :: values(8)

      call exponentials(8, x, values)
      call assertEqual([1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp + eps, 1.0_wp - eps, 1.0_wp, &
         1.0_wp], values, 0.0_wp, 'exactly')
   end subroutine test_zero

   !> Arguments do not mix: the same ones give the same bits in any place, none is left out and
   !> nothing beyond is written.
   subroutine test_blocks()
      integer, parameter :: most = 16*exponential_block
      real(wp) :: x(most), one(exponential_block), values(most), alone(most)
      integer :: i, n

      do i = 1, most
         x(i) = 10.0_wp - 1.7_wp*i
         call exponentials(exponential_block, spread(x(i), 1, exponential_block), one)
         alone(i) = one(exponential_block)
         call assertEqual(one(1), one, 0.0_wp, 'all of a block')
      end do
      do n = 0, most, exponential_block
         values = -1.0_wp
         call exponentials(n, x(:n), values(:n))
         call assertEqual(alone(:n), values(:n), 0.0_wp, 'as alone')
         call assertEqual(-1.0_wp, values(n + 1:), 0.0_wp, 'not touched')
      end do
   end subroutine test_blocks

   !> Without any reference: both arguments are multiples of 2^-20, so that their sum is exact.
   !> Three errors of 1.5 eps each, and the product's rounding.
   subroutine test_products()
      integer, parameter :: n = 2000
      type(random_stream) :: stream
      real(wp) :: x(n), y(n), first(n), second(n), both(n)

      stream = random_stream(seed + 1)
      call fill(x, -50.0_wp, 5.0_wp)
      call fill(y, -50.0_wp, 5.0_wp)
      call exponentials(n, x, first)
      call exponentials(n, y, second)
      call exponentials(n, x + y, both)
      call assertRelativelyEqual(both, first*second, 5.0_wp*eps, 'products')

   contains

      subroutine fill(values, lower, upper)
         real(wp), intent(out) :: values(:)
         real(wp), intent(in) :: lower, upper
         integer :: i

         do i = 1, size(values)
            values(i) = anint(stream%uniform(lower, upper)*2.0_wp**20)/2.0_wp**20
         end do
      end subroutine fill

   end subroutine test_products

   !> e, exp(10) and exp(-100) to 25 digits.
   subroutine test_reference()
      real(high), parameter :: known(3) = [2.718281828459045235360287_high, &
         22026.46579480671651695790065_high, 3.720075976020835962959696e-44_high]
      real(wp), parameter :: x(3) = [1.0_wp, 10.0_wp, -100.0_wp]
      integer :: i

      do i = 1, 3
         call assertLessThanOrEqual(real(abs(series(x(i))/known(i) - 1.0_high), wp), &
            1.0e-24_wp + reference_error*eps, 'relative difference')
      end do
   end subroutine test_reference

   !> Largest relative error over eps.
   function error_in_eps(x, values) result(worst)
      real(wp), intent(in) :: x(:), values(:)
      real(wp) :: worst
      real(high) :: exact
      integer :: i

      worst = 0.0_wp
      do i = 1, size(x)
         exact = series(x(i))
         call worsen(worst, real(abs(real(values(i), high)/exact - 1.0_high), wp)/eps)
      end do
   end function error_in_eps

   !> exp(x) by the power series of x/2^halvings, squared `halvings` times.
   pure function series(x) result(value)
      real(wp), intent(in) :: x
      real(high) :: value, part
      integer :: i

      part = real(x, high)/2.0_high**halvings
      value = 1.0_high
      do i = terms, 1, -1
         value = 1.0_high + part*value/real(i, high)
      end do
      do i = 1, halvings
         value = value*value
      end do
   end function series

end module test_law_exponential
