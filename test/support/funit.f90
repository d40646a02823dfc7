!> The part of pFUnit 4 that the tests use, with pFUnit's names, argument order and keywords, so
!> that the same tests run with the real one: suites and their runner here, assertions in
!> `funit_assert`. The runner lists every test with its time, failed ones with the reasons.
module funit
   use, intrinsic :: iso_fortran_env, only: int64, output_unit
   use funit_assert, only: anyExceptions, assertAll, assertAny, assertEqual, assertFail, &
      assertFalse, assertGreaterThan, assertGreaterThanOrEqual, assertIsFinite, assertIsNaN, &
      assertLessThan, assertLessThanOrEqual, assertRelativelyEqual, assertTrue, SourceLocation, &
      take_failures, throw
   implicit none
   private
   public :: SourceLocation, SerialContext, Test, TestMethod, TestSuite, TestResult, TestRunner
   public :: throw, anyExceptions
   public :: assertAll, assertAny, assertEqual, assertFail, assertFalse, assertGreaterThan, &
      assertGreaterThanOrEqual, assertIsFinite, assertIsNaN, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue

   !> Stands for the one process that runs the tests.
   type :: SerialContext
   end type SerialContext

   abstract interface
      !> A test: it takes nothing and asserts.
      subroutine empty()
      end subroutine empty
   end interface

   !> What a suite is made of.
   type, abstract :: Test
      !> Name, such as `suite.test`
      character(len=:), allocatable :: name
   end type Test

   !> One test procedure with its name.
   type, extends(Test) :: TestMethod
      !> The procedure
      procedure(empty), pointer, nopass :: userMethod => null()
   end type TestMethod

   interface TestMethod
      module procedure :: new_test_method
   end interface TestMethod

   type :: entry_type
      character(len=120) :: name = ''
      procedure(empty), pointer, nopass :: method => null()
   end type entry_type

   !> A named list of tests; the tests of an added suite join the list.
   type, extends(Test) :: TestSuite
      type(entry_type), allocatable, private :: entries(:)
   contains
      procedure :: addTest
      procedure :: countTestCases
   end type TestSuite

   interface TestSuite
      module procedure :: new_test_suite
   end interface TestSuite

   !> Counts of a run.
   type :: TestResult
      integer, private :: n_run = 0, n_failed = 0
   contains
      procedure :: runCount
      procedure :: failureCount
      procedure :: errorCount
      procedure :: wasSuccessful
   end type TestResult

   !> Runs a suite and prints what failed.
   type :: TestRunner
      integer, private :: unit = output_unit
   contains
      procedure :: run
   end type TestRunner

   interface TestRunner
      module procedure :: new_test_runner
   end interface TestRunner

contains

   function new_test_method(name, method) result(this)
      character(len=*), intent(in) :: name
      procedure(empty) :: method
      type(TestMethod) :: this

      this%name = name
      this%userMethod => method
   end function new_test_method

   function new_test_suite(name) result(this)
      character(len=*), intent(in) :: name
      type(TestSuite) :: this

      this%name = name
      allocate (this%entries(0))
   end function new_test_suite

   function new_test_runner(unit) result(this)
      integer, intent(in), optional :: unit
      type(TestRunner) :: this

      if (present(unit)) this%unit = unit
   end function new_test_runner

   !> Append a test, named after the suite, or every test of a suite.
   subroutine addTest(this, aTest)
      class(TestSuite), intent(inout) :: this
      class(Test), intent(in) :: aTest
      type(entry_type) :: new

      select type (aTest)
      type is (TestMethod)
         new%name = this%name//'.'//aTest%name
         new%method => aTest%userMethod
         this%entries = [this%entries, new]
      type is (TestSuite)
         this%entries = [this%entries, aTest%entries]
      end select
   end subroutine addTest

   integer function countTestCases(this)
      class(TestSuite), intent(in) :: this

      countTestCases = size(this%entries)
   end function countTestCases

   !> Run every test of `aTest`, print failures, return the counts.
   function run(this, aTest, context) result(result)
      class(TestRunner), intent(inout) :: this
      class(Test), intent(inout) :: aTest
      class(SerialContext), intent(in) :: context
      type(TestResult) :: result
      integer :: i

      associate (unused => context)
      end associate
      select type (aTest)
      type is (TestMethod)
         call run_one(this%unit, aTest%name, aTest%userMethod, result)
      type is (TestSuite)
         do i = 1, size(aTest%entries)
            call run_one(this%unit, trim(aTest%entries(i)%name), aTest%entries(i)%method, result)
         end do
      end select
   end function run

   subroutine run_one(unit, name, method, result)
      integer, intent(in) :: unit
      character(len=*), intent(in) :: name
      procedure(empty) :: method
      type(TestResult), intent(inout) :: result
      integer(int64) :: start, finish, rate
      character(len=:), allocatable :: failures

      call system_clock(start, rate)
      call method()
      call system_clock(finish)
      result%n_run = result%n_run + 1
      failures = take_failures()
      if (failures /= '') then
         result%n_failed = result%n_failed + 1
         write (unit, '(2a)') 'FAIL ', name//failures
      else
         write (unit, '(a, f7.3, 2a)') '  ok ', real(finish - start)/real(rate), ' s  ', name
      end if
   end subroutine run_one

   integer function runCount(this)
      class(TestResult), intent(in) :: this

      runCount = this%n_run
   end function runCount

   integer function failureCount(this)
      class(TestResult), intent(in) :: this

      failureCount = this%n_failed
   end function failureCount

   !> Tests that broke off: always none here, as nothing can.
   integer function errorCount(this)
      class(TestResult), intent(in) :: this

      errorCount = 0*this%n_failed
   end function errorCount

   logical function wasSuccessful(this)
      class(TestResult), intent(in) :: this

      wasSuccessful = this%n_failed == 0
   end function wasSuccessful

end module funit
