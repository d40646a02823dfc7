!> Splits the text of a case file into words, quoted texts and marks, each with its line.
!> What it accepts is a subset of Fortran's namelist input.
module asperity_program_input_scanner
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_system_strings, only: newline, quoted
   implicit none
   private
   public :: scanner_type, token_type, new_scanner

   integer, parameter :: longest_line = 10000
   character(len=*), parameter :: tab = achar(9), return = achar(13)
   character(len=*), parameter :: blanks = ' '//tab//return//newline
   character(len=*), parameter :: word_ends = blanks//',=/!&''"'

   !> Kinds of tokens
   enum, bind(c)
      !> The text is at its end
      enumerator :: token_none = 0
      !> Anything without quotes: a name, a number, a logical
      enumerator :: token_word
      !> A text in quotes
      enumerator :: token_quoted
      !> `=`
      enumerator :: token_equals
      !> `,`
      enumerator :: token_comma
      !> `/`, the end of the group
      enumerator :: token_slash
      !> `&name`, the beginning of the group
      enumerator :: token_group
   end enum
   public :: token_none, token_word, token_quoted, token_equals, token_comma, token_slash, &
      token_group

   !> One piece of the text.
   type :: token_type
      !> One of the kinds above
      integer :: kind = token_none
      !> Its text, without quotes
      character(len=:), allocatable :: text
      !> Its line, from 1
      integer :: line = 0
      !> A word with `=` after it: the name of a key
      logical :: names_key = .false.
      !> A comment stands between the token before and this one
      logical :: after_comment = .false.
   end type token_type

   !> A text and how far it is read.
   type :: scanner_type
      private
      character(len=:), allocatable :: text, name
      integer :: position = 1, line = 1
   contains
      !> Take the next token
      procedure :: next
      !> Look at the next token without taking it
      procedure :: peek
      !> `file:line` of a token
      procedure :: place
   end type scanner_type

contains

   !> A scanner of a text whose lines and characters are checked. `error` names the line.
   pure subroutine new_scanner(scanner, text, name, error)
      !> The scanner
      type(scanner_type), intent(out) :: scanner
      !> Text of the file
      character(len=*), intent(in) :: text
      !> Name of the file, for messages
      character(len=*), intent(in) :: name
      !> Set when a line is too long or has control characters
      type(error_type), allocatable, intent(out) :: error
      integer :: i, line, first

      scanner%text = text
      scanner%name = name
      line = 1
      first = 1
      do i = 1, len(text)
         if (text(i:i) == newline) then
            line = line + 1
            first = i + 1
         else if (i - first >= longest_line) then
            call fatal_error(error, name//':'//to_text(line)//': the line is longer than '// &
               to_text(longest_line)//' characters')
            return
         else if ((iachar(text(i:i)) < 32 .and. scan(text(i:i), blanks) == 0) &
            .or. iachar(text(i:i)) == 127) then
            call fatal_error(error, name//':'//to_text(line)//': control character '// &
               to_text(iachar(text(i:i)))//' found, this is not a text file')
            return
         end if
      end do
   end subroutine new_scanner

   !> Take the next token. `error` names the line.
   pure subroutine next(self, token, error)
      !> The scanner
      class(scanner_type), intent(inout) :: self
      !> The token
      type(token_type), intent(out) :: token
      !> Set when there is no proper token
      type(error_type), allocatable, intent(out) :: error

      call skip_blanks(self, token%after_comment, error)
      if (allocated(error)) return
      token%line = self%line
      token%text = ''
      if (self%position > len(self%text)) return
      select case (self%text(self%position:self%position))
      case ('=')
         call take_mark(self, token, token_equals)
      case (',')
         call take_mark(self, token, token_comma)
      case ('/')
         call take_mark(self, token, token_slash)
      case ('&')
         self%position = self%position + 1
         call take_word(self, token, token_group)
      case ("'", '"')
         call take_quoted(self, token, error)
      case default
         call take_word(self, token, token_word)
      end select

   end subroutine next

   !> Take one mark.
   pure subroutine take_mark(self, token, kind)
      type(scanner_type), intent(inout) :: self
      type(token_type), intent(inout) :: token
      integer, intent(in) :: kind

      token%kind = kind
      token%text = self%text(self%position:self%position)
      self%position = self%position + 1
   end subroutine take_mark

   !> Take a word and see whether `=` follows.
   pure subroutine take_word(self, token, kind)
      type(scanner_type), intent(inout) :: self
      type(token_type), intent(inout) :: token
      integer, intent(in) :: kind
      integer :: length, after

      token%kind = kind
      length = scan(self%text(self%position:), word_ends) - 1
      if (length < 0) length = len(self%text) - self%position + 1
      token%text = self%text(self%position:self%position + length - 1)
      self%position = self%position + length
      after = verify(self%text(self%position:), blanks) - 1
      if (after < 0) return
      after = self%position + after
      token%names_key = self%text(after:after) == '='
   end subroutine take_word

   !> Skip blanks, line breaks and comments.
   pure subroutine skip_blanks(self, comment_seen, error)
      type(scanner_type), intent(inout) :: self
      logical, intent(out) :: comment_seen
      type(error_type), allocatable, intent(out) :: error
      character(len=1) :: before
      integer :: length

      comment_seen = .false.
      do while (self%position <= len(self%text))
         select case (self%text(self%position:self%position))
         case (newline)
            self%line = self%line + 1
         case (' ', tab, return)
            continue
         case ('!')
            before = newline
            if (self%position > 1) before = self%text(self%position - 1:self%position - 1)
            if (scan(before, blanks//',') == 0) then
               call fatal_error(error, self%place(self%line)//': a comment needs a blank before !')
               return
            end if
            comment_seen = .true.
            length = index(self%text(self%position:), newline) - 1
            if (length < 0) length = len(self%text) - self%position + 1
            self%position = self%position + length - 1
         case default
            return
         end select
         self%position = self%position + 1
      end do
   end subroutine skip_blanks

   !> Take a text in quotes; a doubled quote stands for one.
   pure subroutine take_quoted(self, token, error)
      type(scanner_type), intent(inout) :: self
      type(token_type), intent(inout) :: token
      type(error_type), allocatable, intent(out) :: error
      character(len=1) :: quote
      integer :: i

      token%kind = token_quoted
      quote = self%text(self%position:self%position)
      i = self%position + 1
      do
         if (i > len(self%text)) exit
         if (self%text(i:i) == newline) exit
         if (self%text(i:i) == quote) then
            if (self%text(i + 1:min(i + 1, len(self%text))) /= quote) then
               self%position = i + 1
               if (i == len(self%text)) return
               if (scan(self%text(i + 1:i + 1), blanks//',/') > 0) return
               call fatal_error(error, self%place(token%line)// &
                  ': a text in quotes needs a blank or comma after it')
               return
            end if
            i = i + 1
         end if
         token%text = token%text//self%text(i:i)
         i = i + 1
      end do
      call fatal_error(error, self%place(token%line)//': the text '//quoted(token%text)// &
         ' has no closing quote on its line')
   end subroutine take_quoted

   !> Look at the next token without taking it. `error` names the line.
   pure subroutine peek(self, token, error)
      !> The scanner
      class(scanner_type), intent(inout) :: self
      !> The token
      type(token_type), intent(out) :: token
      !> Set when there is no proper token
      type(error_type), allocatable, intent(out) :: error
      integer :: position, line

      position = self%position
      line = self%line
      call self%next(token, error)
      self%position = position
      self%line = line
   end subroutine peek

   !> `file:line`.
   pure function place(self, line)
      !> The scanner
      class(scanner_type), intent(in) :: self
      !> A line, from 1
      integer, intent(in) :: line
      character(len=:), allocatable :: place

      place = self%name//':'//to_text(line)
   end function place

end module asperity_program_input_scanner
