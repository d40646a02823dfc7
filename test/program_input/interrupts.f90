!> Interrupts that are put off: none is lost.
module test_program_input_interrupts
   use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int
   use asperity_program_system_posix, only: c_raise, c_signal
   use asperity_program_system_process, only: held_interrupts, hold_interrupts, release_interrupts
   use funit, only: assertEqual, TestMethod, TestSuite
   implicit none
   private
   public :: suite_interrupts

   !> SIGUSR1 and SIGTERM
   integer(c_int), parameter :: numbers(2) = [10_c_int, 15_c_int]
   integer :: heard = 0, last = 0

contains

   function suite_interrupts() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('interrupts')
      call suite%addTest(TestMethod('come when they are let, and once', test_put_off))
   end function suite_interrupts

   subroutine test_put_off()
      type(held_interrupts) :: held, within
      type(c_funptr) :: before(size(numbers)), own
      integer(c_int) :: status
      integer :: i

      do i = 1, size(numbers)
         before(i) = c_signal(numbers(i), c_funloc(hear))
         heard = 0
         call hold_interrupts(held)
         status = c_raise(numbers(i))
         call hold_interrupts(within)
         status = c_raise(numbers(i))
         call release_interrupts(within)
         call assertEqual(0, heard, 'while held')
         call release_interrupts(held)
         call assertEqual(1, heard, 'when let')
         call assertEqual(int(numbers(i)), last)
         call hold_interrupts(held)
         call release_interrupts(held)
         call assertEqual(1, heard, 'not again')
         call hold_interrupts(held)
         status = c_raise(numbers(i))
         call release_interrupts(held, is_ending=.true.)
         call hold_interrupts(held)
         call release_interrupts(held)
         call assertEqual(1, heard, 'forgotten at the end')
         own = c_signal(numbers(i), before(i))
      end do
   end subroutine test_put_off

   subroutine hear(number) bind(c, name='')
      integer(c_int), value :: number

      heard = heard + 1
      last = int(number)
   end subroutine hear

end module test_program_input_interrupts
