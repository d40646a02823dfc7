!> The normal law of a rough face: summits with Gaussian heights, each of them elastic,
!> elasto-plastic or fully plastic (Eqs 23-26), as a function of the separation d of the rigid
!> plane from the mean plane of summit heights. Direct evaluation by quadrature, the reference
!> of everything else. The law is reversible: it has no memory.
!>
!> Three pieces, in the summit deformation t = w/sigma: elastic on (0, w1), elasto-plastic on
!> (w1, w2), plastic beyond. Each integral is scaled by the density at its largest point, so
!> that no piece underflows before the result does.
module asperity_normal_law
   use asperity_gauss_legendre, only: n_points, nodes, weights
   use asperity_gaussian_tail, only: phi_0, tail_moments
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
      !> to one. Where the pressure is zero they are the limit far away: 1, 0, 0
      real(wp) :: elastic_share = 1.0_wp, elastoplastic_share = 0.0_wp, plastic_share = 0.0_wp
      !> `valid`, or flags (see `asperity_validity`)
      integer :: validity = valid
   end type normal_response

   !> Integrals over one piece, scaled by exp(-exponent).
   type :: piece_type
      real(wp) :: pressure = 0.0_wp, stiffness = 0.0_wp, area = 0.0_wp, energy = 0.0_wp
      real(wp) :: exponent = 0.0_wp
   end type piece_type

   !> Gauss points u = sqrt(w/w1) and their weights, which hold the density scaled by
   !> exp(-exponent).
   type :: quadrature_type
      integer :: n = 0
      real(wp) :: u(2*n_points), weight(2*n_points)
      real(wp) :: exponent = 0.0_wp
   end type quadrature_type

   !> Ranges that end beyond this many sigma are split
   real(wp), parameter :: wide = 4.0_wp
   !> The density is cut where it falls to exp(-45) of its largest value on the piece
   real(wp), parameter :: cut = 45.0_wp

contains

   !> Evaluate the law at one separation. Relative error below 1e-12 in every component that is
   !> a normal number, for -40 <= d/sigma <= 37, 1e-8 <= w1/sigma <= 1e3; zero where it underflows.
   pure elemental function evaluate_normal_law(properties, separation) result(response)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Separation d, mm; any finite value up to 1e150 sigma in size
      real(wp), intent(in) :: separation
      type(normal_response) :: response
      type(piece_type) :: pieces(3)
      real(wp) :: h, moments(0:2), exponent, decay, total, root(3), share(3)

      h = separation/properties%sigma
      pieces = [elastic_piece(properties, separation), &
         elastoplastic_piece(properties, separation), plastic_piece(properties, separation)]
      moments = tail_moments(h)
      exponent = 0.5_wp*max(h, 0.0_wp)**2
      ! root of the scale of each piece relative to exp(-exponent)
      root = exp(0.5_wp*(exponent - pieces%exponent))
      decay = exp(-exponent)

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
      real(wp) :: u, f
      integer :: i

      rule = new_quadrature(properties, separation, 0.0_wp, properties%w1)
      piece%exponent = rule%exponent
      do i = 1, rule%n
         u = rule%u(i)
         f = rule%weight(i)*u
         piece%stiffness = piece%stiffness + f
         piece%area = piece%area + f*u
         f = f*u*u
         piece%pressure = piece%pressure + f
         piece%energy = piece%energy + f*u*u
      end do
      piece%stiffness = 1.5_wp*piece%stiffness
      piece%energy = 0.4_wp*piece%energy
   end function elastic_piece

   !> The same over elasto-plastic summits.
   pure function elastoplastic_piece(properties, separation) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation
      type(piece_type) :: piece
      type(quadrature_type) :: rule
      real(wp) :: v, ratio, force, f
      integer :: i

      rule = new_quadrature(properties, separation, properties%w1, properties%w2)
      piece%exponent = rule%exponent
      associate (b2 => properties%b2, b3 => properties%b3)
         do i = 1, rule%n
            f = rule%weight(i)
            ratio = rule%u(i)*rule%u(i)
            v = 2.0_wp*log(rule%u(i))
            force = exp(b3*v)
            piece%pressure = piece%pressure + f*force
            piece%stiffness = piece%stiffness + f*force/ratio
            piece%area = piece%area + f*exp(b2*v)
            piece%energy = piece%energy + f*(0.4_wp + (force*ratio - 1.0_wp)/(b3 + 1.0_wp))
         end do
         piece%stiffness = b3*piece%stiffness
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
      piece%exponent = 0.5_wp*max(y, 0.0_wp)**2
      slope = 2.0_wp/properties%yield_factor
      piece%stiffness = slope*moments(0)
      piece%area = 2.0_wp*(moments(1) + b*moments(0))/a
      piece%pressure = slope*(moments(1) + b*moments(0))/a
      piece%energy = properties%energy_2/(properties%n1*properties%w1)*moments(0) &
         + 0.5_wp*slope*(moments(2) + 2.0_wp*b*moments(1))/(a*a)
   end function plastic_piece

   !> Points u = sqrt(w/w1) and weights for integrals of smooth functions of u times the density
   !> over the deformations from..to, cut to where the density matters.
   !> A wide range is split at a quarter of its upper end, since the density narrows in u.
   pure function new_quadrature(properties, separation, from, to) result(rule)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: separation, from, to
      type(quadrature_type) :: rule
      real(wp) :: h, lower, upper, anchor, y, reach

      h = separation/properties%sigma
      anchor = min(max(-separation, from), to)
      y = (separation + anchor)/properties%sigma
      rule%exponent = 0.5_wp*y*y
      reach = 2.0_wp*cut/(sqrt(y*y + 2.0_wp*cut) + abs(y))
      anchor = anchor/properties%sigma
      lower = max(from/properties%sigma, anchor - reach)
      upper = min(to/properties%sigma, anchor + reach)
      if (upper > wide .and. lower < 0.25_wp*upper) then
         call add_panel(rule, h, properties%w1/properties%sigma, anchor, lower, 0.25_wp*upper)
         lower = 0.25_wp*upper
      end if
      call add_panel(rule, h, properties%w1/properties%sigma, anchor, lower, upper)
   end function new_quadrature

   !> Add the Gauss points of t = w/sigma in lower..upper, with t = a u^2.
   pure subroutine add_panel(rule, h, a, anchor, lower, upper)
      type(quadrature_type), intent(inout) :: rule
      real(wp), intent(in) :: h, a, anchor, lower, upper
      real(wp) :: middle, half, u(n_points), t(n_points)

      middle = 0.5_wp*(sqrt(upper/a) + sqrt(lower/a))
      half = 0.5_wp*(sqrt(upper/a) - sqrt(lower/a))
      u = middle + half*nodes
      t = a*u*u
      rule%u(rule%n + 1:rule%n + n_points) = u
      rule%weight(rule%n + 1:rule%n + n_points) = (2.0_wp*phi_0*a*half)*weights*u &
         *exp(-(t - anchor)*(h + 0.5_wp*(t + anchor)))
      rule%n = rule%n + n_points
   end subroutine add_panel

end module asperity_normal_law
