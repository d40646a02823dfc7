!> The share of a cell that has a surface opposite to it, near the surface's rims.
module asperity_solid_contact_geometry_coverage
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_geometry_surface, only: contact_surface
   implicit none
   private
   public :: find_coverage

   !> A cell has at least this share of its size in any direction
   real(wp), parameter :: least_width = 1.0e-3_wp

contains

   !> Coverage of a cell whose middle lies at a place of a facet: in each direction
   !> c = 1/2 + s/h between 0 and 1, with s how far inside the rim the middle is and h how wide
   !> the cell is across the rim. Lengths are those of the undeformed bodies, so that the coverage
   !> depends on the natural coordinates alone.
   pure subroutine find_coverage(surface, facet, natural, edges, coverage, gradient)
      !> The surface opposite
      type(contact_surface), intent(in) :: surface
      !> Facet and natural coordinates of the cell's middle
      integer, intent(in) :: facet
      real(wp), intent(in) :: natural(2)
      !> The cell's two edges, undeformed, mm
      real(wp), intent(in) :: edges(3, 2)
      !> Share of the cell that has the surface opposite
      real(wp), intent(out) :: coverage
      !> Its derivatives by the natural coordinates
      real(wp), intent(out) :: gradient(2)
      !> Natural direction of each edge, and its sense
      integer, parameter :: along(4) = [2, 1, 2, 1], sense(4) = [-1, 1, 1, -1]
      real(wp) :: width, distance, half_edge(3), share
      integer :: edge, direction

      coverage = 1.0_wp
      gradient = 0.0_wp
      do edge = 1, 4
         direction = along(edge)
         half_edge = surface%half_edges(:, direction, facet)
         width = max(sum(abs(matmul(half_edge, edges)))/norm2(half_edge), least_width*norm2(edges))
         distance = (1.0_wp - sense(edge)*natural(direction))*norm2(half_edge)
         distance = distance + beyond(surface, facet, edge, 0.5_wp*width - distance)
         share = 0.5_wp + distance/width
         if (share >= 1.0_wp) cycle
         if (share <= 0.0_wp) then
            coverage = 0.0_wp
            gradient = 0.0_wp
            return
         end if
         gradient = share*gradient
         gradient(direction) = gradient(direction) - coverage*sense(edge)*norm2(half_edge)/width
         coverage = share*coverage
      end do
   end subroutine find_coverage

   !> Length of the facets past an edge up to the rim, mm, as far as it is wanted.
   pure real(wp) function beyond(surface, facet, edge, wanted)
      type(contact_surface), intent(in) :: surface
      integer, intent(in) :: facet, edge
      real(wp), intent(in) :: wanted
      integer :: at, next, entered, direction

      beyond = 0.0_wp
      at = facet
      entered = modulo(edge + 1, 4) + 1
      do while (beyond < wanted)
         next = surface%neighbours(modulo(entered + 1, 4) + 1, at)
         if (next == 0) return
         ! straight on: out through the edge opposite to the one where it is entered
         entered = findloc(surface%neighbours(:, next), at, 1)
         at = next
         direction = merge(2, 1, modulo(entered, 2) == 1)
         beyond = beyond + 2.0_wp*norm2(surface%half_edges(:, direction, at))
      end do
   end function beyond

end module asperity_solid_contact_geometry_coverage
