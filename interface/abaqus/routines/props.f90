!> PROPS of UINTER and VUINTER, read and written.
module asperity_abaqus_props
   use asperity_abaqus_prop_slots, only: most_props, n_props, option_max, &
      option_slots, option_texts, prop_accept_unphysical, prop_critical_slip, prop_decay_slip, &
      prop_decay_slip_rate, prop_eta, prop_friction_coefficient, &
      prop_friction_coefficient_across, prop_friction_points, prop_friction_rule, &
      prop_grain_angle, prop_hardness, prop_height_distribution, prop_initial_separation, &
      prop_kurtosis, prop_modulus, prop_names, prop_pi, prop_plastic_ratio, &
      prop_pressure_exponent, prop_radius, prop_reference_pressure, prop_shear_limit, &
      prop_shear_modulus, prop_sigma, prop_skewness, prop_slip_direction, prop_slip_integration, &
      prop_static_friction_coefficient, prop_stick, prop_stick_elements, prop_unloading, &
      prop_yield_factor
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: friction_settings, stick_summits
   use asperity_contact_properties, only: complete_contact_properties, contact_properties, &
      rule_abaqus, slip_exact
   use asperity_law_normal_properties, only: default_plastic_ratio, heights_gaussian, &
      new_normal_properties, normal_properties
   implicit none
   private
   public :: properties_from_props, props_from_properties, near_pi

   !> How far PROPS(5) may be from pi: 3.14 passes
   real(wp), parameter :: pi_tolerance = 0.01_wp
   !> Defaults of the normal law
   type(normal_properties), parameter :: unset = normal_properties()

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
      integer :: rule, integration
      logical :: accepted

      call check_list(props, error)
      if (allocated(error)) return
      rule = option_of(props, prop_friction_rule)
      if (rule == 0) rule = rule_abaqus
      integration = option_of(props, prop_slip_integration)
      if (integration == 0) integration = slip_exact
      accepted = option_of(props, prop_accept_unphysical) == 1
      if (size(props) <= prop_unloading) then
         call new_normal_properties(properties%normal, props(prop_eta), props(prop_modulus), &
            props(prop_radius), props(prop_hardness), props(prop_yield_factor), &
            props(prop_sigma), error, accepted, option_of(props, prop_unloading))
      else
         call read_normal(props, accepted, properties%normal, error)
      end if
      if (allocated(error)) return
      if (size(props) < prop_initial_separation) then
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error)
      else if (size(props) <= prop_unloading) then
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error, props(prop_initial_separation), rule, integration, &
            accept_unphysical=accepted)
      else
         call complete_contact_properties(properties, props(prop_friction_coefficient), &
            props(prop_critical_slip), error, props(prop_initial_separation), rule, integration, &
            accept_unphysical=accepted, friction=friction_of(props))
      end if
   end subroutine properties_from_props

   !> The normal law of a list that goes beyond `prop_unloading`.
   pure subroutine read_normal(props, accepted, normal, error)
      real(wp), intent(in), contiguous :: props(:)
      logical, intent(in) :: accepted
      type(normal_properties), intent(inout) :: normal
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: ratio, kurtosis

      ratio = value_of(props, prop_plastic_ratio)
      if (.not. abs(ratio) > 0.0_wp) ratio = default_plastic_ratio
      kurtosis = value_of(props, prop_kurtosis)
      if (.not. abs(kurtosis) > 0.0_wp) kurtosis = unset%kurtosis
      call new_normal_properties(normal, props(prop_eta), props(prop_modulus), &
         props(prop_radius), props(prop_hardness), props(prop_yield_factor), props(prop_sigma), &
         error, accepted, option_of(props, prop_unloading), ratio, &
         option_of(props, prop_height_distribution), value_of(props, prop_skewness), kurtosis)
   end subroutine read_normal

   !> Friction beyond one coefficient and one critical slip, as a list has it.
   pure function friction_of(props) result(friction)
      real(wp), intent(in), contiguous :: props(:)
      type(friction_settings) :: friction
      integer :: n

      friction%static_friction_coefficient = value_of(props, prop_static_friction_coefficient)
      friction%decay_slip = value_of(props, prop_decay_slip)
      friction%decay_slip_rate = value_of(props, prop_decay_slip_rate)
      friction%friction_coefficient_across = value_of(props, prop_friction_coefficient_across)
      friction%grain_angle = value_of(props, prop_grain_angle)
      friction%slip_direction = option_of(props, prop_slip_direction)
      friction%pressure_exponent = value_of(props, prop_pressure_exponent)
      friction%reference_pressure = value_of(props, prop_reference_pressure)
      friction%shear_limit = value_of(props, prop_shear_limit)
      friction%stick = option_of(props, prop_stick)
      friction%stick_elements = option_of(props, prop_stick_elements)
      friction%shear_modulus = value_of(props, prop_shear_modulus)
      n = option_of(props, prop_friction_points)
      friction%friction_points = n
      friction%friction_pressures(:n) = props(n_props + 1:size(props):2)
      friction%friction_factors(:n) = props(n_props + 2:size(props):2)
   end function friction_of

   !> The full property list that gives these properties. From the slot after `prop_unloading` on,
   !> defaults and what has no effect are zeros.
   pure function props_from_properties(properties) result(props)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp) :: props(n_props + 2*properties%friction%friction_points)

      props = 0.0_wp
      props(prop_friction_coefficient) = properties%friction_coefficient
      props(prop_critical_slip) = properties%critical_slip
      props(prop_pi) = pi
      props(prop_initial_separation) = properties%initial_separation
      props(prop_friction_rule) = properties%friction_rule
      props(prop_slip_integration) = properties%slip_integration
      ! properties that exist have been accepted
      props(prop_accept_unphysical) = 1.0_wp
      associate (normal => properties%normal)
         props(prop_eta) = normal%eta
         props(prop_modulus) = normal%modulus
         props(prop_radius) = normal%radius
         props(prop_hardness) = normal%hardness
         props(prop_yield_factor) = normal%yield_factor
         props(prop_sigma) = normal%sigma
         props(prop_unloading) = normal%unloading
         if (abs(normal%plastic_ratio - default_plastic_ratio) > 0.0_wp) &
            props(prop_plastic_ratio) = normal%plastic_ratio
         if (normal%height_distribution /= heights_gaussian) then
            props(prop_height_distribution) = normal%height_distribution
            props(prop_skewness) = normal%skewness
            props(prop_kurtosis) = normal%kurtosis
         end if
      end associate
      associate (friction => properties%friction)
         props(prop_static_friction_coefficient) = friction%static_friction_coefficient
         props(prop_decay_slip) = friction%decay_slip
         props(prop_decay_slip_rate) = friction%decay_slip_rate
         if (friction%friction_coefficient_across > 0.0_wp) then
            props(prop_friction_coefficient_across) = friction%friction_coefficient_across
            props(prop_grain_angle) = friction%grain_angle
            props(prop_slip_direction) = friction%slip_direction
         end if
         if (abs(friction%pressure_exponent) > 0.0_wp) then
            props(prop_pressure_exponent) = friction%pressure_exponent
            props(prop_reference_pressure) = friction%reference_pressure
         end if
         props(prop_shear_limit) = friction%shear_limit
         if (friction%stick == stick_summits) then
            props(prop_stick) = friction%stick
            props(prop_stick_elements) = friction%stick_elements
            props(prop_shear_modulus) = friction%shear_modulus
         end if
         props(prop_friction_points) = friction%friction_points
         props(n_props + 1::2) = friction%friction_pressures(:friction%friction_points)
         props(n_props + 2::2) = friction%friction_factors(:friction%friction_points)
      end associate
   end function props_from_properties

   !> A property; zero where the list ends before.
   pure real(wp) function value_of(props, slot) result(value)
      real(wp), intent(in), contiguous :: props(:)
      integer, intent(in) :: slot

      value = 0.0_wp
      if (slot <= size(props)) value = props(slot)
   end function value_of

   !> A whole number, after it was checked; zero where the list ends before.
   pure integer function option_of(props, slot) result(option)
      real(wp), intent(in), contiguous :: props(:)
      integer, intent(in) :: slot

      option = 0
      if (slot <= size(props)) option = int(props(slot))
   end function option_of

   !> Is it pi as PROPS(5) holds it?
   pure logical function near_pi(value)
      !> A property, or a number that may be none
      real(wp), intent(in) :: value

      near_pi = is_finite(value)
      if (near_pi) near_pi = abs(value - pi) < pi_tolerance
   end function near_pi

   !> Set `error` when the list cannot be read: its length, a number, pi or an option is wrong.
   pure subroutine check_list(props, error)
      real(wp), intent(in), contiguous :: props(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i, pairs

      if (size(props) < prop_sigma .or. size(props) > most_props) then
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
      do i = 1, size(option_slots)
         if (option_slots(i) > size(props)) exit
         if (is_option(props(option_slots(i)), option_max(i))) cycle
         call fatal_error(error, 'PROPS('//to_text(option_slots(i))//') = '// &
            to_text(props(option_slots(i)))//' is not allowed: '//trim(option_texts(i)))
         return
      end do
      if (size(props) < n_props) return
      pairs = option_of(props, prop_friction_points)
      if (size(props) /= n_props + 2*pairs) call fatal_error(error, 'PROPERTIES = '// &
         to_text(size(props))//' does not fit PROPS('//to_text(n_props)//') = '//to_text(pairs)// &
         ' friction points: give '//to_text(n_props + 2*pairs)//', a pressure and a factor for '// &
         'each of them at the end')
   end subroutine check_list

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

   !> Say what is missing.
   pure subroutine refuse_length(error, length)
      type(error_type), allocatable, intent(out) :: error
      integer, intent(in) :: length
      character(len=500) :: remedy
      integer :: i

      if (length == prop_sigma - 1) then
         remedy = '; the eight of the paper lack sigma, without which the law has no length '// &
            'scale: add sigma, the standard deviation of summit heights in mm, as the ninth '// &
            '(Table 2 prints it in um)'
      else
         remedy = ' ('//prop_names(1)
         do i = 2, prop_unloading
            remedy = trim(remedy)//', '//prop_names(i)
         end do
         remedy = trim(remedy)//', and what else docs/abaqus.md lists)'
      end if
      call fatal_error(error, 'PROPERTIES = '//to_text(length)//' is not allowed: give '// &
         to_text(prop_sigma)//' to '//to_text(most_props)//trim(remedy))
   end subroutine refuse_length

end module asperity_abaqus_props
