!> Sets of values spread between the bounds of parameters, always the same ones: where searches
!> begin that are to find the lowest of several minima.
module asperity_fit_spread_sets
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter, y_of
   implicit none
   private
   public :: spread_set

contains

   !> y of one set: multiples of powers of the root of x^(p + 1) = x + 1, modulo one, which fill a
   !> space of p dimensions evenly (Roberts 2018, after Kronecker).
   pure function spread_set(parameters, which) result(y)
      !> The parameters
      type(fit_parameter), intent(in) :: parameters(:)
      !> Which set, from 1
      integer, intent(in) :: which
      real(wp) :: y(size(parameters))
      real(wp) :: root, share
      integer :: i

      root = 2.0_wp
      do i = 1, 60
         root = (1.0_wp + root)**(1.0_wp/real(size(parameters) + 1, wp))
      end do
      do i = 1, size(parameters)
         share = modulo(0.5_wp + real(which, wp)/root**i, 1.0_wp)
         associate (low => y_of(parameters(i), parameters(i)%lower), &
               high => y_of(parameters(i), parameters(i)%upper))
            y(i) = low + (high - low)*(0.01_wp + 0.98_wp*share)
         end associate
      end do
   end function spread_set

end module asperity_fit_spread_sets
