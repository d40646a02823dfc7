!> Points for integrals over the deformations of elasto-plastic summits where w1 is small against
!> sigma and w2/w1 is 110, its default: then they are constants in w/w1, a generalised Gauss rule
!> for the powers of w/w1 that force, slope, work and area are, times the density of heights, over
!> ln(w/w1). Numbers from test/reference/fixed_rule_constants.py.
module asperity_law_quadrature_fixed_points
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: default_plastic_ratio
   implicit none
   private
   public :: find_force_powers

   !> Number of points; a multiple of what `exponentials` handles side by side
   integer, parameter, public :: n_points = 20

   !> ln(w/w1) and w/w1 at the points, and weights
   real(wp), parameter, public :: log_ratio(n_points) = [ &
      0.048619530946669133_wp, 0.26399868768473883_wp, 0.61550950897068935_wp, &
      0.96416179633346744_wp, 1.2229071394298781_wp, 1.4895510765996129_wp, &
      1.7955539710073689_wp, 2.1891923339999781_wp, 2.5801607264950008_wp, &
      2.9383367563284768_wp, 3.2590740162331016_wp, 3.5436531606432351_wp, &
      3.7944120320565355_wp, 4.0132971254390029_wp, 4.2015123629184101_wp, &
      4.3596074127275086_wp, 4.4877215482122645_wp, 4.5858136106106135_wp, &
      4.6537996956595515_wp, 4.6916181468231164_wp]
   real(wp), parameter, public :: ratio(n_points) = [ &
      1.0498208504009704_wp, 1.3021264874993114_wp, 1.8505992563141407_wp, &
      2.6225884716482009_wp, 3.397049087858777_wp, 4.4351040500373866_wp, &
      6.0228102600931713_wp, 8.927999360407236_wp, 13.19925945988881_wp, &
      18.884410800289724_wp, 26.025426858577697_wp, 34.593062654419096_wp, &
      44.452092315037193_wp, 55.328996794803534_wp, 66.78726127749217_wp, &
      78.226417698020276_wp, 88.918618115356492_wp, 98.082956021044298_wp, &
      104.98313263265845_wp, 109.02946282194249_wp]
   real(wp), parameter, public :: weight(n_points) = [ &
      0.12707238911149057_wp, 0.29828143160185056_wp, 0.38146746498797651_wp, &
      0.28718707690258494_wp, 0.26878935990223768_wp, 0.25732529983185004_wp, &
      0.36732728073886955_wp, 0.40165336640313309_wp, 0.37633868477986021_wp, &
      0.33947315830579056_wp, 0.30227910626623156_wp, 0.26728907906754784_wp, &
      0.23455769245582775_wp, 0.20341107092152341_wp, 0.17310654370586018_wp, &
      0.14310274294448513_wp, 0.11311642828080093_wp, 0.08305289517656804_wp, &
      0.052907604696516217_wp, 0.022741690081271134_wp]

   !> ln(w/w1) in the middle of the range, where w/w1 is sqrt(110)
   real(wp), parameter, public :: middle = 0.5_wp*log(default_plastic_ratio)
   real(wp), parameter :: from_middle(n_points) = log_ratio - middle
   !> The exponent b3 - 1 in the middle of its range, for yield factors of 0.05 to 1
   real(wp), parameter, public :: middle_exponent = 0.5_wp*log(80.0_wp)/log(default_plastic_ratio)
   !> exp(x) by powers of x to 3e-17 for |x| <= 0.75
   real(wp), parameter :: c(0:13) = [ &
      1.0000000000000000252_wp, 1.0000000000000000017_wp, 0.49999999999999561758_wp, &
      0.16666666666666637479_wp, 0.041666666666791307047_wp, 0.0083333333333416348251_wp, &
      0.0013888888875597155042_wp, 0.00019841269832416821368_wp, 0.000024801594050048587676_wp, &
      2.7557323719055683797e-6_wp, 2.7555560990967492842e-7_wp, 2.50509371405524587e-8_wp, &
      2.1103715506256629742e-9_wp, 1.6210260812877196512e-10_wp]

contains

   !> (w/(sqrt(110) w1))^(b3 - 1 - `middle_exponent`) at the points. Its logarithm is 0.75 in size
   !> at most, so that one polynomial is enough.
   pure subroutine find_force_powers(b3_less_1, powers)
      !> Exponent of the force less one; for yield factors of 0.05 to 1
      real(wp), intent(in) :: b3_less_1
      !> The powers
      real(wp), intent(out) :: powers(n_points)
      real(wp) :: x, s
      integer :: i

      do i = 1, n_points
         x = (b3_less_1 - middle_exponent)*from_middle(i)
         s = x*x
         powers(i) = (c(0) + s*(c(2) + s*(c(4) + s*(c(6) + s*(c(8) + s*(c(10) + s*c(12))))))) &
            + x*(c(1) + s*(c(3) + s*(c(5) + s*(c(7) + s*(c(9) + s*(c(11) + s*c(13)))))))
      end do
   end subroutine find_force_powers

end module asperity_law_quadrature_fixed_points
