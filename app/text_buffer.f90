!> A text that grows: adding to it costs time in proportion to what is added.
module app_text_buffer
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use app_strings, only: newline
   implicit none
   private
   public :: text_buffer

   !> Text under construction.
   type :: text_buffer
      private
      character(len=:), allocatable :: storage
      integer(int64) :: used = 0_int64
   contains
      !> Append text
      procedure :: add
      !> Append text and a line break
      procedure :: line
      !> Append a line of numbers for gnuplot
      procedure :: numbers
      !> The text so far
      procedure :: text => built_text
   end type text_buffer

contains

   !> Append text.
   pure subroutine add(self, text)
      !> The buffer
      class(text_buffer), intent(inout) :: self
      !> What to append
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: kept
      integer(int64) :: needed

      needed = self%used + len(text, int64)
      if (.not. allocated(self%storage)) then
         allocate (character(len=max(4096_int64, needed)) :: self%storage)
      else if (needed > len(self%storage, int64)) then
         ! Not by concatenation, whose result flang puts on the stack
         allocate (character(len=self%used) :: kept)
         kept(:) = self%storage(:self%used)
         deallocate (self%storage)
         allocate (character(len=2_int64*needed) :: self%storage)
         self%storage(:self%used) = kept
      end if
      self%storage(self%used + 1:needed) = text
      self%used = needed
   end subroutine add

   !> Append text and a line break.
   pure subroutine line(self, text)
      !> The buffer
      class(text_buffer), intent(inout) :: self
      !> What to append; only the line break when absent
      character(len=*), intent(in), optional :: text

      if (present(text)) call self%add(text)
      call self%add(newline)
   end subroutine line

   !> Append a line of numbers for gnuplot; huge(1.0_wp), which stands for none, becomes NaN.
   pure subroutine numbers(self, values)
      !> The buffer
      class(text_buffer), intent(inout) :: self
      !> The numbers
      real(wp), intent(in) :: values(:)
      character(len=17) :: number
      integer :: i

      do i = 1, size(values)
         number = ' NaN'
         if (values(i) < huge(1.0_wp)) write (number, '(es17.8e3)') values(i)
         call self%add(number)
      end do
      call self%line()
   end subroutine numbers

   !> The text so far.
   pure function built_text(self) result(text)
      !> The buffer
      class(text_buffer), intent(in) :: self
      character(len=:), allocatable :: text

      text = ''
      if (allocated(self%storage)) text = self%storage(:self%used)
   end function built_text

end module app_text_buffer
