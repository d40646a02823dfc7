!> Contact points whose summits stick each for itself, for the tests.
module stick_cases
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: find_friction_elements, friction_elements
   use asperity_contact_friction_settings, only: fewest_stick_elements, friction_settings, &
      most_stick_elements, stick_summits
   use asperity_contact_point, only: update_contact_point
   use asperity_contact_properties, only: contact_properties, new_contact_properties, rule_abaqus, &
      rule_dissipative, slip_backward_euler, slip_exact
   use asperity_contact_state, only: contact_response, contact_state, no_rotation
   use asperity_law_normal_properties, only: normal_properties
   use random_inputs, only: random_properties, random_stream
   implicit none
   private
   public :: sticking, random_sticking, full_slip, move

   !> G* of the pair transverse-tangential by Table 1, MPa, and the coefficient of all cases
   real(wp), parameter, public :: shear_modulus = 31.6_wp, mu = 0.5_wp

contains

   !> Properties with summits that stick.
   function sticking(normal, rule, integration, elements, settings) result(p)
      type(normal_properties), intent(in) :: normal
      integer, intent(in) :: rule, integration, elements
      type(friction_settings), intent(in), optional :: settings
      type(contact_properties) :: p
      type(friction_settings) :: friction
      type(error_type), allocatable :: error

      if (present(settings)) friction = settings
      friction%stick = stick_summits
      friction%stick_elements = elements
      friction%shear_modulus = shear_modulus
      call new_contact_properties(p, normal, mu, 0.31_wp, error, friction_rule=rule, &
         slip_integration=integration, accept_unphysical=.true., friction=friction)
      if (allocated(error)) error stop 'summits of the tests are refused'
   end function sticking

   !> The same, random.
   subroutine random_sticking(stream, i, p)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: i
      type(contact_properties), intent(out) :: p
      type(normal_properties) :: normal

      call random_properties(stream, normal, 1.0e-4_wp, 1.0_wp, 0.1_wp)
      p = sticking(normal, merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0), &
         merge(slip_exact, slip_backward_euler, mod(i/2, 2) == 0), &
         fewest_stick_elements + mod(i/4, most_stick_elements - fewest_stick_elements + 1))
   end subroutine random_sticking

   !> Critical slip of the summit that slides last, mm.
   pure real(wp) function full_slip(p, overclosure)
      type(contact_properties), intent(in) :: p
      real(wp), intent(in) :: overclosure
      type(friction_elements) :: elements

      call find_friction_elements(p, overclosure, 1.0_wp, 0.0_wp, elements)
      full_slip = elements%radius(elements%n)
   end function full_slip

   !> Slide once along the first direction at a constant overclosure.
   subroutine move(p, state, overclosure, slip, r)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(in) :: state
      real(wp), intent(in) :: overclosure, slip
      type(contact_response), intent(inout) :: r

      call update_contact_point(p, state, overclosure, [slip, 0.0_wp], no_rotation, r)
   end subroutine move

end module stick_cases
