!> The keyword line of a UINTER in a CalculiX deck, as the solver passes it: without blanks, in
!> capitals, word by word.
module test_calculix_keyword
   use asperity_base_kinds, only: wp
   use asperity_calculix_interactions, only: interaction_type
   use asperity_calculix_keyword, only: is_uinter, read_parameters, read_property
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_keyword

   character(len=132), parameter :: asked = 'PRESSURE-OVERCLOSURE=UINTER'

contains

   function suite_keyword() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('keyword of UINTER')
      call suite%addTest(TestMethod('which line is ours', test_recognised))
      call suite%addTest(TestMethod('parameters', test_parameters))
      call suite%addTest(TestMethod('properties', test_properties))
   end function suite_keyword

   function words(text) result(list)
      character(len=*), intent(in) :: text
      character(len=132), allocatable :: list(:)

      list = [character(len=132) :: '*SURFACEBEHAVIOR', asked, text]
   end function words

   subroutine test_recognised()
      call assertTrue(is_uinter(words('DEPVAR=11')), 'UINTER')
      call assertFalse(is_uinter([character(len=132) :: '*SURFACEBEHAVIOR', &
         'PRESSURE-OVERCLOSURE=TABULAR']), 'TABULAR')
   end subroutine test_recognised

   subroutine test_parameters()
      type(interaction_type) :: interaction
      character(len=:), allocatable :: problem
      character(len=132) :: good(5)

      good = [character(len=132) :: '*SURFACEBEHAVIOR', asked, 'PROPERTIES=12', 'DEPVAR=11', &
         'SEARCHDISTANCE=3.']
      call read_parameters(good, interaction, problem)
      call assertFalse(allocated(problem), 'accepted')
      call assertEqual(12, size(interaction%props), 'PROPERTIES')
      call assertEqual(11, interaction%depvar, 'DEPVAR')
      call assertEqual(3.0_wp, interaction%search_distance, 0.0_wp, 'SEARCH DISTANCE')
      call refused(good, 3, '', 'PROPERTIES=n is missing')
      call refused(good, 3, 'PROPERTIES=-1', 'PROPERTIES=n is missing, or negative')
      call refused(good, 3, 'PROPERTIES=TWELVE', 'no number in PROPERTIES=TWELVE')
      call refused(good, 4, '', 'DEPVAR=m is missing')
      call refused(good, 5, '', 'SEARCH DISTANCE=c is missing')
      call refused(good, 5, 'SEARCHDISTANCE=0.', 'not above zero')
      call refused(good, 5, 'DISTANCE=3.', 'unknown parameter DISTANCE=3.')
   end subroutine test_parameters

   !> With one word in the place of another, the line is refused with this text.
   subroutine refused(good, place, word, text)
      character(len=132), intent(in) :: good(:)
      integer, intent(in) :: place
      character(len=*), intent(in) :: word, text
      type(interaction_type) :: interaction
      character(len=:), allocatable :: problem
      character(len=132) :: bad(size(good))

      bad = good
      bad(place) = word
      call read_parameters(bad, interaction, problem)
      call assertTrue(allocated(problem), text)
      if (allocated(problem)) call assertTrue(index(problem, text) > 0, problem//' has '//text)
   end subroutine refused

   subroutine test_properties()
      real(wp) :: props(2)
      character(len=:), allocatable :: problem
      integer :: found

      found = 0
      call read_property('0.5', props, found, problem)
      call read_property('', props, found, problem)
      call read_property('3.1E-1', props, found, problem)
      call assertFalse(allocated(problem), 'accepted')
      call assertEqual(2, found, 'a blank is none')
      call assertEqual(0.31_wp, props(2), 1.0e-15_wp, 'the second')
      call read_property('1.', props, found, problem)
      call assertTrue(index(problem, 'more properties than PROPERTIES says') > 0, 'too many')
      deallocate (problem)
      found = 1
      call read_property('WOOD', props, found, problem)
      call assertTrue(index(problem, 'property WOOD is no number') > 0, 'no number')
   end subroutine test_properties

end module test_calculix_keyword
