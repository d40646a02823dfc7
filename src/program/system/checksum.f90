!> Checksum of numbers, to see whether they have changed: CRC-32 of their bytes, of zlib.
module asperity_program_system_checksum
   use, intrinsic :: iso_c_binding, only: c_int, c_loc, c_long, c_null_ptr, c_ptr, c_sizeof
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: checksum

   interface
      !> zlib: the checksum of some bytes after others; of none, where it begins.
      integer(c_long) function c_crc32(crc, bytes, count) bind(c, name='crc32')
         import :: c_int, c_long, c_ptr
         implicit none
         integer(c_long), value :: crc
         type(c_ptr), value :: bytes
         integer(c_int), value :: count
      end function c_crc32
   end interface

contains

   !> The checksum as eight hexadecimal digits.
   function checksum(values) result(text)
      !> The numbers
      real(wp), intent(in) :: values(:)
      character(len=8) :: text
      real(wp), target :: copy(size(values))
      integer(c_long) :: crc

      copy = values
      crc = c_crc32(0_c_long, c_null_ptr, 0_c_int)
      if (size(copy) > 0) &
         crc = c_crc32(crc, c_loc(copy), int(size(copy)*c_sizeof(copy(1)), c_int))
      write (text, '(z8.8)') crc
   end function checksum

end module asperity_program_system_checksum
