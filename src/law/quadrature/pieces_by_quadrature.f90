!> The three pieces of the normal law: integrals over elastic, elasto-plastic and plastic summits,
!> the first two by quadrature that fits any properties and separation, the last in closed form.
module asperity_law_quadrature_pieces_by_quadrature
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: find_tail_moments
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: n_points, pairwise_sum
   use asperity_law_quadrature_heights, only: new_log_quadrature, new_quadrature, quadrature_type, &
      relative_exponent
   implicit none
   private
   public :: piece_type, elastic_piece, elastoplastic_piece, plastic_piece

   !> Integrals over one piece, to be multiplied by exp(-exponent - max(h, 0)^2/2). Without default
   !> values, which flang sets by library calls that take as long as the piece itself.
   type :: piece_type
      !> Force, its slope, area, its slope and energy, in units of N1, N1/w1, pi R w1, pi R, N1 w1
      real(wp) :: pressure, stiffness, area, area_slope, energy
      !> Of an elasto-plastic energy what unloading gives back and what it does not (see
      !> `asperity_law_unloading_law`), on request; their sum is the energy
      real(wp) :: recoverable, dissipation
      !> See above; never negative
      real(wp) :: exponent
   end type piece_type

   !> The piece of no summits
   type(piece_type), parameter, public :: no_summits = piece_type(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, &
      0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp)

contains

   !> Integrals of the force, its slope, area and energy over elastic summits, in units of N1,
   !> N1/w1, pi R w1 and N1 w1, and of the area's slope in pi R. The summits are those of
   !> deformations up to `largest`, w1 or less.
   pure function elastic_piece(properties, separation, largest) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, largest
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: force_slope, force
      integer :: i

      rule = new_quadrature(properties, separation, 0.0_wp, largest)
      piece = no_summits
      piece%exponent = rule%exponent
      do i = 1, rule%panels
         associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i))
            force_slope = weight*sqrt(ratio)
            force = force_slope*ratio
            piece%stiffness = piece%stiffness + 1.5_wp*pairwise_sum(force_slope)
            piece%pressure = piece%pressure + pairwise_sum(force)
            piece%area = piece%area + pairwise_sum(weight*ratio)
            piece%energy = piece%energy + 0.4_wp*pairwise_sum(force*ratio)
            piece%area_slope = piece%area_slope + pairwise_sum(weight)
         end associate
      end do
   end function elastic_piece

   !> The same over elasto-plastic summits.
   pure function elastoplastic_piece(properties, separation, with_memory) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      !> Whether recoverable energy and dissipation are wanted
      logical, intent(in) :: with_memory
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: force, area, work, recoverable
      real(wp) :: inverse
      integer :: i

      rule = new_log_quadrature(properties, separation, properties%w1, properties%w2)
      piece = no_summits
      piece%exponent = rule%exponent
      inverse = 1.0_wp/(properties%b3 + 1.0_wp)
      do i = 1, rule%panels
         associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i), b2 => properties%b2)
            call exponentials(n_points, properties%b3_less_1*rule%log_ratio(:, i), force)
            call exponentials(n_points, b2*rule%log_ratio(:, i), area)
            if (with_memory) then
               ! 2/5 of force times recovery, the force over the root of the area
               recoverable = 0.4_wp*(ratio*force)**2/sqrt(area)
               work = 0.4_wp - inverse + inverse*ratio**2*force
               piece%recoverable = piece%recoverable + pairwise_sum(weight*recoverable)
               piece%dissipation = piece%dissipation + pairwise_sum(weight*(work - recoverable))
            end if
            force = weight*ratio*force
            area = weight*area
            piece%stiffness = piece%stiffness + properties%b3*pairwise_sum(force/ratio)
            piece%pressure = piece%pressure + pairwise_sum(force)
            piece%area = piece%area + pairwise_sum(area)
            piece%area_slope = piece%area_slope + b2*pairwise_sum(area/ratio)
            piece%energy = piece%energy &
               + pairwise_sum((0.4_wp - inverse)*weight + inverse*force*ratio)
         end associate
      end do
   end function elastoplastic_piece

   !> The same over plastic summits, in closed form: force and area are linear in w.
   pure function plastic_piece(properties, separation) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type) :: piece
      real(wp) :: a, b, y, moments(0:2), slope

      a = properties%w1/properties%sigma
      b = properties%w2/properties%sigma
      y = (separation + properties%w2)/properties%sigma
      call find_tail_moments(y, moments)
      piece = no_summits
      ! moments of y < 0 are not scaled
      piece%exponent = relative_exponent(separation/properties%sigma, b, max(y, 0.0_wp))
      slope = 2.0_wp/properties%yield_factor
      piece%stiffness = slope*moments(0)
      piece%area_slope = 2.0_wp*moments(0)
      piece%area = 2.0_wp*(moments(1) + b*moments(0))/a
      piece%pressure = slope*(moments(1) + b*moments(0))/a
      piece%energy = properties%energy_2/(properties%n1*properties%w1)*moments(0) &
         + 0.5_wp*slope*(moments(2) + 2.0_wp*b*moments(1))/(a*a)
   end function plastic_piece

end module asperity_law_quadrature_pieces_by_quadrature
