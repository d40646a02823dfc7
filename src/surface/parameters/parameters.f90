!> The one table of the parameters of a surface: their names, units and meaning.
module asperity_surface_parameters_parameters
   implicit none
   private

   !> Places in the table and in every list of values.
   enum, bind(c)
      enumerator :: p_sa = 1
      enumerator :: p_sq
      enumerator :: p_ssk
      enumerator :: p_sku
      enumerator :: p_sz
      enumerator :: p_sp
      enumerator :: p_sv
      enumerator :: p_sdq
      enumerator :: p_spd
      enumerator :: p_spc
      enumerator :: p_m0
      enumerator :: p_m2_x
      enumerator :: p_m2_y
      enumerator :: p_m4_x
      enumerator :: p_m4_y
      enumerator :: p_direction
      enumerator :: p_m2_across
      enumerator :: p_m2_along
      enumerator :: p_m4_across
      enumerator :: p_m4_along
      enumerator :: p_m2
      enumerator :: p_m4
      enumerator :: p_alpha
      enumerator :: p_summit_density
      enumerator :: p_summit_curvature
      enumerator :: p_summit_sigma
      enumerator :: p_summit_mean
      enumerator :: p_peak_sigma
      enumerator :: p_peak_mean
      enumerator :: p_eta_paper
      enumerator :: p_radius_paper
      enumerator :: p_sigma_paper
      enumerator :: p_eta_nayak
      enumerator :: p_radius_nayak
      enumerator :: p_sigma_nayak
      enumerator :: p_summit_plane
   end enum
   public :: p_sa, p_sq, p_ssk, p_sku, p_sz, p_sp, p_sv, p_sdq, p_spd, p_spc, p_m0, p_m2_x, &
      p_m2_y, p_m4_x, p_m4_y, p_direction, p_m2_across, p_m2_along, p_m4_across, p_m4_along, &
      p_m2, p_m4, p_alpha, p_summit_density, p_summit_curvature, p_summit_sigma, &
      p_summit_mean, p_peak_sigma, p_peak_mean, p_eta_paper, p_radius_paper, p_sigma_paper, &
      p_eta_nayak, p_radius_nayak, p_sigma_nayak, p_summit_plane

   !> One row of the table.
   type, public :: parameter_type
      !> Name in tables and files
      character(len=16) :: name
      !> Unit, `-` for none
      character(len=8) :: unit
      !> Meaning and source
      character(len=88) :: meaning
   end type parameter_type

   !> Groups begin at `p_sa` (ISO 25178-2), `p_m0` (moments), `p_summit_density` (what is found on
   !> the map) and `p_eta_paper` (what the law takes)
   type(parameter_type), parameter, public :: parameters(*) = [ &
      parameter_type('sa', 'mm', 'arithmetical mean height (ISO 25178-2)'), &
      parameter_type('sq', 'mm', 'root mean square height'), &
      parameter_type('ssk', '-', 'skewness of heights, 0 for a Gaussian surface'), &
      parameter_type('sku', '-', 'kurtosis of heights, 3 for a Gaussian surface'), &
      parameter_type('sz', 'mm', 'maximum height, sp + sv'), &
      parameter_type('sp', 'mm', 'height of the highest point above the mean plane'), &
      parameter_type('sv', 'mm', 'depth of the lowest point below the mean plane'), &
      parameter_type('sdq', '-', 'root mean square gradient, sqrt(m2_x + m2_y)'), &
      parameter_type('spd', '1/mm^2', 'density of peaks: hills left after Wolf pruning'), &
      parameter_type('spc', '1/mm', 'arithmetic mean of the mean curvature of those peaks'), &
      parameter_type('m0', 'mm^2', 'mean square height'), &
      parameter_type('m2_x', '-', 'mean square slope of profiles along x'), &
      parameter_type('m2_y', '-', 'mean square slope of profiles along y'), &
      parameter_type('m4_x', '1/mm^2', 'mean square curvature of profiles along x'), &
      parameter_type('m4_y', '1/mm^2', 'mean square curvature of profiles along y'), &
      parameter_type('direction', 'deg', 'direction of the steepest profiles, from x towards y'), &
      parameter_type('m2_across', '-', 'm2 of profiles in that direction, across the lay'), &
      parameter_type('m2_along', '-', 'm2 of profiles at right angles to it, along the lay'), &
      parameter_type('m4_across', '1/mm^2', 'm4 of profiles across the lay'), &
      parameter_type('m4_along', '1/mm^2', 'm4 of profiles along the lay'), &
      parameter_type('m2', '-', 'm2 of the equivalent isotropic surface'), &
      parameter_type('m4', '1/mm^2', 'm4 of the equivalent isotropic surface'), &
      parameter_type('alpha', '-', 'Nayak''s bandwidth parameter m0 m4/m2^2'), &
      parameter_type('summit_density', '1/mm^2', 'density of points above all eight neighbours'), &
      parameter_type('summit_curvature', '1/mm', 'mean curvature of those summits, on average'), &
      parameter_type('summit_sigma', 'mm', 'standard deviation of their heights'), &
      parameter_type('summit_mean', 'mm', 'their mean height above the mean plane'), &
      parameter_type('peak_sigma', 'mm', 'standard deviation of the heights of the peaks of spd'), &
      parameter_type('peak_mean', 'mm', 'their mean height above the mean plane'), &
      parameter_type('eta_paper', '1/mm^2', 'asperity density, spd (Eq. 30)'), &
      parameter_type('radius_paper', 'mm', 'summit radius, 1/spc (Eq. 29)'), &
      parameter_type('sigma_paper', 'mm', 'standard deviation of summit heights, sq (Eq. 28)'), &
      parameter_type('eta_nayak', '1/mm^2', 'asperity density, (m4/m2)/(6 pi sqrt(3)) (Nayak)'), &
      parameter_type('radius_nayak', 'mm', 'summit radius, (3/8) sqrt(pi/m4) (McCool)'), &
      parameter_type('sigma_nayak', 'mm', &
      'standard deviation of summit heights, sqrt((1 - 0.8968/alpha) m0)'), &
      parameter_type('summit_plane', 'mm', &
      'summit mean plane above the mean plane, 4 sqrt(m0/(pi alpha))')]

   !> Number of parameters
   integer, parameter, public :: n_parameters = size(parameters)

end module asperity_surface_parameters_parameters
