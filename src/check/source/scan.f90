!> What a Fortran source has: subroutines with their arguments, files that it includes.
module asperity_check_source_scan
   use asperity_check_source_statements, only: next_statement, statement_reader
   use asperity_check_source_units, only: program_units, source_routine
   implicit none
   private
   public :: has_external, scan_source, source_scan

   !> A file that a source includes.
   type :: source_include
      !> Its name as written
      character(len=255) :: name = ''
      !> Line of the source
      integer :: line = 0
   end type source_include

   !> What a source has.
   type :: source_scan
      !> Subroutines and entries, those in interfaces left out
      type(source_routine), allocatable :: routines(:)
      !> INCLUDE lines
      type(source_include), allocatable :: includes(:)
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

      allocate (found%includes(0))
      do
         call next_statement(text, form, reader, statement, line, more)
         if (.not. more) exit
         call units%follow(statement, line)
         call take_include(statement, line, found%includes)
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

   !> The file of an INCLUDE line.
   pure subroutine take_include(statement, line, includes)
      character(len=*), intent(in) :: statement
      integer, intent(in) :: line
      type(source_include), allocatable, intent(inout) :: includes(:)
      type(source_include) :: include
      integer :: last

      last = len(statement)
      if (last < 10) return
      if (statement(:7) /= 'include' .or. scan(statement(8:8), '"'//'''') == 0) return
      if (statement(8:8) /= statement(last:last)) return
      include%name = statement(9:last - 1)
      include%line = line
      includes = [includes, include]
   end subroutine take_include

end module asperity_check_source_scan
