!> Fits with known answers: values, standard errors, intervals and correlations of a straight line
!> by their formulas; far starts; several minima; what a record cannot tell.
module test_fit_least_squares
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_student, only: student_factor
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_types, only: fit_result, fit_settings, is_unsettled
   use curve_problem, only: curve
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_fit_least_squares

contains

   function suite_fit_least_squares() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('least squares')
      call suite%addTest(TestMethod('a straight line by its formulas', test_line))
      call suite%addTest(TestMethod('starts off by 100', test_far_starts))
      call suite%addTest(TestMethod('the lowest of several minima', test_minima))
      call suite%addTest(TestMethod('what cannot be told apart', test_product))
      call suite%addTest(TestMethod('a parameter at its bound', test_bound))
      call suite%addTest(TestMethod('what is refused', test_refused))
   end function suite_fit_least_squares

   !> A line with noise of a fixed seed.
   function noisy_line(n) result(problem)
      integer, intent(in) :: n
      type(curve) :: problem
      type(random_stream) :: stream
      integer :: i

      stream%state = 17
      allocate (problem%x(n), problem%y(n))
      do i = 1, n
         problem%x(i) = real(i, wp)
         problem%y(i) = 3.0_wp + 0.5_wp*problem%x(i) + stream%uniform(-0.2_wp, 0.2_wp)
      end do
   end function noisy_line

   !> Regression of y on x has closed formulas for all that a fit gives.
   subroutine test_line()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error
      type(fit_parameter) :: parameters(2)
      real(wp) :: mean_x, sxx, a, b, variance, error_a, error_b, factor
      integer, parameter :: n = 12

      problem = noisy_line(n)
      parameters(1) = fit_parameter('a', '', -40.0_wp, -50.0_wp, 50.0_wp)
      parameters(2) = fit_parameter('b', '', 40.0_wp, -50.0_wp, 50.0_wp, scale=0.1_wp)
      call fit_least_squares(problem, n, parameters, fit_settings(), result, error)
      call assertFalse(allocated(error))
      associate (x => problem%x, y => problem%y)
         mean_x = sum(x)/n
         sxx = sum((x - mean_x)**2)
         b = sum((x - mean_x)*y)/sxx
         a = sum(y)/n - b*mean_x
         variance = sum((y - a - b*x)**2)/(n - 2)
         error_b = sqrt(variance/sxx)
         error_a = sqrt(variance*(1.0_wp/n + mean_x**2/sxx))
         factor = student_factor(0.95_wp, n - 2)
         call assertRelativelyEqual([a, b], result%values, 1.0e-9_wp, 'values')
         ! that of b over its scale
         call assertRelativelyEqual([error_a, 10.0_wp*error_b], result%standard_errors, 1.0e-7_wp, &
            'standard errors')
         call assertRelativelyEqual([a - factor*error_a, b - factor*error_b], result%lower, &
            1.0e-7_wp, 'lower ends')
         call assertRelativelyEqual([a + factor*error_a, b + factor*error_b], result%upper, &
            1.0e-7_wp, 'upper ends')
         call assertRelativelyEqual(-mean_x/sqrt(sum(x**2)/n), result%correlations(1, 2), &
            1.0e-7_wp, 'correlation')
         call assertEqual(n - 2, result%degrees_of_freedom)
         call assertRelativelyEqual(variance*(n - 2), result%chi_squared, 1.0e-12_wp)
      end associate
      call assertTrue(all(result%settled) .and. .not. any(result%at_bound))
   end subroutine test_line

   !> A decay is found from starts 100 times too large and too small, whatever units residuals have.
   subroutine test_far_starts()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error
      real(wp), parameter :: factors(3) = [0.01_wp, 1.0_wp, 100.0_wp], scales(3) = [1.0e-9_wp, &
         1.0_wp, 1.0e9_wp]
      integer :: i, j, k

      problem%form = 'decay'
      problem%x = [(0.1_wp*i, i=0, 30)]
      problem%y = 20.0_wp*exp(-1.5_wp*problem%x)
      do i = 1, 3
         do j = 1, 3
            do k = 1, 3
               problem%scale = scales(k)
               call fit_least_squares(problem, size(problem%x), [fit_parameter('a', '', &
                  20.0_wp*factors(i), 1.0e-3_wp, 1.0e6_wp, .true.), fit_parameter('b', '', &
                  1.5_wp*factors(j), 1.0e-3_wp, 1.0e4_wp, .true.)], fit_settings(searches=2), &
                  result, error)
               call assertFalse(allocated(error))
               call assertRelativelyEqual([20.0_wp, 1.5_wp], result%values, 1.0e-6_wp)
            end do
         end do
      end do
   end subroutine test_far_starts

   !> A wave of a wrong frequency is one minimum among many: one search ends in the next one, many
   !> find the lowest, the same each time.
   subroutine test_minima()
      type(curve) :: problem
      type(fit_result) :: one, many, again
      type(fit_parameter) :: parameters(2)
      type(error_type), allocatable :: error
      integer :: i

      problem%form = 'wave'
      problem%x = [(0.1_wp*i, i=0, 60)]
      problem%y = 2.0_wp*sin(3.0_wp*problem%x)
      parameters(1) = fit_parameter('a', '', 1.0_wp, 0.1_wp, 10.0_wp, .true.)
      parameters(2) = fit_parameter('b', '', 8.0_wp, 0.5_wp, 12.0_wp)
      call fit_least_squares(problem, 61, parameters, fit_settings(), one, error)
      call assertTrue(abs(one%values(2) - 3.0_wp) > 1.0_wp)
      call fit_least_squares(problem, 61, parameters, fit_settings(searches=6), many, error)
      call assertFalse(allocated(error))
      call assertRelativelyEqual([2.0_wp, 3.0_wp], many%values, 1.0e-8_wp)
      call assertEqual(6, many%searches)
      call assertTrue(many%agreeing >= 1 .and. many%agreeing < 6)
      call fit_least_squares(problem, 61, parameters, fit_settings(searches=6), again, error)
      call assertTrue(all(abs(many%values - again%values) <= 0.0_wp), 'the same again')
   end subroutine test_minima

   !> Of a product nothing but the product is known: the direction a up, b down is not settled.
   subroutine test_product()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = noisy_line(20)
      problem%form = 'product'
      call fit_least_squares(problem, 20, [fit_parameter('a', '', 1.0_wp, 1.0e-3_wp, 1.0e3_wp, &
         .true.), fit_parameter('b', '', 2.0_wp, 1.0e-3_wp, 1.0e3_wp, .true.)], fit_settings(), &
         result, error)
      call assertFalse(allocated(error))
      call assertTrue(result%settled(1) .and. .not. result%settled(2))
      call assertTrue(is_unsettled(result, 1) .and. is_unsettled(result, 2))
      call assertEqual(0.0_wp, sum(result%directions(:, 2)), 1.0e-6_wp, 'along a up, b down')
      ! least squares of y = c x
      call assertRelativelyEqual(sum(problem%x*problem%y)/sum(problem%x**2), &
         product(result%values), 1.0e-7_wp)
   end subroutine test_product

   !> What lies beyond a bound ends there, and says so.
   subroutine test_bound()
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = noisy_line(20)
      call fit_least_squares(problem, 20, [fit_parameter('a', '', 3.0_wp, 2.0_wp, 4.0_wp), &
         fit_parameter('b', '', 0.2_wp, 0.1_wp, 0.3_wp)], fit_settings(searches=3), result, error)
      call assertFalse(allocated(error))
      call assertTrue(result%at_bound(2))
      call assertEqual(0.3_wp, result%values(2), 1.0e-4_wp)
   end subroutine test_bound

   !> Too little of a record, bounds in disorder, a name twice.
   subroutine test_refused()
      type(fit_parameter) :: a, b

      a = fit_parameter('a', '', 1.0_wp, 0.0_wp, 2.0_wp)
      b = fit_parameter('b', '', 1.0_wp, 0.5_wp, 2.0_wp, .true.)
      call refused(2, [a, b], '2 numbers of the record cannot settle 2 free parameters')
      call refused(9, [a, a], 'a is free twice')
      a%start = 2.0_wp
      call refused(9, [a, b], 'a begins at 2.0 between 0.0 and 2.0')
      a%start = 1.0_wp
      a%by_ratio = .true.
      call refused(9, [a, b], 'and above 0')
   end subroutine test_refused

   subroutine refused(n, parameters, words)
      integer, intent(in) :: n
      type(fit_parameter), intent(in) :: parameters(:)
      character(len=*), intent(in) :: words
      type(curve) :: problem
      type(fit_result) :: result
      type(error_type), allocatable :: error

      problem = noisy_line(n)
      call fit_least_squares(problem, n, parameters, fit_settings(), result, error)
      if (.not. allocated(error)) call fatal_error(error, 'nothing was refused')
      call assertTrue(index(error%message, words) > 0, error%message)
   end subroutine refused

end module test_fit_least_squares
