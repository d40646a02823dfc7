!> What must hold of every mesh of a deck.
module mesh_checks
   use asperity, only: wp
   use asperity_deck_mesh_hexahedra, only: face_area, face_corners, hex_mesh, least_jacobian, &
      mesh_volume
   use funit, only: assertEqual, assertGreaterThan, assertTrue
   implicit none
   private
   public :: check_mesh, check_surface, outer_area

contains

   !> Elements are not turned inside out, every node is used, neighbours share whole faces, the
   !> outer faces are closed, and the volume is as expected.
   subroutine check_mesh(mesh, volume, name)
      type(hex_mesh), intent(in) :: mesh
      real(wp), intent(in) :: volume
      character(len=*), intent(in) :: name
      logical :: used(size(mesh%nodes, 2))
      real(wp) :: closed(3)
      integer, allocatable :: outer(:, :)
      integer :: i, most

      ! a quarter of the mean: sheared a lot, and still an element
      call assertGreaterThan(least_jacobian(mesh), 0.25_wp, message=name//': least Jacobian')
      call assertEqual(volume, mesh_volume(mesh), tolerance=1.0e-12_wp*volume, &
         message=name//': volume')
      used = .false.
      do i = 1, size(mesh%elements, 2)
         used(mesh%elements(:, i)) = .true.
      end do
      call assertTrue(all(used), message=name//': every node is used')
      call find_outer(mesh, outer, most)
      call assertEqual(2, most, message=name//': a face belongs to two elements at most')
      closed = 0.0_wp
      do i = 1, size(outer, 2)
         closed = closed + face_area(mesh, outer(:, i))
      end do
      call assertEqual(0.0_wp, norm2(closed), tolerance=1.0e-12_wp*outer_area(mesh), &
         message=name//': outer faces are closed')
   end subroutine check_mesh

   !> A surface has that sum of outward area vectors, in faces that lie outside, each once.
   subroutine check_surface(mesh, faces, expected, name)
      type(hex_mesh), intent(in) :: mesh
      integer, intent(in) :: faces(:, :)
      real(wp), intent(in) :: expected(3)
      character(len=*), intent(in) :: name
      real(wp) :: area(3), size_of
      integer, allocatable :: outer(:, :)
      logical :: outside
      integer :: i, j, most

      call find_outer(mesh, outer, most)
      area = 0.0_wp
      size_of = 0.0_wp
      outside = .true.
      do i = 1, size(faces, 2)
         area = area + face_area(mesh, faces(:, i))
         size_of = size_of + norm2(face_area(mesh, faces(:, i)))
         outside = outside &
            .and. count([(all(outer(:, j) == faces(:, i)), j=1, size(outer, 2))]) == 1
      end do
      call assertTrue(outside, message=name//': faces are outer ones')
      call assertEqual(0.0_wp, norm2(area - expected), tolerance=1.0e-11_wp*norm2(expected), &
         message=name//': area and normal')
      call assertEqual(norm2(expected), size_of, tolerance=1.0e-11_wp*norm2(expected), &
         message=name//': no face twice, none turned')
   end subroutine check_surface

   !> Area of all outer faces, mm^2.
   real(wp) function outer_area(mesh)
      type(hex_mesh), intent(in) :: mesh
      integer, allocatable :: outer(:, :)
      integer :: i, most

      call find_outer(mesh, outer, most)
      outer_area = sum([(norm2(face_area(mesh, outer(:, i))), i=1, size(outer, 2))])
   end function outer_area

   !> Faces of one element only, and how many elements share a face at most. Faces are told by
   !> their least corner, where they are kept in a list.
   subroutine find_outer(mesh, outer, most)
      type(hex_mesh), intent(in) :: mesh
      integer, allocatable, intent(out) :: outer(:, :)
      integer, intent(out) :: most
      integer :: first(size(mesh%nodes, 2)), next(6*size(mesh%elements, 2))
      integer :: key(4, 6*size(mesh%elements, 2)), times(6*size(mesh%elements, 2))
      integer :: i, j, n, k, at

      first = 0
      next = 0
      times = 0
      do i = 1, size(mesh%elements, 2)
         do j = 1, 6
            n = 6*(i - 1) + j
            key(:, n) = sorted(mesh%elements(face_corners(:, j), i))
            at = first(key(1, n))
            do while (at > 0)
               if (all(key(:, at) == key(:, n))) exit
               at = next(at)
            end do
            if (at == 0) then
               next(n) = first(key(1, n))
               first(key(1, n)) = n
               at = n
            end if
            times(at) = times(at) + 1
         end do
      end do
      most = maxval(times)
      allocate (outer(2, count(times == 1)))
      k = 0
      do n = 1, size(times)
         if (times(n) /= 1) cycle
         k = k + 1
         outer(:, k) = [(n - 1)/6 + 1, mod(n - 1, 6) + 1]
      end do
   end subroutine find_outer

   !> Four numbers in rising order.
   pure function sorted(numbers) result(rising)
      integer, intent(in) :: numbers(4)
      integer :: rising(4)
      integer :: i, j, kept

      rising = numbers
      do i = 1, 3
         j = i - 1 + minloc(rising(i:), 1)
         kept = rising(i)
         rising(i) = rising(j)
         rising(j) = kept
      end do
   end function sorted

end module mesh_checks
