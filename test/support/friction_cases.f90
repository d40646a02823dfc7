!> Kinds of friction beyond one coefficient, and faces that close like a spring, for tests of it.
module friction_cases
   use asperity, only: contact_properties, contact_response, contact_state, error_type, find_pair, &
      friction_settings, new_contact_properties, pair_preset, slip_direction_associated, &
      slip_direction_of_stress, wp
   use asperity_contact_friction, only: slide
   use random_inputs, only: random_stream
   implicit none
   private
   public :: kinds, random_friction, friction_properties, spring_slides

   !> Kinds of friction
   character(len=*), parameter :: kinds(9) = [character(len=18) :: 'decay by slip', 'fast decay', &
      'decay by rate', 'associated ellipse', 'ellipse by stress', 'power', 'points', &
      'shear limit', 'all together']
   !> Pressure by overclosure, MPa/mm
   real(wp), parameter, public :: spring = 40.0_wp

contains

   !> Settings of a kind for a coefficient in motion and a critical slip.
   subroutine random_friction(stream, kind, mu, critical_slip, settings)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: kind
      real(wp), intent(in) :: mu, critical_slip
      type(friction_settings), intent(out) :: settings
      real(wp) :: one_of_two
      integer :: n, i
      logical :: all_kinds

      all_kinds = kind == size(kinds)
      if (kind <= 3 .or. all_kinds) settings%static_friction_coefficient = &
         mu*stream%uniform(1.1_wp, 2.0_wp)
      if (kind == 1 .or. all_kinds) &
         settings%decay_slip = critical_slip*stream%uniform(0.6_wp, 4.0_wp)
      if (kind == 2) settings%decay_slip = critical_slip*stream%uniform(0.02_wp, 0.3_wp)
      if (kind == 3 .or. all_kinds) &
         settings%decay_slip_rate = critical_slip*stream%uniform(0.3_wp, 3.0_wp)
      if (kind == 4 .or. kind == 5 .or. all_kinds) then
         settings%friction_coefficient_across = mu*stream%log_uniform(0.3_wp, 3.0_wp)
         settings%grain_angle = stream%uniform(-180.0_wp, 180.0_wp)
         settings%slip_direction = slip_direction_associated
         one_of_two = stream%uniform(0.0_wp, 1.0_wp)
         if (kind == 5 .or. (all_kinds .and. one_of_two < 0.5_wp)) &
            settings%slip_direction = slip_direction_of_stress
      end if
      if (kind == 6 .or. all_kinds) then
         settings%pressure_exponent = stream%uniform(-0.9_wp, 0.5_wp)
         settings%reference_pressure = 1.0_wp
      end if
      if (kind == 7) then
         n = 1 + int(stream%uniform(0.0_wp, 7.99_wp))
         settings%friction_points = n
         do i = 1, n
            settings%friction_pressures(i) = 2.0_wp*(real(i, wp) - stream%uniform(0.2_wp, 0.8_wp))/n
            settings%friction_factors(i) = stream%uniform(0.3_wp, 1.5_wp)
         end do
      end if
      if (kind == 8 .or. all_kinds) settings%shear_limit = mu*stream%uniform(0.3_wp, 3.0_wp)
   end subroutine random_friction

   !> The pair transverse-tangential with settings.
   function friction_properties(settings, friction_rule, slip_integration, unloading) &
         result(properties)
      type(friction_settings), intent(in) :: settings
      integer, intent(in), optional :: friction_rule, slip_integration, unloading
      type(contact_properties) :: properties
      type(pair_preset) :: pair
      type(error_type), allocatable :: error

      call find_pair('transverse-tangential', pair, error)
      call new_contact_properties(properties, pair, error, friction_rule=friction_rule, &
         slip_integration=slip_integration, unloading=unloading, friction=settings)
      if (allocated(error)) error stop 'the friction of the tests is refused'
   end function friction_properties

   !> One increment of faces that close like a spring at overclosure zero.
   pure function spring_slides(properties, start, overclosure, slip, time_increment, rotation) &
         result(response)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      real(wp), intent(in), optional :: time_increment, rotation(2, 2)
      type(contact_response) :: response
      real(wp) :: elastic_slip(2)

      response%traction(1) = spring*max(overclosure, 0.0_wp)
      if (overclosure > 0.0_wp) response%tangent(1, 1) = spring
      elastic_slip = start%elastic_slip
      if (present(rotation)) elastic_slip = matmul(rotation, elastic_slip)
      call slide(response, properties, start, elastic_slip, overclosure, slip, &
         .not. overclosure > 0.0_wp, 0.0_wp, rotation, time_increment)
   end function spring_slides

end module friction_cases
