!> Lists of words and numbers as options and defaults write them: `a,b,c` or `start:stop:count`.
module asperity_program_input_ranges
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_program_input_values, only: read_integer, read_real, refuse, word_type
   use asperity_program_system_strings, only: quoted
   implicit none
   private
   public :: split_words, read_range, linear_range, list_text

   !> Most values in a list
   integer, parameter, public :: longest_list = 100000

contains

   !> Words of a text that are separated by blanks or single commas.
   pure subroutine split_words(text, source, words, error)
      !> The text, and where it stands
      character(len=*), intent(in) :: text, source
      !> Its words
      type(word_type), allocatable, intent(inout) :: words(:)
      !> Set when there is none, or an empty one between commas
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: all_of_it
      integer :: i, first, n, pass

      if (allocated(words)) deallocate (words)
      all_of_it%text = text
      all_of_it%source = source
      do pass = 1, 2
         n = 0
         first = 1
         do i = 1, len(text) + 1
            if (i <= len(text)) then
               if (scan(text(i:i), ', ') == 0) cycle
            end if
            if (i > first) then
               n = n + 1
               if (pass == 2) then
                  words(n)%text = text(first:i - 1)
                  words(n)%source = source
               end if
            end if
            first = i + 1
         end do
         if (pass == 1) allocate (words(n))
      end do
      if (size(words) == 0) then
         call refuse(error, all_of_it, 'the list is empty')
      else if (has_gap(text)) then
         call refuse(error, all_of_it, 'the list '//quoted(text)//' has an empty value')
      end if
   end subroutine split_words

   !> Whether a comma has no value before or after it.
   pure logical function has_gap(text)
      character(len=*), intent(in) :: text
      integer :: i
      logical :: after_comma

      has_gap = .true.
      after_comma = .true.
      do i = 1, len(text)
         if (text(i:i) == ' ') cycle
         if (text(i:i) == ',' .and. after_comma) return
         after_comma = text(i:i) == ','
      end do
      has_gap = after_comma
   end function has_gap

   !> Values of `start:stop:count`.
   pure subroutine read_range(text, key, source, values, error)
      !> The range, the name of its key, and where it stands
      character(len=*), intent(in) :: text, key, source
      !> The values, evenly spaced, both ends exact
      real(wp), allocatable, intent(out) :: values(:)
      !> Set when it is no range
      type(error_type), allocatable, intent(out) :: error
      type(word_type) :: part(3), all_of_it
      real(wp) :: start, stop
      integer :: first, second, count, i

      all_of_it%text = text
      all_of_it%source = source
      first = index(text, ':')
      second = index(text, ':', back=.true.)
      if (first == second) then
         call refuse(error, all_of_it, key//' = '//quoted(text)//' is not start:stop:count')
         return
      end if
      do i = 1, 3
         part(i)%source = source
      end do
      part(1)%text = text(:first - 1)
      part(2)%text = text(first + 1:second - 1)
      part(3)%text = text(second + 1:)
      call read_real(part(1), key, start, error)
      if (.not. allocated(error)) call read_real(part(2), key, stop, error)
      if (.not. allocated(error)) call read_integer(part(3), key//' count', count, error)
      if (allocated(error)) return
      if (count < 2 .or. count > longest_list) then
         call refuse(error, all_of_it, key//' count = '//to_text(count)//' is not allowed: it '// &
            'must lie between 2 and '//to_text(longest_list))
         return
      end if
      values = linear_range(start, stop, count)
   end subroutine read_range

   !> Evenly spaced values with both ends exact.
   pure function linear_range(start, stop, count) result(values)
      !> First and last value
      real(wp), intent(in) :: start, stop
      !> How many, at least two
      integer, intent(in) :: count
      real(wp) :: values(count)
      real(wp) :: part
      integer :: i

      do i = 1, count
         part = real(i - 1, wp)/real(count - 1, wp)
         values(i) = (1.0_wp - part)*start + part*stop
      end do
   end function linear_range

   !> Numbers as an option takes them, cut to a default's length.
   pure function list_text(values) result(text)
      !> The numbers; nothing after one that is none
      real(wp), intent(in) :: values(:)
      character(len=:), allocatable :: text
      character(len=32) :: number
      integer :: i, n

      text = ''
      do i = 1, size(values)
         if (is_none(values(i))) return
         if (len(text) > 0) text = text//','
         number = to_text(values(i))
         n = len_trim(number)
         if (n > 2) then
            if (number(n - 1:n) == '.0') n = n - 2
         end if
         text = text//number(:n)
         if (len(text) > 32) return
      end do
   end function list_text

end module asperity_program_input_ranges
