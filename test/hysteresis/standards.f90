!> What EN 12512, EN 26891, ASTM E2126 and EN 14358 make of records, against formulas.
module test_hysteresis_standards
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use asperity_hysteresis_characteristic_values, only: characteristic_values, tolerance_factor
   use asperity_hysteresis_en_12512, only: ductility_class
   use funit, only: assertEqual, assertRelativelyEqual, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: record_type
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_standards

   !> Round-off of a few products
   real(wp), parameter :: exact = 1.0e-12_wp

contains

   function suite_hysteresis_standards() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis standards')
      call suite%addTest(TestMethod('EN 12512: yield by the tangent', test_tangent))
      call suite%addTest(TestMethod('EN 12512: yield by two lines', test_two_lines))
      call suite%addTest(TestMethod('EN 12512: two lines that are not clear', test_unclear))
      call suite%addTest(TestMethod('EN 12512: slopes of two lines', test_slopes))
      call suite%addTest(TestMethod('EN 12512: what ends the skeleton', test_ultimate))
      call suite%addTest(TestMethod('EN 12512: impairment of strength', test_impairment))
      call suite%addTest(TestMethod('EN 12512: classes of ductility', test_classes))
      call suite%addTest(TestMethod('EN 26891: slips and moduli', test_slips))
      call suite%addTest(TestMethod('EN 26891: what is no such unloading', test_unloadings))
      call suite%addTest(TestMethod('EN 26891: 15 mm and the estimated force', test_estimated))
      call suite%addTest(TestMethod('EN 14358: tolerance factors', test_factors))
      call suite%addTest(TestMethod('EN 14358: fractiles', test_fractiles))
   end function suite_hysteresis_standards

   !> A record to a side.
   pure type(record_type) function mirrored(displacement, force, side) result(record)
      real(wp), intent(in) :: displacement(:), force(:)
      integer, intent(in) :: side

      allocate (record%displacement, source=displacement)
      allocate (record%force, source=force)
      if (side == 1) return
      record%displacement(:) = -displacement
      record%force(:) = -force
   end function mirrored

   !> Slopes 6, 2 and 0.5: the tangent of slope 1 touches at (3, 10), F = 7 + x, and meets 6 x at
   !> (1.4, 8.4). The same to the other side. An exponential curve by its formula.
   subroutine test_tangent()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp) :: peak, first, second, slope, touch, above, yield
      integer :: i, n, side
      real(wp), parameter :: length = 2.0_wp, force = 10.0_wp, end_at = 8.0_wp

      do side = 1, 2
         loops = mirrored([0.0_wp, 1.0_wp, 3.0_wp, 9.0_wp], [0.0_wp, 6.0_wp, 10.0_wp, 13.0_wp], &
            side)
         call analyse(loops, result)
         associate (e => result%skeleton(side)%en_12512)
            call assertEqual(merge(1, -1, side == 1)*[1.4_wp, 8.4_wp], &
               [e%tangent_displacement, e%tangent_force], exact, 'trilinear')
            call assertEqual('tangent', e%yield_method, 'no two lines')
            call assertEqual(9.0_wp/1.4_wp, e%ductility, exact, 'ductility')
         end associate
      end do
      n = 4000
      loops%displacement = [(end_at*i/n, i=0, n)]
      loops%force = force*(1.0_wp - exp(-loops%displacement/length))
      call analyse(loops, result)
      peak = loops%force(n + 1)
      first = -length*log(1.0_wp - 0.1_wp*peak/force)
      second = -length*log(1.0_wp - 0.4_wp*peak/force)
      slope = 0.3_wp*peak/(second - first)
      touch = -length*log(slope/6.0_wp*length/force)
      above = force*(1.0_wp - exp(-touch/length)) - slope/6.0_wp*touch
      yield = (above - 0.1_wp*peak + slope*first)/(slope*5.0_wp/6.0_wp)
      associate (e => result%skeleton(1)%en_12512)
         ! samples 0.002 apart
         call assertEqual(yield, e%tangent_displacement, 2.0e-6_wp, 'exponential curve')
         call assertEqual(end_at/yield, e%ductility, 5.0e-6_wp, 'its ductility')
      end associate
      ! stiffening: the tangent lies beyond the peak
      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp]
      loops%force = [0.0_wp, 4.5_wp, 10.0_wp]
      call analyse(loops, result)
      call assertEqual(none, result%skeleton(1)%en_12512%tangent_displacement, 0.0_wp, 'no yield')
      call assertEqual(none, result%skeleton(1)%en_12512%ductility, 0.0_wp, 'no ductility')
   end subroutine test_tangent

   !> Straight to (1, 6) and straight to (9, 10): they meet there, wherever samples lie, with slack
   !> before and noise on it.
   subroutine test_two_lines()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      integer :: i

      loops%displacement = [0.0_wp, 1.0_wp, 9.0_wp]
      loops%force = [0.0_wp, 6.0_wp, 10.0_wp]
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual([1.0_wp, 6.0_wp], [e%two_lines_displacement, e%two_lines_force], &
            10.0_wp*exact, 'where they meet')
         call assertEqual('two_lines', e%yield_method, 'two clear lines')
         call assertEqual(9.0_wp, e%ductility, 100.0_wp*exact, 'ductility')
      end associate
      ! a plateau, after slack of 0.5
      loops%displacement = [0.0_wp, 0.5_wp, 1.5_wp, 4.0_wp]
      loops%force = [0.0_wp, 0.0_wp, 10.0_wp, 10.0_wp]
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual([1.5_wp, 10.0_wp], [e%two_lines_displacement, e%two_lines_force], &
            100.0_wp*exact, 'after slack')
      end associate
      stream%state = 20261130
      write (*, '(5x, a, i0)') 'seed ', stream%state
      loops%displacement = [(0.01_wp*i, i=0, 900)]
      loops%force = min(6.0_wp*loops%displacement, 5.5_wp + 0.5_wp*loops%displacement)
      do i = 2, size(loops%force)
         loops%force(i) = loops%force(i) + stream%uniform(-0.05_wp, 0.05_wp)
      end do
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual(1.0_wp, e%two_lines_displacement, 0.03_wp, 'in noise')
         call assertEqual(6.0_wp, e%two_lines_force, 0.1_wp, 'force in noise')
      end associate
   end subroutine test_two_lines

   !> A curve that bends all the way, and one of three straight parts, have no two clear lines; nor
   !> has one straight line.
   subroutine test_unclear()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: i

      loops%displacement = [(0.01_wp*i, i=0, 100)]
      loops%force = 1.0_wp - (1.0_wp - loops%displacement)**2
      call analyse(loops, result)
      call assertEqual(none, result%skeleton(1)%en_12512%two_lines_force, 0.0_wp, 'a parabola')
      loops%force = 1.0_wp - exp(-5.0_wp*loops%displacement)
      call analyse(loops, result)
      call assertEqual(none, result%skeleton(1)%en_12512%two_lines_force, 0.0_wp, 'exponential')
      loops%force = loops%displacement
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual(none, e%two_lines_force, 0.0_wp, 'straight')
         call assertEqual([1.0_wp, 1.0_wp], [e%tangent_displacement, e%ductility], exact, &
            'yields at its end')
      end associate
   end subroutine test_unclear

   !> Two straight lines count if the second has half the slope of the first, not if it has more.
   subroutine test_slopes()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp]
      loops%force = [0.0_wp, 10.0_wp, 14.9_wp]
      call analyse(loops, result)
      call assertEqual(1.0_wp, result%skeleton(1)%en_12512%two_lines_displacement, 1.0e-9_wp, &
         'less than half')
      loops%force = [0.0_wp, 10.0_wp, 15.1_wp]
      call analyse(loops, result)
      call assertEqual(none, result%skeleton(1)%en_12512%two_lines_displacement, 0.0_wp, 'more')
   end subroutine test_slopes

   !> Low below 4, medium from 4, high from 6.
   subroutine test_classes()
      call assertEqual('low', ductility_class(3.999_wp), 'below 4')
      call assertEqual('medium', ductility_class(4.0_wp), 'from 4')
      call assertEqual('medium', ductility_class(5.999_wp), 'below 6')
      call assertEqual('high', ductility_class(6.0_wp), 'from 6')
      call assertEqual('', ductility_class(none), 'not known')
   end subroutine test_classes

   !> Back to 0.14, 0.16, 0.34 or 0.36 of the force, and from 0.14 or 0.16 of the largest one.
   subroutine test_unloadings()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: left(4) = [0.14_wp, 0.16_wp, 0.34_wp, 0.36_wp]
      logical, parameter :: counts(4) = [.false., .true., .true., .false.]
      integer :: i

      allocate (loops%displacement, source=[0.0_wp, 0.5_wp, 0.3_wp, 0.5_wp, 2.0_wp])
      allocate (loops%force(size(loops%displacement)))
      do i = 1, size(left)
         loops%force = [0.0_wp, 4.0_wp, 4.0_wp*left(i), 4.0_wp, 10.0_wp]
         call analyse(loops, result)
         call assertEqual(trim(merge('unloading ', 'peak_force', counts(i))), &
            trim(result%en_26891%estimated_by), 'what is left')
      end do
      do i = 1, 2
         loops%force = [0.0_wp, left(i)*10.0_wp, 2.5_wp*left(i), left(i)*10.0_wp, 10.0_wp]
         call analyse(loops, result)
         call assertEqual(trim(merge('unloading ', 'peak_force', counts(i))), &
            trim(result%en_26891%estimated_by), 'from where')
      end do
   end subroutine test_unloadings

   !> 0.8 of the peak at 35 mm, 30 mm before it, or the end; in mm, in m, and where it is not known.
   subroutine test_ultimate()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 2.0_wp, 25.0_wp, 45.0_wp]
      loops%force = [0.0_wp, 6.0_wp, 10.0_wp, 6.0_wp]
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual('force', e%ultimate_reason, '0.8 of the peak')
         call assertEqual([35.0_wp, 8.0_wp], [e%ultimate_displacement, e%ultimate_force], &
            100.0_wp*exact, 'at 35')
      end associate
      call analyse(loops, result, hysteresis_settings(millimetre=1.0_wp))
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual('limit', e%ultimate_reason, '30 mm')
         call assertEqual([30.0_wp, 9.0_wp], [e%ultimate_displacement, e%ultimate_force], &
            100.0_wp*exact, 'at 30')
      end associate
      loops%displacement = 1.0e-3_wp*loops%displacement
      call analyse(loops, result, hysteresis_settings(millimetre=1.0e-3_wp))
      call assertEqual(30.0e-3_wp, result%skeleton(1)%en_12512%ultimate_displacement, exact, 'in m')
      ! a peak beyond 30 mm does not count
      loops%displacement = [0.0_wp, 20.0_wp, 40.0_wp]
      loops%force = [0.0_wp, 8.0_wp, 10.0_wp]
      call analyse(loops, result, hysteresis_settings(millimetre=1.0_wp))
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual([30.0_wp, 9.0_wp], [e%peak_displacement, e%peak_force], exact, 'peak')
      end associate
      call analyse(loops, result)
      call assertEqual('end', result%skeleton(1)%en_12512%ultimate_reason, 'its last point')
      call assertEqual(10.0_wp, result%skeleton(1)%peak_force, 0.0_wp, 'E2126 is without limit')
   end subroutine test_ultimate

   !> Three cycles of 1, two of 2 and four of 3, whose forces fall by a tenth and by a quarter each
   !> time; a smaller one between them is none of them.
   subroutine test_impairment()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp, 2.0_wp, &
         -2.0_wp, 1.5_wp, -1.5_wp, 2.0_wp, -2.0_wp, 3.0_wp, -3.0_wp, 3.0_wp, -3.0_wp, 3.0_wp, &
         -3.0_wp, 3.0_wp, -3.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -10.0_wp, 9.0_wp, -10.0_wp, 8.1_wp, -10.0_wp, 12.0_wp, &
         -12.0_wp, 6.0_wp, -6.0_wp, 11.0_wp, -11.0_wp, 13.0_wp, -16.0_wp, 12.0_wp, -12.0_wp, &
         11.0_wp, -9.0_wp, 10.0_wp, -6.75_wp, 0.0_wp]
      call analyse(loops, result)
      associate (a => result%amplitudes)
         call assertEqual([1, 1, 1, 2, 2, 2], a%side, 'sides')
         call assertEqual([3, 2, 4, 3, 2, 4], a%cycles, 'cycles of each amplitude')
         call assertEqual([7, 8, 9], a(3)%cycle, 'which')
         call assertEqual([1.0_wp - 8.1_wp/10.0_wp, none, 1.0_wp - 11.0_wp/13.0_wp, 0.0_wp, none, &
            7.0_wp/16.0_wp], a%impairment, exact, 'impairment')
         call assertEqual([-3.0_wp, -3.0_wp, -3.0_wp], a(6)%displacement, 0.0_wp, 'displacement')
         call assertEqual([-16.0_wp, -12.0_wp, -9.0_wp], a(6)%force, 0.0_wp, 'forces')
         call assertEqual([4, 6, 0], a(2)%cycle, 'no third one')
      end associate
      ! held at 3, the ultimate point, on the positive side, and at 1, a third of it, on the other
      associate (e => result%skeleton%en_12512)
         call assertEqual(e(1)%ductility, e(1)%three_cycle_ductility, exact, 'positive')
         call assertEqual(e(2)%ductility/3.0_wp, e(2)%three_cycle_ductility, exact, 'negative')
      end associate
      ! three equal cycles of 3 past the ultimate point, 8 of 10 at 1.5, do not count
      loops%displacement = [0.0_wp, 1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp, 3.0_wp, &
         -3.0_wp, 3.0_wp, -3.0_wp, 3.0_wp, -3.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -10.0_wp, 10.0_wp, -10.0_wp, 10.0_wp, -10.0_wp, 2.0_wp, &
         -2.0_wp, 2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 0.0_wp]
      call analyse(loops, result)
      associate (e => result%skeleton(1)%en_12512)
         call assertEqual(1.5_wp, e%ultimate_displacement, exact, 'ultimate point')
         call assertEqual(e%ductility/1.5_wp, e%three_cycle_ductility, exact, 'only up to there')
      end associate
   end subroutine test_impairment

   !> 10 x to 4 kN, back to 1 kN and up again along a slope of 20, on to 7 kN at 1 mm, to 10 kN at 4
   !> mm: F_est = 10, v_01 = 0.1, v_04 = v_14 = 0.4 = v_24, v_11 = v_21 = 0.25. A hold of 0.05 at
   !> the top and of 0.02 at the bottom moves v_14, v_11, v_21, v_24.
   subroutine test_slips()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: side, s

      do side = 1, 2
         s = merge(1, -1, side == 1)
         loops = mirrored([0.0_wp, 0.4_wp, 0.25_wp, 0.4_wp, 1.0_wp, 4.0_wp], &
            [0.0_wp, 4.0_wp, 1.0_wp, 4.0_wp, 7.0_wp, 10.0_wp], side)
         call analyse(loops, result)
         associate (e => result%en_26891)
            call assertEqual('unloading', e%estimated_by, 'from 0.4 to 0.1')
            call assertEqual(s*10.0_wp, e%estimated_force, exact, 'F_est')
            call assertEqual(s*[0.1_wp, 0.4_wp, 0.4_wp, 0.0_wp], [e%slip_at_10_percent, &
               e%initial_slip, e%modified_initial_slip, e%joint_settlement], 1.0e-9_wp, 'slips')
            call assertEqual([10.0_wp, 10.0_wp], [e%initial_slip_modulus, e%slip_modulus], &
               1.0e-7_wp, 'moduli')
            call assertEqual(s*2.0_wp/3.0_wp*0.3_wp, e%elastic_slip, 1.0e-9_wp, 'elastic slip')
            call assertEqual(s*[0.8_wp, 2.0_wp], [e%slip_at_60_percent, &
               e%slip_at_80_percent], 1.0e-8_wp, 'at 0.6 and 0.8')
            call assertEqual(s*[0.8_wp, 2.0_wp], [e%modified_slip_at_60_percent, &
               e%modified_slip_at_80_percent], 1.0e-8_wp, 'less v_24, with v_i,mod')
         end associate
      end do
      loops%displacement = [0.0_wp, 0.05_wp, 0.45_wp, 0.5_wp, 0.35_wp, 0.37_wp, 0.52_wp, 1.0_wp, &
         4.0_wp]
      loops%force = [0.0_wp, 0.0_wp, 4.0_wp, 4.0_wp, 1.0_wp, 1.0_wp, 4.0_wp, 7.0_wp, 10.0_wp]
      call analyse(loops, result)
      associate (e => result%en_26891)
         call assertEqual([0.15_wp, 0.45_wp, 0.4_wp, 0.05_wp], [e%slip_at_10_percent, &
            e%initial_slip, e%modified_initial_slip, e%joint_settlement], 1.0e-8_wp, 'after slack')
         call assertEqual(2.0_wp/3.0_wp*(0.5_wp + 0.52_wp - 0.35_wp - 0.37_wp), e%elastic_slip, &
            1.0e-8_wp, 'with holds')
         call assertEqual([4.0_wp/0.45_wp, 10.0_wp], [e%initial_slip_modulus, e%slip_modulus], &
            1.0e-6_wp, 'moduli')
         call assertEqual(e%slip_at_60_percent - 0.52_wp + 0.4_wp, e%modified_slip_at_60_percent, &
            1.0e-8_wp, 'modified slip')
      end associate
   end subroutine test_slips

   !> The largest force up to 15 mm; an estimate that is given, found, or not to be had.
   subroutine test_estimated()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, 10.0_wp, 20.0_wp]
      loops%force = [0.0_wp, 5.0_wp, 8.0_wp, 10.0_wp]
      call analyse(loops, result)
      associate (e => result%en_26891)
         call assertEqual([20.0_wp, 10.0_wp], [e%peak_displacement, e%peak_force], exact, 'peak')
         call assertEqual('peak_force', e%estimated_by, 'as there is no unloading')
         call assertEqual([0.2_wp, 0.8_wp], [e%slip_at_10_percent, e%initial_slip], 1.0e-8_wp, &
            'slips')
         call assertTrue(is_none(e%elastic_slip) .and. is_none(e%modified_slip_at_60_percent), &
            'nor these')
      end associate
      call analyse(loops, result, hysteresis_settings(millimetre=1.0_wp, estimated_force=5.0_wp))
      associate (e => result%en_26891)
         call assertEqual([15.0_wp, 9.0_wp], [e%peak_displacement, e%peak_force], exact, '15 mm')
         call assertEqual('given', e%estimated_by, 'as given')
         call assertEqual([0.1_wp, 0.4_wp], [e%slip_at_10_percent, e%initial_slip], 1.0e-8_wp, &
            'slips')
      end associate
      call analyse(loops, result, hysteresis_settings(estimated_force=50.0_wp))
      call assertEqual(none, result%en_26891%slip_modulus, 0.0_wp, 'never loaded so far')
      ! a cyclic record is no such test
      loops%displacement = [0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp]
      call analyse(loops, result)
      call assertEqual(none, result%en_26891%peak_force, 0.0_wp, 'not of cycles')
   end subroutine test_estimated

   !> Factors of SciPy's noncentral t, nct.ppf(0.75, n - 1, 1.645 root n)/root n, which are those of
   !> the standard's table where it is cited: 3.15, 2.46, 2.10, 1.93, 1.81, 1.76.
   subroutine test_factors()
      integer, parameter :: tests(8) = [2, 3, 4, 5, 10, 20, 50, 100]
      real(wp), parameter :: factors(8) = [5.121509778299801_wp, 3.151842138184501_wp, &
         2.6805969310251925_wp, 2.4633832431752962_wp, 2.103667548936817_wp, &
         1.9319623584465815_wp, 1.8108754389765112_wp, 1.7576339660363456_wp]
      integer :: i

      do i = 1, size(tests)
         call assertRelativelyEqual(factors(i), tolerance_factor(tests(i)), 1.0e-9_wp, 'factor')
      end do
   end subroutine test_factors

   !> Logarithms 0, 1 and 2, of deviation 1: exp(1 - k_s(3)). Equal tests have a deviation of 0.05.
   subroutine test_fractiles()
      real(wp) :: mean, variation, fractile
      real(wp), parameter :: e = exp(1.0_wp)

      call characteristic_values([1.0_wp, e, e**2], mean, variation, fractile)
      call assertEqual((1.0_wp + e + e**2)/3.0_wp, mean, exact, 'mean')
      call assertEqual(exp(1.0_wp - 3.151842138184501_wp), fractile, 1.0e-9_wp, 'fractile')
      call assertEqual(sqrt(0.5_wp*((1.0_wp - mean)**2 + (e - mean)**2 + (e**2 - mean)**2))/mean, &
         variation, exact, 'coefficient of variation')
      call characteristic_values([-4.0_wp, -4.0_wp, -4.0_wp, -4.0_wp], mean, variation, fractile)
      call assertEqual(0.0_wp, variation, exact, 'no variation')
      call assertEqual(-4.0_wp*exp(-0.05_wp*2.6805969310251925_wp), fractile, 1.0e-9_wp, &
         'negative, and the least deviation')
      call characteristic_values([1.0_wp, 3.0_wp], mean, variation, fractile)
      call assertEqual([2.0_wp, sqrt(2.0_wp)/2.0_wp, none], [mean, variation, fractile], exact, &
         'two tests')
      call characteristic_values([1.0_wp, 3.0_wp, -1.0_wp], mean, variation, fractile)
      call assertEqual(none, fractile, 0.0_wp, 'both signs')
      call characteristic_values([5.0_wp], mean, variation, fractile)
      call assertTrue(is_none(variation) .and. .not. is_none(mean), 'one test')
   end subroutine test_fractiles

end module test_hysteresis_standards
