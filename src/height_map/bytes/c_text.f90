!> Strings of C as characters.
module asperity_height_map_bytes_c_text
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_ptr, c_size_t
   use asperity_base_libc, only: c_strlen
   implicit none
   private
   public :: get_string

contains

   !> Copy a string of C, at most so many characters.
   subroutine get_string(from, longest, text)
      !> Where it begins; a null pointer stands for an empty one
      type(c_ptr), intent(in) :: from
      !> Most characters
      integer, intent(in) :: longest
      !> The copy
      character(len=:), allocatable, intent(out) :: text
      character(kind=c_char), pointer :: letters(:)
      integer :: i, n

      text = ''
      if (.not. c_associated(from)) return
      n = int(min(c_strlen(from), int(longest, c_size_t)))
      call c_f_pointer(from, letters, [n])
      text = repeat(' ', n)
      do i = 1, n
         text(i:i) = letters(i)
      end do
   end subroutine get_string

end module asperity_height_map_bytes_c_text
