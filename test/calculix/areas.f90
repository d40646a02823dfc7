!> Slave surfaces that are given by nodes: which faces of an element count. Faces are found here by
!> where the nodes of a unit element lie, nothing is taken from the tables that are tested.
module test_calculix_areas
   use asperity_base_kinds, only: wp
   use asperity_calculix_areas, only: leave_out_sides
   use funit, only: assertEqual, TestMethod, TestSuite
   implicit none
   private
   public :: suite_areas

   !> Most nodes of an element
   integer, parameter :: most = 20

contains

   function suite_areas() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('areas of slave nodes')
      call suite%addTest(TestMethod('hexahedra', test_hexahedra))
      call suite%addTest(TestMethod('tetrahedra', test_tetrahedra))
      call suite%addTest(TestMethod('wedges', test_wedges))
      call suite%addTest(TestMethod('all of a body', test_all))
   end function suite_areas

   !> Faces are z = 0, z = 1, y = 0, x = 1, y = 1, x = 0.
   subroutine test_hexahedra()
      real(wp) :: x(3, 20)

      x(1, :8) = [0.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.0_wp]
      x(2, :8) = [0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp]
      x(3, :8) = [0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp]
      call put_between(x, 9, [1, 2, 2, 3, 3, 4, 4, 1, 5, 6, 6, 7, 7, 8, 8, 5, 1, 5, 2, 6, 3, 7, &
         4, 8])
      call check_planes('C3D8I   ', x(:, :8), 6)
      call check_planes('C3D20R  ', x, 6)
   end subroutine test_hexahedra

   !> Faces are z = 0, y = 0, x + y + z = 1, x = 0.
   subroutine test_tetrahedra()
      real(wp) :: x(3, 10)

      x(:, :4) = 0.0_wp
      x(1, 2) = 1.0_wp
      x(2, 3) = 1.0_wp
      x(3, 4) = 1.0_wp
      call put_between(x, 5, [1, 2, 2, 3, 3, 1, 1, 4, 2, 4, 3, 4])
      call check_planes('C3D4    ', x(:, :4), 4)
      call check_planes('C3D10   ', x, 4)
   end subroutine test_tetrahedra

   !> Faces are z = 0, z = 1, y = 0, x + y = 1, x = 0.
   subroutine test_wedges()
      real(wp) :: x(3, 15)

      x(1, :6) = [0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp]
      x(2, :6) = [0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp]
      x(3, :6) = [0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 1.0_wp, 1.0_wp]
      call put_between(x, 7, [1, 2, 2, 3, 3, 1, 4, 5, 5, 6, 6, 4, 1, 4, 2, 5, 3, 6])
      call check_planes('C3D6    ', x(:, :6), 5)
      call check_planes('C3D15   ', x, 5)
   end subroutine test_wedges

   !> Every face counts when all nodes are slaves.
   subroutine test_all()
      integer :: i

      call assertEqual(6*8, nint(sum(shares('C3D8I   ', [(i, i=1, 8)], 6))), 'all shares')
   end subroutine test_all

   !> Nodes in the middle between pairs of others.
   pure subroutine put_between(x, first, ends)
      real(wp), intent(inout) :: x(:, :)
      integer, intent(in) :: first, ends(:)
      integer :: i

      do i = 1, size(ends)/2
         x(:, first + i - 1) = 0.5_wp*(x(:, ends(2*i - 1)) + x(:, ends(2*i)))
      end do
   end subroutine put_between

   !> With the nodes of a plane as slaves, that face alone counts, for all of them; without one of
   !> them none does.
   subroutine check_planes(kind, x, faces)
      character(len=8), intent(in) :: kind
      real(wp), intent(in) :: x(:, :)
      integer, intent(in) :: faces
      integer, allocatable :: nodes(:)
      real(wp) :: found(faces)
      integer :: i, face

      do face = 1, faces
         nodes = pack([(i, i=1, size(x, 2))], lies_in(kind, face, x))
         found = shares(kind, nodes, faces)
         call assertEqual(real(size(nodes), wp), found(face), 0.0_wp, kind//'the face')
         call assertEqual(real(size(nodes), wp), sum(found), 0.0_wp, kind//'no other')
         found = shares(kind, nodes(:size(nodes) - 1), faces)
         call assertEqual(0.0_wp, sum(found), 0.0_wp, kind//'one node less')
      end do
   end subroutine check_planes

   !> Which nodes lie in the plane of a face.
   pure function lies_in(kind, face, x) result(inside)
      character(len=8), intent(in) :: kind
      integer, intent(in) :: face
      real(wp), intent(in) :: x(:, :)
      logical :: inside(size(x, 2))
      character(len=6) :: planes

      select case (kind)
      case ('C3D8I', 'C3D20R')
         planes = 'zZyXYx'
      case ('C3D4', 'C3D10')
         planes = 'zyDx'
      case default
         planes = 'zZyEx'
      end select
      select case (planes(face:face))
      case ('x')
         inside = abs(x(1, :)) < 0.1_wp
      case ('y')
         inside = abs(x(2, :)) < 0.1_wp
      case ('z')
         inside = abs(x(3, :)) < 0.1_wp
      case ('X')
         inside = abs(x(1, :) - 1.0_wp) < 0.1_wp
      case ('Y')
         inside = abs(x(2, :) - 1.0_wp) < 0.1_wp
      case ('Z')
         inside = abs(x(3, :) - 1.0_wp) < 0.1_wp
      case ('D')
         inside = abs(sum(x, 1) - 1.0_wp) < 0.1_wp
      case default
         inside = abs(x(1, :) + x(2, :) - 1.0_wp) < 0.1_wp
      end select
   end function lies_in

   !> Sum of the shares that slave nodes keep in each face of element 1; each has one in all before.
   function shares(kind, nodes, faces) result(kept)
      character(len=8), intent(in) :: kind
      integer, intent(in) :: nodes(:), faces
      real(wp) :: kept(faces), xnoels(most*faces)
      integer :: i, j, place, kon(most), islavsurf(2, faces), iponoels(most), inoels(2, most*faces)

      kon = [(i, i=1, most)]
      iponoels = 0
      islavsurf(1, :) = [(10 + i, i=1, faces)]
      islavsurf(2, :) = 0
      xnoels = 1.0_wp
      place = 0
      do i = 1, size(nodes)
         do j = 1, faces
            place = place + 1
            inoels(:, place) = [j, iponoels(nodes(i))]
            iponoels(nodes(i)) = place
         end do
      end do
      call leave_out_sides(nodes, [1, faces], [0], kon, [kind], islavsurf, iponoels, inoels, xnoels)
      kept = 0.0_wp
      do i = 1, place
         kept(inoels(1, i)) = kept(inoels(1, i)) + xnoels(i)
      end do
   end function shares

end module test_calculix_areas
