!> Interfaces of the C functions that run a child process; POSIX says what they do, for mallopt the
!> manual of glibc. Sizes and constants are those of Linux.
module asperity_program_system_child_posix
   use, intrinsic :: iso_c_binding, only: c_char, c_int, c_long, c_ptr
   implicit none
   private
   public :: signal_set, time_span, c_chdir, c_dup2, c_exit, c_exit_now, c_fork, c_kill, &
      c_mallopt, c_mkdir, c_mkdtemp, c_prctl, c_setpgid, c_setrlimit, c_sigaddset, &
      c_sigemptyset, c_sigprocmask, c_sigtimedwait, c_waitpid

   !> What sigprocmask does with a set of signals
   integer(c_int), parameter, public :: block_set = 0_c_int, replace_set = 2_c_int

   !> Signals: 1024 bits
   type, bind(c) :: signal_set
      integer(c_long) :: bits(16) = 0_c_long
   end type signal_set

   !> Seconds and nanoseconds
   type, bind(c) :: time_span
      integer(c_long) :: seconds = 0_c_long, nanoseconds = 0_c_long
   end type time_span

   interface
      integer(c_int) function c_fork() bind(c, name='fork')
         import :: c_int
      end function c_fork
      integer(c_int) function c_waitpid(process, status, options) bind(c, name='waitpid')
         import :: c_int
         integer(c_int), value :: process, options
         integer(c_int), intent(out) :: status
      end function c_waitpid
      subroutine c_exit(status) bind(c, name='exit')
         import :: c_int
         integer(c_int), value :: status
      end subroutine c_exit
      subroutine c_exit_now(status) bind(c, name='_exit')
         import :: c_int
         integer(c_int), value :: status
      end subroutine c_exit_now
      integer(c_int) function c_kill(process, signal) bind(c, name='kill')
         import :: c_int
         integer(c_int), value :: process, signal
      end function c_kill
      integer(c_int) function c_setpgid(process, group) bind(c, name='setpgid')
         import :: c_int
         integer(c_int), value :: process, group
      end function c_setpgid
      integer(c_int) function c_setrlimit(resource, limits) bind(c, name='setrlimit')
         import :: c_int, c_long
         integer(c_int), value :: resource
         integer(c_long), intent(in) :: limits(2)
      end function c_setrlimit
      integer(c_int) function c_sigemptyset(set) bind(c, name='sigemptyset')
         import :: c_int, signal_set
         type(signal_set), intent(inout) :: set
      end function c_sigemptyset
      integer(c_int) function c_sigaddset(set, signal) bind(c, name='sigaddset')
         import :: c_int, signal_set
         type(signal_set), intent(inout) :: set
         integer(c_int), value :: signal
      end function c_sigaddset
      integer(c_int) function c_sigprocmask(how, set, before) bind(c, name='sigprocmask')
         import :: c_int, signal_set
         integer(c_int), value :: how
         type(signal_set), intent(in) :: set
         type(signal_set), intent(inout) :: before
      end function c_sigprocmask
      integer(c_int) function c_sigtimedwait(set, facts, span) bind(c, name='sigtimedwait')
         import :: c_int, c_ptr, signal_set, time_span
         type(signal_set), intent(in) :: set
         type(c_ptr), value :: facts
         type(time_span), intent(in) :: span
      end function c_sigtimedwait
      integer(c_int) function c_dup2(file, number) bind(c, name='dup2')
         import :: c_int
         integer(c_int), value :: file, number
      end function c_dup2
      integer(c_int) function c_chdir(path) bind(c, name='chdir')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
      end function c_chdir
      integer(c_int) function c_mkdir(path, mode) bind(c, name='mkdir')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: path(*)
         integer(c_int), value :: mode
      end function c_mkdir
      type(c_ptr) function c_mkdtemp(pattern) bind(c, name='mkdtemp')
         import :: c_char, c_ptr
         character(kind=c_char), intent(inout) :: pattern(*)
      end function c_mkdtemp
      integer(c_int) function c_prctl(option, value) bind(c, name='prctl')
         import :: c_int, c_long
         integer(c_int), value :: option
         integer(c_long), value :: value
      end function c_prctl
      integer(c_int) function c_mallopt(parameter, value) bind(c, name='mallopt')
         import :: c_int
         integer(c_int), value :: parameter, value
      end function c_mallopt
   end interface

end module asperity_program_system_child_posix
