!> Text helpers: lists of texts of different length, lower case, quoting, nearest name.
module asperity_program_system_strings
   use asperity_base_letter_case, only: lower_case
   implicit none
   private
   public :: string_type, add_line, lower_case, quoted, escaped, nearest_name, repeated, &
      shell_word, split_lines, starts_with, wrapped

   character(len=*), parameter, public :: newline = new_line('a')
   !> As `\` in a literal means different things to different compilers
   character(len=*), parameter, public :: backslash = achar(92)
   integer, parameter :: most_quoted = 40

   !> One text in a list.
   type :: string_type
      !> The text
      character(len=:), allocatable :: text
   end type string_type

contains

   !> Append a text to a list.
   pure subroutine add_line(lines, text)
      !> The list, which is allocated
      type(string_type), allocatable, intent(inout) :: lines(:)
      !> The text
      character(len=*), intent(in) :: text
      type(string_type) :: line

      line%text = text
      lines = [lines, line]
   end subroutine add_line

   !> Text of the user in quotes for a message: cut if long, control characters as `?`.
   pure function quoted(text) result(message)
      !> Any text
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: message
      integer :: i

      message = text(:min(len(text), most_quoted))
      do i = 1, len(message)
         if (iachar(message(i:i)) < 32 .or. iachar(message(i:i)) >= 127) message(i:i) = '?'
      end do
      if (len(text) > most_quoted) message = message//'...'
      message = "'"//message//"'"
   end function quoted

   !> The lines of a text, none of an empty one.
   pure subroutine split_lines(text, lines)
      !> Any text
      character(len=*), intent(in) :: text
      !> Without their ends
      type(string_type), allocatable, intent(out) :: lines(:)
      integer :: i, length, start

      allocate (lines(count([(text(i:i) == newline, i=1, len(text))]) + min(len(text), 1)))
      start = 1
      do i = 1, size(lines)
         length = index(text(start:), newline) - 1
         if (length < 0) length = len(text) - start + 1
         lines(i)%text = text(start:start - 1 + length)
         start = start + length + 1
      end do
   end subroutine split_lines

   !> Text with every `mark` replaced by `replacement`.
   pure function escaped(text, mark, replacement) result(changed)
      !> Any text
      character(len=*), intent(in) :: text
      !> What is replaced
      character(len=1), intent(in) :: mark
      !> What stands for it
      character(len=*), intent(in) :: replacement
      character(len=:), allocatable :: changed
      integer :: i

      changed = ''
      do i = 1, len(text)
         if (text(i:i) == mark) then
            changed = changed//replacement
         else
            changed = changed//text(i:i)
         end if
      end do
   end function escaped

   !> A text as one word of a shell command, in quotes where it needs them.
   pure function shell_word(text) result(word)
      !> Any text
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: word
      character(len=*), parameter :: plain = 'abcdefghijklmnopqrstuvwxyz'// &
         'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./,:=+-%@'

      word = text
      if (text == '' .or. verify(text, plain) > 0) &
         word = "'"//escaped(text, "'", "'"//backslash//"''")//"'"
   end function shell_word

   !> A text as lines of a width, broken at blanks; what has none stays whole.
   pure function wrapped(text, width, indent) result(lines)
      !> Any text without line breaks
      character(len=*), intent(in) :: text
      !> Characters of a line
      integer, intent(in) :: width
      !> Blanks before every line but the first
      integer, intent(in) :: indent
      character(len=:), allocatable :: lines
      integer :: before, cut, first, start

      lines = ''
      first = 1
      before = 0
      do while (len(text) - first + 1 > width - before)
         start = first - 1 + verify(text(first:), ' ')
         cut = first - 1 + index(text(first:first + width - before), ' ', back=.true.)
         ! a word that is too long
         if (cut <= start) cut = start - 1 + index(text(start:), ' ')
         if (cut < start) exit
         lines = lines//repeat(' ', before)//trim(text(first:cut - 1))//newline
         first = cut - 1 + verify(text(cut:), ' ')
         if (first < cut) return
         before = indent
      end do
      lines = lines//repeat(' ', before)//text(first:)
   end function wrapped

   !> Whether `text` begins with `start`.
   pure logical function starts_with(text, start)
      !> Any text
      character(len=*), intent(in) :: text
      !> The beginning looked for
      character(len=*), intent(in) :: start

      starts_with = .false.
      if (len(text) >= len(start)) starts_with = text(:len(start)) == start
   end function starts_with

   !> The name that a mistyped one most likely means, or nothing when none is near.
   pure function nearest_name(mistyped, names) result(nearest)
      !> What the user wrote
      character(len=*), intent(in) :: mistyped
      !> Names known
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: nearest
      integer :: i, distance, least

      nearest = ''
      if (len(mistyped) > 2*len(names)) return
      least = max(1, len(mistyped)/3) + 1
      do i = 1, size(names)
         distance = edit_distance(mistyped, trim(names(i)))
         if (distance >= least) cycle
         least = distance
         nearest = trim(names(i))
      end do
   end function nearest_name

   !> Insertions, deletions, replacements and swaps of neighbours between two texts.
   pure integer function edit_distance(a, b)
      character(len=*), intent(in) :: a, b
      integer :: table(-1:len(a), -1:len(b)), i, j, change

      table = len(a) + len(b)
      do i = 0, len(a)
         table(i, 0) = i
      end do
      do j = 0, len(b)
         table(0, j) = j
      end do
      do j = 1, len(b)
         do i = 1, len(a)
            change = merge(0, 1, a(i:i) == b(j:j))
            table(i, j) = min(table(i - 1, j) + 1, table(i, j - 1) + 1, &
               table(i - 1, j - 1) + change)
            if (i < 2 .or. j < 2) cycle
            if (a(i:i) == b(j - 1:j - 1) .and. a(i - 1:i - 1) == b(j:j)) &
               table(i, j) = min(table(i, j), table(i - 2, j - 2) + 1)
         end do
      end do
      edit_distance = table(len(a), len(b))
   end function edit_distance

   !> The first text that is the same as an earlier one, empty for none.
   pure function repeated(list) result(text)
      !> The texts
      type(string_type), intent(in) :: list(:)
      character(len=:), allocatable :: text
      integer :: i, j

      text = ''
      do i = 2, size(list)
         do j = 1, i - 1
            if (list(j)%text /= list(i)%text) cycle
            text = list(i)%text
            return
         end do
      end do
   end function repeated

end module asperity_program_system_strings
