!> The normal law of a rough face: summits with Gaussian heights, each of them elastic,
!> elasto-plastic or fully plastic (Eqs 23-26), as a function of the separation d of the rigid
!> plane from the mean plane of summit heights. Direct evaluation by quadrature, the reference
!> of everything else. The law is reversible: it has no memory.
!>
!> Three pieces, in the summit deformation t = w/sigma: elastic on (0, w1), elasto-plastic on
!> (w1, w2), plastic beyond. Each integral is scaled by the density at its largest point, so
!> that no piece underflows before the result does.
module asperity_normal_law
   use asperity_gauss_legendre, only: n_points, pairwise_sum
   use asperity_gaussian_tail, only: tail_moments
   use asperity_height_quadrature, only: new_quadrature, quadrature_type, relative_exponent
   use asperity_kinds, only: wp
   use asperity_properties, only: normal_properties, pi
   use asperity_validity, only: area_above_nominal, closure_above_half_radius, &
      pressure_above_hardness, valid
   implicit none
   private
   public :: normal_response, evaluate_normal_law

   !> Answer of the rough face at one separation.
   type :: normal_response
      !> Pressure on nominal area, MPa (Eq. 26)
      real(wp) :: pressure = 0.0_wp
      !> Normal stiffness -dp/dd, MPa/mm
      real(wp) :: stiffness = 0.0_wp
      !> Real area over nominal area (Eq. 25)
      real(wp) :: area_fraction = 0.0_wp
      !> Summits in contact per nominal area, 1/mm^2 (Eq. 24)
      real(wp) :: contact_density = 0.0_wp
      !> Stored energy per nominal area, integral of p from d to infinity, N/mm
      real(wp) :: energy = 0.0_wp
      !> Shares of the pressure carried by elastic, elasto-plastic and plastic summits; they sum
      !> to one, also where the pressure itself underflows to zero
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> `valid`, or flags (see `asperity_validity`)
      integer :: validity = valid
   end type normal_response

   !> Integrals over one piece, to be multiplied by exp(-exponent - max(h, 0)^2/2).
   type :: piece_type
      real(wp) :: pressure = 0.0_wp, stiffness = 0.0_wp, area = 0.0_wp, energy = 0.0_wp
      real(wp) :: exponent = 0.0_wp
   end type piece_type

contains

   !> Evaluate the law at one separation. Relative error below 1e-12 in every component that is
   !> a normal number, for -40 <= d/sigma <= 37, 1e-8 <= w1/sigma <= 1e3; zero where it underflows.
   !> The pressure never rises with d over steps above 64 eps max(sigma, |d|), round-off's size.
   pure elemental function evaluate_normal_law(properties, separation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      type(normal_response) :: response
      type(piece_type) :: pieces(3)
      real(wp) :: h, moments(0:2), decay, total, root(3), share(3)

      h = separation/properties%sigma
      pieces = [elastic_piece(properties, separation), &
         elastoplastic_piece(properties, separation), plastic_piece(properties, separation)]
      moments = tail_moments(h)
      root = exp(-0.5_wp*pieces%exponent)
      decay = exp(-0.5_wp*max(h, 0.0_wp)**2)

      associate (p => properties, r => response)
         total = sum(root*root*pieces%pressure)
         r%pressure = p%eta*p%n1*total*decay
         r%stiffness = p%eta*p%n1/p%w1*sum(root*root*pieces%stiffness)*decay
         r%area_fraction = p%eta*pi*p%radius*p%w1*sum(root*root*pieces%area)*decay
         r%energy = p%eta*p%n1*p%w1*sum(root*root*pieces%energy)*decay
         r%contact_density = p%eta*moments(0)*decay
         if (total > 0.0_wp) then
            ! root by root, so that a share underflows only when it is no normal number itself
            share = pieces%pressure/total*root*root
            r%elastic_share = share(1)
            r%elastoplastic_share = share(2)
            r%plastic_share = share(3)
         end if
         r%validity = p%validity
         if (r%area_fraction > 1.0_wp) r%validity = ior(r%validity, area_above_nominal)
         if (r%pressure > p%hardness) r%validity = ior(r%validity, pressure_above_hardness)
         if (p%sigma*moments(1) > 0.5_wp*p%radius*moments(0)) &
            r%validity = ior(r%validity, closure_above_half_radius)
      end associate
   end function evaluate_normal_law

   !> Integrals of the force, its slope, area and energy over elastic summits, in units of N1,
   !> N1/w1, pi R w1 and N1 w1.
   pure function elastic_piece(properties, separation) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: force_slope, force
      integer :: i

      rule = new_quadrature(properties, separation, 0.0_wp, properties%w1)
      piece%exponent = rule%exponent
      do i = 1, rule%panels
         associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i))
            force_slope = weight*sqrt(ratio)
            force = force_slope*ratio
            piece%stiffness = piece%stiffness + 1.5_wp*pairwise_sum(force_slope)
            piece%pressure = piece%pressure + pairwise_sum(force)
            piece%area = piece%area + pairwise_sum(weight*ratio)
            piece%energy = piece%energy + 0.4_wp*pairwise_sum(force*ratio)
         end associate
      end do
   end function elastic_piece

   !> The same over elasto-plastic summits.
   pure function elastoplastic_piece(properties, separation) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp), dimension(n_points) :: log_ratio, force
      integer :: i

      rule = new_quadrature(properties, separation, properties%w1, properties%w2)
      piece%exponent = rule%exponent
      associate (b2 => properties%b2, b3 => properties%b3)
         do i = 1, rule%panels
            associate (ratio => rule%ratio(:, i), weight => rule%weight(:, i))
               log_ratio = log(ratio)
               force = ratio*exp(properties%b3_less_1*log_ratio)
               piece%stiffness = piece%stiffness + b3*pairwise_sum(weight*force/ratio)
               piece%pressure = piece%pressure + pairwise_sum(weight*force)
               piece%area = piece%area + pairwise_sum(weight*exp(b2*log_ratio))
               piece%energy = piece%energy &
                  + pairwise_sum(weight*(0.4_wp + (force*ratio - 1.0_wp)/(b3 + 1.0_wp)))
            end associate
         end do
      end associate
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
      moments = tail_moments(y)
      ! moments of y < 0 are not scaled
      piece%exponent = relative_exponent(separation/properties%sigma, b, max(y, 0.0_wp))
      slope = 2.0_wp/properties%yield_factor
      piece%stiffness = slope*moments(0)
      piece%area = 2.0_wp*(moments(1) + b*moments(0))/a
      piece%pressure = slope*(moments(1) + b*moments(0))/a
      piece%energy = properties%energy_2/(properties%n1*properties%w1)*moments(0) &
         + 0.5_wp*slope*(moments(2) + 2.0_wp*b*moments(1))/(a*a)
   end function plastic_piece

end module asperity_normal_law
