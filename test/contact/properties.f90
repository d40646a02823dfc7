!> Limits of friction and datum: a value, and the next one that is refused.
module test_contact_properties
   use asperity, only: contact_properties, error_type, implausible_property, &
      new_contact_properties, new_normal_properties, wp
   use asperity_base_number_text, only: to_text
   use contact_cases, only: pair_properties
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_contact_properties

   real(wp), parameter :: up = 1.0_wp, down = -1.0_wp, pair_slip = 0.31_wp

contains

   function suite_contact_properties() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact properties')
      call suite%addTest(TestMethod('limits', test_limits))
   end function suite_contact_properties

   subroutine test_limits()
      real(wp) :: reach

      call check(0.0_wp, pair_slip, 0.0_wp, .false., '')
      call check(nearest(0.0_wp, down), pair_slip, 0.0_wp, .false., 'friction_coefficient')
      call check(1000.0_wp, pair_slip, 0.0_wp, .false., '')
      call check(nearest(1000.0_wp, up), pair_slip, 0.0_wp, .true., 'friction_coefficient')
      call check(0.5_wp, 1.0e-20_wp, 0.0_wp, .false., '')
      call check(0.5_wp, nearest(1.0e-20_wp, down), 0.0_wp, .true., 'critical_slip')
      call check(0.5_wp, 1.0e20_wp, 0.0_wp, .true., '', implausible_property)
      call check(0.5_wp, nearest(1.0e20_wp, up), 0.0_wp, .true., 'critical_slip')
      call check(0.5_wp, pair_slip, 1.0e20_wp, .true., '', implausible_property)
      call check(0.5_wp, pair_slip, -1.0e20_wp, .true., '', implausible_property)
      call check(0.5_wp, pair_slip, nearest(1.0e20_wp, up), .true., 'initial_separation')
      call check(0.5_wp, pair_slip, nearest(-1.0e20_wp, down), .true., 'initial_separation')
      ! lengths that no face has: above 10 mm, a datum where the law does not reach as far
      call check(0.5_wp, 10.0_wp, 0.0_wp, .false., '')
      call check(0.5_wp, nearest(10.0_wp, up), 0.0_wp, .false., 'critical_slip')
      call check(0.5_wp, nearest(10.0_wp, up), 0.0_wp, .true., '', implausible_property)
      call check(0.5_wp, pair_slip, -10.0_wp, .false., '')
      call check(0.5_wp, pair_slip, nearest(-10.0_wp, down), .false., 'initial_separation')
      call check(0.5_wp, pair_slip, nearest(10.0_wp, up), .true., '', implausible_property)
      reach = 39.0_wp*0.5_wp
      call check(0.5_wp, pair_slip, reach, .false., '', sigma=0.5_wp)
      call check(0.5_wp, pair_slip, nearest(reach, up), .false., 'initial_separation', sigma=0.5_wp)
   end subroutine test_limits

   !> Refused for what `subject` names, or taken with flags, none when absent.
   subroutine check(friction_coefficient, critical_slip, initial_separation, accepted, subject, &
         flags, sigma)
      real(wp), intent(in) :: friction_coefficient, critical_slip, initial_separation
      logical, intent(in) :: accepted
      character(len=*), intent(in) :: subject
      integer, intent(in), optional :: flags
      real(wp), intent(in), optional :: sigma
      type(contact_properties) :: p, pair
      type(error_type), allocatable :: error
      integer :: expected

      pair = pair_properties()
      if (present(sigma)) call new_normal_properties(pair%normal, 206.0_wp, 297.0_wp, 0.1477_wp, &
         24.53_wp, 0.4_wp, sigma, error)
      call new_contact_properties(p, pair%normal, friction_coefficient, critical_slip, error, &
         initial_separation, accept_unphysical=accepted)
      call assertTrue(allocated(error) .eqv. subject /= '', subject//' mu '// &
         to_text(friction_coefficient)//' gcrit '//to_text(critical_slip)//' d0 '// &
         to_text(initial_separation))
      if (allocated(error)) then
         call assertEqual(subject, error%subject)
         return
      end if
      expected = 0
      if (present(flags)) expected = flags
      call assertEqual(expected, p%normal%validity - pair%normal%validity, 'flags')
   end subroutine check

end module test_contact_properties
