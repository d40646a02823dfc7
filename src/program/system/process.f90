!> Signals, and programs that the program runs.
module asperity_program_system_process
   use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_funptr, c_int, c_intptr_t, &
      c_null_char, c_null_funptr, c_null_ptr, c_ptr, c_size_t
   use asperity_base_number_text, only: to_text
   use asperity_program_system_errno, only: last_reason
   use asperity_program_system_posix, only: c_fwrite, c_pclose, c_popen, c_raise, c_signal, &
      c_system, sigpipe, sigxfsz
   implicit none
   private
   public :: open_shell, close_shell, run_shell, shell_type
   public :: held_interrupts, hold_interrupts, release_interrupts, set_signals

   !> What ends a program from outside: SIGHUP, SIGINT, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGTERM
   !> and SIGXCPU, the user's, the system's and batch systems' signals
   integer(c_int), parameter :: interrupts(*) = int([1, 2, 3, 10, 12, 14, 15, 24], c_int)

   !> What interrupts did before they were held.
   type :: held_interrupts
      private
      type(c_funptr) :: before(size(interrupts)) = c_null_funptr
   end type held_interrupts

   !> A shell command that waits for its standard input.
   type :: shell_type
      private
      type(c_ptr) :: stream = c_null_ptr
   end type shell_type

   !> The interrupt that came while they were held, or 0: a handler has nowhere else to tell it
   integer(c_int), volatile :: came = 0_c_int

contains

   !> What signals do in this program. A reader that goes away (`| head`) ends it without a message,
   !> as it ends `cat`; a file that becomes larger than it may is an error of writing.
   subroutine set_signals()
      type(c_funptr) :: before

      before = c_signal(sigpipe, c_null_funptr)
      before = c_signal(sigxfsz, ignored())
   end subroutine set_signals

   !> Put interrupts off while files are there under their temporary names. What is ignored anyway,
   !> as by nohup, stays so.
   subroutine hold_interrupts(held)
      !> What interrupts did before, for `release_interrupts`
      type(held_interrupts), intent(out) :: held
      type(c_funptr) :: own
      integer :: i

      do i = 1, size(interrupts)
         held%before(i) = c_signal(interrupts(i), c_funloc(note_interrupt))
         if (c_associated(held%before(i), ignored())) own = c_signal(interrupts(i), ignored())
      end do
   end subroutine hold_interrupts

   !> Let interrupts do again what they did before, also the one that came meanwhile.
   subroutine release_interrupts(held, is_ending)
      !> From `hold_interrupts`
      type(held_interrupts), intent(in) :: held
      !> Whether the program is at its end anyway, and so forgets the one that came; no unless given
      logical, intent(in), optional :: is_ending
      type(c_funptr) :: own
      integer(c_int) :: number, status
      integer :: i

      do i = 1, size(interrupts)
         own = c_signal(interrupts(i), held%before(i))
      end do
      number = came
      came = 0_c_int
      if (present(is_ending)) then
         if (is_ending) return
      end if
      if (number == 0_c_int) return
      status = c_raise(number)
      if (status /= 0_c_int) return
   end subroutine release_interrupts

   !> Handler of an interrupt that is put off.
   subroutine note_interrupt(number) bind(c, name='')
      integer(c_int), value :: number

      came = number
   end subroutine note_interrupt

   !> Run a shell command; zero on success.
   integer function run_shell(command)
      !> The command
      character(len=*), intent(in) :: command

      run_shell = int(c_system(command//c_null_char))
   end function run_shell

   !> Start a shell command. Interrupts do to it what they do to the program at this moment.
   subroutine open_shell(shell, command, failure)
      !> The running command, for `close_shell`
      type(shell_type), intent(out) :: shell
      !> The command
      character(len=*), intent(in) :: command
      !> Set when it cannot be started, such as `could not be started: Out of memory`
      character(len=:), allocatable, intent(out) :: failure

      shell%stream = c_popen(command//c_null_char, 'w'//c_null_char)
      if (.not. c_associated(shell%stream)) failure = 'could not be started: '//last_reason()
   end subroutine open_shell

   !> Give a shell command its standard input, and wait for its end.
   subroutine close_shell(shell, text, failure)
      !> From `open_shell`, which succeeded
      type(shell_type), intent(inout) :: shell
      !> Its standard input
      character(len=*), intent(in) :: text
      !> Set unless it read all and succeeded, such as `failed with exit status 1`
      character(len=:), allocatable, intent(out) :: failure
      type(c_funptr) :: before
      integer(c_size_t) :: written
      integer :: status

      before = c_signal(sigpipe, ignored())
      written = c_fwrite(text, 1_c_size_t, len(text, c_size_t), shell%stream)
      status = int(c_pclose(shell%stream))
      shell%stream = c_null_ptr
      if (status == -1) then
         failure = 'was lost: '//last_reason()
      else if (status /= 0) then
         failure = words_for(status)
      else if (written /= len(text, c_size_t)) then
         failure = 'did not read all of its input'
      end if
      before = c_signal(sigpipe, before)
   end subroutine close_shell

   !> How a process ended, from its wait status: the signal is in the lowest seven bits, the exit
   !> status in the next byte.
   pure function words_for(status) result(words)
      integer, intent(in) :: status
      character(len=:), allocatable :: words

      if (ibits(status, 0, 7) == 0) then
         words = 'failed with exit status '//to_text(ibits(status, 8, 8))
      else
         words = 'was ended by signal '//to_text(ibits(status, 0, 7))
      end if
   end function words_for

   !> The C constant SIG_IGN.
   pure type(c_funptr) function ignored()
      ignored = transfer(1_c_intptr_t, c_null_funptr)
   end function ignored

end module asperity_program_system_process
