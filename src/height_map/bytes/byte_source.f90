!> The bytes of a file, or of a memory that stands for one, in pieces at any offset.
module asperity_height_map_bytes_byte_source
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_int, c_loc, c_long, &
      c_null_char, c_null_ptr, c_ptr, c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_kinds, only: wp
   use asperity_base_libc, only: c_fclose, c_fopen, c_fread, c_fseek, c_ftell, c_memmove, &
      from_end, from_start
   implicit none
   private
   public :: byte_source, close_source, memory_of, open_source, progress_report, read_at, &
      report_progress, use_bytes

   !> Bytes read at once
   integer, parameter :: usual_block = 2**20

   abstract interface
      !> Hears how far the reading is.
      subroutine progress_report(share)
         import :: wp
         implicit none
         !> Share done, 0 to 1
         real(wp), intent(in) :: share
      end subroutine progress_report
   end interface

   !> Where bytes come from. As the target of pointers it must be one.
   type :: byte_source
      !> Path, for messages
      character(len=:), allocatable :: name
      !> Number of bytes
      integer(int64) :: size = 0_int64
      !> Bytes `start` + 1 and on, the first `filled` of them valid
      character(len=1), allocatable :: block(:)
      !> Bytes before the block
      integer(int64) :: start = 0_int64
      !> Valid bytes of the block
      integer :: filled = 0
      !> The current line is block(first:last), without the characters that end it
      integer :: first = 1, last = 0
      !> Its number, from one
      integer(int64) :: line = 0_int64
      !> Where the next one begins in the block, and the character that ends lines
      integer :: next = 1, line_end = 0
      !> Length of a block
      integer :: block_length = usual_block
      type(c_ptr), private :: stream = c_null_ptr
      character(len=1), pointer, contiguous, private :: memory(:) => null()
      procedure(progress_report), pointer, nopass, private :: progress => null()
      real(wp), private :: reported = 0.0_wp
   end type byte_source

contains

   !> Open a file. `error` is set when it cannot be, for a folder also.
   subroutine open_source(source, path, error, progress)
      !> The source; close it with `close_source`
      type(byte_source), intent(out) :: source
      !> Path of the file
      character(len=*), intent(in) :: path
      !> Set when it cannot be opened
      type(error_type), allocatable, intent(out) :: error
      !> Hears how far the reading is
      procedure(progress_report), optional :: progress
      logical :: is_there

      source%name = path
      if (present(progress)) source%progress => progress
      inquire (file=path//'/.', exist=is_there)
      if (is_there) then
         call fatal_error(error, path//': is a folder, not a file of heights', file_error)
         return
      end if
      source%stream = c_fopen(path//c_null_char, 'rb'//c_null_char)
      if (.not. c_associated(source%stream)) then
         call fatal_error(error, &
            path//': cannot be opened: there is no such file, or it may not '// &
            'be read', file_error)
         return
      end if
      source%size = -1_int64
      if (c_fseek(source%stream, 0_c_long, from_end) == 0) source%size = c_ftell(source%stream)
      if (source%size < 0_int64) call fatal_error(error, &
         path//': is no ordinary file: save the '// &
         'heights in one', file_error)
   end subroutine open_source

   !> Let a memory stand for a file. It must stay as it is while the source is used.
   subroutine use_bytes(source, name, bytes, block_length)
      !> The source
      type(byte_source), intent(out) :: source
      !> Name for messages
      character(len=*), intent(in) :: name
      !> The bytes
      character(len=*), intent(in), target :: bytes
      !> Bytes handled at once, for tests
      integer, intent(in), optional :: block_length

      source%name = name
      source%size = len(bytes, int64)
      if (len(bytes) > 0) call c_f_pointer(c_loc(bytes), source%memory, [len(bytes)])
      if (present(block_length)) source%block_length = max(block_length, 1)
   end subroutine use_bytes

   !> Address of the memory that stands for a file; a null pointer for a file.
   type(c_ptr) function memory_of(source)
      !> The source
      type(byte_source), intent(in) :: source

      memory_of = c_null_ptr
      if (associated(source%memory)) memory_of = c_loc(source%memory)
   end function memory_of

   !> Close the file of a source, if it has one.
   subroutine close_source(source)
      !> The source
      type(byte_source), intent(inout) :: source
      integer(c_int) :: status

      if (c_associated(source%stream)) status = c_fclose(source%stream)
      source%stream = c_null_ptr
      nullify (source%memory)
   end subroutine close_source

   !> Read the `count` bytes after the first `offset` to an address.
   subroutine read_at(source, offset, to, count, error)
      !> The source
      type(byte_source), intent(inout) :: source
      !> Bytes before them
      integer(int64), intent(in) :: offset
      !> Where they go
      type(c_ptr), intent(in) :: to
      !> How many
      integer(int64), intent(in) :: count
      !> Set when the source ends before
      type(error_type), allocatable, intent(out) :: error
      type(c_ptr) :: unused
      integer(int64) :: done

      if (count <= 0_int64) return
      done = 0_int64
      if (offset + count > source%size) then
         continue
      else if (associated(source%memory)) then
         unused = c_memmove(to, c_loc(source%memory(offset + 1_int64)), int(count, c_size_t))
         done = count
      else if (c_associated(source%stream)) then
         if (c_fseek(source%stream, int(offset, c_long), from_start) == 0) &
            done = int(c_fread(to, 1_c_size_t, int(count, c_size_t), source%stream), int64)
      end if
      if (done < count) call fatal_error(error, source%name//': cannot be read to its end: it '// &
         'was changed meanwhile, or its disk is faulty', file_error)
      call report_progress(source, offset + count)
   end subroutine read_at

   !> Tell whoever listens how far the reading is, at most a hundred times.
   subroutine report_progress(source, done)
      !> The source
      type(byte_source), intent(inout) :: source
      !> Bytes that are done
      integer(int64), intent(in) :: done
      real(wp) :: share

      if (.not. associated(source%progress)) return
      share = min(real(done, wp)/real(max(source%size, 1_int64), wp), 1.0_wp)
      if (share < source%reported + 0.01_wp) return
      source%reported = share
      call source%progress(share)
   end subroutine report_progress

end module asperity_height_map_bytes_byte_source
