!> What stands where in PROPS of UINTER and VUINTER, and nothing else: every reader and writer of it
!> uses these names.
module asperity_abaqus_props
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: complete_contact_properties, contact_properties, &
      rule_abaqus, slip_exact
   use asperity_law_normal_properties, only: new_normal_properties
   implicit none
   private
   public :: properties_from_props, props_from_properties, near_pi

   !> Slots of PROPS, N-mm-MPa
   enum, bind(c)
      !> mu, and gcrit in mm
      enumerator :: prop_friction_coefficient = 1, prop_critical_slip
      !> eta in 1/mm^2, E* in MPa
      enumerator :: prop_eta, prop_modulus
      !> 3.14 or better: kept in the paper's place as a guard against a shifted list, not used
      enumerator :: prop_pi
      !> R in mm, H in MPa, k
      enumerator :: prop_radius, prop_hardness, prop_yield_factor
      !> sigma in mm, which the paper's list lacks
      enumerator :: prop_sigma
      !> d0 in mm, taken literally; 4 sigma when the list ends before
      enumerator :: prop_initial_separation
      !> 0 default, 1 abaqus, 2 dissipative
      enumerator :: prop_friction_rule
      !> 0 default, 1 exact, 2 backward Euler
      enumerator :: prop_slip_integration
      !> 1 lets properties that no face or solid has pass
      enumerator :: prop_accept_unphysical
      !> 0 reversible, 1 elastic: summits remember how flat they were pressed
      enumerator :: prop_unloading
   end enum
   public :: prop_pi, prop_sigma, prop_accept_unphysical
   !> Length of the longest list
   integer, parameter, public :: n_props = prop_unloading
   !> Largest value of each option
   integer, parameter :: option_max(prop_friction_rule:n_props) = [2, 2, 1, 1]

   !> How far PROPS(5) may be from pi: 3.14 passes
   real(wp), parameter :: pi_tolerance = 0.01_wp

contains

   !> Read and check PROPS. `error` is set when the list is too short or too long, PROPS(5) is
   !> not near pi, or a property is refused.
   pure subroutine properties_from_props(props, properties, error)
      !> The property list
      real(wp), intent(in), contiguous :: props(:)
      !> Checked properties; all of them are set
      type(contact_properties), intent(inout) :: properties
      !> Set when the list is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: options(prop_friction_rule:n_props), i

      if (size(props) < prop_sigma .or. size(props) > n_props) then
         call refuse_length(error, size(props))
         return
      end if
      if (.not. all_finite(props)) then
         call refuse_number(error, props)
         return
      end if
      if (.not. near_pi(props(prop_pi))) then
         call fatal_error(error, 'PROPS(5) = '//to_text(props(prop_pi))//' must be pi (3.14 or '// &
            'better): the list seems shifted; check that the line after *SURFACE INTERACTION '// &
            'is blank or a thickness, and the order of the properties')
         return
      end if
      options = 0
      do i = prop_friction_rule, size(props)
         if (.not. is_option(props(i), option_max(i))) then
            call refuse_option(error, i, props(i))
            return
         end if
         options(i) = int(props(i))
      end do
      if (options(prop_friction_rule) == 0) options(prop_friction_rule) = rule_abaqus
      if (options(prop_slip_integration) == 0) options(prop_slip_integration) = slip_exact
      call new_normal_properties(properties%normal, props(prop_eta), props(prop_modulus), &
         props(prop_radius), props(prop_hardness), props(prop_yield_factor), props(prop_sigma), &
         error, options(prop_accept_unphysical) == 1, options(prop_unloading))
      if (allocated(error)) return
      if (size(props) < prop_initial_separation) then
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error)
      else
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error, props(prop_initial_separation), &
            options(prop_friction_rule), options(prop_slip_integration), &
            accept_unphysical=options(prop_accept_unphysical) == 1)
      end if
   end subroutine properties_from_props

   !> The full property list that gives these properties.
   pure function props_from_properties(properties) result(props)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: props(n_props)

      props(prop_friction_coefficient) = properties%friction_coefficient
      props(prop_critical_slip) = properties%critical_slip
      props(prop_eta) = properties%normal%eta
      props(prop_modulus) = properties%normal%modulus
      props(prop_pi) = pi
      props(prop_radius) = properties%normal%radius
      props(prop_hardness) = properties%normal%hardness
      props(prop_yield_factor) = properties%normal%yield_factor
      props(prop_sigma) = properties%normal%sigma
      props(prop_initial_separation) = properties%initial_separation
      props(prop_friction_rule) = properties%friction_rule
      props(prop_slip_integration) = properties%slip_integration
      ! properties that exist have been accepted
      props(prop_accept_unphysical) = 1.0_wp
      props(prop_unloading) = properties%normal%unloading
   end function props_from_properties

   !> Is it pi as PROPS(5) holds it?
   pure logical function near_pi(value)
      !> A property, or a number that may be none
      real(wp), intent(in) :: value

      near_pi = is_finite(value)
      if (near_pi) near_pi = abs(value - pi) < pi_tolerance
   end function near_pi

   !> Is it a whole number from 0 on? Of a finite number.
   pure logical function is_option(value, largest)
      real(wp), intent(in) :: value
      integer, intent(in) :: largest

      is_option = value >= 0.0_wp .and. value <= largest
      if (is_option) is_option = abs(value - int(value)) <= 0.0_wp
   end function is_option

   !> Name the first property that is no number.
   pure subroutine refuse_number(error, props)
      type(error_type), allocatable, intent(out) :: error
      real(wp), intent(in) :: props(:)
      integer :: slot

      slot = findloc(is_finite(props), .false., dim=1)
      call fatal_error(error, 'PROPS('//to_text(slot)//') = '//to_text(props(slot))// &
         ' is not allowed: every property must be a finite number')
   end subroutine refuse_number

   !> Say what an option may be.
   pure subroutine refuse_option(error, slot, value)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: slot
      real(wp), intent(in) :: value
      character(len=80) :: allowed

      select case (slot)
      case (prop_friction_rule)
         allowed = 'the friction rule is 1 for abaqus, 2 for dissipative, 0 for the default'
      case (prop_slip_integration)
         allowed = 'the slip integration is 1 for exact, 2 for backward Euler, 0 for the default'
      case (prop_accept_unphysical)
         allowed = '1 accepts unphysical values, 0 does not'
      case default
         allowed = 'the unloading is 0 for reversible, 1 for elastic'
      end select
      call fatal_error(error, 'PROPS('//to_text(slot)//') = '//to_text(value)// &
         ' is not allowed: '//trim(allowed))
   end subroutine refuse_option

   !> Say what is missing.
   pure subroutine refuse_length(error, length)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: length
      character(len=:), allocatable :: remedy

      remedy = ' (mu, gcrit, eta, E*, pi, R, H, k, sigma, d0, friction rule, slip integration, '// &
         'accept unphysical, unloading)'
      if (length == prop_sigma - 1) remedy = '; the eight of the paper lack sigma, without '// &
         'which the law has no length scale: add sigma, the standard deviation of summit '// &
         'heights in mm, as the ninth (Table 2 prints it in um)'
      call fatal_error(error, 'PROPERTIES = '//to_text(length)//' is not allowed: give '// &
         to_text(prop_sigma)//' to '//to_text(n_props)//remedy)
   end subroutine refuse_length

end module asperity_abaqus_props
