!> Mesh of a frame: its columns one after the other, then its beams; joints beam by beam, along each
!> from column to column.
module asperity_solid_frame_mesh
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_hexahedra, only: check_mesh_room, hex_mesh, nodes_in_box
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_deck_tenon_parts, only: node_near, tenon_elements
   use asperity_deck_tenon_sets, only: face_list, far, find_joint_faces
   use asperity_solid_frame_parts, only: column_face, ends_flush, new_frame_beam, new_frame_column
   use asperity_solid_frame_settings, only: frame_settings, shoe_height
   use asperity_solid_mesh_checks, only: check_solid_mesh
   use asperity_solid_mesh_joint, only: part_beam, part_column, part_shoe, solid_mesh, take_facets
   implicit none
   private
   public :: new_frame_mesh, joint_count

   !> A part, and how many nodes and elements come before its own.
   type :: placed_part
      type(hex_mesh) :: mesh
      integer :: nodes_before = 0, elements_before = 0
   end type placed_part

contains

   !> How many joints a frame has.
   pure integer function joint_count(frame)
      !> The frame, complete
      type(frame_settings), intent(in) :: frame

      joint_count = sum(frame%beam_to - frame%beam_from + 1)
   end function joint_count

   !> Make the mesh. `error` is set when it does not go with the programme, or needs more memory
   !> than there is.
   pure subroutine new_frame_mesh(mesh, frame, deck, beam_ends, error)
      !> Result
      type(solid_mesh), intent(out) :: mesh
      !> The frame, checked
      type(frame_settings), intent(in) :: frame
      !> Its joints, of a column and a beam as long as the frame's columns are high
      type(tenon_deck), intent(in) :: deck
      !> Nodes at mid-height of both ends of each beam, in the plane of symmetry
      integer, allocatable, intent(out) :: beam_ends(:, :)
      !> Set when the mesh is refused
      type(error_type), allocatable, intent(out) :: error
      type(placed_part), allocatable :: columns(:), beams(:)
      integer :: i, nodes, elements

      call check_solid_mesh(deck, error)
      if (.not. allocated(error)) call check_mesh_room(error, &
         tenon_elements(deck%choice, deck%settings, deck%sizes) &
         *(size(frame%column_places) + beam_lengths(frame)/deck%sizes%column_height))
      if (allocated(error)) return
      allocate (columns(size(frame%column_places)), beams(size(frame%beam_heights)))
      nodes = 0
      elements = 0
      do i = 1, size(columns)
         call new_frame_column(columns(i)%mesh, frame, deck, i)
         call place(columns(i), nodes, elements)
      end do
      do i = 1, size(beams)
         call new_frame_beam(beams(i)%mesh, frame, deck, i)
         call place(beams(i), nodes, elements)
      end do
      allocate (mesh%nodes(3, nodes), mesh%elements(8, elements), mesh%part(elements))
      do i = 1, size(columns)
         call take_part(mesh, columns(i), part_column)
      end do
      do i = 1, size(beams)
         call take_part(mesh, beams(i), part_beam)
      end do
      call find_shoes(mesh, deck)
      call find_ends(mesh, frame, deck, columns)
      call find_joints(mesh, frame, deck, columns, beams)
      mesh%middle = pack([(i, i=1, nodes)], .not. mesh%nodes(2, :) > 0.0_wp)
      allocate (beam_ends(2, size(beams)))
      do i = 1, size(beams)
         associate (part => beams(i)%mesh, height => frame%beam_heights(i))
            beam_ends(:, i) = beams(i)%nodes_before &
               + [node_near(part, [minval(part%nodes(1, :)), 0.0_wp, height]), &
               node_near(part, [maxval(part%nodes(1, :)), 0.0_wp, height])]
         end associate
      end do
   end subroutine new_frame_mesh

   !> All beams together, mm.
   pure real(wp) function beam_lengths(frame)
      type(frame_settings), intent(in) :: frame

      beam_lengths = sum(frame%column_places(frame%beam_to) &
         - frame%column_places(frame%beam_from))
   end function beam_lengths

   !> Put a part after those that there are.
   pure subroutine place(part, nodes, elements)
      type(placed_part), intent(inout) :: part
      !> How many there are, then with its own
      integer, intent(inout) :: nodes, elements

      part%nodes_before = nodes
      part%elements_before = elements
      nodes = nodes + size(part%mesh%nodes, 2)
      elements = elements + size(part%mesh%elements, 2)
   end subroutine place

   !> Nodes and elements of a part.
   pure subroutine take_part(mesh, part, number)
      type(solid_mesh), intent(inout) :: mesh
      type(placed_part), intent(in) :: part
      !> `part_column` or `part_beam`
      integer, intent(in) :: number

      associate (n => part%nodes_before, e => part%elements_before)
         mesh%nodes(:, n + 1:n + size(part%mesh%nodes, 2)) = part%mesh%nodes
         mesh%elements(:, e + 1:e + size(part%mesh%elements, 2)) = n + part%mesh%elements
         mesh%part(e + 1:e + size(part%mesh%elements, 2)) = number
      end associate
   end subroutine take_part

   !> Elements of the columns that are in their shoes.
   pure subroutine find_shoes(mesh, deck)
      type(solid_mesh), intent(inout) :: mesh
      type(tenon_deck), intent(in) :: deck
      real(wp) :: middle
      integer :: i

      associate (shoe => shoe_height(deck%settings), head => deck%sizes%column_height)
         do i = 1, size(mesh%part)
            middle = sum(mesh%nodes(3, mesh%elements(:, i)))/8.0_wp
            if (mesh%part(i) == part_column .and. min(middle, head - middle) < shoe) &
               mesh%part(i) = part_shoe
         end do
      end associate
   end subroutine find_shoes

   !> Feet and heads of the columns; the programme moves the heads along x.
   pure subroutine find_ends(mesh, frame, deck, columns)
      type(solid_mesh), intent(inout) :: mesh
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      type(placed_part), intent(in) :: columns(:)
      integer, allocatable :: nodes(:)
      integer :: i

      allocate (mesh%foot(0), mesh%load(0), mesh%heads(size(columns)))
      mesh%load_direction = 1
      do i = 1, size(columns)
         associate (axis => frame%column_places(i), head => deck%sizes%column_height, &
               before => columns(i)%nodes_before)
            if (frame%column_feet == 'fixed') then
               call nodes_in_box(columns(i)%mesh, [-far, -far, 0.0_wp], [far, far, 0.0_wp], nodes)
            else
               call nodes_in_box(columns(i)%mesh, [axis, -far, 0.0_wp], [axis, far, 0.0_wp], nodes)
            end if
            mesh%foot = [mesh%foot, before + nodes]
            call nodes_in_box(columns(i)%mesh, [axis, -far, head], [axis, far, head], nodes)
            mesh%heads(i)%nodes = before + nodes
            mesh%load = [mesh%load, before + nodes]
         end associate
      end do
   end subroutine find_ends

   !> Faces that touch in each joint, and the nodes by which its rotation is measured.
   pure subroutine find_joints(mesh, frame, deck, columns, beams)
      type(solid_mesh), intent(inout) :: mesh
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      type(placed_part), intent(in) :: columns(:), beams(:)
      type(face_list) :: mortise(3), tenon(3)
      integer, allocatable :: nodes(:)
      real(wp) :: low(3), high(3)
      integer :: i, j, k, n

      n = joint_count(frame)
      allocate (mesh%mortise(3, n), mesh%tenon(3, n), mesh%joints(n))
      n = 0
      do j = 1, size(beams)
         do i = frame%beam_from(j), frame%beam_to(j)
            n = n + 1
            associate (front => column_face(frame, deck, i), height => frame%beam_heights(j), &
                  s => deck%settings, joint => mesh%joints(n))
               call find_joint_faces(mortise, tenon, s, deck%sizes, deck%has_sides, &
                  columns(i)%mesh, beams(j)%mesh, [front, height], ends_flush(frame, deck, j, i))
               do k = 1, size(mortise)
                  mortise(k)%faces(1, :) = columns(i)%elements_before + mortise(k)%faces(1, :)
                  tenon(k)%faces(1, :) = beams(j)%elements_before + tenon(k)%faces(1, :)
                  call take_facets(mesh, mortise(k), mesh%mortise(k, n))
                  call take_facets(mesh, tenon(k), mesh%tenon(k, n))
                  deallocate (mortise(k)%faces, tenon(k)%faces)
               end do
               joint%beam = j
               joint%column = i
               low = [front - s%length, -far, height - 0.5_wp*s%height - deck%sizes%gap_below]
               high = [front, far, height + 0.5_wp*s%height + deck%sizes%gap_above]
               call nodes_in_box(columns(i)%mesh, low, high, nodes)
               joint%column_nodes = columns(i)%nodes_before + nodes
               call nodes_in_box(beams(j)%mesh, low, high, nodes)
               joint%beam_nodes = beams(j)%nodes_before + nodes
            end associate
         end do
      end do
   end subroutine find_joints

end module asperity_solid_frame_mesh
