!> What a Fortran source has: routines with their arguments, COMMON blocks, what it includes,
!> what it calls. Names are in lower case, but for those of files.
module asperity_check_source_scan
   use asperity_check_source_heads, only: identifier_end, name_length
   use asperity_check_source_statements, only: next_statement, statement_reader
   use asperity_check_source_units, only: program_units, source_routine
   implicit none
   private
   public :: calls_elsewhere, has_external, scan_source, source_mention, source_scan

   !> A name that a source mentions.
   type :: source_mention
      !> Of the block (empty for blank COMMON), the file or the routine
      character(len=255) :: name = ''
      !> Program unit that mentions it
      character(len=name_length) :: unit = ''
      !> Line of the source
      integer :: line = 0
      !> Variables of a COMMON block in one statement
      integer :: members = 0
   end type source_mention

   !> What a source has.
   type :: source_scan
      !> Subroutines and entries, those in interfaces left out
      type(source_routine), allocatable :: routines(:)
      !> COMMON blocks, as often as they stand there
      type(source_mention), allocatable :: commons(:)
      !> INCLUDE lines
      type(source_mention), allocatable :: includes(:)
      !> Routines that are called, each once
      type(source_mention), allocatable :: calls(:)
   end type source_scan

contains

   !> Look through a source.
   pure subroutine scan_source(text, form, found)
      !> The source
      character(len=*), intent(in) :: text
      !> `fixed` or `free`
      character(len=*), intent(in) :: form
      !> What it has
      type(source_scan), intent(out) :: found
      type(statement_reader) :: reader
      type(program_units) :: units
      character(len=:), allocatable :: statement
      integer :: line
      logical :: more

      allocate (found%commons(0), found%includes(0), found%calls(0))
      do
         call next_statement(text, form, reader, statement, line, more)
         if (.not. more) exit
         call units%follow(statement, line)
         call take_common(statement, units%name(), line, found%commons)
         call take_include(statement, units%name(), line, found%includes)
         call take_call(statement, units%name(), line, found%calls)
      end do
      call units%routines(found%routines)
   end subroutine scan_source

   !> Whether a source has an external subroutine of a name.
   pure logical function has_external(found, name)
      !> What the source has
      type(source_scan), intent(in) :: found
      !> The name in lower case
      character(len=*), intent(in) :: name

      has_external = any(found%routines%name == name .and. found%routines%role == 'external')
   end function has_external

   !> Routines that a source calls and does not have.
   pure subroutine calls_elsewhere(found, calls)
      !> What the source has
      type(source_scan), intent(in) :: found
      !> Where each is called first
      type(source_mention), allocatable, intent(out) :: calls(:)
      integer :: i

      calls = pack(found%calls, [(all(found%routines%name /= found%calls(i)%name), &
         i=1, size(found%calls))])
   end subroutine calls_elsewhere

   !> COMMON blocks of a statement: /name/ variables, several in a row; the first may have no name.
   pure subroutine take_common(statement, unit, line, commons)
      character(len=*), intent(in) :: statement, unit
      integer, intent(in) :: line
      type(source_mention), allocatable, intent(inout) :: commons(:)
      character(len=:), allocatable :: name
      integer :: depth, i, members, start
      logical :: begins

      if (len(statement) < 7) return
      ! an assignment has an equals sign
      if (statement(:6) /= 'common' .or. index(statement, '=') > 0) return
      name = ''
      members = 0
      depth = 0
      begins = .true.
      i = 7
      do while (i <= len(statement))
         select case (statement(i:i))
         case ('/')
            if (members > 0) call add(commons, name, unit, line, members)
            start = i + 1
            i = start - 1 + index(statement(start:)//'/', '/')
            name = statement(start:i - 1)
            members = 0
            begins = .true.
         case ('(')
            depth = depth + 1
         case (')')
            depth = depth - 1
         case (',')
            begins = begins .or. depth == 0
         case default
            if (begins .and. depth == 0) members = members + 1
            begins = .false.
         end select
         i = i + 1
      end do
      if (members > 0) call add(commons, name, unit, line, members)
   end subroutine take_common

   !> The file of an INCLUDE line.
   pure subroutine take_include(statement, unit, line, includes)
      character(len=*), intent(in) :: statement, unit
      integer, intent(in) :: line
      type(source_mention), allocatable, intent(inout) :: includes(:)
      integer :: last

      last = len(statement)
      if (last < 10) return
      if (statement(:7) /= 'include' .or. scan(statement(8:8), '"'//'''') == 0) return
      if (statement(8:8) == statement(last:last)) &
         call add(includes, statement(9:last - 1), unit, line, 0)
   end subroutine take_include

   !> The routine of a CALL, alone or behind IF.
   pure subroutine take_call(statement, unit, line, calls)
      character(len=*), intent(in) :: statement, unit
      integer, intent(in) :: line
      type(source_mention), allocatable, intent(inout) :: calls(:)
      integer :: finish, start

      start = 1
      if (len(statement) > 3) then
         if (statement(:3) == 'if(') start = closing(statement) + 1
      end if
      if (len(statement) < start + 4) return
      if (statement(start:start + 3) /= 'call') return
      start = start + 4
      finish = start - 1 + identifier_end(statement(start:))
      if (scan(statement(start:start), '0123456789_$') > 0 .or. finish < start) return
      ! an assignment to what is called so, or a procedure of a type
      if (finish < len(statement)) then
         if (statement(finish + 1:finish + 1) /= '(' .or. &
            statement(len(statement):) /= ')') return
      end if
      if (any(calls%name == statement(start:finish))) return
      call add(calls, statement(start:finish), unit, line, 0)
   end subroutine take_call

   !> Place of the parenthesis that closes the first one.
   pure integer function closing(statement)
      character(len=*), intent(in) :: statement
      integer :: depth
      logical :: quoted

      depth = 0
      quoted = .false.
      do closing = 1, len(statement) - 1
         if (scan(statement(closing:closing), '"'//'''') > 0) quoted = .not. quoted
         if (quoted) cycle
         if (statement(closing:closing) == '(') depth = depth + 1
         if (statement(closing:closing) == ')') depth = depth - 1
         if (statement(closing:closing) == ')' .and. depth == 0) return
      end do
   end function closing

   pure subroutine add(list, name, unit, line, members)
      type(source_mention), allocatable, intent(inout) :: list(:)
      character(len=*), intent(in) :: name, unit
      integer, intent(in) :: line, members
      type(source_mention) :: mention

      mention%name = name
      mention%unit = unit
      mention%line = line
      mention%members = members
      list = [list, mention]
   end subroutine add

end module asperity_check_source_scan
