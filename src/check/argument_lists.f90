!> The argument lists of UINTER and VUINTER, and how another list differs.
module asperity_check_argument_lists
   use asperity_base_letter_case, only: upper_case
   use asperity_base_number_text, only: to_text
   use asperity_check_finding, only: finding_list, rule_argument_list, severity_error, &
      severity_note
   implicit none
   private
   public :: argument_list, argument_type, check_argument_list

   integer, parameter :: longest = 11
   !> UINTER's, release 6.12 to 2025, as the vendor's manual names them
   character(len=*), parameter :: uinter_list(47) = [character(len=longest) :: &
      'stress', 'ddsddr', 'dviscous', 'dstructural', 'flux', 'ddfddt', 'ddsddt', 'ddfddr', &
      'statev', 'sed', 'sfd', 'spd', 'svd', 'scd', 'pnewdt', 'rdisp', 'drdisp', 'temp', 'dtemp', &
      'predef', 'dpred', 'time', 'dtime', 'freqr', 'ciname', 'slname', 'msname', 'props', &
      'coords', 'alocaldir', 'drot', 'area', 'chrlngth', 'node', 'ndir', 'nstatv', 'npred', &
      'nprops', 'mcrd', 'kstep', 'kinc', 'kit', 'linper', 'lopenclose', 'lstate', 'lsdi', &
      'lprint']
   !> VUINTER's
   character(len=*), parameter :: vuinter_list(49) = [character(len=longest) :: &
      'sfd', 'scd', 'spd', 'svd', 'stress', 'fluxslv', 'fluxmst', 'sed', 'statev', 'kstep', &
      'kinc', 'nfacnod', 'nslvnod', 'nmstnod', 'nsurfdir', 'ndir', 'nstatevar', 'nprops', &
      'ntemp', 'npred', 'numdeftfv', 'jslvuid', 'jmstuid', 'jconmstid', 'timstep', 'timglb', &
      'dtimcur', 'surfint', 'surfslv', 'surfmst', 'rdisp', 'drdisp', 'drot', 'stiffdflt', &
      'conddflt', 'shape', 'coordslv', 'coordmst', 'alocaldir', 'props', 'areaslv', 'tempslv', &
      'dtempslv', 'predefslv', 'dpredefslv', 'tempmst', 'dtempmst', 'predefmst', 'dpredefmst']
   !> Names that other releases have, and those of the lists above. VUINTER's change by a rule: see
   !> `listed_names`
   character(len=*), parameter :: other_names(2, 4) = reshape([character(len=longest) :: &
      'amki', 'dviscous', 'amski', 'dstructural', 'secname', 'slname', 'mainname', 'msname'], &
      [2, 4])
   !> Arguments that UINTER did not have up to release 6.6
   character(len=*), parameter :: later_arguments(3) = [character(len=longest) :: 'dviscous', &
      'dstructural', 'freqr']
   !> Arguments that are texts; all others are numbers, whole by the letter they begin with
   character(len=*), parameter :: texts(6) = [character(len=longest) :: 'ciname', 'slname', &
      'msname', 'surfint', 'surfslv', 'surfmst']
   !> Most names in one finding
   integer, parameter :: most_named = 5

contains

   !> The arguments of `uinter` or `vuinter` in their order.
   pure subroutine argument_list(routine, names)
      !> Name of the routine in lower case
      character(len=*), intent(in) :: routine
      !> In lower case
      character(len=longest), allocatable, intent(out) :: names(:)

      if (routine == 'vuinter') then
         names = vuinter_list
      else
         names = uinter_list
      end if
   end subroutine argument_list

   !> What an argument of these lists is: `character`, `integer` or `real`.
   pure function argument_type(name) result(type_name)
      !> In lower case
      character(len=*), intent(in) :: name
      character(len=9) :: type_name

      if (any(texts == name)) then
         type_name = 'character'
      else if (scan(name(1:1), 'ijklmn') > 0) then
         type_name = 'integer'
      else
         type_name = 'real'
      end if
   end function argument_type

   !> Compare a list of arguments with that which ABAQUS calls the routine by.
   pure subroutine check_argument_list(routine, found, place, findings)
      !> Name of the routine in lower case
      character(len=*), intent(in) :: routine
      !> Names of the arguments in lower case
      character(len=*), intent(in) :: found(:)
      !> Where its head stands: `line 12`
      character(len=*), intent(in) :: place
      !> Differences are added: an error for another number or order, a note on unknown names
      type(finding_list), intent(inout) :: findings
      character(len=longest), allocatable :: right(:)
      character(len=max(len(found), longest)) :: names(size(found))
      character(len=*), parameter :: effect = 'ABAQUS passes arguments by their places: the &
         &routine takes one for another, and answers with nonsense or nothing'
      integer :: i, n
      logical :: differs(size(found))

      call argument_list(routine, right)
      names = listed_names(found)
      n = min(size(names), size(right))
      differs = .true.
      differs(:n) = names(:n) /= right(:n)
      if (size(names) /= size(right)) then
         i = min(findloc(differs, .true., dim=1), n + 1)
         ! all are right, and some are missing
         if (i == 0) i = n + 1
         call findings%add(rule_argument_list, severity_error, &
            'argument '//to_text(i)//', '//place, argument_at(right, i)//' of '// &
            to_text(size(right))//' arguments', &
            argument_at(found, i)//' of '//to_text(size(found))//' arguments'// &
            origin(names), effect)
         return
      end if
      do i = 1, n
         if (.not. (differs(i) .and. any(right == names(i)))) cycle
         call findings%add(rule_argument_list, severity_error, &
            'argument '//to_text(i)//', '//place, argument_at(right, i), &
            argument_at(found, i)//', which is argument '// &
            to_text(findloc(right, names(i), dim=1))//' of ABAQUS', effect)
         return
      end do
      if (any(differs)) call findings%add(rule_argument_list, severity_note, &
         'names of arguments, '//place, listed(pack(right, differs)), &
         listed(pack(found, differs)), &
         'none: ABAQUS passes arguments by their places, whatever their names are')
   end subroutine check_argument_list

   !> The names by which the lists above have these arguments.
   pure function listed_names(names) result(known)
      character(len=*), intent(in) :: names(:)
      character(len=max(len(names), longest)) :: known(size(names))
      integer :: at, i

      known = names
      do i = 1, size(names)
         at = findloc(other_names(1, :), names(i), dim=1)
         if (at > 0) known(i) = other_names(2, at)
         ! what was slave and master is secondary and main in newer releases
         at = index(names(i), 'sec')
         if (at > 0) known(i) = if_known(names(i)(:at - 1)//'slv'//names(i)(at + 3:), known(i))
         at = index(names(i), 'main')
         if (at > 0) known(i) = if_known(names(i)(:at - 1)//'mst'//names(i)(at + 4:), known(i))
      end do
   end function listed_names

   !> A name if VUINTER has it, else another one.
   pure function if_known(name, other) result(known)
      character(len=*), intent(in) :: name, other
      character(len=len(other)) :: known

      known = other
      if (any(vuinter_list == name)) known = name
   end function if_known

   !> In words, which list of another number of arguments it is, if that is known.
   pure function origin(names) result(words)
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: words
      integer :: i

      words = ''
      if (same(names, pack(uinter_list, [(all(later_arguments /= uinter_list(i)), &
         i=1, size(uinter_list))]))) then
         words = ', the list of UINTER in releases up to 6.6, without '//listed(later_arguments)
      else if (same(names, uinter_list)) then
         words = ', the list of UINTER'
      else if (same(names, vuinter_list)) then
         words = ', the list of VUINTER'
      end if
   end function origin

   pure logical function same(a, b)
      character(len=*), intent(in) :: a(:), b(:)

      same = size(a) == size(b)
      if (same) same = all(a == b)
   end function same

   !> An argument of a list by its place.
   pure function argument_at(list, i) result(words)
      character(len=*), intent(in) :: list(:)
      integer, intent(in) :: i
      character(len=:), allocatable :: words

      words = 'none'
      if (i <= size(list)) words = trim(upper_case(list(i)))
   end function argument_at

   !> Names in upper case with commas between.
   pure function listed(names) result(words)
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: words
      integer :: i

      words = trim(upper_case(names(1)))
      do i = 2, min(size(names), most_named)
         words = words//', '//trim(upper_case(names(i)))
      end do
      if (size(names) > most_named) words = words//' and '//to_text(size(names) - most_named)// &
         ' more'
   end function listed

end module asperity_check_argument_lists
