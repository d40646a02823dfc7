!> Replays of OpenSees' materials against what openseespy 3.7.1.2 gives (test/data and
!> test/reference/opensees_reference.py, which has the same numbers).
module test_frame_rules
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_frame_dowel_envelope, only: dowel_envelope
   use asperity_frame_dowel_type, only: dowel_type_material
   use asperity_frame_elastic_gap, only: elastic_gap_material
   use asperity_frame_material, only: frame_command, frame_material
   use asperity_frame_pinching4, only: pinching4_material
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use reference_table, only: open_table
   implicit none
   private
   public :: suite_frame_rules

   !> Forces agree to this share of the largest: round-off
   real(wp), parameter :: exact = 1.0e-12_wp
   !> Rows of a case at most
   integer, parameter :: most_rows = 2000

contains

   function suite_frame_rules() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('frame rules')
      call suite%addTest(TestMethod('Pinching4', test_pinching))
      call suite%addTest(TestMethod('Pinching4 in small units', test_stiff))
      call suite%addTest(TestMethod('Pinching4, first points apart, falling', test_uneven))
      call suite%addTest(TestMethod('Pinching4, points that pass each other', test_early))
      call suite%addTest(TestMethod('DowelType, growing loops', test_dowel))
      call suite%addTest(TestMethod('DowelType, a side hardly loaded', test_dowel_small))
      call suite%addTest(TestMethod('DowelType past its cap, and slider', test_dowel_slider))
      call suite%addTest(TestMethod('DowelType, loops inside', test_dowel_inner))
      call suite%addTest(TestMethod('DowelType, parts of cycles', test_dowel_turns))
      call suite%addTest(TestMethod('elastic gap', test_gap))
      call suite%addTest(TestMethod('what OpenSees is told', test_commands))
      call suite%addTest(TestMethod('no pinching line', test_refused))
   end function suite_frame_rules

   subroutine test_pinching()
      type(pinching4_material) :: material

      material = pinching()
      call compare('pinching', material)
   end subroutine test_pinching

   pure type(pinching4_material) function pinching() result(material)
      material%displacement = reshape([1.0_wp, 4.0_wp, 8.0_wp, 20.0_wp, &
         1.0_wp, 4.0_wp, 8.0_wp, 20.0_wp], [4, 2])
      material%force = reshape([10.0_wp, 16.0_wp, 20.0_wp, 21.0_wp, &
         12.0_wp, 18.0_wp, 22.0_wp, 23.0_wp], [4, 2])
      material%reload_displacement = [0.5_wp, 0.4_wp]
      material%reload_force = [0.25_wp, 0.3_wp]
      material%unload_force = [0.05_wp, 0.1_wp]
   end function pinching

   subroutine test_stiff()
      type(pinching4_material) :: material

      material%displacement = reshape([0.002_wp, 0.004_wp, 0.01_wp, 0.03_wp, &
         0.0015_wp, 0.004_wp, 0.012_wp, 0.03_wp], [4, 2])
      material%force = reshape([6.0_wp, 7.0_wp, 7.5_wp, 7.0_wp, &
         5.0_wp, 6.5_wp, 6.8_wp, 7.1_wp], [4, 2])
      material%reload_displacement = [0.8_wp, 0.7_wp]
      material%reload_force = [0.6_wp, 0.5_wp]
      material%unload_force = [0.4_wp, 0.3_wp]
      call compare('stiff', material)
   end subroutine test_stiff

   subroutine test_uneven()
      type(pinching4_material) :: material

      material = pinching()
      material%displacement(1, 1) = 2.0_wp
      material%force(4, :) = [15.0_wp, 20.0_wp]
      call compare('uneven', material)
   end subroutine test_uneven

   subroutine test_early()
      type(pinching4_material) :: material

      material%displacement = reshape([0.74_wp, 6.8_wp, 13.6_wp, 22.4_wp, &
         0.59_wp, 5.4_wp, 10.8_wp, 17.8_wp], [4, 2])
      material%force = reshape([0.68_wp, 12.1_wp, 17.9_wp, 21.3_wp, &
         1.14_wp, 10.0_wp, 15.0_wp, 18.6_wp], [4, 2])
      material%reload_displacement = [0.07_wp, 0.25_wp]
      material%reload_force = [0.4_wp, 0.37_wp]
      material%unload_force = [0.0014_wp, 0.016_wp]
      call compare('early', material)
   end subroutine test_early

   pure type(dowel_type_material) function dowel() result(material)
      material%pinching_force = 6.0_wp
      material%pinching_stiffness = 0.5_wp
      material%unloading_ratio = 3.0_wp
      material%curvature = 0.5_wp
      material%pinching_growth = 0.1_wp
      material%yield_displacement = 2.0_wp
      material%softening = [0.5_wp, 0.2_wp, 0.3_wp]
      material%envelope(1) = dowel_envelope([1.5_wp, 4.0_wp, 20.0_wp], [12.0_wp, 18.0_wp, &
         25.0_wp], 1.0_wp)
      material%envelope(2) = dowel_envelope([1.2_wp, 5.0_wp, 18.0_wp], [11.0_wp, 19.0_wp, &
         24.0_wp], 0.8_wp)
   end function dowel

   subroutine test_dowel()
      call compare('dowel', dowel())
   end subroutine test_dowel

   subroutine test_dowel_small()
      call compare('dowel_small', dowel())
   end subroutine test_dowel_small

   subroutine test_dowel_slider()
      type(dowel_type_material) :: material

      material = dowel()
      material%slider_stiffness = 5.0_wp
      material%slider_force = 2.0_wp
      call compare('dowel_slider', material)
   end subroutine test_dowel_slider

   subroutine test_dowel_inner()
      type(dowel_type_material) :: material

      material = dowel()
      material%curvature = 1.5_wp
      call compare('dowel_inner', material)
   end subroutine test_dowel_inner

   !> It turns before it comes to the envelope of a side, and inside.
   subroutine test_dowel_turns()
      type(dowel_type_material) :: material

      material = dowel()
      call compare('dowel_turns', material)
      material%curvature = 1.5_wp
      call compare('dowel_round', material)
   end subroutine test_dowel_turns

   subroutine test_gap()
      type(elastic_gap_material) :: material

      material%displacement = reshape([1.0_wp, 3.0_wp, 5.0_wp, 7.0_wp, &
         2.0_wp, 4.0_wp, 6.0_wp, 8.0_wp], [4, 2])
      material%force = reshape([0.0_wp, 3.0_wp, 8.0_wp, 10.0_wp, &
         0.0_wp, 4.0_wp, 7.0_wp, 9.0_wp], [4, 2])
      call compare('gap', material)
   end subroutine test_gap

   !> A replay of the path of a case, against the forces there.
   subroutine compare(name, material)
      character(len=*), intent(in) :: name
      class(frame_material), intent(in) :: material
      type(error_type), allocatable :: error
      character(len=128) :: line
      character(len=16) :: case
      real(wp) :: displacement(most_rows), force(most_rows), found(most_rows)
      integer :: unit, status, n

      call open_table('opensees_reference.csv', 'case,displacement,force', unit)
      n = 0
      do
         read (unit, '(a)', iostat=status) line
         if (status /= 0) exit
         read (line, *) case, displacement(n + 1), force(n + 1)
         if (case == name) n = n + 1
      end do
      close (unit)
      call assertTrue(n > 50, name//' has rows')
      call material%replay(displacement(:n), found(:n), error)
      call assertFalse(allocated(error), name//' has an answer')
      if (allocated(error)) return
      call record('frame_'//name, maxval(abs(found(:n) - force(:n)))/maxval(abs(force(:n))))
      call assertEqual(force(:n), found(:n), exact*maxval(abs(force(:n))), name)
   end subroutine compare

   !> The order of numbers is that of the documentation: forces first in Pinching4.
   subroutine test_commands()
      type(pinching4_material) :: material
      type(frame_command), allocatable :: list(:)

      material = pinching()
      call material%commands(list)
      call assertEqual(1, size(list), 'one material')
      call assertEqual('Pinching4', trim(list(1)%name), 'its name')
      call assertEqual([38, 0], list(1)%size, 'numbers')
      call assertEqual([10.0_wp, 1.0_wp, 16.0_wp, 4.0_wp], list(1)%numbers(:4, 1), 0.0_wp, &
         'positive side')
      call assertEqual([-12.0_wp, -1.0_wp], list(1)%numbers(9:10, 1), 0.0_wp, 'negative side')
      call assertEqual([0.5_wp, 0.25_wp, 0.05_wp, 0.4_wp, 0.3_wp, 0.1_wp], &
         list(1)%numbers(17:22, 1), 0.0_wp, 'pinching')
   end subroutine test_commands

   !> A pinching line above the envelope is an error, not a number.
   subroutine test_refused()
      type(dowel_type_material) :: material
      type(error_type), allocatable :: error
      real(wp) :: force(3)

      material = dowel()
      material%pinching_force = 60.0_wp
      call material%replay([3.0_wp, 6.0_wp, -6.0_wp], force, error)
      call assertTrue(allocated(error), 'refused')
      if (allocated(error)) call assertTrue(index(error%message, 'pinching line') > 0, 'said')
   end subroutine test_refused

end module test_frame_rules
