!> `asperity pairs`: the pairs of faces and the surfaces of the paper.
module asperity_program_commands_pairs
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_paper_pairs, only: pair_note, pairs, surfaces
   use asperity_program_commands_command, only: command_type
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: new_table
   implicit none
   private
   public :: pairs_command

   !> Lists the presets.
   type, extends(command_type) :: pairs_command
   contains
      procedure :: describe, declare, run
   end type pairs_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(pairs_command), intent(inout) :: self

      self%name = 'pairs'
      self%summary = 'pairs of faces and surfaces of the paper'
      self%usage = '[options]'
      self%purpose = 'Pairs of faces (--pair) and surfaces (--surface) of the paper, in N-mm-MPa.'
      self%takes_case = .false.
   end subroutine describe

   !> It has outputs alone.
   pure subroutine declare(self, keys)
      !> The command
      class(pairs_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%declare_outputs(keys, has_picture=.false.)
      call self%declare_requests(keys)
   end subroutine declare

   !> One row per pair, then one per surface, which has only its roughness.
   subroutine run(self, report, error)
      !> The command
      class(pairs_command), intent(inout) :: self
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set when a value is no number
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: none_s(size(surfaces)), none_p(size(pairs))
      integer :: i

      report%name = self%name
      none_s = none
      none_p = none
      report%table = new_table(columns=12, rows=size(pairs) + size(surfaces), leading=2)
      associate (table => report%table)
         call table%add_texts('kind', [character(len=7) :: ('pair', i=1, size(pairs)), &
            ('surface', i=1, size(surfaces))])
         call table%add_texts('name', [pairs%name, surfaces%name])
         call table%add_numbers('eta', '1/mm^2', [pairs%eta, surfaces%eta])
         call table%add_numbers('modulus', 'MPa', [pairs%modulus, none_s])
         call table%add_numbers('radius', 'mm', [pairs%radius, surfaces%radius])
         call table%add_numbers('hardness', 'MPa', [pairs%hardness, none_s])
         call table%add_numbers('yield_factor', '-', [pairs%yield_factor, none_s])
         call table%add_numbers('sigma', 'mm', [pairs%sigma, surfaces%sigma])
         call table%add_numbers('friction_coefficient', '-', &
            [pairs%friction_coefficient, none_s])
         call table%add_numbers('critical_slip', 'mm', [pairs%critical_slip, none_s])
         call table%add_numbers('kurtosis', '-', [none_p, surfaces%kurtosis])
         call table%add_texts('note', [(pair_note(pairs(i), .true., .true., .true., .true.), &
            i=1, size(pairs)), surfaces%note])
         call table%check_finite(error)
      end associate
      report%shown_columns = [character(len=24) :: 'kind', 'name', 'eta', 'modulus', 'radius', &
         'hardness', 'yield_factor', 'sigma', 'friction_coefficient', 'critical_slip', 'kurtosis']
      report%first_rows = [1, report%table%rows + 1]
      allocate (report%important(report%table%rows), source=.true.)
   end subroutine run

end module asperity_program_commands_pairs
