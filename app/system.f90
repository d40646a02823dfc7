!> The few calls of the operating system (POSIX, Linux) that the program needs because Fortran's
!> own output neither reports a full disk reliably nor renames. Every return value is checked.
!> A subroutine sets `reason` to the system's words on failure and leaves it unallocated else.
module app_system
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_funptr, c_int, &
      c_intptr_t, c_null_char, c_null_funptr, c_ptr, c_size_t
   use app_posix, only: c_access, c_close, c_creat, c_errno_location, c_fclose, &
      c_ferror, c_fopen, c_fread, c_fwrite, c_isatty, c_pclose, c_popen, c_realpath, c_rename, &
      c_signal, c_strerror, c_strlen, c_system, c_unlink, c_write
   implicit none
   private
   public :: append_text, create_file, write_text, close_file, rename_file, remove_file, read_file
   public :: is_terminal, may_write, resolved_path, run_shell, pipe_to_shell
   public :: held_interrupts, hold_interrupts, release_interrupts, die_quietly_of_closed_pipe

   integer(c_int), parameter, public :: standard_output = 1_c_int, standard_error = 2_c_int
   integer(c_int), parameter :: file_mode = int(o'666', c_int), write_access = 2_c_int
   integer(c_int), parameter :: eintr = 4_c_int
   integer(c_int), parameter :: sigpipe = 13_c_int
   !> SIGHUP, SIGINT, SIGTERM
   integer(c_int), parameter :: interrupts(3) = [1_c_int, 2_c_int, 15_c_int]
   integer, parameter :: longest_path = 4096

   !> What SIGHUP, SIGINT and SIGTERM did before they were held.
   type :: held_interrupts
      private
      type(c_funptr) :: before(size(interrupts)) = c_null_funptr
   end type held_interrupts

contains

   !> Create or empty a file for writing.
   subroutine create_file(path, file, reason)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> Descriptor of the open file
      integer(c_int), intent(out) :: file
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      file = c_creat(path//c_null_char, file_mode)
      if (file < 0) reason = last_reason()
   end subroutine create_file

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

   !> Read a file, at most its first `limit` characters.
   subroutine read_file(path, limit, text, reason)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> Most characters read
      integer, intent(in) :: limit
      !> What was read
      character(len=:), allocatable, intent(out) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason
      type(c_ptr) :: stream
      integer(c_size_t) :: length
      integer(c_int) :: status

      stream = c_fopen(path//c_null_char, 'r'//c_null_char)
      if (.not. c_associated(stream)) then
         reason = last_reason()
         return
      end if
      allocate (character(len=limit) :: text)
      length = c_fread(text, 1_c_size_t, int(limit, c_size_t), stream)
      if (c_ferror(stream) /= 0) reason = last_reason()
      status = c_fclose(stream)
      if (status /= 0 .and. .not. allocated(reason)) reason = last_reason()
      text = text(:length)
   end subroutine read_file

   !> Append to a file, all of a text at once.
   subroutine append_text(path, text, reason)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> The text
      character(len=*), intent(in) :: text
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason
      type(c_ptr) :: stream
      integer(c_size_t) :: written
      integer(c_int) :: status

      stream = c_fopen(path//c_null_char, 'a'//c_null_char)
      if (.not. c_associated(stream)) then
         reason = last_reason()
         return
      end if
      written = c_fwrite(text, 1_c_size_t, len(text, c_size_t), stream)
      if (written /= len(text, c_size_t)) reason = last_reason()
      status = c_fclose(stream)
      if (status /= 0 .and. .not. allocated(reason)) reason = last_reason()
   end subroutine append_text

   !> Whether a descriptor is a terminal.
   logical function is_terminal(file)
      !> Descriptor of an open file
      integer(c_int), intent(in) :: file

      is_terminal = c_isatty(file) == 1
   end function is_terminal

   !> Set `reason` unless files may be created in a folder.
   subroutine may_write(folder, reason)
      !> Path of the folder
      character(len=*), intent(in) :: folder
      !> Set on failure
      character(len=:), allocatable, intent(out) :: reason

      if (c_access(folder//c_null_char, write_access) /= 0) reason = last_reason()
   end subroutine may_write

   !> Absolute path without links, or nothing when there is no such file.
   function resolved_path(path) result(resolved)
      !> Any path
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: resolved
      character(len=longest_path) :: buffer

      resolved = ''
      if (.not. c_associated(c_realpath(path//c_null_char, buffer))) return
      resolved = buffer(:index(buffer, c_null_char) - 1)
   end function resolved_path

   !> Run a shell command; its wait status, zero on success.
   integer function run_shell(command)
      !> The command
      character(len=*), intent(in) :: command

      run_shell = int(c_system(command//c_null_char))
   end function run_shell

   !> Run a shell command with a text as its standard input. An interrupt reaches the command
   !> but not the program, so that the caller can tidy up.
   integer function pipe_to_shell(command, text) result(status)
      !> The command
      character(len=*), intent(in) :: command
      !> Its standard input
      character(len=*), intent(in) :: text
      type(c_ptr) :: stream
      type(held_interrupts) :: held
      type(c_funptr) :: before
      integer(c_size_t) :: written

      status = -1
      stream = c_popen(command//c_null_char, 'w'//c_null_char)
      if (.not. c_associated(stream)) return
      call hold_interrupts(held)
      before = c_signal(sigpipe, ignored())
      written = c_fwrite(text, 1_c_size_t, len(text, c_size_t), stream)
      status = int(c_pclose(stream))
      if (written /= len(text, c_size_t) .and. status == 0) status = -1
      before = c_signal(sigpipe, before)
      call release_interrupts(held)
   end function pipe_to_shell

   !> Ignore interrupts while files are written under their temporary names.
   subroutine hold_interrupts(held)
      !> What interrupts did before, for `release_interrupts`
      type(held_interrupts), intent(out) :: held
      integer :: i

      do i = 1, size(interrupts)
         held%before(i) = c_signal(interrupts(i), ignored())
      end do
   end subroutine hold_interrupts

   !> Let interrupts do again what they did before.
   subroutine release_interrupts(held)
      !> From `hold_interrupts`
      type(held_interrupts), intent(in) :: held
      type(c_funptr) :: own
      integer :: i

      do i = 1, size(interrupts)
         own = c_signal(interrupts(i), held%before(i))
      end do
   end subroutine release_interrupts

   !> A reader that goes away (`| head`) ends the program without a message, as it ends `cat`.
   subroutine die_quietly_of_closed_pipe()
      type(c_funptr) :: before

      before = c_signal(sigpipe, c_null_funptr)
   end subroutine die_quietly_of_closed_pipe

   !> The C constant SIG_IGN.
   pure type(c_funptr) function ignored()
      ignored = transfer(1_c_intptr_t, c_null_funptr)
   end function ignored

   !> The C variable errno.
   integer(c_int) function last_error()
      integer(c_int), pointer :: number

      call c_f_pointer(c_errno_location(), number)
      last_error = number
   end function last_error

   !> The system's words for the last failure.
   function last_reason() result(reason)
      character(len=:), allocatable :: reason
      character(kind=c_char), pointer :: letters(:)
      type(c_ptr) :: words
      integer :: i, length

      words = c_strerror(last_error())
      length = int(c_strlen(words))
      call c_f_pointer(words, letters, [length])
      allocate (character(len=length) :: reason)
      do i = 1, length
         reason(i:i) = letters(i)
      end do
   end function last_reason

end module app_system
