!> Interfaces of the functions of C that read files and search bytes. Fortran's own stream
!> input would copy every block once more, and opens folders with some compilers.
module asperity_base_libc
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_ptr, c_size_t
   implicit none
   private
   public :: c_fclose, c_fopen, c_fread, c_fseek, c_ftell, c_memchr, c_memmove, c_strlen

   !> Positions counted from the beginning and from the end of a file, for `c_fseek`
   integer(c_int), parameter, public :: from_start = 0_c_int, from_end = 2_c_int

   interface
      type(c_ptr) function c_fopen(path, mode) bind(c, name='fopen')
         import :: c_char, c_ptr
         character(kind=c_char), intent(in) :: path(*), mode(*)
      end function c_fopen
      integer(c_int) function c_fclose(stream) bind(c, name='fclose')
         import :: c_int, c_ptr
         type(c_ptr), value :: stream
      end function c_fclose
      integer(c_size_t) function c_fread(to, size, count, stream) bind(c, name='fread')
         import :: c_ptr, c_size_t
         type(c_ptr), value :: to, stream
         integer(c_size_t), value :: size, count
      end function c_fread
      integer(c_int) function c_fseek(stream, offset, origin) bind(c, name='fseek')
         import :: c_int, c_long, c_ptr
         type(c_ptr), value :: stream
         integer(c_long), value :: offset
         integer(c_int), value :: origin
      end function c_fseek
      integer(c_long) function c_ftell(stream) bind(c, name='ftell')
         import :: c_long, c_ptr
         type(c_ptr), value :: stream
      end function c_ftell
      type(c_ptr) function c_memchr(from, byte, count) bind(c, name='memchr')
         import :: c_int, c_ptr, c_size_t
         type(c_ptr), value :: from
         integer(c_int), value :: byte
         integer(c_size_t), value :: count
      end function c_memchr
      type(c_ptr) function c_memmove(to, from, count) bind(c, name='memmove')
         import :: c_ptr, c_size_t
         type(c_ptr), value :: to, from
         integer(c_size_t), value :: count
      end function c_memmove
      integer(c_size_t) function c_strlen(text) bind(c, name='strlen')
         import :: c_ptr, c_size_t
         type(c_ptr), value :: text
      end function c_strlen
   end interface

end module asperity_base_libc
