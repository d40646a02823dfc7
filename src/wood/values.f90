!> The numbers of a wood in a row, by the names that keys and messages have for them.
module asperity_wood_values
   use asperity_base_kinds, only: wp
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: wood_values, set_wood_values

   !> How many there are
   integer, parameter, public :: n_values = 23
   !> Place of the first, in L or LR, of three; the others follow
   integer, parameter, public :: young_modulus = 1, poisson_ratio = 4, shear_modulus = 7, &
      compression_strength = 10, tension_strength = 13, shear_strength = 16
   !> ... of the transverse section, whose normal is L; tangential and radial follow
   integer, parameter, public :: section_hardness = 21
   !> Place of one
   integer, parameter, public :: hardening_along = 19, hardening_across = 20

   !> Their names
   character(len=22), parameter, public :: value_names(n_values) = [character(len=22) :: &
      'young_modulus_l', 'young_modulus_r', 'young_modulus_t', &
      'poisson_ratio_lr', 'poisson_ratio_lt', 'poisson_ratio_rt', &
      'shear_modulus_lr', 'shear_modulus_lt', 'shear_modulus_rt', &
      'compression_strength_l', 'compression_strength_r', 'compression_strength_t', &
      'tension_strength_l', 'tension_strength_r', 'tension_strength_t', &
      'shear_strength_lr', 'shear_strength_lt', 'shear_strength_rt', &
      'hardening_along', 'hardening_across', &
      'hardness_transverse', 'hardness_tangential', 'hardness_radial']
   !> Their units
   character(len=3), parameter, public :: value_units(n_values) = [character(len=3) :: &
      'MPa', 'MPa', 'MPa', '', '', '', 'MPa', 'MPa', 'MPa', 'MPa', 'MPa', 'MPa', &
      'MPa', 'MPa', 'MPa', 'MPa', 'MPa', 'MPa', '', '', 'MPa', 'MPa', 'MPa']

contains

   !> The numbers of a wood, in the units above.
   pure function wood_values(wood) result(values)
      !> The wood
      type(wood_properties), intent(in) :: wood
      real(wp) :: values(n_values)

      values = [wood%young_moduli, wood%poisson_ratios, wood%shear_moduli, &
         wood%compression_strengths, wood%tension_strengths, wood%shear_strengths, &
         wood%hardening_along, wood%hardening_across, wood%hardnesses]
   end function wood_values

   !> Give a wood its numbers.
   pure subroutine set_wood_values(wood, values)
      !> The wood
      type(wood_properties), intent(inout) :: wood
      !> The numbers, in the units above
      real(wp), intent(in) :: values(n_values)

      wood%young_moduli = values(young_modulus:young_modulus + 2)
      wood%poisson_ratios = values(poisson_ratio:poisson_ratio + 2)
      wood%shear_moduli = values(shear_modulus:shear_modulus + 2)
      wood%compression_strengths = values(compression_strength:compression_strength + 2)
      wood%tension_strengths = values(tension_strength:tension_strength + 2)
      wood%shear_strengths = values(shear_strength:shear_strength + 2)
      wood%hardening_along = values(hardening_along)
      wood%hardening_across = values(hardening_across)
      wood%hardnesses = values(section_hardness:section_hardness + 2)
   end subroutine set_wood_values

end module asperity_wood_values
