!> Residual and tangent of the whole joint: elements, contact, springs, column load.
module asperity_solid_solve_assembly
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_pair, only: foresee_pattern
   use asperity_solid_contact_response, only: face_response
   use asperity_solid_element_brick, only: brick_response
   use asperity_solid_engine_linear_solver, only: linear_solver
   use asperity_solid_model_equations, only: moved
   use asperity_solid_model_model, only: solid_model
   use asperity_solid_solve_pattern, only: block_list, block_places, find_pattern
   implicit none
   private
   public :: equation_system, load_state, assemble

   !> What acts on the joint.
   type :: load_state
      !> Share of the column's load, and of the swelling
      real(wp) :: column = 0.0_wp, swelling = 0.0_wp
   end type load_state

   !> Equations of one state.
   type :: equation_system
      !> Matrix and its solver
      type(linear_solver) :: solver
      !> Where the matrices of elements go, then those of slave faces, pair by pair
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
   end type equation_system

contains

   !> Residual and, if wanted, tangent of a state. The pattern is renewed when points have met faces
   !> that it does not know.
   subroutine assemble(system, model, displacement, load, wants_tangent, error)
      !> Result
      type(equation_system), intent(inout) :: system
      !> The joint, whose trial states are set
      type(solid_model), intent(inout) :: model
      !> Displacements of all nodes, mm
      real(wp), intent(in) :: displacement(:, :)
      !> What acts
      type(load_state), intent(in) :: load
      !> Whether the matrix is wanted
      logical, intent(in) :: wants_tangent
      !> Set when the engine fails
      type(error_type), allocatable, intent(out) :: error

      do
         if (wants_tangent) then
            if (any(model%pairs%has_grown) .or. .not. associated(system%solver%values)) &
               call renew_pattern(system, model, error)
            if (allocated(error)) return
            system%solver%values = 0.0_wp
            system%by_motion = 0.0_wp
         end if
         call add_all(system, model, displacement, load, wants_tangent, error)
         if (allocated(error)) return
         if (.not. (wants_tangent .and. any(model%pairs%has_grown)) .or. system%is_inverted) exit
      end do
   end subroutine assemble

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
      integer :: i, j, n

      n = size(model%mesh%elements, 2)
      do i = 1, size(model%pairs)
         call foresee_pattern(model%pairs(i))
         n = n + size(model%pairs(i)%faces)
      end do
      allocate (blocks(n))
      n = size(model%mesh%elements, 2)
      do i = 1, n
         blocks(i)%numbers = reshape(model%numbers(:, model%mesh%elements(:, i)), [24])
      end do
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%faces)
            n = n + 1
            associate (nodes => model%pairs(i)%faces(j)%nodes)
               blocks(n)%numbers = reshape(model%numbers(:, nodes), [3*size(nodes)])
            end associate
         end do
      end do
      model%pairs%has_grown = .false.
      call find_pattern(model%n_unknowns, blocks, row_start, columns, system%places)
      call system%solver%set_pattern(row_start, columns, error)
   end subroutine renew_pattern

   !> All that acts.
   subroutine add_all(system, model, displacement, load, wants_tangent, error)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: displacement(:, :)
      type(load_state), intent(in) :: load
      logical, intent(in) :: wants_tangent
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: positions(3, size(displacement, 2)), forces(3, size(displacement, 2))
      integer :: i, j

      positions = model%mesh%nodes + displacement
      forces = 0.0_wp
      call add_contact(system, model, positions, forces, wants_tangent, error)
      if (allocated(error)) return
      system%scale = norm2(forces)
      call add_elements(system, model, positions, load%swelling, forces, wants_tangent)
      call add_spring(1, model%mesh%axial_node, model%axial_stiffness)
      call add_spring(3, model%mesh%hold_node, model%holding_stiffness)
      system%residual = 0.0_wp
      system%load_force = 0.0_wp
      do j = 1, size(forces, 2)
         do i = 1, 3
            if (model%numbers(i, j) > 0) then
               system%residual(model%numbers(i, j)) = system%residual(model%numbers(i, j)) &
                  + forces(i, j)
            else if (model%numbers(i, j) == moved) then
               system%load_force = system%load_force + forces(i, j)
            end if
         end do
      end do
      associate (level => model%numbers(3, model%mesh%head(1)))
         system%residual(level) = system%residual(level) + load%column*model%column_load
      end associate
      system%scale = system%scale + abs(system%load_force) + model%small_force

   contains

      !> A spring to ground.
      subroutine add_spring(direction, node, stiffness)
         integer, intent(in) :: direction, node
         real(wp), intent(in) :: stiffness
         integer :: k, number

         forces(direction, node) = forces(direction, node) + stiffness*displacement(direction, node)
         number = model%numbers(direction, node)
         if (number < 1 .or. .not. wants_tangent) return
         associate (solver => system%solver)
            do k = solver%row_start(number) + 1, solver%row_start(number + 1)
               if (solver%columns(k) == number - 1) solver%values(k) = solver%values(k) + stiffness
            end do
         end associate
      end subroutine add_spring

   end subroutine add_all

   !> Elements.
   subroutine add_elements(system, model, positions, swelling, forces, wants_tangent)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: positions(:, :), swelling
      real(wp), intent(inout) :: forces(:, :)
      logical, intent(in) :: wants_tangent
      real(wp) :: at_nodes(3, 8), tangent(24, 24), eigenstrain(6, 2)
      integer :: i, n_yielding
      logical :: is_inverted

      eigenstrain = 0.0_wp
      eigenstrain(2, 2) = swelling*model%swelling
      system%n_yielding = 0
      system%is_inverted = .false.
      do i = 1, size(model%mesh%elements, 2)
         associate (nodes => model%mesh%elements(:, i), part => model%mesh%part(i), &
               shape => model%shapes(model%shape_of(i)))
            if (wants_tangent) then
               call brick_response(shape, model%wood(part), positions(:, nodes), &
                  eigenstrain(:, part), model%points(:, i), model%trial_points(:, i), at_nodes, &
                  n_yielding, tangent, is_inverted)
               call add_block(system, model, nodes, system%places(i)%at, tangent)
            else
               call brick_response(shape, model%wood(part), positions(:, nodes), &
                  eigenstrain(:, part), model%points(:, i), model%trial_points(:, i), at_nodes, &
                  n_yielding, inverted=is_inverted)
            end if
            if (is_inverted) then
               system%is_inverted = .true.
               return
            end if
            forces(:, nodes) = forces(:, nodes) + at_nodes
            system%n_yielding = system%n_yielding + n_yielding
         end associate
      end do
   end subroutine add_elements

   !> Slave faces.
   subroutine add_contact(system, model, positions, forces, wants_tangent, error)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: positions(:, :)
      real(wp), intent(inout) :: forces(:, :)
      logical, intent(in) :: wants_tangent
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: at_nodes(:, :), tangent(:, :)
      integer :: i, j, n

      n = size(model%mesh%elements, 2)
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%faces)
            n = n + 1
            if (wants_tangent) then
               call face_response(model%pairs(i), j, positions, at_nodes, error, tangent)
            else
               call face_response(model%pairs(i), j, positions, at_nodes, error)
            end if
            if (allocated(error)) return
            associate (nodes => model%pairs(i)%faces(j)%nodes)
               forces(:, nodes) = forces(:, nodes) + at_nodes
               if (.not. wants_tangent .or. model%pairs(i)%has_grown) cycle
               call add_block(system, model, nodes, system%places(n)%at, tangent)
            end associate
         end do
      end do
   end subroutine add_contact

   !> A small matrix into the large one; columns of what is moved, into their sum.
   subroutine add_block(system, model, nodes, at, block)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(in) :: model
      integer, intent(in) :: nodes(:), at(:, :)
      real(wp), intent(in) :: block(:, :)
      integer :: i, j, number, numbers(3*size(nodes))

      numbers = reshape(model%numbers(:, nodes), [3*size(nodes)])
      do j = 1, size(numbers)
         number = numbers(j)
         if (number > 0) then
            do i = 1, size(numbers)
               if (at(i, j) > 0) system%solver%values(at(i, j)) = &
                  system%solver%values(at(i, j)) + block(i, j)
            end do
         else if (number == moved) then
            do i = 1, size(numbers)
               if (numbers(i) > 0) &
                  system%by_motion(numbers(i)) = system%by_motion(numbers(i)) + block(i, j)
            end do
         end if
      end do
   end subroutine add_block

end module asperity_solid_solve_assembly
