!> Mesh of a disc: a square in the middle, whose sides bulge, and rings of cells around it, so that
!> no cell is flat at the rim. Layers of it make the disc.
module asperity_deck_mesh_disc
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_cuts, only: even_cuts
   use asperity_deck_mesh_hexahedra, only: hex_mesh
   implicit none
   private
   public :: new_disc_mesh

   !> Middle of a side of the square, and its corners, as shares of the radius: near the places at
   !> which cells of the square and of the rings are of one size
   real(wp), parameter :: side = 0.56_wp, corner = 0.66_wp

contains

   !> A disc with its axis along z. The nodes of the rim are as far outside the circle as makes the
   !> area that of the circle, whatever the size of the cells.
   pure subroutine new_disc_mesh(mesh, diameter, bottom, top, cell)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Diameter, and heights of the lower and the upper face, mm
      real(wp), intent(in) :: diameter, bottom, top
      !> Length of an edge aimed at, mm
      real(wp), intent(in) :: cell
      real(wp), allocatable :: z(:), plan(:, :)
      integer, allocatable :: cells(:, :)
      integer :: n, k

      call even_cuts(bottom, top, cell, 1, z)
      call new_plan(0.5_wp*diameter, cell, plan, cells)
      n = size(plan, 2)
      allocate (mesh%nodes(3, n*size(z)), mesh%elements(8, size(cells, 2)*(size(z) - 1)))
      do k = 1, size(z)
         mesh%nodes(1:2, (k - 1)*n + 1:k*n) = plan
         mesh%nodes(3, (k - 1)*n + 1:k*n) = z(k)
      end do
      n = size(cells, 2)
      do k = 1, size(z) - 1
         mesh%elements(1:4, (k - 1)*n + 1:k*n) = cells + (k - 1)*size(plan, 2)
         mesh%elements(5:8, (k - 1)*n + 1:k*n) = cells + k*size(plan, 2)
      end do
   end subroutine new_disc_mesh

   !> Nodes and cells of one plane.
   pure subroutine new_plan(radius, cell, plan, cells)
      real(wp), intent(in) :: radius, cell
      real(wp), allocatable, intent(out) :: plan(:, :)
      integer, allocatable, intent(out) :: cells(:, :)
      real(wp) :: rim, u, share, angle
      integer :: n, rings, around, i, j, first, next

      ! cells along a side of the square, and so a quarter of the rim
      n = max(2, nint(0.5_wp*pi*radius/cell))
      rings = max(1, nint((1.0_wp - 0.5_wp*(side + corner))*radius/cell))
      around = 4*n
      rim = radius*sqrt(2.0_wp*pi/(around*sin(2.0_wp*pi/around)))
      allocate (plan(2, (n + 1)**2 + around*rings), cells(4, n**2 + around*rings))

      do j = 0, n
         do i = 0, n
            plan(:, j*(n + 1) + i + 1) = radius &
               *inner_place(2.0_wp*i/n - 1.0_wp, 2.0_wp*j/n - 1.0_wp)
         end do
      end do
      do j = 1, n
         do i = 1, n
            first = (j - 1)*(n + 1) + i
            cells(:, (j - 1)*n + i) = [first, first + 1, first + n + 2, first + n + 1]
         end do
      end do
      do j = 1, rings
         share = real(j, wp)/rings
         do i = 0, around - 1
            u = 0.5_wp*pi*i/n
            angle = u - 0.75_wp*pi
            plan(:, (n + 1)**2 + (j - 1)*around + i + 1) = share*rim*[cos(angle), sin(angle)] &
               + (1.0_wp - share)*plan(:, edge_node(n, i))
         end do
         do i = 0, around - 1
            next = mod(i + 1, around)
            cells(:, n**2 + (j - 1)*around + i + 1) = [ring_node(j - 1, i), ring_node(j, i), &
               ring_node(j, next), ring_node(j - 1, next)]
         end do
      end do

   contains

      !> Node of a ring; ring 0 is the edge of the square.
      pure integer function ring_node(ring, place)
         integer, intent(in) :: ring, place

         ring_node = (n + 1)**2 + (ring - 1)*around + place + 1
         if (ring == 0) ring_node = edge_node(n, place)
      end function ring_node

   end subroutine new_plan

   !> Place in the square with bulging sides, over the radius, of u and v from -1 to 1.
   pure function inner_place(u, v) result(place)
      real(wp), intent(in) :: u, v
      real(wp) :: place(2)

      place = [u*(side + (corner/sqrt(2.0_wp) - side)*v**2), &
         v*(side + (corner/sqrt(2.0_wp) - side)*u**2)]
   end function inner_place

   !> Node on the edge of the square of n cells a side, counted around from the corner at the lower
   !> left.
   pure integer function edge_node(n, place)
      integer, intent(in) :: n, place
      integer :: along

      along = mod(place, n)
      select case (place/n)
      case (0)
         edge_node = along + 1
      case (1)
         edge_node = (along + 1)*(n + 1)
      case (2)
         edge_node = (n + 1)**2 - along
      case default
         edge_node = (n - along)*(n + 1) + 1
      end select
   end function edge_node

end module asperity_deck_mesh_disc
