!> The lines of a file, or of a memory that stands for one, without holding more than a block.
module asperity_height_map_bytes_lines
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_intptr_t, c_loc, c_ptr, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_libc, only: c_memchr, c_memmove
   use asperity_base_memory, only: check_memory
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   implicit none
   private
   public :: next_line, replace_in_line, start_lines

   !> Bytes of the longest line
   integer, parameter :: longest_line = 2**26
   integer, parameter :: line_feed = 10, carriage_return = 13

contains

   !> Begin to read lines, after `offset` bytes. A file without line feeds ends its lines with
   !> carriage returns.
   subroutine start_lines(source, offset, error)
      !> The source
      type(byte_source), intent(inout), target :: source
      !> Bytes before the first line
      integer(int64), intent(in) :: offset
      !> Set when the source cannot be read
      type(error_type), allocatable, intent(out) :: error
      integer :: cut, status

      source%start = offset
      source%filled = 0
      source%next = 1
      source%line = 0_int64
      status = 0
      if (.not. allocated(source%block)) &
         allocate (source%block(source%block_length), stat=status)
      call check_memory(status, source%name, int(source%block_length, int64), error)
      if (allocated(error)) return
      call refill(source, error)
      if (allocated(error)) return
      source%line_end = line_feed
      if (position_of(source, 1, line_feed) > 0) return
      cut = position_of(source, 1, carriage_return)
      if (cut > 0 .and. cut < source%filled) source%line_end = carriage_return
   end subroutine start_lines

   !> Go to the next line.
   subroutine next_line(source, found, error)
      !> The source; `first` and `last` are the line's place in its block
      type(byte_source), intent(inout), target :: source
      !> False after the last line
      logical, intent(out) :: found
      !> Set when the source cannot be read
      type(error_type), allocatable, intent(out) :: error
      integer :: finish, searched

      found = .false.
      searched = source%next
      do
         finish = position_of(source, searched, source%line_end)
         if (finish > 0) exit
         if (source%start + source%filled >= source%size) then
            if (source%next > source%filled) return
            finish = source%filled + 1
            exit
         end if
         searched = source%filled - source%next + 2
         call refill(source, error)
         if (allocated(error)) return
      end do
      found = .true.
      source%line = source%line + 1_int64
      source%first = source%next
      source%last = finish - 1
      source%next = finish + 1
      ! GDAL's Surfer grid ends with two
      do while (source%last >= source%first)
         if (ichar(source%block(source%last)) /= carriage_return) exit
         source%last = source%last - 1
      end do
   end subroutine next_line

   !> Replace a character in the current line.
   pure subroutine replace_in_line(source, old, new)
      !> The source
      type(byte_source), intent(inout) :: source
      !> What goes and what comes
      character(len=1), intent(in) :: old, new
      integer :: i

      do i = source%first, source%last
         if (source%block(i) == old) source%block(i) = new
      end do
   end subroutine replace_in_line

   !> Place of a byte in the block from `from` on, 0 if it is not there.
   integer function position_of(source, from, byte)
      type(byte_source), intent(in), target :: source
      integer, intent(in) :: from
      integer, intent(in) :: byte
      type(c_ptr) :: place

      position_of = 0
      if (from > source%filled) return
      place = c_memchr(c_loc(source%block(from)), int(byte, c_int), &
         int(source%filled - from + 1, c_size_t))
      if (c_associated(place)) position_of = from + int(transfer(place, 0_c_intptr_t) - &
         transfer(c_loc(source%block(from)), 0_c_intptr_t))
   end function position_of

   !> Move the beginning of a line to the front of the block, which grows where the line fills it,
   !> and read what follows.
   subroutine refill(source, error)
      type(byte_source), intent(inout), target :: source
      type(error_type), allocatable, intent(out) :: error
      character(len=1), allocatable, target :: larger(:)
      type(c_ptr) :: unused
      integer :: kept, added, status

      kept = source%filled - source%next + 1
      if (2*kept > size(source%block)) then
         if (size(source%block) >= longest_line) then
            call fatal_error(error, source%name//': has a line of more than '// &
               to_text(longest_line/2**20)//' MiB: this is no table of heights', file_error)
            return
         end if
         allocate (larger(2*size(source%block)), stat=status)
         call check_memory(status, source%name, 2_int64*size(source%block), error)
         if (allocated(error)) return
         unused = c_memmove(c_loc(larger), c_loc(source%block(source%next)), int(kept, c_size_t))
         call move_alloc(larger, source%block)
      else if (kept > 0 .and. source%next > 1) then
         unused = c_memmove(c_loc(source%block), c_loc(source%block(source%next)), &
            int(kept, c_size_t))
      end if
      source%start = source%start + source%next - 1
      source%next = 1
      added = int(min(int(size(source%block) - kept, int64), source%size - source%start - kept))
      source%filled = kept + max(added, 0)
      if (added > 0) call read_at(source, source%start + kept, c_loc(source%block(kept + 1)), &
         int(added, int64), error)
   end subroutine refill

end module asperity_height_map_bytes_lines
