!> Shell commands in a child process, so that an interrupt ends them and cleans up.
module asperity_program_system_child_command
   use asperity_base_error, only: error_type, fatal_error, file_error
   use asperity_base_number_text, only: to_text
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_child_run, only: child_finished, child_interrupted, child_limits, &
      child_outcome, child_work, run_child
   use asperity_program_system_process, only: run_shell
   implicit none
   private
   public :: run_command

   !> A shell command.
   type, extends(child_work) :: shell_job
      private
      character(len=:), allocatable :: command
   contains
      procedure :: work
   end type shell_job

   !> Compilers take what they need
   type(child_limits), parameter :: limits = child_limits(seconds=600, megabytes=8000)

contains

   !> Run a command in a fresh folder of its own, with messages in English.
   subroutine run_command(folder, command, output, status, error)
      !> Where the files go
      type(temporary_folder), intent(inout) :: folder
      !> The command
      character(len=*), intent(in) :: command
      !> What it writes to standard output and standard error
      character(len=:), allocatable, intent(out) :: output
      !> Zero on success
      integer, intent(out) :: status
      !> Set when it cannot be run, takes too long or is interrupted
      type(error_type), allocatable, intent(out) :: error
      type(shell_job) :: job
      type(child_outcome) :: outcome
      integer :: failure

      job%command = command
      call run_child(folder, job, limits, outcome)
      output = outcome%output
      status = 1
      if (outcome%ending == child_interrupted) then
         call fatal_error(error, 'interrupted')
      else if (outcome%ending /= child_finished) then
         call fatal_error(error, command(:index(command//' ', ' ') - 1)//' was not run to its '// &
            'end: it needs space in '//folder%path//' (TMPDIR), memory and time', file_error)
      else
         read (outcome%text, *, iostat=failure) status
         if (failure /= 0) status = 1
      end if
   end subroutine run_command

   !> Run the command; the result is its status.
   subroutine work(self, text)
      !> The command
      class(shell_job), intent(in) :: self
      !> Its status
      character(len=:), allocatable, intent(out) :: text

      ! compilers keep files in TMPDIR, which they leave there when they are ended
      text = to_text(run_shell('export LC_ALL=C TMPDIR="$PWD"; '//self%command))
   end subroutine work

end module asperity_program_system_child_command
