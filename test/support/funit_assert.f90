!> Assertions of `funit`, with pFUnit's names, argument order and keywords, for default integers,
!> real64, default logicals and characters. A failed assertion is noted and the test goes on.
module funit_assert
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_is_nan
   use, intrinsic :: iso_fortran_env, only: real64
   implicit none
   private
   public :: SourceLocation, take_failures, throw, anyExceptions
   public :: assertAll, assertAny, assertEqual, assertFail, assertFalse, assertGreaterThan, &
      assertGreaterThanOrEqual, assertIsFinite, assertIsNaN, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue

   !> Place of an assertion; pFUnit's preprocessor fills it in, plain Fortran leaves it out.
   type :: SourceLocation
      !> Name of the source file
      character(len=255) :: fileName = '<unknown file>'
      !> Line in it
      integer :: lineNumber = -1
   end type SourceLocation

   !> An argument that nothing fits: what follows it can be given by keyword only, as in pFUnit.
   type, abstract :: KeywordEnforcer
   end type KeywordEnforcer

   interface assertTrue
      module procedure :: assert_true, assertAll
   end interface assertTrue

   interface assertFalse
      module procedure :: assert_false, assert_false_1
   end interface assertFalse

   interface assertEqual
      module procedure :: equal_real, equal_real_01, equal_real_11
      module procedure :: near_real, near_real_01, near_real_11
      module procedure :: equal_integer, equal_integer_11, equal_logical, equal_string
   end interface assertEqual

   interface assertRelativelyEqual
      module procedure :: relative_real, relative_real_01, relative_real_11
   end interface assertRelativelyEqual

   interface assertLessThan
      module procedure :: less_real, less_integer
   end interface assertLessThan

   interface assertLessThanOrEqual
      module procedure :: less_equal_real, less_equal_integer
   end interface assertLessThanOrEqual

   interface assertGreaterThan
      module procedure :: greater_real, greater_integer
   end interface assertGreaterThan

   interface assertGreaterThanOrEqual
      module procedure :: greater_equal_real, greater_equal_integer
   end interface assertGreaterThanOrEqual

   !> Failures of the running test, each on lines of its own; unset when there is none
   character(len=:), allocatable :: failures
   character(len=*), parameter :: new_row = new_line('a')//'     '

contains

   !> Note a failure of the running test.
   subroutine throw(message, location)
      character(len=*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location

      if (.not. allocated(failures)) failures = ''
      if (present(location)) failures = failures//new_row//trim(location%fileName)//':'
      failures = failures//new_row//message
   end subroutine throw

   !> Whether the running test has failed so far.
   logical function anyExceptions()
      anyExceptions = allocated(failures)
   end function anyExceptions

   !> Hand over the failures noted since the last call, empty when there is none.
   function take_failures() result(text)
      character(len=:), allocatable :: text

      text = ''
      if (allocated(failures)) call move_alloc(failures, text)
   end function take_failures

   subroutine assertFail(message, location)
      character(len=*), intent(in) :: message
      type(SourceLocation), intent(in), optional :: location

      call throw(message, location)
   end subroutine assertFail

   subroutine assert_true(condition, message, location)
      logical, intent(in) :: condition
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (.not. condition) call fail('not true', message=message, location=location)
   end subroutine assert_true

   subroutine assertAll(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(all(conditions), message, location)
   end subroutine assertAll

   subroutine assertAny(conditions, message, location)
      logical, intent(in) :: conditions(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(any(conditions), message, location)
   end subroutine assertAny

   subroutine assert_false(condition, message, location)
      logical, intent(in) :: condition
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(.not. condition, message, location)
   end subroutine assert_false

   subroutine assert_false_1(condition, message, location)
      logical, intent(in) :: condition(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(all(.not. condition), message, location)
   end subroutine assert_false_1

   subroutine assertIsNaN(x, message, location)
      real(real64), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(ieee_is_nan(x), message, location)
   end subroutine assertIsNaN

   subroutine assertIsFinite(x, message, location)
      real(real64), intent(in) :: x
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call assert_true(ieee_is_finite(x), message, location)
   end subroutine assertIsFinite

   subroutine equal_real(expected, actual, message, location)
      real(real64), intent(in) :: expected, actual
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call near_real_11([expected], [actual], 0.0_real64, message, location)
   end subroutine equal_real

   subroutine equal_real_01(expected, actual, message, location)
      real(real64), intent(in) :: expected, actual(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call near_real_01(expected, actual, 0.0_real64, message, location)
   end subroutine equal_real_01

   subroutine equal_real_11(expected, actual, message, location)
      real(real64), intent(in) :: expected(:), actual(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call near_real_11(expected, actual, 0.0_real64, message, location)
   end subroutine equal_real_11

   subroutine near_real(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected, actual, tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call near_real_11([expected], [actual], tolerance, message, location)
   end subroutine near_real

   subroutine near_real_01(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected, actual(:), tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call near_real_11(spread(expected, 1, size(actual)), actual, tolerance, message, location)
   end subroutine near_real_01

   !> Equal infinities are equal; a NaN equals nothing.
   subroutine near_real_11(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:), actual(:), tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      integer :: i

      if (.not. same_size(size(expected), size(actual), message, location)) return
      do i = 1, size(actual)
         if (comparable(expected(i), actual(i))) then
            if (actual(i) >= expected(i) .and. actual(i) <= expected(i)) cycle
            if (abs(actual(i) - expected(i)) <= tolerance) cycle
         end if
         call fail('not equal', text(expected(i)), text(actual(i)), &
            difference_text(actual(i), expected(i)), tolerance, i, size(actual), message, location)
         return
      end do
   end subroutine near_real_11

   subroutine relative_real(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected, actual, tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call relative_real_11([expected], [actual], tolerance, message, location)
   end subroutine relative_real

   subroutine relative_real_01(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected, actual(:), tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call relative_real_11(spread(expected, 1, size(actual)), actual, tolerance, message, location)
   end subroutine relative_real_01

   !> |actual - expected| <= tolerance |expected|; an expected zero fails, as it has no relative
   !> difference.
   subroutine relative_real_11(expected, actual, tolerance, message, location)
      real(real64), intent(in) :: expected(:), actual(:), tolerance
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      integer :: i

      if (.not. same_size(size(expected), size(actual), message, location)) return
      do i = 1, size(actual)
         if (comparable(expected(i), actual(i))) then
            if (abs(expected(i)) > 0.0_real64 .and. &
               abs(actual(i) - expected(i)) <= tolerance*abs(expected(i))) cycle
         end if
         call fail('not relatively equal', text(expected(i)), text(actual(i)), &
            relative_text(actual(i), expected(i)), tolerance, i, size(actual), message, location)
         return
      end do
   end subroutine relative_real_11

   subroutine equal_integer(expected, actual, message, location)
      integer, intent(in) :: expected, actual
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call equal_integer_11([expected], [actual], message, location)
   end subroutine equal_integer

   subroutine equal_integer_11(expected, actual, message, location)
      integer, intent(in) :: expected(:), actual(:)
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      integer :: i

      if (.not. same_size(size(expected), size(actual), message, location)) return
      do i = 1, size(actual)
         if (actual(i) == expected(i)) cycle
         call fail('not equal', digits_of(expected(i)), digits_of(actual(i)), &
            index=i, n=size(actual), message=message, location=location)
         return
      end do
   end subroutine equal_integer_11

   subroutine equal_logical(expected, actual, unused, message, location)
      logical, intent(in) :: expected, actual
      class(KeywordEnforcer), intent(in), optional :: unused
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (present(unused)) return
      if (expected .eqv. actual) return
      call fail('not equal', merge('T', 'F', expected), merge('T', 'F', actual), &
         message=message, location=location)
   end subroutine equal_logical

   !> Blanks at both ends do not count.
   subroutine equal_string(expected, found, message, location)
      character(len=*), intent(in) :: expected, found
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (adjustl(expected) == adjustl(found)) return
      call fail('not equal', trim(expected), trim(found), message=message, location=location)
   end subroutine equal_string

   subroutine less_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs, rhs
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (comparable(lhs, rhs)) then
         if (lhs < rhs) return
      end if
      call fail_order('<', text(lhs), text(rhs), message, location)
   end subroutine less_real

   subroutine less_equal_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs, rhs
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (comparable(lhs, rhs)) then
         if (lhs <= rhs) return
      end if
      call fail_order('<=', text(lhs), text(rhs), message, location)
   end subroutine less_equal_real

   subroutine greater_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs, rhs
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (comparable(lhs, rhs)) then
         if (lhs > rhs) return
      end if
      call fail_order('>', text(lhs), text(rhs), message, location)
   end subroutine greater_real

   subroutine greater_equal_real(lhs, rhs, message, location)
      real(real64), intent(in) :: lhs, rhs
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (comparable(lhs, rhs)) then
         if (lhs >= rhs) return
      end if
      call fail_order('>=', text(lhs), text(rhs), message, location)
   end subroutine greater_equal_real

   subroutine less_integer(lhs, rhs, unused, message, location)
      integer, intent(in) :: lhs, rhs
      class(KeywordEnforcer), intent(in), optional :: unused
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (present(unused)) return
      if (.not. lhs < rhs) call fail_order('<', digits_of(lhs), digits_of(rhs), message, location)
   end subroutine less_integer

   subroutine less_equal_integer(lhs, rhs, unused, message, location)
      integer, intent(in) :: lhs, rhs
      class(KeywordEnforcer), intent(in), optional :: unused
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (present(unused)) return
      if (.not. lhs <= rhs) call fail_order('<=', digits_of(lhs), digits_of(rhs), message, location)
   end subroutine less_equal_integer

   subroutine greater_integer(lhs, rhs, unused, message, location)
      integer, intent(in) :: lhs, rhs
      class(KeywordEnforcer), intent(in), optional :: unused
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (present(unused)) return
      if (.not. lhs > rhs) call fail_order('>', digits_of(lhs), digits_of(rhs), message, location)
   end subroutine greater_integer

   subroutine greater_equal_integer(lhs, rhs, unused, message, location)
      integer, intent(in) :: lhs, rhs
      class(KeywordEnforcer), intent(in), optional :: unused
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      if (present(unused)) return
      if (.not. lhs >= rhs) call fail_order('>=', digits_of(lhs), digits_of(rhs), message, location)
   end subroutine greater_equal_integer

   subroutine fail_order(relation, lhs, rhs, message, location)
      character(len=*), intent(in) :: relation, lhs, rhs
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      call fail(lhs//' '//relation//' '//rhs//' does not hold', message=message, location=location)
   end subroutine fail_order

   logical function same_size(n_expected, n_actual, message, location)
      integer, intent(in) :: n_expected, n_actual
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location

      same_size = n_expected == n_actual
      if (.not. same_size) call fail('sizes differ', digits_of(n_expected), digits_of(n_actual), &
         message=message, location=location)
   end function same_size

   subroutine fail(what, expected, actual, difference, tolerance, index, n, message, location)
      character(len=*), intent(in) :: what
      character(len=*), intent(in), optional :: expected, actual, difference
      real(real64), intent(in), optional :: tolerance
      integer, intent(in), optional :: index, n
      character(len=*), intent(in), optional :: message
      type(SourceLocation), intent(in), optional :: location
      character(len=:), allocatable :: full

      full = what
      if (present(message)) full = message//': '//what
      if (present(n)) then
         if (n > 1) full = full//' at index '//digits_of(index)
      end if
      if (present(expected)) full = full//new_row//'   expected   '//expected
      if (present(actual)) full = full//new_row//'   found      '//actual
      if (present(difference)) full = full//new_row//'   difference '//difference// &
         ', allowed '//text(tolerance)
      call throw(full, location)
   end subroutine fail

   !> Comparing a NaN would trap where invalid operations are trapped.
   pure logical function comparable(a, b)
      real(real64), intent(in) :: a, b

      comparable = .not. (ieee_is_nan(a) .or. ieee_is_nan(b))
   end function comparable

   function relative_text(actual, expected) result(full)
      real(real64), intent(in) :: actual, expected
      character(len=:), allocatable :: full

      full = 'has no meaning'
      if (.not. comparable(actual, expected)) return
      if (abs(expected) > 0.0_real64) full = text((actual - expected)/expected)//' (relative)'
   end function relative_text

   function difference_text(actual, expected) result(full)
      real(real64), intent(in) :: actual, expected
      character(len=:), allocatable :: full

      full = 'has no meaning'
      if (ieee_is_finite(actual) .and. ieee_is_finite(expected)) full = text(actual - expected)
   end function difference_text

   function text(value) result(full)
      real(real64), intent(in) :: value
      character(len=:), allocatable :: full
      character(len=32) :: buffer

      write (buffer, '(es25.16e3)') value
      full = trim(adjustl(buffer))
   end function text

   function digits_of(value) result(full)
      integer, intent(in) :: value
      character(len=:), allocatable :: full
      character(len=12) :: buffer

      write (buffer, '(i0)') value
      full = trim(buffer)
   end function digits_of

end module funit_assert
