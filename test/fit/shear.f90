!> Friction from shear tests: the model against closed forms, and records with noise whose numbers
!> are known, from starts far off.
module test_fit_shear
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: error_type, wp
   use asperity_fit_least_squares, only: fit_least_squares
   use asperity_fit_parameter, only: fit_parameter
   use asperity_fit_shear, only: new_shear_problem, shear_problem
   use asperity_fit_shear_model, only: shear_critical_slip, shear_decay_slip, &
      shear_friction_coefficient, shear_names, shear_pressure_exponent, shear_reference_pressure, &
      shear_shear_compliance, shear_static_friction_coefficient, shear_stress_along, shear_test, &
      shear_units
   use asperity_fit_types, only: fit_result, fit_settings
   use funit, only: anyExceptions, assertEqual, assertFalse, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   use test_fit_coverage, only: assert_coverage, coverage_records
   implicit none
   private
   public :: suite_fit_shear

   real(wp), parameter :: mu = 0.47_wp, g = 0.31_wp, disc = 2922.5_wp
   integer(int64), parameter :: seed = 31415926_int64

contains

   function suite_fit_shear() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('fit of shear tests')
      call suite%addTest(TestMethod('cycles against the closed form', test_closed_form))
      call suite%addTest(TestMethod('in series with a machine', test_series))
      call suite%addTest(TestMethod('rest and motion against the closed form', test_rest))
      call suite%addTest(TestMethod('found from far off', test_far_start))
      call suite%addTest(TestMethod('a machine is told from the faces by two normal stresses', &
         test_machine))
      call suite%addTest(TestMethod('at rest, in motion, by pressure: found', test_friction))
      call suite%addTest(TestMethod('a minimum on a kink', test_kink))
      call suite%addTest(TestMethod('coverage of the intervals', test_coverage))
      call suite%addTest(TestMethod('tests that cannot be followed', test_refused))
   end function suite_fit_shear

   !> Displacements through turning points in steps of at most `step`.
   pure subroutine go_through(turns, step, path)
      real(wp), intent(in) :: turns(:), step
      real(wp), allocatable, intent(out) :: path(:)
      real(wp) :: from
      integer :: i, j, n

      path = [0.0_wp]
      from = 0.0_wp
      do i = 1, size(turns)
         n = ceiling(abs(turns(i) - from)/step)
         path = [path, [(from + (turns(i) - from)*j/n, j=1, n)]]
         from = turns(i)
      end do
   end subroutine go_through

   !> A test without noise at one normal stress.
   function test_at(values, path, normal_stress) result(test)
      real(wp), intent(in) :: values(:), path(:), normal_stress
      type(shear_test) :: test
      type(error_type), allocatable :: error

      allocate (test%displacement, source=path)
      allocate (test%shear_stress(size(path)))
      allocate (test%normal_stress(size(path)), source=normal_stress)
      allocate (test%area(size(path)), source=disc)
      call shear_stress_along(values, test, test%shear_stress, error)
      call assertFalse(allocated(error), 'follows')
   end function test_at

   !> Add noise with a Gaussian distribution.
   subroutine add_noise(test, deviation, stream)
      type(shear_test), intent(inout) :: test
      real(wp), intent(in) :: deviation
      type(random_stream), intent(inout) :: stream
      integer :: i

      do i = 1, size(test%shear_stress)
         test%shear_stress(i) = test%shear_stress(i) + deviation*stream%gaussian()
      end do
   end subroutine add_noise

   !> Numbers of plain friction.
   pure function plain() result(values)
      real(wp) :: values(size(shear_names))

      values = 0.0_wp
      values(shear_friction_coefficient) = mu
      values(shear_critical_slip) = g
   end function plain

   !> Free numbers between 1/1000 and 1000 times their starts.
   function parameters_of(free, starts) result(parameters)
      integer, intent(in) :: free(:)
      real(wp), intent(in) :: starts(:)
      type(fit_parameter) :: parameters(size(free))
      integer :: i

      do i = 1, size(free)
         parameters(i)%name = shear_names(free(i))
         parameters(i)%unit = shear_units(free(i))
         parameters(i)%start = starts(i)
         parameters(i)%lower = 1.0e-3_wp*starts(i)
         parameters(i)%upper = 1.0e3_wp*starts(i)
         parameters(i)%by_ratio = .true.
      end do
   end function parameters_of

   !> Fit some tests.
   subroutine fit(tests, values, free, starts, result)
      type(shear_test), intent(in) :: tests(:)
      real(wp), intent(in) :: values(:), starts(:)
      integer, intent(in) :: free(:)
      type(fit_result), intent(out) :: result
      type(shear_problem) :: problem
      type(fit_parameter) :: parameters(size(free))
      type(error_type), allocatable :: error
      real(wp), allocatable :: scale(:)
      integer :: i, n

      n = sum([(size(tests(i)%displacement), i=1, size(tests))])
      allocate (scale(n), source=tests(1)%shear_stress(maxloc(tests(1)%shear_stress, 1)))
      call new_shear_problem(problem, tests, values, free, scale, error)
      call assertFalse(allocated(error), 'tests are followed')
      if (anyExceptions()) return
      parameters = parameters_of(free, starts)
      call fit_least_squares(problem, n, parameters, fit_settings(searches=4), result, error)
      if (allocated(error)) print '(a)', error%message
      call assertFalse(allocated(error), 'a minimum is found')
   end subroutine fit

   !> tau = mu p max(-1, min(1, gamma/gcrit)), whatever the path.
   subroutine test_closed_form()
      real(wp), parameter :: p = 0.1_wp
      real(wp), allocatable :: path(:)
      real(wp) :: gamma
      type(shear_test) :: test
      integer :: i

      call go_through([0.2_wp, 0.05_wp, 1.0_wp, -1.0_wp, 0.3_wp], 0.07_wp, path)
      test = test_at(plain(), path, p)
      gamma = 0.0_wp
      do i = 2, size(path)
         gamma = max(-g, min(g, gamma + path(i) - path(i - 1)))
         call assertEqual(mu*p*gamma/g, test%shear_stress(i), 1.0e-15_wp, 'shear stress')
      end do
      ! where the record's zero lies is of no matter
      test = test_at(plain(), path + 17.0_wp, p)
      call assertEqual(mu*p*gamma/g, test%shear_stress(size(path)), 1.0e-14_wp, 'from elsewhere')
   end subroutine test_closed_form

   !> At a constant normal stress a compliance C makes gcrit longer by C times the plateau's force.
   subroutine test_series()
      real(wp), parameter :: p = 0.1_wp, compliance = 2.0e-3_wp
      real(wp), allocatable :: path(:)
      real(wp) :: values(size(shear_names)), longer(size(shear_names))
      type(shear_test) :: test, other

      call go_through([1.5_wp, -1.0_wp, 0.8_wp], 0.05_wp, path)
      values = plain()
      longer = values
      values(shear_shear_compliance) = compliance
      longer(shear_critical_slip) = g + compliance*mu*p*disc
      test = test_at(values, path, p)
      other = test_at(longer, path, p)
      call assertEqual(other%shear_stress, test%shear_stress, 1.0e-12_wp*mu*p, 'series')
   end subroutine test_series

   !> One way out from rest: past the peak the stress falls with the slip s since then as
   !> mu_k + (mu_s - mu_k) exp(-s/decay), where s is the motion less what is left of elastic slip.
   subroutine test_rest()
      real(wp), parameter :: p = 0.2_wp, rest = 0.6_wp, decay = 0.4_wp
      real(wp) :: values(size(shear_names)), slip, gamma
      real(wp), allocatable :: path(:)
      type(shear_test) :: test
      integer :: i

      values = plain()
      values(shear_static_friction_coefficient) = rest
      values(shear_decay_slip) = decay
      call go_through([3.0_wp], 0.01_wp, path)
      test = test_at(values, path, p)
      do i = 1, size(path)
         gamma = test%shear_stress(i)*g/(rest*p)
         slip = path(i) - gamma
         if (path(i) < g) then
            call assertEqual(rest*p*path(i)/g, test%shear_stress(i), 1.0e-13_wp, 'sticks')
         else
            call assertEqual(p*(mu + (rest - mu)*exp(-slip/decay)), test%shear_stress(i), &
               1.0e-10_wp, 'slips')
         end if
      end do
   end subroutine test_rest

   !> Both numbers from starts that are ten to a hundred times too large and too small.
   subroutine test_far_start()
      real(wp), parameter :: factors(2, 4) = reshape([10.0_wp, 0.1_wp, 0.1_wp, 10.0_wp, 30.0_wp, &
         30.0_wp, 0.03_wp, 0.01_wp], [2, 4])
      real(wp), allocatable :: path(:)
      type(random_stream) :: stream
      type(shear_test) :: test
      type(fit_result) :: result
      integer :: i

      stream = random_stream(seed)
      call go_through([2.0_wp, -2.0_wp, 2.0_wp], 0.02_wp, path)
      test = test_at(plain(), path, 0.1_wp)
      call add_noise(test, 0.01_wp*mu*0.1_wp, stream)
      do i = 1, size(factors, 2)
         call fit([test], plain(), [shear_friction_coefficient, shear_critical_slip], &
            factors(:, i)*[mu, g], result)
         if (anyExceptions()) return
         call assert_found(result, [mu, g])
         call assertLessThan(maxval(result%standard_errors), 0.01_wp, 'and sharply')
      end do
   end subroutine test_far_start

   !> Values lie within four standard errors of what the record was made with.
   subroutine assert_found(result, truth)
      type(fit_result), intent(in) :: result
      real(wp), intent(in) :: truth(:)

      call assertLessThan(maxval(abs(log(result%values/truth))/result%standard_errors), 4.0_wp, &
         'within four standard errors')
   end subroutine assert_found

   !> At one normal stress only gcrit + C mu p A acts, which is said. At two both are found.
   subroutine test_machine()
      integer, parameter :: free(3) = [shear_friction_coefficient, shear_critical_slip, &
         shear_shear_compliance]
      real(wp), parameter :: compliance = 1.0e-3_wp
      real(wp) :: values(size(shear_names))
      real(wp), allocatable :: path(:)
      type(random_stream) :: stream
      type(shear_test) :: tests(2)
      type(fit_result) :: result
      type(shear_problem) :: problem
      type(error_type), allocatable :: error
      integer :: i

      stream = random_stream(seed + 1_int64)
      values = plain()
      values(shear_shear_compliance) = compliance
      call go_through([1.5_wp, -1.5_wp], 0.02_wp, path)
      do i = 1, 2
         tests(i) = test_at(values, path, 0.1_wp*i*i)
         call add_noise(tests(i), 1.0e-4_wp, stream)
      end do
      call fit(tests, plain(), free, [0.1_wp, 2.0_wp, 2.0e-4_wp], result)
      if (anyExceptions()) return
      call assert_found(result, [mu, g, compliance])
      call assertLessThan(maxval(result%direction_errors), 0.1_wp, 'two normal stresses tell')
      call new_shear_problem(problem, tests(:1), plain(), free, [1.0_wp], error)
      call assertTrue(allocated(error), 'one does not')
      if (.not. allocated(error)) return
      call assertTrue(index(error%message, 'cannot be told apart') > 0, error%message)
   end subroutine test_machine

   !> Coefficient at rest, decay and exponent of pressure besides.
   subroutine test_friction()
      integer, parameter :: free(5) = [shear_friction_coefficient, shear_critical_slip, &
         shear_static_friction_coefficient, shear_decay_slip, shear_pressure_exponent]
      real(wp), parameter :: truth(5) = [mu, g, 0.62_wp, 0.7_wp, 0.2_wp]
      real(wp) :: values(size(shear_names))
      real(wp), allocatable :: path(:)
      type(random_stream) :: stream
      type(shear_test) :: tests(2)
      type(fit_result) :: result
      integer :: i

      stream = random_stream(seed + 2_int64)
      values = 0.0_wp
      values(shear_reference_pressure) = 0.1_wp
      values(free) = truth
      call go_through([4.0_wp, -4.0_wp], 0.03_wp, path)
      do i = 1, 2
         tests(i) = test_at(values, path, 0.1_wp*i)
         call add_noise(tests(i), 5.0e-4_wp, stream)
      end do
      values(free) = 0.0_wp
      call fit(tests, values, free, [0.1_wp, 0.05_wp, 1.0_wp, 3.0_wp, 0.02_wp], result)
      if (anyExceptions()) return
      call assert_found(result, truth)
   end subroutine test_friction

   !> Where a sample lies just where the faces begin to slip, and noise is hardly more than
   !> rounding, the least sum of squares is on that kink: no slope says so, but no step leads lower.
   subroutine test_kink()
      real(wp), parameter :: truth(2) = [0.42_wp, 0.25_wp], rounded = 0.1_wp/2999.6_wp
      real(wp), allocatable :: path(:)
      real(wp) :: values(size(shear_names))
      type(shear_test) :: test
      type(fit_result) :: result

      values = 0.0_wp
      values([shear_friction_coefficient, shear_critical_slip]) = truth
      call go_through([1.0_wp, -1.0_wp], 0.02_wp, path)
      test = test_at(values, path, 0.1_wp)
      test%shear_stress = rounded*anint(test%shear_stress/rounded)
      call fit([test], plain(), [shear_friction_coefficient, shear_critical_slip], truth*[1.0_wp, &
         0.4_wp], result)
      if (anyExceptions()) return
      call assertEqual(truth, result%values, 1.0e-4_wp, 'found')
   end subroutine test_kink

   !> How often 95 % intervals hold the truth, with noise of 3 %.
   subroutine test_coverage()
      real(wp), parameter :: truth(2) = [mu, g]
      real(wp), allocatable :: path(:)
      type(random_stream) :: stream
      type(shear_test) :: clean, test
      type(fit_result) :: result
      integer :: i, held(2), n

      n = coverage_records()
      stream = random_stream(seed + 3_int64)
      call go_through([1.0_wp, -1.0_wp, 1.0_wp], 0.04_wp, path)
      clean = test_at(plain(), path, 0.1_wp)
      held = 0
      do i = 1, n
         test = clean
         call add_noise(test, 0.03_wp*mu*0.1_wp, stream)
         call fit([test], plain(), [shear_friction_coefficient, shear_critical_slip], &
            [0.1_wp, 1.0_wp], result)
         if (anyExceptions()) return
         where (truth >= result%lower .and. truth <= result%upper) held = held + 1
      end do
      print '(a, i0, a, i0, a, *(f6.2))', 'seed ', seed, ', ', n, ' records, % held:', &
         100.0_wp*held/n
      call assert_coverage(real(held, wp)/n, n)
   end subroutine test_coverage

   !> What no model can follow is named.
   subroutine test_refused()
      real(wp), allocatable :: path(:)
      type(shear_test) :: test, other

      call go_through([1.0_wp], 0.1_wp, path)
      test = test_at(plain(), path, 0.1_wp)
      other = test
      other%normal_stress(3) = -0.1_wp
      call assert_refused(other, plain(), 'compression positive')
      other = test
      other%displacement = 0.5_wp
      call assert_refused(other, plain(), 'does not move')
      other = test
      other%shear_stress = 0.0_wp
      call assert_refused(other, plain(), 'no shear stress')
      other = test
      deallocate (other%area)
      call assert_refused(other, plain() + [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
         0.0_wp, 1.0e-3_wp], 'no area')
      other%shear_stress = [1.0_wp]
      call assert_refused(other, plain(), 'two samples or more')
   end subroutine test_refused

   subroutine assert_refused(test, values, words)
      type(shear_test), intent(in) :: test
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: words
      type(shear_problem) :: problem
      type(error_type), allocatable :: error

      call new_shear_problem(problem, [test], values, [shear_friction_coefficient], &
         [1.0_wp], error)
      call assertTrue(allocated(error), words)
      if (.not. allocated(error)) return
      call assertTrue(index(error%message, words) > 0, error%message)
   end subroutine assert_refused

end module test_fit_shear
