!> Solid joints on coarse meshes, runs of them, and steps of Newton's method by hand.
module joint_cases
   use asperity, only: contact_properties, error_type, wp
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_solid_model_equations, only: moved
   use asperity_solid_model_model, only: new_solid_model, solid_model
   use asperity_solid_model_settings, only: solid_settings
   use asperity_solid_solve_programme, only: new_solid_run, run_programme, solid_observer, solid_run
   use contact_cases, only: pair_properties
   use test_petsc_engine, only: petsc
   use funit, only: assertFail
   implicit none
   private
   public :: joint_case, new_joint, run_of, stop_at, stopper, add_unknowns, add_motion

   !> What the tests vary; the rest is the paper's joint.
   type :: joint_case
      character(len=8) :: contact = 'rough', criterion = 'crushing'
      real(wp) :: mesh_size = 100.0_wp, side_pressure = 0.4_wp, column_load = 0.0_wp
      real(wp), allocatable :: amplitudes(:)
      type(solid_settings) :: settings = solid_settings()
   end type joint_case

   !> Stops a run, by an error, after so many increments or strokes.
   type, extends(solid_observer) :: stopper
      integer :: increments = huge(1), strokes = huge(1)
   contains
      procedure :: after_increment, after_stroke
   end type stopper

   !> What a run is stopped with
   character(len=*), parameter :: stop_at = 'stopped by the test'

contains

   subroutine after_increment(self, run, error)
      class(stopper), intent(inout) :: self
      type(solid_run), intent(in) :: run
      type(error_type), allocatable, intent(out) :: error

      if (size(run%records) == self%increments) error = error_type(message=stop_at, subject='')
   end subroutine after_increment

   subroutine after_stroke(self, run, error)
      class(stopper), intent(inout) :: self
      type(solid_run), intent(in) :: run
      type(error_type), allocatable, intent(out) :: error

      if (run%strokes_done == self%strokes) error = error_type(message=stop_at, subject='')
   end subroutine after_stroke

   !> The model of a case: one cycle of each amplitude.
   subroutine new_joint(model, case)
      type(solid_model), intent(out) :: model
      type(joint_case), intent(in) :: case
      type(tenon_deck) :: deck
      type(deck_choice) :: choice
      type(tenon_settings) :: joint
      type(contact_properties) :: faces, sides
      type(error_type), allocatable :: error
      integer :: i

      joint%amplitudes = case%amplitudes
      joint%cycles = [(1, i=1, size(case%amplitudes))]
      joint%side_pressure = case%side_pressure
      joint%column_load = case%column_load
      joint%wood%criterion = case%criterion
      choice%command = ''
      choice%mesh_size = case%mesh_size
      if (case%contact == 'hard') choice%contact = 'hard'
      faces = pair_properties()
      sides = pair_properties(pair='tangential-tangential')
      call new_tenon_deck(deck, choice, joint, default_tenon_sizes(joint), &
         case%settings%stroke_increments, faces, sides, error)
      if (.not. allocated(error)) call new_solid_model(model, deck, case%settings, error)
      if (allocated(error)) call assertFail(error%message)
   end subroutine new_joint

   !> A run of a case, whole or until it is stopped.
   subroutine run_of(run, case, until)
      type(solid_run), intent(out) :: run
      type(joint_case), intent(in) :: case
      type(stopper), intent(in), optional :: until
      type(solid_model) :: model
      type(stopper) :: observer
      type(error_type), allocatable :: error

      call new_joint(model, case)
      call new_solid_run(run, model, petsc, error)
      if (present(until)) observer = until
      call run_programme(run, observer, error)
      if (.not. allocated(error)) return
      if (error%message /= stop_at) call assertFail(error%message)
   end subroutine run_of

   !> Add a vector of the unknowns to the displacements.
   subroutine add_unknowns(model, displacement, step)
      type(solid_model), intent(in) :: model
      real(wp), intent(inout) :: displacement(:, :)
      real(wp), intent(in) :: step(:)
      integer :: i, j

      do j = 1, size(displacement, 2)
         do i = 1, 3
            if (model%numbers(i, j) > 0) displacement(i, j) = displacement(i, j) &
               + step(model%numbers(i, j))
         end do
      end do
   end subroutine add_unknowns

   !> Move the load.
   subroutine add_motion(model, displacement, motion)
      type(solid_model), intent(in) :: model
      real(wp), intent(inout) :: displacement(:, :)
      real(wp), intent(in) :: motion

      where (model%numbers == moved) displacement = displacement + motion
   end subroutine add_motion

end module joint_cases
