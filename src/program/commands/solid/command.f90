!> `asperity solid`: the tenon joint as a solid of plastic wood, through the whole programme, under
!> hard contact and under the rough law.
module asperity_program_commands_solid_command
   use asperity_base_error, only: error_type
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_joint_run_files, only: run_files
   use asperity_program_commands_joint_solid_run, only: follow_model, start_solver, stop_solver
   use asperity_program_commands_opensees_joint, only: add_joint_material, check_history
   use asperity_program_commands_opensees_output, only: opensees_output
   use asperity_program_commands_solid_checkpoint, only: checkpoint_file
   use asperity_program_commands_solid_keys, only: solid_case
   use asperity_program_commands_solid_observer, only: run_observer, seconds_of
   use asperity_program_commands_solid_outcome, only: new_outcome, solid_outcome
   use asperity_program_commands_solid_page, only: solid_page
   use asperity_program_commands_solid_report, only: fill_report
   use asperity_program_commands_tenon_history, only: follow_history, history_type, read_history
   use asperity_program_commands_tenon_paper_joint, only: is_paper_joint
   use asperity_program_input_key, only: kind_picture
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_progress, only: clear_steps
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   use asperity_solid_engine_petsc, only: petsc_library
   use asperity_solid_mesh_checks, only: mesh_remark
   use asperity_solid_model_model, only: new_solid_model, solid_model
   use asperity_solid_solve_programme, only: solid_run
   implicit none
   private
   public :: solid_command

   !> Runs the joint.
   type, extends(command_type) :: solid_command
      private
      type(solid_case) :: case
      !> Path of the page
      character(len=:), allocatable :: page
      type(run_files) :: files
      !> Material for a frame program
      type(opensees_output) :: opensees
   contains
      procedure :: describe, declare, check, run, finish
   end type solid_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(solid_command), intent(inout) :: self

      self%name = 'solid'
      self%uses_ranks = .true.
      self%summary = 'tenon joint as a solid of plastic wood, hard against rough'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Finite-element analysis of the straight tenon joint, as the paper''s: '// &
         'orthotropic, plastic wood under the whole cyclic programme, hard contact against the '// &
         'rough law (Figs 19-35, Table 5). It takes the case of asperity tenon.'
   end subroutine describe

   !> Case, mesh, solver and outputs.
   pure subroutine declare(self, keys)
      !> The command
      class(solid_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%case%declare(keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call keys%text('report', self%page, &
         'write a page of case, tables and pictures, .html (needs gnuplot)', kind_picture)
      call self%files%declare(keys, 'solid')
      call self%opensees%declare(keys)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the case.
   subroutine check(self, error)
      !> The command
      class(solid_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      call self%case%joint%check(error, compiled=.true.)
      if (.not. allocated(error)) call self%opensees%check(error)
   end subroutine check

   !> Run the models. `error` is set when a setting is refused, the engine is missing, or no
   !> increment is small enough.
   subroutine run(self, report, error)
      !> The command
      class(solid_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(history_type) :: history
      type(petsc_library) :: petsc

      call read_history(history, self%case%joint, error)
      if (.not. allocated(error)) call follow_history(self%case%joint%joint, history, error)
      if (.not. allocated(error)) call check_history(self%opensees, self%case%joint%joint, error)
      if (allocated(error)) return
      call self%declare(report%keys)
      report%faces = self%case%joint%faces%words()
      call self%files%check_folder(self%launch, error)
      if (allocated(error)) return
      call start_solver(petsc, self%launch, error)
      if (allocated(error)) return
      call report_models(self, petsc, report, error)
      call stop_solver(petsc, error)
   end subroutine run

   !> Remove the checkpoints.
   subroutine finish(self, error)
      !> The command
      class(solid_command), intent(inout) :: self
      !> Never set
      type(error_type), allocatable, intent(out) :: error

      call self%files%remove()
   end subroutine finish

   !> Run what is asked for and report it.
   subroutine report_models(self, petsc, report, error)
      class(solid_command), intent(inout) :: self
      type(petsc_library), intent(in) :: petsc
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(solid_outcome), allocatable :: outcomes(:)
      integer, allocatable :: models(:)
      type(string_type) :: line
      logical :: beside_paper
      integer :: i

      call self%files%find_models(self%case%contact, 'solid', report%keys, petsc%ranks, models, &
         error)
      if (allocated(error)) return
      allocate (outcomes(size(models)))
      line%text = ''
      do i = 1, size(models)
         call run_model(self, petsc, models(i), self%files%checkpoints(i), outcomes(i), line%text, &
            error)
         call clear_steps()
         call petsc%ranks%agree(error)
         if (allocated(error)) return
      end do
      if (petsc%ranks%rank > 0) return
      beside_paper = is_paper_joint(self%case%joint)
      call fill_report(report, outcomes, self%case%joint%faces%has_memory, beside_paper, error)
      if (.not. allocated(error)) &
         call add_joint_material(self%opensees, report, outcomes, error)
      if (allocated(error)) return
      if (line%text /= '') call report%add_remark(line%text)
      if (self%page /= '') report%page = page_of(self, report, beside_paper)
   end subroutine report_models

   !> Run one model.
   subroutine run_model(self, petsc, which, checkpoint, outcome, remark, error)
      class(solid_command), intent(in) :: self
      type(petsc_library), intent(in) :: petsc
      integer, intent(in) :: which
      type(checkpoint_file), intent(in) :: checkpoint
      type(solid_outcome), intent(out) :: outcome
      character(len=:), allocatable, intent(inout) :: remark
      type(error_type), allocatable, intent(out) :: error
      type(tenon_deck), allocatable :: deck
      type(solid_model), allocatable :: model
      type(solid_run), allocatable :: run
      type(run_observer) :: observer

      allocate (deck, model, run)
      call self%case%deck_of(which == 1, deck, error)
      if (.not. allocated(error)) call new_solid_model(model, deck, self%case%settings, error)
      call petsc%ranks%agree(error)
      if (allocated(error)) return
      if (remark == '') remark = trim(mesh_remark(deck))
      call follow_model(run, observer, model, petsc, 'solid', self%files, checkpoint, error)
      if (.not. allocated(error)) &
         call new_outcome(outcome, run, observer%snapshots, seconds_of(observer), error)
   end subroutine run_model

   !> The page.
   function page_of(self, report, beside_paper) result(parts)
      class(solid_command), intent(in) :: self
      type(report_type), intent(in) :: report
      logical, intent(in) :: beside_paper
      type(string_type), allocatable :: parts(:)
      type(solid_case) :: usual_case
      type(opensees_output) :: usual_output
      type(key_list) :: usual
      type(tenon_settings) :: joint

      call usual_case%declare(usual)
      call usual_output%declare(usual)
      joint = self%case%joint%joint
      call complete_tenon_settings(joint)
      parts = solid_page(report, joint, usual, beside_paper)
   end function page_of

end module asperity_program_commands_solid_command
