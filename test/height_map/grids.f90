!> Grids that coordinates are on, or are not.
module test_height_map_grids
   use asperity_base_kinds, only: wp
   use asperity_height_map_text_find_grid, only: find_grid
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_map_grids

contains

   function suite_map_grids() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('map grids')
      call suite%addTest(TestMethod('limits of a grid', test_grid))
      call suite%addTest(TestMethod('grids of five figures', test_five_figures))
   end function suite_map_grids

   !> The limits of a grid: two lines for each that has points, points a twentieth of a step off,
   !> or twice the rounding of their figures, and coordinates that are one as they differ by 1e-4
   !> of the largest gap.
   subroutine test_grid()
      call check([0.0_wp, 1.0_wp, 5.0_wp], 6)
      call check([0.0_wp, 1.0_wp, 6.0_wp], 0)
      call check([0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 8.0_wp], 9)
      call check([0.0_wp, 15.0_wp, 32.0_wp, 48.0_wp, 64.0_wp], 0)
      call check([0.0_wp, 15.5_wp, 32.0_wp, 48.0_wp, 64.0_wp], 5)
      call check([0.0_wp, 15.0_wp, 32.0_wp, 48.0_wp, 64.0_wp], 0, 0.49_wp)
      call check([0.0_wp, 15.0_wp, 32.0_wp, 48.0_wp, 64.0_wp], 5, 0.51_wp)
      ! a tenth of a step, with a line missing; the same if more is allowed than leaves a gap sure
      call check([0.0_wp, 4.5_wp, 10.0_wp, 15.0_wp, 24.5_wp, 30.4_wp, 35.0_wp], 8, 0.5_wp)
      call check([0.0_wp, 4.5_wp, 10.0_wp, 15.0_wp, 24.5_wp, 30.4_wp, 35.0_wp], 0, 0.8_wp)
      call check([0.0_wp, 1.0_wp, 2.0_wp, 2.0_wp + 0.9999e-4_wp], 3)
      call check([0.0_wp, 1.0_wp, 2.0_wp, 2.0_wp + 1.0001e-4_wp], 0)
   contains
      !> Number of lines, 0 for no grid.
      subroutine check(values, lines, rounding)
         real(wp), intent(in) :: values(:)
         integer, intent(in) :: lines
         real(wp), intent(in), optional :: rounding
         integer :: places(size(values)), points
         real(wp) :: allowed, step
         logical :: is_rounded
         character(len=:), allocatable :: reason

         allowed = 0.0_wp
         if (present(rounding)) allowed = rounding
         call find_grid(values, allowed, places, points, step, is_rounded, reason)
         call assertTrue(allocated(reason) .eqv. lines == 0, 'grid')
         if (allocated(reason)) return
         call assertEqual(lines, points, 'lines')
         call assertTrue(is_rounded .eqv. present(rounding), 'rounded')
      end subroutine check
   end subroutine test_grid

   !> Random grids of 20 to 2000 lines in any order, a tenth of them missing, printed with five
   !> figures: found as long as these leave an eighth of a step, and the step is off by no more than
   !> the rounding of both ends.
   subroutine test_five_figures()
      type(random_stream) :: stream
      character(len=24) :: text
      real(wp), allocatable :: values(:)
      integer, allocatable :: places(:), expected(:)
      real(wp) :: chance, first, found, rounding, step
      integer :: draw, i, k, n, points
      logical :: is_rounded
      character(len=:), allocatable :: reason

      stream%state = 4711
      do draw = 1, 300
         n = int(stream%log_uniform(20.0_wp, 2000.0_wp))
         step = stream%log_uniform(1.0e-7_wp, 1.0_wp)
         first = step*n*stream%uniform(-1.0_wp, 1.0_wp)
         rounding = 0.5e-4_wp*10.0_wp**floor(log10(max(abs(first), abs(first + (n - 1)*step))))
         if (rounding > 0.115_wp*step) cycle
         values = [real(wp) ::]
         expected = [integer ::]
         do k = n, 1, -1
            i = mod(7919*k, n)
            chance = stream%uniform(0.0_wp, 1.0_wp)
            if (i > 0 .and. i < n - 1 .and. chance < 0.1_wp) cycle
            write (text, '(es11.4)') first + i*step
            read (text, *) found
            values = [values, found]
            expected = [expected, i + 1]
         end do
         allocate (places(size(values)))
         call find_grid(values, rounding, places, points, found, is_rounded, reason)
         call assertFalse(allocated(reason), 'on a grid')
         call assertEqual(n, points)
         call assertTrue(all(places == expected), 'places')
         call assertEqual(step, found, 2.01_wp*rounding/(n - 1))
         deallocate (places)
      end do
   end subroutine test_five_figures

end module test_height_map_grids
