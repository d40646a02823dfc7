!> The one scalar equation of the return to the yield surface, in the common eigenvectors of
!> stiffness and surface.
!>
!> The stress there, less the centre, falls from its trial value to trial/(1 + m values), m the
!> multiplier, an increment of the equivalent plastic strain over the yield stress at its end. Its
!> norm N(m) must be that yield stress. On a straight piece of the hardening, stress b +
!> h*increment, that is b/N(m) + h m = 1. 1/N is concave, as each share of N is constant/(constant
!> + m); so from the beginning of the piece Newton's iteration comes to the root from one side:
!> from below for b > 0, from above for b < 0, where a steep piece begins after the strain at the
!> start. It needs no guard.
module asperity_solid_material_return_map
   use asperity_base_kinds, only: wp
   use asperity_solid_material_hardening, only: hardening_curve, piece_of
   implicit none
   private
   public :: find_multiplier

   !> Change of the yield stress, relatively, after which one more step is exact to rounding
   real(wp), parameter :: tolerance = 1.0e-10_wp
   !> Most steps; seven did for strains of up to 1e100
   integer, parameter :: most_steps = 50

contains

   !> Return from a trial stress outside the yield surface.
   pure subroutine find_multiplier(multiplier, slope, values, trial, curve, strain)
      !> Multiplier, 1/MPa
      real(wp), intent(out) :: multiplier
      !> Slope of the yield stress at the end, MPa
      real(wp), intent(out) :: slope
      !> Eigenvalues, and the trial stress less the centre in their vectors
      real(wp), intent(in) :: values(6), trial(6)
      !> Hardening
      type(hardening_curve), intent(in) :: curve
      !> Equivalent plastic strain at the start
      real(wp), intent(in) :: strain
      real(wp) :: shares(6), factors(6), square, fall, base, excess, at_end
      integer :: piece, step

      shares = values*trial**2
      multiplier = 0.0_wp
      do piece = piece_of(curve, strain), size(curve%strains) - 1
         at_end = (curve%strains(piece + 1) - strain)/curve%stresses(piece + 1)
         if (sum(shares/(1.0_wp + at_end*values)**2) <= curve%stresses(piece + 1)**2) exit
         multiplier = at_end
      end do
      slope = curve%slopes(piece)
      ! the yield stress that the piece would have at the start
      base = curve%stresses(piece) + slope*(strain - curve%strains(piece))
      do step = 1, most_steps
         factors = 1.0_wp/(1.0_wp + multiplier*values)
         square = sum(shares*factors**2)
         fall = sum(shares*values*factors**3)
         excess = base/sqrt(square) + slope*multiplier - 1.0_wp
         multiplier = multiplier - excess/(base*fall/(square*sqrt(square)) + slope)
         if (abs(excess) <= tolerance) return
      end do
   end subroutine find_multiplier

end module asperity_solid_material_return_map
