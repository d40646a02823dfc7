!> Bytes as text in base 64 (RFC 4648), as XML holds them.
module asperity_solid_vtu_base64
   use, intrinsic :: iso_fortran_env, only: int8
   implicit none
   private
   public :: encode_base64

   character(len=64), parameter :: alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'// &
      'abcdefghijklmnopqrstuvwxyz0123456789+/'

contains

   !> Four characters for three bytes each, the last ones filled up by `=`.
   pure subroutine encode_base64(bytes, text)
      !> The bytes
      integer(int8), intent(in) :: bytes(:)
      !> The text, without line breaks
      character(len=:), allocatable, intent(out) :: text
      integer :: i, j, word, places, at, sextet

      allocate (character(len=4*((size(bytes) + 2)/3)) :: text)
      at = 0
      do i = 1, size(bytes), 3
         places = min(3, size(bytes) - i + 1)
         word = 0
         do j = 0, places - 1
            word = ior(word, ishft(iand(int(bytes(i + j)), 255), 16 - 8*j))
         end do
         do j = 0, 3
            at = at + 1
            sextet = ibits(word, 18 - 6*j, 6)
            text(at:at) = merge('=', alphabet(sextet + 1:sextet + 1), j > places)
         end do
      end do
   end subroutine encode_base64

end module asperity_solid_vtu_base64
