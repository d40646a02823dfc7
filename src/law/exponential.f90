!> The exponential function of many arguments at once, in a form that compilers turn into vector
!> instructions; the intrinsic is a call for each argument.
module asperity_law_exponential
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: exponentials

   !> Arguments that are handled side by side
   integer, parameter, public :: exponential_block = 4
   !> exp(x) = 2^(k/4) exp(r), |r| <= ln(2)/8; the first part of ln(2)/4 ends in 24 zero bits
   real(wp), parameter :: quarters_of_ln2 = 5.7707801635558536294_wp
   real(wp), parameter :: ln2_high = 0.17328679468482733_wp
   real(wp), parameter :: ln2_low = 4.5515899962603654599e-10_wp
   !> Keeps k positive where it is cut, so that cutting is rounding down
   integer, parameter :: offset = 600
   real(wp), parameter :: quarter_powers(0:3) = [1.0_wp, 1.1892071150027210667_wp, &
      1.4142135623730950488_wp, 1.6817928305074290861_wp]
   !> (exp(r) - 1 - r)/r^2 to 1.3e-17 of exp(r)
   real(wp), parameter :: c(0:6) = [ &
      0.5_wp, 0.16666666666679419891_wp, 0.041666666666679419637_wp, &
      0.0083333331974283901012_wp, 0.0013888888752986457607_wp, 0.0001984489046255152309_wp, &
      0.000024805207871390875803_wp]

contains

   !> exp(x) to 1.5 eps relative for -100 <= x <= 10; what is not a number stays none.
   pure subroutine exponentials(n, x, values)
      !> Number of arguments, a multiple of `exponential_block`
      integer, intent(in) :: n
      !> Arguments, between -100 and 10
      real(wp), intent(in) :: x(n)
      !> Their exponentials
      real(wp), intent(out) :: values(n)
      integer, parameter :: m = exponential_block
      real(wp) :: r, s, power
      integer :: i, j, quarters
      !> 2^((i - offset)/4)
      real(wp), parameter :: power_of_2(0:offset + 60) = [(quarter_powers(modulo(i, 4)) &
         *2.0_wp**((i - offset - modulo(i, 4))/4), i=0, offset + 60)]

      do i = 0, n - m, m
         do j = i + 1, i + m
            ! positive before it is cut, so that cutting is rounding to nearest; the integer that
            ! stands for what is not a number must be no index out of bounds
            quarters = max(int(x(j)*quarters_of_ln2 + (offset + 0.5_wp)), 0)
            r = real(quarters - offset, wp)
            r = (x(j) - r*ln2_high) - r*ln2_low
            s = r*r
            power = ((c(0) + c(1)*r) + s*(c(2) + c(3)*r)) + s*s*((c(4) + c(5)*r) + s*c(6))
            values(j) = power_of_2(quarters)*(1.0_wp + (r + s*power))
         end do
      end do
   end subroutine exponentials

end module asperity_law_exponential
