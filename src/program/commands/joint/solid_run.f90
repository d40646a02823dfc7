!> A solid, of one joint or a frame, taken through its programme: from a checkpoint or from the
!> start, with files for ParaView, and with what is left behind where it fails.
module asperity_program_commands_joint_solid_run
   use asperity_base_error, only: computation_error, error_type
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_joint_loops, only: hard, legends, rough
   use asperity_program_commands_joint_run_files, only: run_files
   use asperity_program_commands_replay_failed_point, only: keep_failed_point
   use asperity_program_commands_solid_checkpoint, only: checkpoint_file, is_there
   use asperity_program_commands_solid_observer, only: new_observer, run_observer, seconds_of
   use asperity_program_commands_solid_vtk_files, only: write_vtk_series
   use asperity_program_system_launch, only: check_launch, launch_type
   use asperity_program_system_progress, only: tell_terminal
   use asperity_solid_contact_failed_point, only: failed_point, find_failed_point, keep_motions
   use asperity_solid_engine_petsc, only: load_petsc, petsc_library, unload_petsc
   use asperity_solid_engine_ranks, only: rank_team
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_run
   use asperity_solid_solve_times, only: take_slowest
   implicit none
   private
   public :: start_solver, stop_solver, follow_model

contains

   !> Start PETSc, and MPI with it. `error` is set when it is not installed, or has not joined the
   !> ranks that the launcher has started.
   subroutine start_solver(petsc, launch, error)
      !> Result
      type(petsc_library), intent(out) :: petsc
      !> What the launcher says
      type(launch_type), intent(in) :: launch
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      call load_petsc(petsc, error)
      if (allocated(error)) return
      call check_launch(launch, petsc%ranks%rank, petsc%ranks%size, error)
      if (allocated(error)) call unload_petsc(petsc)
   end subroutine start_solver

   !> Stop it. An error, which all ranks know of, is left to the first one, which tells it.
   subroutine stop_solver(petsc, error)
      !> PETSc
      type(petsc_library), intent(in) :: petsc
      !> What has failed, if anything
      type(error_type), allocatable, intent(inout) :: error

      call unload_petsc(petsc)
      if (allocated(error) .and. petsc%ranks%rank > 0) deallocate (error)
   end subroutine stop_solver

   !> Follow a model. `error` is set when no increment is small enough, or a file cannot be written.
   subroutine follow_model(run, observer, model, petsc, command, files, checkpoint, error)
      !> The run, and who watched it
      type(solid_run), intent(out) :: run
      type(run_observer), intent(out) :: observer
      !> The model, given up once the run has it
      type(solid_model), allocatable, intent(inout) :: model
      !> PETSc, loaded
      type(petsc_library), intent(in) :: petsc
      !> The command
      character(len=*), intent(in) :: command
      !> What it writes on its way, and where this run is kept
      type(run_files), intent(in) :: files
      type(checkpoint_file), intent(in) :: checkpoint
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer :: which

      which = merge(hard, rough, model%is_hard)
      call new_solid_run(run, model, petsc, error)
      if (allocated(error)) return
      deallocate (model)
      call new_observer(observer, command//': '//trim(legends(which)), checkpoint, files%vtk, &
         petsc%ranks%rank == 0)
      call begin(files%resumes, checkpoint, run, observer, error)
      call petsc%ranks%agree(error)
      if (allocated(error)) return
      call run_programme(run, observer, error)
      if (allocated(error)) then
         call keep_point(error, run%model, petsc%ranks)
         if (is_there(checkpoint%path)) error%message = error%message//'. It begins again from '// &
            checkpoint%path//' with --resume'
         return
      end if
      call take_slowest(run%system%times, petsc%ranks)
      if (.not. observer%is_first) return
      if (files%vtk /= '') call write_vtk_series(files%vtk, run, error)
      if (allocated(error)) return
      call tell_terminal(observer%name//': '//to_text(run%increments)//' increments, '// &
         to_text(run%iterations)//' iterations, '//to_text(seconds_of(observer), 3)//' s')
   end subroutine follow_model

   !> Go on from a checkpoint, if there is one and it is asked for, else from the start.
   subroutine begin(resumes, checkpoint, run, observer, error)
      logical, intent(in) :: resumes
      type(checkpoint_file), intent(in) :: checkpoint
      type(solid_run), intent(inout) :: run
      type(run_observer), intent(inout) :: observer
      type(error_type), allocatable, intent(out) :: error

      if (is_there(checkpoint%path) .and. resumes) then
         call checkpoint%load(run, observer%snapshots, observer%seconds_before, error)
      else
         call keep_motions(run%model%pairs)
      end if
   end subroutine begin

   !> Keep the motion of the contact point at which an increment failed, if UINTER can be led along.
   subroutine keep_point(error, model, ranks)
      type(error_type), intent(inout) :: error
      type(solid_model), intent(inout) :: model
      type(rank_team), intent(in) :: ranks
      type(failed_point) :: failed

      if (error%category /= computation_error .or. model%is_hard) return
      call find_failed_point(model%pairs, failed, ranks)
      ! one tells and writes
      if (ranks%rank > 0) return
      if (failed%pair > 0) then
         call keep_failed_point(error, failed%path, failed%properties, trim(failed%words))
      else if (.not. failed%is_known) then
         error%message = error%message//'; no motion of a point is left (resumed, or no memory)'
      end if
   end subroutine keep_point

end module asperity_program_commands_joint_solid_run
