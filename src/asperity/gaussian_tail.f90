!> Moments of the upper tail of the standard normal density phi without loss of digits:
!> F_n(y) = integral_0^inf t^n phi(t + y) dt for n = 0, 1, 2.
module asperity_gaussian_tail
   use asperity_kinds, only: wp
   implicit none
   private
   public :: tail_moments

   !> 1/sqrt(2 pi)
   real(wp), parameter, public :: phi_0 = 0.398942280401432677939946_wp
   real(wp), parameter :: sqrt_half = 0.707106781186547524400844_wp
   !> From here on the closed forms phi - y Q, (1 + y^2) Q - y phi lose digits
   real(wp), parameter :: fraction_start = 2.5_wp
   !> Levels of the continued fraction: enough for round-off at y = 2.5, more than enough beyond
   integer, parameter :: levels = 60

contains

   !> Scaled moments: F_n(y) = moments(n) exp(-max(y, 0)^2/2), n = 0, 1, 2.
   !> For y >= 2.5 by the continued fraction F_n/F_(n-1) = n/(y + F_(n+1)/F_n), which follows from
   !> F_(n+1) = n F_(n-1) - y F_n and has positive terms only.
   pure function tail_moments(y) result(moments)
      !> Lower end of the tail; any finite value up to 1e150 in size
      real(wp), intent(in) :: y
      real(wp) :: moments(0:2)
      real(wp) :: density, ratio, ratio_2
      integer :: n

      if (y >= fraction_start) then
         ratio = 0.5_wp*(sqrt(y*y + 4.0_wp*levels) - y)
         do n = levels, 3, -1
            ratio = n/(y + ratio)
         end do
         ratio_2 = 2.0_wp/(y + ratio)
         ratio = 1.0_wp/(y + ratio_2)
         moments(0) = phi_0/(y + ratio)
         moments(1) = ratio*moments(0)
         moments(2) = ratio_2*moments(1)
         return
      end if
      if (y > 0.0_wp) then
         density = phi_0
         moments(0) = 0.5_wp*erfc(sqrt_half*y)*exp(0.5_wp*y*y)
      else
         density = phi_0*exp(-0.5_wp*y*y)
         moments(0) = 0.5_wp*erfc(sqrt_half*y)
      end if
      moments(1) = density - y*moments(0)
      moments(2) = moments(0) - y*moments(1)
   end function tail_moments

end module asperity_gaussian_tail
