!> The direct shear tests of two discs of wood, and their finite element model (Figs 13 to 15 and
!> the text beside them).
module asperity_paper_shear_test
   use asperity_base_kinds, only: wp
   implicit none
   private

   !> Diameter and height of a disc, mm
   real(wp), parameter, public :: disc_diameter = 61.8_wp, disc_height = 10.0_wp
   !> Normal stress of the model, the lowest of the tests, MPa
   real(wp), parameter, public :: disc_normal_stress = 0.05_wp
   !> Speed of the lower box, mm/min
   real(wp), parameter, public :: disc_rate = 1.2_wp
   !> Length of an edge of the mesh, mm
   real(wp), parameter, public :: disc_mesh_size = 2.5_wp
end module asperity_paper_shear_test
