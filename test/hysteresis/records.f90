!> Records as they come from a test: noisy, unevenly sampled, with repeated samples, unclosed, half
!> a cycle, one-sided.
module test_hysteresis_records
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
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

   type(hysteresis_settings), parameter :: tips = hysteresis_settings(peaks='displacement')

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
   end function suite_hysteresis_records

   type(spring_type) function plastic()
      plastic = spring_type(stiffness=k, limit=[limit, limit])
   end function plastic

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
         call analyse(loops, noisy, tips)
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
         call analyse(loops, noisy)
         call assertEqual(limit, noisy%skeleton(1)%yield_force, 0.03_wp*limit, 'of the envelope')
         call assertEqual(-limit, noisy%skeleton(2)%peak_force, 1.01_wp*h, 'largest force')
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
         call assertEqual([none, none, none, none], [last%loop_area, &
            last%damping, last%pinching, last%fullness], 0.0_wp, 'nothing of a loop')
         call assertEqual(total_work(loops), last%cumulative_energy, 100.0_wp*exact, 'work')
      end associate
      ! past zero: a third cycle has begun
      loops = response(plastic(), path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 1.0_wp], &
         0.125_wp))
      call analyse(loops, result, tips)
      call assertEqual(3, size(result%cycles), 'a third')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .true., .false.]), 'closed')
      call assertTrue(result%cycles(3)%peak(1) > 0 .and. result%cycles(3)%peak(2) == 0, &
         'half of it')
      call assertEqual(limit, result%cycles(3)%secant_stiffness, exact, 'secant of one side')
      call assertEqual(limit, result%cycles(3)%mean_secant_stiffness, exact, 'mean of one side')
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
         call assertEqual(none, result%cycles(1)%damping, 0.0_wp, 'no damping of half a cycle')
         call assertEqual(total_work(loops), result%cycles(1)%energy, 100.0_wp*exact, 'work')
         call assertEqual(limit, abs(result%skeleton(side)%yield_force), 1.0e-11_wp, 'Py')
         call assertEqual(k, result%skeleton(side)%elastic_stiffness, 1.0e-11_wp, 'Ke')
         call assertEqual(0, size(result%skeleton(3 - side)%force), 'no skeleton there')
         call assertEqual(none, result%skeleton(3 - side)%yield_force, 0.0_wp, 'no yield')
      end do
   end subroutine test_half

   !> Out and back to zero, or to where the force is gone, further every time.
   subroutine test_one_side()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops = response(plastic(), path_through([0.5_wp, 0.0_wp, 2.0_wp, 0.0_wp, 4.0_wp, 0.0_wp], &
         0.125_wp))
      call analyse(loops, result, tips)
      call assertEqual(3, size(result%cycles), 'cycles')
      call assertEqual([0.5_wp, 2.0_wp, 4.0_wp], result%skeleton(1)%displacement, 0.0_wp, &
         'skeleton')
      call assertTrue(all(result%cycles%closed .eqv. [.true., .true., .true.]), 'closed')
      call assertEqual(k, result%skeleton(1)%elastic_stiffness, exact*k, 'Ke')
      call assertEqual(limit, result%skeleton(1)%yield_force, 1.0e-11_wp, 'Py')
      call assertEqual(total_work(loops), result%cycles(3)%cumulative_energy, 1.0e-11_wp, 'work')

      loops = response(plastic(), path_through([0.5_wp, 0.0_wp, 2.0_wp, 1.5_wp, 4.0_wp, 3.5_wp], &
         0.125_wp))
      call analyse(loops, result, tips)
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

end module test_hysteresis_records
