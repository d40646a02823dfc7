!> The elastic and the elasto-plastic piece of the normal law on the points of the fixed rule: few,
!> constant, without a power function. Ten times faster than the quadrature of law_pieces, and as
!> accurate where it serves.
module asperity_law_quadrature_pieces_by_fixed_rule
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: normal_properties, plastic_area_exponent
   use asperity_law_quadrature_fixed_points, only: elastic_weight, elastoplastic_ratio, &
      elastoplastic_weight, force_powers, log_ratio, n_elastic, n_elastoplastic, root_ratio
   use asperity_law_quadrature_pieces_by_quadrature, only: piece_type
   implicit none
   private
   public :: fixed_pieces_serve, evaluate_fixed_pieces, fixed_elastic_piece

   !> Largest w1/sigma, smallest d/sigma and largest product of the two: test/test_fixed_pieces
   real(wp), parameter :: largest_ratio = 0.025_wp, lowest = -7.0_wp, largest_product = 0.28_wp

   integer, parameter :: n = n_elastic + n_elastoplastic
   real(wp), parameter :: ratio(n) = [root_ratio**2, elastoplastic_ratio]

   ! weights of the elastic sums: force, its slope, area, its slope, energy
   real(wp), parameter :: by_root(n_elastic) = 2.0_wp*elastic_weight*root_ratio
   real(wp), parameter :: elastic_force(n_elastic) = by_root*root_ratio**3
   real(wp), parameter :: elastic_slope(n_elastic) = 1.5_wp*by_root*root_ratio
   real(wp), parameter :: elastic_area(n_elastic) = by_root*root_ratio**2
   real(wp), parameter :: elastic_energy(n_elastic) = 0.4_wp*by_root*root_ratio**5
   ! and of the elasto-plastic sums; those with the force's power lack it, that of the recoverable
   ! energy, force times recovery, lacks its square
   real(wp), parameter :: by_log(n_elastoplastic) = elastoplastic_weight*elastoplastic_ratio
   real(wp), parameter :: force_weight(n_elastoplastic) = by_log*elastoplastic_ratio
   real(wp), parameter :: work_weight(n_elastoplastic) = by_log*elastoplastic_ratio**2
   real(wp), parameter :: area_weight(n_elastoplastic) = by_log*exp(plastic_area_exponent*log_ratio)
   real(wp), parameter :: recoverable_weight(n_elastoplastic) = 0.4_wp*by_log &
      *exp((2.0_wp - 0.5_wp*plastic_area_exponent)*log_ratio)
   real(wp), parameter :: area_slope_weight(n_elastoplastic) = plastic_area_exponent*by_log &
      *exp((plastic_area_exponent - 1.0_wp)*log_ratio)

contains

   !> Whether the fixed rule is accurate at a separation.
   pure logical function fixed_pieces_serve(a, h)
      !> w1/sigma and d/sigma
      real(wp), intent(in) :: a, h

      fixed_pieces_serve = a <= largest_ratio .and. h >= lowest .and. a*h <= largest_product
   end function fixed_pieces_serve

   !> Both pieces, where the fixed rule serves.
   pure subroutine evaluate_fixed_pieces(properties, h, with_area_slope, with_memory, elastic, &
         elastoplastic)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Whether the area's slope is wanted
      logical, intent(in) :: with_area_slope
      !> Whether recoverable energy and dissipation are wanted
      logical, intent(in) :: with_memory
      !> Integrals, with exponents of zero
      type(piece_type), intent(out) :: elastic, elastoplastic
      real(wp) :: a, scale, inverse, t(n), exponent(n), density(n), plain
      real(wp), dimension(n_elastoplastic) :: power, force

      a = properties%w1/properties%sigma
      t = a*ratio
      if (h > 0.0_wp) then
         exponent = -t*(h + 0.5_wp*t)
      else
         exponent = -0.5_wp*(t + h)**2
      end if
      call exponentials(n, exponent, density)

      scale = phi_0*a
      associate (first => density(:n_elastic), rest => density(n_elastic + 1:), &
            p => properties)
         call sum_elastic(scale, first, with_area_slope, elastic)
         power = force_powers(p%b3_less_1, 2.0_wp/p%yield_factor)
         force = power*rest
         inverse = 1.0_wp/(p%b3 + 1.0_wp)
         plain = weighted(n_elastoplastic, by_log, rest)
         elastoplastic%pressure = scale*weighted(n_elastoplastic, force_weight, force)
         elastoplastic%stiffness = scale*p%b3*weighted(n_elastoplastic, by_log, force)
         elastoplastic%area = scale*weighted(n_elastoplastic, area_weight, rest)
         elastoplastic%energy = scale*(inverse*weighted(n_elastoplastic, work_weight, force) &
            + (0.4_wp - inverse)*plain)
         if (with_area_slope) &
            elastoplastic%area_slope = scale*weighted(n_elastoplastic, area_slope_weight, rest)
         if (with_memory) then
            elastoplastic%recoverable = scale*weighted(n_elastoplastic, recoverable_weight, &
               power*force)
            elastoplastic%dissipation = elastoplastic%energy - elastoplastic%recoverable
         end if
      end associate
   end subroutine evaluate_fixed_pieces

   !> The elastic piece of deformations up to `largest` w1, where the fixed rule serves: that of
   !> another w1, in units of this one.
   pure function fixed_elastic_piece(properties, h, largest) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Largest deformation over w1, above zero up to one
      real(wp), intent(in) :: largest
      !> Integrals, with an exponent of zero
      type(piece_type) :: piece
      real(wp) :: a, t(n_elastic), exponent(n_elastic), density(n_elastic)

      a = largest*properties%w1/properties%sigma
      t = a*ratio(:n_elastic)
      if (h > 0.0_wp) then
         exponent = -t*(h + 0.5_wp*t)
      else
         exponent = -0.5_wp*(t + h)**2
      end if
      call exponentials(n_elastic, exponent, density)
      call sum_elastic(phi_0*a, density, .false., piece)
      piece%stiffness = piece%stiffness*sqrt(largest)
      piece%pressure = piece%pressure*largest*sqrt(largest)
      piece%area = piece%area*largest
      piece%energy = piece%energy*largest*largest*sqrt(largest)
   end function fixed_elastic_piece

   !> Set the integrals over elastic summits from the density at their points.
   pure subroutine sum_elastic(scale, density, with_area_slope, piece)
      real(wp), intent(in) :: scale, density(n_elastic)
      logical, intent(in) :: with_area_slope
      type(piece_type), intent(inout) :: piece

      piece%pressure = scale*weighted(n_elastic, elastic_force, density)
      piece%stiffness = scale*weighted(n_elastic, elastic_slope, density)
      piece%area = scale*weighted(n_elastic, elastic_area, density)
      piece%energy = scale*weighted(n_elastic, elastic_energy, density)
      if (with_area_slope) piece%area_slope = scale*weighted(n_elastic, by_root, density)
   end subroutine sum_elastic

   !> Sum of weights times values in four parts, side by side; n is a multiple of four.
   pure real(wp) function weighted(n, weight, values)
      integer, intent(in) :: n
      real(wp), intent(in) :: weight(n), values(n)
      real(wp) :: parts(4)
      integer :: i

      parts = 0.0_wp
      do i = 1, n, 4
         parts = parts + weight(i:i + 3)*values(i:i + 3)
      end do
      weighted = (parts(1) + parts(3)) + (parts(2) + parts(4))
   end function weighted

end module asperity_law_quadrature_pieces_by_fixed_rule
