!> The sections of wood: planes at right angles to L (transverse), R (tangential) and T (radial),
!> and what the wood is to a body that presses on them.
module asperity_wood_sections
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: section_constants, section_elasticity

   !> A section by the direction of its normal
   integer, parameter, public :: section_transverse = 1, section_tangential = 2, section_radial = 3
   !> Their names, in this order
   character(len=10), parameter, public :: section_names(3) = [character(len=10) :: &
      'transverse', 'tangential', 'radial']

contains

   !> Young's modulus along the normal of a section, Poisson's ratio and hardness for Eqs 4 and 26.
   !> `error` is set when the section is unknown, the wood cannot be, or it has no hardness there.
   pure subroutine section_constants(wood, section, young_modulus, poisson_ratio, hardness, error)
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> `section_transverse`, `section_tangential` or `section_radial`
      integer, intent(in) :: section
      !> Young's modulus and hardness, MPa, and Poisson's ratio
      real(wp), intent(out) :: young_modulus, poisson_ratio, hardness
      !> Set when there are none
      type(error_type), allocatable, intent(out) :: error

      young_modulus = 0.0_wp
      poisson_ratio = 0.0_wp
      hardness = 0.0_wp
      if (section < 1 .or. section > size(section_names)) then
         call fatal_error(error, 'section = '//to_text(section)// &
            ' is unknown: 1 is transverse, 2 is tangential, 3 is radial', subject='section')
         return
      end if
      call check_wood_properties(wood, error)
      if (allocated(error)) return
      call section_elasticity(wood, section, young_modulus, poisson_ratio)
      hardness = wood%hardnesses(section)
      if (is_none(hardness)) call fatal_error(error, 'hardness_'//trim(section_names(section))// &
         ' is not given: it is known of no '//trim(section_names(section))//' section of larch', &
         subject='hardness_'//trim(section_names(section)))
   end subroutine section_constants

   !> Young's modulus along the normal of a section, and Poisson's ratio of strain in the section
   !> across the grain, of T on the transverse one, as the paper takes nu_LT and nu_RT: so
   !> nu_TR = nu_RT E_T/E_R on the radial one.
   pure subroutine section_elasticity(wood, section, young_modulus, poisson_ratio)
      !> The wood, which is not checked
      type(wood_properties), intent(in) :: wood
      !> A section that there is
      integer, intent(in) :: section
      !> Young's modulus, MPa, and Poisson's ratio
      real(wp), intent(out) :: young_modulus, poisson_ratio

      associate (e => wood%young_moduli, nu => wood%poisson_ratios)
         young_modulus = e(section)
         select case (section)
         case (section_transverse)
            poisson_ratio = nu(2)
         case (section_tangential)
            poisson_ratio = nu(3)
         case default
            poisson_ratio = nu(3)*(e(3)/e(2))
         end select
      end associate
   end subroutine section_elasticity

end module asperity_wood_sections
