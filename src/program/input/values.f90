!> Words of the user, as they stand in a case file or in an option, and what they mean.
module asperity_program_input_values
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_program_system_strings, only: lower_case, quoted
   implicit none
   private
   public :: word_type, read_integer, read_logical, read_real, refuse

   integer, parameter :: longest_number = 100
   !> Numbers from 10 to this power on are refused before they could overflow when read
   integer, parameter :: largest_exponent = 300
   !> Stands for exponents that do not fit an integer
   integer, parameter :: far = 100000

   !> One value as it was written, before its kind is known.
   type :: word_type
      !> The text, without its quotes
      character(len=:), allocatable :: text
      !> Whether it had quotes
      logical :: in_quotes = .false.
      !> Where it stands, such as `case.nml:4` or `--sigma`
      character(len=:), allocatable :: source
   end type word_type

contains

   !> The finite real number that a word means.
   pure subroutine read_real(word, key, value, error)
      !> What was written
      type(word_type), intent(in) :: word
      !> Name of the key, for the message
      character(len=*), intent(in) :: key
      !> Its value
      real(wp), intent(out) :: value
      !> Set when it means none
      type(error_type), allocatable, intent(out) :: error
      integer :: status

      value = 0.0_wp
      if (index(word%text, '*') > 0 .and. .not. word%in_quotes) then
         call refuse(error, word, key//': repeat counts such as '//quoted(word%text)// &
            ' are not supported, write every value')
         return
      end if
      status = 1
      if (is_number(word%text) .and. .not. word%in_quotes) then
         if (decimal_exponent(word%text) <= largest_exponent) &
            read (word%text, *, iostat=status) value
      end if
      if (status == 0) then
         if (ieee_is_finite(value)) return
      end if
      call refuse(error, word, key//' = '//quoted(word%text)// &
         ' is not a finite number')
   end subroutine read_real

   !> The whole number that a word means.
   pure subroutine read_integer(word, key, value, error)
      !> What was written
      type(word_type), intent(in) :: word
      !> Name of the key, for the message
      character(len=*), intent(in) :: key
      !> Its value
      integer, intent(out) :: value
      !> Set when it means none
      type(error_type), allocatable, intent(out) :: error
      integer :: status

      value = 0
      status = 1
      if (is_number(word%text) .and. scan(word%text, '.eEdD') == 0 .and. .not. word%in_quotes) &
         read (word%text, *, iostat=status) value
      if (status /= 0) call refuse(error, word, key//' = '//quoted(word%text)// &
         ' is not a whole number within range')
   end subroutine read_integer

   !> The logical that a word means.
   pure subroutine read_logical(word, key, value, error)
      !> What was written
      type(word_type), intent(in) :: word
      !> Name of the key, for the message
      character(len=*), intent(in) :: key
      !> Its value
      logical, intent(out) :: value
      !> Set when it means none
      type(error_type), allocatable, intent(out) :: error

      value = .false.
      if (.not. word%in_quotes) then
         select case (lower_case(word%text))
         case ('.true.', 'true', '.t.', 't')
            value = .true.
            return
         case ('.false.', 'false', '.f.', 'f')
            return
         case default
            continue
         end select
      end if
      call refuse(error, word, key//' = '//quoted(word%text)// &
         ' is neither true nor false')
   end subroutine read_logical

   !> Whether a text is a decimal number: sign, digits with at most one point, exponent.
   pure logical function is_number(text)
      character(len=*), intent(in) :: text
      integer :: digits_end, first

      is_number = .false.
      if (len(text) == 0 .or. len(text) > longest_number) return
      first = 1
      if (scan(text(1:1), '+-') == 1) first = 2
      digits_end = scan(text, 'eEdD') - 1
      if (digits_end < 0) digits_end = len(text)
      associate (mantissa => text(first:digits_end))
         if (verify(mantissa, '0123456789.') > 0 .or. scan(mantissa, '0123456789') == 0) return
         if (index(mantissa, '.') /= index(mantissa, '.', back=.true.)) return
      end associate
      if (digits_end < len(text)) then
         first = digits_end + 2
         if (first > len(text)) return
         if (scan(text(first:first), '+-') == 1) first = first + 1
         if (first > len(text)) return
         if (verify(text(first:), '0123456789') > 0) return
      end if
      is_number = .true.
   end function is_number

   !> Exponent of a decimal number in scientific form; zero for zero.
   pure integer function decimal_exponent(text) result(exponent)
      character(len=*), intent(in) :: text
      integer :: mark, point, first, status

      exponent = 0
      mark = scan(text, 'eEdD')
      if (mark == 0) mark = len(text) + 1
      point = index(text(:mark - 1), '.')
      if (point == 0) point = mark
      first = scan(text(:mark - 1), '123456789')
      if (first == 0) return
      if (mark < len(text)) then
         read (text(mark + 1:), *, iostat=status) exponent
         if (status /= 0) exponent = merge(-far, far, text(mark + 1:mark + 1) == '-')
         exponent = max(-far, min(far, exponent))
      end if
      exponent = exponent + merge(point - first - 1, point - first, first < point)
   end function decimal_exponent

   !> An error at the place of a word.
   pure subroutine refuse(error, word, message)
      !> Set on return
      type(error_type), allocatable, intent(out) :: error
      !> What was written
      type(word_type), intent(in) :: word
      !> What is wrong with it
      character(len=*), intent(in) :: message

      call fatal_error(error, word%source//': '//message)
   end subroutine refuse

end module asperity_program_input_values
