!> Contact goes on from a checkpoint, and through UINTER.
module test_solid_contact_history
   use asperity, only: contact_properties, error_type, friction_settings, stick_summits, wp
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_solid_contact_history, only: history_size, pack_facets, pack_history, &
      unpack_facets, unpack_history
   use asperity_solid_contact_pair, only: begin_increment, forget_pattern
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_contact_uinter, only: new_uinter_law, uinter_law
   use contact_blocks, only: blocks, new_blocks
   use contact_cases, only: pair_properties
   use contact_forces, only: pair_forces
   use contact_motion, only: advance, motion, moved_master, new_motion, winding_path
   use friction_cases, only: friction_properties
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   implicit none
   private
   public :: suite_contact_history

contains

   function suite_contact_history() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact history')
      call suite%addTest(TestMethod('a checkpoint bit for bit', test_history))
      call suite%addTest(TestMethod('an increment cut back bit for bit', test_cut_back))
      call suite%addTest(TestMethod('nodes are met when they are needed', test_nodes))
      call suite%addTest(TestMethod('the same through UINTER', test_uinter))
   end function suite_contact_history

   !> Summits that remember, friction that does, and summits that stick.
   subroutine test_history()
      type(contact_properties) :: properties

      properties = pair_properties()
      properties%normal%unloading = unloading_elastic
      call check_history(properties)
      call check_history(friction_properties(friction_settings(decay_slip=0.2_wp, &
         static_friction_coefficient=0.7_wp, friction_coefficient_across=0.3_wp)))
      call check_history(friction_properties(friction_settings(stick=stick_summits, &
         shear_modulus=30.0_wp)))
   end subroutine test_history

   !> A pair that goes on, and one that is built anew from its numbers.
   subroutine check_history(properties)
      type(contact_properties), intent(in) :: properties
      type(rough_law) :: law
      type(motion) :: first, second
      type(blocks) :: b
      integer :: i

      law%properties = properties
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.02_wp)
      call new_motion(first, b, law)
      do i = 1, 12
         call advance(first, winding_path(b, 0.02_wp*i))
      end do
      call new_motion(second, b, law)
      call assertEqual(size(pack_history(first%pair)), history_size(second%pair))
      call unpack_history(second%pair, pack_history(first%pair))
      call unpack_facets(second%pair, pack_facets(first%pair))
      second%x = first%x
      call forget_pattern(first%pair)
      call forget_pattern(second%pair)
      do i = 13, 24
         call advance(first, winding_path(b, 0.02_wp*i))
         call advance(second, winding_path(b, 0.02_wp*i))
         call assertTrue(all(abs(first%forces - second%forces) <= 0.0_wp), 'the same forces')
      end do
      call assertTrue(all(abs(pack_history(first%pair) - pack_history(second%pair)) <= 0.0_wp), &
         'the same history')
      do i = 1, size(first%pair%faces)
         call assertEqual(first%pair%faces(i)%nodes, second%pair%faces(i)%nodes, 'the same nodes')
      end do
      call assertGreaterThan(first%pair%energy%dissipation, 1000.0_wp, 'it slid')
   end subroutine check_history

   !> Trials far astray, then the increment anew.
   subroutine test_cut_back()
      type(rough_law) :: law
      type(motion) :: first, second
      type(blocks) :: b
      type(error_type), allocatable :: error
      real(wp), allocatable :: forces(:, :)
      integer :: i

      law%properties = pair_properties()
      b = new_blocks([3, 3], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 5], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.08_wp)
      call new_motion(first, b, law)
      call new_motion(second, b, law)
      allocate (forces(3, size(b%nodes, 2)))
      do i = 1, 12
         call advance(first, winding_path(b, 0.02_wp*i))
         if (mod(i, 3) == 1) then
            call begin_increment(second%pair, second%x, error)
            call pair_forces(second%pair, moved_master(b, [40.0_wp, -25.0_wp, -3.0_wp], &
               [0.3_wp, 1.5_wp, -0.2_wp]), forces)
         end if
         call advance(second, winding_path(b, 0.02_wp*i))
         call assertTrue(all(abs(first%forces - second%forces) <= 0.0_wp), 'the same forces')
      end do
      call assertTrue(all(abs(pack_history(first%pair) - pack_history(second%pair)) <= 0.0_wp), &
         'the same history')
   end subroutine test_cut_back

   !> A face knows the nodes of the facets within the search distance and of their neighbours; it
   !> says so when they are more, and can forget those not met since it did so last.
   subroutine test_nodes()
      type(rough_law) :: law
      type(motion) :: m
      type(blocks) :: b
      real(wp), parameter :: still(3) = 0.0_wp

      law%properties = pair_properties()
      b = new_blocks([1, 1], [0.0_wp, 0.0_wp], [10.0_wp, 10.0_wp], [9, 9], [-40.0_wp, -40.0_wp], &
         [50.0_wp, 50.0_wp], -4.0_wp)
      call new_motion(m, b, law)
      associate (face => m%pair%faces(1), pair => m%pair)
         call advance(m, moved_master(b, [0.0_wp, 0.0_wp, 0.5_wp], still))
         call assertEqual(4, size(face%nodes), 'past the search distance')
         call assertFalse(pair%has_grown, 'none was met')
         call advance(m, moved_master(b, [0.0_wp, 0.0_wp, -2.0_wp], still))
         call assertTrue(pair%has_grown, 'some were met')
         call assertEqual(4 + 16, size(face%nodes), 'a facet and those around it')
         pair%has_grown = .false.
         ! past those around it
         call advance(m, moved_master(b, [22.0_wp, 1.0_wp, -2.0_wp], still))
         call advance(m, moved_master(b, [22.0_wp, 1.0_wp, -4.1_wp], still))
         call assertTrue(pair%has_grown, 'more were met')
         call forget_pattern(pair)
         call assertTrue(size(face%nodes) > 20, 'those met last are kept')
         call forget_pattern(pair)
         call assertEqual(4, size(face%nodes), 'none was met since')
         call advance(m, moved_master(b, [22.0_wp, 1.0_wp, -4.1_wp], still))
         call assertTrue(size(face%nodes) > 16, 'and met again')
         call assertGreaterThan(maxval(m%forces), 1.0_wp, 'there are forces')
      end associate
   end subroutine test_nodes

   subroutine test_uinter()
      type(rough_law) :: law
      type(uinter_law) :: through
      type(motion) :: direct, called
      type(blocks) :: b
      real(wp) :: worst, largest
      integer :: i

      law%properties = pair_properties()
      law%properties%normal%unloading = unloading_elastic
      call new_uinter_law(through, law%properties)
      b = new_blocks([2, 2], [0.0_wp, 0.0_wp], [60.0_wp, 60.0_wp], [4, 3], [-31.0_wp, -10.0_wp], &
         [50.0_wp, 70.0_wp], 0.02_wp)
      call new_motion(direct, b, law)
      call new_motion(called, b, through)
      worst = 0.0_wp
      largest = 0.0_wp
      do i = 1, 20
         call advance(direct, winding_path(b, 0.04_wp*i))
         call advance(called, winding_path(b, 0.04_wp*i))
         worst = max(worst, maxval(abs(direct%forces - called%forces)))
         largest = max(largest, maxval(abs(direct%forces)))
      end do
      call assertGreaterThan(largest, 100.0_wp, 'there are forces')
      call assertLessThan(worst/largest, 1.0e-12_wp, 'forces')
      call assertEqual(direct%pair%energy%dissipation, called%pair%energy%dissipation, &
         tolerance=1.0e-12_wp*direct%pair%energy%dissipation, message='dissipation')
      call assertEqual(direct%pair%energy%coupling, called%pair%energy%coupling, &
         tolerance=1.0e-12_wp*direct%pair%energy%dissipation, message='coupling')
      call assertGreaterThan(direct%pair%energy%plastic, 1.0_wp, 'summits yielded')
      call assertEqual(direct%pair%energy%plastic, called%pair%energy%plastic, &
         tolerance=1.0e-12_wp*direct%pair%energy%plastic, message='plastic dissipation')
   end subroutine test_uinter

end module test_solid_contact_history
