!> Packs members into a zip archive without compressing them, with right checksums, so that damaged
!> ones get past zip.
module zip_writer
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: zip_member_text, zip_of

   !> A member.
   type :: zip_member_text
      !> Name and bytes
      character(len=:), allocatable :: name, bytes
   end type zip_member_text

   interface
      integer(c_long) function c_crc32(start, bytes, length) bind(c, name='crc32')
         import :: c_char, c_int, c_long
         implicit none
         integer(c_long), value :: start
         character(kind=c_char), intent(in) :: bytes(*)
         integer(c_int), value :: length
      end function c_crc32
   end interface

contains

   !> The archive.
   subroutine zip_of(members, archive)
      !> The members
      type(zip_member_text), intent(in) :: members(:)
      !> Its bytes
      character(len=:), allocatable, intent(out) :: archive
      character(len=:), allocatable :: list, head
      integer :: i, offset

      archive = ''
      list = ''
      do i = 1, size(members)
         associate (name => members(i)%name, bytes => members(i)%bytes)
            ! needed version, flags, method, time, date; checksum, packed and unpacked size
            head = number(20, 2)//number(0, 2)//number(0, 2)//number(0, 2)//number(33, 2)// &
               word(int(c_crc32(0_c_long, bytes, len(bytes, c_int)), int64))// &
               number(len(bytes), 4)//number(len(bytes), 4)//number(len(name), 2)
            offset = len(archive)
            archive = archive//'PK'//achar(3)//achar(4)//head//number(0, 2)//name//bytes
            list = list//'PK'//achar(1)//achar(2)//number(20, 2)//head//number(0, 2)// &
               number(0, 2)//number(0, 2)//number(0, 2)//number(0, 4)//number(offset, 4)//name
         end associate
      end do
      offset = len(archive)
      archive = archive//list//'PK'//achar(5)//achar(6)//number(0, 4)//number(size(members), 2)// &
         number(size(members), 2)//number(len(list), 4)//number(offset, 4)//number(0, 2)
   end subroutine zip_of

   !> A number of so many bytes, little end first.
   pure function number(value, length) result(bytes)
      integer, intent(in) :: value, length
      character(len=length) :: bytes
      integer :: i

      do i = 1, length
         bytes(i:i) = char(iand(ishft(value, 8 - 8*i), 255))
      end do
   end function number

   !> A number of 4 bytes that may be above 2^31.
   pure function word(value) result(bytes)
      integer(int64), intent(in) :: value
      character(len=4) :: bytes
      integer :: i

      do i = 1, 4
         bytes(i:i) = char(int(iand(ishft(value, 8 - 8*i), 255_int64)))
      end do
   end function word

end module zip_writer
