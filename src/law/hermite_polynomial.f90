!> The polynomial of degree seven that has given values and slopes at four points of an interval:
!> both ends and the inner Gauss-Lobatto points. Neighbours share values and slopes at their ends.
module asperity_law_hermite_polynomial
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: hermite_polynomial

   !> Degree of the polynomial
   integer, parameter, public :: degree = 7
   !> The points from the middle of the interval, over half its width
   real(wp), parameter, public :: hermite_points(4) = &
      [-1.0_wp, -0.447213595499957939281834733746255247_wp, &
      0.447213595499957939281834733746255247_wp, 1.0_wp]
   !> Their squares
   real(wp), parameter :: inner = 0.2_wp, outer = 1.0_wp

contains

   !> Coefficients of the powers of t, measured from the middle of the interval.
   pure function hermite_polynomial(values, slopes, half_width) result(c)
      !> At the four points, in ascending order
      real(wp), intent(in) :: values(4), slopes(4)
      !> Half the width of the interval
      real(wp), intent(in) :: half_width
      real(wp) :: c(0:degree)
      real(wp) :: s(4), slope(2), value(2)
      integer :: i

      ! with z = s^2, the even part is a cubic of z and the odd part s times another
      s = half_width*slopes
      value = 0.5_wp*[values(2) + values(3), values(1) + values(4)]
      slope = 0.25_wp*[s(3) - s(2), s(4) - s(1)]/hermite_points(3:4)
      c(0:6:2) = cubic(value, slope)
      value = 0.5_wp*[values(3) - values(2), values(4) - values(1)]/hermite_points(3:4)
      slope = 0.5_wp*(0.5_wp*[s(2) + s(3), s(1) + s(4)] - value)/[inner, outer]
      c(1:7:2) = cubic(value, slope)
      do i = 1, degree
         c(i) = c(i)/half_width**i
      end do
   end function hermite_polynomial

   !> Cubic with given values and slopes at the two squares, by powers.
   pure function cubic(value, slope) result(c)
      real(wp), intent(in) :: value(2), slope(2)
      real(wp) :: c(0:3)
      real(wp), parameter :: width = outer - inner
      real(wp) :: mean, bend, twist

      mean = (value(2) - value(1))/width
      bend = (mean - slope(1))/width
      twist = (slope(1) + slope(2) - 2.0_wp*mean)/width**2
      ! value + slope y + bend y^2 + twist y^2 (y - width), y = z - inner
      c(3) = twist
      c(2) = bend - twist*(2.0_wp*inner + outer)
      c(1) = slope(1) - 2.0_wp*inner*bend + twist*inner*(inner + 2.0_wp*outer)
      c(0) = value(1) - inner*slope(1) + inner**2*bend - twist*inner**2*outer
   end function cubic

end module asperity_law_hermite_polynomial
