!> Lines of UINTER in a deck: their numbers are the properties, DEPVAR is what they need.
module test_deck_uinter_lines
   use asperity, only: contact_properties, error_type, friction_settings, &
      slip_direction_of_stress, stick_summits, unloading_elastic, wp
   use asperity_abaqus_props, only: properties_from_props, props_from_properties
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_cards_interaction, only: interaction_type, new_interaction, &
      write_interaction, write_pair
   use asperity_deck_options, only: deck_choice
   use contact_cases, only: pair_properties
   use friction_cases, only: friction_properties
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_uinter_lines

contains

   function suite_uinter_lines() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('lines of UINTER')
      call suite%addTest(TestMethod('numbers, counts and names', test_lines))
      call suite%addTest(TestMethod('the lines of the page', test_page))
   end function suite_uinter_lines

   subroutine test_lines()
      type(friction_settings) :: points

      call check(pair_properties(), 12, 11, 'd0 (mm), friction rule, slip integration. Separation')
      call check(pair_properties(unloading=unloading_elastic), 14, 11, 'unloading. Separation')
      call check(friction_properties(friction_settings(static_friction_coefficient=0.6_wp, &
         decay_slip=0.05_wp)), 20, 13, 'decay slip (mm). Separation')
      call check(friction_properties(friction_settings(friction_coefficient_across=0.2_wp, &
         grain_angle=30.0_wp, slip_direction=slip_direction_of_stress)), 24, 13, &
         'slip direction. Separation')
      call check(friction_properties(friction_settings(shear_limit=0.7_wp)), 27, 13, &
         'shear limit (MPa). Separation')
      call check(friction_properties(friction_settings(stick=stick_summits, shear_modulus=31.6_wp, &
         stick_elements=5)), 30, 13 + 10, 'shear modulus (MPa). Separation')
      points = friction_settings(friction_points=2)
      points%friction_pressures(:2) = [0.1_wp, 1.5_wp]
      points%friction_factors(:2) = [1.2_wp, 0.6_wp]
      call check(friction_properties(points), 35, 13, &
         'friction points, a pressure (MPa) and a factor for each of them. Separation')
   end subroutine test_lines

   !> docs/abaqus.md, and with it the head of the one file, has the lines that decks have.
   subroutine test_page()
      type(deck_choice) :: choice
      type(interaction_type) :: interaction
      type(writer_type) :: deck
      type(error_type), allocatable :: error
      character(len=:), allocatable :: page
      integer :: unit, status, length

      open (newunit=unit, file='docs/abaqus.md', status='old', action='read', access='stream', &
         iostat=status)
      call assertTrue(status == 0, 'docs/abaqus.md opens')
      if (status /= 0) return
      inquire (unit, size=length)
      allocate (character(len=length) :: page)
      read (unit) page
      close (unit)
      choice%solver = 'abaqus'
      call new_interaction(interaction, choice, 'WOOD', pair_properties(), 0.1_wp, error)
      call write_interaction(deck, choice, interaction)
      call write_pair(deck, interaction, 'SLAVE', 'MASTER')
      call assertTrue(index(page, '```text'//new_line('a')//deck%text()//'```') > 0, &
         'docs/abaqus.md has: '//deck%text())
   end subroutine test_page

   !> The list has so many numbers, which give the same properties; both solvers.
   subroutine check(properties, n, depvar, names)
      type(contact_properties), intent(in) :: properties
      integer, intent(in) :: n, depvar
      character(len=*), intent(in) :: names
      type(deck_choice) :: choice
      type(interaction_type) :: interaction
      type(writer_type) :: deck
      type(contact_properties) :: back
      type(error_type), allocatable :: error
      character(len=:), allocatable :: text
      character(len=40) :: counts
      real(wp), allocatable :: again(:), wanted(:)
      real(wp) :: props(n)
      integer :: i, j

      write (counts, '(2(a, i0))') 'PROPERTIES=', n, ', DEPVAR=', depvar
      do i = 1, 2
         choice%solver = merge('calculix', 'abaqus  ', i == 1)
         deck = writer_type()
         call new_interaction(interaction, choice, 'WOOD', properties, 0.1_wp, error)
         call assertFalse(allocated(error), 'prepared')
         call write_interaction(deck, choice, interaction)
         text = deck%text()
         call assertTrue(index(text, trim(counts)//', ') > 0, trim(counts)//' in: '//text)
         call assertTrue(index(joined(text), names) > 0, names//' in: '//joined(text))
         text = text(index(text, trim(counts)):)
         ! after the keyword line, and the blank one of ABAQUS
         text = text(index(text, new_line('a')) + i:)
         ! flang takes the end of a line within a record for no separator
         do j = 1, len(text)
            if (text(j:j) == new_line('a')) text(j:j) = ' '
         end do
         read (text, *) props
         call properties_from_props(props, back, error)
         call assertFalse(allocated(error), 'read back')
         again = props_from_properties(back)
         wanted = props_from_properties(properties)
         call assertEqual(wanted, again, 0.0_wp, 'the same')
      end do
   end subroutine check

   !> Comment lines as one.
   pure function joined(text) result(line)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: line
      integer :: at

      line = text
      do
         at = index(line, new_line('a')//'** ')
         if (at == 0) exit
         line = line(:at - 1)//' '//line(at + 4:)
      end do
   end function joined

end module test_deck_uinter_lines
