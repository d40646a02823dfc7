!> A Fortran source of the user's as a compiler reads it: with the files that it includes in their
!> places.
module asperity_check_source_text
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_letter_case, only: lower_case, upper_case
   use asperity_base_number_text, only: to_text
   use asperity_check_source_form, only: form_of
   use asperity_check_source_scan, only: scan_source, source_scan
   use asperity_check_source_statements, only: newline
   implicit none
   private
   public :: read_source, read_text, source_text

   !> Most characters of a file
   integer, parameter :: most_characters = 50000000
   character(len=*), parameter :: utf8_mark = char(239)//char(187)//char(191)
   !> How deep files may include files
   integer, parameter :: most_levels = 20

   !> A source.
   type :: source_text
      !> Path of the file
      character(len=:), allocatable :: path
      !> Its form, `fixed` or `free`
      character(len=5) :: form = ''
      !> The file and those that it includes
      character(len=:), allocatable :: text
      !> Of each line of the text: which file it is of, the user's own first, and its line there
      integer, allocatable :: file(:), line(:)
      !> Names of the files
      character(len=255), allocatable :: files(:)
   contains
      !> Where a line stands, in words
      procedure :: place
   end type source_text

contains

   !> Read a source and what it includes, as far as it stands beside it.
   subroutine read_source(path, source, error)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> What was read
      type(source_text), intent(out) :: source
      !> Set when there is no such source: it cannot be read, has no known form, is no text
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text

      source%path = path
      source%text = ''
      allocate (source%file(0), source%line(0), source%files(0))
      call read_text(path, text, error)
      if (allocated(error)) return
      call form_of(path, text, source%form, error)
      if (allocated(error)) return
      call insert(source, path, text, 1, error)
   end subroutine read_source

   !> Append a file, and in the places of its INCLUDE lines what they include.
   recursive subroutine insert(source, name, text, level, error)
      type(source_text), intent(inout) :: source
      character(len=*), intent(in) :: name, text
      integer, intent(in) :: level
      type(error_type), allocatable, intent(inout) :: error
      character(len=:), allocatable :: inner, path
      type(source_scan) :: found
      integer :: at, i, length, number, start

      if (level > most_levels) then
         call fatal_error(error, source%path//' includes files that include each other '// &
            'without end, '//name//' among them')
         return
      end if
      source%files = [character(len=255) :: source%files, name]
      number = size(source%files)
      call scan_source(text, source%form, found)
      start = 1
      at = 1
      do i = 1, size(found%includes)
         path = beside(source%path, trim(found%includes(i)%name))
         if (path == '') cycle
         call append(source, text, number, found%includes(i)%line, at, start)
         call read_text(path, inner, error)
         if (.not. allocated(error)) &
            call insert(source, trim(found%includes(i)%name), inner, level + 1, error)
         if (allocated(error)) return
         ! the line itself
         length = index(text(start:), newline)
         if (length == 0) length = len(text) - start + 1
         start = start + length
         at = at + 1
      end do
      call append(source, text, number, huge(at), at, start)
   end subroutine insert

   !> Append lines `at` to before `next` of a file, which begin at `start`; both are moved on.
   subroutine append(source, text, number, next, at, start)
      type(source_text), intent(inout) :: source
      character(len=*), intent(in) :: text
      integer, intent(in) :: number, next
      integer, intent(inout) :: at, start
      integer :: finish, from, i, length

      from = at
      finish = start
      do while (at < next .and. finish <= len(text))
         length = index(text(finish:), newline)
         if (length == 0) length = len(text) - finish + 1
         finish = finish + length
         at = at + 1
      end do
      source%text = source%text//text(start:finish - 1)
      ! the last line may have no end
      if (finish > start) then
         if (text(finish - 1:finish - 1) /= newline) source%text = source%text//newline
      end if
      source%file = [source%file, (number, i=from, at - 1)]
      source%line = [source%line, (i, i=from, at - 1)]
      start = finish
   end subroutine append

   !> Path of an included file, in the folder of the source; empty if it is not there. Where
   !> upper and lower case differ, users of Windows may have written it either way.
   function beside(path, name) result(found)
      character(len=*), intent(in) :: path, name
      character(len=:), allocatable :: found
      logical :: exists
      integer :: i

      do i = 1, 3
         select case (i)
         case (1)
            found = path(:scan(path, '/', back=.true.))//name
         case (2)
            found = path(:scan(path, '/', back=.true.))//lower_case(name)
         case default
            found = path(:scan(path, '/', back=.true.))//upper_case(name)
         end select
         inquire (file=found, exist=exists)
         if (exists) return
      end do
      found = ''
   end function beside

   !> Read a text file as it is, but for the mark of UTF-8 that editors of Windows write first.
   subroutine read_text(path, text, error)
      !> Path of the file
      character(len=*), intent(in) :: path
      !> All of it
      character(len=:), allocatable, intent(out) :: text
      !> Set when it cannot be read, is too large or has zero bytes
      type(error_type), allocatable, intent(out) :: error
      character(len=200) :: reason
      integer :: length, status, unit

      open (newunit=unit, file=path, status='old', action='read', access='stream', &
         form='unformatted', iostat=status, iomsg=reason)
      if (status == 0) then
         inquire (unit=unit, size=length)
         if (length > most_characters) then
            call fatal_error(error, path//' has '//to_text(length)//' characters, a source '// &
               'has at most '//to_text(most_characters))
         else
            allocate (character(len=max(length, 0)) :: text)
            if (length > 0) read (unit, iostat=status, iomsg=reason) text
         end if
         close (unit)
      end if
      if (status /= 0) call fatal_error(error, 'cannot read '//path//': '//trim(reason), file_error)
      if (allocated(error)) return
      if (index(text, utf8_mark) == 1) text = text(len(utf8_mark) + 1:)
      if (index(text, achar(0)) > 0) call fatal_error(error, path//' is no text: it has zero bytes')
   end subroutine read_text

   !> Where a line of the text stands: `line 12`, or `line 3 of body.inc`.
   pure function place(self, line) result(words)
      !> The source
      class(source_text), intent(in) :: self
      !> Line of its text
      integer, intent(in) :: line
      character(len=:), allocatable :: words

      words = 'line '//to_text(self%line(line))
      if (self%file(line) > 1) words = words//' of '//trim(self%files(self%file(line)))
   end function place

end module asperity_check_source_text
