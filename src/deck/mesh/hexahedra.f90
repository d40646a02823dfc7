!> Meshes of eight-node hexahedra, and what is found on them by place: nodes and faces.
!>
!> Corners and faces are numbered as in C3D8 of ABAQUS and CalculiX.
module asperity_deck_mesh_hexahedra
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_deck_mesh_cuts, only: tolerance
   implicit none
   private
   public :: hex_mesh, check_mesh_room, new_grid_mesh, nodes_in_box, faces_in_box, face_area, &
      mesh_volume, least_jacobian

   !> Corners of the faces S1 to S6, in the order that makes the normal point outwards
   integer, parameter, public :: face_corners(4, 6) = reshape([1, 4, 3, 2, 5, 6, 7, 8, &
      1, 2, 6, 5, 2, 3, 7, 6, 3, 4, 8, 7, 4, 1, 5, 8], [4, 6])
   !> Natural coordinates of the corners
   integer, parameter, public :: natural_corners(3, 8) = reshape([-1, -1, -1, 1, -1, -1, &
      1, 1, -1, -1, 1, -1, -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1], [3, 8])
   !> Bytes that an element takes at most, with its node and what is found on the mesh, if it is
   !> half as large as aimed at; and elements of which there can be no more
   real(wp), parameter :: bytes_of_element = 400.0_wp, most_elements = 1.0e15_wp

   !> Nodes and elements.
   type :: hex_mesh
      !> Coordinates of each node, mm
      real(wp), allocatable :: nodes(:, :)
      !> The eight nodes of each element
      integer, allocatable :: elements(:, :)
   end type hex_mesh

contains

   !> Set `error`, unless it is set, when there is not enough memory for the meshes of a model.
   pure subroutine check_mesh_room(error, elements)
      !> Set without memory
      type(error_type), allocatable, intent(inout) :: error
      !> About how many elements all parts have
      real(wp), intent(in) :: elements
      real(wp) :: asked_for

      asked_for = min(elements, most_elements)
      call check_work('meshes of '//to_text(asked_for, 3)//' elements', &
         int(bytes_of_element*asked_for, int64), error)
   end subroutine check_mesh_room

   !> Elements between the planes of a grid, all or those of `keep`; only their nodes are made.
   pure subroutine new_grid_mesh(mesh, x, y, z, keep)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Planes of the grid, rising, mm
      real(wp), intent(in) :: x(:), y(:), z(:)
      !> Cells that are filled, one fewer than planes in each direction; all when absent
      logical, intent(in), optional :: keep(:, :, :)
      integer :: number(size(x), size(y), size(z)), i, j, k, n
      logical :: filled(size(x) - 1, size(y) - 1, size(z) - 1)

      filled = .true.
      if (present(keep)) filled = keep
      number = 0
      do k = 1, size(z) - 1
         do j = 1, size(y) - 1
            do i = 1, size(x) - 1
               if (filled(i, j, k)) number(i:i + 1, j:j + 1, k:k + 1) = 1
            end do
         end do
      end do
      allocate (mesh%nodes(3, count(number > 0)), mesh%elements(8, count(filled)))
      n = 0
      do k = 1, size(z)
         do j = 1, size(y)
            do i = 1, size(x)
               if (number(i, j, k) == 0) cycle
               n = n + 1
               number(i, j, k) = n
               mesh%nodes(:, n) = [x(i), y(j), z(k)]
            end do
         end do
      end do
      n = 0
      do k = 1, size(z) - 1
         do j = 1, size(y) - 1
            do i = 1, size(x) - 1
               if (.not. filled(i, j, k)) cycle
               n = n + 1
               mesh%elements(:, n) = [ &
                  number(i, j, k), number(i + 1, j, k), &
                  number(i + 1, j + 1, k), number(i, j + 1, k), &
                  number(i, j, k + 1), number(i + 1, j, k + 1), &
                  number(i + 1, j + 1, k + 1), number(i, j + 1, k + 1)]
            end do
         end do
      end do
   end subroutine new_grid_mesh

   !> Numbers of the nodes in a box, whose sides belong to it.
   pure subroutine nodes_in_box(mesh, low, high, found)
      !> The mesh
      type(hex_mesh), intent(in) :: mesh
      !> Corners of the box, mm
      real(wp), intent(in) :: low(3), high(3)
      !> The nodes
      integer, allocatable, intent(out) :: found(:)
      logical :: inside(size(mesh%nodes, 2))
      integer :: i

      do i = 1, size(inside)
         inside(i) = all(mesh%nodes(:, i) > low - tolerance &
            .and. mesh%nodes(:, i) < high + tolerance)
      end do
      allocate (found(count(inside)))
      found = pack([(i, i=1, size(inside))], inside)
   end subroutine nodes_in_box

   !> Elements and faces all of whose nodes are in a box, which is flat when one face is wanted.
   pure subroutine faces_in_box(mesh, low, high, found)
      !> The mesh
      type(hex_mesh), intent(in) :: mesh
      !> Corners of the box, mm
      real(wp), intent(in) :: low(3), high(3)
      !> Element and number of each face
      integer, allocatable, intent(out) :: found(:, :)
      logical :: inside(size(mesh%nodes, 2)), chosen(6, size(mesh%elements, 2))
      integer, allocatable :: nodes(:)
      integer :: i, j, n

      call nodes_in_box(mesh, low, high, nodes)
      inside = .false.
      inside(nodes) = .true.
      do i = 1, size(mesh%elements, 2)
         do j = 1, 6
            chosen(j, i) = all(inside(mesh%elements(face_corners(:, j), i)))
         end do
      end do
      allocate (found(2, count(chosen)))
      n = 0
      do i = 1, size(mesh%elements, 2)
         do j = 1, 6
            if (.not. chosen(j, i)) cycle
            n = n + 1
            found(:, n) = [i, j]
         end do
      end do
   end subroutine faces_in_box

   !> Outward normal of a face times its area, mm^2; of a warped face, of its middle.
   pure function face_area(mesh, face) result(area)
      !> The mesh
      type(hex_mesh), intent(in) :: mesh
      !> Element and number of the face
      integer, intent(in) :: face(2)
      real(wp) :: area(3)
      real(wp) :: x(3, 4), a(3), b(3)

      x = mesh%nodes(:, mesh%elements(face_corners(:, face(2)), face(1)))
      a = x(:, 3) - x(:, 1)
      b = x(:, 4) - x(:, 2)
      area = 0.5_wp*[a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
   end function face_area

   !> Volume of all elements, mm^3, by two Gauss points in each direction, which is exact.
   pure real(wp) function mesh_volume(mesh)
      !> The mesh
      type(hex_mesh), intent(in) :: mesh
      integer :: i, j

      mesh_volume = 0.0_wp
      do i = 1, size(mesh%elements, 2)
         do j = 1, 8
            mesh_volume = mesh_volume &
               + jacobian(mesh%nodes(:, mesh%elements(:, i)), natural_corners(:, j)/sqrt(3.0_wp))
         end do
      end do
   end function mesh_volume

   !> Smallest Jacobian at a corner over the element's mean: 1 for a brick, above 0 for any element
   !> that can be used.
   pure real(wp) function least_jacobian(mesh)
      !> The mesh
      type(hex_mesh), intent(in) :: mesh
      real(wp) :: at_corner(8)
      integer :: i, j

      least_jacobian = huge(1.0_wp)
      do i = 1, size(mesh%elements, 2)
         do j = 1, 8
            at_corner(j) = jacobian(mesh%nodes(:, mesh%elements(:, i)), &
               real(natural_corners(:, j), wp))
         end do
         least_jacobian = min(least_jacobian, 8.0_wp*minval(at_corner)/abs(sum(at_corner)))
      end do
   end function least_jacobian

   !> Jacobian of an element at a place in it.
   pure real(wp) function jacobian(nodes, place)
      real(wp), intent(in) :: nodes(3, 8), place(3)
      real(wp) :: m(3, 3), s(3)
      integer :: i

      m = 0.0_wp
      do i = 1, 8
         s = 1.0_wp + natural_corners(:, i)*place
         m(:, 1) = m(:, 1) + 0.125_wp*natural_corners(1, i)*s(2)*s(3)*nodes(:, i)
         m(:, 2) = m(:, 2) + 0.125_wp*natural_corners(2, i)*s(1)*s(3)*nodes(:, i)
         m(:, 3) = m(:, 3) + 0.125_wp*natural_corners(3, i)*s(1)*s(2)*nodes(:, i)
      end do
      jacobian = m(1, 1)*(m(2, 2)*m(3, 3) - m(3, 2)*m(2, 3)) &
         - m(1, 2)*(m(2, 1)*m(3, 3) - m(3, 1)*m(2, 3)) &
         + m(1, 3)*(m(2, 1)*m(3, 2) - m(3, 1)*m(2, 2))
   end function jacobian

end module asperity_deck_mesh_hexahedra
