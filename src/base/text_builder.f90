!> A text that grows: adding to it costs time in proportion to what is added.
module asperity_base_text_builder
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_memory, only: check_memory, check_room, worth_a_look
   implicit none
   private
   public :: growing_text

   !> Text under construction. Once there is no memory for it, it takes nothing more, and cannot be
   !> had.
   type :: growing_text
      private
      character(len=:), allocatable :: storage
      integer(int64) :: used = 0_int64
      !> Set when there was no memory
      type(error_type), allocatable :: error
   contains
      !> Append text
      procedure :: add
      !> Append text and a line break
      procedure :: line
      !> Take a text that may be large
      procedure :: take
      !> A text that is small
      procedure :: text => built_text
   end type growing_text

   integer(int64), parameter :: first_room = 4096_int64

contains

   !> Append text.
   pure subroutine add(self, text)
      !> The growing text
      class(growing_text), intent(inout) :: self
      !> What to append
      character(len=*), intent(in) :: text
      integer(int64) :: needed

      if (allocated(self%error)) return
      needed = self%used + len(text, int64)
      if (.not. allocated(self%storage)) then
         call resize(self, max(first_room, needed))
      else if (needed > len(self%storage, int64)) then
         call resize(self, 2_int64*needed)
      end if
      if (allocated(self%error)) return
      self%storage(self%used + 1:needed) = text
      self%used = needed
   end subroutine add

   !> Give the storage another length, and keep what is used of it.
   pure subroutine resize(self, length)
      class(growing_text), intent(inout) :: self
      integer(int64), intent(in) :: length
      character(len=:), allocatable :: resized
      integer :: status

      allocate (character(len=length) :: resized, stat=status)
      if (status == 0) then
         if (self%used > 0_int64) resized(:self%used) = self%storage(:self%used)
         call move_alloc(resized, self%storage)
         if (length > worth_a_look) call check_room('the text', 0_int64, self%error)
      else
         call check_memory(status, 'the text', length, self%error)
      end if
      if (allocated(self%error) .and. allocated(self%storage)) deallocate (self%storage)
   end subroutine resize

   !> Append text and a line break.
   pure subroutine line(self, text)
      !> The growing text
      class(growing_text), intent(inout) :: self
      !> What to append; only the line break when absent
      character(len=*), intent(in), optional :: text

      if (present(text)) call self%add(text)
      call self%add(new_line('a'))
   end subroutine line

   !> Take the text, which is gone then.
   pure subroutine take(self, text, error)
      !> The growing text
      class(growing_text), intent(inout) :: self
      !> The text, empty on failure
      character(len=:), allocatable, intent(out) :: text
      !> Set when there was not enough memory for it
      type(error_type), allocatable, intent(out) :: error

      if (self%used < len_of(self%storage)) call resize(self, self%used)
      if (allocated(self%error)) then
         call move_alloc(self%error, error)
      else if (allocated(self%storage)) then
         call move_alloc(self%storage, text)
      end if
      if (.not. allocated(text)) text = ''
      self%used = 0_int64
   end subroutine take

   !> Length of a text, zero if it is not allocated.
   pure integer(int64) function len_of(text)
      character(len=:), allocatable, intent(in) :: text

      len_of = 0_int64
      if (allocated(text)) len_of = len(text, int64)
   end function len_of

   !> The text so far, of which there is little. Without memory even for that the program ends.
   pure function built_text(self) result(text)
      !> The growing text
      class(growing_text), intent(in) :: self
      character(len=:), allocatable :: text

      if (allocated(self%error)) error stop 'not enough memory'
      text = ''
      if (allocated(self%storage)) text = self%storage(:self%used)
   end function built_text

end module asperity_base_text_builder
