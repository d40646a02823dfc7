!> The equations of one state of a joint, and the pattern of their matrix.
module asperity_solid_solve_equations
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_pair, only: foresee_pattern
   use asperity_solid_engine_linear_solver, only: linear_solver
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_model_rigid_motions, only: rigid_motions
   use asperity_solid_solve_pattern, only: block_list, block_places, find_pattern
   use asperity_solid_solve_times, only: run_times, seconds_now
   implicit none
   private
   public :: equation_system, load_state, has_grown, renew_pattern

   !> What acts on the joint.
   type :: load_state
      !> Share of the column's load, and of the swelling
      real(wp) :: column = 0.0_wp, swelling = 0.0_wp
   end type load_state

   !> Equations of one state.
   type :: equation_system
      !> Matrix and its solver
      type(linear_solver) :: solver
      !> Where the matrices of this rank's elements go, then those of its slave faces, pair by pair,
      !> and on the first rank those of the springs
      type(block_places), allocatable :: places(:)
      !> Internal less external forces, N
      real(wp), allocatable :: residual(:)
      !> Derivative of the residual by the motion of the load, N/mm
      real(wp), allocatable :: by_motion(:)
      !> Force of the half joint at the load, N, and size of the forces by which residuals are
      !> measured, N
      real(wp) :: load_force = 0.0_wp, scale = 0.0_wp
      !> Points of elements that yield
      integer :: n_yielding = 0
      !> Whether elements have turned inside out: the state is none
      logical :: is_inverted = .false.
      !> Where the time went
      type(run_times) :: times
   end type equation_system

contains

   !> Whether a face of any rank has met nodes that the pattern does not know.
   logical function has_grown(system, model)
      !> The equations
      type(equation_system), intent(in) :: system
      !> The joint
      type(solid_model), intent(in) :: model

      has_grown = system%solver%petsc%ranks%any(any(model%pairs%has_grown))
   end function has_grown

   !> A pattern for the present contact. Values and factors are gone.
   subroutine renew_pattern(system, model, error)
      !> The equations
      type(equation_system), intent(inout) :: system
      !> The joint
      type(solid_model), intent(inout) :: model
      !> Set when the engine fails
      type(error_type), allocatable, intent(out) :: error
      type(block_list), allocatable :: blocks(:)
      integer, allocatable :: row_start(:), columns(:)
      real(wp), allocatable :: motions(:, :)
      real(wp) :: began
      integer :: i, j, n, springs

      began = seconds_now()
      springs = 0
      if (system%solver%petsc%ranks%rank == 0) springs = size(model%springs)
      n = size(model%own_elements)
      do i = 1, size(model%pairs)
         call foresee_pattern(model%pairs(i))
         n = n + size(model%pairs(i)%own)
      end do
      allocate (blocks(n + springs))
      n = size(model%own_elements)
      do i = 1, n
         associate (nodes => model%mesh%elements(:, model%own_elements(i)))
            blocks(i)%numbers = reshape(model%numbers(:, nodes), [24])
         end associate
      end do
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%own)
            n = n + 1
            associate (nodes => model%pairs(i)%faces(model%pairs(i)%own(j))%nodes)
               blocks(n)%numbers = reshape(model%numbers(:, nodes), [3*size(nodes)])
            end associate
         end do
      end do
      do i = 1, springs
         associate (spring => model%springs(i))
            blocks(n + i)%numbers = [model%numbers(spring%direction, spring%node)]
         end associate
      end do
      model%pairs%has_grown = .false.
      call find_pattern(model%n_unknowns, blocks, row_start, columns, system%places)
      if (model%settings%uses_multigrid) &
         motions = rigid_motions(model%mesh%nodes, model%numbers, model%n_unknowns)
      call system%solver%set_pattern(row_start, columns, model%first_rows, error, motions)
      system%times%patterns = system%times%patterns + seconds_now() - began
   end subroutine renew_pattern

end module asperity_solid_solve_equations
