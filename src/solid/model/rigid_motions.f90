!> Motions of a solid that strain nothing, which multigrid needs to know.
module asperity_solid_model_rigid_motions
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: rigid_motions

contains

   !> Three translations and three small rotations of all nodes, at right angles and of length one.
   !> An unknown of several nodes moves as the first of them.
   pure function rigid_motions(nodes, numbers, n) result(motions)
      !> Coordinates of the nodes; numbers of their displacements, others than unknowns below one
      real(wp), intent(in) :: nodes(:, :)
      integer, intent(in) :: numbers(:, :)
      !> Number of unknowns
      integer, intent(in) :: n
      !> A column a motion
      real(wp) :: motions(n, 6)
      real(wp) :: from_middle(3), size_of_all
      integer :: i, j, next, last

      associate (middle => sum(nodes, 2)/size(nodes, 2))
         size_of_all = maxval(abs(nodes - spread(middle, 2, size(nodes, 2))))
         motions = 0.0_wp
         do j = size(nodes, 2), 1, -1
            from_middle = (nodes(:, j) - middle)/size_of_all
            do i = 1, 3
               if (numbers(i, j) < 1) cycle
               next = modulo(i, 3) + 1
               last = modulo(i + 1, 3) + 1
               associate (motion => motions(numbers(i, j), :))
                  motion = 0.0_wp
                  motion(i) = 1.0_wp
                  motion(3 + next) = from_middle(last)
                  motion(3 + last) = -from_middle(next)
               end associate
            end do
         end do
      end associate
      do j = 1, 6
         do i = 1, j - 1
            motions(:, j) = motions(:, j) &
               - dot_product(motions(:, i), motions(:, j))*motions(:, i)
         end do
         motions(:, j) = motions(:, j)/max(norm2(motions(:, j)), tiny(1.0_wp))
      end do
   end function rigid_motions

end module asperity_solid_model_rigid_motions
