!> Errors are values: an allocatable `error_type` is unset on success. Nothing in the library
!> prints or stops.
module asperity_base_error
   implicit none
   private
   public :: error_type, fatal_error

   !> What kind of failure it is; the program uses the number as its exit status.
   integer, parameter, public :: computation_error = 1
   !> A value that is not allowed.
   integer, parameter, public :: input_error = 2
   !> A file that cannot be read or written.
   integer, parameter, public :: file_error = 3

   !> One failure. The message names the thing, its value, what is allowed and what to do.
   type :: error_type
      !> `computation_error`, `input_error` or `file_error`
      integer :: category = computation_error
      !> One line of text without a full stop at its end
      character(len=:), allocatable :: message
      !> Names of the values that it is about, as the API calls them, with a blank between: `sigma`,
      !> `eta radius sigma`; empty when it is about none
      character(len=:), allocatable :: subject
   end type error_type

contains

   !> Set `error` to a failure.
   pure subroutine fatal_error(error, message, category, subject)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> What went wrong
      character(len=*), intent(in) :: message
      !> Kind of failure; `input_error` when absent
      integer, intent(in), optional :: category
      !> Names of the values that it is about; empty when absent
      character(len=*), intent(in), optional :: subject

      allocate (error)
      ! allocated in so many words: ABAQUS may compile without allocation by assignment
      allocate (error%message, source=message)
      if (present(subject)) then
         allocate (error%subject, source=subject)
      else
         allocate (error%subject, source='')
      end if
      error%category = input_error
      if (present(category)) error%category = category
   end subroutine fatal_error

end module asperity_base_error
