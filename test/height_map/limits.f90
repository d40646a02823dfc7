!> The limits that messages of the readers name are those that are kept.
module test_height_map_limits
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_height_map_units, only: settle_step
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_limits

contains

   function suite_limits() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('limits')
      call suite%addTest(TestMethod('steps from 1e-9 to 1e6 mm', test_steps))
   end function suite_limits

   !> Said by the user, and by the file.
   subroutine test_steps()
      real(wp), parameter :: limits(2) = [1.0e-9_wp, 1.0e6_wp]
      integer :: i

      do i = 1, 2
         call expect(0.0_wp, limits(i), .true.)
         call expect(0.0_wp, nearest(limits(i), 2.0_wp*i - 3.0_wp), .false.)
         call expect(limits(i), 0.0_wp, .true.)
         call expect(nearest(limits(i), 2.0_wp*i - 3.0_wp), 0.0_wp, .false.)
      end do
   end subroutine test_steps

   subroutine expect(in_file, hint, accepted)
      real(wp), intent(in) :: in_file, hint
      logical, intent(in) :: accepted
      type(error_type), allocatable :: error
      real(wp) :: step

      call settle_step('file', 'x', in_file, hint, step, error)
      call assertTrue(accepted .neqv. allocated(error))
      if (allocated(error)) then
         call assertTrue(index(error%message, 'from 1e-9 to 1e6 mm') > 0, error%message)
      else if (accepted) then
         call assertEqual(max(in_file, hint), step, 0.0_wp)
      end if
   end subroutine expect

end module test_height_map_limits
