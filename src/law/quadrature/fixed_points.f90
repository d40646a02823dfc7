!> Points for integrals over the deformations of elastic and of elasto-plastic summits where w1 is
!> small against sigma. As w2/w1 is always 110, they are constants in w/w1: Gauss-Legendre, even in
!> sqrt(w/w1) on the elastic range and in ln(w/w1) on the elasto-plastic one. Numbers from
!> test/reference/fixed_rule_constants.py.
module asperity_law_quadrature_fixed_points
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   implicit none
   private
   public :: force_powers

   !> Number of points; multiples of what `exponentials` handles side by side
   integer, parameter, public :: n_elastic = 8, n_elastoplastic = 28

   !> sqrt(w/w1) at the elastic points, and weights
   real(wp), parameter, public :: root_ratio(n_elastic) = [ &
      0.019855071751231884158_wp, 0.1016667612931866302_wp, 0.23723379504183550709_wp, &
      0.40828267875217509753_wp, 0.59171732124782490247_wp, 0.76276620495816449291_wp, &
      0.8983332387068133698_wp, 0.98014492824876811584_wp]
   real(wp), parameter, public :: elastic_weight(n_elastic) = [ &
      0.050614268145188129576_wp, 0.11119051722668723527_wp, 0.15685332293894364367_wp, &
      0.18134189168918099148_wp, 0.18134189168918099148_wp, 0.15685332293894364367_wp, &
      0.11119051722668723527_wp, 0.050614268145188129576_wp]
   !> ln(w/w1) and w/w1 at the elasto-plastic points, and weights
   real(wp), parameter, public :: log_ratio(n_elastoplastic) = [ &
      0.0083609851524429976287_wp, 0.04394205203834017676_wp, 0.10750167666044842066_wp, &
      0.19828265148255507764_wp, 0.31518478227250288106_wp, 0.45678945996306509759_wp, &
      0.62137793841300994202_wp, 0.80695239554331097394_wp, 1.011260237026465358_wp, &
      1.2318214574020996887_wp, 1.4659587509080361763_wp, 1.710830013403867121_wp, &
      1.9634628431559536159_wp, 2.2207906225653621449_wp, 2.4796897432270540832_wp, &
      2.7370175226364626122_wp, 2.9896503523885491071_wp, 3.2345216148843800518_wp, &
      3.4686589083903165394_wp, 3.6892201287659508701_wp, 3.8935279702491052541_wp, &
      4.0791024273794062861_wp, 4.2436909058293511305_wp, 4.385295583519913347_wp, &
      4.5021977143098611504_wp, 4.5929786891319678074_wp, 4.6565383137540760513_wp, &
      4.6921193806399732305_wp]
   real(wp), parameter, public :: elastoplastic_ratio(n_elastoplastic) = [ &
      1.0083960358067021206_wp, 1.0449218020454813676_wp, 1.113492727694187116_wp, &
      1.219306984046610138_wp, 1.370512533981235897_wp, 1.5789964072889026013_wp, &
      1.8614912957996918899_wp, 2.2410676808456517677_wp, 2.7490633042702651735_wp, &
      3.427466838918890224_wp, 4.33169426589378599_wp, 5.5335524947992221957_wp, &
      7.1239535354896347852_wp, 9.2146132678679000214_wp, 11.937560134355163416_wp, &
      15.440864325126401279_wp, 19.878730725584488723_wp, 25.394220655437463418_wp, &
      32.09367301557811239_wp, 40.013629307528565204_wp, 49.08374742100258312_wp, &
      59.092406313264162708_wp, 69.664503030039981501_wp, 80.261943814886733011_wp, &
      90.215180786494254979_wp, 98.788251835094804676_wp, 105.27103538721276421_wp, &
      109.08412577405820959_wp]
   real(wp), parameter, public :: elastoplastic_weight(n_elastoplastic) = [ &
      0.021444255590391147408_wp, 0.049665540165017988175_wp, 0.07732625764862942892_wp, &
      0.10405203028535398594_wp, 0.1295154981798210871_wp, 0.1534070487623714161_wp, &
      0.17543653219516246078_wp, 0.19533649290918165408_wp, 0.21286535310751011586_wp, &
      0.22781032738130460325_wp, 0.23998999959673611295_wp, 0.24925652269970800115_wp, &
      0.25549741237599805204_wp, 0.2586369119990220603_wp, 0.2586369119990220603_wp, &
      0.25549741237599805204_wp, 0.24925652269970800115_wp, 0.23998999959673611295_wp, &
      0.22781032738130460325_wp, 0.21286535310751011586_wp, 0.19533649290918165408_wp, &
      0.17543653219516246078_wp, 0.1534070487623714161_wp, 0.1295154981798210871_wp, &
      0.10405203028535398594_wp, 0.07732625764862942892_wp, 0.049665540165017988175_wp, &
      0.021444255590391147408_wp]

contains

   !> (w/w1)^(b3 - 1) at the elasto-plastic points. The points are symmetric in ln(w/w1), so the
   !> upper ones follow from the lower ones and the value at w2.
   pure function force_powers(b3_less_1, upper) result(powers)
      !> Exponent of the force less one
      real(wp), intent(in) :: b3_less_1
      !> Value at w2, 2/k
      real(wp), intent(in) :: upper
      real(wp) :: powers(n_elastoplastic)
      integer, parameter :: n_lower = 16

      call exponentials(n_lower, b3_less_1*log_ratio(:n_lower), powers(:n_lower))
      powers(n_lower + 1:) = upper/powers(n_elastoplastic - n_lower:1:-1)
   end function force_powers

end module asperity_law_quadrature_fixed_points
