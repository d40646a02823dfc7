!> First-cycle envelopes by hand: peaks inside an excursion, reloading from below, weaker later
!> cycles, brittle drops, force that the other side has left.
module test_hysteresis_envelopes
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use backbone_models, only: backbone_fall, backbone_type, driven
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: path_through, record_type, response, spring_type
   implicit none
   private
   public :: suite_hysteresis_envelopes

   real(wp), parameter :: exact = 1.0e-13_wp

contains

   function suite_hysteresis_envelopes() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis envelopes')
      call suite%addTest(TestMethod('unloading leaves no trace', test_unloading))
      call suite%addTest(TestMethod('peak inside an excursion', test_peak_inside))
      call suite%addTest(TestMethod('reloading from below', test_reloading))
      call suite%addTest(TestMethod('weaker later cycles', test_later))
      call suite%addTest(TestMethod('brittle drop', test_brittle))
      call suite%addTest(TestMethod('force left by the other side', test_left))
      call suite%addTest(TestMethod('more in the record than in the skeleton', test_more))
      call suite%addTest(TestMethod('rise without a sample', test_rigid))
   end function suite_hysteresis_envelopes

   !> The same samples as without the unloading, and so the same numbers to the bit.
   subroutine test_unloading()
      type(backbone_type), parameter :: joint = backbone_type(12.0_wp, 8.0_wp, 1.25_wp)
      type(hysteresis_result) :: plain, unloaded
      real(wp), allocatable :: way(:)

      way = path_through([24.0_wp], 0.03125_wp)
      call analyse(driven(joint, way), plain)
      call analyse(driven(joint, [way(:21), way(20:5:-1), way(6:)]), unloaded)
      call assertEqual('monotonic', trim(plain%record_kind), 'kind')
      call assertEqual('monotonic_with_unloading', trim(unloaded%record_kind), 'kind')
      associate (a => plain%skeleton(1), b => unloaded%skeleton(1))
         call assertEqual(a%displacement, b%displacement, 0.0_wp, 'samples')
         call assertEqual([a%initial_stiffness, a%elastic_stiffness, a%yield_displacement, &
            a%yield_force, a%peak_displacement, a%peak_force, a%ultimate_displacement, a%area, &
            a%ductility], [b%initial_stiffness, b%elastic_stiffness, b%yield_displacement, &
            b%yield_force, b%peak_displacement, b%peak_force, b%ultimate_displacement, b%area, &
            b%ductility], 0.0_wp, 'numbers')
         call assertEqual(12.0_wp, a%peak_force, exact, 'peak')
      end associate
   end subroutine test_unloading

   !> Tips at 0.5 and 3.5 of the displacement of the peak: tips alone would give 0.824 of the force.
   subroutine test_peak_inside()
      type(backbone_type), parameter :: joint = backbone_type(10.0_wp, 4.0_wp, 1.0_wp)
      type(hysteresis_result) :: result
      type(record_type) :: loops
      real(wp) :: u

      loops = driven(joint, path_through([2.0_wp, -2.0_wp, 14.0_wp, -14.0_wp, 0.0_wp], 0.03125_wp))
      call analyse(loops, result)
      u = backbone_fall(joint, 0.8_wp, .true.)
      call assertEqual([10.0_wp, 4.0_wp], [result%skeleton(1)%peak_force, &
         result%skeleton(1)%peak_displacement], exact, 'peak')
      call assertEqual(-u, result%skeleton(2)%ultimate_displacement, 1.0e-4_wp, 'ultimate')
      call assertTrue(all(result%cycles%in_skeleton(1)), 'both cycles')
      call assertEqual([1, 2], result%skeleton(1)%cycle([1, 448]), 'cycles of its points')
      call assertEqual(448, size(result%skeleton(1)%cycle), 'one point a sample')
      call analyse(loops, result, hysteresis_settings(peaks='displacement'))
      call assertEqual(0.5_wp*exp(0.5_wp)*10.0_wp, result%skeleton(1)%peak_force, exact, 'of tips')
      call assertFalse(any(result%skeleton(1)%cycle == 0), 'tips of cycles')
   end subroutine test_peak_inside

   !> The second excursion comes back with 6 at 4, has 10 again at 5 and 12 at 8. A straight line
   !> goes from 10 at 4 to 10 at 5. One that never gets 10 again counts from its largest force on.
   subroutine test_reloading()
      type(hysteresis_result) :: result
      type(record_type) :: loops

      loops%displacement = [0.0_wp, 2.0_wp, 4.0_wp, 3.0_wp, 0.0_wp, -4.0_wp, 0.0_wp, 3.5_wp, &
         4.25_wp, 5.0_wp, 8.0_wp, 10.0_wp, 9.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 7.0_wp, 10.0_wp, 0.0_wp, 0.0_wp, -10.0_wp, 0.0_wp, 3.0_wp, &
         7.0_wp, 10.0_wp, 12.0_wp, 6.0_wp, 0.0_wp, 0.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(1))
         call assertEqual([2.0_wp, 4.0_wp, 5.0_wp, 8.0_wp, 10.0_wp], s%displacement, 0.0_wp, &
            'points')
         call assertEqual([1, 1, 2, 2, 2], s%cycle, 'cycles')
         ! to 9.6 at 8.8: 7 + 17 + 10 + 33 + 8.64
         call assertEqual([12.0_wp, 8.8_wp, 75.64_wp], [s%peak_force, s%ultimate_displacement, &
            s%area], 1000.0_wp*exact, 'peak, ultimate, area')
      end associate
      ! 10 at 4 to 9 at 8, where it is largest, then to 6 at 10
      loops%force(8:12) = [1.0_wp, 5.0_wp, 8.0_wp, 9.0_wp, 6.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(1))
         call assertEqual([2.0_wp, 4.0_wp, 8.0_wp, 10.0_wp], s%displacement, 0.0_wp, 'points')
         call assertEqual([10.0_wp, 8.0_wp + 2.0_wp/3.0_wp], [s%peak_force, &
            s%ultimate_displacement], 100.0_wp*exact, 'peak, ultimate')
      end associate
   end subroutine test_reloading

   !> Cycles of an amplitude that has been reached, but for the tolerance, do not lower the
   !> envelope.
   subroutine test_later()
      type(hysteresis_result) :: result
      type(record_type) :: loops

      loops%displacement = [0.0_wp, 4.0_wp, -4.0_wp, 4.1_wp, -4.1_wp, 4.15_wp, -4.15_wp, 8.0_wp, &
         -8.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -10.0_wp, 8.5_wp, -8.5_wp, 7.0_wp, -7.0_wp, 11.0_wp, &
         -11.0_wp, 0.0_wp]
      call analyse(loops, result)
      call assertEqual([4.0_wp, 8.0_wp], result%skeleton(1)%displacement, 0.0_wp, 'points')
      call assertEqual([1, 4], result%skeleton(2)%cycle, 'cycles')
      call assertFalse(result%skeleton(1)%ultimate_reached, 'has not failed')
      call analyse(loops, result, hysteresis_settings(amplitude_tolerance=0.0_wp))
      call assertEqual(4, size(result%skeleton(1)%force), 'without tolerance')
   end subroutine test_later

   !> A crack with a little way back: the drop from 10 to 4 stays where it is. So does one at one
   !> displacement. A part-unloading that ends above half the force leaves its dip.
   subroutine test_brittle()
      type(hysteresis_result) :: result
      type(record_type) :: loops

      loops%displacement = [0.0_wp, 8.0_wp, 7.5_wp, 8.5_wp, 12.0_wp]
      loops%force = [0.0_wp, 10.0_wp, 4.0_wp, 4.0_wp, 6.0_wp]
      call analyse(loops, result)
      call assertEqual([8.0_wp, 8.5_wp, 12.0_wp], result%skeleton(1)%displacement, 0.0_wp, 'points')
      call assertEqual(8.0_wp + 0.5_wp/3.0_wp, result%skeleton(1)%ultimate_displacement, &
         100.0_wp*exact, 'ultimate')
      loops%displacement(3) = 8.0_wp
      call analyse(loops, result)
      call assertEqual([10.0_wp, 4.0_wp, 6.0_wp], result%skeleton(1)%force, 0.0_wp, 'drop')
   end subroutine test_brittle

   !> Elastic and perfectly plastic: the negative side begins with the yield force, left by the
   !> positive one, and counts from its tip on. A second excursion counts as a whole.
   subroutine test_left()
      type(hysteresis_result) :: result

      call analyse(response(spring_type(stiffness=8.0_wp, limit=[4.0_wp, 4.0_wp]), &
         path_through([2.0_wp, -2.0_wp, 3.0_wp, -3.0_wp, 0.0_wp], 0.125_wp)), result)
      call assertEqual(8.0_wp, result%skeleton(1)%elastic_stiffness, exact, 'from rest')
      associate (s => result%skeleton(2))
         call assertEqual([0.0_wp, -4.0_wp], result%skeleton%left_force, exact, 'left force')
         call assertEqual(-2.0_wp, s%displacement(1), 0.0_wp, 'from the tip')
         call assertEqual(9, size(s%displacement), 'and then all')
         call assertEqual([2.0_wp, -4.0_wp, 8.0_wp], [s%elastic_stiffness, s%peak_force, s%area], &
            100.0_wp*exact, 'a straight line to the tip')
      end associate
   end subroutine test_left

   !> The record's largest force beside the skeleton, whatever the definition.
   subroutine test_more()
      type(hysteresis_result) :: result
      type(record_type) :: loops
      character(len=12), parameter :: peaks(3) = [character(len=12) :: 'envelope', &
         'displacement', 'force']
      real(wp), parameter :: largest(3) = [11.0_wp, 10.0_wp, 12.0_wp]
      integer :: i

      loops%displacement = [0.0_wp, 4.0_wp, -4.0_wp, 6.0_wp, 8.0_wp, -8.0_wp, 7.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -10.0_wp, 11.0_wp, 7.0_wp, -7.0_wp, 12.0_wp, 0.0_wp]
      do i = 1, 3
         call analyse(loops, result, hysteresis_settings(peaks=peaks(i)))
         associate (s => result%skeleton(1))
            call assertEqual(largest(i), s%peak_force, 0.0_wp, 'skeleton, '//peaks(i))
            call assertEqual([7.0_wp, 12.0_wp], [s%record_displacement, s%record_force], 0.0_wp, &
               'record')
            call assertEqual(7, s%record_sample, 'its sample')
         end associate
      end do
   end subroutine test_more

   !> Force that is there at the first sample beyond zero has no stiffness.
   subroutine test_rigid()
      type(hysteresis_result) :: result
      type(record_type) :: loops

      loops%displacement = [0.0_wp, 0.0001_wp, 2.0_wp, 4.0_wp, 6.0_wp]
      loops%force = [0.0_wp, 5.0_wp, 8.0_wp, 10.0_wp, 7.0_wp]
      call analyse(loops, result)
      associate (s => result%skeleton(1))
         call assertEqual([none, none, none, none, none], &
            [s%initial_stiffness, s%elastic_stiffness, s%yield_force, s%yield_displacement, &
            s%ductility], 0.0_wp, 'nothing')
         call assertEqual([10.0_wp, 4.0_wp + 4.0_wp/3.0_wp], [s%peak_force, &
            s%ultimate_displacement], 100.0_wp*exact, 'peak, ultimate')
      end associate
   end subroutine test_rigid

end module test_hysteresis_envelopes
