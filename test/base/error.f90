!> Errors are values with a subject; what is checked is refused by its own name.
module test_base_error
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: computation_error, error_type, fatal_error, input_error
   use asperity_base_kinds, only: wp
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_error

contains

   function suite_error() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('error')
      call suite%addTest(TestMethod('what an error holds', test_error))
      call suite%addTest(TestMethod('a number above zero', test_positive))
      call suite%addTest(TestMethod('a number in a range', test_range))
   end function suite_error

   subroutine test_error()
      type(error_type), allocatable :: error

      call fatal_error(error, 'no balance', computation_error)
      call assertEqual('no balance', error%message)
      call assertEqual('', error%subject)
      call assertEqual(computation_error, error%category)
      call fatal_error(error, 'ssk = 5.0 with sku = 3.0', subject='ssk sku')
      call assertEqual('ssk sku', error%subject)
      call assertEqual(input_error, error%category)
      call assertTrue(fits_subject(error))
      error%subject = 'sku'
      call assertFalse(fits_subject(error))
   end subroutine test_error

   !> The message tells the limits that are kept: either is the last number accepted.
   subroutine test_positive()
      real(wp), parameter :: limits(2) = [1.0e-20_wp, 1.0e20_wp]
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, 2
         call check_positive(error, 'radius', limits(i), 'mm')
         call assertFalse(allocated(error))
         call check_positive(error, 'radius', nearest(limits(i), 2.0_wp*i - 3.0_wp), 'mm')
         call assertTrue(allocated(error))
         if (.not. allocated(error)) return
         call assertEqual('radius', error%subject)
         call assertTrue(fits_subject(error), error%message)
         call assertTrue(index(error%message, 'above zero (1e-20 to 1e20), in mm') > 0, &
            error%message)
         deallocate (error)
      end do
   end subroutine test_positive

   subroutine test_range()
      real(wp), parameter :: limits(2) = [-0.25_wp, 1000.0_wp]
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, 2
         call check_range(error, 'shift', limits(i), limits(1), limits(2), ' mm')
         call assertFalse(allocated(error))
         call check_range(error, 'shift', nearest(limits(i), 2.0_wp*i - 3.0_wp), limits(1), &
            limits(2), ' mm')
         call assertTrue(allocated(error))
         if (.not. allocated(error)) return
         call assertEqual('shift', error%subject)
         call assertTrue(index(error%message, 'between -0.25 and 1000.0 mm') > 0, error%message)
         deallocate (error)
      end do
   end subroutine test_range

end module test_base_error
