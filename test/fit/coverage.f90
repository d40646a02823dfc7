!> Whether 95 % intervals hold the truth in 95 of 100 records with noise. 200 records, or as many as
!> ASPERITY_FIT_RECORDS says (`./run coverage`); searches begin ten times off.
module test_fit_coverage
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_press, only: press_problem
   use asperity_fit_types, only: fit_result, fit_settings
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use press_records, only: add_noise, new_record, press_parameters, truth
   use random_inputs, only: random_stream
   implicit none
   private
   public :: assert_coverage, coverage_records, suite_fit_coverage

   integer, parameter :: usual_records = 200, many_records = 2000
   integer(int64), parameter :: seed = 20210101_int64

contains

   function suite_fit_coverage() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('coverage')
      call suite%addTest(TestMethod('eta and datum, noise 0.5 %', test_two))
      call suite%addTest(TestMethod('eta, sigma and datum, noise 0.1 %', test_three))
      call suite%addTest(TestMethod('with unloading and machine, noise 0.2 %', test_machine))
   end function suite_fit_coverage

   subroutine test_two()
      call check_coverage([1, 7], .false., 0.0_wp, 0.005_wp)
   end subroutine test_two

   subroutine test_three()
      call check_coverage([1, 6, 7], .false., 0.0_wp, 0.001_wp)
   end subroutine test_three

   subroutine test_machine()
      call check_coverage([1, 7, 8], .true., 0.005_wp, 0.002_wp)
   end subroutine test_machine

   !> Count the intervals that hold the truth.
   subroutine check_coverage(free, returns, compliance, noise)
      integer, intent(in) :: free(:)
      logical, intent(in) :: returns
      real(wp), intent(in) :: compliance, noise
      type(press_problem) :: problem
      type(random_stream) :: stream
      type(fit_result) :: result
      type(error_type), allocatable :: error
      real(wp), allocatable :: exact(:)
      real(wp) :: numbers(8), share(size(free)), largest
      integer :: held(size(free)), failed, k, n

      n = coverage_records()
      call new_record(problem, free, returns, compliance)
      exact = problem%pressure
      numbers(:7) = truth
      numbers(8) = compliance
      stream%state = seed
      held = 0
      failed = 0
      largest = 0.0_wp
      do k = 1, n
         call add_noise(problem, exact, noise, stream)
         call fit_least_squares(problem, size(exact), press_parameters(problem, 10.0_wp), &
            fit_settings(), result, error)
         if (allocated(error)) then
            failed = failed + 1
            cycle
         end if
         where (result%lower <= numbers(free) .and. numbers(free) <= result%upper) held = held + 1
         largest = max(largest, maxval(result%standard_errors))
      end do
      share = real(held, wp)/n
      print '(a, i0, a, i0, a, *(f6.2))', 'seed ', seed, ', ', n, ' records, % held:', &
         100.0_wp*share
      print '(a, f6.3)', '   largest standard error', largest
      call assertEqual(0, failed, 'fits that failed')
      call assert_coverage(share, n)
   end subroutine check_coverage

   !> The share of the intervals that hold the truth is what chance allows.
   subroutine assert_coverage(share, records)
      real(wp), intent(in) :: share(:)
      integer, intent(in) :: records

      if (records < many_records) then
         call assertTrue(all(share >= 0.90_wp .and. share <= 0.985_wp), 'coverage')
      else
         call assertTrue(all(share >= 0.93_wp .and. share <= 0.97_wp), 'coverage')
      end if
   end subroutine assert_coverage

   !> How many records.
   integer function coverage_records() result(records)
      character(len=12) :: text
      integer :: status

      records = usual_records
      call get_environment_variable('ASPERITY_FIT_RECORDS', text, status=status)
      if (status == 0) read (text, *) records
   end function coverage_records

end module test_fit_coverage
