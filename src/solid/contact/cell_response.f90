!> Nodal forces and tangent of one cell.
!>
!> With T = p (-m3) + tau_i t_i at each sample, -m3 the gradient of its overclosure, the slave's
!> nodes get area coverage weight N T, the master's as much with -N: normal forces are the gradient
!> of the stored energy. The tangent is the exact derivative, rims and the turning of -m3 included.
module asperity_solid_contact_cell_response
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_cell, only: contact_cell, contact_sample
   use asperity_solid_contact_face, only: contact_face
   use asperity_solid_contact_geometry_facet, only: facet_shape, facet_slopes, facet_twist
   use asperity_solid_contact_geometry_surface, only: contact_surface
   implicit none
   private
   public :: add_cell_response

contains

   !> Add forces and, where wanted, the tangent of a cell that is pressed.
   pure subroutine add_cell_response(face, cell, master, positions, forces, tangent)
      !> The face
      type(contact_face), intent(in) :: face
      !> The cell, one of its own
      type(contact_cell), intent(in) :: cell
      !> The master surface, of which the face has met the facets
      type(contact_surface), intent(in) :: master
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      !> Internal forces on the face's nodes, N
      real(wp), intent(inout) :: forces(:, :)
      !> Their derivative by the places of these nodes, N/mm
      real(wp), intent(inout), optional :: tangent(:, :)
      !> d overclosure, d slip over t, d coverage, and shear force over t, for each node
      real(wp) :: by_normal(3, size(face%nodes)), by_slip(size(face%nodes))
      real(wp) :: by_coverage(3, size(face%nodes)), carried(size(face%nodes))
      real(wp) :: shares(8), shear(3), corners(3, 4)
      logical :: touched(size(face%nodes))
      integer :: i, nodes(8)

      by_normal = 0.0_wp
      by_slip = 0.0_wp
      by_coverage = 0.0_wp
      carried = 0.0_wp
      touched = .false.
      do i = cell%first, cell%last
         associate (s => face%samples(i))
            call find_shares(face, s, s%facet, s%ray%natural, nodes, shares)
            shares = s%weight*shares
            touched(nodes) = .true.
            carried(nodes) = carried(nodes) + shares
            by_normal(:, nodes) = by_normal(:, nodes) - outer(s%ray%inverse(3, :), shares)
            if (s%start_facet == 0) cycle
            call find_shares(face, s, s%start_facet, s%start_natural, nodes, shares)
            touched(nodes) = .true.
            by_slip(nodes) = by_slip(nodes) + s%weight*shares
         end associate
      end do
      associate (traction => cell%trial%traction, scale => cell%area*cell%coverage)
         shear = matmul(face%tangents, traction(2:))
         forces = forces + scale*(traction(1)*by_normal + outer(shear, carried))
         if (.not. present(tangent)) return
         if (cell%coverage < 1.0_wp) then
            associate (s => cell%middle)
               call find_shares(face, s, s%facet, s%ray%natural, nodes, shares)
               touched(nodes) = .true.
               by_coverage(:, nodes) = outer(matmul(cell%coverage_gradient, &
                  s%ray%inverse(:2, :)), shares)
            end associate
         end if
         call add_law(face%tangents, cell, pack([(i, i=1, size(touched))], touched), by_normal, &
            by_slip, by_coverage, carried, tangent)
         do i = cell%first, cell%last
            associate (s => face%samples(i))
               corners = positions(:, master%facets(:, s%facet))
               call add_turning(face, s, corners, scale*s%weight, traction(1), shear, tangent)
            end associate
         end do
      end associate
   end subroutine add_cell_response

   !> Nodes of a sample and of the facet opposite, and how a motion of each counts in the relative
   !> motion.
   pure subroutine find_shares(face, sample, facet, natural, nodes, shares)
      type(contact_face), intent(in) :: face
      type(contact_sample), intent(in) :: sample
      integer, intent(in) :: facet
      real(wp), intent(in) :: natural(2)
      integer, intent(out) :: nodes(8)
      real(wp), intent(out) :: shares(8)

      nodes(:4) = [1, 2, 3, 4]
      nodes(5:) = face%corners(:, findloc(face%facets, facet, 1))
      shares(:4) = sample%shape
      shares(5:) = -facet_shape(natural)
   end subroutine find_shares

   !> Derivative of the tractions and of the coverage, with all directions held.
   pure subroutine add_law(tangents, cell, nodes, by_normal, by_slip, by_coverage, carried, &
         tangent)
      real(wp), intent(in) :: tangents(3, 2)
      type(contact_cell), intent(in) :: cell
      integer, intent(in) :: nodes(:)
      real(wp), intent(in) :: by_normal(:, :), by_slip(:), by_coverage(:, :), carried(:)
      real(wp), intent(inout) :: tangent(:, :)
      real(wp) :: change(3, 3), shear(3, 3)
      integer :: i, j, k, row, column

      associate (d => cell%trial%tangent, scale => cell%area*cell%coverage)
         do j = 1, size(nodes)
            do k = 1, 3
               ! of pressure and shear stresses times the area covered
               change(:, k) = scale*(d(k, 1)*by_normal(:, nodes(j)) &
                  + by_slip(nodes(j))*matmul(tangents, d(k, 2:))) &
                  + cell%area*cell%trial%traction(k)*by_coverage(:, nodes(j))
            end do
            shear = outer(tangents(:, 1), change(:, 2)) + outer(tangents(:, 2), change(:, 3))
            do i = 1, size(nodes)
               row = 3*nodes(i)
               do k = 1, 3
                  column = 3*nodes(j) - 3 + k
                  tangent(row - 2:row, column) = tangent(row - 2:row, column) &
                     + by_normal(:, nodes(i))*change(k, 1) + carried(nodes(i))*shear(:, k)
               end do
            end do
         end do
      end associate
   end subroutine add_law

   !> Derivative of the directions and places where a sample's traction acts, at that traction: -m3
   !> turns with the facet, and the foot of the ray moves over it.
   pure subroutine add_turning(face, sample, corners, scale, pressure, shear, tangent)
      type(contact_face), intent(in) :: face
      type(contact_sample), intent(in) :: sample
      real(wp), intent(in) :: corners(3, 4), scale, pressure, shear(3)
      real(wp), intent(inout) :: tangent(:, :)
      real(wp) :: shares(8), foot(3, 8), traction(3), turning(3, 3), twist
      integer :: nodes(8), i, j, k, row, column

      call find_shares(face, sample, sample%facet, sample%ray%natural, nodes, shares)
      associate (m => sample%ray%inverse)
         foot(:, :4) = 0.0_wp
         foot(:, 5:) = -scale*matmul(transpose(m(:2, :)), &
            transpose(facet_slopes(sample%ray%natural)))
         traction = shear - pressure*m(3, :)
         twist = scale*pressure*dot_product(m(3, :), matmul(corners, facet_twist))
         turning = twist*(outer(m(1, :), m(2, :)) + outer(m(2, :), m(1, :)))
         do j = 1, 8
            do k = 1, 3
               column = 3*nodes(j) - 3 + k
               do i = 1, 8
                  row = 3*nodes(i)
                  tangent(row - 2:row, column) = tangent(row - 2:row, column) &
                     + shares(i)*(shares(j)*turning(:, k) - pressure*m(3, k)*foot(:, j)) &
                     + shares(j)*foot(k, i)*traction
               end do
            end do
         end do
      end associate
   end subroutine add_turning

   pure function outer(u, v) result(matrix)
      real(wp), intent(in) :: u(:), v(:)
      real(wp) :: matrix(size(u), size(v))
      integer :: j

      do j = 1, size(v)
         matrix(:, j) = u*v(j)
      end do
   end function outer

end module asperity_solid_contact_cell_response
