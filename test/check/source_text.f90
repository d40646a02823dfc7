!> Sources in files, and the routine that ABAQUS would call of them.
module test_check_source_text
   use asperity_base_error, only: error_type, file_error, input_error
   use asperity_check_source_scan, only: scan_source, source_scan
   use asperity_check_source_text, only: read_source, source_text
   use asperity_check_source_units, only: source_routine
   use asperity_check_source_user_routine, only: find_user_routine
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use uinter_sources, only: with_line_breaks
   implicit none
   private
   public :: suite_source_text

   character(len=*), parameter :: folder = 'test/data/uinter/included/'

contains

   function suite_source_text() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('sources in files')
      call suite%addTest(TestMethod('included files in their places', test_included))
      call suite%addTest(TestMethod('files that are no sources', test_refused))
      call suite%addTest(TestMethod('no UINTER, two, or another thing', test_user_routine))
   end function suite_source_text

   subroutine test_included()
      type(source_text) :: source
      type(source_scan) :: found
      type(source_routine) :: routine
      type(error_type), allocatable :: error

      call read_source(folder//'whole.f', source, error)
      call assertFalse(allocated(error), 'is read')
      call scan_source(source%text, source%form, found)
      call find_user_routine(source, found, 'uinter', routine, error)
      call assertFalse(allocated(error), 'is found')
      call assertEqual('line 2 of BODY.INC', source%place(routine%line))
      call assertEqual(2, size(found%routines))
      call assertEqual('line 3', source%place(found%routines(2)%line))
      call assertEqual('line 1 of common.inc', source%place(routine%line + 1))
      call assertEqual('line 4 of BODY.INC', source%place(routine%line + 3))
      call assertEqual(1, size(found%includes), 'one does not stand beside it')
      call assertEqual('ABA_PARAM.INC', found%includes(1)%name)
      call read_source(folder//'mark.f', source, error)
      call scan_source(source%text, source%form, found)
      call find_user_routine(source, found, 'uinter', routine, error)
      call assertFalse(allocated(error), 'is found behind the mark of UTF-8')
   end subroutine test_included

   subroutine test_refused()
      call refused('none.f', file_error, 'cannot read '//folder//'none.f: ')
      call refused('body.inc', input_error, folder//'body.inc is no Fortran by its ending')
      call refused('binary.f', input_error, folder//'binary.f is no text: it has zero bytes')
      call refused('endless.f', input_error, folder//'endless.f includes files that include each')
      call refused('', file_error, 'cannot read ')
   end subroutine test_refused

   subroutine test_user_routine()
      call explained('empty.f', 'has no subroutine UINTER')
      call explained('missing.f', 'has no subroutine UINTER; it includes nowhere.inc, which '// &
         'does '// &
         'not stand beside it')
      call says('subroutine vuinter|end', 'free', 'uinter', 'a.f has no subroutine UINTER but '// &
         'VUINTER, which ABAQUS/Explicit calls')
      call says('subroutine uinter|end', 'free', 'vuinter', 'a.f has no subroutine VUINTER but '// &
         'UINTER, which ABAQUS/Standard calls')
      call says('subroutine uinter(a, &|b)|end', 'fixed', 'uinter', 'a.f has no subroutine '// &
         'UINTER '// &
         'in fixed form, but in free form: begin the file with !DIR$ FREEFORM')
      call says('      SUBROUTINE UINTER(A,|     1 B)|      END', 'free', 'uinter', &
         'a.f has no '// &
         'subroutine UINTER in free form, but in fixed form: begin the file with !DIR$ NOFREEFORM')
      call says('module m|contains|subroutine uinter|end|end', 'free', 'uinter', &
         'UINTER at line 3 '// &
         'of a.f is a procedure of module M; ABAQUS calls an external subroutine')
      call says('program p|contains|subroutine uinter|end|end', 'free', 'uinter', &
         'UINTER at line 3 '// &
         'of a.f is inside P; ABAQUS calls an external subroutine')
      call says('subroutine a|entry uinter|end', 'free', 'uinter', 'UINTER at line 2 of a.f '// &
         'is an '// &
         'ENTRY of A; ABAQUS calls an external subroutine')
      call says('subroutine uinter() bind(c)|end', 'free', 'uinter', 'UINTER at line 1 of a.f '// &
         'has '// &
         'BIND(C), so that its name for the linker is another; ABAQUS calls an external subroutine')
      call says('subroutine uinter|end|subroutine b|end|subroutine uinter|end', 'free', 'uinter', &
         'a.f has 2 subroutines UINTER, at line 1 and at line 5; leave the one that ABAQUS '// &
         'shall call')
   end subroutine test_user_routine

   subroutine refused(name, category, message)
      character(len=*), intent(in) :: name, message
      integer, intent(in) :: category
      type(source_text) :: source
      type(error_type), allocatable :: error

      call read_source(folder//name, source, error)
      call assertTrue(allocated(error), name)
      if (.not. allocated(error)) return
      call assertEqual(category, error%category, name)
      call assertEqual(message, error%message(:min(len(message), len(error%message))), name)
   end subroutine refused

   !> What is said of a file.
   subroutine explained(name, message)
      character(len=*), intent(in) :: name, message
      type(source_text) :: source
      type(source_scan) :: found
      type(source_routine) :: routine
      type(error_type), allocatable :: error

      call read_source(folder//name, source, error)
      call assertFalse(allocated(error), name)
      call scan_source(source%text, source%form, found)
      call find_user_routine(source, found, 'uinter', routine, error)
      call assertTrue(allocated(error), name)
      if (allocated(error)) call assertEqual(folder//name//' '//message, error%message, name)
   end subroutine explained

   !> What is said of a source whose line ends are |, as if it were in a.f.
   subroutine says(text, form, name, message)
      character(len=*), intent(in) :: text, form, name, message
      type(source_text) :: source
      type(source_scan) :: found
      type(source_routine) :: routine
      type(error_type), allocatable :: error
      integer :: i

      source%path = 'a.f'
      source%form = form
      source%text = with_line_breaks(text)
      source%line = [(i, i=1, 9)]
      source%file = [(1, i=1, 9)]
      call scan_source(source%text, source%form, found)
      call find_user_routine(source, found, name, routine, error)
      call assertTrue(allocated(error), text)
      if (allocated(error)) call assertEqual(message, error%message, text)
   end subroutine says

end module test_check_source_text
