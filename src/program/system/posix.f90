!> Interfaces of the C functions that the program calls; POSIX says what they do, for flock and
!> statx the Linux manual. Sizes and constants are those of Linux.
module asperity_program_system_posix
   use, intrinsic :: iso_c_binding, only: c_char, c_funptr, c_int, c_int16_t, c_int32_t, &
      c_int64_t, c_long, c_ptr, c_size_t
   implicit none
   private
   public :: c_access, c_close, c_creat, c_errno_location, c_fchmod, c_fchown, c_ferror, c_fileno, &
      c_flock, c_fsync, c_ftruncate, c_fwrite, c_getpid, c_getppid, c_gmtime_r, c_ioctl, c_isatty, &
      c_pclose, c_popen, c_raise, c_readlink, c_realpath, c_rename, c_signal, c_sleep, c_statx, &
      c_strerror, c_strftime, c_system, c_time, c_unlink, c_write, statx_type

   !> Signals
   integer(c_int), parameter, public :: sigkill = 9_c_int, sigpipe = 13_c_int, sigchld = 17_c_int, &
      sigxcpu = 24_c_int, sigxfsz = 25_c_int

   !> What statx tells; unlike that of stat, it is laid out in one way on every machine.
   type, bind(c) :: statx_type
      integer(c_int32_t) :: mask, block_size
      integer(c_int64_t) :: attributes
      integer(c_int32_t) :: links, owner, group
      integer(c_int16_t) :: mode, spare
      integer(c_int64_t) :: inode, size, blocks, attributes_mask, times(8)
      integer(c_int32_t) :: own_major, own_minor, device_major, device_minor
      integer(c_int64_t) :: later(14)
   end type statx_type

   interface
      integer(c_int) function c_creat(path, mode) bind(c, name='creat')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
      end function c_creat
      integer(c_size_t) function c_write(file, text, length) bind(c, name='write')
         import :: c_char, c_int, c_size_t
         integer(c_int), value :: file
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: length
      end function c_write
      integer(c_int) function c_close(file) bind(c, name='close')
         import :: c_int
         integer(c_int), value :: file
      end function c_close
      integer(c_int) function c_fsync(file) bind(c, name='fsync')
         import :: c_int
         integer(c_int), value :: file
      end function c_fsync
      integer(c_int) function c_ftruncate(file, length) bind(c, name='ftruncate')
         import :: c_int, c_long
         integer(c_int), value :: file
         integer(c_long), value :: length
      end function c_ftruncate
      integer(c_int) function c_fchmod(file, mode) bind(c, name='fchmod')
         import :: c_int
         integer(c_int), value :: file, mode
      end function c_fchmod
      integer(c_int) function c_fchown(file, owner, group) bind(c, name='fchown')
         import :: c_int
         integer(c_int), value :: file, owner, group
      end function c_fchown
      integer(c_int) function c_flock(file, operation) bind(c, name='flock')
         import :: c_int
         integer(c_int), value :: file, operation
      end function c_flock
      integer(c_int) function c_statx(folder, path, flags, mask, status) bind(c, name='statx')
         import :: c_char, c_int, statx_type
         integer(c_int), value :: folder, flags, mask
         character(kind=c_char), intent(in) :: path(*)
         type(statx_type), intent(out) :: status
      end function c_statx
      integer(c_int) function c_rename(from, to) bind(c, name='rename')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: from(*), to(*)
      end function c_rename
      integer(c_int) function c_unlink(path) bind(c, name='unlink')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
      end function c_unlink
      integer(c_int) function c_isatty(file) bind(c, name='isatty')
         import :: c_int
         integer(c_int), value :: file
      end function c_isatty
      integer(c_int) function c_ioctl(file, request, result) bind(c, name='ioctl')
         import :: c_int, c_int16_t, c_long
         integer(c_int), value :: file
         integer(c_long), value :: request
         integer(c_int16_t), intent(inout) :: result(*)
      end function c_ioctl
      subroutine c_time(seconds) bind(c, name='time')
         import :: c_long
         integer(c_long), intent(out) :: seconds
      end subroutine c_time
      type(c_ptr) function c_gmtime_r(seconds, calendar) bind(c, name='gmtime_r')
         import :: c_long, c_ptr
         integer(c_long), intent(in) :: seconds
         integer(c_long), intent(out) :: calendar(*)
      end function c_gmtime_r
      integer(c_size_t) function c_strftime(text, length, form, calendar) bind(c, name='strftime')
         import :: c_char, c_long, c_size_t
         character(kind=c_char), intent(out) :: text(*)
         integer(c_size_t), value :: length
         character(kind=c_char), intent(in) :: form(*)
         integer(c_long), intent(in) :: calendar(*)
      end function c_strftime
      integer(c_int) function c_access(path, mode) bind(c, name='access')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
      end function c_access
      type(c_ptr) function c_realpath(path, resolved) bind(c, name='realpath')
         import :: c_char, c_ptr
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(out) :: resolved(*)
      end function c_realpath
      integer(c_size_t) function c_readlink(path, text, length) bind(c, name='readlink')
         import :: c_char, c_size_t
         character(kind=c_char), intent(in) :: path(*)
         character(kind=c_char), intent(out) :: text(*)
         integer(c_size_t), value :: length
      end function c_readlink
      integer(c_int) function c_getpid() bind(c, name='getpid')
         import :: c_int
      end function c_getpid
      integer(c_int) function c_getppid() bind(c, name='getppid')
         import :: c_int
      end function c_getppid
      integer(c_int) function c_sleep(seconds) bind(c, name='sleep')
         import :: c_int
         integer(c_int), value :: seconds
      end function c_sleep
      integer(c_int) function c_system(command) bind(c, name='system')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: command(*)
      end function c_system
      type(c_ptr) function c_popen(command, mode) bind(c, name='popen')
         import :: c_char, c_ptr
         character(kind=c_char), intent(in) :: command(*), mode(*)
      end function c_popen
      integer(c_int) function c_pclose(stream) bind(c, name='pclose')
         import :: c_int, c_ptr
         type(c_ptr), value :: stream
      end function c_pclose
      integer(c_size_t) function c_fwrite(text, size, length, stream) bind(c, name='fwrite')
         import :: c_char, c_ptr, c_size_t
         character(kind=c_char), intent(in) :: text(*)
         integer(c_size_t), value :: size, length
         type(c_ptr), value :: stream
      end function c_fwrite
      integer(c_int) function c_ferror(stream) bind(c, name='ferror')
         import :: c_int, c_ptr
         type(c_ptr), value :: stream
      end function c_ferror
      integer(c_int) function c_fileno(stream) bind(c, name='fileno')
         import :: c_int, c_ptr
         type(c_ptr), value :: stream
      end function c_fileno
      type(c_funptr) function c_signal(number, action) bind(c, name='signal')
         import :: c_funptr, c_int
         integer(c_int), value :: number
         type(c_funptr), value :: action
      end function c_signal
      integer(c_int) function c_raise(number) bind(c, name='raise')
         import :: c_int
         integer(c_int), value :: number
      end function c_raise
      type(c_ptr) function c_errno_location() bind(c, name='__errno_location')
         import :: c_ptr
      end function c_errno_location
      type(c_ptr) function c_strerror(number) bind(c, name='strerror')
         import :: c_int, c_ptr
         integer(c_int), value :: number
      end function c_strerror
   end interface

end module asperity_program_system_posix
