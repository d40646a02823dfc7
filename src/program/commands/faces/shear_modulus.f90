!> The equivalent shear modulus of pairs of the paper, which it does not give: by the elastic
!> constants of Table 1 for the sections of the pair.
module asperity_program_commands_faces_shear_modulus
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_contact_stick_elements, only: equivalent_shear_modulus
   use asperity_paper_wood, only: poisson_ratios, shear_moduli
   implicit none
   private
   public :: shear_modulus_of_pair

contains

   !> G* of a pair, MPa; none where there is no such pair. Constants are those of Eq. 4: G_LR and
   !> nu_LT of the transverse section, G_RT and nu_RT of the tangential one.
   pure real(wp) function shear_modulus_of_pair(pair) result(modulus)
      !> Name of the pair
      character(len=*), intent(in) :: pair

      associate (g => shear_moduli, nu => poisson_ratios)
         select case (pair)
         case ('transverse-tangential')
            modulus = equivalent_shear_modulus(g(1), nu(2), g(3), nu(3))
         case ('tangential-tangential')
            modulus = equivalent_shear_modulus(g(3), nu(3), g(3), nu(3))
         case default
            modulus = none
         end select
      end associate
   end function shear_modulus_of_pair

end module asperity_program_commands_faces_shear_modulus
