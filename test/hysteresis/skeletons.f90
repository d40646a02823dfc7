!> Skeletons of records and what follows from them, calculated by hand.
module test_hysteresis_skeletons
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use extremes, only: worsen
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: record_type
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_skeletons

   !> Round-off of sums of a few thousand products
   real(wp), parameter :: exact = 1.0e-13_wp

contains

   function suite_hysteresis_skeletons() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis skeletons')
      call suite%addTest(TestMethod('softening skeleton by hand', test_softening))
      call suite%addTest(TestMethod('stiffening skeleton: yield assumed', test_stiffening))
      call suite%addTest(TestMethod('area under the equal-energy curve', test_equal_energy))
      call suite%addTest(TestMethod('peaks by force', test_peaks_by_force))
      call suite%addTest(TestMethod('skeletons with ties', test_ties))
      call suite%addTest(TestMethod('rigid jumps', test_jumps))
   end function suite_hysteresis_skeletons

   !> 10 at 1, to 3, then down to 6 at 5: 0.8 of the peak at 4, area 34, Py = 10 (4 - sqrt(9.2)).
   subroutine test_softening()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, 3.0_wp, 5.0_wp]
      loops%force = [0.0_wp, 10.0_wp, 10.0_wp, 6.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(1))
         call assertEqual([10.0_wp, 3.0_wp], [s%peak_force, s%peak_displacement], exact, 'peak')
         call assertTrue(s%ultimate_reached, 'falls to 0.8')
         call assertEqual([8.0_wp, 4.0_wp], [s%ultimate_force, s%ultimate_displacement], &
            10.0_wp*exact, 'ultimate')
         call assertEqual(34.0_wp, s%area, 100.0_wp*exact, 'area')
         call assertEqual(10.0_wp*(4.0_wp - sqrt(9.2_wp)), s%yield_force, 100.0_wp*exact, 'Py')
         call assertEqual([0, 0, 0], s%cycle, 'the record itself')
      end associate
      ! the same skeleton from the tips of a cyclic record; a smaller and a repeated amplitude
      ! are no points of it
      loops%displacement = [0.0_wp, 1.0_wp, -1.0_wp, 3.0_wp, -3.0_wp, 1.0_wp, -1.0_wp, 3.1_wp, &
         -3.1_wp, 5.0_wp, -5.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -10.0_wp, 10.0_wp, -10.0_wp, 2.0_wp, -2.0_wp, 9.0_wp, &
         -9.0_wp, 6.0_wp, -6.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(2))
         call assertEqual([1, 2, 5], s%cycle, 'cycles of the skeleton')
         call assertEqual([-10.0_wp, -8.0_wp, -4.0_wp], [s%peak_force, s%ultimate_force, &
            s%ultimate_displacement], 10.0_wp*exact, 'peak and ultimate')
         call assertEqual(-10.0_wp*(4.0_wp - sqrt(9.2_wp)), s%yield_force, 100.0_wp*exact, 'Py')
      end associate
      call assertFalse(result%cycles(5)%closed, 'ends at a peak')
      call assertEqual(none, result%cycles(5)%damping, 0.0_wp, 'so it has no damping')
   end subroutine test_softening

   !> A gap first: 1 at 2, then to 10 at 3. Area 6.5; Ke = 4/(2 + 3/9) leaves no real root.
   subroutine test_stiffening()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 2.0_wp, 3.0_wp, 4.0_wp]
      loops%force = [0.0_wp, 1.0_wp, 10.0_wp, 10.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(1), elastic => 4.0_wp/(2.0_wp + 1.0_wp/3.0_wp))
         call assertEqual(elastic, s%elastic_stiffness, exact, 'Ke')
         call assertEqual(16.5_wp, s%area, 100.0_wp*exact, 'area')
         call assertTrue(s%yield_assumed, 'no solution')
         call assertEqual(8.5_wp, s%yield_force, exact*10.0_wp, '0.85 of the peak')
         call assertEqual(3.0_wp/(7.0_wp/3.0_wp - 2.0_wp), s%initial_stiffness, 1.0e-12_wp, &
            'between 0.1 and 0.4')
      end associate
   end subroutine test_stiffening

   !> Random skeletons: the equal-energy curve has the area of the skeleton, and a scale of two in
   !> displacement and of four in force changes no bit.
   subroutine test_equal_energy()
      type(record_type) :: loops
      type(hysteresis_result) :: result, scaled
      type(random_stream) :: stream
      real(wp) :: area, worst
      integer :: i, j, solved

      stream%state = 20260401
      write (*, '(5x, a, i0)') 'seed ', stream%state
      worst = 0.0_wp
      solved = 0
      do i = 1, 200
         allocate (loops%displacement(12), loops%force(12))
         loops%displacement(1) = 0.0_wp
         loops%force(1) = 0.0_wp
         do j = 2, 12
            loops%displacement(j) = loops%displacement(j - 1) + stream%uniform(0.1_wp, 1.0_wp)
            loops%force(j) = max(0.2_wp, loops%force(j - 1) + stream%uniform(-1.0_wp, 2.0_wp))
         end do
         call analyse(loops, result)
         associate (s => result%skeleton(1))
            if (.not. s%yield_assumed) then
               solved = solved + 1
               area = s%yield_force*(s%ultimate_displacement - 0.5_wp*s%yield_displacement)
               call worsen(worst, abs(area/s%area - 1.0_wp))
            end if
            loops%displacement = 2.0_wp*loops%displacement
            loops%force = 4.0_wp*loops%force
            call analyse(loops, scaled)
            call assertEqual(4.0_wp*s%yield_force, scaled%skeleton(1)%yield_force, 0.0_wp, 'scale')
            call assertEqual(2.0_wp*s%ultimate_displacement, &
               scaled%skeleton(1)%ultimate_displacement, 0.0_wp, 'scale of displacement')
         end associate
         deallocate (loops%displacement, loops%force)
      end do
      call assertGreaterThan(solved, 100, message='most have a solution')
      call record('hysteresis.equal_energy', worst)
      call assertEqual(0.0_wp, worst, 1.0e-12_wp, 'areas')
   end subroutine test_equal_energy

   !> Force largest before the tip: which of the two counts as the peak is a setting.
   subroutine test_peaks_by_force()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp, 0.0_wp, -1.0_wp, -2.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 5.0_wp, 4.0_wp, -1.0_wp, -6.0_wp, -3.0_wp, 1.0_wp]
      call analyse(loops, result)
      call assertEqual([3, 6], result%cycles(1)%peak, 'tips')
      call assertEqual(7.0_wp/4.0_wp, result%cycles(1)%secant_stiffness, exact, 'of the tips')
      call analyse(loops, result, hysteresis_settings(peaks='force'))
      call assertEqual([2, 5], result%cycles(1)%peak, 'largest forces')
      call assertEqual(11.0_wp/2.0_wp, result%cycles(1)%secant_stiffness, exact, 'of the forces')
      call assertEqual(2.0_wp/11.0_wp, result%cycles(1)%pinching, exact, 'pinching')
   end subroutine test_peaks_by_force

   !> Forces that are equal, but for round-off, and lines that are straight but for it.
   subroutine test_ties()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      real(wp) :: slope
      integer :: i, j

      ! a plateau that falls by round-off: its end is the peak
      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp]
      loops%force = [0.0_wp, 10.0_wp, 10.0_wp*(1.0_wp - 1.0e-12_wp), &
         10.0_wp*(1.0_wp - 2.0e-12_wp), 9.0_wp]
      call analyse(loops, result)
      call assertEqual(3.0_wp, result%skeleton(1)%peak_displacement, 0.0_wp, 'end of the plateau')
      ! above the ultimate fraction, then below it; 0.4 of the peak over a length
      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp]
      loops%force = [0.0_wp, 4.0_wp, 4.0_wp, 10.0_wp, 8.5_wp, 7.5_wp]
      call analyse(loops, result)
      call assertEqual(4.5_wp, result%skeleton(1)%ultimate_displacement, 1.0e-12_wp, 'ultimate')
      call assertEqual(4.0_wp, result%skeleton(1)%elastic_stiffness, exact, 'where it is first')
      ! straight lines yield at their end, to the root of round-off
      stream%state = 77
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do i = 1, 100
         slope = stream%uniform(0.1_wp, 10.0_wp)
         loops%displacement = [(0.1_wp*j, j=0, 30)]
         loops%force = slope*loops%displacement
         call analyse(loops, result)
         associate (s => result%skeleton(1))
            call assertFalse(s%yield_assumed, 'straight')
            call assertEqual(s%peak_force, s%yield_force, 1.0e-6_wp*s%peak_force, 'at the end')
         end associate
      end do
   end subroutine test_ties

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

end module test_hysteresis_skeletons
