!> What a command of the program is: its name, its keys, and what it does.
module asperity_program_commands_command
   use asperity_base_error, only: error_type
   use asperity_program_input_key, only: kind_file, kind_picture, kind_sweep
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_launch, only: launch_type
   implicit none
   private
   public :: command_type

   !> A command. Those of the program stand in registry.f90.
   type, abstract :: command_type
      !> Words that call it, such as `deck shear`
      character(len=12) :: name = ''
      !> What it does, in a line of the overview
      character(len=76) :: summary = ''
      !> What follows the words, one way a line
      character(len=:), allocatable :: usage
      !> What it is for, in a few sentences
      character(len=:), allocatable :: purpose
      !> Headings of its properties and of its other keys in its help
      character(len=52) :: headings(2) = [character(len=52) :: &
         'Properties of the faces, also keys of a case file', 'The test, also keys of a case file']
      !> Whether it takes a case file
      logical :: takes_case = .true.
      !> Whether ranks of MPI share its work; else rank 0 does it
      logical :: uses_ranks = .false.
      !> The rank that runs it. Those above 0 say and write nothing
      type(launch_type) :: launch
      !> The input is to be printed as a case file
      logical :: prints_case = .false.
      !> Paths of the outputs of all commands
      character(len=:), allocatable :: csv, json, plot
      !> Keys with several values each, empty for one run
      character(len=:), allocatable :: sweep
      logical :: asks_help = .false.
   contains
      !> Set name, usage and the like
      procedure(describe), deferred :: describe
      !> Declare its keys, which gives its variables their values
      procedure(declare), deferred :: declare
      !> Check its values
      procedure :: check
      !> Do it
      procedure(run), deferred :: run
      !> Clear up when its results are written, and judge them
      procedure :: finish
      !> Declare the outputs of all commands
      procedure :: declare_outputs
      !> Declare that keys may take several values each
      procedure :: declare_sweep
      !> Declare what all commands may be asked for
      procedure :: declare_requests
   end type command_type

   abstract interface
      !> Set name, usage and the like.
      pure subroutine describe(self)
         import :: command_type
         !> The command
         class(command_type), intent(inout) :: self
      end subroutine describe

      !> Declare the keys.
      pure subroutine declare(self, keys)
         import :: command_type, key_list
         !> The command, whose variables take their values
         class(command_type), intent(inout) :: self
         !> Its keys
         type(key_list), intent(inout) :: keys
      end subroutine declare

      !> Run the command. `error` is set when that fails; its subject names values of the library.
      subroutine run(self, report, error)
         import :: command_type, report_type, error_type
         !> The command, with its values
         class(command_type), intent(inout) :: self
         !> With its keys on entry, results on return
         type(report_type), intent(inout) :: report
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine run
   end interface

contains

   !> Check the values of the command, and make of them what it runs on.
   subroutine check(self, error)
      !> The command
      class(command_type), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      ! nothing to check, unless a command says so
      associate (command => self)
      end associate
   end subroutine check

   !> Clear up when the results are written. A command whose results say that something is wrong
   !> fails here, after them.
   subroutine finish(self, error)
      !> The command
      class(command_type), intent(inout) :: self
      !> Set when the results are no success
      type(error_type), allocatable, intent(out) :: error

      ! nothing is left, unless a command says so
      associate (command => self)
      end associate
   end subroutine finish

   !> Declare the outputs of all commands.
   pure subroutine declare_outputs(self, keys, has_picture)
      !> The command
      class(command_type), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys
      !> Whether it draws a picture
      logical, intent(in) :: has_picture

      call keys%text('csv', self%csv, &
         'write all columns with 17 figures; - is standard output', kind_file)
      call keys%text('json', self%json, &
         'write properties, units and all columns; - is standard output', kind_file)
      if (has_picture) call keys%text('plot', self%plot, &
         'draw a picture, .svg, .png or .pdf (needs gnuplot)', kind_picture)
   end subroutine declare_outputs

   !> Declare that keys may take several values each.
   pure subroutine declare_sweep(self, keys)
      !> The command
      class(command_type), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call keys%text('sweep', self%sweep, &
         'run all combinations; NAME=a,b,c or NAME=start:stop:count; may be repeated', kind_sweep)
   end subroutine declare_sweep

   !> Declare what all commands may be asked for.
   pure subroutine declare_requests(self, keys)
      !> The command
      class(command_type), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      if (self%takes_case) call keys%request('print_case', self%prints_case, &
         'print the effective input as a case file and stop')
      call keys%request('help', self%asks_help, 'print this text')
   end subroutine declare_requests

end module asperity_program_commands_command
