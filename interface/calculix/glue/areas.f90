!> Areas of the slave nodes of a surface that is given by nodes. The solver shares out every outer
!> face that one of the nodes belongs to, sides of the body included: a rim's nodes get too much.
module asperity_calculix_areas
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: leave_out_sides

   !> Most nodes of a face
   integer, parameter :: most = 8

contains

   !> Faces of a pair that have a node outside the slave surface get no share of it. Nothing changes
   !> where the surface is given by faces.
   pure subroutine leave_out_sides(nodes, faces, ipkon, kon, lakon, islavsurf, iponoels, inoels, &
         xnoels)
      !> Slave nodes of the pair, rising
      integer, intent(in) :: nodes(:)
      !> Its first and its last face
      integer, intent(in) :: faces(2)
      !> As in CalculiX: nodes of elements, faces, and for each node the list of its faces with the
      !> shares that it has in them
      integer, intent(in) :: ipkon(*), kon(*), islavsurf(2, *), iponoels(*), inoels(2, *)
      character(len=8), intent(in) :: lakon(*)
      real(wp), intent(inout) :: xnoels(*)
      integer :: i, entry
      logical :: whole(faces(1):faces(2))

      do i = faces(1), faces(2)
         whole(i) = has_all(nodes, islavsurf(1, i), ipkon, kon, lakon)
      end do
      if (all(whole)) return
      do i = 1, size(nodes)
         entry = iponoels(nodes(i))
         do while (entry > 0)
            if (inoels(1, entry) >= faces(1) .and. inoels(1, entry) <= faces(2)) then
               if (.not. whole(inoels(1, entry))) xnoels(entry) = 0.0_wp
            end if
            entry = inoels(2, entry)
         end do
      end do
   end subroutine leave_out_sides

   !> Whether all nodes of a face are among those of a list.
   pure logical function has_all(nodes, face, ipkon, kon, lakon)
      integer, intent(in) :: nodes(:), face, ipkon(*), kon(*)
      character(len=8), intent(in) :: lakon(*)
      integer :: places(most), i

      places = places_of(lakon(face/10), mod(face, 10))
      has_all = .true.
      do i = 1, most
         if (places(i) > 0) has_all = has_all .and. &
            contains_node(nodes, kon(ipkon(face/10) + places(i)))
      end do
   end function has_all

   !> Whether a rising list has a number, by halving.
   pure logical function contains_node(nodes, node)
      integer, intent(in) :: nodes(:), node
      integer :: low, high, middle

      low = 1
      high = size(nodes)
      do while (low < high)
         middle = (low + high)/2
         if (nodes(middle) < node) then
            low = middle + 1
         else
            high = middle
         end if
      end do
      contains_node = size(nodes) > 0
      if (contains_node) contains_node = nodes(low) == node
   end function contains_node

   !> Places of a face's nodes among those of its element, as CalculiX numbers faces: corners, and
   !> the middles of the edges between them; zeros after them.
   pure function places_of(kind, face) result(places)
      !> Kind of the element, such as C3D8I
      character(len=8), intent(in) :: kind
      integer, intent(in) :: face
      integer :: places(most)
      integer, parameter :: hexahedron(4, 6) = reshape([1, 2, 3, 4, 5, 8, 7, 6, 1, 5, 6, 2, &
         2, 6, 7, 3, 3, 7, 8, 4, 4, 8, 5, 1], [4, 6])
      integer, parameter :: tetrahedron(3, 4) = reshape([1, 2, 3, 1, 4, 2, 2, 4, 3, 3, 4, 1], &
         [3, 4])
      integer, parameter :: wedge(4, 5) = reshape([1, 2, 3, 0, 4, 5, 6, 0, 1, 2, 5, 4, &
         2, 3, 6, 5, 3, 1, 4, 6], [4, 5])
      !> Ends of the edges, in the order of their middles, which come after the corners
      integer, parameter :: hexahedron_edges(2, 12) = reshape([1, 2, 2, 3, 3, 4, 4, 1, 5, 6, &
         6, 7, 7, 8, 8, 5, 1, 5, 2, 6, 3, 7, 4, 8], [2, 12])
      integer, parameter :: tetrahedron_edges(2, 6) = reshape([1, 2, 2, 3, 3, 1, 1, 4, 2, 4, &
         3, 4], [2, 6])
      integer, parameter :: wedge_edges(2, 9) = reshape([1, 2, 2, 3, 3, 1, 4, 5, 5, 6, 6, 4, &
         1, 4, 2, 5, 3, 6], [2, 9])

      places = 0
      if (kind(4:4) == '8' .or. kind(4:5) == '20') then
         places(:4) = hexahedron(:, face)
         if (kind(4:5) == '20') call add_middles(places, hexahedron_edges, 8)
      else if (kind(4:4) == '4' .or. kind(4:5) == '10') then
         places(:3) = tetrahedron(:, face)
         if (kind(4:5) == '10') call add_middles(places, tetrahedron_edges, 4)
      else
         places(:4) = wedge(:, face)
         if (kind(4:5) == '15') call add_middles(places, wedge_edges, 6)
      end if
   end function places_of

   !> Add the middles of those edges that have both ends at corners that are there.
   pure subroutine add_middles(places, edges, first)
      integer, intent(inout) :: places(:)
      integer, intent(in) :: edges(:, :)
      !> Number of the element's corners
      integer, intent(in) :: first
      integer :: i, corners(4), found

      corners = places(:4)
      found = count(corners > 0)
      do i = 1, size(edges, 2)
         if (.not. (any(corners == edges(1, i)) .and. any(corners == edges(2, i)))) cycle
         found = found + 1
         places(found) = first + i
      end do
   end subroutine add_middles

end module asperity_calculix_areas
