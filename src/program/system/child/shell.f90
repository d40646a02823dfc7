!> Shell commands apart from the program: C's system would lose an interrupt that waits.
module asperity_program_system_child_shell
   use, intrinsic :: iso_c_binding, only: c_int
   use asperity_program_system_child_posix, only: c_exit_now, c_fork, c_setpgid, c_waitpid
   use asperity_program_system_process, only: run_shell
   implicit none
   private
   public :: run_apart

contains

   !> Run a shell command in a process of its own, which an interrupt of the program's group does
   !> not reach; zero on success.
   integer function run_apart(command)
      !> The command
      character(len=*), intent(in) :: command
      integer(c_int) :: child, status

      run_apart = 1
      child = c_fork()
      if (child < 0) return
      if (child == 0) then
         status = c_setpgid(0_c_int, 0_c_int)
         call c_exit_now(merge(0_c_int, 1_c_int, run_shell(command) == 0))
      end if
      if (c_waitpid(child, status, 0_c_int) == child) run_apart = int(status)
   end function run_apart

end module asperity_program_system_child_shell
