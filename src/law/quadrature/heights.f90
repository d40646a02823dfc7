!> Quadrature over summit heights: Gauss points and weights for integrals of functions that are
!> smooth in sqrt(w) or in ln(w), times the Gaussian density of heights, over a range of
!> deformations w.
module asperity_law_quadrature_heights
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: density_reach, phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   implicit none
   private
   public :: quadrature_type, new_quadrature, new_log_quadrature, find_dense_range, &
      relative_exponent

   !> Gauss points, one column a panel. The weights hold the density of heights, to be multiplied
   !> by exp(-exponent - max(h, 0)^2/2), which makes it one at its largest.
   type :: quadrature_type
      !> Number of panels used
      integer :: panels = 0
      !> Points w/w1, and weights
      real(wp) :: ratio(n_points, 2), weight(n_points, 2)
      !> ln(w/w1), from `new_log_quadrature`
      real(wp) :: log_ratio(n_points, 2)
      !> See above; never negative
      real(wp) :: exponent = 0.0_wp
   end type quadrature_type

   !> Ranges that end beyond this many sigma are split; from 2 to 16 is as exact
   real(wp), parameter :: wide = 4.0_wp
   !> Points are even in ln(w) where the range of ln(w) is longer than this and d/sigma above
   !> -1: shorter ranges gain nothing, and around w = -d the density has only the width sigma/|d|
   real(wp), parameter :: shortest = 1.0_wp, lowest = -1.0_wp

contains

   !> Gauss points for integrals over the deformations from..to of functions that are smooth in
   !> sqrt(w), times the density, cut to where the density matters.
   pure function new_quadrature(properties, separation, from, to) result(rule)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      type(quadrature_type) :: rule
      real(wp) :: anchor, y, lower, upper

      call place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      if (rule%panels == 0) call add_panels(rule, properties, anchor, y, lower, upper)
   end function new_quadrature

   !> The same for functions that are smooth in ln(w), and with the logarithms; `from` is above
   !> zero.
   pure function new_log_quadrature(properties, separation, from, to) result(rule)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      type(quadrature_type) :: rule
      real(wp) :: anchor, y, lower, upper, center, first, last
      integer :: i

      call place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      if (rule%panels == 0) then
         center = anchor/properties%sigma
         first = log(1.0_wp + lower/center)
         last = log(1.0_wp + upper/center)
         if (last - first > shortest .and. y - center > lowest) then
            call add_log_panel(rule, properties, anchor, y, first, last)
            return
         end if
         call add_panels(rule, properties, anchor, y, lower, upper)
      end if
      do i = 1, rule%panels
         rule%log_ratio(:, i) = log(rule%ratio(:, i))
      end do
   end function new_log_quadrature

   !> Find the range about the anchor; where it lies inside from..to on both sides, its panel is
   !> added.
   pure subroutine place_anchor(rule, properties, separation, from, to, anchor, y, lower, upper)
      type(quadrature_type), intent(out) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, from, to
      !> See `find_dense_range`
      real(wp), intent(out) :: anchor, y, lower, upper
      real(wp) :: reach

      call find_dense_range(properties, separation, from, to, anchor, y, lower, upper, &
         rule%exponent)
      reach = density_reach(y)
      if (lower > (from - anchor)/properties%sigma .and. upper < (to - anchor)/properties%sigma) &
         call add_bell(rule, properties, anchor, reach)
   end subroutine place_anchor

   !> Find the anchor, the densest point of a range of deformations, from which lengths are
   !> measured, so that nothing is lost where the range is narrow and far from zero; and the range
   !> about it, cut to where the density matters.
   pure subroutine find_dense_range(properties, separation, from, to, anchor, y, lower, upper, &
         exponent)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Range of the deformation w, mm
      real(wp), intent(in) :: from, to
      !> Anchor, mm; height there over sigma; range about it, in sigma
      real(wp), intent(out) :: anchor, y, lower, upper
      !> Of the density at the anchor, less max(h, 0)^2/2
      real(wp), intent(out) :: exponent
      real(wp) :: reach

      anchor = min(max(-separation, from), to)
      y = (separation + anchor)/properties%sigma
      reach = density_reach(y)
      lower = max((from - anchor)/properties%sigma, -reach)
      upper = min((to - anchor)/properties%sigma, reach)
      exponent = relative_exponent(separation/properties%sigma, anchor/properties%sigma, y)
   end subroutine find_dense_range

   !> Add the Gauss points in lower..upper sigma beyond the anchor, in one panel or two: the
   !> density narrows in sqrt(w), so a wide range is split at a quarter of its upper end (1/16 to
   !> 3/4 are as exact).
   pure subroutine add_panels(rule, properties, anchor, y, lower, upper)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, lower, upper
      real(wp) :: root_split

      associate (center => anchor/properties%sigma)
         root_split = 0.25_wp*(center + upper) - center
         if (center + upper > wide .and. lower < root_split) then
            call add_panel(rule, properties, anchor, y, lower, root_split)
            call add_panel(rule, properties, anchor, y, root_split, upper)
         else
            call add_panel(rule, properties, anchor, y, lower, upper)
         end if
      end associate
   end subroutine add_panels

   !> Add the Gauss points between the logarithms of w/anchor, spread evenly in ln(w).
   pure subroutine add_log_panel(rule, properties, anchor, y, first, last)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, first, last
      real(wp) :: center, half
      real(wp), dimension(n_points) :: x, growth, t, density

      center = anchor/properties%sigma
      half = 0.5_wp*(last - first)
      x = 0.5_wp*(last + first) + half*nodes
      call exponentials(n_points, x, growth)
      t = center*(growth - 1.0_wp)
      call exponentials(n_points, -t*(y + 0.5_wp*t), density)
      rule%panels = 1
      rule%log_ratio(:, 1) = log(anchor/properties%w1) + x
      rule%ratio(:, 1) = anchor/properties%w1*growth
      rule%weight(:, 1) = (phi_0*half*center)*weights*growth*density
   end subroutine add_log_panel

   !> Add the Gauss points in lower..upper sigma beyond the anchor, spread evenly in sqrt(w). The
   !> density is phi(y + t) at t sigma beyond it. Each w is rounded for itself, so that the errors
   !> of the points average out, and the points are set from the denser end, which keeps it sharp.
   pure subroutine add_panel(rule, properties, anchor, y, lower, upper)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, y, lower, upper
      real(wp) :: start, first, last, half
      real(wp), dimension(n_points) :: w, t, beyond, density

      associate (sigma => properties%sigma)
         ! roots of w/sigma, then less that of the anchor
         start = sqrt(anchor/sigma)
         first = sqrt(max(anchor/sigma + lower, 0.0_wp))
         last = sqrt(max(anchor/sigma + upper, 0.0_wp))
         half = 0.5_wp*(upper - lower)/max(last + first, tiny(1.0_wp))
         if (abs(upper) < abs(lower)) then
            beyond = upper/max(last + start, tiny(1.0_wp)) - half*(1.0_wp - nodes)
         else
            first = lower/max(first + start, tiny(1.0_wp))
            beyond = first + half*(1.0_wp + nodes)
         end if
         t = beyond*(2.0_wp*start + beyond)
         w = max(anchor + sigma*t, 0.0_wp)
         rule%panels = rule%panels + 1
         rule%ratio(:, rule%panels) = w/properties%w1
         call exponentials(n_points, -t*(y + 0.5_wp*t), density)
         rule%weight(:, rule%panels) = (2.0_wp*phi_0*half)*weights*sqrt(w/sigma)*density
      end associate
   end subroutine add_panel

   !> Add the Gauss points of the whole bell around the anchor, spread evenly in w: nothing happens
   !> at its ends, and fixed points have no noise.
   pure subroutine add_bell(rule, properties, anchor, reach)
      type(quadrature_type), intent(inout) :: rule
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: anchor, reach
      real(wp), dimension(n_points) :: t, density

      t = reach*nodes
      call exponentials(n_points, -0.5_wp*t*t, density)
      rule%panels = 1
      rule%ratio(:, 1) = (anchor + properties%sigma*t)/properties%w1
      rule%weight(:, 1) = (phi_0*reach)*weights*density
   end subroutine add_bell

   !> Exponent y^2/2 of the density where a piece is densest, at y = h + t, less max(h, 0)^2/2:
   !> not as a difference of squares, which would lose digits of small shares.
   pure real(wp) function relative_exponent(h, t, y)
      !> d/sigma
      real(wp), intent(in) :: h
      !> Deformation over sigma at the densest point
      real(wp), intent(in) :: t
      !> Their sum; zero where the whole piece lies on the far side of the mean plane
      real(wp), intent(in) :: y

      if (h > 0.0_wp) then
         relative_exponent = t*(h + 0.5_wp*t)
      else
         relative_exponent = 0.5_wp*y*y
      end if
   end function relative_exponent

end module asperity_law_quadrature_heights
