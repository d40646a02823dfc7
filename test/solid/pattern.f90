!> Unknowns of the joint, and the pattern of their matrix against a dense one.
module test_solid_pattern
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   use asperity_solid_mesh_joint, only: solid_mesh
   use asperity_solid_model_equations, only: held, moved, number_equations
   use asperity_solid_solve_pattern, only: block_list, block_places, find_pattern
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_pattern

   integer(int64), parameter :: seed = 14142135_int64

contains

   function suite_pattern() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('equations of a solid')
      call suite%addTest(TestMethod('unknowns, held and moved displacements', test_numbers))
      call suite%addTest(TestMethod('sum of small matrices', test_sum))
   end function suite_pattern

   !> Eight nodes: two of the foot, two of the head, one in the plane of symmetry, one load.
   subroutine test_numbers()
      type(solid_mesh) :: mesh
      integer, allocatable :: numbers(:, :)
      integer :: n

      allocate (mesh%nodes(3, 8), source=0.0_wp)
      mesh%foot = [1, 2]
      allocate (mesh%heads(1))
      mesh%heads(1)%nodes = [3, 4]
      mesh%middle = [5]
      mesh%load = [6]
      mesh%axial_node = 7
      call number_equations(mesh, .false., numbers, n)
      call assertEqual([held, held, held, held, held, held], pack(numbers(:, 1:2), .true.))
      call assertEqual([held, held, 1, held, held, 1], pack(numbers(:, 3:4), .true.), 'level')
      call assertEqual([2, held, 3, 4, 5, moved], pack(numbers(:, 5:6), .true.))
      call assertEqual([6, 7, 8, 9, 10, 11], pack(numbers(:, 7:8), .true.))
      call assertEqual(11, n)
      call number_equations(mesh, .true., numbers, n)
      call assertEqual([held, 6, 7], numbers(:, 7), 'held along the beam')
      call assertEqual(10, n)
   end subroutine test_numbers

   !> Random blocks with numbers that have no row, and numbers that come twice.
   subroutine test_sum()
      integer, parameter :: n = 30, n_blocks = 25
      type(random_stream) :: stream
      type(block_list) :: blocks(n_blocks)
      type(block_places), allocatable :: places(:)
      integer, allocatable :: row_start(:), columns(:)
      real(wp), allocatable :: values(:)
      real(wp) :: dense(n, n), sparse(n, n), entry
      integer :: b, i, j, k

      stream = random_stream(seed)
      print '(a, i0)', '     seed ', seed
      do b = 1, n_blocks
         allocate (blocks(b)%numbers(3 + mod(b, 5)))
         do i = 1, size(blocks(b)%numbers)
            blocks(b)%numbers(i) = floor(stream%uniform(-1.0_wp, n + 0.999_wp))
         end do
      end do
      blocks(1)%numbers(2) = max(blocks(1)%numbers(1), 1)
      blocks(1)%numbers(1) = blocks(1)%numbers(2)
      call find_pattern(n, blocks, row_start, columns, places)
      allocate (values(size(columns)), source=0.0_wp)
      dense = 0.0_wp
      do b = 1, n_blocks
         do j = 1, size(blocks(b)%numbers)
            do i = 1, size(blocks(b)%numbers)
               entry = stream%uniform(-1.0_wp, 1.0_wp)
               k = places(b)%at(i, j)
               call assertTrue((k > 0) .eqv. min(blocks(b)%numbers(i), blocks(b)%numbers(j)) > 0)
               if (k == 0) cycle
               values(k) = values(k) + entry
               associate (r => blocks(b)%numbers(i), c => blocks(b)%numbers(j))
                  dense(r, c) = dense(r, c) + entry
               end associate
            end do
         end do
      end do
      sparse = 0.0_wp
      do i = 1, n
         do k = row_start(i) + 1, row_start(i + 1)
            sparse(i, columns(k) + 1) = values(k)
            if (k > row_start(i) + 1) call assertTrue(columns(k) > columns(k - 1), 'rising')
         end do
      end do
      call assertEqual(0.0_wp, maxval(abs(sparse - dense)), tolerance=1.0e-14_wp)
      call assertEqual(size(columns), row_start(n + 1))
   end subroutine test_sum

end module test_solid_pattern
