!> Post-processing of displacement-force records against exact answers: elastic and perfectly
!> plastic, bilinear, slipping and asymmetric loops.
module test_hysteresis_analysis
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings, &
      hysteresis_skeleton
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: path_through, record_type, response, spring_type, total_work
   use measurements, only: record
   implicit none
   private
   public :: suite_hysteresis

   !> Round-off of sums of a few thousand products
   real(wp), parameter :: exact = 1.0e-13_wp

contains

   function suite_hysteresis() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis')
      call suite%addTest(TestMethod('elastic and perfectly plastic', test_plastic))
      call suite%addTest(TestMethod('skeleton of growing amplitudes', test_amplitudes))
      call suite%addTest(TestMethod('bilinear', test_bilinear))
      call suite%addTest(TestMethod('slipping with friction', test_slip))
      call suite%addTest(TestMethod('elastic', test_elastic))
      call suite%addTest(TestMethod('asymmetric', test_asymmetric))
   end function suite_hysteresis

   !> Closed loops of a parallelogram: area 4 Fy (a - dy), damping 2/pi (1 - 1/ductility), no
   !> pinching; the first cycle starts at rest.
   subroutine test_plastic()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: k = 8.0_wp, limit = 4.0_wp, dy = limit/k, a = 2.0_wp
      integer :: i, side

      loops = response(spring_type(stiffness=k, limit=[limit, limit]), &
         path_through([a, -a, a, -a, a, -a, 0.0_wp], 0.0625_wp))
      call analyse(loops, result, hysteresis_settings(peaks='displacement'))
      call assertEqual(3, size(result%cycles), 'cycles')
      call assertEqual(4.0_wp*a/400.0_wp*0.5_wp, result%threshold, exact, 'threshold')
      do i = 1, 3
         associate (cycle => result%cycles(i))
            call assertTrue(cycle%closed, 'closed')
            call assertEqual([a, -a], cycle%displacement, 0.0_wp, 'tips')
            call assertEqual([limit, -limit], cycle%force, 0.0_wp, 'their forces')
            call assertEqual(limit/a, cycle%secant_stiffness, exact, 'secant')
            call assertEqual(1.0_wp, cycle%stiffness_ratio, exact, 'no degradation')
            call assertEqual(1.0_wp, cycle%pinching, exact, 'not pinched')
         end associate
      end do
      associate (first => result%cycles(1), second => result%cycles(2), third => result%cycles(3))
         ! from rest at zero to the yield force at zero: the same cycle less 5 dy of slip, and with
         ! the spring loaded
         call assertEqual(limit*(4.0_wp*a - 4.5_wp*dy), first%energy, exact*a*limit, 'first')
         call assertEqual(4.0_wp*limit*(a - dy), second%energy, exact*a*limit, 'parallelogram')
         call assertEqual(2.0_wp/pi*(1.0_wp - dy/a), second%damping, exact, 'damping')
         call assertEqual(1.0_wp - dy/a, second%fullness, exact, 'fullness')
         call assertEqual(second%energy, third%energy, exact*a*limit, 'third')
         call assertEqual(total_work(loops), third%cumulative_energy, exact*a*limit, 'sum')
         call record('hysteresis.plastic_damping', &
            abs(second%damping/(2.0_wp/pi*(1.0_wp - dy/a)) - 1.0_wp))
      end associate
      do side = 1, 2
         call assertEqual(1, size(result%skeleton(side)%force), 'one amplitude')
      end do

      ! pushed once, the record is its own skeleton
      loops = response(spring_type(stiffness=k, limit=[limit, limit]), &
         path_through([3.0_wp], 0.0625_wp))
      call analyse(loops, result)
      call assertEqual(1, size(result%cycles), 'one cycle')
      call assertFalse(result%cycles(1)%closed, 'open')
      call assertEqual(0, result%cycles(1)%peak(2), 'no negative peak')
      call assertEqual(limit*(3.0_wp - 0.5_wp*dy), result%cycles(1)%energy, exact*limit, 'work')
      call check_plastic_skeleton(result%skeleton(1), 1.0_wp, k, limit, 3.0_wp)
      call assertEqual(0, size(result%skeleton(2)%force), 'no negative side')
   end subroutine test_plastic

   !> The equal-energy curve of an elastic and perfectly plastic skeleton is the skeleton.
   subroutine check_plastic_skeleton(skeleton, s, k, limit, last)
      type(hysteresis_skeleton), intent(in) :: skeleton
      real(wp), intent(in) :: s, k, limit, last

      call assertEqual(k, skeleton%elastic_stiffness, exact*k, 'Ke')
      call assertEqual(k, skeleton%initial_stiffness, exact*k, 'initial stiffness')
      call assertEqual(s*limit, skeleton%yield_force, 1.0e-12_wp*limit, 'Py')
      call assertEqual(s*limit/k, skeleton%yield_displacement, 1.0e-12_wp*limit/k, 'yield at')
      call assertEqual(last*k/limit, skeleton%ductility, 1.0e-12_wp*last*k/limit, 'ductility')
      call assertEqual(s*limit, skeleton%peak_force, 0.0_wp, 'peak')
      call assertEqual(s*last, skeleton%peak_displacement, 0.0_wp, 'the outermost of equal ones')
      call assertEqual(s*last, skeleton%ultimate_displacement, 0.0_wp, 'last point')
      call assertEqual(s*limit, skeleton%ultimate_force, 0.0_wp, 'ultimate force')
      call assertFalse(skeleton%ultimate_reached, 'the force does not fall')
      call assertFalse(skeleton%yield_assumed, 'yield is calculated')
      call assertEqual(limit*(last - 0.5_wp*limit/k), skeleton%area, exact*limit*last, 'area')
   end subroutine check_plastic_skeleton

   !> The programme of the paper, amplitudes once and then three times: 17 cycles or so, one point
   !> of the skeleton per amplitude, secant stiffness Fy/a, damping zero below yield.
   subroutine test_amplitudes()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: amplitudes(9) = [0.5_wp, 1.0_wp, 2.0_wp, 4.0_wp, 8.0_wp, 16.0_wp, &
         24.0_wp, 32.0_wp, 48.0_wp]
      integer, parameter :: times(9) = [1, 1, 1, 1, 3, 3, 3, 3, 3]
      real(wp), parameter :: k = 2.0_wp, limit = 8.0_wp
      real(wp) :: turns(2*sum(times) + 1), a
      integer :: i, j, n

      n = 0
      do i = 1, size(times)
         do j = 1, times(i)
            turns(n + 1:n + 2) = [amplitudes(i), -amplitudes(i)]
            n = n + 2
         end do
      end do
      turns(n + 1) = 0.0_wp
      loops = response(spring_type(stiffness=k, limit=[limit, limit]), path_through(turns, 0.25_wp))
      call analyse(loops, result, hysteresis_settings(peaks='displacement'))
      call assertEqual(sum(times), size(result%cycles), 'cycles')
      call assertEqual(amplitudes, result%skeleton(1)%displacement, 0.0_wp, 'positive skeleton')
      call assertEqual(-amplitudes, result%skeleton(2)%displacement, 0.0_wp, 'negative skeleton')
      call assertEqual([1, 2, 3, 4, 5, 8, 11, 14, 17], result%skeleton(1)%cycle, 'first cycles')
      call assertEqual(9, count([(result%cycles(i)%in_skeleton(2), i=1, sum(times))]), 'marked')
      ! an amplitude of dy is among them, so the skeleton has its corner
      call check_plastic_skeleton(result%skeleton(1), 1.0_wp, k, limit, 48.0_wp)
      call check_plastic_skeleton(result%skeleton(2), -1.0_wp, k, limit, 48.0_wp)
      ! the envelope has more points, on the same curve
      call analyse(loops, result)
      call check_plastic_skeleton(result%skeleton(1), 1.0_wp, k, limit, 48.0_wp)
      call check_plastic_skeleton(result%skeleton(2), -1.0_wp, k, limit, 48.0_wp)
      n = 0
      do i = 1, size(times)
         a = amplitudes(i)
         do j = 1, times(i)
            n = n + 1
            associate (cycle => result%cycles(n))
               call assertEqual(min(k, limit/a), cycle%secant_stiffness, exact, 'secant')
               call assertEqual(min(k, limit/a)/k, cycle%stiffness_ratio, exact, 'degradation')
               if (a <= limit/k) call assertEqual(0.0_wp, cycle%damping, exact, 'elastic')
               if (j > 1) call assertEqual(2.0_wp/pi*(1.0_wp - limit/k/a), cycle%damping, exact, &
                  'damping')
            end associate
         end do
      end do
      call assertEqual(total_work(loops), result%cycles(n)%cumulative_energy, &
         exact*total_work(loops), 'energy')
   end subroutine test_amplitudes

   !> Bilinear, second slope r k: damping 2 (m - 1)(1 - r)/(pi m (1 + r m - r)) at ductility m.
   subroutine test_bilinear()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: k = 16.0_wp, r = 0.125_wp, dy = 0.5_wp, m = 4.0_wp
      real(wp), parameter :: peak = k*dy*(1.0_wp + r*m - r)
      real(wp) :: energy

      loops = response(spring_type(stiffness=(1.0_wp - r)*k, limit=[1.0_wp, 1.0_wp] &
         *(1.0_wp - r)*k*dy, beside=r*k), &
         path_through([-m*dy, m*dy, -m*dy, m*dy, 0.0_wp], 0.0625_wp))
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'cycles')
      associate (second => result%cycles(2))
         energy = 4.0_wp*k*dy**2*(m - 1.0_wp)*(1.0_wp - r)
         call assertEqual([peak, -peak], second%force, exact*peak, 'peaks')
         call assertEqual(energy, second%energy, exact*energy, 'area')
         call assertEqual(2.0_wp*(m - 1.0_wp)*(1.0_wp - r)/(pi*m*(1.0_wp + r*m - r)), &
            second%damping, exact, 'damping')
         ! at zero displacement only the slider pulls
         call assertEqual((1.0_wp - r)*k*dy/peak, second%pinching, exact, 'pinching')
         call assertEqual(peak/(m*dy), second%secant_stiffness, exact*k, 'secant')
         call assertGreaterThan(second%peak(1), second%peak(2), message='negative side first')
      end associate

      ! equal energy: Ke = k, and half the area above the elastic line goes below the second slope
      loops = response(spring_type(stiffness=(1.0_wp - r)*k, limit=[1.0_wp, 1.0_wp] &
         *(1.0_wp - r)*k*dy, beside=r*k), path_through([-m*dy], 0.0625_wp))
      call analyse(loops, result)
      associate (s => result%skeleton(2), area => 0.5_wp*k*dy**2 + 0.5_wp*(k*dy + peak) &
            *(m - 1.0_wp)*dy)
         call assertEqual(k, s%elastic_stiffness, exact*k, 'Ke')
         call assertEqual(area, s%area, exact*area, 'area under the skeleton')
         call assertEqual(-k*(m*dy - sqrt((m*dy)**2 - 2.0_wp*area/k)), s%yield_force, &
            1.0e-12_wp*peak, 'Py')
         call assertEqual(-peak, s%peak_force, exact*peak, 'peak')
      end associate
   end subroutine test_bilinear

   !> Bearings that yield and leave gaps, with a little friction: a new amplitude dissipates
   !> 2 Fb (a - dy) in the bearings, a repeated one nothing; the pinching ratio is the share of
   !> friction.
   subroutine test_slip()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: kb = 16.0_wp, bearing = 8.0_wp, ks = 64.0_wp, friction = 2.0_wp
      real(wp), parameter :: dy = bearing/kb, ds = friction/ks, a = 2.0_wp
      real(wp), parameter :: peak = bearing + friction
      real(wp) :: rubbed

      loops = response(spring_type(stiffness=ks, limit=[friction, friction], &
         bearing_stiffness=kb, bearing_limit=bearing), &
         path_through([a, -a, a, -a, a, -a, 0.0_wp], 0.03125_wp))
      call analyse(loops, result)
      call assertEqual(3, size(result%cycles), 'cycles')
      rubbed = 4.0_wp*friction*(a - ds)
      associate (first => result%cycles(1), second => result%cycles(2), third => result%cycles(3))
         call assertEqual(friction*(4.0_wp*a - 4.5_wp*ds) + 2.0_wp*bearing*(a - dy), first%energy, &
            exact*a*peak, 'first cycle')
         call assertEqual(rubbed, second%energy, exact*a*peak, 'second cycle')
         call assertEqual(rubbed, third%energy, exact*a*peak, 'third cycle')
         call assertEqual(friction/peak, second%pinching, exact, 'pinching')
         call assertEqual(friction/peak, first%pinching, exact, 'pinching of the first')
         call assertEqual(rubbed/(2.0_wp*pi*a*peak), second%damping, exact, 'damping')
         call assertEqual(rubbed/(4.0_wp*a*peak), second%fullness, exact, 'fullness')
         call assertEqual([peak, -peak], third%force, exact*peak, 'peaks')
      end associate

      ! without friction nothing is left at zero
      loops = response(spring_type(bearing_stiffness=kb, bearing_limit=bearing), &
         path_through([a, -a, a, -a, 0.0_wp], 0.03125_wp))
      call analyse(loops, result)
      call assertEqual(2.0_wp*bearing*(a - dy), result%cycles(1)%energy, exact*a*peak, 'gaps')
      call assertEqual(0.0_wp, result%cycles(2)%energy, exact*a*peak, 'only gaps')
      call assertEqual(0.0_wp, result%cycles(2)%pinching, exact, 'fully pinched')
      call assertEqual(0.0_wp, result%cycles(2)%damping, exact, 'no damping')
   end subroutine test_slip

   !> A spring: every loop is a line.
   subroutine test_elastic()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      integer :: i, side

      loops = response(spring_type(beside=4.0_wp), &
         path_through([1.0_wp, -1.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], 0.125_wp))
      call analyse(loops, result)
      call assertEqual(2, size(result%cycles), 'cycles')
      do i = 1, 2
         call assertEqual([4.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], [result%cycles(i)%secant_stiffness, &
            result%cycles(i)%energy, result%cycles(i)%damping, result%cycles(i)%pinching], exact, &
            'a line')
      end do
      do side = 1, 2
         associate (s => result%skeleton(side))
            call assertEqual(4.0_wp, s%elastic_stiffness, exact, 'Ke')
            ! yield at the end; sqrt of round-off
            call assertEqual(abs(s%peak_force), abs(s%yield_force), 1.0e-6_wp, 'yield at the end')
            call assertFalse(s%yield_assumed, 'is calculated')
         end associate
      end do
   end subroutine test_elastic

   !> Other strengths and amplitudes on each side.
   subroutine test_asymmetric()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp), parameter :: k = 8.0_wp, up = 8.0_wp, down = 4.0_wp
      integer :: i

      loops = response(spring_type(stiffness=k, limit=[up, down]), path_through([1.0_wp, -0.5_wp, &
         2.0_wp, -1.0_wp, 3.0_wp, -1.5_wp, 3.0_wp, -1.5_wp, 0.0_wp], 0.0625_wp))
      call analyse(loops, result)
      call assertEqual(4, size(result%cycles), 'cycles')
      call check_plastic_skeleton(result%skeleton(1), 1.0_wp, k, up, 3.0_wp)
      call check_plastic_skeleton(result%skeleton(2), -1.0_wp, k, down, 1.5_wp)
      associate (cycle => result%cycles(4), dy => (up + down)/k)
         call assertEqual((up + down)/4.5_wp, cycle%secant_stiffness, exact, 'secant')
         call assertEqual(0.5_wp*(up/3.0_wp + down/1.5_wp), cycle%mean_secant_stiffness, exact, &
            'mean of both sides')
         ! a parallelogram from -1.5 to 3 and from -down to up
         call assertEqual((up + down)*(4.5_wp - dy), cycle%energy, exact*50.0_wp, 'area')
         call assertEqual((up + down)*(4.5_wp - dy)/(pi*(3.0_wp*up + 1.5_wp*down)), &
            cycle%damping, exact, 'damping')
         call assertEqual(1.0_wp, cycle%pinching, exact, 'not pinched')
      end associate
      ! mirrored, the sides change places and nothing else
      loops%displacement = -loops%displacement
      loops%force = -loops%force
      call analyse(loops, result)
      call check_plastic_skeleton(result%skeleton(2), -1.0_wp, k, up, 3.0_wp)
      call check_plastic_skeleton(result%skeleton(1), 1.0_wp, k, down, 1.5_wp)
      do i = 1, 4
         call assertTrue(result%cycles(i)%closed, 'closed')
      end do
      call assertEqual(1.0_wp, result%cycles(4)%pinching, exact, 'not pinched')
   end subroutine test_asymmetric

end module test_hysteresis_analysis
