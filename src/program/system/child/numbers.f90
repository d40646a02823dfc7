!> Numbers as text, bit by bit, on their way from a child process.
module asperity_program_system_child_numbers
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_base_text_builder, only: growing_text
   implicit none
   private
   public :: add_numbers, numbers_of

   !> Characters of a number with its line break
   integer, parameter :: of_number = 17

contains

   !> Append numbers, one a line.
   pure subroutine add_numbers(buffer, values)
      !> The text
      type(growing_text), intent(inout) :: buffer
      !> The numbers
      real(wp), intent(in) :: values(:)
      character(len=of_number - 1) :: word
      integer :: i

      do i = 1, size(values)
         write (word, '(z16.16)') transfer(values(i), 0_int64)
         call buffer%line(word)
      end do
   end subroutine add_numbers

   !> The numbers of such a text.
   pure function numbers_of(text) result(values)
      !> From `add_numbers`
      character(len=*), intent(in) :: text
      real(wp) :: values(len(text)/of_number)
      integer(int64) :: bits
      integer :: i

      do i = 1, size(values)
         read (text((i - 1)*of_number + 1:i*of_number - 1), '(z16)') bits
         values(i) = transfer(bits, 0.0_wp)
      end do
   end function numbers_of

end module asperity_program_system_child_numbers
