!> What wood is to a body that presses on one of its sections.
module test_faces_sections
   use asperity, only: equivalent_modulus, error_type, wp
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_constants, section_names, section_radial, &
      section_tangential, section_transverse
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_faces_sections

contains

   function suite_faces_sections() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('sections of wood')
      call suite%addTest(TestMethod('constants of each section', test_constants))
      call suite%addTest(TestMethod('six pairs of sections', test_pairs))
      call suite%addTest(TestMethod('sections that are refused', test_refused))
   end function suite_faces_sections

   !> Table 1, Table 4 and the symmetry of the compliance, nu_TR/E_T = nu_RT/E_R.
   subroutine test_constants()
      type(wood_properties) :: wood
      type(error_type), allocatable :: error
      real(wp) :: found(3)

      wood%hardnesses(3) = 10.0_wp
      wood%young_moduli(3) = 200.0_wp
      call section_constants(wood, section_transverse, found(1), found(2), found(3), error)
      call assertFalse(allocated(error))
      call assertEqual([3727.12_wp, 0.42_wp, 24.53_wp], found, 0.0_wp, 'transverse')
      call section_constants(wood, section_tangential, found(1), found(2), found(3), error)
      call assertEqual([351.01_wp, 0.35_wp, 12.14_wp], found, 0.0_wp, 'tangential')
      call section_constants(wood, section_radial, found(1), found(2), found(3), error)
      call assertEqual([200.0_wp, 0.35_wp*200.0_wp/351.01_wp, 10.0_wp], found, 1.0e-14_wp, 'radial')
   end subroutine test_constants

   !> E* of Eq. 4 by the larch of the paper, each face's 1 - nu^2 over E by hand: 0.8236/3727.12 of
   !> the transverse one, 0.8775/351.01 of the others, as E_T = E_R there.
   subroutine test_pairs()
      real(wp), parameter :: compliances(3) = [0.8236_wp/3727.12_wp, 0.8775_wp/351.01_wp, &
         0.8775_wp/351.01_wp]
      type(wood_properties) :: wood
      type(error_type), allocatable :: error
      real(wp) :: e(3), nu(3), hardness, largest
      integer :: i, j

      wood%hardnesses(3) = 10.0_wp
      do i = 1, 3
         call section_constants(wood, i, e(i), nu(i), hardness, error)
         call assertFalse(allocated(error))
      end do
      call assertEqual(367.5_wp, equivalent_modulus(e(1), nu(1), e(2), nu(2)), 0.05_wp, 'text')
      call assertEqual(200.0_wp, equivalent_modulus(e(2), nu(2), e(2), nu(2)), 0.05_wp, 'text')
      largest = 0.0_wp
      do i = 1, 3
         do j = 1, 3
            associate (product => equivalent_modulus(e(i), nu(i), e(j), nu(j)) &
               *(compliances(i) + compliances(j)))
               call assertEqual(1.0_wp, product, 1.0e-15_wp, trim(section_names(i))//' on '// &
                  trim(section_names(j)))
               largest = max(largest, abs(product - 1.0_wp))
            end associate
         end do
      end do
      call record('faces.modulus', largest)
   end subroutine test_pairs

   !> No such section, no hardness, a wood that cannot be.
   subroutine test_refused()
      type(wood_properties) :: larch, wood
      real(wp) :: found(3)

      call expect(larch, 0, 'section = 0', 'unknown')
      call expect(larch, 4, 'section = 4', 'unknown')
      call expect(larch, section_radial, 'hardness_radial is not given', 'no radial section')
      wood = larch
      wood%young_moduli(2) = -1.0_wp
      call expect(wood, section_transverse, 'young_modulus_r = -1.0', 'not allowed')
      wood = larch
      wood%hardnesses(3) = 0.0_wp
      call expect(wood, section_transverse, 'hardness_radial = 0.0', 'not allowed')
   contains
      subroutine expect(wood, section, start, part)
         type(wood_properties), intent(in) :: wood
         integer, intent(in) :: section
         character(len=*), intent(in) :: start, part
         type(error_type), allocatable :: error

         call section_constants(wood, section, found(1), found(2), found(3), error)
         call assertTrue(allocated(error), start)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, start), error%message)
         call assertTrue(index(error%message, part) > 0, error%message)
         call assertTrue(fits_subject(error), error%subject)
      end subroutine expect
   end subroutine test_refused

end module test_faces_sections
