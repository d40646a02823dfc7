!> A tenon joint as a solid: mesh, wood, contact, what holds and loads it, and what its points
!> remember.
module asperity_solid_model_model
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_replay_tenon_settings, only: tenon_face_arm
   use asperity_solid_contact_pair, only: contact_pair, new_contact_pair
   use asperity_solid_element_brick, only: brick, new_brick
   use asperity_solid_material_material, only: material_point, new_solid_material, solid_material
   use asperity_solid_mesh_joint, only: face_side, n_parts, new_solid_mesh, part_beam, &
      part_column, solid_mesh
   use asperity_solid_model_equations, only: number_equations
   use asperity_solid_model_interface, only: new_interface_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_model_settings, only: check_solid_settings, solid_settings
   implicit none
   private
   public :: solid_model, ground_spring, new_solid_model, complete_model, load_place

   !> A spring to the ground.
   type :: ground_spring
      !> Its node, and its direction, 1 to 3
      integer :: node = 0, direction = 0
      !> Stiffness, of the half joint, N/mm
      real(wp) :: stiffness = 0.0_wp
   end type ground_spring

   !> The joint and its history.
   type :: solid_model
      !> Settings of the analysis, and whether contact is hard
      type(solid_settings) :: settings
      logical :: is_hard = .false.
      !> Nodes, elements, sets
      type(solid_mesh) :: mesh
      !> Number of each displacement, and of unknowns
      integer, allocatable :: numbers(:, :)
      integer :: n_unknowns = 0
      !> Elements that this rank works on, and the first equation of each rank, from 0, and one
      !> more: set when the work is shared
      integer, allocatable :: own_elements(:), first_rows(:)
      !> Wood of column and beam, and what shoes are of
      type(solid_material) :: wood(n_parts)
      !> Elements of one shape and wood, and which of them each element is
      type(brick), allocatable :: shapes(:)
      integer, allocatable :: shape_of(:)
      !> Faces above, below and at the side, joint by joint, and how many of them a joint has
      type(contact_pair), allocatable :: pairs(:)
      integer :: pairs_of_joint = 0
      !> Points of the elements at the start of the increment, and as found last
      type(material_point), allocatable :: points(:, :), trial_points(:, :)
      !> Strain by which the beam swells across, in full, in the measure of its elements
      real(wp) :: swelling = 0.0_wp
      !> Half of the load of each column, N
      real(wp), allocatable :: column_loads(:)
      !> The axial spring, and what holds the open joint
      type(ground_spring), allocatable :: springs(:)
      !> Force that is small against those of the joint, N: residuals below are none
      real(wp) :: small_force = 0.0_wp
      !> Residual that rounding of the displacements leaves, N
      real(wp) :: rounding = 0.0_wp
      !> Distance of the load from the column face, mm
      real(wp) :: arm = 0.0_wp
      !> Where the load point turns, mm, from 0
      real(wp), allocatable :: turns(:)
   end type solid_model

   !> Edges of two elements of one shape differ by no more, mm
   real(wp), parameter :: same_shape = 1.0e-7_wp
   !> A small force over the strength of the bearing face
   real(wp), parameter :: small_share = 1.0e-4_wp

contains

   !> Make the model of a deck. `error` is set when it cannot be.
   subroutine new_solid_model(model, deck, settings, error)
      !> Result
      type(solid_model), intent(out) :: model
      !> The joint, as its input deck has it
      type(tenon_deck), intent(in) :: deck
      !> Settings of the analysis
      type(solid_settings), intent(in) :: settings
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      call check_solid_settings(settings, error)
      if (.not. allocated(error)) call new_solid_mesh(model%mesh, deck, error)
      if (allocated(error)) return
      allocate (model%springs(2))
      associate (s => deck%settings, springs => model%springs)
         springs%node = [model%mesh%axial_node, model%mesh%hold_node]
         springs%direction = [1, 3]
         springs%stiffness = [0.5_wp*s%axial_stiffness, settings%holding_stiffness]
         ! the node is held
         if (s%axial_rule /= 'spring') springs(1)%stiffness = 0.0_wp
         model%column_loads = [0.5_wp*s%column_load]
         model%arm = tenon_face_arm(s)
      end associate
      call complete_model(model, deck, settings, error)
   end subroutine new_solid_model

   !> Equations, wood, contact and points of a model that has its mesh and what holds and loads it.
   !> `error` is set when a value is refused.
   subroutine complete_model(model, deck, settings, error)
      !> The model
      type(solid_model), intent(inout) :: model
      !> The joint, or one of a frame's
      type(tenon_deck), intent(in) :: deck
      !> Checked settings of the analysis
      type(solid_settings), intent(in) :: settings
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      model%settings = settings
      model%is_hard = deck%choice%contact == 'hard'
      call number_equations(model%mesh, model%mesh%axial_node > 0 &
         .and. deck%settings%axial_rule == 'fixed', model%numbers, model%n_unknowns)
      ! the column's grain is along z and the beam's along x; R lies along y and z
      associate (wood => deck%settings%wood)
         call new_solid_material(model%wood(part_column), wood, 3, 2, .true., error)
         if (.not. allocated(error)) &
            call new_solid_material(model%wood(part_beam), wood, 1, 3, .false., error)
      end associate
      if (.not. allocated(error)) call find_shapes(model, error)
      if (.not. allocated(error)) call find_contact(model, deck, error)
      if (allocated(error)) return
      allocate (model%points(8, size(model%mesh%elements, 2)), &
         model%trial_points(8, size(model%mesh%elements, 2)))
      associate (s => deck%settings)
         model%swelling = deck%swelling
         if (settings%is_logarithmic) model%swelling = log(1.0_wp + deck%swelling)
         model%small_force = small_share*0.5_wp*s%wood%compression_strengths(2)*s%width &
            *s%length
         model%turns = deck%turns
      end associate
   end subroutine complete_model

   !> Where the programme has moved the load, mm.
   pure real(wp) function load_place(model, displacement)
      !> The model
      type(solid_model), intent(in) :: model
      !> Displacements of all nodes, mm
      real(wp), intent(in) :: displacement(:, :)

      load_place = displacement(model%mesh%load_direction, model%mesh%load(1))
   end function load_place

   !> Elements of equal edges share their matrices.
   subroutine find_shapes(model, error)
      type(solid_model), intent(inout) :: model
      type(error_type), allocatable, intent(out) :: error
      type(brick), allocatable :: shapes(:), more(:)
      integer, allocatable :: part_of(:)
      real(wp) :: corners(3, 8)
      integer :: i, j, n

      associate (mesh => model%mesh)
         allocate (model%shape_of(size(mesh%elements, 2)), shapes(16), part_of(16))
         n = 0
         do i = 1, size(mesh%elements, 2)
            corners = mesh%nodes(:, mesh%elements(:, i)) &
               - spread(mesh%nodes(:, mesh%elements(1, i)), 2, 8)
            do j = n, 1, -1
               if (part_of(j) /= mesh%part(i)) cycle
               if (maxval(abs(shapes(j)%corners - corners)) < same_shape) exit
            end do
            if (j == 0) then
               if (n == size(shapes)) then
                  allocate (more(2*n))
                  more(:n) = shapes
                  call move_alloc(more, shapes)
                  part_of = [part_of, part_of]
               end if
               n = n + 1
               j = n
               part_of(n) = mesh%part(i)
               call new_brick(shapes(n), corners, model%wood(mesh%part(i))%stiffness, error)
               if (allocated(error)) return
               shapes(n)%is_logarithmic = model%settings%is_logarithmic
            end if
            model%shape_of(i) = j
         end do
      end associate
      allocate (model%shapes(n))
      model%shapes = shapes(:n)
      do i = 1, size(model%shape_of)
         associate (shape => model%shapes(model%shape_of(i)))
            model%rounding = model%rounding + (epsilon(1.0_wp)*maxval(abs(shape%stiffness)) &
               *maxval(abs(shape%corners)))**2
         end associate
      end do
      model%rounding = sqrt(model%rounding)
   end subroutine find_shapes

   !> Faces of the mortises against those of the tenons.
   subroutine find_contact(model, deck, error)
      type(solid_model), intent(inout) :: model
      type(tenon_deck), intent(in) :: deck
      type(error_type), allocatable, intent(out) :: error
      character(len=8), parameter :: names(3) = [character(len=8) :: 'upper', 'lower', 'side']
      class(solid_law), allocatable :: law
      integer :: i, joint, face

      model%pairs_of_joint = merge(3, 2, deck%has_sides)
      associate (mesh => model%mesh, n => model%pairs_of_joint)
         allocate (model%pairs(n*size(mesh%mortise, 2)))
         do i = 1, size(model%pairs)
            joint = (i - 1)/n + 1
            face = i - n*(joint - 1)
            if (face == face_side) then
               call new_interface_law(law, deck%sides%properties, model%is_hard, model%settings)
            else
               call new_interface_law(law, deck%faces%properties, model%is_hard, model%settings)
            end if
            call new_contact_pair(model%pairs(i), names(face), mesh%nodes, &
               mesh%mortise(face, joint)%facets, mesh%tenon(face, joint)%facets, &
               model%settings%cells, law, error)
            if (allocated(error)) return
            model%pairs(i)%search_distance = model%settings%search_distance
         end do
      end associate
   end subroutine find_contact

end module asperity_solid_model_model
