!> Argument lists: ours are those of the signatures that hosts call by; how others differ.
module test_check_argument_lists
   use asperity_base_error, only: error_type
   use asperity_check_argument_lists, only: argument_list, argument_type, check_argument_list
   use asperity_check_finding, only: finding_list, rule_argument_list, severity_error, &
      severity_note
   use asperity_check_source_heads, only: name_length, read_head
   use asperity_check_source_scan, only: scan_source, source_scan
   use asperity_check_source_statements, only: next_statement, statement_reader
   use asperity_check_source_text, only: read_source, source_text
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use uinter_sources, only: in_lower_case, manual, swapped
   implicit none
   private
   public :: suite_argument_lists

contains

   function suite_argument_lists() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('argument lists')
      call suite%addTest(TestMethod('those of the signatures, with their types', test_signatures))
      call suite%addTest(TestMethod('names of all releases', test_right))
      call suite%addTest(TestMethod('other numbers of arguments', test_numbers))
      call suite%addTest(TestMethod('another order', test_order))
      call suite%addTest(TestMethod('unknown names', test_names))
      call suite%addTest(TestMethod('files of the tests', test_files))
   end function suite_argument_lists

   subroutine test_signatures()
      call as_signature('uinter', 47)
      call as_signature('vuinter', 49)
   end subroutine test_signatures

   subroutine test_right()
      type(finding_list) :: findings
      character(len=*), parameter :: newer(49) = [character(len=10) :: 'sfd', 'scd', 'spd', 'svd', &
         'stress', 'fluxSec', 'fluxMain', 'sed', 'statev', 'kStep', 'kInc', 'nFacNod', 'nSecNod', &
         'nMainNod', 'nSurfDir', 'nDir', 'nStateVar', 'nProps', 'nTemp', 'nPred', 'numDefTfv', &
         'jSecUid', 'jMainUid', 'jConMainid', 'timStep', 'timGlb', 'dTimCur', 'surfInt', &
         'surfSec', &
         'surfMain', 'rdisp', 'drdisp', 'drot', 'stiffDflt', 'condDflt', 'shape', 'coordSec', &
         'coordMain', 'alocaldir', 'props', 'areaSec', 'tempSec', 'dtempSec', 'preDefSec', &
         'dpreDefSec', 'tempMain', 'dtempMain', 'preDefMain', 'dpreDefMai']
      character(len=12) :: names(49)

      call check_argument_list('uinter', in_lower_case(manual), 'line 1', findings)
      call check_argument_list('uinter', in_lower_case(renamed()), 'line 1', findings)
      names = in_lower_case(newer)
      names(49) = 'dpredefmain'
      call check_argument_list('vuinter', names, 'line 1', findings)
      call assertEqual(0, findings%n)
   end subroutine test_right

   subroutine test_numbers()
      character(len=name_length), allocatable :: names(:)
      character(len=10) :: longer(48)

      call gives(manual(:46), severity_error, 'argument 47, line 7', 'LPRINT of 47 arguments', &
         'none of 46 arguments')
      longer(:47) = manual
      longer(48) = 'MORE'
      call gives(longer, severity_error, 'argument 48, line 7', 'none of 47 arguments', &
         'MORE of 48 arguments')
      call gives(manual(:0), severity_error, 'argument 1, line 7', 'STRESS of 47 arguments', &
         'none of 0 arguments')
      call gives(pack(manual, manual /= 'AMKI' .and. manual /= 'AMSKI' .and. manual /= 'FREQR'), &
         severity_error, 'argument 3, line 7', 'DVISCOUS of 47 arguments', &
         'FLUX of 44 arguments, '// &
         'the list of UINTER in releases up to 6.6, without DVISCOUS, DSTRUCTURAL, FREQR')
      call gives(manual(2:), severity_error, 'argument 1, line 7', 'STRESS of 47 arguments', &
         'DDSDDR of 46 arguments')
      names = signature('vuinter')
      call gives(names, severity_error, 'argument 1, line 7', 'STRESS of 47 arguments', &
         'SFD of 49 arguments, the list of VUINTER')
      call gives(manual, severity_error, 'argument 1, line 7', 'SFD of 49 arguments', &
         'STRESS of 47 arguments, the list of UINTER', 'vuinter')
   end subroutine test_numbers

   subroutine test_order()
      call gives(swapped('RDISP', 'DRDISP'), severity_error, 'argument 16, line 7', 'RDISP', &
         'DRDISP, which is argument 17 of ABAQUS')
      call gives(swapped('AMKI', 'AMSKI'), severity_error, 'argument 3, line 7', 'DVISCOUS', &
         'AMSKI, which is argument 4 of ABAQUS')
   end subroutine test_order

   subroutine test_names()
      character(len=10) :: names(47)

      names = manual
      where (names == 'FREQR') names = 'FRQ'
      call gives(names, severity_note, 'names of arguments, line 7', 'FREQR', 'FRQ')
      names(40:) = ['A', 'B', 'C', 'D', 'E', 'F', 'G', 'H']
      call gives(names, severity_note, 'names of arguments, line 7', &
         'FREQR, KSTEP, KINC, KIT, LINPER and 4 more', 'FRQ, A, B, C, D and 4 more')
   end subroutine test_names

   !> Files whose list another one's author took for ABAQUS'.
   subroutine test_files()
      type(finding_list) :: findings

      call check_file('args28.for', findings)
      call assertEqual(1, findings%n)
      call assertEqual('argument 1, line 2', findings%items(1)%place)
      call assertEqual('S of 28 arguments', findings%items(1)%found)
      call check_file('args44.for', findings)
      call assertEqual(2, findings%n)
      call assertEqual('argument 3, line 1', findings%items(2)%place)
      call check_file('freeform.for', findings)
      call check_file('uexternaldb.for', findings)
      call assertEqual(2, findings%n)
   end subroutine test_files

   subroutine check_file(name, findings)
      character(len=*), intent(in) :: name
      type(finding_list), intent(inout) :: findings
      type(source_text) :: source
      type(source_scan) :: found
      type(error_type), allocatable :: error

      call read_source('test/data/uinter/'//name, source, error)
      call assertFalse(allocated(error), name)
      call scan_source(source%text, source%form, found)
      call assertEqual('uinter', found%routines(1)%name, name)
      call check_argument_list('uinter', found%routines(1)%arguments, &
         source%place(found%routines(1)%line), findings)
   end subroutine check_file

   !> A list, as users write it, at line 7 gives one finding.
   subroutine gives(names, severity, place, expected, found, routine)
      character(len=*), intent(in) :: names(:)
      integer, intent(in) :: severity
      character(len=*), intent(in) :: place, expected, found
      character(len=*), intent(in), optional :: routine
      type(finding_list) :: findings

      if (present(routine)) then
         call check_argument_list(routine, in_lower_case(names), 'line 7', findings)
      else
         call check_argument_list('uinter', in_lower_case(names), 'line 7', findings)
      end if
      call assertEqual(1, findings%n, found)
      if (findings%n /= 1) return
      call assertEqual(rule_argument_list, findings%items(1)%rule, found)
      call assertEqual(severity, findings%items(1)%severity, found)
      call assertEqual(place, findings%items(1)%place)
      call assertEqual(expected, findings%items(1)%expected)
      call assertEqual(found, findings%items(1)%found)
   end subroutine gives

   !> The manual's list by the names of newer releases.
   function renamed() result(names)
      character(len=11) :: names(size(manual))

      names = manual
      where (names == 'SLNAME') names = 'SECNAME'
      where (names == 'MSNAME') names = 'MAINNAME'
      where (names == 'AMKI') names = 'DVISCOUS'
      where (names == 'AMSKI') names = 'DSTRUCTURAL'
   end function renamed

   !> The arguments that the signature of a routine has in its file.
   function signature(routine) result(names)
      character(len=*), intent(in) :: routine
      character(len=name_length), allocatable :: names(:)
      character(len=:), allocatable :: arguments
      type(source_text) :: source
      type(error_type), allocatable :: error
      type(statement_reader) :: reader
      character(len=:), allocatable :: statement
      character(len=name_length) :: name
      integer :: at, line
      logical :: bound, found, is_head

      allocate (names(0))
      call read_source('interface/abaqus/routines/'//routine//'_signature.f90', source, error)
      call assertFalse(allocated(error), routine)
      do
         call next_statement(source%text, source%form, reader, statement, line, found)
         if (.not. found) return
         call read_head(statement, 'subroutine', name, arguments, bound, is_head)
         if (is_head) exit
      end do
      do while (arguments /= '')
         at = index(arguments//',', ',')
         name = arguments(:at - 1)
         names = [character(len=name_length) :: names, name]
         arguments = arguments(min(at, len(arguments)) + 1:)
      end do
   end function signature

   !> Our list is that of the signature, and so are the types that it declares.
   subroutine as_signature(routine, n)
      character(len=*), intent(in) :: routine
      integer, intent(in) :: n
      type(source_text) :: source
      type(error_type), allocatable :: error
      type(statement_reader) :: reader
      character(len=:), allocatable :: statement
      character(len=11), allocatable :: names(:)
      character(len=9) :: declared
      integer :: i, line, seen
      logical :: found

      call argument_list(routine, names)
      call assertEqual(n, size(names), routine)
      call assertTrue(all(names == signature(routine)), routine)
      seen = 0
      call read_source('interface/abaqus/routines/'//routine//'_signature.f90', source, error)
      do
         call next_statement(source%text, source%form, reader, statement, line, found)
         if (.not. found) exit
         if (index(statement, '::') == 0 .or. index(statement, 'intent(') == 0) cycle
         declared = statement(:scan(statement, '(,') - 1)
         statement = ','//statement(index(statement, '::') + 2:)//','
         do i = 1, size(names)
            if (index(statement, ','//trim(names(i))//',') == 0 .and. &
               index(statement, ','//trim(names(i))//'(') == 0) cycle
            ! a dimension, as in stress(ndir,nslvnod)
            if (index(statement, '('//trim(names(i))//',') > 0 .and. &
               index(statement, ','//trim(names(i))//'(') == 0) cycle
            call assertEqual(declared, argument_type(names(i)), trim(names(i)))
            seen = seen + 1
         end do
      end do
      call assertTrue(seen >= n, routine//': all are declared')
   end subroutine as_signature

end module test_check_argument_lists
