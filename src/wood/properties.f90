!> Wood as finite elements and replays know it: nine elastic constants, strengths, hardening.
!> 1 = L along the grain, 2 = R radial, 3 = T tangential.
module asperity_wood_properties
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_paper_wood, only: hardness_tangential, hardness_transverse, poisson_ratios, &
      shear_moduli, wood_strength_across, wood_strength_along, wood_tension_along, young_moduli
   implicit none
   private
   public :: wood_properties

   !> Criteria of yield: none, so that wood is elastic; Mises' with one curve a part, for the
   !> direction in which it is pressed; Hill's; crushing without interaction of L, R and T, tension
   !> apart from compression
   character(len=8), parameter, public :: criteria(*) = [character(len=8) :: 'none', 'mises', &
      'hill', 'crushing']

   !> Values of Table 1 of the paper; what the paper does not give is chosen, with its reason.
   type :: wood_properties
      !> Young's moduli in L, R and T, MPa
      real(wp) :: young_moduli(3) = young_moduli
      !> Poisson's ratios LR, LT, RT: strain in the second over that in the first direction, which
      !> is pulled
      real(wp) :: poisson_ratios(3) = poisson_ratios
      !> Shear moduli LR, LT, RT, MPa
      real(wp) :: shear_moduli(3) = shear_moduli
      !> Strengths in compression in L, R and T, MPa: fc0, fc90, fc90
      real(wp) :: compression_strengths(3) = &
         [wood_strength_along, wood_strength_across, wood_strength_across]
      !> Strengths in tension in L, R and T, MPa: ft0 of Table 1; across the grain the paper gives
      !> none, chosen as in compression
      real(wp) :: tension_strengths(3) = &
         [wood_tension_along, wood_strength_across, wood_strength_across]
      !> Strengths in shear LR, LT, RT, MPa; the paper gives none, chosen as fc90/sqrt(3), which is
      !> what Mises' criterion makes of fc90
      real(wp) :: shear_strengths(3) = wood_strength_across/sqrt(3.0_wp)
      !> Slope of the yield stress over plastic strain, over the modulus; along and across the
      !> grain; chosen: small, wood densifies
      real(wp) :: hardening_along = 0.02_wp, hardening_across = 0.02_wp
      !> Hardness of the sections whose normals are L, R and T, MPa: transverse, tangential, radial;
      !> `none` where it is not known, as the paper's of the radial section
      real(wp) :: hardnesses(3) = [hardness_transverse, hardness_tangential, none]
      !> Yield stress across the grain, MPa (second row), over plastic strain (first row), in place
      !> of the slope: rising strains from 0, where the stress is fc90; not allocated unless given
      real(wp), allocatable :: hardening_curve(:, :)
      !> The same along the grain, from fc0: for `mises` alone, in a part that is pressed along it
      real(wp), allocatable :: hardening_curve_along(:, :)
      !> One of `criteria`
      character(len=8) :: criterion = 'crushing'
   end type wood_properties

end module asperity_wood_properties
