!> Lines and fields of a text file of numbers.
module asperity_program_record_lines
   use asperity_base_number_text, only: to_text
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: place_type, start_reading, next_line, separator_of, find_field, field, field_count, &
      place_text

   character(len=*), parameter :: tab = achar(9), return = achar(13)
   character(len=*), parameter :: byte_order_mark = char(239)//char(187)//char(191)
   !> Beginnings of lines that are comments
   character(len=*), parameter :: comments = '#%!'

   !> Where the reader is.
   type :: place_type
      !> Path of the file
      character(len=:), allocatable :: path
      !> Number of the line
      integer :: line = 0
      !> First and last character of the line; the first of what follows
      integer :: first = 1, last = 0, next = 1
      !> What separates fields
      character(len=1) :: separator = ','
   end type place_type

contains

   !> Begin before the first line, after a byte order mark and so many lines.
   pure subroutine start_reading(text, path, skipped, place)
      !> The whole file
      character(len=*), intent(in) :: text
      !> Its path
      character(len=*), intent(in) :: path
      !> Lines passed over
      integer, intent(in) :: skipped
      !> Where the reader is
      type(place_type), intent(out) :: place

      place%path = path
      if (index(text(:min(3, len(text))), byte_order_mark) == 1) place%next = 4
      call skip_lines(text, skipped, place)
   end subroutine start_reading

   !> Pass over lines whatever they hold.
   pure subroutine skip_lines(text, count, place)
      character(len=*), intent(in) :: text
      integer, intent(in) :: count
      type(place_type), intent(inout) :: place
      integer :: i, length

      do i = 1, count
         if (place%next > len(text)) return
         length = index(text(place%next:), newline)
         if (length == 0) length = len(text) - place%next + 1
         place%next = place%next + length
         place%line = place%line + 1
      end do
   end subroutine skip_lines

   !> Go to the next line that is neither empty nor a comment; `next` is zero when there is none.
   pure subroutine next_line(text, place)
      !> The whole file
      character(len=*), intent(in) :: text
      !> Where the reader is
      type(place_type), intent(inout) :: place
      integer :: length

      do
         if (place%next > len(text)) exit
         length = index(text(place%next:), newline) - 1
         if (length < 0) length = len(text) - place%next + 1
         place%line = place%line + 1
         place%first = place%next
         place%last = place%first + length - 1
         place%next = place%last + 2
         if (length > 0) then
            if (text(place%last:place%last) == return) place%last = place%last - 1
         end if
         do while (place%first <= place%last)
            if (text(place%first:place%first) /= ' ') exit
            place%first = place%first + 1
         end do
         if (verify(text(place%first:place%last), ' '//tab) == 0) cycle
         if (scan(text(place%first:place%first), comments) == 0) return
      end do
      place%next = 0
   end subroutine next_line

   !> The character that separates fields.
   pure character(len=1) function separator_of(name, line) result(separator)
      !> Its name, or `auto`, and the first line
      character(len=*), intent(in) :: name, line

      select case (name)
      case ('comma')
         separator = ','
      case ('semicolon')
         separator = ';'
      case ('tab')
         separator = tab
      case ('blank')
         separator = ' '
      case default
         separator = ' '
         if (index(line, ',') > 0) separator = ','
         if (index(line, ';') > 0) separator = ';'
         if (index(line, tab) > 0) separator = tab
      end select
   end function separator_of

   !> Find a field of a line, without blanks and quotes around it; `first` is zero if there is none.
   pure subroutine find_field(line, separator, number, first, last)
      !> The line and what separates its fields
      character(len=*), intent(in) :: line
      character(len=1), intent(in) :: separator
      !> Which field, from one
      integer, intent(in) :: number
      !> Its first and last character
      integer, intent(out) :: first, last
      integer :: i, n
      logical :: in_quotes

      n = 1
      first = 1
      in_quotes = .false.
      do i = 1, len(line) + 1
         if (i <= len(line)) then
            if (line(i:i) == '"') in_quotes = .not. in_quotes
            if (in_quotes .or. .not. separates(line(i:i), separator)) cycle
            ! many blanks are one
            if (separator == ' ' .and. i == first) then
               first = i + 1
               cycle
            end if
         end if
         if (n == number .and. .not. (separator == ' ' .and. first > len(line))) then
            last = i - 1
            call strip(line, first, last)
            return
         end if
         n = n + 1
         first = i + 1
      end do
      first = 0
      last = -1
   end subroutine find_field

   pure logical function separates(letter, separator)
      character(len=1), intent(in) :: letter, separator

      separates = letter == separator .or. (separator == ' ' .and. letter == tab)
   end function separates

   !> Take blanks, and then quotes, off a field.
   pure subroutine strip(line, first, last)
      character(len=*), intent(in) :: line
      integer, intent(inout) :: first, last

      do while (first <= last)
         if (scan(line(first:first), ' '//tab) == 0) exit
         first = first + 1
      end do
      do while (first <= last)
         if (scan(line(last:last), ' '//tab) == 0) exit
         last = last - 1
      end do
      if (last > first) then
         if (line(first:first) == '"' .and. line(last:last) == '"') then
            first = first + 1
            last = last - 1
         end if
      end if
   end subroutine strip

   !> Fields of a line.
   pure integer function field_count(line, separator)
      !> The line and what separates its fields
      character(len=*), intent(in) :: line
      character(len=1), intent(in) :: separator
      integer :: first, last

      field_count = 0
      do
         call find_field(line, separator, field_count + 1, first, last)
         if (first == 0) return
         field_count = field_count + 1
      end do
   end function field_count

   !> Text of a field, empty when there is none.
   pure function field(line, place, number) result(text)
      !> The line and where it stands
      character(len=*), intent(in) :: line
      type(place_type), intent(in) :: place
      !> Which field, from one
      integer, intent(in) :: number
      character(len=:), allocatable :: text
      integer :: first, last

      text = ''
      call find_field(line, place%separator, number, first, last)
      if (first > 0) text = line(first:last)
   end function field

   !> File and line for messages.
   pure function place_text(place) result(text)
      !> The place
      type(place_type), intent(in) :: place
      character(len=:), allocatable :: text

      text = place%path//':'//to_text(place%line)
   end function place_text

end module asperity_program_record_lines
