!> True segments: the cells of a slave facet are cut by the master facets opposite to it, and every
!> piece gets a sample at its centroid. So the mean gap of a cell over a plane master is exact, and
!> forces of a uniform pressure are those of the exact integral on meshes of parallel edges.
module asperity_solid_contact_cut
   use asperity_base_kinds, only: wp
   use asperity_solid_contact_cell, only: contact_sample
   use asperity_solid_contact_face, only: cell_place, contact_face
   use asperity_solid_contact_geometry_facet, only: facet_shape, facet_slopes, least_cosine
   use asperity_solid_contact_geometry_polygon, only: clip_to_rectangle
   use asperity_solid_contact_geometry_surface, only: contact_surface
   use asperity_solid_small_matrices, only: cross, invert
   implicit none
   private
   public :: cut_face

   !> A piece below this share of its cell is none
   real(wp), parameter :: smallest_share = 1.0e-6_wp

   !> A master facet seen from a slave facet.
   type :: opposite_facet
      !> Its number
      integer :: facet = 0
      !> Its corners in natural coordinates of the slave facet
      real(wp) :: corners(2, 4) = 0.0_wp
   end type opposite_facet

contains

   !> Samples of all cells of a face, each with the facet near which its ray is to be sought. What
   !> of a cell is past the rim of the master is one piece, near the facet where the ray from the
   !> cell's middle ends, so that weights sum to one and their centroid is the cell's middle.
   pure subroutine cut_face(face, master, positions)
      !> The face; the rays of its cells' middles are known
      type(contact_face), intent(inout) :: face
      !> The master surface
      type(contact_surface), intent(in) :: master
      !> Places of all nodes, mm
      real(wp), intent(in) :: positions(:, :)
      type(opposite_facet), allocatable :: opposite(:)
      type(contact_sample), allocatable :: samples(:)
      real(wp) :: place(2), rest(2), half, area, centroid(2), share, covered
      integer :: i, j, n, cells

      call find_opposite(face, master, positions, opposite)
      cells = nint(sqrt(real(size(face%cells), wp)))
      half = 1.0_wp/cells
      allocate (samples(size(face%cells)*(size(opposite) + 1)))
      n = 0
      do i = 1, size(face%cells)
         associate (cell => face%cells(i))
            place = cell_place(i, cells)
            cell%first = n + 1
            covered = 0.0_wp
            rest = place
            do j = 1, size(opposite)
               call clip_to_rectangle(opposite(j)%corners, place - half, place + half, area, &
                  centroid)
               ! seen from the slave, its sense is clockwise
               share = -area/(4.0_wp*half*half)
               if (share < smallest_share) cycle
               call add_sample(samples, n, opposite(j)%facet, share, centroid)
               covered = covered + share
               rest = rest - share*centroid
            end do
            if (covered < 1.0_wp - smallest_share) then
               rest = rest/(1.0_wp - covered)
               call add_sample(samples, n, cell%middle%facet, 1.0_wp - covered, &
                  min(max(rest, place - half), place + half))
            else
               samples(cell%first:n)%weight = samples(cell%first:n)%weight/covered
            end if
            cell%last = n
         end associate
      end do
      face%samples = samples(:n)
   end subroutine cut_face

   pure subroutine add_sample(samples, n, facet, weight, place)
      type(contact_sample), intent(inout) :: samples(:)
      integer, intent(inout) :: n
      integer, intent(in) :: facet
      real(wp), intent(in) :: weight, place(2)

      n = n + 1
      samples(n)%weight = weight
      samples(n)%shape = facet_shape(place)
      samples(n)%start_facet = facet
   end subroutine add_sample

   !> Master facets that face the slave facet and lie over it, seen along its normal. Their corners
   !> are mapped as at its middle: exact for a parallelogram, near enough for what it becomes.
   pure subroutine find_opposite(face, master, positions, opposite)
      type(contact_face), intent(in) :: face
      type(contact_surface), intent(in) :: master
      real(wp), intent(in) :: positions(:, :)
      type(opposite_facet), allocatable, intent(out) :: opposite(:)
      type(opposite_facet) :: found(size(master%facets, 2))
      real(wp) :: x(3, 4), a(3, 3), inverse(3, 3), determinant, middle(3), area(3)
      integer :: i, k, n

      x = positions(:, face%nodes(:4))
      middle = 0.25_wp*sum(x, 2)
      a(:, :2) = matmul(x, facet_slopes([0.0_wp, 0.0_wp]))
      a(:, 3) = face%normal
      call invert(a, inverse, determinant)
      n = 0
      do i = 1, size(found)
         x = positions(:, master%facets(:, i))
         area = cross(x(:, 3) - x(:, 1), x(:, 4) - x(:, 2))
         if (-dot_product(face%normal, area) < least_cosine*norm2(area)) cycle
         do k = 1, 4
            found(n + 1)%corners(:, k) = matmul(inverse(:2, :), x(:, k) - middle)
         end do
         if (any(minval(found(n + 1)%corners, 2) >= 1.0_wp) &
            .or. any(maxval(found(n + 1)%corners, 2) <= -1.0_wp)) cycle
         n = n + 1
         found(n)%facet = i
      end do
      opposite = found(:n)
   end subroutine find_opposite

end module asperity_solid_contact_cut
