!> Principal stretches of a deformation gradient.
module asperity_solid_element_principal_stretches
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: find_principal_stretches

   !> Rounds of rotations; four or five are usual
   integer, parameter :: most_sweeps = 20
   !> Cosine of the angle between two images that stand upright to rounding
   real(wp), parameter :: upright = 4.0_wp*epsilon(1.0_wp)

contains

   !> Orthonormal directions N and their images F N, upright to each other, whose lengths are the
   !> stretches: Jacobi's rotations from one side (Golub, Van Loan, Matrix Computations, section
   !> 8.6). F'F is not formed, in which small stretches would drown.
   pure subroutine find_principal_stretches(gradient, directions, images)
      !> Deformation gradient F, its determinant above zero
      real(wp), intent(in) :: gradient(3, 3)
      !> N, in columns
      real(wp), intent(out) :: directions(3, 3)
      !> F N, in columns
      real(wp), intent(out) :: images(3, 3)
      real(wp) :: squares(2), mixed, ratio, tangent, cosine
      integer :: sweep, p, q
      logical :: is_done

      images = gradient
      directions = 0.0_wp
      do p = 1, 3
         directions(p, p) = 1.0_wp
      end do
      do sweep = 1, most_sweeps
         is_done = .true.
         do p = 1, 2
            do q = p + 1, 3
               squares = [dot_product(images(:, p), images(:, p)), &
                  dot_product(images(:, q), images(:, q))]
               mixed = dot_product(images(:, p), images(:, q))
               if (abs(mixed) <= upright*sqrt(squares(1)*squares(2))) cycle
               is_done = .false.
               ratio = (squares(2) - squares(1))/(2.0_wp*mixed)
               tangent = sign(1.0_wp, ratio)/(abs(ratio) + sqrt(1.0_wp + ratio**2))
               cosine = 1.0_wp/sqrt(1.0_wp + tangent**2)
               call rotate(images(:, p), images(:, q), cosine, cosine*tangent)
               call rotate(directions(:, p), directions(:, q), cosine, cosine*tangent)
            end do
         end do
         if (is_done) exit
      end do
   end subroutine find_principal_stretches

   !> Turn two vectors into each other.
   pure subroutine rotate(first, second, cosine, sine)
      real(wp), intent(inout) :: first(3), second(3)
      real(wp), intent(in) :: cosine, sine
      real(wp) :: before(3)

      before = first
      first = cosine*before - sine*second
      second = sine*before + cosine*second
   end subroutine rotate

end module asperity_solid_element_principal_stretches
