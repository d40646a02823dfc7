!> The three pieces of the normal law for heights by Johnson's distributions. The variable is the
!> Gaussian number x of a height, whose density is known in all tails: from x_0 on, that of the
!> separation, summits touch. Force is smooth in sqrt(x - x_0) for elastic summits and in
!> ln(x - x_0) beyond.
module asperity_law_quadrature_pieces_by_johnson
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: density_reach, find_tail_moments, phi_0, vanishing_height
   use asperity_law_johnson_heights, only: height_of, height_slope_at, height_step, &
      johnson_heights, normal_score
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, pairwise_sum, weights
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   implicit none
   private
   public :: find_johnson_pieces, decay_score

   !> Below this number no summit that matters is
   real(wp), parameter :: lowest = -37.0_wp
   !> Widest panels: in x, over 1/s in x, and in ln(x - x_0)
   real(wp), parameter :: widest = 4.0_wp, widest_by_pole = 6.0_wp, widest_log = 4.0_wp
   !> Where yielded summits begin in x - x_0 if all have yielded: nothing is there to be lost
   real(wp), parameter :: nearest_start = 1.0e-12_wp

   !> Where the integrals over x begin, and the height of the first summit over the separation
   type :: origin_type
      real(wp) :: x, offset
   end type origin_type

contains

   !> Gaussian number x_0 of a separation, which takes the place of h = d/sigma in the factor
   !> exp(-max(h, 0)^2/2) that scaled values lack; 39 at most, where that is zero.
   pure real(wp) function decay_score(properties, separation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation

      decay_score = max(min(normal_score(properties%heights, separation/properties%sigma), &
         vanishing_height), -vanishing_height)
   end function decay_score

   !> The three pieces, by exp(-max(x_0, 0)^2/2), and the moments of the heights beyond the
   !> separation, of orders 0 and 1, likewise.
   pure subroutine find_johnson_pieces(properties, separation, pieces, moments)
      !> Checked properties, whose heights are not Gaussian
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm
      real(wp), intent(in) :: separation
      !> Elastic, elasto-plastic and plastic summits
      type(piece_type), intent(out) :: pieces(3)
      !> Share of the summits in contact, and their mean deformation over sigma times that
      real(wp), intent(out) :: moments(0:1)
      type(origin_type) :: origin
      real(wp) :: ends(0:3), tail(0:2), deformation
      integer :: stage

      pieces = no_summits
      moments = 0.0_wp
      associate (p => properties, h => separation/properties%sigma)
         if (normal_score(p%heights, h) >= vanishing_height) return
         origin%x = max(decay_score(p, separation), lowest)
         origin%offset = 0.0_wp
         if (origin%x <= lowest) origin%offset = max(height_of(p%heights, lowest) - h, 0.0_wp)
         ends(0) = 0.0_wp
         ends(1) = distance_to(p%heights, origin, h, p%w1/p%sigma)
         ends(2) = max(ends(1), distance_to(p%heights, origin, h, p%w2/p%sigma))
         ends(3) = huge(1.0_wp)
         call find_tail_moments(origin%x, tail)
         moments(0) = tail(0)
         do stage = 1, 3
            call integrate(p, origin, stage, ends(stage - 1), ends(stage), pieces(stage), &
               deformation)
            moments(1) = moments(1) + deformation*exp(-pieces(stage)%exponent)
         end do
      end associate
   end subroutine find_johnson_pieces

   !> How far beyond the origin summits are deformed by b, in sigma.
   pure real(wp) function distance_to(heights, origin, h, b) result(xi)
      type(johnson_heights), intent(in) :: heights
      type(origin_type), intent(in) :: origin
      real(wp), intent(in) :: h, b
      real(wp), parameter :: short = 1.0e-3_wp
      real(wp) :: x
      integer :: i

      xi = 0.0_wp
      if (b <= origin%offset) return
      x = normal_score(heights, h + b)
      xi = huge(1.0_wp)
      if (x >= vanishing_height) return
      xi = x - origin%x
      ! over short ways the difference has lost digits: by the slope, and Newton's method
      if (xi < short) xi = (b - origin%offset)/height_slope_at(heights, origin%x)
      do i = 1, 4
         xi = xi - (origin%offset + height_step(heights, origin%x, xi) - b) &
            /height_slope_at(heights, origin%x + xi)
      end do
      xi = max(xi, 0.0_wp)
   end function distance_to

   !> Integrals over the summits of one stage, whose numbers lie from..to beyond the origin, cut to
   !> where they matter.
   pure subroutine integrate(properties, origin, stage, from, to, piece, deformation)
      type(normal_properties), intent(in) :: properties
      type(origin_type), intent(in) :: origin
      integer, intent(in) :: stage
      real(wp), intent(in) :: from, to
      type(piece_type), intent(inout) :: piece
      !> Mean deformation over sigma times the share of the summits
      real(wp), intent(out) :: deformation
      real(wp) :: anchor, y, growth, lower, upper, first, last, width

      deformation = 0.0_wp
      if (.not. to > from) return
      ! the densest point; beyond it squares of deformations may grow as exp(growth x)
      anchor = min(max(-origin%x, from), to)
      y = origin%x + anchor
      piece%exponent = 0.5_wp*y*y
      if (origin%x > 0.0_wp) piece%exponent = anchor*(origin%x + 0.5_wp*anchor)
      associate (curve => properties%heights%curve)
         growth = merge(0.0_wp, 2.0_wp*curve%s, curve%is_bounded)
         width = min(widest, widest_by_pole/curve%s)
      end associate
      lower = max(from, anchor - density_reach(y))
      upper = min(to, anchor + max(growth - y, 0.0_wp) + density_reach(max(y - growth, 0.0_wp)))
      if (stage > 1) lower = max(lower, nearest_start)
      first = lower
      do while (first < upper)
         last = min(upper, first + width)
         if (stage > 1) last = min(last, first*exp(widest_log))
         call add_panel(properties, origin, stage, first, last, anchor, y, piece, deformation)
         first = last
      end do
   end subroutine integrate

   !> Add one panel.
   pure subroutine add_panel(properties, origin, stage, first, last, anchor, y, piece, deformation)
      type(normal_properties), intent(in) :: properties
      type(origin_type), intent(in) :: origin
      integer, intent(in) :: stage
      real(wp), intent(in) :: first, last, anchor, y
      type(piece_type), intent(inout) :: piece
      real(wp), intent(inout) :: deformation
      real(wp), dimension(n_points) :: xi, weight, ratio, exponent, force, area, energy
      real(wp) :: middle, half, inverse
      integer :: i

      if (stage == 1) then
         middle = 0.5_wp*(sqrt(last) + sqrt(first))
         half = 0.5_wp*(last - first)/(2.0_wp*middle)
         xi = (middle + half*nodes)**2
         weight = 2.0_wp*half*(middle + half*nodes)*weights
      else
         middle = 0.5_wp*log(last*first)
         half = 0.5_wp*log(last/first)
         xi = exp(middle + half*nodes)
         weight = half*xi*weights
      end if
      exponent = -(xi - anchor)*(y + 0.5_wp*(xi - anchor))
      call exponentials(n_points, exponent, force)
      weight = phi_0*weight*force
      do i = 1, n_points
         ratio(i) = origin%offset + height_step(properties%heights, origin%x, xi(i))
      end do
      deformation = deformation + pairwise_sum(weight*ratio)
      associate (p => properties, r => ratio)
         r = r*(p%sigma/p%w1)
         inverse = 1.0_wp/(p%b3 + 1.0_wp)
         select case (stage)
         case (1)
            area = weight*r
            force = area*sqrt(r)
            energy = 0.4_wp*force*r
            piece%stiffness = piece%stiffness + 1.5_wp*pairwise_sum(weight*sqrt(r))
            piece%area_slope = piece%area_slope + pairwise_sum(weight)
         case (2)
            exponent = log(r)
            call exponentials(n_points, p%b3_less_1*exponent, force)
            call exponentials(n_points, (p%b2 - 1.0_wp)*exponent, area)
            force = weight*force
            area = weight*area
            piece%stiffness = piece%stiffness + p%b3*pairwise_sum(force)
            piece%area_slope = piece%area_slope + p%b2*pairwise_sum(area)
            force = force*r
            area = area*r
            energy = (0.4_wp - inverse)*weight + inverse*force*r
         case default
            area = 2.0_wp*weight*r
            force = area/p%yield_factor
            energy = weight*(p%energy_2/(p%n1*p%w1) &
               + (r - p%plastic_ratio)*(r + p%plastic_ratio)/p%yield_factor)
            piece%stiffness = piece%stiffness + 2.0_wp/p%yield_factor*pairwise_sum(weight)
            piece%area_slope = piece%area_slope + 2.0_wp*pairwise_sum(weight)
         end select
      end associate
      piece%area = piece%area + pairwise_sum(area)
      piece%pressure = piece%pressure + pairwise_sum(force)
      piece%energy = piece%energy + pairwise_sum(energy)
   end subroutine add_panel

end module asperity_law_quadrature_pieces_by_johnson
