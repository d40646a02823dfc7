!> What GSL 2.7.1 calls a success and is none: points that are no number, points that are refused.
module test_fit_traps
   use asperity_base_error, only: computation_error, error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter, t_of, value_of, y_at, y_of
   use asperity_fit_types, only: fit_result, fit_settings
   use curve_problem, only: curve
   use funit, only: assertEqual, assertFalse, assertRelativelyEqual, assertTrue, TestMethod, &
      TestSuite
   implicit none
   private
   public :: suite_fit_traps

contains

   function suite_fit_traps() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('traps')
      call suite%addTest(TestMethod('a model that is refused on the way', test_refused_region))
      call suite%addTest(TestMethod('a model that is no number on the way', test_no_number))
      call suite%addTest(TestMethod('a model that is nowhere', test_nowhere))
      call suite%addTest(TestMethod('a model that is at one point only', test_one_point))
      call suite%addTest(TestMethod('a model that does not depend on them', test_no_influence))
      call suite%addTest(TestMethod('bounds are never passed', test_bounds))
   end function suite_fit_traps

   !> A decay of 1.5, of which nothing is known above `largest`.
   function decay() result(problem)
      type(curve) :: problem
      integer :: i

      problem%form = 'decay'
      allocate (problem%x(31))
      problem%x(:) = [(0.1_wp*i, i=0, 30)]
      problem%y = 20.0_wp*exp(-1.5_wp*problem%x)
   end function decay

   subroutine fit(problem, start, searches, result, error)
      type(curve), intent(in) :: problem
      real(wp), intent(in) :: start
      integer, intent(in) :: searches
      type(fit_result), intent(out) :: result
      type(error_type), allocatable, intent(out) :: error

      call fit_least_squares(problem, size(problem%x), [fit_parameter('a', '', 2000.0_wp, &
         1.0e-3_wp, 1.0e6_wp, .true.), fit_parameter('b', '', start, 1.0e-3_wp, 1.0e4_wp, &
         .true.)], fit_settings(searches=searches), result, error)
   end subroutine fit

   !> From the edge of what is refused, and from far inside. One search that runs into the edge says
   !> that it is no minimum; others find it.
   subroutine test_refused_region()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error
      real(wp), parameter :: starts(3) = [0.02_wp, 1.6_wp, 1.9999_wp]
      integer :: i

      problem = decay()
      problem%largest = 2.0_wp
      do i = 1, size(starts)
         call fit(problem, starts(i), 1, result, error)
         if (allocated(error)) then
            call assertTrue(index(error%message, 'standard errors from the minimum') > 0)
         else
            call assertRelativelyEqual([20.0_wp, 1.5_wp], result%values, 1.0e-6_wp)
         end if
         call fit(problem, starts(i), 4, result, error)
         call assertFalse(allocated(error))
         call assertRelativelyEqual([20.0_wp, 1.5_wp], result%values, 1.0e-6_wp)
      end do
   end subroutine test_refused_region

   !> The same where the model gives no number.
   subroutine test_no_number()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error
      real(wp), parameter :: starts(3) = [0.02_wp, 1.6_wp, 1.9999_wp]
      integer :: i

      problem = decay()
      problem%largest_number = 2.0_wp
      do i = 1, size(starts)
         call fit(problem, starts(i), 4, result, error)
         call assertFalse(allocated(error))
         call assertRelativelyEqual([20.0_wp, 1.5_wp], result%values, 1.0e-6_wp)
      end do
   end subroutine test_no_number

   !> Nothing to begin with.
   subroutine test_nowhere()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = decay()
      problem%largest = 1.0e-9_wp
      call fit(problem, 1.0_wp, 1, result, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertEqual('refused', error%message)
      problem%largest = huge(1.0_wp)
      problem%largest_number = 1.0e-9_wp
      call fit(problem, 1.0_wp, 1, result, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertEqual(computation_error, error%category)
   end subroutine test_nowhere

   !> Nothing is settled where no parameter changes anything. GSL would take the logarithm of zero,
   !> which stops a program that traps divisions by zero.
   subroutine test_no_influence()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = decay()
      problem%form = 'product'
      problem%x = 0.0_wp
      call fit(problem, 1.0_wp, 2, result, error)
      call assertFalse(allocated(error))
      call assertFalse(any(result%settled))
      call assertTrue(all(is_finite(result%correlations)))
      call assertRelativelyEqual(sum(problem%y**2), result%chi_squared, 1.0e-12_wp)
   end subroutine test_no_influence

   !> A start with no neighbours that can be evaluated is no fit.
   subroutine test_one_point()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = decay()
      problem%y = 0.0_wp
      ! all there is lies below what differences step over
      problem%largest = 0.001_wp*(1.0_wp + 1.0e-12_wp)
      call fit(problem, 0.001_wp*(1.0_wp + 0.5e-12_wp), 1, result, error)
      call assertTrue(allocated(error) .or. any(result%at_bound))
   end subroutine test_one_point

   !> Whatever t is, the value stays between the bounds, and comes back from t.
   subroutine test_bounds()
      type(fit_parameter) :: parameter
      real(wp) :: value
      integer :: i

      parameter = fit_parameter('a', '', 1.0_wp, 0.001_wp, 1000.0_wp, .true.)
      do i = -1000, 1000
         value = value_of(parameter, y_at(parameter, 0.37_wp*i))
         call assertTrue(is_finite(value) .and. value >= 0.001_wp*(1.0_wp - 1.0e-15_wp) &
            .and. value <= 1000.0_wp*(1.0_wp + 1.0e-15_wp))
      end do
      call assertRelativelyEqual(3.0_wp, value_of(parameter, y_at(parameter, t_of(parameter, &
         y_of(parameter, 3.0_wp)))), 1.0e-14_wp)
   end subroutine test_bounds

end module test_fit_traps
