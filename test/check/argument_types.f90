!> Types of arguments by what gfortran says.
module test_check_argument_types
   use asperity_check_argument_lists, only: argument_list
   use asperity_check_argument_types, only: caller_of, check_argument_types
   use asperity_check_finding, only: finding_list, rule_argument_list, severity_error
   use asperity_check_source_includes, only: double_kind, include_names, include_text, single_kind
   use asperity_check_source_scan, only: scan_source, source_scan
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use uinter_sources, only: newline
   implicit none
   private
   public :: suite_argument_types

contains

   function suite_argument_types() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('types of arguments')
      call suite%addTest(TestMethod('what gfortran says', test_messages))
      call suite%addTest(TestMethod('the caller', test_caller))
      call suite%addTest(TestMethod('what user subroutines include', test_include))
   end function suite_argument_types

   subroutine test_messages()
      type(finding_list) :: findings
      character(len=*), parameter :: alone = &
         'a.f:3:9:'//newline//'Warning: Unused dummy argument ''flux'' at (1)'//newline// &
         'Warning: Type mismatch in argument ''lsdi'' at (1); passed REAL(8) to INTEGER(4)'

      call check_argument_types('uinter', alone, 'no messages', 'line 2', findings)
      call check_argument_types('uinter', alone, alone//newline//warning('flux', 'REAL(4)')// &
         warning('xit', 'UNKNOWN'), 'line 2', findings)
      call assertEqual(0, findings%n)
      call check_argument_types('uinter', alone, alone//newline//warning('flux', 'REAL(4)')// &
         warning('area', 'INTEGER(4)')//warning('stress', 'REAL(4)'), 'line 2', findings)
      call assertEqual(1, findings%n)
      call assertEqual(rule_argument_list, findings%items(1)%rule)
      call assertEqual(severity_error, findings%items(1)%severity)
      call assertEqual('types of arguments, line 2', findings%items(1)%place)
      call assertEqual('AREA REAL(8), STRESS REAL(8)', findings%items(1)%expected)
      call assertEqual('AREA INTEGER(4), STRESS REAL(4)', findings%items(1)%found)
      call assertTrue(index(findings%items(1)%effect, '''ABA_PARAM.INC''') > 0)
      call check_argument_types('vuinter', '', warning('a', 'REAL(4)')//warning('b', 'REAL(4)')// &
         warning('c', 'REAL(4)')//warning('d', 'REAL(4)')//warning('e', 'REAL(4)'), 'line 3', &
         findings)
      call assertEqual('A REAL(4), B REAL(4), C REAL(4) and 2 more', findings%items(2)%found)
      call assertTrue(index(findings%items(2)%effect, '''VABA_PARAM.INC''') > 0)
   end subroutine test_messages

   !> It calls by the right number of arguments, in either form and precision.
   subroutine test_caller()
      character(len=*), parameter :: routines(2) = [character(len=7) :: 'uinter', 'vuinter']
      character(len=*), parameter :: forms(2) = [character(len=5) :: 'fixed', 'free']
      character(len=:), allocatable :: text
      character(len=11), allocatable :: names(:)
      type(source_scan) :: found
      integer :: i, j

      do i = 1, 2
         do j = 1, 2
            call caller_of(trim(routines(i)), forms(j), single_kind, text)
            call scan_source(text, forms(j), found)
            call assertEqual('calls_'//routines(i), found%routines(1)%name)
            call assertTrue(index(text, '      call '//trim(routines(i))//'( ') > 0)
            call argument_list(trim(routines(i)), names)
            call assertTrue(index(text, ' '//trim(names(size(names)))//'(1))'//newline) > 0)
            call assertTrue(index(text, '      real*4 props(1)'//newline) > 0)
         end do
      end do
      call caller_of('uinter', 'fixed', double_kind, text)
      call assertTrue(index(text, '      real*8 props(1)'//newline) > 0)
      call assertTrue(index(text, '      integer mcrd(1)'//newline) > 0)
      call assertTrue(index(text, '      character(len=80) ciname'//newline) > 0)
   end subroutine test_caller

   subroutine test_include()
      call assertEqual('      implicit real*8(a-h,o-z)'//newline//'      parameter (nprecd=2)'// &
         newline, include_text(include_names(1), double_kind))
      call assertTrue(index(include_text(include_names(2), single_kind), &
         '      implicit real*4(a-h,o-z)'//newline) == 1)
   end subroutine test_include

   function warning(name, has) result(text)
      character(len=*), intent(in) :: name, has
      character(len=:), allocatable :: text

      text = 'Warning: Type mismatch in argument '''//name//''' at (1); passed REAL(8) to '//has// &
         newline
   end function warning

end module test_check_argument_types
