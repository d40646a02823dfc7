!> POSIX threads, so that the tests need no compiler flag for threads.
module threads
   use, intrinsic :: iso_c_binding, only: c_funloc, c_funptr, c_int, c_intptr_t, c_loc, &
      c_null_ptr, c_ptr
   implicit none
   private
   public :: run_two

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
      !> What a thread runs; the argument is its number.
      function thread_routine(argument) bind(c) result(answer)
         import :: c_ptr
         implicit none
         type(c_ptr), value :: argument
         type(c_ptr) :: answer
      end function thread_routine
   end interface

contains

   !> Run the routine in two threads at once, with pointers to 1 and 2; `ok` when both ended.
   subroutine run_two(routine, ok)
      procedure(thread_routine) :: routine
      logical, intent(out) :: ok
      integer(c_int), target :: numbers(2)
      integer(c_intptr_t) :: ids(2)
      integer(c_int) :: status(2)
      integer :: i

      numbers = [1_c_int, 2_c_int]
      do i = 1, 2
         status(i) = pthread_create(ids(i), c_null_ptr, c_funloc(routine), c_loc(numbers(i)))
      end do
      ok = all(status == 0)
      if (.not. ok) return
      do i = 1, 2
         status(i) = pthread_join(ids(i), c_null_ptr)
      end do
      ok = all(status == 0)
   end subroutine run_two

end module threads
