!> Interfaces of the C functions that `app_system` wraps; POSIX says what they do. Sizes and
!> constants are those of Linux.
module app_posix
   use, intrinsic :: iso_c_binding, only: c_char, c_funptr, c_int, c_ptr, c_size_t
   implicit none
   private
   public :: c_access, c_close, c_creat, c_errno_location, c_fclose, c_ferror, c_fopen, c_fread, &
      c_fwrite, c_isatty, c_pclose, c_popen, c_realpath, c_rename, c_signal, c_strerror, &
      c_strlen, c_system, c_unlink, c_write

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
      type(c_ptr) function c_fopen(path, mode) bind(c, name='fopen')
         import :: c_char, c_ptr
         character(kind=c_char), intent(in) :: path(*), mode(*)
      end function c_fopen
      integer(c_size_t) function c_fread(text, size, length, stream) bind(c, name='fread')
         import :: c_char, c_ptr, c_size_t
         character(kind=c_char), intent(out) :: text(*)
         integer(c_size_t), value :: size, length
         type(c_ptr), value :: stream
      end function c_fread
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
      integer(c_int) function c_fclose(stream) bind(c, name='fclose')
         import :: c_int, c_ptr
         type(c_ptr), value :: stream
      end function c_fclose
      type(c_funptr) function c_signal(number, action) bind(c, name='signal')
         import :: c_funptr, c_int
         integer(c_int), value :: number
         type(c_funptr), value :: action
      end function c_signal
      type(c_ptr) function c_errno_location() bind(c, name='__errno_location')
         import :: c_ptr
      end function c_errno_location
      type(c_ptr) function c_strerror(number) bind(c, name='strerror')
         import :: c_int, c_ptr
         integer(c_int), value :: number
      end function c_strerror
      integer(c_size_t) function c_strlen(text) bind(c, name='strlen')
         import :: c_ptr, c_size_t
         type(c_ptr), value :: text
      end function c_strlen
   end interface

end module app_posix
