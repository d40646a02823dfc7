!> The statements of a Fortran source, one after the other, whole: without labels, comments and
!> blanks, in lower case but for what stands in quotes.
module asperity_check_source_statements
   use asperity_base_letter_case, only: lower_case
   implicit none
   private
   public :: next_statement, statement_reader

   !> What ends a line
   character(len=*), parameter, public :: newline = new_line('a')
   character(len=*), parameter :: tab = achar(9), digits = '0123456789'
   character(len=*), parameter :: blanks = ' '//tab//achar(13)
   character(len=*), parameter :: quotes = '"'//''''

   !> How far a source is read.
   type :: statement_reader
      private
      !> Where the next line begins, and the number of the last one
      integer :: next = 1, line = 0
      !> How deep conditions of the preprocessor are nested, and at which depth lines began to be
      !> left out, 0 for none
      integer :: depth = 0, hidden = 0
      !> Whether the condition has had no part yet that counts
      logical :: none_yet = .false.
      !> What is read and not yet taken: statements between semicolons; and its line
      character(len=:), allocatable :: rest
      integer :: rest_line = 0
   end type statement_reader

contains

   !> The next statement of a source.
   pure subroutine next_statement(text, form, reader, statement, line, found)
      !> The source
      character(len=*), intent(in) :: text
      !> `fixed` or `free`
      character(len=*), intent(in) :: form
      !> New before the first statement
      type(statement_reader), intent(inout) :: reader
      !> The statement
      character(len=:), allocatable, intent(out) :: statement
      !> Line that it begins on
      integer, intent(out) :: line
      !> Whether there was one
      logical, intent(out) :: found
      integer :: finish

      line = 0
      if (.not. allocated(reader%rest)) reader%rest = ''
      do
         do while (reader%rest == '' .and. reader%next <= len(text))
            reader%rest = ''
            if (form == 'free') then
               call read_free(text, reader)
            else
               call read_fixed(text, reader)
            end if
         end do
         found = reader%rest /= ''
         if (.not. found) return
         finish = end_of_first(reader%rest)
         statement = reader%rest(:finish - 1)
         reader%rest = reader%rest(finish + 1:)
         line = reader%rest_line
         ! nothing between two semicolons, or a label alone
         if (verify(statement, digits) == 0) cycle
         statement = statement(verify(statement, digits):)
         return
      end do
   end subroutine next_statement

   !> Where the first of several statements ends: at a semicolon outside of quotes, or behind it.
   pure integer function end_of_first(statements) result(finish)
      character(len=*), intent(in) :: statements
      character(len=1) :: quote

      quote = ' '
      do finish = 1, len(statements)
         if (quote == ' ') then
            if (statements(finish:finish) == ';') return
            if (scan(statements(finish:finish), quotes) > 0) quote = statements(finish:finish)
         else if (statements(finish:finish) == quote) then
            quote = ' '
         end if
      end do
   end function end_of_first

   !> Read what stands on a line of free form and on those that continue it.
   pure subroutine read_free(text, reader)
      character(len=*), intent(in) :: text
      type(statement_reader), intent(inout) :: reader
      character(len=1) :: quote
      integer :: first, last
      logical :: continued, found

      quote = ' '
      continued = .false.
      do
         call take_line(text, 'free', reader, first, last, found)
         if (.not. found) return
         ! empty lines and comments may stand between
         if (first > last) cycle
         if (text(first:first) == '!') cycle
         if (.not. continued) reader%rest_line = reader%line
         if (continued .and. text(first:first) == '&') first = first + 1
         call append(text(first:last), reader%rest, quote)
         continued = .false.
         if (len(reader%rest) > 0) continued = reader%rest(len(reader%rest):) == '&'
         if (.not. continued) return
         reader%rest = reader%rest(:len(reader%rest) - 1)
      end do
   end subroutine read_free

   !> Read what stands on a line of fixed form and on those that continue it.
   pure subroutine read_fixed(text, reader)
      character(len=*), intent(in) :: text
      type(statement_reader), intent(inout) :: reader
      type(statement_reader) :: before
      character(len=1) :: quote
      integer :: first, last, start
      logical :: begun, continues, found

      quote = ' '
      begun = .false.
      do
         before = reader
         call take_line(text, 'fixed', reader, first, last, found)
         if (.not. found) return
         if (is_comment(text(first:last))) cycle
         call split_line(text(first:last), continues, start)
         if (begun .and. .not. continues) then
            reader = before
            return
         end if
         if (.not. begun) reader%rest_line = reader%line
         begun = .true.
         call append(text(first - 1 + start:last), reader%rest, quote)
      end do
   end subroutine read_fixed

   !> Whether a line of fixed form has no statement. In column 6 a ! continues one.
   pure logical function is_comment(line)
      character(len=*), intent(in) :: line
      integer :: first

      is_comment = .true.
      first = verify(line, blanks)
      if (first == 0) return
      if (scan(line(1:1), 'cCdD*!') > 0) return
      is_comment = line(first:first) == '!' .and. (first /= 6 .or. index(line(:first), tab) > 0)
   end function is_comment

   !> Where the statement on a line of fixed form begins, and whether it continues the last one: by
   !> a mark in column 6, or by a digit behind a tab.
   pure subroutine split_line(line, continues, start)
      character(len=*), intent(in) :: line
      logical, intent(out) :: continues
      integer, intent(out) :: start
      integer :: at

      continues = .false.
      start = 1
      at = index(line(:min(6, len(line))), tab)
      if (at > 0) then
         start = at + 1
         continues = scan(line(start:min(start, len(line))), '123456789') > 0
         if (continues) start = start + 1
      else if (len(line) > 5) then
         if (verify(line(:5), ' '//digits) > 0) return
         continues = line(:5) == '' .and. scan(line(6:6), ' 0') == 0
         start = 7
      end if
   end subroutine split_line

   !> Append a part of a line to a statement, up to its comment.
   pure subroutine append(part, statement, quote)
      character(len=*), intent(in) :: part
      character(len=:), allocatable, intent(inout) :: statement
      !> The quote that is open, a blank for none
      character(len=1), intent(inout) :: quote
      character(len=len(part)) :: kept
      integer :: i, n

      n = 0
      do i = 1, len(part)
         if (quote == ' ') then
            if (part(i:i) == '!') exit
            if (scan(part(i:i), blanks) > 0) cycle
            if (scan(part(i:i), quotes) > 0) quote = part(i:i)
            n = n + 1
            kept(n:n) = lower_case(part(i:i))
         else
            if (part(i:i) == quote) quote = ' '
            n = n + 1
            kept(n:n) = part(i:i)
         end if
      end do
      statement = statement//kept(:n)
   end subroutine append

   !> The next line that the preprocessor leaves, of #if and #else the first part that is not #if 0.
   !> In free form without the blanks before it, always without those behind it.
   pure subroutine take_line(text, form, reader, first, last, found)
      character(len=*), intent(in) :: text, form
      type(statement_reader), intent(inout) :: reader
      !> Its first and last character; an empty line has none
      integer, intent(out) :: first, last
      logical, intent(out) :: found
      integer :: length

      found = .false.
      first = 1
      last = 0
      do while (reader%next <= len(text))
         first = reader%next
         length = index(text(first:), newline) - 1
         if (length < 0) length = len(text) - first + 1
         last = first - 1 + verify(text(first:first - 1 + length), blanks, back=.true.)
         reader%next = first + length + 1
         reader%line = reader%line + 1
         if (form == 'free') first = first + max(verify(text(first:last), blanks) - 1, 0)
         if (text(first:min(first, last)) == '#') then
            call follow_condition(text(first + 1:last), reader)
            cycle
         end if
         found = reader%hidden == 0
         if (found) return
      end do
   end subroutine take_line

   !> Follow a line of the preprocessor.
   pure subroutine follow_condition(directive, reader)
      character(len=*), intent(in) :: directive
      type(statement_reader), intent(inout) :: reader
      character(len=8) :: words

      words = adjustl(directive)
      if (words(:2) == 'if') then
         reader%depth = reader%depth + 1
         if (reader%hidden > 0) return
         reader%none_yet = words == 'if 0'
         if (reader%none_yet) reader%hidden = reader%depth
      else if (words(:2) == 'el') then
         if (reader%hidden == 0) then
            reader%hidden = reader%depth
         else if (reader%hidden == reader%depth .and. reader%none_yet) then
            reader%hidden = 0
            reader%none_yet = .false.
         end if
      else if (words(:5) == 'endif') then
         if (reader%hidden == reader%depth) reader%hidden = 0
         reader%depth = max(reader%depth - 1, 0)
      end if
   end subroutine follow_condition

end module asperity_check_source_statements
