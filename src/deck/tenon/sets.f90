!> Sets of nodes and faces of the tenon joint's half model, as its decks name them and as the joint
!> as a solid needs them. Nodes and elements are numbered through, those of the column first.
module asperity_deck_tenon_sets
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_hexahedra, only: faces_in_box, hex_mesh, nodes_in_box
   use asperity_deck_tenon_parts, only: node_near, tenon_sizes
   use asperity_replay_tenon_settings, only: tenon_face_arm, tenon_settings
   implicit none
   private
   public :: tenon_sets, face_list, new_tenon_sets, find_joint_faces

   !> Further than any part reaches, mm
   real(wp), parameter, public :: far = huge(1.0_wp)
   !> Stiffness of the spring that holds the open joint, N/mm: nothing beside wood
   real(wp), parameter, public :: holding_stiffness = 0.1_wp
   !> Places of the upper, the lower and the side face in lists of pairs
   integer, parameter, public :: face_top = 1, face_bottom = 2, face_side = 3

   !> Faces of elements.
   type :: face_list
      !> Element, and number of the face as in C3D8, of each
      integer, allocatable :: faces(:, :)
   end type face_list

   !> What is held, moved, loaded and touched.
   type :: tenon_sets
      !> Faces of the mortise, which are the slaves, and of the beam, at `face_top` and so on; none
      !> at the sides when these have no contact
      type(face_list) :: mortise(3), tenon(3)
      !> Upper face of the column, on which its load is
      type(face_list) :: loaded
      !> Nodes of the column's foot and top, and those of the plane of symmetry that are in neither
      integer, allocatable :: foot(:), head(:), middle(:)
      !> Nodes of the beam that are moved
      integer, allocatable :: tip(:)
      !> Node of the axial hold, and node at the end of the tenon that a soft spring holds
      integer :: axial_node = 0, hold_node = 0
   end type tenon_sets

contains

   !> Find the sets on the meshes of the column and the beam.
   pure subroutine new_tenon_sets(sets, settings, sizes, has_sides, column, beam)
      !> Result
      type(tenon_sets), intent(out) :: sets
      !> Settings of the joint, and what a plane joint has not
      type(tenon_settings), intent(in) :: settings
      type(tenon_sizes), intent(in) :: sizes
      !> Whether the sides touch
      logical, intent(in) :: has_sides
      !> The parts
      type(hex_mesh), intent(in) :: column, beam
      integer, allocatable :: nodes(:)
      integer :: before, i
      real(wp) :: end_of_column, tip

      before = size(column%nodes, 2)
      end_of_column = 0.5_wp*sizes%column_height
      tip = tenon_face_arm(settings)
      call find_joint_faces(sets%mortise, sets%tenon, settings, sizes, has_sides, column, beam, &
         [0.0_wp, 0.0_wp], [.true., .false.])
      do i = 1, size(sets%tenon)
         sets%tenon(i)%faces(1, :) = size(column%elements, 2) + sets%tenon(i)%faces(1, :)
      end do
      call faces_in_box(column, [-far, -far, end_of_column], [far, far, far], sets%loaded%faces)
      call nodes_in_box(column, [-far, -far, -end_of_column], [far, far, -end_of_column], sets%foot)
      call nodes_in_box(column, [-far, -far, end_of_column], [far, far, end_of_column], sets%head)
      call nodes_in_box(column, [-far, 0.0_wp, -far], [far, 0.0_wp, far], sets%middle)
      nodes = pack(sets%middle, &
         abs(column%nodes(3, sets%middle)) < end_of_column*(1.0_wp - 1.0e-9_wp))
      call nodes_in_box(beam, [-far, 0.0_wp, -far], [far, 0.0_wp, far], sets%middle)
      sets%middle = [nodes, (before + sets%middle(i), i=1, size(sets%middle))]
      call nodes_in_box(beam, [tip, -far, 0.0_wp], [tip, far, 0.0_wp], sets%tip)
      sets%tip = before + sets%tip
      sets%axial_node = before + node_near(beam, [0.0_wp, 0.0_wp, 0.0_wp])
      sets%hold_node = before + node_near(beam, [-settings%length - sizes%tail, 0.0_wp, 0.0_wp])
   end subroutine new_tenon_sets

   !> Faces of a joint that touch, elements numbered as in their parts.
   pure subroutine find_joint_faces(mortise, tenon, settings, sizes, has_sides, column, beam, &
         place, has_relief)
      !> Faces of the mortise and of the beam, at `face_top` and so on
      type(face_list), intent(inout) :: mortise(3), tenon(3)
      !> Settings of the joint, and what a plane joint has not
      type(tenon_settings), intent(in) :: settings
      type(tenon_sizes), intent(in) :: sizes
      !> Whether the sides touch
      logical, intent(in) :: has_sides
      !> The parts
      type(hex_mesh), intent(in) :: column, beam
      !> Front face of the column, and height of the beam's axis, mm
      real(wp), intent(in) :: place(2)
      !> Whether contact begins at a distance from the back and the front face
      logical, intent(in) :: has_relief(2)
      real(wp) :: upper, lower, top, bottom, side, half_width, back, front, relief

      relief = sizes%edge_relief
      back = place(1) - settings%length
      if (has_relief(1)) back = back + relief
      front = place(1)
      if (has_relief(2)) front = front - relief
      upper = place(2) + 0.5_wp*settings%height
      lower = place(2) - 0.5_wp*settings%height
      half_width = 0.5_wp*settings%width
      top = upper + sizes%gap_above
      bottom = lower - sizes%gap_below
      side = half_width - sizes%side_overlap
      call faces_in_box(column, [back, 0.0_wp, top], [front, side, top], mortise(face_top)%faces)
      call faces_in_box(column, [back, 0.0_wp, bottom], [front, side, bottom], &
         mortise(face_bottom)%faces)
      call faces_in_box(beam, [-far, -far, upper], [far, far, upper], tenon(face_top)%faces)
      call faces_in_box(beam, [-far, -far, lower], [far, far, lower], tenon(face_bottom)%faces)
      if (has_sides) then
         call faces_in_box(column, [back, side, bottom + relief], [front, side, top - relief], &
            mortise(face_side)%faces)
         call faces_in_box(beam, [-far, half_width, -far], [far, half_width, far], &
            tenon(face_side)%faces)
      else
         allocate (mortise(face_side)%faces(2, 0), tenon(face_side)%faces(2, 0))
      end if
   end subroutine find_joint_faces

end module asperity_deck_tenon_sets
