!> Parameters of a surface from the sums over its points.
module asperity_surface_parameters_from_sums
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_faces_nayak, only: nayak_summits, nayak_type
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_direction, &
      p_eta_nayak, p_eta_paper, p_m0, p_m2, p_m2_across, p_m2_along, p_m2_x, p_m2_y, p_m4, &
      p_m4_across, p_m4_along, p_m4_x, p_m4_y, p_peak_mean, p_peak_sigma, p_radius_nayak, &
      p_radius_paper, p_sa, p_sdq, p_sigma_nayak, p_sigma_paper, p_sku, p_sp, p_spc, p_spd, p_sq, &
      p_ssk, p_summit_curvature, p_summit_density, p_summit_mean, p_summit_plane, p_summit_sigma, &
      p_sv, p_sz
   use asperity_surface_parameters_tile_sums, only: summit_sums_type, surface_sums_type
   implicit none
   private
   public :: parameters_of, values_of_moments, variance_of

   !> A variance below this share of the mean square is rounding
   real(wp), parameter :: rounding = 64.0_wp*epsilon(1.0_wp)

contains

   !> All parameters of a part of a map, or of the whole. Heights count from the mean of the part,
   !> which is zero for the whole: the mean plane is not known better than the part tells.
   pure subroutine parameters_of(sums, cell_area, values)
      !> Sums over the part
      type(surface_sums_type), intent(in) :: sums
      !> Area of one inner point, step_x step_y, mm^2
      real(wp), intent(in) :: cell_area
      !> Values in the order of the table; `none` where there is none
      real(wp), intent(out) :: values(n_parameters)
      real(wp) :: mean

      values = none
      if (.not. sums%points > 0.0_wp) return
      mean = sums%first/sums%points
      call evaluate_heights(sums, mean, values)
      call evaluate_slopes(sums, values)
      call evaluate_summits(sums%summits, mean, values(p_summit_curvature), &
         values(p_summit_sigma), values(p_summit_mean))
      call evaluate_summits(sums%peaks, mean, values(p_spc), values(p_peak_sigma), &
         values(p_peak_mean))
      if (sums%inner > 0.0_wp) then
         values(p_summit_density) = sums%summits%number/(sums%inner*cell_area)
         values(p_spd) = sums%peaks%number/(sums%inner*cell_area)
         if (sums%peaks%number > 0.0_wp) values(p_eta_paper) = values(p_spd)
      end if
      if (values(p_spc) > 0.0_wp .and. .not. is_none(values(p_spc))) &
         values(p_radius_paper) = 1.0_wp/values(p_spc)
      values(p_sigma_paper) = values(p_sq)
      call values_of_moments(values)
   end subroutine parameters_of

   !> Moments of the heights, and their extremes.
   pure subroutine evaluate_heights(sums, mean, values)
      type(surface_sums_type), intent(in) :: sums
      real(wp), intent(in) :: mean
      real(wp), intent(inout) :: values(:)
      real(wp) :: raw(2:4), central(3:4), variance

      raw = [sums%second, sums%third, sums%fourth]/sums%points
      variance = variance_of(raw(2), mean)
      central(3) = raw(3) - 3.0_wp*mean*raw(2) + 2.0_wp*mean**3
      central(4) = raw(4) - 4.0_wp*mean*raw(3) + 6.0_wp*mean**2*raw(2) - 3.0_wp*mean**4
      values(p_sa) = sums%absolute/sums%points
      values(p_m0) = variance
      values(p_sq) = sqrt(variance)
      if (variance > 0.0_wp) then
         values(p_ssk) = central(3)/values(p_sq)**3
         values(p_sku) = central(4)/variance**2
      end if
      if (sums%highest < sums%lowest) return
      values(p_sp) = sums%highest
      values(p_sv) = -sums%lowest
      values(p_sz) = sums%highest - sums%lowest
   end subroutine evaluate_heights

   !> Mean squares of slopes and curvatures: along x and y, and along the principal axes.
   pure subroutine evaluate_slopes(sums, values)
      type(surface_sums_type), intent(in) :: sums
      real(wp), intent(inout) :: values(:)
      real(wp) :: c, s, angle, cross

      if (min(sums%pairs_x, sums%pairs_y, sums%triples_x, sums%triples_y, sums%inner) < 1.0_wp) &
         return
      values(p_m2_x) = sums%slope_x/sums%pairs_x
      values(p_m2_y) = sums%slope_y/sums%pairs_y
      values(p_m4_x) = sums%curvature_x/sums%triples_x
      values(p_m4_y) = sums%curvature_y/sums%triples_y
      values(p_sdq) = sqrt(values(p_m2_x) + values(p_m2_y))
      angle = 0.0_wp
      if (sums%gradient_xx + sums%gradient_yy > 0.0_wp) &
         angle = 0.5_wp*atan2(2.0_wp*sums%gradient_xy, sums%gradient_xx - sums%gradient_yy)
      if (values(p_sdq) > 0.0_wp) values(p_direction) = modulo(angle*180.0_wp/pi, 180.0_wp)
      c = cos(angle)
      s = sin(angle)
      ! central differences see less of short waves than neighbours do: of the product of slopes
      ! only the correlation is taken from them
      cross = 0.0_wp
      if (min(sums%gradient_xx, sums%gradient_yy) > 0.0_wp) &
         cross = sums%gradient_xy/sqrt(sums%gradient_xx)/sqrt(sums%gradient_yy) &
         *sqrt(values(p_m2_x)*values(p_m2_y))
      values(p_m2_across) = c*c*values(p_m2_x) + s*s*values(p_m2_y) + 2.0_wp*c*s*cross
      values(p_m2_along) = max(s*s*values(p_m2_x) + c*c*values(p_m2_y) - 2.0_wp*c*s*cross, 0.0_wp)
      values(p_m4_across) = curvature_along(sums, c, s)
      values(p_m4_along) = curvature_along(sums, -s, c)
      values(p_m2) = sqrt(values(p_m2_across)*values(p_m2_along))
      values(p_m4) = sqrt(values(p_m4_across)*values(p_m4_along))
   end subroutine evaluate_slopes

   !> Mean of (c^2 z_xx + 2 c s z_xy + s^2 z_yy)^2, the curvature of profiles along (c, s) squared.
   pure real(wp) function curvature_along(sums, c, s)
      type(surface_sums_type), intent(in) :: sums
      real(wp), intent(in) :: c, s

      curvature_along = max(c**4*sums%hessian_xx_xx + s**4*sums%hessian_yy_yy &
         + 2.0_wp*c*c*s*s*(sums%hessian_xx_yy + 2.0_wp*sums%hessian_xy_xy) &
         + 4.0_wp*c*s*(c*c*sums%hessian_xx_xy + s*s*sums%hessian_yy_xy), 0.0_wp)/sums%inner
   end function curvature_along

   !> Mean curvature, standard deviation and mean of the heights of summits or peaks.
   pure subroutine evaluate_summits(summits, plane, curvature, sigma, mean)
      type(summit_sums_type), intent(in) :: summits
      !> Height of the mean plane
      real(wp), intent(in) :: plane
      real(wp), intent(out) :: curvature, sigma, mean
      real(wp) :: height

      curvature = none
      sigma = none
      mean = none
      if (summits%number < 1.0_wp) return
      height = summits%height/summits%number
      curvature = summits%curvature/summits%number
      mean = height - plane
      if (summits%number > 1.5_wp) &
         sigma = sqrt(variance_of(summits%height_2/summits%number, height))
   end subroutine evaluate_summits

   !> Mean square less squared mean, free of what rounding leaves.
   pure real(wp) function variance_of(mean_square, mean)
      !> Of the same numbers
      real(wp), intent(in) :: mean_square, mean

      variance_of = mean_square - mean**2
      if (variance_of < rounding*mean_square) variance_of = 0.0_wp
   end function variance_of

   !> What follows from m0, m2 and m4 already among the values: alpha and the route of Nayak and
   !> McCool.
   pure subroutine values_of_moments(values)
      !> Values in the order of the table
      real(wp), intent(inout) :: values(n_parameters)
      type(nayak_type) :: summits

      values([integer :: p_alpha, p_eta_nayak, p_radius_nayak, p_sigma_nayak, p_summit_plane]) = &
         none
      associate (m0 => values(p_m0), m2 => values(p_m2), m4 => values(p_m4))
         if (.not. min(m0, m2, m4) > 0.0_wp .or. is_none(max(m0, m2, m4))) return
         summits = nayak_summits(m0, m2, m4)
      end associate
      values(p_alpha) = summits%alpha
      values(p_eta_nayak) = summits%density
      values(p_radius_nayak) = 1.0_wp/summits%curvature
      values(p_summit_plane) = summits%height
      if (summits%variance > 0.0_wp) values(p_sigma_nayak) = sqrt(summits%variance)
   end subroutine values_of_moments

end module asperity_surface_parameters_from_sums
