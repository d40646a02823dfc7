!> Integrals over plastic summits that part again.
module asperity_law_unloading_plastic_pieces
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_heights, only: find_dense_range
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points, points, weights
   use asperity_law_unloading_sums, only: add_summits, lowest, lowest_exponent
   implicit none
   private
   public :: plastic_unloading_piece, recoverable_plastic_energy

   !> Smallest w2/sigma with one panel of plastic summits; otherwise the ends of the panels that
   !> their range is split into
   real(wp), parameter :: smallest_w2 = 0.11_wp
   real(wp), parameter :: one(0:1) = [0.0_wp, 1.0_wp]
   real(wp), parameter :: four(0:4) = [0.0_wp, 0.05_wp, 0.3_wp, 0.65_wp, 1.0_wp]

contains

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
         .and. properties%w2 >= smallest_w2*properties%sigma
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

      piece = no_summits
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

end module asperity_law_unloading_plastic_pieces
