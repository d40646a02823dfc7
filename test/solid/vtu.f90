!> Files for ParaView: base 64, structure, values. With the environment variable ASPERITY_VTU the
!> files go to the folder that it names, where test/solid/read_vtu.py opens them.
module test_solid_vtu
   use, intrinsic :: iso_fortran_env, only: int32, int64, int8
   use asperity, only: error_type, wp
   use asperity_solid_vtu_base64, only: encode_base64
   use asperity_solid_vtu_document, only: write_pvd
   use asperity_solid_vtu_fields, only: body_fields, contact_fields, write_body, write_contact
   use funit, only: assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_vtu

   character(len=*), parameter :: alphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZ'// &
      'abcdefghijklmnopqrstuvwxyz0123456789+/'

contains

   function suite_vtu() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('files for ParaView')
      call suite%addTest(TestMethod('base 64', test_base64))
      call suite%addTest(TestMethod('body', test_body))
      call suite%addTest(TestMethod('contact cells', test_contact))
      call suite%addTest(TestMethod('series', test_series))
   end function suite_vtu

   !> The test vectors of RFC 4648, and bytes beyond 127.
   subroutine test_base64()
      character(len=:), allocatable :: text

      call check('', '')
      call check('f', 'Zg==')
      call check('fo', 'Zm8=')
      call check('foo', 'Zm9v')
      call check('foob', 'Zm9vYg==')
      call check('fooba', 'Zm9vYmE=')
      call check('foobar', 'Zm9vYmFy')
      call encode_base64([-1_int8, -2_int8, 0_int8], text)
      call assertEqual('//4A', text)
   contains
      subroutine check(plain, expected)
         character(len=*), intent(in) :: plain, expected

         call encode_base64(transfer(plain, [0_int8]), text)
         call assertEqual(expected, text)
      end subroutine check
   end subroutine test_base64

   !> Two steps of two bricks side by side, sheared: the arrays, decoded, have the values.
   subroutine test_body()
      type(body_fields) :: body
      character(len=:), allocatable :: text
      type(error_type), allocatable :: error
      integer :: step

      do step = 1, 2
         body = two_bricks(step)
         call write_body(body, text, error)
         call assertFalse(allocated(error))
         call keep('body_'//achar(iachar('0') + step)//'.vtu', text)
      end do
      call assertEqual(1, index(text, '<?xml version="1.0"?>'//new_line('a')//'<VTKFile type='// &
         '"UnstructuredGrid" version="1.0" byte_order="'))
      call assertTrue(index(text, '<Piece NumberOfPoints="12" NumberOfCells="2">') > 0, 'piece')
      call assertEqual(reshape(body%nodes, [36]), reals_of(text, 'Points'), tolerance=0.0_wp)
      call assertEqual(reshape(body%displacement, [36]), reals_of(text, 'displacement'), &
         tolerance=0.0_wp)
      call assertTrue(all(integers_of(text, 'connectivity') + 1 == reshape(body%elements, [16])), &
         'connectivity')
      call assertTrue(all(integers_of(text, 'offsets') == [8, 16]), 'offsets')
      call assertTrue(all(bytes_of(text, 'types') == 12_int8), 'types')
      ! means over points of 1 to 8 times the component are 4.5 times it
      call assertEqual(4.5_wp*2.0_wp*[1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, 6.0_wp, -1.0_wp, &
         -2.0_wp, -3.0_wp, -4.0_wp, -5.0_wp, -6.0_wp], reals_of(text, 'stress'), &
         tolerance=1.0e-13_wp)
      call assertEqual([0.08_wp, 0.16_wp], reals_of(text, 'plastic_strain'), tolerance=1.0e-15_wp)
      call assertEqual([1.0_wp, 2.0_wp], reals_of(text, 'part'), tolerance=0.0_wp)
   end subroutine test_body

   !> Cells of a facet that is no parallelogram: corners are bilinear, each cell has its values.
   subroutine test_contact()
      type(contact_fields) :: contact
      character(len=:), allocatable :: text
      type(error_type), allocatable :: error
      real(wp), allocatable :: places(:)
      integer :: i

      contact%nodes = reshape([0.0_wp, 0.0_wp, 1.0_wp, 6.0_wp, 0.0_wp, 1.0_wp, 3.0_wp, 6.0_wp, &
         1.0_wp, 0.0_wp, 3.0_wp, 1.0_wp], [3, 4])
      contact%displacement = 0.01_wp*contact%nodes
      contact%facets = reshape([1, 2, 3, 4], [4, 1])
      contact%cells = 3
      contact%face = [(2, i=1, 9)]
      contact%status = [(1 + mod(i, 3), i=1, 9)]
      contact%pressure = [(0.5_wp*i, i=1, 9)]
      contact%gap = [(-0.01_wp*i, i=1, 9)]
      contact%coverage = [(0.1_wp*i, i=1, 9)]
      contact%shear = reshape([(real(i, wp), i=1, 27)], [3, 9])
      call write_contact(contact, text, error)
      call assertFalse(allocated(error))
      call keep('contact.vtu', text)
      call assertTrue(index(text, '<Piece NumberOfPoints="16" NumberOfCells="9">') > 0, 'piece')
      allocate (places, source=reals_of(text, 'Points'))
      ! first row along the first edge; the last one from (0, 3) to (3, 6)
      call assertEqual([0.0_wp, 0.0_wp, 1.0_wp, 2.0_wp, 0.0_wp, 1.0_wp], places(:6), &
         tolerance=1.0e-14_wp)
      call assertEqual([0.0_wp, 3.0_wp, 1.0_wp, 1.0_wp, 4.0_wp, 1.0_wp], places(37:42), &
         tolerance=1.0e-14_wp)
      ! a third of the way across and up: 1/3 of 6, less 1/9 of 3; 1/3 of 3, and 1/9 of 3 more
      call assertEqual([5.0_wp/3.0_wp, 4.0_wp/3.0_wp, 1.0_wp], places(16:18), tolerance=1.0e-14_wp)
      call assertEqual(0.01_wp*places, reals_of(text, 'displacement'), tolerance=1.0e-14_wp)
      call assertTrue(all(integers_of(text, 'connectivity') == reshape([0, 1, 5, 4, 1, 2, 6, 5, &
         2, 3, 7, 6, 4, 5, 9, 8, 5, 6, 10, 9, 6, 7, 11, 10, 8, 9, 13, 12, 9, 10, 14, 13, 10, 11, &
         15, 14], [36])), 'connectivity')
      call assertTrue(all(bytes_of(text, 'types') == 9_int8), 'types')
      call assertEqual(contact%pressure, reals_of(text, 'pressure'), tolerance=0.0_wp)
      call assertEqual(contact%gap, reals_of(text, 'gap'), tolerance=0.0_wp)
      call assertEqual(contact%coverage, reals_of(text, 'coverage'), tolerance=0.0_wp)
      call assertEqual(reshape(contact%shear, [27]), reals_of(text, 'shear'), tolerance=0.0_wp)
      call assertEqual(real(contact%status, wp), reals_of(text, 'status'), tolerance=0.0_wp)
      call assertEqual(real(contact%face, wp), reals_of(text, 'face'), tolerance=0.0_wp)
   end subroutine test_contact

   !> Files with their times; a name with what XML reserves.
   subroutine test_series()
      character(len=:), allocatable :: text
      type(error_type), allocatable :: error

      call write_pvd([0.25_wp, 1.5_wp], ['body_1.vtu', 'body_2.vtu'], text, error)
      call assertFalse(allocated(error))
      call keep('body.pvd', text)
      call assertTrue(index(text, '<DataSet timestep="0.25" part="0" file="body_1.vtu"/>') > 0)
      call assertTrue(index(text, '<DataSet timestep="1.5" part="0" file="body_2.vtu"/>') > 0)
      call write_pvd([0.0_wp], ['a&b<"c".vtu'], text, error)
      call assertTrue(index(text, 'file="a&amp;b&lt;&quot;c&quot;.vtu"/>') > 0)
   end subroutine test_series

   !> Bricks of 2 x 3 x 5 mm beside each other along x, the first of part 1; read_vtu.py knows them.
   pure function two_bricks(step) result(body)
      integer, intent(in) :: step
      type(body_fields) :: body
      real(wp) :: place(3)
      integer :: i, j, k, n, point

      allocate (body%nodes(3, 12), body%displacement(3, 12), body%elements(8, 2), body%part(2))
      n = 0
      do k = 0, 1
         do j = 0, 1
            do i = 0, 2
               n = n + 1
               place = [2.0_wp*i, 3.0_wp*j, 5.0_wp*k]
               body%nodes(:, n) = place
               body%displacement(:, n) = 0.01_wp*step*[place(3), 0.0_wp, place(1)]
            end do
         end do
      end do
      body%elements(:, :) = reshape([1, 2, 5, 4, 7, 8, 11, 10, 2, 3, 6, 5, 8, 9, 12, 11], [8, 2])
      body%part(:) = [1, 2]
      allocate (body%stress(6, 8, 2), body%plastic_strain(8, 2))
      do point = 1, 8
         body%stress(:, point, 1) = point*step*[(real(i, wp), i=1, 6)]
         body%plastic_strain(point, :) = 0.005_wp*point*step*[1.0_wp, 2.0_wp]
      end do
      body%stress(:, :, 2) = -body%stress(:, :, 1)
   end function two_bricks

   !> Bytes of the array with a name, without the count before them, which must be right.
   function bytes_of(text, name) result(bytes)
      character(len=*), intent(in) :: text, name
      integer(int8), allocatable :: bytes(:)
      integer :: from, to, i, j, word, n

      from = index(text, ' Name="'//name//'"')
      call assertTrue(from > 0, name)
      from = from + index(text(from:), new_line('a'))
      to = from + index(text(from:), new_line('a')) - 2
      n = 3*((to - from + 1)/4) - count([(text(i:i) == '=', i=from, to)])
      allocate (bytes(n + 2))
      do i = from, to, 4
         word = 0
         do j = 0, 3
            word = 64*word + max(0, index(alphabet, text(i + j:i + j)) - 1)
         end do
         do j = 0, 2
            n = ibits(word, 16 - 8*j, 8)
            bytes(3*((i - from)/4) + j + 1) = int(merge(n - 256, n, n > 127), int8)
         end do
      end do
      bytes = bytes(:size(bytes) - 2)
      call assertTrue(transfer(bytes(:8), 0_int64) == size(bytes) - 8, name//': count of bytes')
      bytes = bytes(9:)
   end function bytes_of

   function reals_of(text, name) result(values)
      character(len=*), intent(in) :: text, name
      real(wp), allocatable :: values(:)

      allocate (values, source=transfer(bytes_of(text, name), [0.0_wp]))
   end function reals_of

   function integers_of(text, name) result(values)
      character(len=*), intent(in) :: text, name
      integer(int32), allocatable :: values(:)

      allocate (values, source=transfer(bytes_of(text, name), [0_int32]))
   end function integers_of

   !> Write a file where the environment asks for it.
   subroutine keep(name, text)
      character(len=*), intent(in) :: name, text
      character(len=1024) :: folder
      integer :: unit, length, status

      call get_environment_variable('ASPERITY_VTU', folder, length, status)
      if (status /= 0 .or. length == 0) return
      open (newunit=unit, file=folder(:length)//'/'//name, access='stream', form='unformatted', &
         status='replace', action='write', iostat=status)
      if (status /= 0) error stop 'ASPERITY_VTU names a folder that cannot be written to'
      write (unit) text
      close (unit)
   end subroutine keep

end module test_solid_vtu
