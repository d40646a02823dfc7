!> Exact statistics of the summits of an isotropic Gaussian surface (Nayak 1971), from the spectral
!> moments m0, m2, m4 of its profiles. Derived in docs/surface_theory.md.
module asperity_faces_nayak
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_plausibility, only: summit_constant
   implicit none
   private
   public :: nayak_summits, moments_of_summits, summit_curvature_density

   !> Statistics of summits; heights are above the mean plane of the surface.
   type, public :: nayak_type
      !> Bandwidth parameter m0 m4/m2^2
      real(wp) :: alpha = 0.0_wp
      !> Summits per area, 1/mm^2
      real(wp) :: density = 0.0_wp
      !> Mean and standard deviation of their mean curvature, 1/mm
      real(wp) :: curvature = 0.0_wp, curvature_sigma = 0.0_wp
      !> Mean height, mm, and variance of heights, mm^2; below zero where alpha < 0.8968
      real(wp) :: height = 0.0_wp, variance = 0.0_wp
   end type nayak_type

contains

   !> Statistics of the summits. No surface has alpha below 1.5, but the formulas go on.
   pure elemental function nayak_summits(m0, m2, m4) result(summits)
      !> Mean square height, mm^2
      real(wp), intent(in) :: m0
      !> Mean square slope of profiles
      real(wp), intent(in) :: m2
      !> Mean square curvature of profiles, 1/mm^2
      real(wp), intent(in) :: m4
      type(nayak_type) :: summits
      real(wp), parameter :: mean_x = 8.0_wp/3.0_wp*sqrt(1.5_wp/pi), &
         mean_x_2 = 2.0_wp*sqrt(3.0_wp) + 1.0_wp/3.0_wp

      summits%alpha = (m0/m2)*(m4/m2)
      summits%density = (m4/m2)/(6.0_wp*pi*sqrt(3.0_wp))
      summits%curvature = 8.0_wp/3.0_wp*sqrt(m4/pi)
      summits%curvature_sigma = sqrt(2.0_wp*m4/3.0_wp*(mean_x_2 - mean_x**2))
      summits%height = 4.0_wp*m2/sqrt(pi*m4)
      summits%variance = m0 - summit_constant*m2*(m2/m4)
   end function nayak_summits

   !> The moments of the surface whose summits have a density, a mean radius and a standard
   !> deviation of heights: what `nayak_summits` turns back.
   pure elemental subroutine moments_of_summits(density, radius, sigma, m0, m2, m4)
      !> Summits per area, 1/mm^2
      real(wp), intent(in) :: density
      !> One over their mean curvature, mm
      real(wp), intent(in) :: radius
      !> Standard deviation of their heights, mm
      real(wp), intent(in) :: sigma
      !> As above
      real(wp), intent(out) :: m0, m2, m4

      m4 = pi*(0.375_wp/radius)**2
      m2 = m4/(6.0_wp*pi*sqrt(3.0_wp)*density)
      m0 = sigma**2 + summit_constant*m2*(m2/m4)
   end subroutine moments_of_summits

   !> Probability density of x = kappa sqrt(3/(2 m4)), kappa the mean curvature at a summit.
   pure elemental real(wp) function summit_curvature_density(x) result(density)
      !> Scaled curvature; no summit has one below zero
      real(wp), intent(in) :: x
      real(wp) :: x2

      density = 0.0_wp
      if (.not. x > 0.0_wp) return
      x2 = x*x
      density = 2.0_wp*sqrt(3.0_wp/(2.0_wp*pi))*exp(-0.5_wp*x2)*(x2 - 1.0_wp + exp(-x2))
   end function summit_curvature_density

end module asperity_faces_nayak
