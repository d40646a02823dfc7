!> Moments of the upper tail of the standard normal density phi without loss of digits:
!> F_n(y) = integral_0^inf t^n phi(t + y) dt for n = 0, 1, 2.
module asperity_gaussian_tail
   use asperity_gauss_legendre, only: n_points, nodes, pairwise_sum, weights
   use asperity_kinds, only: wp
   implicit none
   private
   public :: tail_moments, density_reach

   !> 1/sqrt(2 pi)
   real(wp), parameter, public :: phi_0 = 0.398942280401432677939946_wp
   real(wp), parameter :: sqrt_half = 0.707106781186547524400844_wp
   !> The density is cut where it falls to exp(-45) of its largest value
   real(wp), parameter :: cut = 45.0_wp

contains

   !> Scaled moments: F_n(y) = moments(n) exp(-max(y, 0)^2/2), n = 0, 1, 2.
   !> For y > 0 by quadrature of t^n exp(-t (y + t/2)), which has positive terms only: the closed
   !> forms phi - y Q and (1 + y^2) Q - y phi lose 13 digits by y = 37.
   pure function tail_moments(y) result(moments)
      !> Lower end of the tail; any finite value up to 1e150 in size
      real(wp), intent(in) :: y
      real(wp) :: moments(0:2)
      real(wp) :: half
      real(wp), dimension(n_points) :: t, terms

      if (y > 0.0_wp) then
         half = 0.5_wp*density_reach(y)
         t = half*(1.0_wp + nodes)
         terms = (phi_0*half)*weights*exp(-t*(y + 0.5_wp*t))
         moments(0) = pairwise_sum(terms)
         terms = terms*t
         moments(1) = pairwise_sum(terms)
         moments(2) = pairwise_sum(terms*t)
      else
         moments(0) = 0.5_wp*erfc(sqrt_half*y)
         moments(1) = phi_0*exp(-0.5_wp*y*y) - y*moments(0)
         moments(2) = moments(0) - y*moments(1)
      end if
   end function tail_moments

   !> How far from y, away from zero, the density phi matters: where it is exp(-45) phi(y).
   pure elemental real(wp) function density_reach(y)
      !> Any finite value up to 1e150 in size
      real(wp), intent(in) :: y

      density_reach = 2.0_wp*cut/(sqrt(y*y + 2.0_wp*cut) + abs(y))
   end function density_reach

end module asperity_gaussian_tail
