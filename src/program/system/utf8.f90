!> Text of files and of the user, which may be in an older encoding, as valid UTF-8.
module asperity_program_system_utf8
   use asperity_base_error, only: error_type
   use asperity_base_text_builder, only: growing_text
   implicit none
   private
   public :: make_utf8, utf8_text

   !> Code points that windows-1252 has for the bytes 128 to 159; 65533 stands for none. The bytes
   !> from 160 on are code points themselves, as in Latin-1
   integer, parameter :: windows_1252(128:159) = [8364, 65533, 8218, 402, 8222, 8230, 8224, 8225, &
      710, 8240, 352, 8249, 338, 65533, 381, 65533, 65533, 8216, 8217, 8220, 8221, 8226, 8211, &
      8212, 732, 8482, 353, 8250, 339, 65533, 382, 376]

contains

   !> The text with every byte that is no part of valid UTF-8 read as windows-1252. For what is
   !> short; without memory it stays as it is.
   pure function utf8_text(text) result(valid)
      !> Any bytes
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: valid
      type(error_type), allocatable :: error

      valid = text
      call make_utf8(valid, error)
   end function utf8_text

   !> Read every byte of a text that is no part of valid UTF-8 as windows-1252, of which Latin-1 is
   !> a part.
   pure subroutine make_utf8(text, error)
      !> Any bytes, valid UTF-8 on return
      character(len=:), allocatable, intent(inout) :: text
      !> Set when there is not enough memory for it; the text stays as it is then
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: buffer
      character(len=:), allocatable :: valid
      integer :: i, first, length

      first = 1
      i = 1
      do while (i <= len(text))
         length = sequence_length(text(i:min(len(text), i + 3)))
         if (length == 0) then
            call buffer%add(text(first:i - 1))
            call buffer%add(encoded(code_of(text(i:i))))
            first = i + 1
         end if
         i = i + max(1, length)
      end do
      if (first == 1) return
      call buffer%add(text(first:))
      call buffer%take(valid, error)
      if (.not. allocated(error)) call move_alloc(valid, text)
   end subroutine make_utf8

   !> Bytes of the UTF-8 character that a text begins with, zero if it begins with none.
   pure integer function sequence_length(text) result(length)
      character(len=*), intent(in) :: text
      integer :: lead, second, i

      lead = ichar(text(1:1))
      length = 1
      if (lead < 128) return
      length = 0
      if (lead < 194 .or. lead > 244) return
      i = 2 + merge(1, 0, lead >= 224) + merge(1, 0, lead >= 240)
      if (len(text) < i) return
      second = ichar(text(2:2))
      ! neither longer than need be, nor surrogates, nor beyond the last code point
      if (lead == 224 .and. second < 160 .or. lead == 237 .and. second > 159) return
      if (lead == 240 .and. second < 144 .or. lead == 244 .and. second > 143) return
      if (any(iand(bytes(text(2:i)), 192) /= 128)) return
      length = i
   end function sequence_length

   !> The bytes of a text as numbers.
   pure function bytes(text) result(numbers)
      character(len=*), intent(in) :: text
      integer :: numbers(len(text))
      integer :: i

      numbers = [(ichar(text(i:i)), i=1, len(text))]
   end function bytes

   !> Code point of a byte of windows-1252.
   pure integer function code_of(byte) result(code)
      character(len=1), intent(in) :: byte

      code = ichar(byte)
      if (code >= lbound(windows_1252, 1) .and. code <= ubound(windows_1252, 1)) &
         code = windows_1252(code)
   end function code_of

   !> A code point from 128 to 65535 in UTF-8.
   pure function encoded(code) result(text)
      integer, intent(in) :: code
      character(len=:), allocatable :: text

      if (code < 2048) then
         text = char(192 + code/64)//char(128 + modulo(code, 64))
      else
         text = char(224 + code/4096)//char(128 + modulo(code/64, 64))//char(128 + modulo(code, 64))
      end if
   end function encoded

end module asperity_program_system_utf8
