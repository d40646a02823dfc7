!> Two flat surfaces of a grid each, one over the other, for the tests of contact: the slave below
!> with its normal up, the master above with its normal down.
module contact_blocks
   use asperity, only: wp
   implicit none
   private
   public :: blocks, new_blocks, turn_master

   !> Nodes of both, and the facets of each.
   type :: blocks
      real(wp), allocatable :: nodes(:, :)
      integer, allocatable :: slave(:, :), master(:, :)
      !> Nodes of the slave; those of the master follow
      integer :: slave_nodes = 0
   end type blocks

contains

   !> Grids over rectangles. A master overlaps the slave by `overclosure`.
   function new_blocks(slave_cells, slave_from, slave_to, master_cells, master_from, master_to, &
         overclosure) result(b)
      integer, intent(in) :: slave_cells(2), master_cells(2)
      real(wp), intent(in) :: slave_from(2), slave_to(2), master_from(2), master_to(2), overclosure
      type(blocks) :: b
      real(wp), allocatable :: slave(:, :), master(:, :)
      integer, allocatable :: facets(:, :)

      call grid(slave_cells, slave_from, slave_to, 0.0_wp, slave, b%slave)
      call grid(master_cells, master_from, master_to, -overclosure, master, facets)
      b%slave_nodes = size(slave, 2)
      b%nodes = reshape([slave, master], [3, size(slave, 2) + size(master, 2)])
      ! outwards is down
      b%master = facets([1, 4, 3, 2], :) + b%slave_nodes
   end function new_blocks

   subroutine grid(cells, from, to, z, nodes, facets)
      integer, intent(in) :: cells(2)
      real(wp), intent(in) :: from(2), to(2), z
      real(wp), allocatable, intent(out) :: nodes(:, :)
      integer, allocatable, intent(out) :: facets(:, :)
      integer :: i, j, n, row

      row = cells(1) + 1
      allocate (nodes(3, row*(cells(2) + 1)), facets(4, cells(1)*cells(2)))
      do j = 0, cells(2)
         do i = 0, cells(1)
            nodes(:, j*row + i + 1) = [from(1) + (to(1) - from(1))*i/cells(1), &
               from(2) + (to(2) - from(2))*j/cells(2), z]
         end do
      end do
      do j = 0, cells(2) - 1
         do i = 0, cells(1) - 1
            n = j*row + i + 1
            facets(:, j*cells(1) + i + 1) = [n, n + 1, n + row + 1, n + row]
         end do
      end do
   end subroutine grid

   !> Turn the master about an axis through a point.
   subroutine turn_master(b, axis, centre, angle)
      type(blocks), intent(inout) :: b
      integer, intent(in) :: axis
      real(wp), intent(in) :: centre(3), angle
      real(wp) :: r(3, 3)
      integer :: i, j, k

      r = 0.0_wp
      i = modulo(axis, 3) + 1
      j = modulo(axis + 1, 3) + 1
      r(axis, axis) = 1.0_wp
      r(i, i) = cos(angle)
      r(j, j) = cos(angle)
      r(j, i) = sin(angle)
      r(i, j) = -sin(angle)
      do k = b%slave_nodes + 1, size(b%nodes, 2)
         b%nodes(:, k) = centre + matmul(r, b%nodes(:, k) - centre)
      end do
   end subroutine turn_master

end module contact_blocks
