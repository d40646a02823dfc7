!> Integrals over elastic and elasto-plastic summits that part again, by the stage of their largest
!> deformation: elastic ones are those of the law without memory, others are summed by quadrature.
module asperity_law_unloading_pieces
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: find_dense_range, relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastic_piece, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, no_summits, &
      piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points, points, weights
   use asperity_law_unloading_sums, only: add_summits, lowest, lowest_exponent
   use asperity_law_unloading_summit, only: recovery_exponent
   implicit none
   private
   public :: elastic_unloading_piece, elastoplastic_unloading_piece

   !> The root of the area of an elasto-plastic summit, in pi R w1, is sqrt(x) exp(area_slope ln x)
   !> with area_slope = (b2 - 1)/2: the second factor grows from 1 to sqrt(2), by powers from the
   !> middle
   real(wp), parameter :: log_2 = log(2.0_wp), root_of_root_2 = sqrt(sqrt(2.0_wp))
   real(wp), parameter :: series(0:9) = 1.0_wp/[1.0_wp, 1.0_wp, 2.0_wp, 6.0_wp, 24.0_wp, &
      120.0_wp, 720.0_wp, 5040.0_wp, 40320.0_wp, 362880.0_wp]
   !> Largest w2/sigma, and product of it and d/sigma, with one panel of elasto-plastic summits
   real(wp), parameter :: largest_w2 = 2.2_wp, largest_product = 9.9_wp

contains

   !> Summits of a largest deformation below w1: those of the law without memory at the separation
   !> now, up to the deformation w1 - u.
   pure function elastic_unloading_piece(properties, closest_separation, retraction) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece
      real(wp) :: h, now, largest

      piece = no_summits
      if (.not. retraction < properties%w1) return
      associate (p => properties)
         h = closest_separation/p%sigma
         now = (closest_separation + retraction)/p%sigma
         largest = p%w1 - retraction
         if (fixed_pieces_serve(p, now)) then
            piece = fixed_elastic_piece(p, now, largest/p%w1)
         else
            piece = elastic_piece(p, closest_separation + retraction, largest)
         end if
         piece%exponent = piece%exponent &
            + relative_exponent(h, retraction/p%sigma, max(now, 0.0_wp))
      end associate
   end function elastic_unloading_piece

   !> Summits of a largest deformation between w1 and w2. With x = w/w1 the recovery is x^c, and the
   !> variable is v, ln x = ln x_u + v^2, x_u the ratio that just loses contact: 1 - u/e is
   !> 1 - exp(-c v^2).
   pure function elastoplastic_unloading_piece(properties, closest_separation, retraction, edge, &
         log_edge) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> See `find_contact_edge`
      real(wp), intent(in) :: edge, log_edge
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece
      real(wp) :: u, c, from, anchor, y, lower, upper, first, last, width, start, a, b, v, log_x, &
         t, z, log_ratio, area_slope
      real(wp) :: exponents(2*n), powers(2*n)
      real(wp), dimension(n) :: density, weight, left, radius
      integer :: panel, panels, i

      piece = no_summits
      if (.not. edge < properties%w2) return
      associate (p => properties)
         u = retraction/p%w1
         c = recovery_exponent(p)
         log_ratio = log(p%plastic_ratio)
         area_slope = 0.5_wp*log_2/log_ratio
         from = max(p%w1, edge)
         call find_dense_range(p, closest_separation, from, p%w2, anchor, y, lower, upper, &
            piece%exponent)
         first = max(log_edge, 0.0_wp)
         if (lower > (from - anchor)/p%sigma) first = log((anchor + lower*p%sigma)/p%w1)
         last = log_ratio
         if (upper < (p%w2 - anchor)/p%sigma) last = log((anchor + upper*p%sigma)/p%w1)
         first = sqrt(max(first - log_edge, 0.0_wp))
         last = sqrt(max(last - log_edge, 0.0_wp))
         anchor = anchor/p%sigma
         a = p%w1/p%sigma
         b = p%w2/p%sigma
         panels = 3
         if (closest_separation < lowest*p%sigma) then
            panels = 10
         else if (b <= largest_w2 .and. b*closest_separation <= largest_product*p%sigma) then
            panels = 1
         end if
         width = (last - first)/panels
         do panel = 1, panels
            start = first + width*(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               log_x = log_edge + v*v
               exponents(i) = log_x
               exponents(n + i) = c*log_x
               weight(i) = weights(i)*v
               z = area_slope*log_x - 0.25_wp*log_2
               radius(i) = root_of_root_2*exponential_series(z)
            end do
            call exponentials(2*n, exponents, powers)
            do i = 1, n
               t = a*powers(i) - anchor
               weight(i) = weight(i)*powers(i)
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
               left(i) = max(powers(n + i) - u, 0.0_wp)
               radius(i) = radius(i)*sqrt(powers(i)*left(i)/powers(n + i))
            end do
            call exponentials(n, exponents(:n), density)
            call add_summits(piece, 2.0_wp*phi_0*a*width, weight, density, radius, left)
         end do
      end associate
   end function elastoplastic_unloading_piece

   !> exp(z) for |z| <= ln(2)/4, to round-off.
   pure real(wp) function exponential_series(z)
      real(wp), intent(in) :: z
      real(wp) :: z2, z4

      z2 = z*z
      z4 = z2*z2
      exponential_series = ((series(0) + z*series(1)) + z2*(series(2) + z*series(3))) &
         + z4*((series(4) + z*series(5)) + z2*(series(6) + z*series(7))) &
         + z4*z4*(series(8) + z*series(9))
   end function exponential_series

end module asperity_law_unloading_pieces
