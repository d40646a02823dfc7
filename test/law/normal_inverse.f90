!> The inverse of the normal law: round trips, exact pairs, no failure, errors.
module test_law_normal_inverse
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use asperity_base_error, only: error_type, input_error
   use asperity_base_kinds, only: wp
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertFail, assertFalse, assertGreaterThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   use reference_table, only: read_reference, reference_row
   implicit none
   private
   public :: suite_normal_inverse

   real(wp), parameter :: eps = epsilon(1.0_wp)

contains

   function suite_normal_inverse() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('normal inverse')
      call suite%addTest(TestMethod('round trip', test_round_trip))
      call suite%addTest(TestMethod('30-digit pressures', test_exact))
      call suite%addTest(TestMethod('never fails', test_never_fails))
      call suite%addTest(TestMethod('smallest and largest pressures', test_extremes))
      call suite%addTest(TestMethod('falls with pressure', test_monotone))
      call suite%addTest(TestMethod('refuses what has no separation', test_refused))
   end function suite_normal_inverse

   !> d(p(d)) over the whole range of properties and h from -40 to 37. The error holds the
   !> round-off of two evaluations, at d and at the separation found.
   subroutine test_round_trip()
      integer, parameter :: seed = 4, n_cases = 50000
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: d, back, error_in_eps, worst, at_h
      integer :: i, n_tried

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      at_h = 0.0_wp
      n_tried = 0
      do i = 1, n_cases
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         d = p%sigma*stream%uniform(-40.0_wp, 37.0_wp)
         r = evaluate_normal_law(p, d)
         if (r%pressure < tiny(1.0_wp)) cycle
         n_tried = n_tried + 1
         call separation_for_pressure(p, r%pressure, back, error)
         if (allocated(error)) then
            call assertFail(error%message)
            return
         end if
         error_in_eps = abs(back - d)/(eps*max(p%sigma, abs(d)))
         if (error_in_eps > worst) then
            worst = error_in_eps
            at_h = d/p%sigma
         end if
      end do
      call record('normal_inverse.round_trip.eps', worst)
      call record('normal_inverse.round_trip.worst_h', at_h)
      call assertGreaterThan(n_tried, 49000, message='cases tried')
      call assertLessThanOrEqual(worst, 4.0_wp, 'error in eps max(sigma, |d|)')
   end subroutine test_round_trip

   !> The separation of the exact pressures of the reference table.
   subroutine test_exact()
      type(reference_row), allocatable :: rows(:)
      character(len=:), allocatable :: message
      type(error_type), allocatable :: error
      real(wp) :: d, worst
      integer :: i

      call read_reference(rows, message)
      call assertEqual('', message)
      worst = 0.0_wp
      do i = 1, size(rows)
         associate (row => rows(i))
            if (row%values(1) < tiny(1.0_wp)) cycle
            call separation_for_pressure(row%properties, row%values(1), d, error)
            call assertFalse(allocated(error))
            call worsen(worst, abs(d - row%separation)/ &
               (eps*max(row%properties%sigma, abs(row%separation))))
         end associate
      end do
      call record('normal_inverse.exact_pressure.eps', worst)
      call assertLessThanOrEqual(worst, 4.0_wp, 'error in eps max(sigma, |d|)')
   end subroutine test_exact

   !> Any pressure from 1e-300 to 1e6 of eta R H sigma, far past p(-40 sigma) at both ends, has a
   !> separation that gives the pressure back: the mismatch over the stiffness is as in the round
   !> trip.
   subroutine test_never_fails()
      integer, parameter :: n_cases = 10000
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(normal_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: pressure, d, worst
      integer :: i

      stream = random_stream(32)
      worst = 0.0_wp
      do i = 1, n_cases
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         pressure = p%eta*p%radius*p%hardness*p%sigma &
            *exp(stream%uniform(log(1.0e-300_wp), log(1.0e6_wp)))
         call separation_for_pressure(p, pressure, d, error)
         call assertFalse(allocated(error), 'refused')
         r = evaluate_normal_law(p, d)
         call worsen(worst, abs(r%pressure - pressure)/r%stiffness/(eps*max(p%sigma, abs(d))))
         if (anyExceptions()) return
      end do
      call record('normal_inverse.mismatch.eps', worst)
      call assertLessThanOrEqual(worst, 4.0_wp, 'mismatch in eps max(sigma, |d|)')
   end subroutine test_never_fails

   !> The smallest pressure that is a normal number, and one of 1e90 MPa, where p = 2 pi eta R H |d|
   !> holds to round-off.
   subroutine test_extremes()
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: d

      p = normal_of_pair('transverse-tangential')
      call separation_for_pressure(p, tiny(1.0_wp), d, error)
      call assertFalse(allocated(error))
      ! phi(37) = 1e-298, phi(38) = 1e-314
      call assertTrue(d/p%sigma > 37.0_wp .and. d/p%sigma < 38.0_wp, 'smallest pressure')
      call separation_for_pressure(p, 1.0e90_wp, d, error)
      call assertFalse(allocated(error))
      call assertRelativelyEqual(1.0e90_wp, &
         -d*8.0_wp*atan(1.0_wp)*p%eta*p%radius*p%hardness, 1.0e-14_wp, '1e90 MPa')
   end subroutine test_extremes

   !> Two pressures at least 1e-12 apart, relatively: the higher one has the smaller separation.
   subroutine test_monotone()
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: pressure, d, nearer
      integer :: i, n_bad

      stream = random_stream(33)
      n_bad = 0
      do i = 1, 2000
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         pressure = p%eta*p%radius*p%hardness*p%sigma*stream%log_uniform(1.0e-6_wp, 100.0_wp)
         call separation_for_pressure(p, pressure, d, error)
         pressure = pressure*(1.0_wp + stream%log_uniform(1.0e-12_wp, 1.0_wp))
         call separation_for_pressure(p, pressure, nearer, error)
         if (.not. nearer <= d) n_bad = n_bad + 1
      end do
      call assertEqual(0, n_bad, 'pairs with a rising separation')
   end subroutine test_monotone

   subroutine test_refused()
      call check_refused(0.0_wp, 'pressure = 0')
      call check_refused(-1.0_wp, 'pressure = -1')
      call check_refused(ieee_value(1.0_wp, ieee_quiet_nan), 'pressure = NaN')
      call check_refused(ieee_value(1.0_wp, ieee_positive_inf), 'pressure = Infinity')
      call check_refused(huge(1.0_wp), 'pressure = 1.7976931348623157E308')
      call check_refused(0.5_wp*tiny(1.0_wp), 'pressure = 1.1125369292536007E-308')
   end subroutine test_refused

   !> The message names the pressure and its value.
   subroutine check_refused(pressure, begin)
      real(wp), intent(in) :: pressure
      character(len=*), intent(in) :: begin
      type(error_type), allocatable :: error
      real(wp) :: d

      call separation_for_pressure(normal_of_pair('transverse-tangential'), pressure, d, error)
      call assertTrue(allocated(error), begin//' is refused')
      if (.not. allocated(error)) return
      call assertEqual(input_error, error%category)
      call assertEqual(begin, error%message(:min(len(begin), len(error%message))))
      call assertEqual('pressure', error%subject)
   end subroutine check_refused

end module test_law_normal_inverse
