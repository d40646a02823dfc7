!> Old wood: what each of its properties is over that of new wood. One factor for all would hide
!> what tests of old timber find: some properties fall with age, others do not.
module asperity_wood_ageing
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_within
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_values, only: compression_strength, n_values, section_hardness, &
      set_wood_values, shear_modulus, shear_strength, tension_strength, wood_values, &
      young_modulus
   implicit none
   private
   public :: ageing_factors, ageing_values, aged_wood, check_aged_wood, check_ageing, &
      set_ageing_values

   !> Least and largest factor: beyond them is a percentage, or a slip
   real(wp), parameter :: smallest_factor = 0.01_wp, largest_factor = 10.0_wp
   !> How many factors there are
   integer, parameter, public :: n_factors = 10

   !> Old over new; one leaves a property as it is.
   type :: ageing_factors
      !> Young's modulus along the grain; those across it, R and T; the three shear moduli
      real(wp) :: stiffness_along = 1.0_wp, stiffness_across = 1.0_wp, stiffness_shear = 1.0_wp
      !> Hardness of all sections
      real(wp) :: hardness = 1.0_wp
      !> Strengths in compression and in tension, along the grain and across it, R and T
      real(wp) :: strength_compression_along = 1.0_wp, strength_compression_across = 1.0_wp, &
         strength_tension_along = 1.0_wp, strength_tension_across = 1.0_wp
      !> The three strengths in shear
      real(wp) :: strength_shear = 1.0_wp
      !> Coefficients of friction
      real(wp) :: friction = 1.0_wp
   end type ageing_factors

   !> Names of the factors as keys and messages have them
   character(len=34), parameter, public :: ageing_names(n_factors) = [character(len=34) :: &
      'ageing_stiffness_along', 'ageing_stiffness_across', 'ageing_stiffness_shear', &
      'ageing_hardness', 'ageing_strength_compression_along', &
      'ageing_strength_compression_across', 'ageing_strength_tension_along', &
      'ageing_strength_tension_across', 'ageing_strength_shear', 'ageing_friction']
   !> First and last of the wood's values that each acts on, 1 and 0 for none
   integer, parameter, public :: first_aged(n_factors) = [young_modulus, young_modulus + 1, &
      shear_modulus, section_hardness, compression_strength, compression_strength + 1, &
      tension_strength, tension_strength + 1, shear_strength, 1], &
      last_aged(n_factors) = [young_modulus, young_modulus + 2, shear_modulus + 2, &
      section_hardness + 2, compression_strength, compression_strength + 2, &
      tension_strength, tension_strength + 2, shear_strength + 2, 0]

contains

   !> The factors in the order of their names.
   pure function ageing_values(ageing) result(values)
      !> The factors
      type(ageing_factors), intent(in) :: ageing
      real(wp) :: values(n_factors)

      associate (a => ageing)
         values = [a%stiffness_along, a%stiffness_across, a%stiffness_shear, a%hardness, &
            a%strength_compression_along, a%strength_compression_across, &
            a%strength_tension_along, a%strength_tension_across, a%strength_shear, a%friction]
      end associate
   end function ageing_values

   !> Set the factors in the order of their names.
   pure subroutine set_ageing_values(ageing, values)
      !> The factors
      type(ageing_factors), intent(out) :: ageing
      !> Their values
      real(wp), intent(in) :: values(n_factors)

      ageing = ageing_factors(values(1), values(2), values(3), values(4), values(5), values(6), &
         values(7), values(8), values(9), values(10))
   end subroutine set_ageing_values

   !> `error` is set when a factor is not between 0.01 and 10.
   pure subroutine check_ageing(ageing, error)
      !> The factors
      type(ageing_factors), intent(in) :: ageing
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: values(n_factors)
      integer :: i

      values = ageing_values(ageing)
      do i = 1, n_factors
         if (all_within(values(i:i), smallest_factor, largest_factor)) cycle
         call fatal_error(error, trim(ageing_names(i))//' = '//to_text(values(i))// &
            ' is not allowed: it must be a factor between '//to_text(smallest_factor)//' and '// &
            to_text(largest_factor)//', of old wood over new; write 0.8 for 80 per cent', &
            subject=trim(ageing_names(i)))
         return
      end do
   end subroutine check_ageing

   !> `error` is set when age makes of a wood that can be one that cannot: factors of moduli that
   !> are far apart, or strengths that the criterion does not bear.
   pure subroutine check_aged_wood(wood, ageing, error)
      !> The wood when it is new
      type(wood_properties), intent(in) :: wood
      !> The factors
      type(ageing_factors), intent(in) :: ageing
      !> Set when the old wood cannot be
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: when_new

      call check_wood_properties(wood, when_new)
      if (allocated(when_new)) return
      call check_wood_properties(aged_wood(wood, ageing), error)
      if (.not. allocated(error)) return
      error%message = error%message//'; so it is in old wood: take ageing factors of moduli '// &
         'and of strengths that are closer to each other'
      error%subject = error%subject//' ageing_stiffness_along ageing_stiffness_across '// &
         'ageing_strength_compression_along ageing_strength_compression_across'
   end subroutine check_aged_wood

   !> A wood when it is old. Poisson's ratios stay, and so do slopes of hardening, which are
   !> measured in moduli; curves of hardening go with the strength that they begin at.
   pure function aged_wood(wood, ageing) result(old)
      !> The wood when it is new
      type(wood_properties), intent(in) :: wood
      !> The factors
      type(ageing_factors), intent(in) :: ageing
      type(wood_properties) :: old
      real(wp) :: values(n_values), factors(n_factors)
      integer :: i

      values = wood_values(wood)
      factors = ageing_values(ageing)
      do i = 1, n_factors
         associate (aged => values(first_aged(i):last_aged(i)))
            ! a hardness that is not known stays so
            where (.not. is_none(aged)) aged = factors(i)*aged
         end associate
      end do
      old = wood
      call set_wood_values(old, values)
      if (allocated(old%hardening_curve)) old%hardening_curve(2, :) = &
         ageing%strength_compression_across*wood%hardening_curve(2, :)
      if (allocated(old%hardening_curve_along)) old%hardening_curve_along(2, :) = &
         ageing%strength_compression_along*wood%hardening_curve_along(2, :)
   end function aged_wood

end module asperity_wood_ageing
