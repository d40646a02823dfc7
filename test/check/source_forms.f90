!> Forms of sources with a UINTER: each way to write the head gives the same 47 arguments.
module test_check_source_forms
   use asperity_base_error, only: error_type
   use asperity_check_source_form, only: form_of, gfortran_options
   use asperity_check_source_scan, only: scan_source, source_scan
   use asperity_check_source_statements, only: next_statement, statement_reader
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use uinter_sources, only: fixed_begin, fixed_uinter, free_uinter, in_lower_case, manual, &
      newline, with_line_breaks
   implicit none
   private
   public :: suite_source_forms

   character(len=*), parameter :: tab = achar(9)

contains

   function suite_source_forms() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('forms of sources')
      call suite%addTest(TestMethod('fixed form', test_fixed))
      call suite%addTest(TestMethod('free form', test_free))
      call suite%addTest(TestMethod('what tells the form', test_form_of))
      call suite%addTest(TestMethod('statements whole', test_statements))
      call suite%addTest(TestMethod('a preprocessor''s conditions', test_conditions))
   end function suite_source_forms

   subroutine test_fixed()
      call has_uinter('as usual', 'a.f', fixed_uinter(manual), 1)
      call has_uinter('ending .for', 'a.FOR', fixed_uinter(manual), 1)
      call has_uinter('digits continue, comments between', 'a.f', 'C  subroutine '// &
         'uinter(nothing)'// &
         newline//fixed_uinter(manual, go_on='C    a comment ('''//newline//'!'//newline// &
         '     2 '), 2)
      call has_uinter('labels', 'a.f', ' 5   CONTINUE'//newline//'      END'//newline// &
         fixed_uinter(manual), 3)
      call has_uinter('tabs', 'a.f', fixed_uinter(manual, tab//'SUBROUTINE UINTER(', tab//'1'), 1)
      call has_uinter('blanks in names', 'a.f', &
         fixed_uinter(manual, '      SUB ROUTINE  U INTER  ('), 1)
      call has_uinter('a comment behind each line', 'a.f', &
         fixed_uinter(manual, fixed_begin//' ! (one, two)'//newline//'     &', &
         ' ! (one, two)'//newline//'     &'), 1)
      call has_uinter('a ! in column 6 continues', 'a.f', fixed_uinter(manual, go_on='     !'), 1)
      call has_uinter('a line beyond 72 columns', 'a.f', joined(fixed_uinter(manual)), 1)
      call has_uinter('a preprocessor''s lines', 'a.f', '#define ONE 1'//newline// &
         fixed_uinter(manual), 2)
      call has_uinter('line ends of Windows', 'a.f', windows(fixed_uinter(manual)), 1)
      call has_uinter('debug lines', 'a.f', 'D     SUBROUTINE UINTER(A)'//newline// &
         fixed_uinter(manual), 2)
   end subroutine test_fixed

   subroutine test_free()
      character(len=:), allocatable :: text

      call has_uinter('as usual', 'a.f90', free_uinter(), 1)
      call has_uinter('& at the beginning too, comments between', 'a.f90', &
         free_uinter(go_on='&'//newline//' ! subroutine uinter(a)'//newline//newline//'  & '), 1)
      call has_uinter('& within a name', 'a.f90', free_uinter('sub&'//newline//'&routine '// &
         'uinter('), 1)
      call has_uinter('beyond 132 columns', 'a.f90', free_uinter(go_on=''), 1)
      call has_uinter('recursive', 'a.f90', free_uinter('recursive subroutine uinter('), 1)
      call has_uinter('by directive', 'a.for', '!DIR$ FREEFORM'//newline//free_uinter(), 2)
      call has_uinter('by the older directive', 'a.f', '!dec$ freeform'//newline//free_uinter(), 2)
      call has_uinter('fixed by directive', 'a.f90', '!DIR$ NOFREEFORM'//newline// &
         fixed_uinter(manual), 2)
      call has_uinter('line ends of Windows', 'a.f90', windows(free_uinter()), 1)
      call has_uinter('other letters in comments', 'a.f90', '! Stra'//char(195)//char(159)//'e'// &
         newline//free_uinter(), 2)
      text = free_uinter()
      call has_uinter('no line end at the end', 'a.f90', text(:len(text) - 1), 1)
   end subroutine test_free

   subroutine test_form_of()
      type(error_type), allocatable :: error
      character(len=5) :: form

      call form_of('folder.f90/a.txt', 'subroutine uinter', form, error)
      call assertTrue(allocated(error), 'no Fortran')
      call assertTrue(index(error%message, 'folder.f90/a.txt is no Fortran by its ending') == 1)
      call form_of('a', 'subroutine uinter', form, error)
      call assertTrue(allocated(error), 'no ending')
      call form_of('a.txt', 'C'//newline//'cDEC$ NOFREEFORM', form, error)
      call assertFalse(allocated(error), 'by a directive')
      call assertEqual('fixed', form)
      call form_of('a.f90', '', form, error)
      call assertEqual('free', form, 'empty')
      call assertEqual('-ffixed-form -ffixed-line-length-none', gfortran_options('fixed', 'C #'))
      call assertEqual('-ffree-form -ffree-line-length-none -cpp', &
         gfortran_options('free', 'end'//newline//'#define A'))
   end subroutine test_form_of

   subroutine test_statements()
      call reads('free', 'a = ''it''''s ! no comment''; b = "x;y" ! comment|c = 1', &
         'a=''it''''s ! no comment''|b="x;y"|c=1', [1, 1, 2])
      call reads('free', 'print *, ''one &|   ! a comment|   &two''|end', &
         'print*,''one two''|end', [1, 4])
      call reads('free', '10 continue;;20|x=1;', 'continue|x=1', [1, 2])
      call reads('fixed', '   10 CONTINUE|      A=''B!C''|     1 //''D''|!     1 E|     2 '// &
         '//''E''', &
         'continue|a=''B!C''//''D''//''E''', [1, 2])
      call reads('fixed', '      A=1; B=2|*     C=3|     0D=4', 'a=1|b=2|d=4', [1, 1, 3])
      call reads('fixed', 'X', 'x', [1])
      call reads('free', '', '', [integer ::])
      call reads('fixed', '|||', '', [integer ::])
      call reads('free', ' & |&|', '', [integer ::])
   end subroutine test_statements

   !> Of #if and #else the first part counts, but for #if 0.
   subroutine test_conditions()
      call reads('free', '#if 0|a|# else|b|#endif|c', 'b|c', [4, 6])
      call reads('free', '#ifdef X|a|#if Y|b|#else|c|#endif|#elif Z|d|#if 0|e|#endif|#else|f|'// &
         '#endif|g', &
         'a|b|g', [2, 4, 16])
      call reads('fixed', '#endif|#if 0|      A|#endif|      B', 'b', [5])
   end subroutine test_conditions

   subroutine has_uinter(name, path, text, line)
      character(len=*), intent(in) :: name, path, text
      integer, intent(in) :: line
      type(source_scan) :: found
      type(error_type), allocatable :: error
      character(len=5) :: form

      call form_of(path, text, form, error)
      call assertFalse(allocated(error), name)
      call scan_source(text, form, found)
      call assertEqual(1, count(found%routines%name == 'uinter'), name)
      if (count(found%routines%name == 'uinter') /= 1) return
      associate (routine => found%routines(size(found%routines)))
         call assertEqual(47, size(routine%arguments), name)
         call assertTrue(all(routine%arguments == in_lower_case(manual)), name)
         call assertEqual('external', routine%role, name)
         call assertEqual(line, routine%line, name)
      end associate
   end subroutine has_uinter

   !> Statements of a source and their lines; | is a line's end, and the end of a statement.
   subroutine reads(form, text, expected, lines)
      character(len=*), intent(in) :: form, text, expected
      integer, intent(in) :: lines(:)
      type(statement_reader) :: reader
      character(len=:), allocatable :: all_of_them, statement
      integer, allocatable :: found_lines(:)
      integer :: line
      logical :: found

      all_of_them = ''
      allocate (found_lines(0))
      do
         call next_statement(with_line_breaks(text), form, reader, statement, line, found)
         if (.not. found) exit
         if (size(found_lines) > 0) all_of_them = all_of_them//'|'
         all_of_them = all_of_them//statement
         found_lines = [found_lines, line]
      end do
      call assertEqual(expected, all_of_them, text)
      call assertEqual(size(lines), size(found_lines), text)
      if (size(lines) == size(found_lines)) call assertEqual(lines, found_lines, text)
   end subroutine reads

   !> Without continuation lines.
   function joined(text) result(line)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: line
      integer :: at

      line = text
      do
         at = index(line, newline//'     &')
         if (at == 0) exit
         line = line(:at - 1)//line(at + 7:)
      end do
   end function joined

   function windows(text) result(changed)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: changed
      integer :: i

      changed = ''
      do i = 1, len(text)
         if (text(i:i) == newline) changed = changed//achar(13)
         changed = changed//text(i:i)
      end do
   end function windows

end module test_check_source_forms
