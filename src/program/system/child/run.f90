!> Work done in a child process, which has a folder, limits and an output of its own: whatever it
!> does to itself, the program goes on.
module asperity_program_system_child_run
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_funptr, c_int, c_long, c_null_char, &
      c_null_funptr, c_null_ptr, c_ptr
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_libc, only: c_fopen
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_child_posix, only: c_chdir, c_dup2, c_exit, c_fork, c_kill, &
      c_mallopt, c_mkdir, c_prctl, c_setpgid, c_setrlimit, c_sigprocmask, c_sigtimedwait, &
      c_waitpid, replace_set, signal_set, time_span
   use asperity_program_system_child_shell, only: run_apart
   use asperity_program_system_errno, only: last_reason
   use asperity_program_system_files, only: close_file, open_file, read_file, write_text
   use asperity_program_system_posix, only: c_fileno, c_signal, sigchld, sigkill, sigpipe, &
      sigxcpu, sigxfsz
   use asperity_program_system_strings, only: shell_word, split_lines, string_type
   implicit none
   private
   public :: child_work, child_limits, child_outcome, run_child, check_started

   !> How a child ended
   enum, bind(c)
      !> It did its work
      enumerator :: child_finished = 1
      !> It ended before, by itself
      enumerator :: child_stopped
      !> A signal ended it
      enumerator :: child_killed
      !> It took too long
      enumerator :: child_late
      !> The program was interrupted
      enumerator :: child_interrupted
      !> It could not be started
      enumerator :: child_refused
   end enum
   public :: child_finished, child_stopped, child_killed, child_late, child_interrupted, &
      child_refused

   !> Something to do in a child.
   type, abstract :: child_work
   contains
      !> Do it
      procedure(work), deferred :: work
   end type child_work

   abstract interface
      !> Do it and say what came of it.
      subroutine work(self, text)
         import :: child_work
         !> What to do
         class(child_work), intent(in) :: self
         !> The result, which the parent reads
         character(len=:), allocatable, intent(out) :: text
      end subroutine work
   end interface

   !> What a child may take.
   type :: child_limits
      !> Time of the processor, s; it may wait ten times as long
      integer :: seconds = 20
      !> Memory, MB
      integer :: megabytes = 2000
      !> What fresh memory is filled with, a byte; negative for what the system gives
      integer :: fill = -1
   end type child_limits

   !> What came of a child.
   type :: child_outcome
      !> One of the above
      integer :: ending = child_finished
      !> Exit status or number of the signal
      integer :: code = 0
      !> Its result, empty when it did not come to it; why it could not be started
      character(len=:), allocatable :: text
      !> What it wrote to standard output and standard error, the first part of it
      character(len=:), allocatable :: output
      !> Names of the files that it left in its folder
      type(string_type), allocatable :: files(:)
   end type child_outcome

   !> Resources of setrlimit: time of the processor, size of a file, core files, address space
   integer(c_int), parameter :: limit_time = 0_c_int, limit_file = 1_c_int, limit_core = 4_c_int, &
      limit_memory = 9_c_int
   integer(c_long), parameter :: megabyte = 1048576_c_long
   !> Largest file that a child may write, MB, and how much of its output is read
   integer(c_long), parameter :: largest_file = 64_c_long
   integer, parameter :: output_read = 1048576, result_read = huge(1)
   !> How much longer than its time of the processor a child may take
   integer, parameter :: waiting_factor = 10
   integer(c_int), parameter :: no_wait = 1_c_int, all_rights = int(o'700', c_int)
   !> Option of prctl: the signal that the end of the program sends to its child
   integer(c_int), parameter :: end_with_parent = 1_c_int
   !> Parameter of mallopt: the byte that freed memory gets, fresh memory its complement
   integer(c_int), parameter :: malloc_fill = -6_c_int

contains

   !> Do some work in a child. What it prints goes to the file `output` of the folder; it works in
   !> the folder `work` below it, which is fresh; what comes of it to the file `result`.
   subroutine run_child(folder, job, limits, outcome)
      !> Where the files go
      type(temporary_folder), intent(inout) :: folder
      !> The work
      class(child_work), intent(in) :: job
      !> Limits
      type(child_limits), intent(in) :: limits
      !> How it ended
      type(child_outcome), intent(out) :: outcome
      character(len=:), allocatable :: reason
      integer(c_int) :: child, status

      outcome%text = ''
      outcome%output = ''
      status = int(run_apart('cd '//shell_word(folder%path)//' && { chmod -R u+rwX work; '// &
         'rm -rf work result output; } 2>/dev/null'), c_int)
      status = c_mkdir(folder%path//'/work'//c_null_char, all_rights)
      child = -1_c_int
      if (status == 0) child = c_fork()
      if (child < 0) then
         outcome%ending = child_refused
         outcome%text = last_reason()
         allocate (outcome%files(0))
         return
      end if
      if (child == 0) call be_child(folder, job, limits)
      ! both do it, as either may come first
      status = c_setpgid(child, child)
      call wait_for(child, folder, int(limits%seconds, int64)*waiting_factor, outcome)
      call read_file(folder%path//'/output', output_read, outcome%output, reason)
      if (allocated(reason)) outcome%output = ''
      if (outcome%ending == child_finished) then
         call read_file(folder%path//'/result', result_read, outcome%text, reason)
         if (allocated(reason)) then
            outcome%ending = child_stopped
            outcome%text = ''
         end if
      end if
      call list_files(folder, outcome%files)
   end subroutine run_child

   !> `error` is set when the work could not begin, or the program was interrupted.
   pure subroutine check_started(outcome, error)
      !> What came of the work
      type(child_outcome), intent(in) :: outcome
      !> Set when there is nothing to judge
      type(error_type), allocatable, intent(out) :: error

      if (outcome%ending == child_interrupted) then
         call fatal_error(error, 'interrupted', computation_error)
      else if (outcome%ending == child_refused) then
         call fatal_error(error, 'no child process can be started: '//outcome%text, &
            computation_error)
      end if
   end subroutine check_started

   !> What the child does; it does not return.
   subroutine be_child(folder, job, limits)
      type(temporary_folder), intent(in) :: folder
      class(child_work), intent(in) :: job
      type(child_limits), intent(in) :: limits
      type(signal_set) :: waited
      type(c_funptr) :: before
      type(c_ptr) :: stream
      character(len=:), allocatable :: reason, text
      integer(c_int) :: file, status

      status = c_setpgid(0_c_int, 0_c_int)
      status = c_prctl(end_with_parent, int(sigkill, c_long))
      before = c_signal(sigpipe, c_null_funptr)
      before = c_signal(sigxfsz, c_null_funptr)
      status = c_sigprocmask(replace_set, folder%before, waited)
      call open_file(folder%path//'/output', file, reason)
      status = c_dup2(file, 1_c_int)
      status = c_dup2(file, 2_c_int)
      stream = c_fopen('/dev/null'//c_null_char, 'r'//c_null_char)
      if (c_associated(stream)) status = c_dup2(c_fileno(stream), 0_c_int)
      status = c_chdir(folder%path//'/work'//c_null_char)
      call limit(limit_time, int(limits%seconds, c_long), 1_c_long)
      call limit(limit_memory, limits%megabytes*megabyte, 0_c_long)
      call limit(limit_file, largest_file*megabyte, 0_c_long)
      call limit(limit_core, 0_c_long, 0_c_long)
      if (limits%fill >= 0) status = c_mallopt(malloc_fill, int(255 - limits%fill, c_int))
      ! a foreign routine may divide by zero, as it may in its own host
      call ieee_set_halting_mode(ieee_all, .false.)
      call job%work(text)
      call open_file(folder%path//'/result', file, reason)
      if (.not. allocated(reason)) call write_text(file, text, reason)
      if (.not. allocated(reason)) call close_file(file, reason)
      ! closes the files of the routine as well
      call c_exit(merge(1_c_int, 0_c_int, allocated(reason)))
   end subroutine be_child

   !> Set a limit and, a bit higher, what it can never be raised above.
   subroutine limit(resource, value, above)
      integer(c_int), intent(in) :: resource
      integer(c_long), intent(in) :: value, above
      integer(c_int) :: status

      status = c_setrlimit(resource, [value, value + above])
      if (status /= 0) return
   end subroutine limit

   !> Wait until a child ends; end it when it takes too long or the program is interrupted.
   subroutine wait_for(child, folder, seconds, outcome)
      integer(c_int), intent(in) :: child
      type(temporary_folder), intent(inout) :: folder
      integer(int64), intent(in) :: seconds
      type(child_outcome), intent(inout) :: outcome
      integer(int64) :: began, now, rate
      integer(c_int) :: signal, status, ended

      call system_clock(began, rate)
      do
         ended = c_waitpid(child, status, no_wait)
         if (ended == child) exit
         call system_clock(now)
         signal = c_sigtimedwait(folder%waiting, c_null_ptr, time_span(1_c_long, 0_c_long))
         if (signal > 0 .and. signal /= sigchld) then
            folder%interrupt = signal
            outcome%ending = child_interrupted
         else if (now - began > seconds*rate) then
            outcome%ending = child_late
         else
            cycle
         end if
         ended = c_kill(-child, sigkill)
         ended = c_waitpid(child, status, 0_c_int)
         return
      end do
      ! what it started and left is ended with it
      ended = c_kill(-child, sigkill)
      if (ibits(status, 0, 7) == 0) then
         outcome%code = ibits(status, 8, 8)
         if (outcome%code /= 0) outcome%ending = child_stopped
      else
         outcome%code = ibits(status, 0, 7)
         outcome%ending = child_killed
         if (outcome%code == sigxcpu) outcome%ending = child_late
      end if
   end subroutine wait_for

   !> Names of the files that a child left.
   subroutine list_files(folder, names)
      type(temporary_folder), intent(in) :: folder
      type(string_type), allocatable, intent(out) :: names(:)
      character(len=:), allocatable :: text, reason
      integer :: status

      status = run_apart('cd '//shell_word(folder%path)//' && LC_ALL=C ls -A work '// &
         '>files 2>/dev/null')
      call read_file(folder%path//'/files', output_read, text, reason)
      if (allocated(reason) .or. status /= 0) text = ''
      call split_lines(text, names)
   end subroutine list_files

end module asperity_program_system_child_run
