!> Fields of a line of text: numbers and words that stand for missing ones, between separators.
module asperity_height_map_text_fields
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_file_errors, only: excerpt, line_error
   use asperity_height_map_text_numbers, only: number_absent, number_found, number_too_large, &
      read_number
   implicit none
   private
   public :: choose_separator, field_error, is_colour, read_field, skip_field

   !> What a field holds: a number, nothing or a word for it, or one of the faults
   integer, parameter, public :: field_number = 0, field_missing = 1, field_text = 2, &
      field_decimal_comma = 3, field_infinite = 4, field_too_large = 5

   character(len=1), parameter :: tab = achar(9), quote = '"'
   !> Words that stand for a height that is missing, in lower case
   character(len=*), parameter :: missing_words(15) = [character(len=10) :: 'nan', 'bad', &
      'nodata', &
      'no data', 'no_data', 'null', 'none', 'na', 'n/a', 'missing', 'invalid', 'void', '---', &
      '***', &
      '1.#qnan']
   integer, parameter :: longest_word = 12
   !> Beside what `read_number` finds
   integer, parameter :: number_empty = -1

contains

   !> Read the field at `at`, and go to the next.
   pure subroutine read_field(text, at, last, separator, value, kind, is_last)
      !> Last character of the line
      integer, intent(in) :: last
      !> The block that the line is in
      character(len=1), intent(in) :: text(last)
      !> Where the field begins, then where the next does; for a fault, where that is
      integer, intent(inout) :: at
      !> What separates fields; a blank for blanks and tabs
      character(len=1), intent(in) :: separator
      !> The number, `none` without one
      real(wp), intent(out) :: value
      !> One of the parameters `field_*`
      integer, intent(out) :: kind
      !> Whether the line has no further field
      logical, intent(out) :: is_last
      integer :: start, status
      logical :: is_quoted

      value = none
      kind = field_missing
      is_last = .true.
      call skip_blanks(text, at, last, separator)
      if (at > last) return
      is_quoted = text(at) == quote .and. at < last
      if (is_quoted) at = at + 1
      if (text(at) == separator) then
         at = at + 1
         is_last = .false.
         return
      end if
      start = at
      if (is_quoted .and. text(at) == quote) then
         ! nothing between quotes
         status = number_empty
      else
         call read_number(text, at, last, value, status)
      end if
      if (status == number_found .and. at <= last) then
         ! a number such as 1.#QNAN, 12abc or 1,5
         if (.not. ends_field(text(at), separator)) status = number_absent
      end if
      if (status == number_found) then
         kind = field_number
         if (separator == ',' .and. at > start + 1) then
            if (is_fraction(text(start:at - 1))) kind = field_decimal_comma
         end if
      else if (status == number_too_large) then
         kind = field_too_large
      else if (status /= number_empty) then
         call read_word(text, start, last, separator, at, kind)
         value = none
      end if
      if (kind > field_missing) then
         at = start
         return
      end if
      if (is_quoted .and. at <= last) then
         if (text(at) == quote) at = at + 1
      end if
      call skip_blanks(text, at, last, separator)
      is_last = at > last
      if (is_last) return
      if (separator /= ' ') then
         if (text(at) == separator) then
            at = at + 1
         else
            kind = field_text
            if (text(at) == ',') kind = field_decimal_comma
         end if
      end if
   end subroutine read_field

   !> Go past a field whatever it holds.
   pure subroutine skip_field(text, at, last, separator, is_last)
      !> Last character of the line
      integer, intent(in) :: last
      !> The block that the line is in
      character(len=1), intent(in) :: text(last)
      !> A place in the field, then where the next begins
      integer, intent(inout) :: at
      !> What separates fields; a blank for blanks and tabs
      character(len=1), intent(in) :: separator
      !> Whether the line has no further field
      logical, intent(out) :: is_last

      do while (at <= last)
         if (text(at) == separator .or. (text(at) == tab .and. separator == ' ')) exit
         at = at + 1
      end do
      is_last = at > last
      if (separator /= ' ') at = at + 1
      call skip_blanks(text, at, last, separator)
      if (separator == ' ') is_last = at > last
   end subroutine skip_field

   pure subroutine skip_blanks(text, at, last, separator)
      integer, intent(in) :: last
      character(len=1), intent(in) :: text(last)
      integer, intent(inout) :: at
      character(len=1), intent(in) :: separator

      do while (at <= last)
         if (text(at) /= ' ' .and. (text(at) /= tab .or. separator == tab)) exit
         at = at + 1
      end do
   end subroutine skip_blanks

   pure logical function ends_field(c, separator)
      character(len=1), intent(in) :: c, separator

      ends_field = c == ' ' .or. c == separator .or. c == tab .or. c == quote
   end function ends_field

   !> Whether a whole number begins with a 0 that no number needs, as what follows a decimal comma.
   pure logical function is_fraction(token)
      character(len=1), intent(in) :: token(:)
      integer :: i

      is_fraction = token(1) == '0'
      do i = 1, size(token)
         is_fraction = is_fraction .and. token(i) >= '0' .and. token(i) <= '9'
      end do
   end function is_fraction

   !> Read a word, which stands for a missing number or is a fault.
   pure subroutine read_word(text, start, last, separator, at, kind)
      integer, intent(in) :: start, last
      character(len=1), intent(in) :: text(last)
      character(len=1), intent(in) :: separator
      !> Character after the word
      integer, intent(out) :: at
      integer, intent(out) :: kind
      character(len=longest_word) :: word
      integer :: i, n

      word = ''
      do i = 1, min(longest_word, last - start + 1)
         word(i:i) = lower(text(start + i - 1))
         ! the word may be followed by a separator, which is none of it
         if (word(i:i) == separator .and. separator /= ' ') word(i:i) = ' '
         if (word(i:i) == tab .or. word(i:i) == quote) word(i:i) = ' '
      end do
      do i = 1, size(missing_words)
         n = len_trim(missing_words(i))
         if (word(:n) /= missing_words(i)(:n) .or. word(n + 1:n + 1) /= ' ') cycle
         kind = field_missing
         at = start + n
         return
      end do
      at = start
      kind = field_text
      n = 1
      if (scan(word(1:1), '+-') > 0) n = 2
      if (word(n:n + 2) == 'inf' .or. word(n:n + 5) == '1.#inf') kind = field_infinite
      n = start - 1 + verify(word//'x', '+-0123456789')
      if (n > start .and. n < last) then
         if (text(n) == ',' .and. scan(text(n + 1), '0123456789') > 0) kind = field_decimal_comma
      end if
   end subroutine read_word

   pure character(len=1) function lower(c)
      character(len=1), intent(in) :: c

      lower = c
      if (c >= 'A' .and. c <= 'Z') lower = achar(iachar(c) + 32)
   end function lower

   !> Set `error` to the fault that `read_field` found.
   pure subroutine field_error(error, source, at, kind)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> The file
      type(byte_source), intent(in) :: source
      !> Place in the block
      integer, intent(in) :: at
      !> The fault
      integer, intent(in) :: kind
      character(len=:), allocatable :: text

      call excerpt(source, at, text)
      select case (kind)
      case (field_decimal_comma)
         call line_error(error, source, at, 'decimal comma at '//text//': numbers must have '// &
            'decimal points: replace the commas, or export with points')
      case (field_infinite)
         call line_error(error, source, at, text//' is not allowed: a height must be a finite '// &
            'number, or NaN where it is missing')
      case (field_too_large)
         call line_error(error, source, at, text//' is not allowed: numbers above 1e308 cannot '// &
            'be read; write NaN where a height is missing')
      case default
         call line_error(error, source, at, text//' is no number: allowed are numbers such as '// &
            '-1.5e-3, and NaN, BAD or No Data where a height is missing')
      end select
   end subroutine field_error

   !> What separates the fields of a line: semicolons, commas, tabs, or a blank for blanks.
   pure character(len=1) function choose_separator(text)
      !> The line
      character(len=*), intent(in) :: text
      character(len=1) :: c
      integer :: i
      logical :: was_blank
      character(len=1) :: before

      choose_separator = ' '
      if (index(text, ';') > 0) then
         choose_separator = ';'
         return
      end if
      if (scan(text, ','//tab) == 0) return
      ! Two numbers with nothing but blanks between: blanks separate, and commas are decimal
      before = ','
      was_blank = .false.
      do i = 1, len(text)
         c = text(i:i)
         if (c == ' ') then
            was_blank = .true.
            cycle
         end if
         if (was_blank .and. is_of_number(before) .and. is_of_number(c)) return
         before = c
         was_blank = .false.
      end do
      choose_separator = ','
      if (index(text, tab) == 0) return
      if (index(text, ',') == 0) then
         choose_separator = tab
      else
         ! tabs after commas are blanks
         before = ' '
         do i = 1, len(text)
            if (text(i:i) == tab .and. before /= ',' .and. before /= ' ') choose_separator = tab
            if (text(i:i) /= ' ') before = text(i:i)
         end do
      end if
   end function choose_separator

   !> Whether a number may be the red, green or blue of a scanner.
   pure elemental logical function is_colour(value)
      !> The number
      real(wp), intent(in) :: value

      is_colour = value >= 0.0_wp .and. value <= 255.0_wp .and. &
         .not. abs(value - anint(value)) > 0.0_wp
   end function is_colour

   pure logical function is_of_number(c)
      character(len=1), intent(in) :: c

      is_of_number = scan(c, '0123456789.+-') > 0
   end function is_of_number

end module asperity_height_map_text_fields
