!> First and last statements of program units, as `next_statement` gives them: without blanks, so
!> that an assignment may look alike.
module asperity_check_source_heads
   implicit none
   private
   public :: begins, begins_interface, ended_kind, identifier_end, read_head

   !> Longest name that is kept
   integer, parameter, public :: name_length = 63
   character(len=*), parameter :: name_letters = 'abcdefghijklmnopqrstuvwxyz0123456789_$'
   !> What the head of a procedure may begin with
   character(len=*), parameter :: prefixes(14) = [character(len=15) :: 'real', 'integer', &
      'doubleprecision', 'doublecomplex', 'complex', 'logical', 'character', 'type(', 'recursive', &
      'pure', 'impure', 'elemental', 'module', 'non_recursive']

contains

   !> The head of a procedure: prefixes, the keyword, the name, arguments in parentheses, suffixes.
   pure subroutine read_head(statement, keyword, name, arguments, bound, is_head)
      !> A statement, and what the head is of: `subroutine`, `function` or `entry`
      character(len=*), intent(in) :: statement, keyword
      !> Name of the procedure
      character(len=name_length), intent(out) :: name
      !> Names of its arguments with commas between
      character(len=:), allocatable, intent(out) :: arguments
      !> Whether it has BIND(C)
      logical, intent(out) :: bound
      !> Whether it is such a head at all
      logical, intent(out) :: is_head
      integer :: last, finish, start

      name = ''
      arguments = ''
      bound = .false.
      is_head = .false.
      start = index(statement, keyword)
      if (start == 0) return
      if (.not. is_prefix(statement(:start - 1), keyword)) return
      start = start + len(keyword)
      finish = start - 1 + identifier_end(statement(start:))
      if (finish < start) return
      if (scan(statement(start:start), '0123456789_$') > 0) return
      last = finish
      if (statement(finish + 1:min(finish + 1, len(statement))) == '(') then
         last = finish + index(statement(finish + 1:), ')')
         if (last == finish) return
         arguments = statement(finish + 2:last - 1)
         if (verify(arguments, name_letters//',*') > 0) return
      else if (keyword == 'function') then
         return
      end if
      bound = begins(statement(last + 1:), 'bind(c')
      is_head = last == len(statement) .or. bound .or. begins(statement(last + 1:), 'result(')
      name = statement(start:finish)
   end subroutine read_head

   !> Whether a text may stand before a keyword: a type, words of a procedure.
   pure logical function is_prefix(text, keyword)
      character(len=*), intent(in) :: text, keyword
      integer :: depth, i

      is_prefix = text == ''
      if (is_prefix .or. keyword == 'entry') return
      depth = 0
      do i = 1, len(text)
         if (text(i:i) == '(') depth = depth + 1
         if (text(i:i) == ')') depth = depth - 1
         ! of a declaration or an assignment
         if (depth == 0 .and. scan(text(i:i), '=,:/%"'//'''') > 0) return
      end do
      is_prefix = any([(begins(text, trim(prefixes(i))), i=1, size(prefixes))])
   end function is_prefix

   !> Whether a statement begins an interface.
   pure logical function begins_interface(statement) result(is_head)
      !> A statement
      character(len=*), intent(in) :: statement

      is_head = statement == 'abstractinterface' .or. begins(statement, 'interfaceoperator(') .or. &
         begins(statement, 'interfaceassignment(=)') .or. begins(statement, 'interfaceread(') .or. &
         begins(statement, 'interfacewrite(')
      if (begins(statement, 'interface')) &
         is_head = is_head .or. identifier_end(statement) == len(statement)
   end function begins_interface

   !> The kind of unit that a statement ends: `any` of END alone, empty if it ends none.
   pure function ended_kind(statement) result(kind)
      !> A statement
      character(len=*), intent(in) :: statement
      character(len=9) :: kind
      character(len=*), parameter :: words(8) = [character(len=10) :: 'subroutine', 'function', &
         'procedure', 'module', 'submodule', 'program', 'blockdata', 'interface']
      character(len=*), parameter :: kinds(8) = [character(len=9) :: 'procedure', 'procedure', &
         'procedure', 'module', 'module', 'program', 'program', 'interface']
      integer :: i

      kind = ''
      if (statement == 'end') kind = 'any'
      if (begins(statement, 'endinterfaceoperator(') .or. &
         begins(statement, 'endinterfaceassignment(')) kind = 'interface'
      ! not an assignment
      if (.not. begins(statement, 'end') .or. identifier_end(statement) < len(statement)) return
      do i = 1, size(words)
         if (begins(statement, 'end'//trim(words(i)))) kind = kinds(i)
      end do
   end function ended_kind

   !> Last character of the name that a text begins with.
   pure integer function identifier_end(text)
      !> In lower case
      character(len=*), intent(in) :: text

      identifier_end = verify(text, name_letters) - 1
      if (identifier_end < 0) identifier_end = len(text)
   end function identifier_end

   !> Whether a text begins with another one.
   pure logical function begins(text, start)
      !> The text, and the other one
      character(len=*), intent(in) :: text, start

      begins = .false.
      if (len(text) >= len(start)) begins = text(:len(start)) == start
   end function begins

end module asperity_check_source_heads
