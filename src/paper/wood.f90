!> The wood of the tests, larch (Larix gmelinii): Table 1. 1 = L along the grain, 2 = R radial,
!> 3 = T tangential.
module asperity_paper_wood
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> Young's moduli in L, R and T, MPa; the table has one for R and T
   real(wp), parameter, public :: young_moduli(3) = [3727.12_wp, 351.01_wp, 351.01_wp]
   !> Poisson's ratios LR, LT, RT: strain in the second over that in the first direction, which is
   !> pulled
   real(wp), parameter, public :: poisson_ratios(3) = [0.62_wp, 0.42_wp, 0.35_wp]
   !> Shear moduli LR, LT, RT, MPa
   real(wp), parameter, public :: shear_moduli(3) = [224.61_wp, 280.32_wp, 67.16_wp]
   !> Strength in compression along the grain, fc0, and across it, fc90, MPa
   real(wp), parameter, public :: wood_strength_along = 50.1_wp, wood_strength_across = 4.7_wp
   !> Strength in tension along the grain, ft0, MPa
   real(wp), parameter, public :: wood_tension_along = 75.3_wp
   !> Hardness of the transverse section, whose normal is L, and of the tangential one, whose normal
   !> is R, MPa (Table 4); the paper has none of the radial one
   real(wp), parameter, public :: hardness_transverse = 24.53_wp, hardness_tangential = 12.14_wp
end module asperity_paper_wood
