!> A file that grows and belongs to one process at a time. The lock is the system's: it ends with
!> the process, however that ends.
module asperity_program_system_locked_file
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_long, c_null_char, &
      c_null_ptr, c_ptr
   use asperity_base_libc, only: c_fclose, c_fopen
   use asperity_program_system_errno, only: ewouldblock, last_error, last_reason
   use asperity_program_system_file_facts, only: facts_of, facts_of_descriptor, file_facts
   use asperity_program_system_files, only: remove_file, write_text
   use asperity_program_system_posix, only: c_fileno, c_flock, c_ftruncate
   implicit none
   private
   public :: locked_file, open_locked, shorten, append_text, remove_locked

   !> flock: for one process, without waiting
   integer(c_int), parameter :: exclusive_at_once = 6_c_int

   !> An open file that no other process may have.
   type :: locked_file
      !> Its path
      character(len=:), allocatable :: path
      type(c_ptr), private :: stream = c_null_ptr
   end type locked_file

contains

   !> Open a file, or create it, and lock it. Where the file system knows no locks there is none.
   subroutine open_locked(file, path, reason)
      !> The file
      type(locked_file), intent(out) :: file
      !> Its path
      character(len=*), intent(in) :: path
      !> Set on failure, or when another process has it
      character(len=:), allocatable, intent(out) :: reason
      type(file_facts) :: mine, there

      file%path = path
      do
         file%stream = c_fopen(path//c_null_char, 'a'//c_null_char)
         if (.not. c_associated(file%stream)) then
            reason = last_reason()
            return
         end if
         if (c_flock(c_fileno(file%stream), exclusive_at_once) /= 0) then
            if (last_error() == ewouldblock) then
               reason = 'another process is writing it'
               call close_stream(file)
               return
            end if
         end if
         ! Until it was locked, another process may have removed it
         mine = facts_of_descriptor(c_fileno(file%stream))
         there = facts_of(path)
         if (all(mine%identity == there%identity)) return
         call close_stream(file)
      end do
   end subroutine open_locked

   !> Leave only the beginning of a file.
   subroutine shorten(file, length, reason)
      !> The file
      type(locked_file), intent(in) :: file
      !> Its new length, bytes
      integer, intent(in) :: length
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_ftruncate(c_fileno(file%stream), int(length, c_long)) /= 0) reason = last_reason()
   end subroutine shorten

   !> Write a text at the end of a file.
   subroutine append_text(file, text, reason)
      !> The file
      type(locked_file), intent(in) :: file
      !> The text
      character(len=*), intent(in) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      call write_text(c_fileno(file%stream), text, reason)
   end subroutine append_text

   !> Remove a file and give it up.
   subroutine remove_locked(file)
      !> The file
      type(locked_file), intent(inout) :: file

      call remove_file(file%path)
      call close_stream(file)
   end subroutine remove_locked

   subroutine close_stream(file)
      type(locked_file), intent(inout) :: file
      integer(c_int) :: status

      status = c_fclose(file%stream)
      file%stream = c_null_ptr
      if (status /= 0) return
   end subroutine close_stream

end module asperity_program_system_locked_file
