!> What comes out of the analysis of a solid joint with one contact model.
module asperity_program_commands_solid_outcome
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_loops, only: analyse_loops, hard, joint_loops, rough
   use asperity_program_commands_solid_snapshot, only: solid_snapshot
   use asperity_solid_mesh_joint, only: solid_mesh
   use asperity_solid_solve_programme, only: solid_run
   use asperity_solid_solve_record, only: increment_record
   use asperity_solid_solve_times, only: run_times
   implicit none
   private
   public :: solid_outcome, new_outcome, common_snapshots

   !> One contact model, through the whole programme.
   type, extends(joint_loops) :: solid_outcome
      !> Every increment of the strokes
      type(increment_record), allocatable :: records(:)
      !> States that were kept
      type(solid_snapshot), allocatable :: snapshots(:)
      !> Names of the pairs of faces
      character(len=8), allocatable :: pairs(:)
      !> Nodes and elements
      type(solid_mesh) :: mesh
      !> Unknowns; increments, iterations and increments that were halved, with those before the
      !> strokes
      integer :: unknowns = 0, increments = 0, iterations = 0, cutbacks = 0
      !> Ranks that shared the work, and where the time of the slowest went
      integer :: ranks = 1
      type(run_times) :: times
      !> Factorisations of the matrix, or sets of levels, and vectors of GMRES
      integer :: factorisations = 0, vectors = 0
      !> How often multigrid has not converged, so that factors took its place
      integer :: multigrid_failures = 0
      !> Distance of the load from the column face, mm
      real(wp) :: arm = 0.0_wp
      !> Forces below this are none, N
      real(wp) :: small_force = 0.0_wp
      !> Whether strain is logarithmic, which bears what is large
      logical :: is_logarithmic = .false.
   end type solid_outcome

contains

   !> What came out of a run that is done. `error` is set when its loops cannot be analysed.
   pure subroutine new_outcome(outcome, run, snapshots, seconds, error)
      !> Result
      type(solid_outcome), intent(out) :: outcome
      !> The run
      type(solid_run), intent(in) :: run
      !> States that were kept
      type(solid_snapshot), intent(in) :: snapshots(:)
      !> Time that it took, s
      real(wp), intent(in) :: seconds
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      associate (model => run%model)
         outcome%model = merge(hard, rough, model%is_hard)
         allocate (outcome%records, source=run%records)
         allocate (outcome%snapshots, source=snapshots)
         allocate (outcome%pairs(size(model%pairs)))
         do i = 1, size(model%pairs)
            outcome%pairs(i) = model%pairs(i)%name
         end do
         outcome%mesh = model%mesh
         outcome%unknowns = model%n_unknowns
         outcome%arm = model%arm
         outcome%small_force = model%small_force
         outcome%is_logarithmic = model%settings%is_logarithmic
      end associate
      outcome%increments = run%increments
      outcome%iterations = run%iterations
      outcome%cutbacks = run%cutbacks
      outcome%seconds = seconds
      outcome%times = run%system%times
      associate (solver => run%system%solver)
         outcome%ranks = solver%petsc%ranks%size
         outcome%factorisations = solver%n_factorisations
         outcome%vectors = solver%n_vectors
         outcome%multigrid_failures = solver%n_multigrid_failures
      end associate
      call find_loops(outcome, error)
   end subroutine new_outcome

   !> Loops of moment against displacement over arm, from the joint at rest.
   pure subroutine find_loops(outcome, error)
      type(solid_outcome), intent(inout) :: outcome
      type(error_type), allocatable, intent(out) :: error

      associate (r => outcome%records)
         outcome%rotation_name = 'drift'
         outcome%has_moment = any(abs(r%force) > outcome%small_force)
         call analyse_loops(outcome, [0.0_wp, r%displacement/outcome%arm], &
            [0.0_wp, outcome%arm*r%force], .false., error)
      end associate
   end subroutine find_loops

   !> Kinds of the states that all models have kept, in the order of time.
   pure function common_snapshots(outcomes) result(kinds)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      integer, allocatable :: kinds(:)
      integer :: i, j

      kinds = outcomes(1)%snapshots%kind
      do i = 2, size(outcomes)
         kinds = pack(kinds, [(any(outcomes(i)%snapshots%kind == kinds(j)), j=1, size(kinds))])
      end do
   end function common_snapshots

end module asperity_program_commands_solid_outcome
