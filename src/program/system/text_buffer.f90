!> A growing text that also takes numbers for gnuplot.
module asperity_program_system_text_buffer
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_text_builder, only: growing_text
   implicit none
   private
   public :: text_buffer

   !> Text under construction.
   type, extends(growing_text) :: text_buffer
   contains
      !> Append a line of numbers for gnuplot
      procedure :: numbers
   end type text_buffer

contains

   !> Append a line of numbers for gnuplot; `none` becomes NaN.
   pure subroutine numbers(self, values)
      !> The buffer
      class(text_buffer), intent(inout) :: self
      !> The numbers
      real(wp), intent(in) :: values(:)
      character(len=17) :: number
      integer :: i

      do i = 1, size(values)
         number = ' NaN'
         if (.not. is_none(values(i))) write (number, '(es17.8e3)') values(i)
         call self%add(number)
      end do
      call self%line()
   end subroutine numbers

end module asperity_program_system_text_buffer
