!> Residual and tangent of the whole joint: elements, contact, springs, column load. Each rank adds
!> up its elements and slave faces; forces are then summed over the ranks, and are whole on all.
module asperity_solid_solve_assembly
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_response, only: face_response
   use asperity_solid_element_brick, only: brick_response
   use asperity_solid_mesh_joint, only: n_parts, part_beam
   use asperity_solid_model_equations, only: moved
   use asperity_solid_model_model, only: ground_spring, solid_model
   use asperity_solid_solve_equations, only: equation_system, has_grown, load_state, renew_pattern
   use asperity_solid_solve_times, only: seconds_now
   implicit none
   private
   public :: assemble

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
            if (has_grown(system, model) .or. .not. associated(system%solver%values)) &
               call renew_pattern(system, model, error)
            if (allocated(error)) return
            system%solver%values = 0.0_wp
            system%by_motion = 0.0_wp
         end if
         call add_all(system, model, displacement, load, wants_tangent, error)
         if (allocated(error)) return
         if (system%is_inverted .or. .not. wants_tangent) exit
         if (.not. has_grown(system, model)) exit
      end do
   end subroutine assemble

   !> All that acts.
   subroutine add_all(system, model, displacement, load, wants_tangent, error)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: displacement(:, :)
      type(load_state), intent(in) :: load
      logical, intent(in) :: wants_tangent
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: positions(3, size(displacement, 2)), forces(3, size(displacement, 2)), &
         sums(3, size(displacement, 2))
      integer :: i, j

      positions = model%mesh%nodes + displacement
      forces = 0.0_wp
      call add_contact(system, model, positions, forces, wants_tangent, error)
      call system%solver%petsc%ranks%agree(error)
      if (allocated(error)) return
      sums = forces
      call sum_over_ranks(system, sums)
      system%scale = norm2(sums)
      call add_elements(system, model, displacement, load%swelling, forces, wants_tangent)
      call sum_over_ranks(system, forces, wants_tangent)
      if (system%is_inverted) return
      do i = 1, size(model%springs)
         call add_spring(model%springs(i), size(model%springs) - i)
      end do
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
      do i = 1, size(model%column_loads)
         associate (level => model%numbers(3, model%mesh%heads(i)%nodes(1)))
            system%residual(level) = system%residual(level) + load%column*model%column_loads(i)
         end associate
      end do
      system%scale = system%scale + abs(system%load_force) + model%small_force

   contains

      !> A spring to ground.
      subroutine add_spring(spring, behind)
         type(ground_spring), intent(in) :: spring
         !> How many blocks stand behind its own in the pattern, which the first rank has
         integer, intent(in) :: behind

         forces(spring%direction, spring%node) = forces(spring%direction, spring%node) &
            + spring%stiffness*displacement(spring%direction, spring%node)
         if (.not. wants_tangent .or. system%solver%petsc%ranks%rank > 0) return
         associate (at => system%places(size(system%places) - behind)%at(1, 1))
            if (at > 0) system%solver%values(at) = system%solver%values(at) + spring%stiffness
         end associate
      end subroutine add_spring

   end subroutine add_all

   !> Forces of all ranks, and, at the end of an assembly, all else that they have found.
   subroutine sum_over_ranks(system, forces, wants_tangent)
      type(equation_system), intent(inout) :: system
      real(wp), intent(inout) :: forces(:, :)
      logical, intent(in), optional :: wants_tangent
      real(wp) :: began, counts(2)

      if (system%solver%petsc%ranks%size == 1) return
      began = seconds_now()
      associate (ranks => system%solver%petsc%ranks)
         call ranks%sum(forces)
         if (present(wants_tangent)) then
            if (wants_tangent) call ranks%sum(system%by_motion)
            counts = [real(system%n_yielding, wp), merge(1.0_wp, 0.0_wp, system%is_inverted)]
            call ranks%sum(counts)
            system%n_yielding = nint(counts(1))
            system%is_inverted = counts(2) > 0.5_wp
         end if
      end associate
      system%times%exchange = system%times%exchange + seconds_now() - began
   end subroutine sum_over_ranks

   !> Elements.
   subroutine add_elements(system, model, displacement, swelling, forces, wants_tangent)
      type(equation_system), intent(inout) :: system
      type(solid_model), intent(inout) :: model
      real(wp), intent(in) :: displacement(:, :), swelling
      real(wp), intent(inout) :: forces(:, :)
      logical, intent(in) :: wants_tangent
      real(wp) :: corners(3, 8), at_nodes(3, 8), tangent(24, 24), eigenstrain(6, n_parts), began
      integer :: i, k, n_yielding
      logical :: is_inverted

      began = seconds_now()
      eigenstrain = 0.0_wp
      eigenstrain(2, part_beam) = swelling*model%swelling
      system%n_yielding = 0
      system%is_inverted = .false.
      do k = 1, size(model%own_elements)
         i = model%own_elements(k)
         associate (nodes => model%mesh%elements(:, i), part => model%mesh%part(i), &
               shape => model%shapes(model%shape_of(i)))
            ! from the first: places in the whole joint have fewer digits
            corners = shape%corners + displacement(:, nodes) &
               - spread(displacement(:, nodes(1)), 2, 8)
            if (wants_tangent) then
               call brick_response(shape, model%wood(part), corners, &
                  eigenstrain(:, part), model%points(:, i), model%trial_points(:, i), at_nodes, &
                  n_yielding, tangent, is_inverted)
               call add_block(system, model, nodes, system%places(k)%at, tangent)
            else
               call brick_response(shape, model%wood(part), corners, &
                  eigenstrain(:, part), model%points(:, i), model%trial_points(:, i), at_nodes, &
                  n_yielding, inverted=is_inverted)
            end if
            if (is_inverted) then
               system%is_inverted = .true.
               exit
            end if
            forces(:, nodes) = forces(:, nodes) + at_nodes
            system%n_yielding = system%n_yielding + n_yielding
         end associate
      end do
      system%times%elements = system%times%elements + seconds_now() - began
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
      real(wp) :: began
      integer :: i, j, n

      began = seconds_now()
      n = size(model%own_elements)
      do i = 1, size(model%pairs)
         do j = 1, size(model%pairs(i)%own)
            n = n + 1
            associate (pair => model%pairs(i), face => model%pairs(i)%own(j))
               if (wants_tangent) then
                  call face_response(pair, face, positions, at_nodes, error, tangent)
               else
                  call face_response(pair, face, positions, at_nodes, error)
               end if
               if (allocated(error)) return
               associate (nodes => pair%faces(face)%nodes)
                  forces(:, nodes) = forces(:, nodes) + at_nodes
                  if (.not. wants_tangent .or. pair%has_grown) cycle
                  call add_block(system, model, nodes, system%places(n)%at, tangent)
               end associate
            end associate
         end do
      end do
      system%times%contact = system%times%contact + seconds_now() - began
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
