!> A text that grows: adding to it costs time in proportion to what is added.
module deck_growing_text
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: growing_text

   !> Text under construction.
   type :: growing_text
      private
      character(len=:), allocatable :: storage
      integer(int64) :: used = 0_int64
   contains
      !> Append text
      procedure :: add
      !> Append text and a line break
      procedure :: line
      !> The text so far
      procedure :: text => built_text
   end type growing_text

contains

   !> Append text.
   pure subroutine add(self, text)
      !> The growing text
      class(growing_text), intent(inout) :: self
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
      !> The growing text
      class(growing_text), intent(inout) :: self
      !> What to append; only the line break when absent
      character(len=*), intent(in), optional :: text

      if (present(text)) call self%add(text)
      call self%add(new_line('a'))
   end subroutine line

   !> The text so far.
   pure function built_text(self) result(text)
      !> The growing text
      class(growing_text), intent(in) :: self
      character(len=:), allocatable :: text

      text = ''
      if (allocated(self%storage)) text = self%storage(:self%used)
   end function built_text

end module deck_growing_text
