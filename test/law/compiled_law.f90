!> The compiled law against the direct evaluation, 30-digit values and itself: no seams, the
!> stiffness is the derivative, scalar and batch forms agree, size.
module test_law_compiled_law
   use, intrinsic :: ieee_arithmetic, only: ieee_get_halting_mode, ieee_invalid, ieee_is_nan, &
      ieee_quiet_nan, ieee_set_halting_mode, ieee_value
   use asperity, only: compiled_law, error_type, evaluate_compiled_law, evaluate_normal_law, &
      new_compiled_law, normal_properties, normal_response, wp
   use asperity_law_gaussian_tail, only: vanishing_height
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertLessThan, &
      assertLessThanOrEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   use reference_table, only: read_reference, reference_row
   implicit none
   private
   public :: suite_compiled_law

   !> Number of intervals
   integer, parameter :: n_intervals = 221
   character(len=15), parameter :: names(5) = [character(len=15) :: 'pressure', 'stiffness', &
      'area_fraction', 'contact_density', 'energy']

contains

   function suite_compiled_law() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled law')
      call suite%addTest(TestMethod('a million points of 250 property sets', test_sweep))
      call suite%addTest(TestMethod('30-digit values', test_table))
      call suite%addTest(TestMethod('no seam at the ends of intervals', test_seams))
      call suite%addTest(TestMethod('stiffness is the derivative', test_derivative))
      call suite%addTest(TestMethod('pressure never rises with separation', test_monotone))
      call suite%addTest(TestMethod('scalar and batch are the same', test_batch))
      call suite%addTest(TestMethod('limits are flagged where the direct law does', test_validity))
      call suite%addTest(TestMethod('far out, far in, not a number', test_ends))
      call suite%addTest(TestMethod('size, and properties never built', test_construction))
   end function suite_compiled_law

   !> All quantities of the compiled law at one separation, in the order of `names`.
   subroutine evaluate(law, separation, values, validity)
      type(compiled_law), intent(in) :: law
      real(wp), intent(in) :: separation
      real(wp), intent(out) :: values(5)
      integer, intent(out), optional :: validity

      call evaluate_compiled_law(law, separation, values(1), values(2), values(3), values(4), &
         values(5), validity)
   end subroutine evaluate

   pure function direct_values(r) result(values)
      type(normal_response), intent(in) :: r
      real(wp) :: values(5)

      values = [r%pressure, r%stiffness, r%area_fraction, r%contact_density, r%energy]
   end function direct_values

   !> Random properties, w1/sigma from 1e-8 to 1e3, and random separations: -8 to 8 sigma, to 37
   !> sigma, and some outside, where the law is evaluated directly. 1e-10 and 1e-9 are demanded.
   subroutine test_sweep()
      integer, parameter :: seed = 314159, n_sets = 250, n_points = 4000
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: h, found(5), expected(5), worst(5, 3)
      integer :: i, j, range, differ, validity
      type(normal_response) :: r

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      differ = 0
      do i = 1, n_sets
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         call new_compiled_law(law, p, error)
         call assertFalse(allocated(error), 'built')
         do j = 1, n_points
            range = 1 + min(mod(j, 10)/7, 2)
            if (mod(j, 100) == 0) range = 3
            select case (range)
            case (1)
               h = stream%uniform(-8.0_wp, 8.0_wp)
            case (2)
               h = stream%uniform(8.0_wp, 37.0_wp)
            case default
               h = stream%uniform(-20.0_wp, -8.0_wp)
            end select
            r = evaluate_normal_law(p, h*p%sigma)
            expected = direct_values(r)
            call evaluate(law, h*p%sigma, found, validity)
            where (expected >= 1.0e-290_wp) worst(:, range) = &
               max(worst(:, range), abs(found/expected - 1.0_wp))
            if (validity /= r%validity) differ = differ + 1
         end do
      end do
      do j = 1, 5
         call record('compiled_law.'//trim(names(j))//'.to_8_sigma', worst(j, 1))
         call record('compiled_law.'//trim(names(j))//'.to_37_sigma', worst(j, 2))
         call assertLessThan(worst(j, 1), 1.0e-10_wp, trim(names(j))//', |h| <= 8')
         call assertLessThan(worst(j, 2), 1.0e-9_wp, trim(names(j))//', 8 < h <= 37')
         call assertLessThan(worst(j, 3), 1.0e-15_wp, trim(names(j))//', direct below h = -8')
      end do
      call assertEqual(0, differ, 'points where validity differs')
   end subroutine test_sweep

   !> The rows of test/data/normal_law_reference.csv between -8 and 37 sigma.
   subroutine test_table()
      type(reference_row), allocatable :: rows(:)
      character(len=:), allocatable :: message
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: h, found(5), worst
      integer :: i, n

      call read_reference(rows, message)
      call assertEqual('', message)
      worst = 0.0_wp
      n = 0
      do i = 1, size(rows)
         h = rows(i)%separation/rows(i)%properties%sigma
         if (abs(h) > 8.0_wp) cycle
         call new_compiled_law(law, rows(i)%properties, error)
         call evaluate(law, rows(i)%separation, found)
         call worsen(worst, largest_of(found/rows(i)%values(:5) - 1.0_wp))
         n = n + 1
      end do
      call assertTrue(n > 100, 'rows within 8 sigma')
      call record('compiled_law.reference.relative_error', worst)
      call assertLessThan(worst, 1.0e-10_wp, 'relative error')
   end subroutine test_table

   !> Over four roundings of h about each end of an interval, the law may change by its slope and by
   !> round-off, which is h^2 eps, and by no more; at -8 and 38 it meets the direct evaluation.
   subroutine test_seams()
      integer, parameter :: seed = 17
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: h, step, below(5), above(5), worst(5), slope
      integer :: i, j

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      do i = 1, 30
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         call new_compiled_law(law, p, error)
         do j = 0, 2*n_intervals, 2
            h = place(j)
            step = 2.0_wp*spacing(max(1.0_wp, abs(h)))
            call evaluate(law, (h - step)*p%sigma, below)
            call evaluate(law, (h + step)*p%sigma, above)
            if (below(1) < 1.0e-290_wp) exit
            ! each quantity falls by about max(h, 1) times itself a sigma, squared for the noise
            slope = 16.0_wp*max(h, 1.0_wp)*step + 4.0_wp*epsilon(h)*(1.0_wp + h*h)
            call worsen(worst, abs(above/below - 1.0_wp) - slope)
         end do
      end do
      call record('compiled_law.seam.pressure', max(worst(1), 0.0_wp))
      call record('compiled_law.seam.stiffness', max(worst(2), 0.0_wp))
      call assertLessThan(worst(1), 2.0e-12_wp, 'pressure')
      call assertLessThan(worst(2), 5.0e-12_wp, 'stiffness')
      call assertLessThan(largest_of(worst(3:)), 2.0e-12_wp, 'area, density, energy')
   end subroutine test_seams

   !> End (even j) or middle (odd j) of the intervals, counted by halves from -8: five a sigma to 2,
   !> twenty-one to 8, one and a half to 38.
   pure real(wp) function place(j)
      integer, intent(in) :: j

      if (j <= 100) then
         place = -8.0_wp + 0.1_wp*j
      else if (j <= 352) then
         place = 2.0_wp + (j - 100)/42.0_wp
      else
         place = 8.0_wp + (j - 352)/3.0_wp
      end if
   end function place

   !> Within an interval the pressure is a polynomial of degree seven, whose derivative the central
   !> differences of eighth order give exactly: only round-off is left. Beyond 8 sigma the factor
   !> exp(-h^2/2) asks for small steps, and round-off is larger. Energy falls by pressure.
   subroutine test_derivative()
      real(wp), parameter :: weights(4) = [0.8_wp, -0.2_wp, 4.0_wp/105.0_wp, -1.0_wp/280.0_wp]
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: h, step, ahead(5), behind(5), here(5), slopes(5), worst, worst_far, worst_energy
      integer :: i, k

      p = normal_of_pair('transverse-tangential')
      call new_compiled_law(law, p, error)
      worst = 0.0_wp
      worst_far = 0.0_wp
      worst_energy = 0.0_wp
      do i = 1, 2*n_intervals - 1, 2
         h = place(i)
         step = p%sigma/merge(240.0_wp, 500.0_wp, h < 8.0_wp)
         if (h > 37.0_wp) exit
         call evaluate(law, h*p%sigma, here)
         slopes = 0.0_wp
         do k = 1, 4
            call evaluate(law, h*p%sigma + k*step, ahead)
            call evaluate(law, h*p%sigma - k*step, behind)
            slopes = slopes + weights(k)*(behind - ahead)/step
         end do
         if (h < 8.0_wp) then
            call worsen(worst, abs(slopes(1)/here(2) - 1.0_wp))
         else
            call worsen(worst_far, abs(slopes(1)/here(2) - 1.0_wp))
         end if
         call worsen(worst_energy, abs(slopes(5)/here(1) - 1.0_wp))
      end do
      call record('compiled_law.stiffness.derivative', worst)
      call assertLessThan(worst, 2.0e-12_wp, 'to 8 sigma')
      call assertLessThan(worst_far, 1.0e-9_wp, 'beyond')
      call assertLessThan(worst_energy, 1.0e-9_wp, 'energy falls by pressure')
   end subroutine test_derivative

   !> Over steps of 1e-4 sigma, far above round-off, and positive stiffness everywhere.
   subroutine test_monotone()
      integer, parameter :: seed = 99
      type(random_stream) :: stream
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: pressure, stiffness, previous
      integer :: i, j, rising

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      rising = 0
      do i = 1, 10
         call random_properties(stream, p, 1.0e-8_wp, 1.0e3_wp, 0.05_wp)
         call new_compiled_law(law, p, error)
         previous = huge(previous)
         do j = -82000, 90000, 7
            call evaluate_compiled_law(law, 1.0e-4_wp*j*p%sigma, pressure, stiffness)
            if (.not. (pressure < previous .and. stiffness > 0.0_wp)) rising = rising + 1
            previous = pressure
         end do
      end do
      call assertEqual(0, rising, 'points')
   end subroutine test_monotone

   !> The batch has the same numbers, to the bit, in any order and for any size.
   subroutine test_batch()
      integer, parameter :: seed = 5, n = 1001
      type(random_stream) :: stream
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      real(wp) :: separation(n), pressure(n), stiffness(n), one, other
      integer :: i, m

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      associate (p => normal_of_pair('tangential-tangential'))
         call new_compiled_law(law, p, error)
         do i = 1, n
            separation(i) = p%sigma*stream%uniform(-12.0_wp, 45.0_wp)
         end do
      end associate
      do m = 0, n, 143
         pressure = -1.0_wp
         stiffness = -1.0_wp
         call evaluate_compiled_law(law, separation(:m), pressure(:m), stiffness(:m))
         do i = 1, m
            call evaluate_compiled_law(law, separation(i), one, other)
            call assertTrue(abs(pressure(i) - one) <= 0.0_wp, 'pressure')
            call assertTrue(abs(stiffness(i) - other) <= 0.0_wp, 'stiffness')
         end do
         call assertTrue(all(pressure(m + 1:) < 0.0_wp), 'nothing beyond is written')
      end do
   end subroutine test_batch

   !> Wood: real area above nominal below 0.91 sigma, and the other two limits; both laws agree at
   !> all but the last digits of the limit.
   subroutine test_validity()
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      type(normal_response) :: r
      real(wp) :: values(5), d
      integer :: i, validity, seen

      p = normal_of_pair('transverse-tangential')
      call new_compiled_law(law, p, error)
      seen = 0
      do i = -3000, 10000
         d = 1.0e-3_wp*i*p%sigma
         r = evaluate_normal_law(p, d)
         call evaluate(law, d, values, validity)
         call assertEqual(r%validity, validity, 'flags')
         seen = ior(seen, validity)
      end do
      call assertEqual(7, seen, 'the three limits were passed')
   end subroutine test_validity

   !> Zero beyond 39 sigma, the direct evaluation far in, and for what is not a number the same,
   !> without an index out of bounds.
   subroutine test_ends()
      type(normal_properties) :: p
      type(compiled_law) :: law
      type(error_type), allocatable :: error
      type(normal_response) :: r
      real(wp) :: values(5), beyond(3), bad
      integer :: i, validity
      logical :: halts

      p = normal_of_pair('transverse-tangential')
      call new_compiled_law(law, p, error)
      beyond = [vanishing_height*p%sigma*1.001_wp, 1.0e10_wp, 1.0e36_wp]
      do i = 1, 3
         call evaluate(law, beyond(i), values, validity)
         call assertLessThanOrEqual(largest_of(values), 0.0_wp, 'nothing touches')
         call assertEqual(p%validity, validity, 'valid')
         call evaluate(law, -1.0e3_wp*i*p%sigma, values)
         call assertRelativelyEqual(direct_values(evaluate_normal_law(p, -1.0e3_wp*i*p%sigma)), &
            values, 1.0e-15_wp, 'far in')
      end do
      ! a comparison with what is not a number would end a build that traps invalid operations
      call ieee_get_halting_mode(ieee_invalid, halts)
      call ieee_set_halting_mode(ieee_invalid, .false.)
      bad = ieee_value(bad, ieee_quiet_nan)
      call evaluate_compiled_law(law, bad, values(1), values(2))
      call assertTrue(ieee_is_nan(values(1)), 'not a number')
      r = evaluate_normal_law(p, bad)
      call assertTrue(ieee_is_nan(r%pressure), 'not a number, directly')
      call ieee_set_halting_mode(ieee_invalid, halts)
   end subroutine test_ends

   !> Below 64 KiB, without allocatable parts that storage_size would miss.
   subroutine test_construction()
      type(compiled_law) :: law
      type(normal_properties) :: never_built
      type(error_type), allocatable :: error

      call record('compiled_law.bytes', real(storage_size(law)/8, wp))
      call assertTrue(storage_size(law)/8 <= 65536, 'bytes')
      call new_compiled_law(law, never_built, error)
      call assertTrue(allocated(error), 'refused')
      call assertTrue(index(error%message, 'new_normal_properties') > 0, error%message)
   end subroutine test_construction

end module test_law_compiled_law
