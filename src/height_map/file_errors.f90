!> Errors that name a place of a file: line and column, or byte.
module asperity_height_map_file_errors
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   implicit none
   private
   public :: byte_error, excerpt, fits_memory, line_error, line_text, map_error, &
      plain_excerpt

   !> Characters of a file that a message shows
   integer, parameter :: shown = 40

contains

   !> Set `error` to a fault of the file as a whole.
   pure subroutine map_error(error, source, message)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> The file
      type(byte_source), intent(in) :: source
      !> What is wrong, what is allowed and what to do
      character(len=*), intent(in) :: message

      call fatal_error(error, source%name//': '//message)
   end subroutine map_error

   !> Set `error` to a fault in the current line.
   pure subroutine line_error(error, source, at, message)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> The file
      type(byte_source), intent(in) :: source
      !> Place in the block
      integer, intent(in) :: at
      !> What is wrong, what is allowed and what to do
      character(len=*), intent(in) :: message

      call fatal_error(error, source%name//':'//to_text(source%line)//':'// &
         to_text(int(max(at - source%first + 1, 1), int64))//': '//message)
   end subroutine line_error

   !> Set `error` to a fault at a byte.
   pure subroutine byte_error(error, source, offset, message)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> The file
      type(byte_source), intent(in) :: source
      !> Bytes before it
      integer(int64), intent(in) :: offset
      !> What is wrong, what is allowed and what to do
      character(len=*), intent(in) :: message

      call fatal_error(error, source%name//': byte '//to_text(offset)//': '//message)
   end subroutine byte_error

   !> The current line, at most so many characters of it.
   pure subroutine line_text(source, longest, text)
      !> The file
      type(byte_source), intent(in) :: source
      !> Most characters
      integer, intent(in) :: longest
      !> The line
      character(len=:), allocatable, intent(out) :: text
      integer :: i, n

      n = max(0, min(source%last - source%first + 1, longest))
      allocate (character(len=n) :: text)
      do i = 1, n
         text(i:i) = source%block(source%first + i - 1)
      end do
   end subroutine line_text

   !> A piece of the current line in quotes, from `at` to the next blank or separator, without
   !> what a terminal could take for a command.
   pure subroutine excerpt(source, at, text)
      !> The file
      type(byte_source), intent(in) :: source
      !> Place in the block
      integer, intent(in) :: at
      !> The piece
      character(len=:), allocatable, intent(out) :: text
      character(len=1) :: c
      integer :: i

      text = ''
      do i = at, min(source%last, at + shown - 1)
         c = source%block(i)
         if (len(text) > 0 .and. scan(c, ' ,;'//achar(9)) > 0) exit
         if (ichar(c) < 32 .or. ichar(c) > 126) c = '?'
         text = text//c
      end do
      text = ''''//text//''''
   end subroutine excerpt

   !> The beginning of a text in ASCII: any other character becomes a question mark.
   pure function plain_excerpt(text, longest) result(plain)
      !> The text
      character(len=*), intent(in) :: text
      !> Most characters
      integer, intent(in) :: longest
      character(len=:), allocatable :: plain
      character(len=1) :: c
      integer :: i

      plain = ''
      do i = 1, len_trim(text)
         c = text(i:i)
         ! what follows the first byte of a character in UTF-8 is none of its own
         if (ichar(c) >= 128 .and. ichar(c) < 192) cycle
         if (len(plain) == longest) then
            plain = plain//'...'
            return
         end if
         if (c == achar(9)) c = ' '
         if (ichar(c) < 32 .or. ichar(c) > 126) c = '?'
         plain = plain//c
      end do
   end function plain_excerpt

   !> Set `error` unless a map of so many points has a size that can be: at most 2^31 - 1 points,
   !> and no more than the bytes that hold them.
   pure subroutine fits_memory(source, nx, ny, most, offset, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Points along x and y that its header promises
      integer(int64), intent(in) :: nx, ny
      !> Most points that its bytes can hold
      integer(int64), intent(in) :: most
      !> Bytes before the header's numbers
      integer(int64), intent(in) :: offset
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      integer(int64), parameter :: largest = huge(1)

      if (nx < 1_int64 .or. ny < 1_int64) then
         call byte_error(error, source, offset, 'the header promises '//to_text(nx)//' x '// &
            to_text(ny)//' points: both must be above 0')
      else if (nx > largest .or. ny > largest .or. nx > largest/ny) then
         call byte_error(error, source, offset, 'the header promises '//to_text(nx)//' x '// &
            to_text(ny)//' points: at most '//to_text(huge(1))//' points are read: cut the map')
      else if (nx*ny > most) then
         call byte_error(error, source, offset, 'the header promises '//to_text(nx)//' x '// &
            to_text(ny)//' points, the file has room for '//to_text(max(most, 0_int64))// &
            ' at most: it was cut off, or the header is wrong')
      end if
   end subroutine fits_memory

end module asperity_height_map_file_errors
