!> Gauss-Legendre rule of 28 points on 0..1.
module asperity_law_unloading_gauss_points
   use asperity_base_kinds, only: wp
   implicit none
   private

   integer, parameter :: n_half = 14
   !> Number of points
   integer, parameter, public :: n_points = 2*n_half

   real(wp), parameter :: half_nodes(n_half) = [ &
      0.055079289884034270427_wp, 0.16456928213338077128_wp, 0.27206162763517807768_wp, &
      0.37625151608907871022_wp, 0.47587422495511826103_wp, 0.56972047181140171931_wp, &
      0.65665109403886496122_wp, 0.73561087801363177203_wp, 0.80564137091717917145_wp, &
      0.86589252257439504894_wp, 0.91563302639213207387_wp, 0.95425928062893819725_wp, &
      0.98130316537087275369_wp, 0.99644249757395444995_wp]
   real(wp), parameter :: half_weights(n_half) = [ &
      0.11004701301647519628_wp, 0.10871119225829413525_wp, 0.10605576592284641791_wp, &
      0.10211296757806076981_wp, 0.09693065799792991585_wp, 0.090571744393032840942_wp, &
      0.08311341722890121839_wp, 0.074646214234568779024_wp, 0.065272923966999595793_wp, &
      0.055107345675716745431_wp, 0.04427293475900422784_wp, 0.032901427782304379978_wp, &
      0.021132112592771259752_wp, 0.0091242825930945177388_wp]

   !> Points in ascending order
   real(wp), parameter, public :: points(n_points) = &
      0.5_wp*[1.0_wp - half_nodes(n_half:1:-1), 1.0_wp + half_nodes]
   !> Their weights, of sum 1
   real(wp), parameter, public :: weights(n_points) = &
      0.5_wp*[half_weights(n_half:1:-1), half_weights]

end module asperity_law_unloading_gauss_points
