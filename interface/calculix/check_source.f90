!> What build needs to know of a Fortran file with a UINTER: its form, and whether its arguments are
!> ABAQUS'.
!>
!> usage: check_source FILE COMPILER FOLDER
!>
!> Prints the compiler's options for the form of the file, and notices on standard error; writes
!> what user subroutines include, ABA_PARAM.INC, into FOLDER. Exit status 1, and what is wrong on
!> standard error, for a file whose UINTER ABAQUS would call otherwise.
program check_source
   use, intrinsic :: iso_fortran_env, only: error_unit
   use asperity_base_error, only: error_type
   use asperity_base_letter_case, only: lower_case
   use asperity_check_argument_lists, only: check_argument_list
   use asperity_check_argument_types, only: caller_of, check_argument_types, type_options
   use asperity_check_finding, only: finding_list, severity_error
   use asperity_check_source_form, only: gfortran_options
   use asperity_check_source_includes, only: double_kind, include_names, include_text
   use asperity_check_source_scan, only: scan_source, source_scan
   use asperity_check_source_text, only: read_source, read_text, source_text
   use asperity_check_source_units, only: source_routine
   use asperity_check_source_user_routine, only: find_user_routine
   implicit none
   character(len=*), parameter :: name = 'uinter', include_name = trim(include_names(1))
   type(source_text) :: source
   type(source_scan) :: found
   type(source_routine) :: routine
   type(finding_list) :: findings
   type(error_type), allocatable :: error
   character(len=:), allocatable :: compiler, file, folder, options, place

   file = argument(1)
   compiler = argument(2)
   folder = argument(3)
   call write_text(folder//'/'//include_name, include_text(include_name, double_kind))
   call write_text(folder//'/'//lower_case(include_name), include_text(include_name, double_kind))
   call read_source(file, source, error)
   if (allocated(error)) call refuse(error%message)
   call scan_source(source%text, source%form, found)
   call find_user_routine(source, found, name, routine, error)
   if (allocated(error)) call refuse(error%message)
   place = source%place(routine%line)
   options = trim(gfortran_options(source%form, source%text))
   call check_argument_list(name, routine%arguments, place, findings)
   if (.not. has_errors()) call ask_for_types()
   call tell()
   write (*, '(a)') options

contains

   !> An argument of the command.
   function argument(i) result(text)
      integer, intent(in) :: i
      character(len=:), allocatable :: text
      integer :: length

      call get_command_argument(i, length=length)
      allocate (character(len=length) :: text)
      call get_command_argument(i, text)
   end function argument

   !> Let the compiler look at the file alone and with a caller behind it.
   subroutine ask_for_types()
      character(len=:), allocatable :: alone, called, caller

      call said_of(source%text, alone)
      call caller_of(name, source%form, double_kind, caller)
      call said_of(source%text//caller, called)
      call check_argument_types(name, alone, called, place, findings)
   end subroutine ask_for_types

   !> What the compiler says of a text. That it does not compile is told later, when it shall.
   subroutine said_of(text, said)
      character(len=*), intent(in) :: text
      character(len=:), allocatable, intent(out) :: said
      integer :: status

      call write_text(folder//'/check.f', text)
      call execute_command_line('LC_ALL=C '//compiler//' '//type_options//' '//options//' -I'// &
         quoted(folder)//' -I'//quoted(file(:scan(file, '/', back=.true.))//'.')//' -J'// &
         quoted(folder)//' '//quoted(folder//'/check.f')//' -o /dev/null 2>'// &
         quoted(folder//'/check.log'), exitstat=status)
      call read_text(folder//'/check.log', said, error)
      if (allocated(error)) call refuse(error%message)
   end subroutine said_of

   !> A word of a command of the shell.
   pure function quoted(text) result(word)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: word
      integer :: i

      word = ''''
      do i = 1, len(text)
         if (text(i:i) == '''') then
            word = word//'''"''"'''
         else
            word = word//text(i:i)
         end if
      end do
      word = word//''''
   end function quoted

   subroutine write_text(path, text)
      character(len=*), intent(in) :: path, text
      character(len=200) :: reason
      integer :: status, unit

      open (newunit=unit, file=path, access='stream', form='unformatted', status='replace', &
         action='write', iostat=status, iomsg=reason)
      if (status == 0) write (unit, iostat=status, iomsg=reason) text
      if (status /= 0) call refuse('cannot write '//path//': '//trim(reason))
      close (unit)
   end subroutine write_text

   logical function has_errors()
      has_errors = .false.
      if (findings%n > 0) has_errors = any(findings%items(:findings%n)%severity == severity_error)
   end function has_errors

   !> Tell what was found; errors end it.
   subroutine tell()
      character(len=:), allocatable :: said
      integer :: i

      do i = 1, findings%n
         associate (finding => findings%items(i))
            said = finding%place//': '//finding%found//'; ABAQUS has '//finding%expected
            if (finding%severity == severity_error) call refuse(said//'. '//finding%effect)
            write (error_unit, '(a)') said
         end associate
      end do
   end subroutine tell

   subroutine refuse(reason)
      character(len=*), intent(in) :: reason

      write (error_unit, '(a)') reason
      stop 1, quiet=.true.
   end subroutine refuse

end program check_source
