!> Ranges of sizes: their ends, and the units that values outside them look like.
module test_replay_sizes
   use asperity, only: error_type, wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_sizes, only: check_size, ranges
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_sizes

contains

   function suite_sizes() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('sizes')
      call suite%addTest(TestMethod('the ranges', test_ranges))
      call suite%addTest(TestMethod('ends of every range', test_ends))
      call suite%addTest(TestMethod('no size passes in another unit', test_units))
   end function suite_sizes

   !> The ends as they are stated.
   subroutine test_ranges()
      real(wp), parameter :: ends(2, 43) = reshape([ &
         5.0_wp, 4000.0_wp, 5.0_wp, 4000.0_wp, 3.0_wp, 2000.0_wp, 1.0_wp, 900.0_wp, &
         20.0_wp, 19000.0_wp, 0.01_wp, 9.0_wp, 0.01_wp, 9.0_wp, 0.8_wp, 790.0_wp, &
         0.01_wp, 9.0_wp, 2.5_wp, 2400.0_wp, 2.5_wp, 2400.0_wp, 40.0_wp, 39000.0_wp, &
         40.0_wp, 39000.0_wp, 40.0_wp, 39000.0_wp, 4.0_wp, 3900.0_wp, 4.0_wp, 3900.0_wp, &
         4.0_wp, 3900.0_wp, 0.3_wp, 200.0_wp, 0.3_wp, 200.0_wp, 0.3_wp, 200.0_wp, &
         0.3_wp, 290.0_wp, 0.3_wp, 290.0_wp, 0.3_wp, 290.0_wp, &
         0.3_wp, 200.0_wp, 0.3_wp, 200.0_wp, 0.3_wp, 200.0_wp, &
         0.5_wp, 490.0_wp, 0.5_wp, 490.0_wp, 0.5_wp, 490.0_wp, 0.005_wp, 4.9_wp, &
         0.005_wp, 4.9_wp, 500.0_wp, 490000.0_wp, 0.005_wp, 4.9_wp, 5.0_wp, 900.0_wp, &
         1.0_wp, 900.0_wp, 0.5_wp, 490.0_wp, 0.5_wp, 490.0_wp, 16.0_wp, 15000.0_wp, &
         5.0_wp, 4000.0_wp, 5.0_wp, 4000.0_wp, 0.05_wp, 40.0_wp, 0.005_wp, 4.0_wp, 0.05_wp, &
         40.0_wp], [2, 43])

      call assertEqual(ends(1, :), ranges%lowest, 0.0_wp, 'lowest')
      call assertEqual(ends(2, :), ranges%highest, 0.0_wp, 'highest')
   end subroutine test_ranges

   !> The ends pass, the numbers next to them do not, and zero does; with either sign.
   subroutine test_ends()
      integer :: i

      do i = 1, size(ranges)
         associate (r => ranges(i)%name, low => ranges(i)%lowest, high => ranges(i)%highest)
            call expect(r, low, .true.)
            call expect(r, high, .true.)
            call expect(r, -high, .true.)
            call expect(r, 0.0_wp, .true.)
            call expect(r, nearest(high, 1.0_wp), .false.)
            call expect(r, -nearest(high, 1.0_wp), .false.)
            call expect(r, nearest(low, -1.0_wp), .false.)
         end associate
      end do

   contains

      subroutine expect(name, value, good)
         character(len=*), intent(in) :: name
         real(wp), intent(in) :: value
         logical, intent(in) :: good
         type(error_type), allocatable :: error

         call check_size(error, trim(name), value, .false.)
         call assertTrue(good .neqv. allocated(error), trim(name)//' '//to_text(value))
         if (allocated(error)) call assertEqual(1, index(error%message, trim(name)//' = '// &
            to_text(value)//' '), error%message)
         if (allocated(error)) deallocate (error)
         call check_size(error, trim(name), value, .true.)
         call assertFalse(allocated(error), 'accepted')
      end subroutine expect

   end subroutine test_ends

   !> Sizes all over each range, written in metres and micrometres, kPa and GPa, kN: each is
   !> refused, and the message says the unit and the size that is meant.
   subroutine test_units()
      real(wp), parameter :: shares(5) = [0.0_wp, 0.2_wp, 0.5_wp, 0.8_wp, 1.0_wp]
      real(wp) :: size_meant
      integer :: i, j

      do i = 1, size(ranges)
         call assertLessThan(ranges(i)%highest, 1000.0_wp*ranges(i)%lowest, trim(ranges(i)%name))
         do j = 1, size(shares)
            ! three figures, so that the text is short
            size_meant = ranges(i)%lowest*(ranges(i)%highest/ranges(i)%lowest)**shares(j)
            size_meant = rounded(size_meant)
            select case (ranges(i)%unit)
            case ('mm')
               call expect(0.001_wp, 'metres')
               call expect(1000.0_wp, 'micrometres')
            case ('MPa')
               call expect(0.001_wp, 'GPa')
               call expect(1000.0_wp, 'kPa')
               call expect(1.0e6_wp, 'Pa')
            case default
               call expect(0.001_wp, 'kN')
            end select
         end do
      end do

   contains

      subroutine expect(factor, unit)
         real(wp), intent(in) :: factor
         character(len=*), intent(in) :: unit
         type(error_type), allocatable :: error

         call check_size(error, trim(ranges(i)%name), factor*size_meant, .false.)
         call assertTrue(allocated(error), trim(ranges(i)%name)//' in '//unit)
         if (allocated(error)) call assertTrue(index(error%message, ' looks like '//unit// &
            ', write '//to_text(size_meant)//';') > 0, error%message)
      end subroutine expect

   end subroutine test_units

   !> To three figures.
   real(wp) function rounded(value)
      real(wp), intent(in) :: value
      character(len=32) :: text

      text = to_text(value, 3)
      read (text, *) rounded
   end function rounded

end module test_replay_sizes
