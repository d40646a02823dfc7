!> What yielded summits that part again carry together. A summit's contact radius is a, and it is
!> still pressed in elastically by e - u, e its recovery and u the retraction: its stiffness is
!> 3/2 a, its force a (e - u), its stored energy 2/5 a (e - u)^2 and its area a^2, in units of N1,
!> w1 and sqrt(R w1). The point where it loses contact is a branch point of a; each stage has a
!> variable without it.
module asperity_law_unloading_sums
   use asperity_base_kinds, only: wp
   use asperity_law_quadrature_pieces_by_quadrature, only: piece_type
   use asperity_law_unloading_gauss_points, only: n => n_points
   implicit none
   private
   public :: add_summits

   !> Exponents of the density are kept within what `exponentials` takes, as rounding of
   !> deformations carries them away where no summit touches
   real(wp), parameter, public :: lowest_exponent = -100.0_wp
   !> Below this d/sigma the density has a peak inside the range
   real(wp), parameter, public :: lowest = -1.0_wp

contains

   !> Add what summits of given contact radii and elastic deformations carry, in four parts side by
   !> side.
   pure subroutine add_summits(piece, scale, weight, density, radius, left)
      !> What is added to
      type(piece_type), intent(inout) :: piece
      !> Factor of all weights
      real(wp), intent(in) :: scale
      !> Weights and densities of the points of a panel, contact radii a, deformations e - u
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

end module asperity_law_unloading_sums
