!> What stands in for the utility routines of ABAQUS that a user routine may call, as a source that
!> is compiled when a routine calls one. Messages go to a file of the folder in which the routine
!> runs, one a line with its level before it; what ends the job in ABAQUS ends the process.
module asperity_program_commands_routine_stubs
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: stubs_text

   !> Their names as gfortran has them
   character(len=*), parameter, public :: stub_names(*) = [character(len=16) :: 'stdb_abqerr_', &
      'xplb_abqerr_', 'xit_', 'xplb_exit_', 'getoutdir_', 'vgetoutdir_', 'getjobname_', &
      'vgetjobname_', 'getnumcpus_', 'vgetnumcpus_', 'getrank_', 'vgetrank_', 'getnumthreads_', &
      'get_thread_id_', 'mutexinit_', 'mutexlock_', 'mutexunlock_', 'posfil_', 'dbfile_']
   !> The file of messages, and the exit status of a job that is ended
   character(len=*), parameter, public :: messages_file = 'abaqus_messages'
   integer, parameter, public :: ended_status = 201
   !> Levels of messages: an error, and one that ends the job
   integer, parameter, public :: level_error = -2, level_end = -3

   character(len=*), parameter :: lines(*) = [character(len=90) :: &
      'subroutine stand_in_tell(level, text)', &
      '   implicit none', &
      '   integer, intent(in) :: level', &
      '   character(len=*), intent(in) :: text', &
      '   integer :: unit', &
      '   open (newunit=unit, file=''abaqus_messages'', position=''append'')', &
      '   write (unit, ''(i0, 1x, a)'') level, trim(text)', &
      '   close (unit)', &
      '   if (level == -3) call exit(201)', &
      'end subroutine', &
      ! Placeholders: %I integers, %S names; %R stays, as its precision is not known
      'subroutine stand_in_message(level, string, integers, names)', &
      '   implicit none', &
      '   integer, intent(in) :: level, integers(*)', &
      '   character(len=*), intent(in) :: string', &
      '   character(len=8), intent(in) :: names(*)', &
      '   character(len=:), allocatable :: text', &
      '   character(len=12) :: number', &
      '   integer :: i, used_i, used_s', &
      '   used_i = 0', &
      '   used_s = 0', &
      '   text = ''''', &
      '   i = 1', &
      '   do while (i <= len_trim(string))', &
      '      if (string(i:min(i + 1, len(string))) == ''%I'') then', &
      '         used_i = used_i + 1', &
      '         write (number, ''(i0)'') integers(used_i)', &
      '         text = text//trim(number)', &
      '         i = i + 2', &
      '      else if (string(i:min(i + 1, len(string))) == ''%S'') then', &
      '         used_s = used_s + 1', &
      '         text = text//trim(names(used_s))', &
      '         i = i + 2', &
      '      else', &
      '         text = text//string(i:i)', &
      '         i = i + 1', &
      '      end if', &
      '   end do', &
      '   call stand_in_tell(level, text)', &
      'end subroutine', &
      'subroutine stdb_abqerr(lop, string, intv, realv, charv)', &
      '   integer :: lop, intv(*)', &
      '   double precision :: realv(*)', &
      '   character(len=*) :: string', &
      '   character(len=8) :: charv(*)', &
      '   call stand_in_message(lop, string, intv, charv)', &
      'end subroutine', &
      'subroutine xplb_abqerr(lop, string, intv, realv, charv)', &
      '   integer :: lop, intv(*), realv(*)', &
      '   character(len=*) :: string', &
      '   character(len=8) :: charv(*)', &
      '   call stand_in_message(lop, string, intv, charv)', &
      'end subroutine', &
      'subroutine xit()', &
      '   call stand_in_tell(-3, ''XIT was called'')', &
      'end subroutine', &
      'subroutine xplb_exit()', &
      '   call stand_in_tell(-3, ''XPLB_EXIT was called'')', &
      'end subroutine', &
      'subroutine getoutdir(folder, length)', &
      '   character(len=*) :: folder', &
      '   integer :: length', &
      '   call getcwd(folder)', &
      '   length = len_trim(folder)', &
      'end subroutine', &
      'subroutine getjobname(name, length)', &
      '   character(len=*) :: name', &
      '   integer :: length', &
      '   name = ''check''', &
      '   length = 5', &
      'end subroutine', &
      'subroutine vgetoutdir(folder, length)', &
      '   character(len=*) :: folder', &
      '   integer :: length', &
      '   call getoutdir(folder, length)', &
      'end subroutine', &
      'subroutine vgetjobname(name, length)', &
      '   character(len=*) :: name', &
      '   integer :: length', &
      '   call getjobname(name, length)', &
      'end subroutine', &
      'subroutine getnumcpus(number)', &
      '   integer :: number', &
      '   number = 1', &
      'end subroutine', &
      'subroutine vgetnumcpus(number)', &
      '   integer :: number', &
      '   number = 1', &
      'end subroutine', &
      'subroutine getrank(number)', &
      '   integer :: number', &
      '   number = 0', &
      'end subroutine', &
      'subroutine vgetrank(number)', &
      '   integer :: number', &
      '   number = 0', &
      'end subroutine', &
      'integer function getnumthreads()', &
      '   getnumthreads = 1', &
      'end function', &
      'integer function get_thread_id()', &
      '   get_thread_id = 0', &
      'end function', &
      'subroutine mutexinit(number)', &
      '   integer :: number', &
      'end subroutine', &
      'subroutine mutexlock(number)', &
      '   integer :: number', &
      'end subroutine', &
      'subroutine mutexunlock(number)', &
      '   integer :: number', &
      'end subroutine', &
      ! There is no results file: its end is reached
      'subroutine posfil(step, increment, array, status)', &
      '   integer :: step, increment, status', &
      '   double precision :: array(*)', &
      '   status = 1', &
      'end subroutine', &
      'subroutine dbfile(lop, array, status)', &
      '   integer :: lop, status', &
      '   double precision :: array(*)', &
      '   status = 1', &
      'end subroutine']

contains

   !> The source, in free form.
   pure function stubs_text() result(text)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(lines)
         text = text//trim(lines(i))//newline
      end do
   end function stubs_text

end module asperity_program_commands_routine_stubs
