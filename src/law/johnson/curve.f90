!> Johnson's functions from a Gaussian number x to a height z, and back, to round-off also where
!> they are all but a line, and over short ways.
module asperity_law_johnson_curve
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: height_at, height_beyond, height_slope, johnson_curve_type, normal_number

   !> Below this s the function is a line to rounding
   real(wp), parameter, public :: flattest = 1.0e-8_wp
   !> Numbers beyond this are of no use: the density is zero in double precision from 39 on
   real(wp), parameter :: farthest = 40.0_wp

   !> The function z(x) of a distribution, z(0) = 0 and z'(0) = 1. With
   !> c(y) = (1 + w) exp(y)/2 + (1 - w) exp(-y)/2 it is 2/s sinh(y/2) c(y/2), unbounded, or
   !> 2/s sinh(y/2)/c(-y/2), bounded.
   type :: johnson_curve_type
      !> Whether heights are bounded
      logical :: is_bounded = .false.
      !> s, w = (1 - q)/(1 + q), and 1 - w with the digits that w has no room for
      real(wp) :: s = flattest, w = 0.0_wp, rest = 1.0_wp
   end type johnson_curve_type

contains

   !> z(x), rising also where it is flat to rounding: away from zero of terms that each rise.
   pure elemental real(wp) function height_at(curve, x) result(z)
      !> The function
      type(johnson_curve_type), intent(in) :: curve
      !> Gaussian number of mean 0 and variance 1
      real(wp), intent(in) :: x
      real(wp) :: y, power

      y = curve%s*x
      if (abs(y) < 1.0_wp) then
         z = height_beyond(curve, 0.0_wp, x)
      else if (.not. curve%is_bounded) then
         power = exp(y)
         z = 0.5_wp*((1.0_wp + curve%w)*(power - 1.0_wp) + curve%rest*(1.0_wp - 1.0_wp/power)) &
            /curve%s
      else if (y > 0.0_wp) then
         power = exp(-y)
         z = 2.0_wp*(1.0_wp - power)/((1.0_wp + curve%w)*power + curve%rest)/curve%s
      else
         power = exp(y)
         z = 2.0_wp*(power - 1.0_wp)/(1.0_wp + curve%w + curve%rest*power)/curve%s
      end if
   end function height_at

   !> z(x + xi) - z(x), free of cancellation.
   pure elemental real(wp) function height_beyond(curve, x, xi) result(z)
      !> The function
      type(johnson_curve_type), intent(in) :: curve
      !> Gaussian numbers of mean 0 and variance 1: from where, and how far
      real(wp), intent(in) :: x, xi

      associate (s => curve%s)
         z = 2.0_wp/s*sinh(0.5_wp*s*xi)
         if (curve%is_bounded) then
            z = z/(growth(curve, -0.5_wp*s*x)*growth(curve, -0.5_wp*s*(x + xi)))
         else
            z = z*growth(curve, s*(x + 0.5_wp*xi))
         end if
      end associate
   end function height_beyond

   !> dz/dx.
   pure elemental real(wp) function height_slope(curve, x) result(slope)
      !> The function, and a Gaussian number
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: x

      if (curve%is_bounded) then
         slope = growth(curve, -0.5_wp*curve%s*x)**(-2)
      else
         slope = growth(curve, curve%s*x)
      end if
   end function height_slope

   !> c(y) of `johnson_curve_type`.
   pure elemental real(wp) function growth(curve, y)
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: y

      growth = exp(y)
      growth = 0.5_wp*((1.0_wp + curve%w)*growth + curve%rest/growth)
   end function growth

   !> The inverse: the Gaussian number x of a height z; huge in size beyond the ends of bounded
   !> heights.
   pure elemental real(wp) function normal_number(curve, z) result(x)
      !> The function, and a height
      type(johnson_curve_type), intent(in) :: curve
      real(wp), intent(in) :: z
      real(wp) :: v, above, below, root
      integer :: i

      v = curve%s*z
      if (curve%is_bounded) then
         above = 2.0_wp + (1.0_wp + curve%w)*v
         below = 2.0_wp - curve%rest*v
      else
         v = v + curve%w
         root = sqrt(v*v + curve%rest*(1.0_wp + curve%w))
         if (v > 0.0_wp) then
            above = root + v
         else
            above = curve%rest*(1.0_wp + curve%w)/(root - v)
         end if
         below = 1.0_wp + curve%w
      end if
      x = huge(1.0_wp)
      if (.not. below > 0.0_wp) return
      x = -huge(1.0_wp)
      if (.not. above > 0.0_wp) return
      x = log(above/below)/curve%s
      ! a flat function has lost digits in the logarithm, which two steps of Newton's method restore
      if (curve%s > 0.5_wp .or. abs(x) > farthest) return
      do i = 1, 2
         x = x - (height_at(curve, x) - z)/height_slope(curve, x)
      end do
   end function normal_number

end module asperity_law_johnson_curve
