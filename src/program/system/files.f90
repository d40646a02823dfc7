!> Files by the operating system (POSIX, Linux), because Fortran's own output neither reports a
!> full disk reliably nor renames. Every return value is checked. A subroutine sets `reason` to the
!> system's words on failure and leaves it unallocated else.
module asperity_program_system_files
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_loc, c_null_char, c_ptr, &
      c_size_t
   use asperity_base_libc, only: c_fclose, c_fopen, c_fread
   use asperity_base_memory, only: memory_remedy
   use asperity_program_system_errno, only: eintr, last_error, last_reason
   use asperity_program_system_posix, only: c_close, c_creat, c_ferror, c_isatty, c_rename, &
      c_unlink, c_write
   implicit none
   private
   public :: open_file, write_text, close_file, rename_file, remove_file, read_file, is_terminal

   integer(c_int), parameter, public :: standard_output = 1_c_int, standard_error = 2_c_int
   integer(c_int), parameter :: file_mode = int(o'666', c_int)
   !> Characters that a file is first taken to have
   integer, parameter :: first_room = 65536

contains

   !> Open a device or pipe for writing, or create or empty a file.
   subroutine open_file(path, file, reason)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> Descriptor of the open file
      integer(c_int), intent(out) :: file
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      file = c_creat(path//c_null_char, file_mode)
      if (file < 0) reason = last_reason()
   end subroutine open_file

   !> Write all of a text.
   subroutine write_text(file, text, reason)
      !> Descriptor of an open file
      integer(c_int), intent(in) :: file
      !> The text
      character(len=*), intent(in) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason
      integer(c_size_t) :: done, written

      done = 0_c_size_t
      do while (done < len(text, c_size_t))
         written = c_write(file, text(done + 1:), len(text, c_size_t) - done)
         if (written > 0_c_size_t) then
            done = done + written
         else if (last_error() /= eintr) then
            reason = last_reason()
            return
         end if
      end do
   end subroutine write_text

   !> Close a file; some systems report only here that the disk is full.
   subroutine close_file(file, reason)
      !> Descriptor of an open file
      integer(c_int), intent(in) :: file
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_close(file) /= 0) reason = last_reason()
   end subroutine close_file

   !> Rename a file, replacing a file of the new name.
   subroutine rename_file(from, to, reason)
      !> Present and new path
      character(len=*), intent(in) :: from, to
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_rename(from//c_null_char, to//c_null_char) /= 0) reason = last_reason()
   end subroutine rename_file

   !> Remove a file. A failure cannot be helped: it follows another one that is reported.
   subroutine remove_file(path)
      !> Path of the file
      character(len=*), intent(in) :: path
      integer(c_int) :: status

      status = c_unlink(path//c_null_char)
      if (status /= 0) return
   end subroutine remove_file

   !> Read a file, at most its first `limit` characters, with as much memory as it needs.
   subroutine read_file(path, limit, text, reason)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> Most characters read
      integer, intent(in) :: limit
      !> What was read
      character(len=:), allocatable, target, intent(out) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason
      type(c_ptr) :: stream
      integer :: length, room
      integer(c_int) :: status

      stream = c_fopen(path//c_null_char, 'r'//c_null_char)
      if (.not. c_associated(stream)) then
         reason = last_reason()
         return
      end if
      length = 0
      room = 0
      do while (length == room .and. room < limit .and. .not. allocated(reason))
         if (room > limit/2) then
            room = limit
         else
            room = min(limit, max(first_room, 2*room))
         end if
         call resize(text, length, room, reason)
         if (allocated(reason)) exit
         length = length + int(c_fread(c_loc(text(length + 1:length + 1)), 1_c_size_t, &
            int(room - length, c_size_t), stream))
         if (c_ferror(stream) /= 0) reason = last_reason()
      end do
      status = c_fclose(stream)
      if (status /= 0 .and. .not. allocated(reason)) reason = last_reason()
      if (.not. allocated(reason)) call resize(text, length, length, reason)
   end subroutine read_file

   !> Give a text another length and keep its beginning.
   subroutine resize(text, kept, length, reason)
      character(len=:), allocatable, intent(inout) :: text
      integer, intent(in) :: kept, length
      character(len=:), allocatable, intent(inout) :: reason
      character(len=:), allocatable :: resized
      integer :: status

      allocate (character(len=length) :: resized, stat=status)
      if (status /= 0) then
         reason = 'not enough memory'//memory_remedy
         return
      end if
      if (kept > 0) resized(:kept) = text(:kept)
      call move_alloc(resized, text)
   end subroutine resize

   !> Whether a descriptor is a terminal.
   logical function is_terminal(file)
      !> Descriptor of an open file
      integer(c_int), intent(in) :: file

      is_terminal = c_isatty(file) == 1
   end function is_terminal

end module asperity_program_system_files
