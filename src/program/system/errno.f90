!> Why the last call of the operating system failed.
module asperity_program_system_errno
   use, intrinsic :: iso_c_binding, only: c_char, c_f_pointer, c_int, c_ptr
   use asperity_base_libc, only: c_strlen
   use asperity_program_system_posix, only: c_errno_location, c_strerror
   implicit none
   private
   public :: last_error, last_reason

   !> Numbers of failures: interrupted call, locked by another process, not possible for this file
   integer(c_int), parameter, public :: eintr = 4_c_int, ewouldblock = 11_c_int, einval = 22_c_int

contains

   !> The C variable errno.
   integer(c_int) function last_error()
      integer(c_int), pointer :: number

      call c_f_pointer(c_errno_location(), number)
      last_error = number
   end function last_error

   !> The system's words for the last failure.
   function last_reason() result(reason)
      character(len=:), allocatable :: reason
      character(kind=c_char), pointer :: letters(:)
      type(c_ptr) :: words
      integer :: i, length

      words = c_strerror(last_error())
      length = int(c_strlen(words))
      call c_f_pointer(words, letters, [length])
      allocate (character(len=length) :: reason)
      do i = 1, length
         reason(i:i) = letters(i)
      end do
   end function last_reason

end module asperity_program_system_errno
