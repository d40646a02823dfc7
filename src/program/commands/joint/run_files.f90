!> What a run of a solid writes on its way: checkpoints to go on from, and files for ParaView.
module asperity_program_commands_joint_run_files
   use asperity_base_error, only: error_type
   use asperity_program_commands_solid_checkpoint, only: checkpoint_file, name_checkpoints
   use asperity_program_commands_solid_vtk_files, only: check_vtk_folder
   use asperity_program_input_key, only: kind_place
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_launch, only: launch_type
   use asperity_solid_engine_ranks, only: rank_team
   implicit none
   private
   public :: run_files

   !> Names of the contact models, hard contact first
   character(len=5), parameter :: names(2) = [character(len=5) :: 'hard', 'rough']

   !> The files of the runs of a command.
   type :: run_files
      !> Folder of files for ParaView, empty for none, and stem of the paths of checkpoints
      character(len=:), allocatable :: vtk, stem
      !> Whether to go on from checkpoints
      logical :: resumes = .false.
      !> Checkpoints of the models, to be removed when the results are written
      type(checkpoint_file), allocatable :: checkpoints(:)
   contains
      procedure :: declare, check_folder, find_models, remove
   end type run_files

contains

   !> Their keys.
   pure subroutine declare(self, keys, command)
      !> The files
      class(run_files), intent(inout) :: self
      !> Keys of the command
      type(key_list), intent(inout) :: keys
      !> Its name
      character(len=*), intent(in) :: command

      call keys%text('vtk', self%vtk, &
         'folder in which the end of every stroke is written for ParaView, .vtu and .pvd', &
         kind_place)
      call keys%text('checkpoint', self%stem, 'stem of the files from which a run that '// &
         'was interrupted goes on; '//command//' unless given', kind_place)
      call keys%request('resume', self%resumes, 'go on from the checkpoints of an earlier run')
   end subroutine declare

   !> `error` is set when the folder for ParaView cannot be written into.
   subroutine check_folder(self, launch, error)
      !> The files
      class(run_files), intent(in) :: self
      !> What the launcher says
      type(launch_type), intent(in) :: launch
      !> Set then
      type(error_type), allocatable, intent(out) :: error

      if (self%vtk /= '' .and. launch%rank == 0) call check_vtk_folder(self%vtk, error)
   end subroutine check_folder

   !> The models to be run, 1 for hard contact and 2 for the rough law, and their checkpoints.
   !> `error` is set when these cannot be written, or are there and not to be gone on from.
   subroutine find_models(self, contact, command, keys, ranks, models, error)
      !> The files
      class(run_files), intent(inout) :: self
      !> `hard`, `rough` or `both`; the command
      character(len=*), intent(in) :: contact, command
      !> The input
      type(key_list), intent(in) :: keys
      !> The ranks, of which the first writes
      type(rank_team), intent(in) :: ranks
      !> Result
      integer, allocatable, intent(out) :: models(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      models = pack([1, 2], names == contact .or. contact == 'both')
      allocate (self%checkpoints(size(models)))
      call name_checkpoints(self%checkpoints, self%stem, names(models), command, self%resumes, &
         keys, ranks, error)
   end subroutine find_models

   !> Remove the checkpoints.
   subroutine remove(self)
      !> The files
      class(run_files), intent(in) :: self
      integer :: i

      do i = 1, size(self%checkpoints)
         call self%checkpoints(i)%remove()
      end do
   end subroutine remove

end module asperity_program_commands_joint_run_files
