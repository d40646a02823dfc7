!> Numbers whose count is not known beforehand, in chunks: nothing is ever copied to grow, and what
!> has been used can be given back chunk by chunk, so that numbers and map are hardly ever both
!> there as a whole.
module asperity_height_map_bytes_number_chunks
   use, intrinsic :: iso_fortran_env, only: int32, int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory
   implicit none
   private
   public :: number_store

   !> Numbers of the first and of the largest chunk
   integer, parameter :: smallest_chunk = 2**12, largest_chunk = 2**19

   type :: chunk_type
      real(wp), allocatable :: values(:)
      integer(int32), allocatable :: places(:)
   end type chunk_type

   !> Numbers, each with an integer that says its place if wanted.
   type :: number_store
      !> How many
      integer(int64) :: count = 0_int64
      !> Chunks in use
      integer :: chunks = 0
      type(chunk_type), allocatable, private :: chunk(:)
      integer, private :: used = 0, room = 0
   contains
      !> Append one
      procedure :: add
      !> Append one with its place
      procedure :: add_placed
      !> Take the numbers of a chunk out
      procedure :: take
   end type number_store

contains

   !> Append a number.
   subroutine add(self, value, name, error)
      !> The store
      class(number_store), intent(inout) :: self
      !> The number
      real(wp), intent(in) :: value
      !> Name of the file
      character(len=*), intent(in) :: name
      !> Set when there is not enough memory
      type(error_type), allocatable, intent(inout) :: error

      if (self%used == self%room) call new_chunk(self, .false., name, error)
      if (allocated(error)) return
      self%used = self%used + 1
      self%count = self%count + 1_int64
      self%chunk(self%chunks)%values(self%used) = value
   end subroutine add

   !> Append a number with its place.
   subroutine add_placed(self, value, place, name, error)
      !> The store
      class(number_store), intent(inout) :: self
      !> The number
      real(wp), intent(in) :: value
      !> Its place, as the caller counts
      integer(int32), intent(in) :: place
      !> Name of the file
      character(len=*), intent(in) :: name
      !> Set when there is not enough memory
      type(error_type), allocatable, intent(inout) :: error

      if (self%used == self%room) call new_chunk(self, .true., name, error)
      if (allocated(error)) return
      self%used = self%used + 1
      self%count = self%count + 1_int64
      self%chunk(self%chunks)%values(self%used) = value
      self%chunk(self%chunks)%places(self%used) = place
   end subroutine add_placed

   subroutine new_chunk(self, with_places, name, error)
      type(number_store), intent(inout) :: self
      logical, intent(in) :: with_places
      character(len=*), intent(in) :: name
      type(error_type), allocatable, intent(inout) :: error
      type(chunk_type), allocatable :: longer(:)
      integer :: i, room, status

      status = 0
      room = min(largest_chunk, max(smallest_chunk, 2*self%room))
      if (.not. allocated(self%chunk)) allocate (self%chunk(16), stat=status)
      if (status == 0 .and. self%chunks == size(self%chunk)) then
         allocate (longer(2*size(self%chunk)), stat=status)
         if (status == 0) then
            do i = 1, self%chunks
               call move_alloc(self%chunk(i)%values, longer(i)%values)
               call move_alloc(self%chunk(i)%places, longer(i)%places)
            end do
            call move_alloc(longer, self%chunk)
         end if
      end if
      if (status == 0) allocate (self%chunk(self%chunks + 1)%values(room), stat=status)
      if (status == 0 .and. with_places) &
         allocate (self%chunk(self%chunks + 1)%places(room), stat=status)
      call check_memory(status, name, 8_int64*room + merge(4_int64*room, 0_int64, with_places), &
         error)
      if (allocated(error)) return
      self%room = room
      self%chunks = self%chunks + 1
      self%used = 0
   end subroutine new_chunk

   !> Take the numbers of a chunk out, so that their memory is given back with `values`.
   subroutine take(self, number, values, length, places)
      !> The store
      class(number_store), intent(inout) :: self
      !> Which chunk
      integer, intent(in) :: number
      !> The numbers, the first `length` of them valid
      real(wp), allocatable, intent(out) :: values(:)
      !> How many
      integer, intent(out) :: length
      !> Their places
      integer(int32), allocatable, intent(out), optional :: places(:)

      call move_alloc(self%chunk(number)%values, values)
      if (present(places)) call move_alloc(self%chunk(number)%places, places)
      length = size(values)
      if (number == self%chunks) length = self%used
   end subroutine take

end module asperity_height_map_bytes_number_chunks
