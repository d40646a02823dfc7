!> Shear stress along the slip of a recorded shear test: the friction of the contact point at the
!> recorded normal stress, in series with what else gives way. Whatever the path: loading, cycles.
module asperity_fit_shear_model
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction, only: slide
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_friction_strength, only: largest_shear_stress
   use asperity_contact_properties, only: contact_properties, new_contact_properties
   use asperity_contact_state, only: contact_response, contact_state, no_rotation
   use asperity_law_normal_properties, only: normal_properties
   implicit none
   private
   public :: check_shear_tests, shear_test, shear_stress_along

   !> One recorded test.
   type :: shear_test
      !> Displacement, mm; from any zero, as the faces are taken to be without shear stress at first
      real(wp), allocatable :: displacement(:)
      !> Shear stress and normal stress of the faces, MPa
      real(wp), allocatable :: shear_stress(:), normal_stress(:)
      !> Area of the faces, mm^2; of use with a shear compliance
      real(wp), allocatable :: area(:)
   end type shear_test

   !> Numbers of the model, in the order of `shear_names`
   enum, bind(c)
      enumerator :: shear_friction_coefficient = 1
      enumerator :: shear_critical_slip
      enumerator :: shear_static_friction_coefficient
      enumerator :: shear_decay_slip
      enumerator :: shear_pressure_exponent
      enumerator :: shear_reference_pressure
      enumerator :: shear_shear_limit
      enumerator :: shear_shear_compliance
   end enum
   public :: shear_friction_coefficient, shear_critical_slip, shear_static_friction_coefficient, &
      shear_decay_slip, shear_pressure_exponent, shear_reference_pressure, shear_shear_limit, &
      shear_shear_compliance

   !> Their names and units; all but the first two are zero where they do nothing
   character(len=32), parameter, public :: shear_names(8) = [character(len=32) :: &
      'friction_coefficient', 'critical_slip', 'static_friction_coefficient', 'decay_slip', &
      'pressure_exponent', 'reference_pressure', 'shear_limit', 'shear_compliance']
   character(len=16), parameter, public :: shear_units(8) = [character(len=16) :: &
      '', 'mm', '', 'mm', '', 'MPa', 'MPa', 'mm/N']

   integer, parameter :: most_iterations = 100
   !> Displacements balance to this part of the critical slip
   real(wp), parameter :: balance_tolerance = 1.0e-12_wp

contains

   !> Friction of the numbers of the model. A coefficient at rest below that in motion counts as the
   !> latter, so that a search may come by there. `error` is set when a number is refused.
   pure subroutine shear_friction(values, properties, error)
      !> Numbers of the model
      real(wp), intent(in) :: values(:)
      !> The friction; no normal law, which a given normal stress does not ask for
      type(contact_properties), intent(out) :: properties
      !> Set when a number is refused
      type(error_type), allocatable, intent(out) :: error
      type(friction_settings) :: friction

      friction%static_friction_coefficient = values(shear_static_friction_coefficient)
      if (friction%static_friction_coefficient > 0.0_wp) friction%static_friction_coefficient = &
         max(friction%static_friction_coefficient, values(shear_friction_coefficient))
      friction%decay_slip = values(shear_decay_slip)
      friction%pressure_exponent = values(shear_pressure_exponent)
      friction%reference_pressure = values(shear_reference_pressure)
      friction%shear_limit = values(shear_shear_limit)
      call new_contact_properties(properties, normal_properties(), &
         values(shear_friction_coefficient), values(shear_critical_slip), error, &
         accept_unphysical=.true., friction=friction)
      if (.not. allocated(error) .and. .not. values(shear_shear_compliance) >= 0.0_wp) &
         call fatal_error(error, 'shear_compliance = '//to_text(values(shear_shear_compliance))// &
         ' mm/N is not allowed: it must not be below zero', subject='shear_compliance')
   end subroutine shear_friction

   !> Shear stress of the model along a test, MPa. `error` is set when a number is refused.
   pure subroutine shear_stress_along(values, test, shear_stress, error)
      !> Numbers of the model
      real(wp), intent(in) :: values(:)
      !> The test
      type(shear_test), intent(in) :: test
      !> One for each of its samples
      real(wp), intent(out) :: shear_stress(:)
      !> Set when a number is refused
      type(error_type), allocatable, intent(out) :: error
      type(contact_properties) :: properties
      type(contact_state) :: state
      type(contact_response) :: response
      real(wp) :: slip, compliance
      integer :: i

      shear_stress = 0.0_wp
      call shear_friction(values, properties, error)
      if (allocated(error)) return
      slip = test%displacement(1)
      compliance = 0.0_wp
      do i = 1, size(shear_stress)
         if (values(shear_shear_compliance) > 0.0_wp) &
            compliance = values(shear_shear_compliance)*test%area(i)
         call advance(properties, compliance, test%normal_stress(i), test%displacement(i), state, &
            slip, response)
         state = response%state
         shear_stress(i) = response%traction(2)
      end do
   end subroutine shear_stress_along

   !> One increment: the slip at which the faces and what is in series with them share the
   !> displacement. It stays in a bracket, as the shear stress never exceeds the strength.
   pure subroutine advance(properties, compliance, normal_stress, displacement, state, slip, &
         response)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: compliance, normal_stress, displacement
      type(contact_state), intent(in) :: state
      real(wp), intent(inout) :: slip
      type(contact_response), intent(inout) :: response
      real(wp) :: start, low, high, left, half, slope, step
      integer :: i

      start = slip
      half = 1.01_wp*compliance*largest_shear_stress(properties, normal_stress, moves=.false.)
      low = displacement - half
      high = displacement + half
      slip = min(max(displacement - compliance*response%traction(2), low), high)
      do i = 1, most_iterations
         response%traction(1) = normal_stress
         response%tangent(1, 1) = 0.0_wp
         call slide(response, properties, state, state%elastic_slip, 0.0_wp, &
            [slip - start, 0.0_wp], .false., 0.0_wp, no_rotation)
         left = slip + compliance*response%traction(2) - displacement
         if (abs(left) <= balance_tolerance*properties%critical_slip + 4.0_wp*spacing( &
            abs(displacement) + half) .or. .not. high > low) return
         if (left > 0.0_wp) then
            high = slip
         else
            low = slip
         end if
         slope = 1.0_wp + compliance*response%tangent(2, 2)
         ! no slope leads out of the bracket, as does one below zero
         step = high - low
         if (abs(left) < slope*step) step = left/slope
         slip = slip - step
         if (.not. (slip > low .and. slip < high)) slip = 0.5_wp*(low + high)
      end do
   end subroutine advance

   !> Set `error` unless tests can be followed.
   pure subroutine check_shear_tests(tests, error)
      !> The tests
      type(shear_test), intent(in) :: tests(:)
      !> Set otherwise; names the test by its number
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: name
      integer :: i

      if (size(tests) == 0) call fatal_error(error, 'no shear test is given')
      do i = 1, size(tests)
         if (allocated(error)) return
         name = 'shear test '//to_text(i)
         associate (t => tests(i), n => size(tests(i)%displacement))
            if (n < 2 .or. size(t%shear_stress) /= n .or. size(t%normal_stress) /= n) then
               call fatal_error(error, name//' needs two samples or more, each with '// &
                  'displacement, shear stress and normal stress')
            else if (.not. (all_finite(t%displacement) .and. all_finite(t%shear_stress) &
                  .and. all_finite(t%normal_stress))) then
               call fatal_error(error, name//' has numbers that are not finite')
            else if (.not. all(t%normal_stress > 0.0_wp)) then
               call fatal_error(error, name//' has a normal stress of '// &
                  to_text(minval(t%normal_stress))//' MPa: it must be above zero, and '// &
                  'compression positive')
            else if (.not. maxval(t%displacement) > minval(t%displacement)) then
               call fatal_error(error, name//' does not move: all displacements are '// &
                  to_text(t%displacement(1))//' mm')
            else if (.not. maxval(abs(t%shear_stress)) > 0.0_wp) then
               call fatal_error(error, name//' has no shear stress: all are zero')
            else if (allocated(t%area)) then
               if (size(t%area) /= n .or. .not. all(t%area > 0.0_wp)) call fatal_error(error, &
                  name//' needs an area above zero at each of its samples')
            end if
         end associate
      end do
   end subroutine check_shear_tests

end module asperity_fit_shear_model
