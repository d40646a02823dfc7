!> `asperity frame`: a plane frame with many tenon joints as one solid, under hard contact and under
!> the rough law.
module asperity_program_commands_frame_command
   use asperity_base_error, only: error_type
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_frame_keys, only: frame_case
   use asperity_program_commands_frame_outcome, only: frame_outcome
   use asperity_program_commands_frame_plots, only: frame_pictures
   use asperity_program_commands_frame_tables, only: frame_increments_table, joints_table
   use asperity_program_commands_joint_remarks, only: analysis_remarks
   use asperity_program_commands_joint_run_files, only: run_files
   use asperity_program_commands_joint_solid_run, only: follow_model, start_solver, stop_solver
   use asperity_program_commands_joint_tables, only: comparison_table, cycles_table, skeleton_table
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_commands_solid_checkpoint, only: checkpoint_file
   use asperity_program_commands_solid_observer, only: run_observer, seconds_of
   use asperity_program_commands_solid_outcome, only: new_outcome, solid_outcome
   use asperity_program_commands_solid_tables, only: amplitudes_table, sizes_table, &
      times_table
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: named_table, report_type, turning_points
   use asperity_program_system_progress, only: clear_steps
   use asperity_solid_engine_petsc, only: petsc_library
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: solid_run
   implicit none
   private
   public :: frame_command

   !> Runs the frame.
   type, extends(command_type) :: frame_command
      private
      type(frame_case) :: case
      type(run_files) :: files
   contains
      procedure :: describe, declare, check, run, finish
   end type frame_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(frame_command), intent(inout) :: self

      self%name = 'frame'
      self%uses_ranks = .true.
      self%summary = 'plane frame with many tenon joints as one solid'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Finite-element analysis of a plane frame of columns and of beams that '// &
         'pass through them, all joints by the code of asperity solid. The heads sway '// &
         'together; base shear, and moment, rotation and energy of each joint come out.'
   end subroutine describe

   !> Case, mesh, solver and outputs.
   pure subroutine declare(self, keys)
      !> The command
      class(frame_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%case%declare(keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call self%files%declare(keys, 'frame')
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the case.
   subroutine check(self, error)
      !> The command
      class(frame_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      call self%case%check(error)
   end subroutine check

   !> Run the models. `error` is set when a setting is refused, the engine is missing, or no
   !> increment is small enough.
   subroutine run(self, report, error)
      !> The command
      class(frame_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(petsc_library) :: petsc

      call self%declare(report%keys)
      report%faces = self%case%joints%joint%faces%words()
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
      class(frame_command), intent(inout) :: self
      !> Never set
      type(error_type), allocatable, intent(out) :: error

      call self%files%remove()
   end subroutine finish

   !> Run what is asked for and report it.
   subroutine report_models(self, petsc, report, error)
      class(frame_command), intent(inout) :: self
      type(petsc_library), intent(in) :: petsc
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(frame_outcome), allocatable :: outcomes(:)
      integer, allocatable :: models(:)
      integer :: i

      call self%files%find_models(self%case%joints%contact, 'frame', report%keys, petsc%ranks, &
         models, error)
      allocate (outcomes(size(models)))
      do i = 1, size(models)
         if (.not. allocated(error)) call run_model(self, petsc, models(i) == 1, &
            self%files%checkpoints(i), outcomes(i), error)
         call clear_steps()
         call petsc%ranks%agree(error)
      end do
      if (allocated(error) .or. petsc%ranks%rank > 0) return
      call fill_report(report, outcomes, self%case%joints%joint%faces%has_memory, error)
   end subroutine report_models

   !> Run one model.
   subroutine run_model(self, petsc, is_hard, checkpoint, outcome, error)
      class(frame_command), intent(in) :: self
      type(petsc_library), intent(in) :: petsc
      logical, intent(in) :: is_hard
      type(checkpoint_file), intent(in) :: checkpoint
      type(frame_outcome), intent(out) :: outcome
      type(error_type), allocatable, intent(out) :: error
      type(solid_model), allocatable :: model
      type(solid_run), allocatable :: run
      type(run_observer) :: observer

      allocate (model, run)
      call self%case%new_model(is_hard, model, error)
      call petsc%ranks%agree(error)
      if (.not. allocated(error)) call follow_model(run, observer, model, petsc, 'frame', &
         self%files, checkpoint, error)
      if (allocated(error)) return
      call new_outcome(outcome%whole, run, observer%snapshots, seconds_of(observer), error)
      call move_alloc(run%joints, outcome%joints)
   end subroutine run_model

   !> All tables, pictures and remarks. `error` is set when a number is not finite.
   subroutine fill_report(report, outcomes, has_memory, error)
      type(report_type), intent(inout) :: report
      type(frame_outcome), intent(in) :: outcomes(:)
      logical, intent(in) :: has_memory
      type(error_type), allocatable, intent(out) :: error
      type(solid_outcome), allocatable :: whole(:)
      integer :: i

      allocate (whole(size(outcomes)))
      do i = 1, size(outcomes)
         whole(i) = outcomes(i)%whole
      end do
      report%table = frame_increments_table(outcomes, has_memory)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%summary = comparison_table(whole, .false.)
      report%more = [ &
         named_table('by_amplitude', 'Base shear, first cycle of each amplitude', &
         amplitudes_table(whole)), &
         named_table('joints', 'Joints', joints_table(outcomes)), &
         named_table('cycles', 'Cycles of base shear times height of the columns', &
         cycles_table(whole), 2 + 5*size(whole)), &
         named_table('skeleton', '', skeleton_table(whole)), &
         named_table('analysis', 'Analysis', sizes_table(whole)), &
         named_table('times', '', times_table(whole))]
      report%remarks = analysis_remarks(whole)
      report%shows_table = .false.
      report%first_rows = [1]
      allocate (report%important(0))
      do i = 1, size(whole)
         associate (records => whole(i)%records)
            report%first_rows = [report%first_rows, report%first_rows(i) + size(records)]
            report%important = [report%important, turning_points((records%displacement))]
         end associate
      end do
      if (.not. report%is_drawn()) return
      report%pictures = frame_pictures(outcomes)
      report%picture_title = picture_title(report, 'Frame')
   end subroutine fill_report

end module asperity_program_commands_frame_command
