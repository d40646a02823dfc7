!> Faces of a slave surface: a facet in cells, and the nodes that its contact touches.
module asperity_solid_contact_face
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_cell, only: contact_cell, contact_sample
   use asperity_solid_contact_geometry_facet, only: facet_shape, facet_slopes
   use asperity_solid_contact_geometry_surface, only: contact_surface
   use asperity_solid_small_matrices, only: cross, invert
   implicit none
   private
   public :: contact_face, new_contact_face, freeze_axes, meet_facet, surround_facet, met_facets, &
      keep_facets, cell_place

   !> A slave facet.
   type :: contact_face
      !> Nodes of the slave facet, then those of every master facet met
      integer, allocatable :: nodes(:)
      !> Master facets met and their neighbours, which of the nodes are their corners, and which
      !> were met since some were forgotten
      integer, allocatable :: facets(:), corners(:, :)
      logical, allocatable :: is_met(:)
      !> Cells, and their samples one after the other
      type(contact_cell), allocatable :: cells(:)
      type(contact_sample), allocatable :: samples(:)
      !> Unit normal outwards and two tangents, frozen within an increment
      real(wp) :: normal(3) = 0.0_wp, tangents(3, 2) = 0.0_wp
      !> Natural components of the first tangent, which moves with the face
      real(wp) :: slip_axis(2) = 0.0_wp
   end type contact_face

   !> The first tangent lies along global x, or along y where the normal is this near to x
   real(wp), parameter :: along_x = 0.9_wp

contains

   !> Divide an undeformed facet into cells.
   pure subroutine new_contact_face(face, positions, nodes, cells)
      !> Result
      type(contact_face), intent(out) :: face
      !> Undeformed places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> The facet's corners, counter-clockwise seen from outside
      integer, intent(in) :: nodes(4)
      !> Cells along each edge
      integer, intent(in) :: cells
      real(wp) :: x(3, 4), a(3, 3), inverse(3, 3), determinant, axis(3), place(2)
      integer :: i

      face%nodes = nodes
      allocate (face%facets(0), face%corners(4, 0), face%is_met(0), face%samples(0), &
         face%cells(cells*cells))
      x = positions(:, nodes)
      a(:, :2) = matmul(x, facet_slopes([0.0_wp, 0.0_wp]))
      a(:, 3) = cross(a(:, 1), a(:, 2))
      axis = merge([0.0_wp, 1.0_wp, 0.0_wp], [1.0_wp, 0.0_wp, 0.0_wp], &
         abs(a(1, 3)) > along_x*norm2(a(:, 3)))
      call invert(a, inverse, determinant)
      face%slip_axis = matmul(inverse(:2, :), axis)
      do i = 1, cells*cells
         associate (cell => face%cells(i))
            place = cell_place(i, cells)
            cell%middle%shape = facet_shape(place)
            cell%position = matmul(x, cell%middle%shape)
            cell%edges = matmul(x, facet_slopes(place))*(2.0_wp/cells)
            cell%area = norm2(cross(cell%edges(:, 1), cell%edges(:, 2)))
         end associate
      end do
      call freeze_axes(face, positions)
   end subroutine new_contact_face

   !> Natural coordinates of a cell's middle.
   pure function cell_place(cell, cells) result(place)
      !> Number of the cell, and cells along each edge
      integer, intent(in) :: cell, cells
      real(wp) :: place(2)

      place = (2.0_wp*[mod(cell - 1, cells), (cell - 1)/cells] + 1.0_wp)/cells - 1.0_wp
   end function cell_place

   !> Normal and tangents as the facet lies now.
   pure subroutine freeze_axes(face, positions)
      !> The face
      type(contact_face), intent(inout) :: face
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      real(wp) :: x(3, 4), a(3, 2)

      associate (n => face%normal, t => face%tangents)
         x = positions(:, face%nodes(:4))
         a = matmul(x, facet_slopes([0.0_wp, 0.0_wp]))
         n = cross(a(:, 1), a(:, 2))
         n = n/norm2(n)
         t(:, 1) = matmul(a, face%slip_axis)
         t(:, 1) = t(:, 1)/norm2(t(:, 1))
         t(:, 2) = cross(n, t(:, 1))
      end associate
   end subroutine freeze_axes

   !> Add a master facet and those around it to those met; one that is there is only noted.
   pure subroutine meet_facet(face, master, facet, has_grown)
      !> The face
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> The facet; 0 for none
      integer, intent(in) :: facet
      !> Set to true when it was new
      logical, intent(inout) :: has_grown
      integer :: place

      if (facet == 0) return
      place = findloc(face%facets, facet, 1)
      if (place > 0) then
         face%is_met(place) = .true.
      else
         call add_facet(face, master, facet, has_grown)
         face%is_met(size(face%is_met)) = .true.
         call surround_facet(face, master, facet, has_grown)
      end if
   end subroutine meet_facet

   !> Add the facets around one, also those at its corners.
   pure subroutine surround_facet(face, master, facet, has_grown)
      !> The face
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> The facet
      integer, intent(in) :: facet
      !> Set to true when one was new
      logical, intent(inout) :: has_grown
      integer :: i, j, k, beside, beyond

      do i = 1, 4
         beside = master%neighbours(i, facet)
         call add_facet(face, master, beside, has_grown)
         if (beside == 0) cycle
         do j = 1, 4
            beyond = master%neighbours(j, beside)
            if (beyond == 0) cycle
            if (any([(any(master%facets(:, facet) == master%facets(k, beyond)), k=1, 4)])) &
               call add_facet(face, master, beyond, has_grown)
         end do
      end do
   end subroutine surround_facet

   pure subroutine add_facet(face, master, facet, has_grown)
      type(contact_face), intent(inout) :: face
      type(contact_surface), intent(in) :: master
      integer, intent(in) :: facet
      logical, intent(inout) :: has_grown
      integer :: corners(4), k

      if (facet == 0) return
      if (any(face%facets == facet)) return
      has_grown = .true.
      do k = 1, 4
         corners(k) = findloc(face%nodes, master%facets(k, facet), 1)
         if (corners(k) > 0) cycle
         face%nodes = [face%nodes, master%facets(k, facet)]
         corners(k) = size(face%nodes)
      end do
      face%facets = [face%facets, facet]
      face%is_met = [face%is_met, .false.]
      face%corners = reshape([face%corners, corners], [4, size(face%facets)])
   end subroutine add_facet

   !> Master facets met since some were forgotten, rising.
   pure function met_facets(face) result(list)
      !> The face
      type(contact_face), intent(in) :: face
      integer, allocatable :: list(:)
      integer :: facet

      allocate (list(0))
      do facet = 1, maxval(face%facets)
         if (any(face%facets == facet .and. face%is_met)) list = [list, facet]
      end do
   end function met_facets

   !> Keep some master facets and their neighbours and forget all others, so that those of the past
   !> no longer fill the matrix. The same list gives the same nodes in the same order.
   pure subroutine keep_facets(face, master, list)
      !> The face
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> The facets
      integer, intent(in) :: list(:)
      logical :: has_grown
      integer :: i

      ! of no interest here
      has_grown = .false.
      face%nodes = face%nodes(:4)
      face%facets = face%facets(:0)
      face%is_met = face%is_met(:0)
      face%corners = face%corners(:, :0)
      do i = 1, size(list)
         call meet_facet(face, master, list(i), has_grown)
      end do
   end subroutine keep_facets

end module asperity_solid_contact_face
