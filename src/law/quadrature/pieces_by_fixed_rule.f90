!> The elastic and the elasto-plastic piece of the normal law where w1 is small against sigma: the
!> one by the power series of the density, the other on the points of a fixed rule, few and
!> constant where w2/w1 is its default; neither takes a power function. Ten times faster than the
!> general quadrature, and as accurate where it serves.
module asperity_law_quadrature_pieces_by_fixed_rule
   use asperity_base_kinds, only: wp
   use asperity_law_exponential, only: exponentials
   use asperity_law_gaussian_tail, only: phi_0
   use asperity_law_normal_properties, only: default_plastic_ratio, normal_properties
   use asperity_law_quadrature_fixed_points, only: find_force_powers, log_ratio, &
      middle, middle_exponent, n => n_points, ratio, weight
   use asperity_law_quadrature_pieces_by_quadrature, only: no_summits, piece_type
   implicit none
   private
   public :: fixed_pieces_serve, evaluate_fixed_pieces, fixed_elastic_piece, &
      fixed_elastoplastic_piece

   !> Largest w1/sigma, smallest d/sigma and largest product of the two: test/law/fixed_pieces.f90
   real(wp), parameter :: largest_ratio = 0.025_wp, lowest = -7.0_wp, largest_product = 0.28_wp

   !> Last power of w/w1 in the series of the density, and the powers themselves: the first that is
   !> left out is below 0.28^12/12! = 5e-16; for small products, 0.05^8/8! = 1e-15, fewer do
   integer, parameter :: last = 11, last_of_few = 7
   real(wp), parameter :: small_product = 0.05_wp
   real(wp), parameter :: power(0:last) = real([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11], wp)
   real(wp), parameter :: reciprocal(2:last) = 1.0_wp/power(2:)
   ! integrals of the powers, times those of force, its slope, area, its slope and energy
   real(wp), parameter :: elastic_force(0:last) = 1.0_wp/(power + 2.5_wp)
   real(wp), parameter :: elastic_slope(0:last) = 1.5_wp/(power + 1.5_wp)
   real(wp), parameter :: elastic_area(0:last) = 1.0_wp/(power + 2.0_wp)
   real(wp), parameter :: elastic_area_slope(0:last) = 1.0_wp/(power + 1.0_wp)
   real(wp), parameter :: elastic_energy(0:last) = 0.4_wp/(power + 3.5_wp)

   !> b2, Eq. 15
   real(wp), parameter :: plastic_area_exponent = 1.0_wp + log(2.0_wp)/log(default_plastic_ratio)
   ! weights of the elasto-plastic sums; those with the force lack what `find_force_powers` gives,
   ! that of the recoverable energy, force times recovery, its square
   real(wp), parameter :: by_log(n) = weight*ratio
   real(wp), parameter :: slope_weight(n) = by_log*exp(middle_exponent*(log_ratio - middle))
   real(wp), parameter :: force_weight(n) = slope_weight*ratio
   real(wp), parameter :: work_weight(n) = force_weight*ratio
   real(wp), parameter :: area_weight(n) = by_log*exp(plastic_area_exponent*log_ratio)
   real(wp), parameter :: recoverable_weight(n) = 0.4_wp*by_log*exp(2.0_wp*middle_exponent &
      *(log_ratio - middle) + (2.0_wp - 0.5_wp*plastic_area_exponent)*log_ratio)
   real(wp), parameter :: area_slope_weight(n) = plastic_area_exponent*by_log &
      *exp((plastic_area_exponent - 1.0_wp)*log_ratio)

contains

   !> Whether the fixed rule is accurate at a separation.
   pure logical function fixed_pieces_serve(properties, h)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      real(wp) :: a

      a = properties%w1/properties%sigma
      fixed_pieces_serve = a <= largest_ratio .and. h >= lowest .and. a*h <= largest_product &
         .and. .not. abs(properties%plastic_ratio - default_plastic_ratio) > 0.0_wp
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
      real(wp) :: a

      a = properties%w1/properties%sigma
      call sum_series(a, h, with_area_slope, elastic)
      call sum_points(properties, a, h, with_area_slope, with_memory, elastoplastic)
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

      call sum_series(largest*properties%w1/properties%sigma, h, .false., piece)
      piece%stiffness = piece%stiffness*sqrt(largest)
      piece%pressure = piece%pressure*largest*sqrt(largest)
      piece%area = piece%area*largest
      piece%energy = piece%energy*largest*largest*sqrt(largest)
   end function fixed_elastic_piece

   !> The elasto-plastic piece alone, with recoverable energy and dissipation, where the fixed rule
   !> serves.
   pure function fixed_elastoplastic_piece(properties, h) result(piece)
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> d/sigma
      real(wp), intent(in) :: h
      !> Integrals, with an exponent of zero
      type(piece_type) :: piece

      call sum_points(properties, properties%w1/properties%sigma, h, .false., .true., piece)
   end function fixed_elastoplastic_piece

   !> Elastic summits, by the density exp(-t (h + t/2)) at t = a w/w1 in powers of w/w1, each
   !> integrated. The coefficients are a^i/i! times Hermite polynomials of -h.
   pure subroutine sum_series(a, h, with_area_slope, piece)
      real(wp), intent(in) :: a, h
      logical, intent(in) :: with_area_slope
      type(piece_type), intent(out) :: piece
      real(wp) :: c(0:last), first, second, scale
      real(wp), dimension(0:1) :: by_force, by_slope, by_area, by_work
      integer :: most, i, j

      first = -a*h
      second = -a*a
      c(0) = 1.0_wp
      c(1) = first
      most = last
      if (abs(first) < small_product) most = last_of_few
      do i = 2, most
         c(i) = (first*c(i - 1) + second*c(i - 2))*reciprocal(i)
      end do
      by_force = 0.0_wp
      by_slope = 0.0_wp
      by_area = 0.0_wp
      by_work = 0.0_wp
      do i = 0, most, 2
         do j = 0, 1
            by_force(j) = by_force(j) + elastic_force(i + j)*c(i + j)
            by_slope(j) = by_slope(j) + elastic_slope(i + j)*c(i + j)
            by_area(j) = by_area(j) + elastic_area(i + j)*c(i + j)
            by_work(j) = by_work(j) + elastic_energy(i + j)*c(i + j)
         end do
      end do
      piece = no_summits
      scale = phi_0*a
      if (h < 0.0_wp) scale = scale*exp(-0.5_wp*h*h)
      piece%pressure = scale*(by_force(0) + by_force(1))
      piece%stiffness = scale*(by_slope(0) + by_slope(1))
      piece%area = scale*(by_area(0) + by_area(1))
      piece%energy = scale*(by_work(0) + by_work(1))
      if (with_area_slope) &
         piece%area_slope = scale*dot_product(elastic_area_slope(:most), c(:most))
   end subroutine sum_series

   !> Elasto-plastic summits, by sums over the points, in two halves side by side.
   pure subroutine sum_points(properties, a, h, with_area_slope, with_memory, piece)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: a, h
      logical, intent(in) :: with_area_slope, with_memory
      type(piece_type), intent(out) :: piece
      real(wp) :: t, exponent(n), density(n), powers(n), force, inverse, scale, force_scale
      real(wp), dimension(2) :: by_force, by_slope, by_work, by_area, by_range
      integer :: i, j

      if (h > 0.0_wp) then
         do i = 1, n
            t = a*ratio(i)
            exponent(i) = -t*(h + 0.5_wp*t)
         end do
      else
         exponent = -0.5_wp*(a*ratio + h)**2
      end if
      call exponentials(n, exponent, density)
      call find_force_powers(properties%b3_less_1, powers)

      by_force = 0.0_wp
      by_slope = 0.0_wp
      by_work = 0.0_wp
      by_area = 0.0_wp
      by_range = 0.0_wp
      do i = 0, n - 2, 2
         do j = 1, 2
            by_range(j) = by_range(j) + by_log(i + j)*density(i + j)
            by_area(j) = by_area(j) + area_weight(i + j)*density(i + j)
            force = powers(i + j)*density(i + j)
            by_slope(j) = by_slope(j) + slope_weight(i + j)*force
            by_force(j) = by_force(j) + force_weight(i + j)*force
            by_work(j) = by_work(j) + work_weight(i + j)*force
         end do
      end do
      piece = no_summits
      scale = phi_0*a
      ! the force in the middle of the range: (2/k)^(1/2), as it is 2/k at its upper end
      force_scale = scale*sqrt(2.0_wp/properties%yield_factor)
      inverse = 1.0_wp/(properties%b3 + 1.0_wp)
      piece%pressure = force_scale*(by_force(1) + by_force(2))
      piece%stiffness = force_scale*properties%b3*(by_slope(1) + by_slope(2))
      piece%area = scale*(by_area(1) + by_area(2))
      piece%energy = force_scale*inverse*(by_work(1) + by_work(2)) &
         + scale*(0.4_wp - inverse)*(by_range(1) + by_range(2))
      if (with_area_slope) piece%area_slope = scale*dot_product(area_slope_weight, density)
      if (with_memory) then
         piece%recoverable = scale*2.0_wp/properties%yield_factor &
            *dot_product(recoverable_weight, powers*powers*density)
         piece%dissipation = piece%energy - piece%recoverable
      end if
   end subroutine sum_points

end module asperity_law_quadrature_pieces_by_fixed_rule
