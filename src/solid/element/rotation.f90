!> The rotation in a deformation gradient.
module asperity_solid_element_rotation
   use asperity_base_kinds, only: wp
   use asperity_solid_small_matrices, only: invert
   implicit none
   private
   public :: polar_rotation, is_inverted

   !> Largest entry of a gradient and smallest determinant of one whose largest entry is 1: beyond
   !> them an iterate has gone astray, and strains of it are of no use
   real(wp), parameter :: largest_stretch = 1000.0_wp, smallest_volume = 1.0e-9_wp
   !> Change at which an iteration that converges quadratically has arrived
   real(wp), parameter :: arrived = 1.0e-8_wp
   !> Iterations; four are usual, six are the most for gradients that are not refused
   integer, parameter :: most_iterations = 20

contains

   !> The rotation R of F = R U, U symmetric and positive, by Newton's iteration
   !> R <- (g R + R^-T/g)/2 with the scale g that makes both terms alike (N. J. Higham, Computing
   !> the polar decomposition - with applications, SIAM J. Sci. Stat. Comput. 7, 1986).
   pure subroutine polar_rotation(gradient, rotation, inverted)
      !> Deformation gradient F
      real(wp), intent(in) :: gradient(3, 3)
      !> R; not set when `inverted`
      real(wp), intent(out) :: rotation(3, 3)
      !> F turns inside out, is flat, or stretches a thousandfold
      logical, intent(out) :: inverted
      real(wp) :: inverse(3, 3), next(3, 3), determinant, scale, change
      integer :: iteration

      inverted = is_inverted(gradient)
      if (inverted) return
      rotation = gradient/maxval(abs(gradient))
      call invert(rotation, inverse, determinant)
      do iteration = 1, most_iterations
         scale = sqrt(sqrt(sum(inverse**2)/sum(rotation**2)))
         next = 0.5_wp*(scale*rotation + transpose(inverse)/scale)
         change = maxval(abs(next - rotation))
         rotation = next
         if (change < arrived) exit
         call invert(rotation, inverse, determinant)
      end do
   end subroutine polar_rotation

   !> Whether a gradient turns inside out, is flat, or stretches a thousandfold.
   pure logical function is_inverted(gradient)
      !> Deformation gradient F
      real(wp), intent(in) :: gradient(3, 3)
      real(wp) :: inverse(3, 3), determinant, scale

      scale = maxval(abs(gradient))
      is_inverted = .not. (scale > 0.0_wp .and. scale < largest_stretch)
      if (is_inverted) return
      call invert(gradient/scale, inverse, determinant)
      is_inverted = .not. determinant > smallest_volume
   end function is_inverted

end module asperity_solid_element_rotation
