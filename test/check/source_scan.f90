!> What the scan of a source finds, and what it is not taken in by.
module test_check_source_scan
   use asperity_check_source_scan, only: has_external, scan_source, source_scan
   use asperity_base_number_text, only: to_text
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use uinter_sources, only: fixed_uinter, manual, newline, with_line_breaks
   implicit none
   private
   public :: suite_source_scan

contains

   function suite_source_scan() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('scan of sources')
      call suite%addTest(TestMethod('subroutines and what they are in', test_routines))
      call suite%addTest(TestMethod('what looks like a head', test_no_heads))
      call suite%addTest(TestMethod('what looks like an end', test_no_ends))
      call suite%addTest(TestMethod('interfaces', test_interfaces))
      call suite%addTest(TestMethod('included files', test_includes))
      call suite%addTest(TestMethod('a large source', test_large))
      call suite%addTest(TestMethod('no source at all', test_nonsense))
   end function suite_source_scan

   subroutine test_routines()
      call has('free', 'subroutine a|end|subroutine b()|end subroutine b|recursive subroutine '// &
         'c(x,y)|'// &
         'end subroutine', 'a external 1|b external 3|c external 5')
      call has('free', 'module m|contains|subroutine a|end subroutine|end module|subroutine b|'// &
         'end', &
         'a module m 3|b external 6')
      call has('free', 'module m|real :: x|contains|pure real(kind=8) function f(x)|real, '// &
         'intent(in) '// &
         ':: x|end function|pure subroutine a(x)|contains|subroutine i|end|end|end module m', &
         'a module m 7|i internal a 9')
      call has('free', 'submodule (m) s|contains|module procedure p|end procedure|module '// &
         'subroutine '// &
         'q(x)|end|end submodule s|subroutine a|end', 'q module s 5|a external 8')
      call has('free', 'program p|call a|contains|subroutine a|end|end program', 'a internal p 4')
      call has('free', 'subroutine a(x)|entry b(x)|entry c|end', &
         'a external 1|b entry a 2|c entry a 3')
      call has('free', 'subroutine a(x) bind(c, name=''uinter'')|end', 'a bind(c) 1')
      call has('fixed', '      REAL*8 FUNCTION F(X)|      END|      CHARACTER*(*) FUNCTION G()|'// &
         '      END|      BLOCK DATA|      COMMON /A/ B|      END|      SUBROUTINE C(*,X)|    '// &
         '  END', &
         'c external 8')
      call has('free', 'module m|type t|contains|procedure :: p|end type|interface g|module '// &
         'procedure a, b|end interface|contains|subroutine a|end subroutine a|end module m', &
         'a module m 10')
   end subroutine test_routines

   subroutine test_no_heads()
      call has('free', 'subroutine a|subroutinex = 1|subroutine_b(3) = 2|print *, "subroutine '// &
         'uinter(a)"'// &
         '|! subroutine uinter(a)|functionx(3) = 1|real functional(10)|entryx = 1|program_x = '// &
         '2|'// &
         'module_x = 3|interface_stiffness = 4|interface = 5|end|subroutine b|end', &
         'a external 1|b external 14')
      ! real functional is read as a function if it may be one; among declarations none may begin
      call has('fixed', '      SUBROUTINE A(N)|      REAL FUNCTIONALS(N)|      END|      '// &
         'SUBROUTINE B'// &
         '|      END', 'a external 1|b external 4')
      call has('free', 'subroutine a(x, &|   ''|end', '')
   end subroutine test_no_heads

   subroutine test_no_ends()
      call has('free', 'module m|contains|subroutine a|if (x) then|end if|do i = 1, 2|enddo|'// &
         'endfunction '// &
         '= 1|endsubroutine(3) = 2|end = 4|block|end block|associate (x => y)|end associate|'// &
         'end '// &
         'subroutine|subroutine b|end subroutine|end module', 'a module m 3|b module m 16')
      ! an end too many, and one that was forgotten
      call has('free', 'end|subroutine a|end|end|subroutine b|subroutine c|end', &
         'a external 2|b external 5|c external 6')
   end subroutine test_no_ends

   subroutine test_interfaces()
      call has('free', 'subroutine a|interface|subroutine uinter(x)|end subroutine uinter|end '// &
         'interface'// &
         '|end|subroutine uinter(x)|end subroutine uinter', 'a external 1|uinter external 7')
      call has('free', 'module m|abstract interface|subroutine uinter|end|end interface|'// &
         'interface '// &
         'operator(+)|procedure p|end interface operator(+)|interface assignment(=)|'// &
         'subroutine b'// &
         '|end|end interface assignment(=)|contains|subroutine c|end|end', 'c module m 14')
   end subroutine test_interfaces

   subroutine test_includes()
      type(source_scan) :: found

      call scan_source(with_line_breaks('      INCLUDE ''Body.INC'' ! ''a''|      include "b '// &
         'c.f"|'// &
         'C     INCLUDE ''D''|      INCLUDEX=''E''|      PRINT *, ''INCLUDE ''''F'''''''), &
         'fixed', found)
      call assertEqual(2, size(found%includes))
      if (size(found%includes) /= 2) return
      call assertEqual('Body.INC', found%includes(1)%name)
      call assertEqual('b c.f', found%includes(2)%name)
      call assertEqual(1, found%includes(1)%line)
      call assertEqual(2, found%includes(2)%line)
   end subroutine test_includes

   !> 20000 lines and a statement of 2000 continuation lines before the UINTER.
   subroutine test_large()
      type(source_scan) :: found
      character(len=:), allocatable :: text
      character(len=*), parameter :: line = '      X = X + 1.D0'//newline, &
         more = '     &  + 1.D0'//newline

      text = '      SUBROUTINE A'//newline//repeat(line, 18000)//repeat(more, 2000)//'      END'// &
         newline//fixed_uinter(manual)
      call scan_source(text, 'fixed', found)
      call assertEqual(2, size(found%routines))
      if (size(found%routines) == 2) call assertEqual(20003, found%routines(2)%line)
   end subroutine test_large

   subroutine test_nonsense()
      type(source_scan) :: found
      character(len=*), parameter :: forms(2) = [character(len=5) :: 'fixed', 'free']
      character(len=256) :: every
      integer :: i

      do i = 1, 256
         every(i:i) = achar(i - 1)
      end do
      do i = 1, 2
         call scan_source('', forms(i), found)
         call assertEqual(0, size(found%routines))
         call scan_source(newline//newline//'  ', forms(i), found)
         call assertEqual(0, size(found%routines))
         call scan_source(every//newline//every, forms(i), found)
         call assertEqual(0, size(found%routines))
         call scan_source('subroutine (|endsubroutine', forms(i), found)
         call assertEqual(0, size(found%routines))
      end do
   end subroutine test_nonsense

   !> Routines of a source whose line ends are |: name, role, host, line.
   subroutine has(form, text, expected)
      character(len=*), intent(in) :: form, text, expected
      type(source_scan) :: found
      character(len=:), allocatable :: routines
      integer :: i

      call scan_source(with_line_breaks(text), form, found)
      routines = ''
      do i = 1, size(found%routines)
         associate (routine => found%routines(i))
            if (i > 1) routines = routines//'|'
            routines = routines//trim(routine%name)//' '//trim(routine%role)//' '
            if (routine%host /= '') routines = routines//trim(routine%host)//' '
            routines = routines//to_text(routine%line)
         end associate
      end do
      call assertEqual(expected, routines, text)
   end subroutine has

end module test_check_source_scan
