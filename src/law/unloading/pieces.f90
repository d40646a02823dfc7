!> Integrals over summits that part again, by the stage of their largest deformation w: elastic ones
!> are those of the law without memory, yielded ones are summed by quadrature.
!>
!> A yielded summit's contact radius is a, and it is still pressed in elastically by e(w) - u, e its
!> recovery and u the retraction: its stiffness is 3/2 a, its force a (e - u), its stored energy
!> 2/5 a (e - u)^2 and its area a^2, in units of N1, w1 and sqrt(R w1). The point where it loses
!> contact is a branch point of a; each stage has a variable without it.
module asperity_law_unloading_pieces
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties, plastic_ratio
   use asperity_law_quadrature_heights, only: find_dense_range, relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastic_piece, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points, points, weights
   use asperity_law_unloading_summit, only: recovery_exponent
   implicit none
   private
   public :: elastic_unloading_piece, elastoplastic_unloading_piece, plastic_unloading_piece, &
      recoverable_plastic_energy

   real(wp), parameter :: log_plastic_ratio = log(plastic_ratio)
   !> The root of the area of an elasto-plastic summit, in pi R w1, is sqrt(x) exp(area_slope ln x):
   !> the second factor grows from 1 to sqrt(2), by powers from the middle
   real(wp), parameter :: log_2 = log(2.0_wp), root_of_root_2 = sqrt(sqrt(2.0_wp))
   real(wp), parameter :: area_slope = 0.5_wp*log_2/log_plastic_ratio
   real(wp), parameter :: series(0:9) = 1.0_wp/[1.0_wp, 1.0_wp, 2.0_wp, 6.0_wp, 24.0_wp, &
      120.0_wp, 720.0_wp, 5040.0_wp, 40320.0_wp, 362880.0_wp]
   !> Exponents of the density are kept within what `exponentials` takes, as rounding of
   !> deformations carries them away where no summit touches
   real(wp), parameter :: lowest_exponent = -100.0_wp
   !> Below this d/sigma the density has a peak inside the range
   real(wp), parameter :: lowest = -1.0_wp
   !> Largest w1/sigma, and product of it and d/sigma, with one panel of elasto-plastic summits
   real(wp), parameter :: largest_ratio = 0.02_wp, largest_product = 0.09_wp
   !> Smallest w1/sigma with one panel of plastic summits; otherwise the ends of the panels that
   !> their range is split into
   real(wp), parameter :: smallest_ratio = 1.0e-3_wp
   real(wp), parameter :: one(0:1) = [0.0_wp, 1.0_wp]
   real(wp), parameter :: four(0:4) = [0.0_wp, 0.05_wp, 0.3_wp, 0.65_wp, 1.0_wp]

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

      if (.not. retraction < properties%w1) return
      associate (p => properties)
         h = closest_separation/p%sigma
         now = (closest_separation + retraction)/p%sigma
         largest = p%w1 - retraction
         if (fixed_pieces_serve(p%w1/p%sigma, now)) then
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
      real(wp) :: u, c, from, anchor, y, lower, upper, first, last, width, start, a, v, log_x, t, z
      real(wp) :: exponents(2*n), powers(2*n)
      real(wp), dimension(n) :: density, weight, left, radius
      integer :: panel, panels, i

      if (.not. edge < properties%w2) return
      associate (p => properties)
         u = retraction/p%w1
         c = recovery_exponent(p)
         from = max(p%w1, edge)
         call find_dense_range(p, closest_separation, from, p%w2, anchor, y, lower, upper, &
            piece%exponent)
         first = max(log_edge, 0.0_wp)
         if (lower > (from - anchor)/p%sigma) first = log((anchor + lower*p%sigma)/p%w1)
         last = log_plastic_ratio
         if (upper < (p%w2 - anchor)/p%sigma) last = log((anchor + upper*p%sigma)/p%w1)
         first = sqrt(max(first - log_edge, 0.0_wp))
         last = sqrt(max(last - log_edge, 0.0_wp))
         anchor = anchor/p%sigma
         a = p%w1/p%sigma
         panels = 3
         if (closest_separation < lowest*p%sigma) then
            panels = 10
         else if (a <= largest_ratio .and. a*closest_separation <= largest_product*p%sigma) then
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

   !> Summits of a largest deformation above w2: e = sqrt(2 x)/k, and the variable is
   !> sqrt(x - x_u).
   pure function plastic_unloading_piece(properties, closest_separation, retraction) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Integrals, by the density at the closest separation
      type(piece_type) :: piece

      if (has_one_panel(properties, closest_separation)) then
         piece = sum_plastic(properties, closest_separation, retraction, one)
      else
         piece = sum_plastic(properties, closest_separation, retraction, four)
      end if
   end function plastic_unloading_piece

   !> The `energy` of the same piece at a retraction of zero, 2/5 N e a summit: by its exponent,
   !> which is that of the plastic piece of the law without memory.
   pure real(wp) function recoverable_plastic_energy(properties, separation) result(energy)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation, mm
      real(wp), intent(in) :: separation

      if (has_one_panel(properties, separation)) then
         energy = sum_plastic_energy(properties, separation, one)
      else
         energy = sum_plastic_energy(properties, separation, four)
      end if
   end function recoverable_plastic_energy

   !> Whether one panel is enough for plastic summits.
   pure logical function has_one_panel(properties, closest_separation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation

      has_one_panel = closest_separation >= lowest*properties%sigma &
         .and. properties%w1 >= smallest_ratio*properties%sigma
   end function has_one_panel

   !> Range of the root of the deformation beyond the edge, and the density in it: from the anchor,
   !> where it is densest, at y. All in sigma, as is the edge.
   pure subroutine find_plastic_range(properties, closest_separation, edge, anchor, y, first, &
         last, exponent)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, edge
      real(wp), intent(out) :: anchor, y, first, last, exponent
      real(wp) :: lower, upper

      associate (p => properties)
         call find_dense_range(p, closest_separation, max(p%w2, edge*p%sigma), &
            max(p%w2, edge*p%sigma, -closest_separation) + 10.0_wp*p%sigma, anchor, y, lower, &
            upper, exponent)
         anchor = anchor/p%sigma
         first = sqrt(max(anchor - edge + lower, p%w2/p%sigma - edge, 0.0_wp))
         last = sqrt(anchor - edge + upper)
      end associate
   end subroutine find_plastic_range

   pure function sum_plastic(properties, closest_separation, retraction, ends) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction, ends(0:)
      type(piece_type) :: piece
      real(wp) :: u, edge, anchor, y, first, last, width, start, v, scale, t, recovery
      real(wp), dimension(n) :: exponents, density, weight, left, radius
      integer :: panel, i

      associate (p => properties)
         u = retraction/p%w1
         ! deformations in sigma from here
         edge = 0.5_wp*(p%yield_factor*u)**2*p%w1/p%sigma
         call find_plastic_range(p, closest_separation, edge, anchor, y, first, last, &
            piece%exponent)
         scale = 2.0_wp*p%sigma/(p%w1*p%yield_factor**2)
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            start = first + (last - first)*ends(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               weight(i) = weights(i)*v
               v = v*v
               t = v - (anchor - edge)
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
               left(i) = scale*v
               recovery = sqrt(u*u + left(i))
               left(i) = left(i)/(recovery + u)
               radius(i) = p%yield_factor*sqrt(recovery*left(i))
            end do
            call exponentials(n, exponents, density)
            call add_summits(piece, 2.0_wp*phi_0*width, weight, density, radius, left)
         end do
      end associate
   end function sum_plastic

   !> The energy alone at a retraction of zero, 2/5 k e^3 a summit: fewer roots and sums.
   pure real(wp) function sum_plastic_energy(properties, separation, ends) result(energy)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, ends(0:)
      real(wp) :: exponent, anchor, y, first, last, width, start, v, t, part(2)
      real(wp), dimension(n) :: exponents, density, weight
      integer :: panel, i, j

      associate (p => properties)
         call find_plastic_range(p, separation, 0.0_wp, anchor, y, first, last, exponent)
         energy = 0.0_wp
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            start = first + (last - first)*ends(panel - 1)
            do i = 1, n
               v = start + width*points(i)
               weight(i) = weights(i)*(v*v)**2
               t = v*v - anchor
               exponents(i) = max(min(-t*(y + 0.5_wp*t), 0.0_wp), lowest_exponent)
            end do
            call exponentials(n, exponents, density)
            part = 0.0_wp
            do i = 0, n - 2, 2
               do j = 1, 2
                  part(j) = part(j) + weight(i + j)*density(i + j)
               end do
            end do
            energy = energy + width*(part(1) + part(2))
         end do
         t = p%sigma/p%w1
         energy = 0.4_wp*2.0_wp*phi_0/p%yield_factor**2*(2.0_wp*t)*sqrt(2.0_wp*t)*energy
      end associate
   end function sum_plastic_energy

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

   !> Add what summits of given contact radii and elastic deformations carry, in four parts side by
   !> side.
   pure subroutine add_summits(piece, scale, weight, density, radius, left)
      type(piece_type), intent(inout) :: piece
      real(wp), intent(in) :: scale
      real(wp), dimension(n), intent(in) :: weight, density, radius, left
      real(wp), dimension(4) :: stiffness, force, energy, area, w, f
      integer :: i

      stiffness = 0.0_wp
      force = 0.0_wp
      energy = 0.0_wp
      area = 0.0_wp
      do i = 1, n, 4
         w = weight(i:i + 3)*density(i:i + 3)*radius(i:i + 3)
         f = w*left(i:i + 3)
         stiffness = stiffness + w
         force = force + f
         energy = energy + f*left(i:i + 3)
         area = area + w*radius(i:i + 3)
      end do
      piece%stiffness = piece%stiffness + 1.5_wp*scale*sum(stiffness)
      piece%pressure = piece%pressure + scale*sum(force)
      piece%energy = piece%energy + 0.4_wp*scale*sum(energy)
      piece%area = piece%area + scale*sum(area)
   end subroutine add_summits

end module asperity_law_unloading_pieces
