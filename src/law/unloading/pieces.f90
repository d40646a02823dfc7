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
   use asperity_law_quadrature_fixed_points, only: elastoplastic_weight, log_ratio, &
      n => n_elastoplastic
   use asperity_law_quadrature_heights, only: find_dense_range, relative_exponent
   use asperity_law_quadrature_pieces_by_fixed_rule, only: fixed_elastic_piece, fixed_pieces_serve
   use asperity_law_quadrature_pieces_by_quadrature, only: elastic_piece, piece_type
   use asperity_law_unloading_summit, only: recovery_exponent
   implicit none
   private
   public :: elastic_unloading_piece, elastoplastic_unloading_piece, plastic_unloading_piece

   real(wp), parameter :: log_plastic_ratio = log(plastic_ratio)
   !> Gauss points on 0..1, and weights
   real(wp), parameter :: points(n) = log_ratio/log_plastic_ratio
   real(wp), parameter :: weights(n) = elastoplastic_weight/log_plastic_ratio
   !> Ends of the panels that a range of deformations is split into where one is not enough
   real(wp), parameter :: three(0:3) = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp]/3.0_wp
   real(wp), parameter :: six(0:6) = [0.0_wp, 1.0_wp, 2.0_wp, 3.0_wp, 4.0_wp, 5.0_wp, 6.0_wp]/6.0_wp
   real(wp), parameter :: four(0:4) = [0.0_wp, 0.05_wp, 0.3_wp, 0.65_wp, 1.0_wp]
   real(wp), parameter :: one(0:1) = [0.0_wp, 1.0_wp]
   !> Below this d/sigma the density has a peak inside the range
   real(wp), parameter :: lowest = -1.0_wp
   !> Largest w1/sigma with one panel of elasto-plastic summits, smallest with one of plastic ones
   real(wp), parameter :: elastoplastic_limit = 0.02_wp, plastic_limit = 1.0e-3_wp
   !> Logarithm of w/w1 that stands for that of zero
   real(wp), parameter :: lowest_log = -50.0_wp

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
   !> 1 - exp(-c v^2). At a retraction of zero also the plastic dissipation.
   pure subroutine elastoplastic_unloading_piece(properties, closest_separation, retraction, piece, &
         dissipation)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Closest separation so far, mm
      real(wp), intent(in) :: closest_separation
      !> Separation less the closest one, mm; zero or more
      real(wp), intent(in) :: retraction
      !> Integrals, by the density at the closest separation
      type(piece_type), intent(out) :: piece
      !> Plastic dissipation up to the closest separation, in units of N1 w1
      real(wp), intent(out), optional :: dissipation

      if (closest_separation < lowest*properties%sigma) then
         call sum_elastoplastic(properties, closest_separation, retraction, six, piece, dissipation)
      else if (properties%w1 > elastoplastic_limit*properties%sigma) then
         call sum_elastoplastic(properties, closest_separation, retraction, three, piece, &
            dissipation)
      else
         call sum_elastoplastic(properties, closest_separation, retraction, one, piece, dissipation)
      end if
   end subroutine elastoplastic_unloading_piece

   pure subroutine sum_elastoplastic(properties, closest_separation, retraction, ends, piece, &
         dissipation)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction, ends(0:)
      type(piece_type), intent(out) :: piece
      real(wp), intent(out), optional :: dissipation
      real(wp) :: u, c, edge, anchor, y, lower, upper, first, last, width, inverse, start
      real(wp), dimension(n) :: v, log_x, x, recovery, radius, left, t, weight
      integer :: panel

      if (present(dissipation)) dissipation = 0.0_wp
      associate (p => properties)
         u = retraction/p%w1
         c = recovery_exponent(p)
         edge = lowest_log
         if (u > 0.0_wp) edge = max(log(u)/c, lowest_log)
         if (edge >= log_plastic_ratio) return
         start = max(edge, 0.0_wp)
         call find_dense_range(p, closest_separation, p%w1*exp(start), p%w2, anchor, y, lower, &
            upper, piece%exponent)
         anchor = anchor/p%sigma
         first = sqrt(max(log((anchor + lower)*p%sigma/p%w1), start) - edge)
         last = sqrt(max(min(log((anchor + upper)*p%sigma/p%w1), log_plastic_ratio), start) - edge)
         inverse = 1.0_wp/(p%b3 + 1.0_wp)
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            v = first + (last - first)*ends(panel - 1) + width*points
            log_x = edge + v*v
            call exponentials(n, log_x, x)
            call exponentials(n, c*log_x, recovery)
            call exponentials(n, 0.5_wp*p%b2*log_x, radius)
            t = p%w1/p%sigma*x - anchor
            call exponentials(n, -t*(y + 0.5_wp*t), weight)
            weight = (2.0_wp*phi_0*width*p%w1/p%sigma)*weights*v*x*weight
            if (present(dissipation)) dissipation = dissipation + sum_of(weight*(0.4_wp - inverse &
               + radius*recovery*(inverse*x - 0.4_wp*recovery)))
            left = max(recovery - u, 0.0_wp)
            call add_summits(piece, weight, radius*sqrt(left/recovery), left)
         end do
      end associate
   end subroutine sum_elastoplastic

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

      if (closest_separation < lowest*properties%sigma &
            .or. properties%w1 < plastic_limit*properties%sigma) then
         piece = sum_plastic(properties, closest_separation, retraction, four)
      else
         piece = sum_plastic(properties, closest_separation, retraction, one)
      end if
   end function plastic_unloading_piece

   pure function sum_plastic(properties, closest_separation, retraction, ends) result(piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction, ends(0:)
      type(piece_type) :: piece
      real(wp) :: u, edge, anchor, y, lower, upper, first, last, width
      real(wp), dimension(n) :: v, recovery, left, t, weight
      integer :: panel

      associate (p => properties)
         u = retraction/p%w1
         ! deformations in sigma from here
         edge = 0.5_wp*(p%yield_factor*u)**2*p%w1/p%sigma
         call find_dense_range(p, closest_separation, max(p%w2, edge*p%sigma), &
            max(p%w2, edge*p%sigma, -closest_separation) + 10.0_wp*p%sigma, anchor, y, lower, &
            upper, piece%exponent)
         anchor = anchor/p%sigma
         first = sqrt(max(anchor - edge + lower, p%w2/p%sigma - edge, 0.0_wp))
         last = sqrt(anchor - edge + upper)
         do panel = 1, ubound(ends, 1)
            width = (last - first)*(ends(panel) - ends(panel - 1))
            v = first + (last - first)*ends(panel - 1) + width*points
            t = v*v - (anchor - edge)
            call exponentials(n, -t*(y + 0.5_wp*t), weight)
            weight = (2.0_wp*phi_0*width)*weights*v*weight
            left = (2.0_wp*p%sigma/(p%w1*p%yield_factor**2))*(v*v)
            recovery = sqrt(u*u + left)
            left = left/(recovery + u)
            call add_summits(piece, weight, p%yield_factor*sqrt(recovery*left), left)
         end do
      end associate
   end function sum_plastic

   !> Add what summits of given contact radii and elastic deformations carry.
   pure subroutine add_summits(piece, weight, radius, left)
      type(piece_type), intent(inout) :: piece
      real(wp), dimension(n), intent(in) :: weight, radius, left
      real(wp), dimension(4) :: stiffness, force, energy, area, w, f
      integer :: i

      stiffness = 0.0_wp
      force = 0.0_wp
      energy = 0.0_wp
      area = 0.0_wp
      do i = 1, n, 4
         w = weight(i:i + 3)*radius(i:i + 3)
         f = w*left(i:i + 3)
         stiffness = stiffness + w
         force = force + f
         energy = energy + f*left(i:i + 3)
         area = area + w*radius(i:i + 3)
      end do
      piece%stiffness = piece%stiffness + 1.5_wp*sum(stiffness)
      piece%pressure = piece%pressure + sum(force)
      piece%energy = piece%energy + 0.4_wp*sum(energy)
      piece%area = piece%area + sum(area)
   end subroutine add_summits

   pure real(wp) function sum_of(values)
      real(wp), intent(in) :: values(n)
      real(wp) :: parts(4)
      integer :: i

      parts = 0.0_wp
      do i = 1, n, 4
         parts = parts + values(i:i + 3)
      end do
      sum_of = sum(parts)
   end function sum_of

end module asperity_law_unloading_pieces
