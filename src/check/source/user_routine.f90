!> The routine that ABAQUS would call, found in a source of the user's.
module asperity_check_source_user_routine
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_letter_case, only: upper_case
   use asperity_base_number_text, only: to_text
   use asperity_check_source_scan, only: has_external, scan_source, source_scan
   use asperity_check_source_text, only: source_text
   use asperity_check_source_units, only: source_routine
   implicit none
   private
   public :: find_user_routine

contains

   !> Find the one external subroutine of a name.
   pure subroutine find_user_routine(source, found, name, routine, error)
      !> The source
      type(source_text), intent(in) :: source
      !> What it has
      type(source_scan), intent(in) :: found
      !> Name of the routine in lower case: `uinter` or `vuinter`
      character(len=*), intent(in) :: name
      !> The routine
      type(source_routine), intent(out) :: routine
      !> Set when there is not exactly one, in words of what there is
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: places(:)
      integer :: i

      places = pack([(i, i=1, size(found%routines))], found%routines%name == name .and. &
         found%routines%role == 'external')
      if (size(places) == 1) then
         routine = found%routines(places(1))
      else if (size(places) > 1) then
         call fatal_error(error, source%path//' has '//to_text(size(places))//' subroutines '// &
            upper_case(name)//', at '//source%place(found%routines(places(1))%line)//' and at '// &
            source%place(found%routines(places(2))%line)//'; leave the one that ABAQUS shall call')
      else
         call explain_absence(source, found, name, error)
      end if
   end subroutine find_user_routine

   !> Why there is none.
   pure subroutine explain_absence(source, found, name, error)
      type(source_text), intent(in) :: source
      type(source_scan), intent(in) :: found
      character(len=*), intent(in) :: name
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: message
      integer :: i

      do i = 1, size(found%routines)
         if (found%routines(i)%name /= name) cycle
         call fatal_error(error, upper_case(name)//' at '//source%place(found%routines(i)%line)// &
            ' of '//source%path//in_words(found%routines(i)%role, trim(found%routines(i)%host))// &
            '; ABAQUS calls an external subroutine')
         return
      end do
      message = source%path//' has no subroutine '//upper_case(name)
      if (name == 'uinter' .and. has_external(found, 'vuinter')) then
         message = message//' but VUINTER, which ABAQUS/Explicit calls'
      else if (name == 'vuinter' .and. has_external(found, 'uinter')) then
         message = message//' but UINTER, which ABAQUS/Standard calls'
      else
         message = message//hint(source, name)
      end if
      if (size(found%includes) > 0 .and. size(found%routines) == 0) message = message// &
         '; it includes '//trim(found%includes(1)%name)//', which does not stand beside it'
      call fatal_error(error, message)
   end subroutine explain_absence

   !> What the routine is instead of external.
   pure function in_words(role, host) result(words)
      character(len=*), intent(in) :: role, host
      character(len=:), allocatable :: words

      select case (role)
      case ('module')
         words = ' is a procedure of module '//upper_case(host)
      case ('internal')
         words = ' is inside '//upper_case(host)
      case ('entry')
         words = ' is an ENTRY of '//upper_case(host)
      case default
         words = ' has BIND(C), so that its name for the linker is another'
      end select
   end function in_words

   !> Whether the source has the routine when it is read in the other form.
   pure function hint(source, name) result(words)
      type(source_text), intent(in) :: source
      character(len=*), intent(in) :: name
      character(len=:), allocatable :: words
      character(len=5) :: other
      type(source_scan) :: found

      words = ''
      other = 'free'
      if (source%form == 'free') other = 'fixed'
      call scan_source(source%text, other, found)
      if (has_external(found, name)) words = ' in '//trim(source%form)//' form, but in '// &
         trim(other)//' form: begin the file with !DIR$ '//trim(upper_case(merge('freeform  ', &
         'nofreeform', other == 'free')))
   end function hint

end module asperity_check_source_user_routine
