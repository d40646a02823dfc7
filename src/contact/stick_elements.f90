!> Summits that stick each for itself. Mindlin (1949): a summit under the force N, of contact radius
!> a, leans over by delta under T = mu N (1 - (1 - delta/delta_i)^(3/2)) and slides from
!> delta_i = 3 mu N/(16 G* a) on; N and a = sqrt(A/pi) are those of the normal law. The sum over the
!> heights is the backbone. It is concave, so its chords are a sum of elements, each with a critical
!> slip of its own, that repeat it up to the chords' distance and all its loops by Masing's rule.
!>
!> All slips are over the coefficient mu, as it only scales them.
module asperity_contact_stick_elements
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_quadrature_gauss_legendre, only: m => n_points, nodes, weights
   implicit none
   private
   public :: stick_elements, find_stick_elements, summit_backbone, equivalent_shear_modulus

   !> Elements at one separation. Without default values, which flang sets by library calls.
   type :: stick_elements
      !> Number of elements; the first n of the arrays count
      integer :: n
      !> Share of the largest shear stress that an element carries when all slide: positive, sum 1;
      !> and its derivative by closure, 1/mm
      real(wp) :: share(most_stick_elements), share_by_closure(most_stick_elements)
      !> Critical slip over mu, mm, rising; and its derivative by closure
      real(wp) :: unit_slip(most_stick_elements), unit_slip_by_closure(most_stick_elements)
      !> Shear stiffness at first touch, MPa/mm: 8 G* a of all summits in contact
      real(wp) :: stiffness
   end type stick_elements

   !> Summits at the points of a quadrature over heights, at one separation.
   type :: summits
      !> What forces per area, MPa, and critical slips over mu, mm, are told in
      real(wp) :: unit_force, unit_slip
      !> Force times density and weight, and its derivative by d/sigma
      real(wp) :: force(m), force_slope(m)
      !> Critical slip over mu, and its derivative by d/sigma
      real(wp) :: slip(m), slip_slope(m)
      !> 1/slip, force/slip, and the latter times slip_slope/slip
      real(wp) :: inverse(m), stiffness(m), stiffness_drop(m)
      !> Sums of forces and their derivatives
      real(wp) :: total, total_slope
   end type summits

   !> Heights count as long as their density is above exp(-cut) of the largest
   real(wp), parameter :: cut = 18.0_wp
   !> Knots suit a backbone of 1 - (1 - x/kappa)^kappa, x the slip over that at which the first
   !> slope meets the plateau: kappa = 3/2 for equal summits, infinite for exponential heights. It
   !> follows from the area over the backbone; taken larger for the tail of the heights. The last
   !> chord ends on the plateau, part of a step beyond what would be the end for kappa.
   real(wp), parameter :: tail_factor = 0.75_wp, tail_step = 0.5_wp

contains

   !> Elements at a separation. Shares and slips are differentiable in it but where a point of the
   !> quadrature passes w1 or w2.
   pure subroutine find_stick_elements(normal, shear_modulus, n, separation, elements)
      !> Checked properties of the normal law: Gaussian heights, no memory
      type(normal_properties), intent(in) :: normal
      !> Equivalent shear modulus G*, MPa
      real(wp), intent(in) :: shear_modulus
      !> Number of elements, up to `most_stick_elements`
      integer, intent(in) :: n
      !> Separation d, mm; any finite value up to 1e100 sigma in size
      real(wp), intent(in) :: separation
      !> Result
      type(stick_elements), intent(out) :: elements
      type(summits) :: s
      real(wp) :: sums(3), slopes(3), moment, scale, scale_slope, rate, rate_slope
      real(wp) :: x, x_by_rate, knot(0:n), knot_slope(0:n), height(0:n), height_slope(0:n)
      real(wp) :: chord(n + 1), chord_slope(n + 1), width
      integer :: j

      call find_summits(normal, shear_modulus, separation, s)
      ! force, stiffness at first touch, and force times critical slip
      sums = [s%total, 1.5_wp*sum(s%stiffness), sum(s%force*s%slip)]
      slopes = [s%total_slope, 1.5_wp*sum(s%force_slope*s%inverse - s%stiffness_drop), &
         sum(s%force_slope*s%slip + s%force*s%slip_slope)]
      scale = sums(1)/sums(2)
      scale_slope = scale*(slopes(1)/sums(1) - slopes(2)/sums(2))
      ! the area over the backbone, kappa/(kappa + 1)
      moment = 0.4_wp*sums(3)/sums(1)/scale
      rate = tail_factor*(1.0_wp/moment - 1.0_wp)
      rate_slope = -tail_factor/moment &
         *(slopes(3)/sums(3) + slopes(2)/sums(2) - 2.0_wp*slopes(1)/sums(1))

      knot(0) = 0.0_wp
      knot_slope(0) = 0.0_wp
      height(0) = 0.0_wp
      height_slope(0) = 0.0_wp
      do j = 1, n
         call place_knot(j, n, rate, x, x_by_rate)
         knot(j) = scale*x
         knot_slope(j) = scale_slope*x + scale*x_by_rate*rate_slope
         call sum_backbone(s, knot(j), knot_slope(j), height(j), height_slope(j))
         height_slope(j) = (height_slope(j) - height(j)/sums(1)*slopes(1))/sums(1)
         height(j) = height(j)/sums(1)
      end do
      height(n) = 1.0_wp
      height_slope(n) = 0.0_wp
      do j = 1, n
         width = knot(j) - knot(j - 1)
         chord(j) = (height(j) - height(j - 1))/width
         chord_slope(j) = (height_slope(j) - height_slope(j - 1) &
            - chord(j)*(knot_slope(j) - knot_slope(j - 1)))/width
      end do
      chord(n + 1) = 0.0_wp
      chord_slope(n + 1) = 0.0_wp

      elements%n = n
      elements%share = 0.0_wp
      elements%share_by_closure = 0.0_wp
      elements%unit_slip = 0.0_wp
      elements%unit_slip_by_closure = 0.0_wp
      do j = 1, n
         elements%share(j) = knot(j)*(chord(j) - chord(j + 1))
         elements%share_by_closure(j) = -(knot_slope(j)*(chord(j) - chord(j + 1)) &
            + knot(j)*(chord_slope(j) - chord_slope(j + 1)))/normal%sigma
         elements%unit_slip(j) = s%unit_slip*knot(j)
         elements%unit_slip_by_closure(j) = -s%unit_slip*knot_slope(j)/normal%sigma
      end do
      elements%stiffness = s%unit_force/s%unit_slip*sums(2)
   end subroutine find_stick_elements

   !> Equivalent shear modulus G* of two elastic bodies, MPa: 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2.
   pure elemental function equivalent_shear_modulus(shear_modulus_1, poisson_1, shear_modulus_2, &
         poisson_2) result(modulus)
      !> Shear moduli, MPa
      real(wp), intent(in) :: shear_modulus_1, shear_modulus_2
      !> Poisson's ratios
      real(wp), intent(in) :: poisson_1, poisson_2
      real(wp) :: modulus

      modulus = 1.0_wp/((2.0_wp - poisson_1)/shear_modulus_1 &
         + (2.0_wp - poisson_2)/shear_modulus_2)
   end function equivalent_shear_modulus

   !> Mindlin's curve of all summits: shear stress over mu p at a slip, to be compared with its
   !> elements.
   pure real(wp) function summit_backbone(normal, shear_modulus, separation, unit_slip) &
         result(share)
      !> As above
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: shear_modulus, separation
      !> Slip over mu, mm; zero or more
      real(wp), intent(in) :: unit_slip
      type(summits) :: s
      real(wp) :: slope

      call find_summits(normal, shear_modulus, separation, s)
      call sum_backbone(s, unit_slip/s%unit_slip, 0.0_wp, share, slope)
      share = share/s%total
   end function summit_backbone

   !> Summits at Gauss points in sqrt(w), in which their forces are smooth. Force and contact radius
   !> are powers of w in each stage.
   pure subroutine find_summits(normal, shear_modulus, separation, s)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: shear_modulus, separation
      type(summits), intent(out) :: s
      real(wp) :: h, root, first, width, first_slope, width_slope, x, t, t_slope, height
      real(wp) :: by_force, by_slip, log_force(m), log_slip(m)
      integer :: i

      h = separation/normal%sigma
      root = sqrt(max(h, 0.0_wp)**2 + 2.0_wp*cut)
      first = max(-h - root, 0.0_wp)
      first_slope = merge(-1.0_wp, 0.0_wp, first > 0.0_wp)
      if (h > 0.0_wp) then
         width = 2.0_wp*cut/(root + h)
         width_slope = -width/root
      else
         width = min(root - h, 2.0_wp*root)
         width_slope = -1.0_wp - first_slope
      end if
      do i = 1, m
         x = (0.5_wp*(1.0_wp + nodes(i)))**2
         t = first + width*x
         t_slope = first_slope + width_slope*x
         height = max(h, -root) + width*x
         call find_powers(normal, t*normal%sigma, by_force, by_slip, log_force(i), log_slip(i))
         if (h > 0.0_wp) then
            log_force(i) = log_force(i) - t*(h + 0.5_wp*t)
            s%force_slope(i) = -t - height*t_slope
         else
            log_force(i) = log_force(i) - 0.5_wp*height**2
            s%force_slope(i) = -height*(1.0_wp + t_slope)
         end if
         ! of ln(force) and ln(slip), until both are known
         s%force_slope(i) = s%force_slope(i) + by_force*t_slope/t
         s%slip_slope(i) = by_slip*t_slope/t
      end do
      s%unit_force = normal%eta*normal%n1*phi_0*width*exp(-0.5_wp*max(h, 0.0_wp)**2)
      s%unit_slip = 3.0_wp*normal%n1/(16.0_wp*shear_modulus*sqrt(normal%radius*normal%w1))
      s%force = exp(log_force)*weights*0.5_wp*(1.0_wp + nodes)
      s%slip = exp(log_slip)
      s%force_slope = s%force_slope*s%force
      s%inverse = 1.0_wp/s%slip
      s%stiffness = s%force*s%inverse
      s%stiffness_drop = s%stiffness*s%slip_slope
      s%slip_slope = s%slip_slope*s%slip
      s%total = sum(s%force)
      s%total_slope = sum(s%force_slope)
   end subroutine find_summits

   !> Exponents of force and critical slip of a summit, and their logarithms over those at w1.
   pure subroutine find_powers(normal, deformation, by_force, by_slip, log_force, log_slip)
      type(normal_properties), intent(in) :: normal
      real(wp), intent(in) :: deformation
      real(wp), intent(out) :: by_force, by_slip, log_force, log_slip
      real(wp) :: log_ratio

      log_ratio = log(deformation/normal%w1)
      if (deformation < normal%w1) then
         by_force = 1.5_wp
         by_slip = 1.0_wp
         log_force = by_force*log_ratio
         log_slip = log_ratio
      else if (deformation < normal%w2) then
         by_force = normal%b3
         by_slip = normal%b3 - 0.5_wp*normal%b2
         log_force = by_force*log_ratio
         log_slip = by_slip*log_ratio
      else
         by_force = 1.0_wp
         by_slip = 0.5_wp
         log_force = log_ratio + log(2.0_wp/normal%yield_factor)
         log_slip = log_force - 0.5_wp*(log_ratio + log(2.0_wp))
      end if
   end subroutine find_powers

   !> Sum of the summits' shear forces over mu at a slip, and its derivative by d/sigma where that
   !> of the slip is given. Critical slips rise from point to point.
   pure subroutine sum_backbone(s, slip, slip_slope, total, total_slope)
      type(summits), intent(in) :: s
      real(wp), intent(in) :: slip, slip_slope
      real(wp), intent(out) :: total, total_slope
      real(wp) :: sticking, root, spared, spared_slope, by_slip, by_critical_slip
      integer :: i

      spared = 0.0_wp
      spared_slope = 0.0_wp
      by_slip = 0.0_wp
      by_critical_slip = 0.0_wp
      do i = m, 1, -1
         if (.not. s%slip(i) > slip) exit
         sticking = 1.0_wp - slip*s%inverse(i)
         root = sqrt(sticking)
         spared = spared + s%force(i)*(sticking*root)
         spared_slope = spared_slope + s%force_slope(i)*(sticking*root)
         by_slip = by_slip + s%stiffness(i)*root
         by_critical_slip = by_critical_slip + s%stiffness_drop(i)*root
      end do
      total = s%total - spared
      total_slope = s%total_slope - spared_slope &
         + 1.5_wp*(slip_slope*by_slip - slip*by_critical_slip)
   end subroutine sum_backbone

   !> Knot j of n for a rate 1/kappa, kappa (1 - r^(2/kappa)) with r = 1 - j/(n + tail_step), at
   !> which chords are equally far from 1 - (1 - x/kappa)^kappa; and its derivative by the rate.
   pure subroutine place_knot(j, n, rate, x, x_by_rate)
      integer, intent(in) :: j, n
      real(wp), intent(in) :: rate
      real(wp), intent(out) :: x, x_by_rate
      real(wp), parameter :: small = 1.0e-2_wp
      real(wp) :: l, z

      l = 2.0_wp*log(1.0_wp - real(j, wp)/(real(n, wp) + tail_step))
      z = rate*l
      if (abs(z) < small) then
         x = -l*(1.0_wp + z/2.0_wp*(1.0_wp + z/3.0_wp*(1.0_wp + z/4.0_wp*(1.0_wp + z/5.0_wp &
            *(1.0_wp + z/6.0_wp)))))
         x_by_rate = -l*l*(0.5_wp + z/3.0_wp*(1.0_wp + z*3.0_wp/8.0_wp*(1.0_wp + z*4.0_wp/15.0_wp &
            *(1.0_wp + z*5.0_wp/24.0_wp*(1.0_wp + z*6.0_wp/35.0_wp)))))
      else
         x = (1.0_wp - exp(z))/rate
         x_by_rate = -(x + l*exp(z))/rate
      end if
   end subroutine place_knot

end module asperity_contact_stick_elements
