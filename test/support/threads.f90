!> POSIX threads, so that the tests need no compiler flag for threads.
module threads
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_funloc, c_funptr, c_int, c_intptr_t, &
      c_loc, c_null_ptr, c_ptr
   use asperity_base_kinds, only: wp
   use funit, only: assertEqual, assertTrue
   implicit none
   private
   public :: check_two_threads

   interface
      integer(c_int) function pthread_create(thread, attributes, routine, argument) &
            bind(c, name='pthread_create')
         import :: c_funptr, c_int, c_intptr_t, c_ptr
         implicit none
         integer(c_intptr_t), intent(out) :: thread
         type(c_ptr), value :: attributes
         type(c_funptr), value :: routine
         type(c_ptr), value :: argument
      end function pthread_create
      integer(c_int) function pthread_join(thread, answer) bind(c, name='pthread_join')
         import :: c_int, c_intptr_t, c_ptr
         implicit none
         integer(c_intptr_t), value :: thread
         type(c_ptr), value :: answer
      end function pthread_join
   end interface

   abstract interface
      !> What a thread computes: sums of the thread with a number, 1 or 2.
      subroutine thread_work(number, sums)
         import :: wp
         implicit none
         integer, intent(in) :: number
         real(wp), intent(out) :: sums(:)
      end subroutine thread_work
   end interface

   !> The work of one thread.
   type :: thread_task
      procedure(thread_work), pointer, nopass :: work => null()
      real(wp), allocatable :: sums(:)
   end type thread_task

   !> Of the two threads; each writes its own only
   type(thread_task) :: tasks(2)

contains

   !> Do the work of both numbers one after the other, then in two threads at once: the sums, so
   !> many of each, have the same bits, and those of the two numbers differ.
   subroutine check_two_threads(work, amount)
      procedure(thread_work) :: work
      integer, intent(in) :: amount
      integer(c_int), target :: numbers(2)
      real(wp) :: serial(amount, 2)
      integer(c_intptr_t) :: ids(2)
      integer(c_int) :: status(2)
      integer :: i

      numbers = [1_c_int, 2_c_int]
      do i = 1, 2
         call work(i, serial(:, i))
         tasks(i)%work => work
         tasks(i)%sums = spread(0.0_wp, 1, amount)
      end do
      do i = 1, 2
         status(i) = pthread_create(ids(i), c_null_ptr, c_funloc(run_task), c_loc(numbers(i)))
      end do
      call assertTrue(all(status == 0), 'threads started')
      if (any(status /= 0)) return
      do i = 1, 2
         status(i) = pthread_join(ids(i), c_null_ptr)
      end do
      call assertTrue(all(status == 0), 'threads ended')
      do i = 1, 2
         call assertEqual(serial(:, i), tasks(i)%sums, 0.0_wp, 'bits')
      end do
      call assertTrue(abs(serial(1, 1) - serial(1, 2)) > 0.0_wp, 'the two differ')
   end subroutine check_two_threads

   function run_task(argument) bind(c) result(answer)
      type(c_ptr), value :: argument
      type(c_ptr) :: answer
      integer(c_int), pointer :: number

      call c_f_pointer(argument, number)
      call tasks(number)%work(int(number), tasks(number)%sums)
      answer = c_null_ptr
   end function run_task

end module threads
