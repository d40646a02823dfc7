!> Motions that strain nothing.
module test_solid_rigid_motions
   use asperity, only: wp
   use asperity_solid_model_equations, only: held
   use asperity_solid_model_rigid_motions, only: rigid_motions
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   implicit none
   private
   public :: suite_rigid_motions

contains

   function suite_rigid_motions() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('rigid motions')
      call suite%addTest(TestMethod('distances stay, six at right angles', test_distances))
      call suite%addTest(TestMethod('held and shared displacements', test_held))
   end function suite_rigid_motions

   !> To first order: the change of a distance is along it.
   subroutine test_distances()
      real(wp) :: nodes(3, 5), motions(15, 6), moved(3, 5), products(6, 6)
      integer :: i, j, k, numbers(3, 5)

      nodes = 100.0_wp + 50.0_wp*reshape([(sin(3.0_wp*i), i=1, 15)], [3, 5])
      numbers = reshape([(i, i=1, 15)], [3, 5])
      motions = rigid_motions(nodes, numbers, 15)
      products = matmul(transpose(motions), motions)
      do k = 1, 6
         products(k, k) = products(k, k) - 1.0_wp
         moved = reshape(motions(:, k), [3, 5])
         do i = 1, 5
            do j = 1, 5
               call assertLessThan(abs(dot_product(moved(:, i) - moved(:, j), &
                  nodes(:, i) - nodes(:, j))), 1.0e-12_wp)
            end do
         end do
      end do
      call assertLessThan(maxval(abs(products)), 1.0e-14_wp)
   end subroutine test_distances

   !> What is held has no row; what two nodes share moves with the first.
   subroutine test_held()
      real(wp) :: nodes(3, 3), motions(7, 6), free(9, 6)
      integer :: i

      nodes = reshape([0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 2.0_wp, 0.0_wp], &
         [3, 3])
      motions = rigid_motions(nodes, reshape([1, 2, 3, 4, held, 3, 5, 6, 7], [3, 3]), 7)
      free = rigid_motions(nodes, reshape([(i, i=1, 9)], [3, 3]), 9)
      ! translations keep their directions, whatever is held
      call assertEqual(0.0_wp, motions(2, 1), tolerance=0.0_wp)
      call assertEqual(motions(1, 1), motions(4, 1), tolerance=0.0_wp)
      call assertEqual(1.0_wp/sqrt(3.0_wp), motions(1, 1), tolerance=1.0e-15_wp)
      call assertEqual(1.0_wp/sqrt(2.0_wp), motions(3, 3), tolerance=1.0e-15_wp)
      call assertEqual(1.0_wp/sqrt(3.0_wp), free(3, 3), tolerance=1.0e-15_wp)
   end subroutine test_held

end module test_solid_rigid_motions
