!> Records as they come from a test: noisy, unevenly sampled, with repeated samples, unclosed, half
!> a cycle, one-sided, begun at a peak; and those that are refused.
module test_hysteresis_records
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use asperity_error, only: error_type
   use asperity_kinds, only: wp
   use asperity_properties, only: pi
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use hysteresis_analysis, only: analyse_hysteresis, hysteresis_result, hysteresis_settings, &
      not_known
   use hysteresis_models, only: add_noise, path_through, random_path, record_type, &
      repeat_samples, response, spring_type, total_work
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_records

   real(wp), parameter :: exact = 1.0e-13_wp
   !> Elastic and perfectly plastic, yield at 0.5
   real(wp), parameter :: k = 8.0_wp, limit = 4.0_wp, dy = limit/k
   !> Amplitudes dy, 1, 2, 4, the last two twice
   real(wp), parameter :: programme(13) = [0.5_wp, -0.5_wp, 1.0_wp, -1.0_wp, 2.0_wp, -2.0_wp, &
      2.0_wp, -2.0_wp, 4.0_wp, -4.0_wp, 4.0_wp, -4.0_wp, 0.0_wp]

contains

   function suite_hysteresis_records() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis records')
      call suite%addTest(TestMethod('noise', test_noise))
      call suite%addTest(TestMethod('uneven sampling and repeated samples', test_uneven))
      call suite%addTest(TestMethod('coarse sampling: a cut between two samples', test_coarse))
      call suite%addTest(TestMethod('unclosed', test_unclosed))
      call suite%addTest(TestMethod('half a cycle', test_half))
      call suite%addTest(TestMethod('one side only', test_one_side))
      call suite%addTest(TestMethod('begun at a peak', test_from_peak))
      call suite%addTest(TestMethod('begun away from zero', test_offset))
      call suite%addTest(TestMethod('random programmes: energy adds up', test_random))
      call suite%addTest(TestMethod('small reversals and the threshold', test_threshold))
      call suite%addTest(TestMethod('rigid jumps', test_jumps))
      call suite%addTest(TestMethod('records and settings that are refused', test_refused))
   end function suite_hysteresis_records

   type(spring_type) function plastic()
      plastic = spring_type(stiffness=k, limit=[limit, limit])
   end function plastic

   subroutine analyse(this, result, settings)
      type(record_type), intent(in) :: this
      type(hysteresis_result), intent(out) :: result
      type(hysteresis_settings), intent(in), optional :: settings
      type(error_type), allocatable :: error

      call analyse_hysteresis(this%displacement, this%force, result, error, settings)
      call assertFalse(allocated(error), 'is analysed')
      if (allocated(error)) error stop error%message
   end subroutine analyse

   !> Noise of e in displacement and h in force, both uniform. A tip is off by e and its force by h.
   !> The error of the work telescopes but for the ends, limit e, and for the sums over the samples
   !> of h times a step, k e times a step and e h, whose standard deviations grow with the root of
   !> their number; six of them are allowed.
   subroutine test_noise()
      type(record_type) :: loops
      type(hysteresis_result) :: clean, noisy
      type(random_stream) :: stream
      real(wp), parameter :: e = 0.004_wp, h = 0.02_wp, step = 0.015625_wp
      real(wp) :: allowed, samples, worst, worst_work
      integer :: i, run

      worst = 0.0_wp
      worst_work = 0.0_wp
      stream%state = 4711
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do run = 1, 20
         loops = response(plastic(), path_through(programme, step))
         call analyse(loops, clean)
         call add_noise(stream, loops, e, h)
         call analyse(loops, noisy)
         call assertEqual(6, size(noisy%cycles), 'cycles')
         if (size(noisy%cycles) /= 6) return
         call assertEqual([1, 2, 3, 5], noisy%skeleton(1)%cycle, 'skeleton')
         call assertEqual([1, 2, 3, 5], noisy%skeleton(2)%cycle, 'negative skeleton')
         do i = 1, 6
            associate (a => clean%cycles(i), b => noisy%cycles(i))
               call assertTrue(b%closed, 'closed')
               call assertEqual(a%displacement, b%displacement, e + step, 'tips')
               ! elastic below dy, where an error in displacement is one in force
               call assertEqual(a%force, b%force, h + k*(e + step), 'forces at the tips')
               samples = real(b%last - b%first, wp)
               allowed = 6.0_wp*(limit*e + sqrt(samples)*(h*step + e*h/sqrt(3.0_wp) &
                  + k*step*e)/sqrt(3.0_wp))
               call worsen(worst_work, abs(a%energy - b%energy)/allowed)
               call assertEqual(a%energy, b%energy, allowed, 'energy')
               if (i > 2) then
                  call worsen(worst, abs(b%damping/a%damping - 1.0_wp))
                  call assertEqual(a%damping, b%damping, 0.03_wp*a%damping, 'damping')
                  call assertEqual(a%pinching, b%pinching, 0.02_wp, 'pinching')
               end if
            end associate
         end do
         ! 40 % of the peak is at 0.2 of the first point of the skeleton, whose error it inherits
         call assertEqual(limit, noisy%skeleton(1)%yield_force, 0.03_wp*limit, 'yield force')
      end do
      call record('hysteresis.noisy_damping', worst)
      call record('hysteresis.noisy_energy_over_allowed', worst_work)
   end subroutine test_noise

   !> The same straight lines sampled at random, every corner among the samples, some repeated.
   subroutine test_uneven()
      type(record_type) :: loops
      type(hysteresis_result) :: even, uneven
      type(random_stream) :: stream
      real(wp), allocatable :: path(:)
      integer :: i, run

      loops = response(plastic(), path_through(programme, 0.5_wp))
      call analyse(loops, even)
      stream%state = 1918
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do run = 1, 20
         call random_path(stream, programme, 0.5_wp, path)
         loops = response(plastic(), path)
         call repeat_samples(stream, loops)
         call analyse(loops, uneven)
         call assertEqual(6, size(uneven%cycles), 'cycles')
         do i = 1, 6
            associate (a => even%cycles(i), b => uneven%cycles(i))
               call assertEqual(a%displacement, b%displacement, 0.0_wp, 'tips')
               call assertEqual([a%secant_stiffness, a%energy, a%cumulative_energy, a%damping, &
                  a%pinching, a%fullness], [b%secant_stiffness, b%energy, b%cumulative_energy, &
                  b%damping, b%pinching, b%fullness], 1.0e-12_wp*100.0_wp, 'cycle')
            end associate
         end do
         call assertEqual(limit, uneven%skeleton(2)%yield_force*(-1.0_wp), 1.0e-11_wp, 'yield')
      end do
   end subroutine test_uneven

   !> Tips and corners alone: zero lies between two samples, and energies are exact.
   subroutine test_coarse()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 0.5_wp, 2.0_wp, 1.0_wp, -2.0_wp, -1.0_wp, 2.0_wp, 1.0_wp, &
         -2.0_wp, -1.0_wp, 2.0_wp]
      loops%force = [0.0_wp, 4.0_wp, 4.0_wp, -4.0_wp, -4.0_wp, 4.0_wp, 4.0_wp, -4.0_wp, -4.0_wp, &
         4.0_wp, 4.0_wp]
      call analyse(loops, result)
      call assertEqual(3, size(result%cycles), 'cycles')
      call assertEqual([6, 10, 11], result%cycles%last, 'last samples')
      call assertEqual([1, 7, 11], result%cycles%first, 'first samples')
      call assertEqual([0.0_wp, 0.0_wp], result%cycles(2:)%start_displacement, 0.0_wp, 'at zero')
      call assertEqual([4.0_wp, 4.0_wp], result%cycles(2:)%start_force, exact, 'force there')
      call assertEqual([limit*(8.0_wp - 4.5_wp*dy), 4.0_wp*limit*(2.0_wp - dy), 8.0_wp], &
         result%cycles%energy, 100.0_wp*exact, 'energy')
      call assertEqual(1.0_wp, result%cycles(2)%pinching, exact, 'pinching')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .true., .false.]), 'closed')
   end subroutine test_coarse

   !> A record that stops on its way: the last cycle is open, has its work and peaks and no damping.
   subroutine test_unclosed()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: i

      ! half way back from the second negative peak
      loops = response(plastic(), path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, -1.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'cycles')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .false.]), 'closed')
      associate (last => result%cycles(2))
         call assertEqual(-1.0_wp, last%end_displacement, 0.0_wp, 'its end')
         call assertEqual(limit/2.0_wp, last%secant_stiffness, exact, 'its secant')
         call assertEqual([not_known, not_known, not_known, not_known], [last%loop_area, &
            last%damping, last%pinching, last%fullness], 0.0_wp, 'nothing of a loop')
         call assertEqual(total_work(loops), last%cumulative_energy, 100.0_wp*exact, 'work')
      end associate
      ! past zero: a third cycle has begun
      loops = response(plastic(), path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 1.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(3, size(result%cycles), 'a third')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .true., .false.]), 'closed')
      call assertTrue(result%cycles(3)%peak(1) > 0 .and. result%cycles(3)%peak(2) == 0, &
         'half of it')
      call assertEqual(limit, result%cycles(3)%secant_stiffness, exact, 'secant of one side')
      call assertEqual(2.0_wp, result%skeleton(1)%displacement(1), 0.0_wp, 'the skeleton stays')
      call assertEqual(1, size(result%skeleton(1)%displacement), 'and has no new point')
      ! short of zero by less than the threshold: closed, by a straight line
      loops = response(plastic(), path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], &
         0.0078125_wp))
      i = size(loops%force) - 1
      loops%displacement = loops%displacement(:i)
      loops%force = loops%force(:i)
      call analyse(loops, result)
      call assertTrue(result%cycles(2)%closed, 'closed')
      call assertEqual(4.0_wp*limit*(2.0_wp - dy), result%cycles(2)%loop_area, 100.0_wp*exact, &
         'whole area')
      call assertEqual(4.0_wp*limit*(2.0_wp - dy) - limit*0.0078125_wp, result%cycles(2)%energy, &
         100.0_wp*exact, 'work of what there is')
      call assertEqual(1.0_wp, result%cycles(2)%pinching, exact, 'pinching at the last sample')
      ! short of it by a little more than the threshold
      loops = response(plastic(), path_through([2.0_wp, -2.0_wp, -0.015625_wp], 0.015625_wp))
      call analyse(loops, result)
      call assertEqual(0.01_wp, result%threshold, exact, 'threshold')
      call assertFalse(result%cycles(1)%closed, 'open')
   end subroutine test_unclosed

   !> Out and back: one peak, the way out is the skeleton.
   subroutine test_half()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: side

      do side = 1, 2
         loops = response(plastic(), path_through([real(5 - 4*side, wp)*3.0_wp, 0.0_wp], 0.125_wp))
         if (side == 2) then
            call assertEqual(-9.0_wp, minval(loops%displacement), 0.0_wp, 'the other side')
         end if
         call analyse(loops, result)
         call assertEqual(1, size(result%cycles), 'one cycle')
         call assertTrue(result%cycles(1)%closed, 'back at zero')
         call assertEqual(0, result%cycles(1)%peak(3 - side), 'no other peak')
         call assertEqual(not_known, result%cycles(1)%damping, 0.0_wp, 'no damping of half a cycle')
         call assertEqual(total_work(loops), result%cycles(1)%energy, 100.0_wp*exact, 'work')
         call assertEqual(limit, abs(result%skeleton(side)%yield_force), 1.0e-11_wp, 'Py')
         call assertEqual(k, result%skeleton(side)%elastic_stiffness, 1.0e-11_wp, 'Ke')
         call assertEqual(0, size(result%skeleton(3 - side)%force), 'no skeleton there')
         call assertEqual(not_known, result%skeleton(3 - side)%yield_force, 0.0_wp, 'no yield')
      end do
   end subroutine test_half

   !> Out and back to zero, or to where the force is gone, further every time.
   subroutine test_one_side()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops = response(plastic(), path_through([0.5_wp, 0.0_wp, 2.0_wp, 0.0_wp, 4.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(3, size(result%cycles), 'cycles')
      call assertEqual([0.5_wp, 2.0_wp, 4.0_wp], result%skeleton(1)%displacement, 0.0_wp, &
         'skeleton')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .true., .true.]), 'closed')
      call assertEqual(k, result%skeleton(1)%elastic_stiffness, exact*k, 'Ke')
      call assertEqual(limit, result%skeleton(1)%yield_force, 1.0e-11_wp, 'Py')
      call assertEqual(total_work(loops), result%cycles(3)%cumulative_energy, 1.0e-11_wp, 'work')

      loops = response(plastic(), path_through([0.5_wp, 0.0_wp, 2.0_wp, 1.5_wp, 4.0_wp, 3.5_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(3, size(result%cycles), 'cycles')
      call assertEqual([0.5_wp, 2.0_wp, 4.0_wp], result%skeleton(1)%displacement, 0.0_wp, &
         'skeleton')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .false., .false.]), 'closed')
      call assertEqual(limit, result%skeleton(1)%yield_force, 1.0e-11_wp, 'Py')
      call assertEqual(3.5_wp, result%cycles(3)%end_displacement, 0.0_wp, 'end')
      ! slip times limit, as every cycle ends without force
      call assertEqual([0.0_wp, 1.5_wp*limit, 2.0_wp*limit], result%cycles%energy, 1.0e-11_wp, &
         'work')
   end subroutine test_one_side

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
      call assertEqual([3.0_wp], result%skeleton(1)%displacement, 0.0_wp, 'positive skeleton')
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

   !> A pause of the test with a little unloading is a cycle of its own, unless the threshold is
   !> larger.
   subroutine test_threshold()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops = response(plastic(), path_through([1.0_wp, 0.75_wp, 2.0_wp, -2.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'two cycles')
      call assertEqual(5, size(result%turning_points), 'turning points')
      call analyse(loops, result, hysteresis_settings(threshold=0.25_wp))
      call assertEqual(1, size(result%cycles), 'one cycle')
      call assertEqual([2.0_wp, -2.0_wp, 0.0_wp], loops%displacement(result%turning_points), &
         0.0_wp, 'turning points')
   end subroutine test_threshold

   !> Force that jumps at the tips, as rigid friction does: the tip is the sample before the jump.
   subroutine test_jumps()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 0.0_wp, 2.0_wp, 2.0_wp, -2.0_wp, -2.0_wp, 2.0_wp, 2.0_wp, &
         -2.0_wp, -2.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 3.0_wp, 3.0_wp, -3.0_wp, -3.0_wp, 3.0_wp, 3.0_wp, -3.0_wp, -3.0_wp, &
         3.0_wp, 3.0_wp]
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'cycles')
      associate (cycle => result%cycles(2))
         call assertEqual([3.0_wp, -3.0_wp], cycle%force, 0.0_wp, 'forces at the tips')
         call assertEqual([24.0_wp, 2.0_wp/pi, 1.0_wp, 1.0_wp], [cycle%energy, cycle%damping, &
            cycle%pinching, cycle%fullness], 100.0_wp*exact, 'a rectangle')
      end associate
      ! held at the tips while the force grows: the largest counts
      loops%force(2:3) = [1.0_wp, 1.0_wp]
      loops%displacement = [loops%displacement(:3), 2.0_wp, loops%displacement(4:)]
      loops%force = [loops%force(:3), 3.0_wp, loops%force(4:)]
      call analyse(loops, result)
      call assertEqual([3.0_wp, -3.0_wp], result%cycles(1)%force, 0.0_wp, 'forces held')
      call assertEqual([3.0_wp, 1.5_wp], [result%skeleton(1)%peak_force, &
         result%skeleton(1)%elastic_stiffness], exact, 'skeleton of one point')
   end subroutine test_jumps

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
      if (allocated(error)) call assertEqual(1, index(error%message, text), error%message)
   end subroutine expect

end module test_hysteresis_records
