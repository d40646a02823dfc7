!> Gauss-Legendre rule of 48 points on [-1, 1]: enough for a Gaussian cut at exp(-45) of its
!> peak times a smooth factor, to round-off.
module asperity_law_quadrature_gauss_legendre
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: pairwise_sum

   integer, parameter :: n_half = 24
   !> Number of points
   integer, parameter, public :: n_points = 2*n_half

   real(wp), parameter :: half_nodes(n_half) = [ &
      0.03238017096286936203332_wp, 0.09700469920946269893005_wp, 0.1612223560688917180564_wp, &
      0.2247637903946890612249_wp, 0.2873624873554555767359_wp, 0.3487558862921607381598_wp, &
      0.4086864819907167299162_wp, 0.4669029047509584045449_wp, 0.5231609747222330336782_wp, &
      0.5772247260839727038178_wp, 0.6288673967765136239952_wp, 0.6778723796326639052119_wp, &
      0.7240341309238146546745_wp, 0.7671590325157403392539_wp, 0.8070662040294426270826_wp, &
      0.8435882616243935307111_wp, 0.8765720202742478859057_wp, 0.9058791367155696728221_wp, &
      0.9313866907065543331142_wp, 0.952987703160430860723_wp, 0.9705915925462472504614_wp, &
      0.9841245837228268577446_wp, 0.9935301722663507575479_wp, 0.9987710072524261186005_wp]
   real(wp), parameter :: half_weights(n_half) = [ &
      0.06473769681268392250302_wp, 0.0644661644359500822065_wp, 0.06392423858464818662391_wp, &
      0.06311419228625402565713_wp, 0.0620394231598926639042_wp, 0.06070443916589388005297_wp, &
      0.05911483969839563574647_wp, 0.05727729210040321570515_wp, 0.0551995036999841628682_wp, &
      0.05289018948519366709551_wp, 0.05035903555385447495781_wp, 0.04761665849249047482591_wp, &
      0.04467456085669428041945_wp, 0.04154508294346474921406_wp, 0.03824135106583070631722_wp, &
      0.03477722256477043889255_wp, 0.03116722783279808890207_wp, 0.02742650970835694820007_wp, &
      0.02357076083932437914052_wp, 0.01961616045735552781446_wp, 0.01557931572294384872818_wp, &
      0.01147723457923453948959_wp, 0.007327553901276262102384_wp, 0.003153346052305838632677_wp]

   !> Points in ascending order
   real(wp), parameter, public :: nodes(n_points) = &
      [-half_nodes(n_half:1:-1), half_nodes]
   !> Their weights, of sum 2
   real(wp), parameter, public :: weights(n_points) = &
      [half_weights(n_half:1:-1), half_weights]
contains

   !> Sum with the round-off of log2(48) additions instead of 48.
   pure real(wp) function pairwise_sum(terms)
      !> Terms of a quadrature
      real(wp), intent(in) :: terms(n_points)
      integer, parameter :: n = n_points/16
      real(wp) :: halves(8*n)

      halves = terms(:8*n) + terms(8*n + 1:)
      halves(:4*n) = halves(:4*n) + halves(4*n + 1:)
      halves(:2*n) = halves(:2*n) + halves(2*n + 1:4*n)
      halves(:n) = halves(:n) + halves(n + 1:2*n)
      pairwise_sum = sum(halves(:n))
   end function pairwise_sum

end module asperity_law_quadrature_gauss_legendre
