!> Records begun at a peak or away from zero, of random programmes, with small reversals; and those
!> that are refused.
module test_hysteresis_programmes
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result, &
      hysteresis_settings
   use extremes, only: worsen
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: add_noise, path_through, record_type, repeat_samples, response, &
      spring_type, total_work
   use measurements, only: record
   use random_inputs, only: random_stream
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_hysteresis_programmes

   real(wp), parameter :: exact = 1.0e-13_wp
   !> Elastic and perfectly plastic, yield at 0.5
   real(wp), parameter :: k = 8.0_wp, limit = 4.0_wp, dy = limit/k

contains

   function suite_hysteresis_programmes() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis programmes')
      call suite%addTest(TestMethod('begun at a peak', test_from_peak))
      call suite%addTest(TestMethod('begun away from zero', test_offset))
      call suite%addTest(TestMethod('random programmes: energy adds up', test_random))
      call suite%addTest(TestMethod('small reversals and the threshold', test_threshold))
      call suite%addTest(TestMethod('records and settings that are refused', test_refused))
   end function suite_hysteresis_programmes

   type(spring_type) function plastic()
      plastic = spring_type(stiffness=k, limit=[limit, limit])
   end function plastic

   !> Closed loops from peak to peak, as one cuts them out of a record.
   subroutine test_from_peak()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: i, n, sign_of

      do sign_of = -1, 1, 2
         loops = response(plastic(), path_through(sign_of*[2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, &
            2.0_wp], 0.125_wp))
         n = size(loops%force)
         loops%displacement = loops%displacement(17:n)
         loops%force = loops%force(17:n)
         call assertEqual(sign_of*2.0_wp, loops%displacement(1), 0.0_wp, 'from the peak')
         call analyse(loops, result)
         call assertEqual(2, size(result%cycles), 'cycles')
         do i = 1, 2
            associate (cycle => result%cycles(i))
               call assertTrue(cycle%closed, 'closed')
               call assertEqual(4.0_wp*limit*(2.0_wp - dy), cycle%energy, 100.0_wp*exact, 'area')
               call assertEqual(2.0_wp/pi*(1.0_wp - dy/2.0_wp), cycle%damping, exact, 'damping')
               call assertEqual(1.0_wp, cycle%pinching, exact, 'pinching')
            end associate
         end do
      end do
      ! growing from a peak: what follows the last peak belongs to the cycle it ends
      loops%displacement = [1.0_wp, -1.0_wp, 3.0_wp, -3.0_wp]
      loops%force = [1.0_wp, -1.0_wp, 3.0_wp, -3.0_wp]
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'cycles')
      call assertEqual([1.0_wp, 3.0_wp], result%skeleton(1)%displacement, 0.0_wp, 'positive side')
      call assertEqual([-1.0_wp, -3.0_wp], result%skeleton(2)%displacement, 0.0_wp, 'negative')
   end subroutine test_from_peak

   !> The first sample is a little on one side, and the test begins on the other: nothing changes
   !> but the first work.
   subroutine test_offset()
      type(record_type) :: loops
      type(hysteresis_result) :: from_zero, offset

      loops = response(plastic(), path_through([-2.0_wp, 2.0_wp, -2.0_wp, 2.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, from_zero)
      loops%displacement = [0.25_wp, loops%displacement]
      loops%force = [0.0_wp, loops%force]
      call analyse(loops, offset)
      call assertEqual(2, size(offset%cycles), 'cycles')
      call assertTrue(all(offset%cycles%closed .eqv. [.false., .true.]), 'closed')
      call assertEqual(from_zero%cycles%energy, offset%cycles%energy, 100.0_wp*exact, 'energy')
      call assertEqual(from_zero%cycles%secant_stiffness, offset%cycles%secant_stiffness, exact, &
         'secant')
      call assertEqual(from_zero%cycles(2)%damping, offset%cycles(2)%damping, exact, 'damping')
      call assertEqual(from_zero%cycles(2)%pinching, offset%cycles(2)%pinching, exact, 'pinching')
   end subroutine test_offset

   !> Whatever the record, the cycles follow each other and their work is that of the record; each
   !> peak is the outermost sample of its side and cycle.
   subroutine test_random()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      real(wp) :: turns(24), work, worst
      integer :: i, j, run

      stream%state = 31415
      write (*, '(5x, a, i0)') 'seed ', stream%state
      worst = 0.0_wp
      do run = 1, 300
         do i = 1, size(turns)
            turns(i) = 0.125_wp*nint(stream%uniform(-40.0_wp, 40.0_wp))
         end do
         loops = response(spring_type(stiffness=k, limit=[limit, 0.5_wp*limit], beside=1.0_wp, &
            bearing_stiffness=k, bearing_limit=limit), path_through(turns, 0.125_wp))
         if (mod(run, 2) == 0) call add_noise(stream, loops, 0.05_wp, 0.05_wp)
         if (mod(run, 3) == 0) call repeat_samples(stream, loops)
         if (mod(run, 5) == 0) then
            ! begins anywhere
            loops%displacement = loops%displacement(run/5:)
            loops%force = loops%force(run/5:)
         end if
         call analyse(loops, result)
         associate (n => size(result%cycles), f => abs(loops%force))
            work = total_work(loops)
            call worsen(worst, abs(work - result%cycles(n)%cumulative_energy) &
               /(sum(f)*0.125_wp))
            call assertEqual(1, result%cycles(1)%first, 'first sample')
            call assertEqual(size(f), result%cycles(n)%last, 'last sample')
            do i = 1, n
               associate (cycle => result%cycles(i))
                  if (i > 1) then
                     call assertEqual(result%cycles(i - 1)%end_force, cycle%start_force, 0.0_wp, &
                        'no gap')
                     call assertTrue(any(cycle%first - result%cycles(i - 1)%last == [0, 1]), &
                        'next sample')
                  end if
                  do j = 1, 2
                     if (cycle%peak(j) == 0) cycle
                     call assertEqual(maxval((3 - 2*j) &
                        *loops%displacement(cycle%first:cycle%last)), &
                        (3 - 2*j)*cycle%displacement(j), 0.0_wp, 'outermost')
                  end do
               end associate
            end do
         end associate
      end do
      call record('hysteresis.energy_balance', worst)
      call assertEqual(0.0_wp, worst, exact, 'work')
   end subroutine test_random

   !> A pause with part-unloading makes no cycle; a return does, unless the threshold is larger.
   subroutine test_threshold()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops = response(plastic(), path_through([1.0_wp, 0.75_wp, 2.0_wp, -2.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(1, size(result%cycles), 'a pause')
      loops = response(plastic(), path_through([1.0_wp, 0.25_wp, 2.0_wp, -2.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'two cycles')
      call assertEqual(5, size(result%turning_points), 'turning points')
      call analyse(loops, result, hysteresis_settings(threshold=0.75_wp))
      call assertEqual(1, size(result%cycles), 'one cycle')
      call assertEqual([2.0_wp, -2.0_wp, 0.0_wp], loops%displacement(result%turning_points), &
         0.0_wp, 'turning points')
   end subroutine test_threshold

   subroutine test_refused()
      real(wp), parameter :: x(5) = [0.0_wp, 1.0_wp, 0.0_wp, -1.0_wp, 0.0_wp]
      real(wp) :: bad(5)

      call expect(x(:4), x, 'the record has 4 displacements but 5 forces')
      call expect(x(:2), x(:2), 'the record is too short: 2 samples')
      call expect(x(:0), x(:0), 'the record is too short: 0 samples')
      bad = x
      bad(3) = ieee_value(1.0_wp, ieee_quiet_nan)
      call expect(bad, x, 'displacement = NaN in sample 3')
      bad(3) = ieee_value(1.0_wp, ieee_positive_inf)
      call expect(x, bad, 'force = Infinity in sample 3')
      bad(3) = 1.0e200_wp
      call expect(bad, x, 'displacement = 1.0E200 in sample 3')
      bad(3) = 1.0e100_wp
      call expect(x, bad, 'force = 1.0E100 in sample 3 is not a number below 1e100 in size')
      bad(3) = nearest(bad(3), -1.0_wp)
      call expect(x, bad, '')
      bad = 2.0_wp
      call expect(bad, x, 'displacement is 2.0 in every sample')
      bad = 0.0_wp
      call expect(x, bad, 'force is zero in every sample')
      call expect(x, -x, 'force points against the displacement')
      call expect(x, x, 'threshold = -1.0 ', hysteresis_settings(threshold=-1.0_wp))
      call expect(x, x, 'displacement changes by no more than 2.0', &
         hysteresis_settings(threshold=2.0_wp))
      call expect(x + 5.0_wp, x, '', hysteresis_settings(threshold=1.5_wp))
      call expect(x, x, 'displacement comes no further from zero', &
         hysteresis_settings(threshold=1.5_wp))
      call expect(x, x, 'amplitude_tolerance = -0.1', &
         hysteresis_settings(amplitude_tolerance=-0.1_wp))
      call expect(x, x, 'elastic_fraction = 0.1', hysteresis_settings(elastic_fraction=0.1_wp))
      call expect(x, x, 'ultimate_fraction = 1.0', hysteresis_settings(ultimate_fraction=1.0_wp))
      call expect(x, x, "peaks = 'foo' is unknown", hysteresis_settings(peaks='foo'))
      call expect(x, x, "outliers = 'foo' is unknown", hysteresis_settings(outliers='foo'))
      call expect(x, x, 'force_floor = -1.0 ', hysteresis_settings(force_floor=-1.0_wp))
   end subroutine test_refused

   !> A message that starts so, or none when that is empty.
   subroutine expect(displacement, force, text, settings)
      real(wp), intent(in) :: displacement(:), force(:)
      character(len=*), intent(in) :: text
      type(hysteresis_settings), intent(in), optional :: settings
      type(hysteresis_result) :: result
      type(error_type), allocatable :: error

      call analyse_hysteresis(displacement, force, result, error, settings)
      call assertTrue(allocated(error) .neqv. text == '', 'refused: '//text)
      if (.not. allocated(error)) return
      call assertEqual(1, index(error%message, text), error%message)
      call assertTrue(fits_subject(error), error%message)
   end subroutine expect

end module test_hysteresis_programmes
