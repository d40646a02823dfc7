!> Mesh of the joint as a solid: that of the deck of the same case (`asperity deck tenon`), node for
!> node, column and beam as one.
module asperity_solid_mesh_joint
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_hexahedra, only: face_corners, hex_mesh
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_deck_tenon_sets, only: face_bottom, face_list, face_side, face_top
   use asperity_solid_mesh_checks, only: check_solid_mesh
   implicit none
   private
   public :: solid_mesh, facet_set, node_list, joint_nodes, new_solid_mesh, take_facets
   ! places of the pairs in `mortise` and `tenon`
   public :: face_top, face_bottom, face_side

   !> Parts, as `part` numbers them; the last is for ends of columns that turn on a hinge
   integer, parameter, public :: part_column = 1, part_beam = 2, part_shoe = 3
   !> How many there are
   integer, parameter, public :: n_parts = 3

   !> Facets of a surface.
   type :: facet_set
      !> The four nodes of each, in the order that makes the normal point outwards
      integer, allocatable :: facets(:, :)
   end type facet_set

   !> Some nodes.
   type :: node_list
      !> Their numbers
      integer, allocatable :: nodes(:)
   end type node_list

   !> A joint of a frame: its beam and its column, and the nodes of both by which its rotation is
   !> measured.
   type :: joint_nodes
      !> Numbers of the beam and the column
      integer :: beam = 0, column = 0
      !> Nodes of both within the mortise's depth and height
      integer, allocatable :: beam_nodes(:), column_nodes(:)
   end type joint_nodes

   !> Nodes, elements and what is found on them; half the joint, see asperity_deck_tenon_parts for
   !> the axes. A frame has several columns, beams and joints.
   type :: solid_mesh
      !> Coordinates of each node, mm; those of the column first
      real(wp), allocatable :: nodes(:, :)
      !> The eight nodes of each element, in the order of C3D8, and its part
      integer, allocatable :: elements(:, :), part(:)
      !> Surfaces in contact: slave facets of the mortise and master facets of the beam, at
      !> `face_top`, `face_bottom` and `face_side`, of each joint; none at the side when it has no
      !> contact
      type(facet_set), allocatable :: mortise(:, :), tenon(:, :)
      !> Nodes of the columns' feet, which are held; the others in the plane of symmetry, which are
      !> held in y; and those that the programme moves, in this direction
      integer, allocatable :: foot(:), middle(:), load(:)
      integer :: load_direction = 3
      !> Nodes of the head of each column, which are held in y and, unless they are moved, in x, and
      !> stay level
      type(node_list), allocatable :: heads(:)
      !> Node of the spring or hold in x, and of the soft spring in z at the end of the tenon
      integer :: axial_node = 0, hold_node = 0
      !> Nodes of the beam's section nearest to the column face, whose rotation is that of a single
      !> joint
      integer, allocatable :: section(:)
      !> The joints of a frame; not allocated for a single one
      type(joint_nodes), allocatable :: joints(:)
   end type solid_mesh

contains

   !> Take the mesh of a deck. `error` is set when it does not go with the programme.
   pure subroutine new_solid_mesh(mesh, deck, error)
      !> Result
      type(solid_mesh), intent(out) :: mesh
      !> The deck
      type(tenon_deck), intent(in) :: deck
      !> Set when the mesh is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: before, i

      call check_solid_mesh(deck, error)
      if (allocated(error)) return
      before = size(deck%column%nodes, 2)
      associate (column => deck%column, beam => deck%beam, sets => deck%sets)
         allocate (mesh%nodes(3, before + size(beam%nodes, 2)), &
            mesh%elements(8, size(column%elements, 2) + size(beam%elements, 2)))
         mesh%nodes(:, :before) = column%nodes
         mesh%nodes(:, before + 1:) = beam%nodes
         mesh%elements(:, :size(column%elements, 2)) = column%elements
         mesh%elements(:, size(column%elements, 2) + 1:) = before + beam%elements
         mesh%part = [(merge(part_column, part_beam, i <= size(column%elements, 2)), &
            i=1, size(mesh%elements, 2))]
         allocate (mesh%mortise(3, 1), mesh%tenon(3, 1), mesh%heads(1))
         do i = 1, size(mesh%tenon)
            call take_facets(mesh, sets%mortise(i), mesh%mortise(i, 1))
            call take_facets(mesh, sets%tenon(i), mesh%tenon(i, 1))
         end do
         mesh%foot = sets%foot
         mesh%heads(1)%nodes = sets%head
         mesh%middle = sets%middle
         mesh%load = sets%tip
         mesh%axial_node = sets%axial_node
         mesh%hold_node = sets%hold_node
         associate (along => abs(beam%nodes(1, :)))
            ! nodes of one section have the same coordinate, as the grid is of planes
            mesh%section = before + pack([(i, i=1, size(along))], along <= minval(along))
         end associate
      end associate
   end subroutine new_solid_mesh

   !> Nodes of faces.
   pure subroutine take_facets(mesh, list, set)
      !> The mesh, with its elements
      type(solid_mesh), intent(in) :: mesh
      !> Element and number of each face
      type(face_list), intent(in) :: list
      !> The facets
      type(facet_set), intent(inout) :: set
      integer :: i

      allocate (set%facets(4, size(list%faces, 2)))
      do i = 1, size(set%facets, 2)
         set%facets(:, i) = mesh%elements(face_corners(:, list%faces(2, i)), list%faces(1, i))
      end do
   end subroutine take_facets

end module asperity_solid_mesh_joint
