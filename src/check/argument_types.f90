!> Types of the arguments of a user routine: gfortran is asked by a caller that is appended to the
!> user's source. What it says of arguments that the routine does not use does not count.
module asperity_check_argument_types
   use asperity_base_letter_case, only: upper_case
   use asperity_base_number_text, only: to_text
   use asperity_check_argument_lists, only: argument_list, argument_type
   use asperity_check_finding, only: finding_list, rule_argument_list, severity_error
   use asperity_check_source_includes, only: include_names
   use asperity_check_source_statements, only: newline
   implicit none
   private
   public :: caller_of, check_argument_types

   !> Options of gfortran, whose messages must be those of LC_ALL=C, for both sources:
   !> that of the user, and the same with the caller behind it
   character(len=*), parameter, public :: type_options = &
      '-S -std=legacy -Wunused-dummy-argument -fmax-errors=0'
   !> What gfortran says of arguments
   character(len=*), parameter :: mismatch = 'Type mismatch in argument ', &
      unused = 'Unused dummy argument '
   !> Most arguments in one finding
   integer, parameter :: most_named = 3

contains

   !> A subroutine that calls the routine with arguments of the right types. It passes elements of
   !> arrays, which are right for a scalar and for an array.
   pure subroutine caller_of(routine, form, real_kind, text)
      !> `uinter` or `vuinter`
      character(len=*), intent(in) :: routine
      !> `fixed` or `free`
      character(len=*), intent(in) :: form
      !> Kind of its reals: `double_kind` or `single_kind` of asperity_check_source_includes
      character(len=*), intent(in) :: real_kind
      !> To be appended to a source
      character(len=:), allocatable, intent(out) :: text
      character(len=11), allocatable :: names(:)
      character(len=1) :: more
      integer :: i

      call argument_list(routine, names)
      ! in free form a line that goes on says so; in fixed form the one that follows
      more = ' '
      if (form == 'free') more = '&'
      text = newline//'      subroutine calls_'//routine//'()'//newline
      do i = 1, size(names)
         select case (argument_type(names(i)))
         case ('character')
            text = text//'      character(len=80) '//trim(names(i))//newline
         case ('integer')
            text = text//'      integer '//trim(names(i))//'(1)'//newline
         case default
            text = text//'      '//real_kind//' '//trim(names(i))//'(1)'//newline
         end select
      end do
      text = text//'      call '//routine//'( '//more//newline
      do i = 1, size(names)
         text = text//'     & '//trim(names(i))
         if (argument_type(names(i)) /= 'character') text = text//'(1)'
         if (i < size(names)) text = text//', '//more//newline
      end do
      text = text//')'//newline//'      end'//newline
   end subroutine caller_of

   !> Find arguments of other types than ABAQUS'.
   pure subroutine check_argument_types(routine, alone, called, place, findings)
      !> Name of the routine in lower case
      character(len=*), intent(in) :: routine
      !> What gfortran says of the source alone, and with the caller behind it
      character(len=*), intent(in) :: alone, called
      !> Where the head of the routine stands: `line 12`
      character(len=*), intent(in) :: place
      !> Arguments of other types are added
      type(finding_list), intent(inout) :: findings
      character(len=:), allocatable :: expected, found, has, name, passed, remedy
      integer :: at, n, next

      expected = ''
      found = ''
      n = 0
      next = 1
      do
         at = index(called(next:), mismatch)
         if (at == 0) exit
         next = next - 1 + at + len(mismatch)
         call read_mismatch(called(next:), name, passed, has)
         ! an argument that is neither declared nor used; a call in the source itself
         if (has == '' .or. has == 'UNKNOWN' .or. index(alone, unused//name) > 0 .or. &
            index(alone, mismatch//name) > 0) cycle
         n = n + 1
         if (n > most_named) cycle
         if (n > 1) expected = expected//', '
         if (n > 1) found = found//', '
         expected = expected//upper_case(name(2:len(name) - 1))//' '//passed
         found = found//upper_case(name(2:len(name) - 1))//' '//has
      end do
      if (n == 0) return
      if (n > most_named) found = found//' and '//to_text(n - most_named)//' more'
      if (routine == 'vuinter') then
         remedy = 'Is INCLUDE '''//trim(include_names(2))//''' missing, or the precision another?'
      else
         remedy = 'Is INCLUDE '''//trim(include_names(1))//''' missing?'
      end if
      call findings%add(rule_argument_list, severity_error, 'types of arguments, '//place, &
         expected, found, 'ABAQUS passes numbers that '//upper_case(routine)// &
         ' takes for others. '//remedy)
   end subroutine check_argument_types

   !> Read `'name' at (1); passed REAL(8) to REAL(4)`; what is not so leaves `found` empty.
   pure subroutine read_mismatch(text, name, passed, found)
      character(len=*), intent(in) :: text
      !> The name in its quotes
      character(len=:), allocatable, intent(out) :: name
      character(len=:), allocatable, intent(out) :: passed, found
      character(len=*), parameter :: before = 'passed ', between = ' to '
      character(len=:), allocatable :: line
      integer :: at

      name = ''
      passed = ''
      found = ''
      line = text(:scan(text//newline, newline) - 1)
      at = index(line(2:), '''') + 1
      if (line(:min(1, len(line))) /= '''' .or. at == 1) return
      name = line(:at)
      at = index(line, before)
      if (at == 0) return
      line = line(at + len(before):)
      at = index(line, between)
      if (at == 0) return
      passed = line(:at - 1)
      found = line(at + len(between):)
   end subroutine read_mismatch

end module asperity_check_argument_types
