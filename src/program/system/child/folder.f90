!> A temporary folder that is removed at the end, also when the program is interrupted: while it is
!> there, interrupts wait, and who waits for a child process (`run_child`) ends that instead.
module asperity_program_system_child_folder
   use, intrinsic :: iso_c_binding, only: c_associated, c_funptr, c_int, c_intptr_t, &
      c_null_char, c_null_funptr
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_program_system_child_posix, only: block_set, c_kill, c_mkdtemp, c_sigaddset, &
      c_sigemptyset, c_sigprocmask, replace_set, signal_set
   use asperity_program_system_child_shell, only: run_apart
   use asperity_program_system_errno, only: last_reason
   use asperity_program_system_path, only: resolved_path
   use asperity_program_system_posix, only: c_getpid, c_signal, sigchld
   use asperity_program_system_strings, only: shell_word
   implicit none
   private
   public :: temporary_folder, create_folder, remove_folder

   !> What ends a program from outside, and may wait: SIGHUP, SIGINT, SIGQUIT, SIGTERM
   integer(c_int), parameter :: interrupts(*) = int([1, 2, 3, 15], c_int)

   !> A temporary folder.
   type :: temporary_folder
      !> Its absolute path
      character(len=:), allocatable :: path
      !> Signals that wait while it is there, and what waited before
      type(signal_set) :: waiting, before
      !> The interrupt that came meanwhile, zero for none
      integer(c_int) :: interrupt = 0_c_int
   end type temporary_folder

contains

   !> Create a folder in TMPDIR, or in /tmp.
   subroutine create_folder(folder, error)
      !> The folder
      type(temporary_folder), intent(out) :: folder
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: place
      integer(c_int) :: status
      integer :: i, length

      call get_environment_variable('TMPDIR', length=length)
      place = repeat(' ', length)
      if (length > 0) call get_environment_variable('TMPDIR', place)
      if (length == 0) place = '/tmp'
      status = c_sigemptyset(folder%waiting)
      do i = 1, size(interrupts)
         if (.not. is_ignored(interrupts(i))) status = c_sigaddset(folder%waiting, interrupts(i))
      end do
      status = c_sigaddset(folder%waiting, sigchld)
      status = c_sigprocmask(block_set, folder%waiting, folder%before)
      ! children work in other folders
      if (resolved_path(place) /= '') place = resolved_path(place)
      folder%path = place//'/asperity-XXXXXX'//c_null_char
      if (.not. c_associated(c_mkdtemp(folder%path))) then
         call fatal_error(error, place//': no temporary folder can be created there: '// &
            last_reason()//'; set TMPDIR', file_error)
         status = c_sigprocmask(replace_set, folder%before, folder%waiting)
         return
      end if
      folder%path = folder%path(:len(folder%path) - 1)
   end subroutine create_folder

   !> Remove a folder and all that is in it, and let the interrupt that came meanwhile end the
   !> program.
   subroutine remove_folder(folder)
      !> The folder
      type(temporary_folder), intent(inout) :: folder
      integer(c_int) :: status
      type(signal_set) :: waiting

      ! a routine may have taken rights away from what it left there
      if (run_apart('chmod -R u+rwX '//shell_word(folder%path)//' 2>/dev/null; rm -rf '// &
         shell_word(folder%path)) /= 0) status = 0
      status = c_sigprocmask(replace_set, folder%before, waiting)
      if (folder%interrupt /= 0) status = c_kill(c_getpid(), folder%interrupt)
   end subroutine remove_folder

   !> Whether the program ignores a signal, as under nohup.
   logical function is_ignored(signal)
      integer(c_int), intent(in) :: signal
      type(c_funptr) :: action, default

      action = c_signal(signal, c_null_funptr)
      default = c_signal(signal, action)
      ! the C constant SIG_IGN
      is_ignored = transfer(action, 0_c_intptr_t) == 1_c_intptr_t
   end function is_ignored

end module asperity_program_system_child_folder
