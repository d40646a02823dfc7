!> Numbers as loggers and spreadsheets write them, with a decimal point or a decimal comma.
module asperity_program_record_numbers
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_input_values, only: read_real, word_type
   use asperity_program_record_lines, only: find_field, next_line, place_type
   use asperity_program_system_strings, only: lower_case
   implicit none
   private
   public :: decimal_of, looks_like_number, read_number

   character(len=*), parameter :: digits = '0123456789'

contains

   !> Whether a text was meant as a number, whatever its decimal sign; also NaN and infinity.
   pure logical function looks_like_number(text)
      !> A field
      character(len=*), intent(in) :: text
      character(len=len(text)) :: lower

      looks_like_number = .false.
      if (len(text) == 0) return
      lower = lower_case(text)
      if (scan(text(1:1), '+-') == 1) lower = lower(2:)
      looks_like_number = lower == 'nan' .or. lower == 'inf' .or. lower == 'infinity'
      ! e1 and d2 are names
      if (scan(text, digits) > 0 .and. scan(lower(1:1), digits//'.,') == 1) &
         looks_like_number = verify(trim(lower), digits//'+-.,ed') == 0
   end function looks_like_number

   !> The number in a field.
   pure subroutine read_number(text, decimal, value, error)
      !> The field
      character(len=*), intent(in) :: text
      !> Decimal sign, `point` or `comma`
      character(len=*), intent(in) :: decimal
      !> Its value
      real(wp), intent(out) :: value
      !> Set, without a place, when it is no finite number
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: word
      integer :: comma

      word%text = text
      comma = index(text, ',')
      if (decimal == 'comma' .and. comma > 0) then
         word%text(comma:comma) = '.'
         ! a point beside a comma marks thousands, which nobody else reads so
         if (index(text, '.') > 0) word%text = '?'//text
      end if
      word%source = ''
      call read_real(word, '', value, error)
   end subroutine read_number

   !> The decimal sign of some columns, `point`, `comma`, or nothing where both are possible: where
   !> every comma has three figures behind it, as thousands have, and may have them before it.
   pure function decimal_of(text, start, columns) result(decimal)
      !> The whole file
      character(len=*), intent(in) :: text
      !> Its first line of numbers
      type(place_type), intent(in) :: start
      !> Places of the columns in a line
      integer, intent(in) :: columns(:)
      character(len=:), allocatable :: decimal
      type(place_type) :: place
      integer :: i, first, last, points, commas, unsure

      points = 0
      commas = 0
      unsure = 0
      place = start
      if (index(text(place%first:), ',') == 0) place%next = 0
      do while (place%next > 0)
         associate (line => text(place%first:place%last))
            do i = 1, size(columns)
               call find_field(line, place%separator, columns(i), first, last)
               if (first == 0 .or. last < first) cycle
               if (.not. looks_like_number(line(first:last))) cycle
               if (index(line(first:last), '.') > 0) then
                  points = points + 1
               else if (index(line(first:last), ',') > 0) then
                  commas = commas + 1
                  if (is_thousands(line(first:last))) unsure = unsure + 1
               end if
            end do
         end associate
         call next_line(text, place)
      end do
      decimal = 'point'
      if (points > 0 .or. commas == 0) return
      decimal = 'comma'
      if (unsure == commas) decimal = ''
   end function decimal_of

   !> Whether a number with commas may mark thousands by them, such as 12,345.
   pure logical function is_thousands(text)
      character(len=*), intent(in) :: text
      integer :: comma, first

      first = 1
      if (scan(text(1:1), '+-') == 1) first = 2
      comma = first - 1 + index(text(first:), ',')
      is_thousands = comma > first .and. comma <= first + 3 .and. text(first:first) /= '0' &
         .and. verify(text(comma + 1:), digits//',') == 0
      if (.not. is_thousands) return
      is_thousands = modulo(len(text) - comma, 4) == 3
   end function is_thousands

end module asperity_program_record_numbers
