!> Keys and values of headers.
module asperity_height_map_text_header_fields
   use asperity_base_kinds, only: wp
   use asperity_height_map_text_numbers, only: count_figures, number_found, read_number
   implicit none
   private
   public :: narrow_colons, next_pair, number_in, plain_key, rounding_in, split_at

   !> The colon of Chinese and Japanese, in UTF-8
   character(len=*), parameter :: wide_colon = char(239)//char(188)//char(154)

contains

   !> Wide colons as ordinary ones, with blanks behind so that places stay.
   pure subroutine narrow_colons(line)
      !> The line
      character(len=:), allocatable, intent(inout) :: line
      integer :: at

      do
         at = index(line, wide_colon)
         if (at == 0) return
         line(at:at + 2) = ':'
      end do
   end subroutine narrow_colons

   !> The number at the beginning of a text, and what follows it.
   pure subroutine number_in(text, value, is_number, rest)
      !> The text
      character(len=*), intent(in) :: text
      !> The number
      real(wp), intent(out) :: value
      !> Whether there is one
      logical, intent(out) :: is_number
      !> What follows it, without blanks around
      character(len=:), allocatable, intent(out) :: rest
      character(len=1) :: letters(len(text))
      integer :: at, i, status

      do i = 1, len(text)
         letters(i) = text(i:i)
      end do
      at = verify(text//'x', ' '//achar(9))
      call read_number(letters, at, len(text), value, status)
      is_number = status == number_found
      rest = ''
      if (is_number) rest = trim(adjustl(text(at:)))
   end subroutine number_in

   !> Half of the last decimal of the number at the beginning of a text.
   pure real(wp) function rounding_in(text)
      !> The text
      character(len=*), intent(in) :: text
      character(len=1) :: letters(len(text))
      integer :: decimals, figures, i

      do i = 1, len(text)
         letters(i) = text(i:i)
      end do
      call count_figures(letters, 1, len(text), figures, decimals)
      rounding_in = 0.5_wp*10.0_wp**max(-300, min(-decimals, 300))
   end function rounding_in

   !> A key in lower case, without blanks, underscores and marks of comments.
   pure subroutine plain_key(text, key)
      !> As it stands in the file
      character(len=*), intent(in) :: text
      !> To compare
      character(len=:), allocatable, intent(out) :: key
      character(len=1) :: c
      integer :: i

      key = ''
      do i = 1, len(text)
         c = text(i:i)
         if (scan(c, ' _#%"!\'''//achar(9)) > 0) cycle
         if (c >= 'A' .and. c <= 'Z') c = achar(iachar(c) + 32)
         key = key//c
      end do
   end subroutine plain_key

   !> Where in a value another key begins, as in `18 w=24`; 0 if none does.
   pure integer function next_pair(value)
      !> What stands after a key
      character(len=*), intent(in) :: value

      next_pair = index(value, '=')
      if (next_pair == 0) return
      next_pair = len_trim(value(:next_pair - 1))
      next_pair = scan(value(:next_pair), ' ,;'//achar(9), back=.true.)
      if (next_pair > 0) next_pair = next_pair + 1
   end function next_pair

   !> Split a line into a key and a value at the first of some marks; the key is empty without one.
   pure subroutine split_at(text, marks, key, value, place)
      !> The line
      character(len=*), intent(in) :: text
      !> Characters that may stand between
      character(len=*), intent(in) :: marks
      !> The key, plain
      character(len=:), allocatable, intent(out) :: key
      !> The value, without blanks around
      character(len=:), allocatable, intent(out) :: value
      !> Where the value begins in the line
      integer, intent(out) :: place
      integer :: mark

      mark = scan(text, marks)
      key = ''
      value = ''
      place = 1
      if (mark == 0) return
      call plain_key(text(:mark - 1), key)
      place = mark + verify(text(mark + 1:)//'x', ' '//achar(9))
      if (place <= len(text)) value = trim(text(place:))
   end subroutine split_at

end module asperity_height_map_text_header_fields
