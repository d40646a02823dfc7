!> UINTER with friction beyond one coefficient, with summits that stick each for itself, and with
!> the normal law's own numbers: PROPS(15) on and STATEV(12) on.
module test_abaqus_friction
   use, intrinsic :: iso_fortran_env, only: int64
   use abaqus_stubs, only: forget_calls, last_message, messages
   use asperity, only: contact_properties, contact_response, contact_state, contact_tangent, &
      error_type, friction_settings, heights_johnson, new_contact_properties, &
      new_normal_properties, normal_properties, slip_direction_of_stress, stick_summits, &
      update_contact_point, wp
   use asperity_abaqus_prop_slots, only: most_props, n_props
   use asperity_abaqus_props, only: properties_from_props, props_from_properties
   use asperity_abaqus_statev, only: most_statev, n_statev, state_grain_turn, &
      state_motion_share, state_summit_slip, statev_needed
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      try_increment
   use contact_cases, only: pair_properties
   use friction_cases, only: friction_properties, kinds, random_friction
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_abaqus_friction

   procedure(uinter_interface) :: uinter
   integer(int64), parameter :: seed = 27182818_int64
   real(wp), parameter :: dtime = 0.1_wp

contains

   function suite_abaqus_friction() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('abaqus friction')
      call suite%addTest(TestMethod('PROPS there and back', test_round_trip))
      call suite%addTest(TestMethod('each slot has its place', test_slots))
      call suite%addTest(TestMethod('lists of before give the same bits', test_old_lists))
      call suite%addTest(TestMethod('as the contact-point update', test_same))
      call suite%addTest(TestMethod('perturbation', test_perturbation))
      call suite%addTest(TestMethod('time increment', test_time))
      call suite%addTest(TestMethod('property lists that are refused', test_refused))
      call suite%addTest(TestMethod('DEPVAR and STATEV that are refused', test_statev))
   end function suite_abaqus_friction

   !> Friction of a kind; the kinds after those of `friction_cases` are summits, 8 and 5 elements.
   function properties_of(stream, kind, friction_rule, slip_integration) result(properties)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: kind
      integer, intent(in), optional :: friction_rule, slip_integration
      type(contact_properties) :: properties
      type(friction_settings) :: settings

      if (kind <= size(kinds)) then
         call random_friction(stream, kind, 0.5_wp, 0.31_wp, settings)
      else
         settings = friction_settings(stick=stick_summits, shear_modulus=31.6_wp, &
            stick_elements=merge(0, 5, kind == size(kinds) + 1))
      end if
      properties = friction_properties(settings, friction_rule, slip_integration)
   end function properties_of

   !> Bit for bit, through the list.
   subroutine test_round_trip()
      type(random_stream) :: stream
      type(contact_properties) :: p, q
      type(normal_properties) :: normal
      type(error_type), allocatable :: error
      integer :: kind

      stream = random_stream(seed)
      do kind = 1, size(kinds) + 2
         p = properties_of(stream, kind, friction_rule=2, slip_integration=2)
         call properties_from_props(props_from_properties(p), q, error)
         call assertFalse(allocated(error), 'accepted')
         call assertFalse(q%friction_is_plain, 'not plain')
         call assertEqual(props_from_properties(p), props_from_properties(q), 0.0_wp, 'list')
         call assertEqual(p%friction%friction_pressures, q%friction%friction_pressures, 0.0_wp, 'p')
         call assertEqual(p%friction%friction_factors, q%friction%friction_factors, 0.0_wp, 'f')
         call assertEqual(n_props + 2*p%friction%friction_points, size(props_from_properties(p)), &
            'length')
         if (anyExceptions()) return
      end do
      p = pair_properties()
      call new_normal_properties(normal, p%normal%eta, p%normal%modulus, p%normal%radius, &
         p%normal%hardness, p%normal%yield_factor, p%normal%sigma, error, plastic_ratio=54.0_wp, &
         height_distribution=heights_johnson, skewness=0.3_wp, kurtosis=3.61_wp)
      if (.not. allocated(error)) call new_contact_properties(p, normal, 0.5_wp, 0.31_wp, error)
      if (.not. allocated(error)) &
         call properties_from_props(props_from_properties(p), q, error)
      call assertFalse(allocated(error), 'accepted')
      call assertEqual([54.0_wp, 0.3_wp, 3.61_wp], [q%normal%plastic_ratio, q%normal%skewness, &
         q%normal%kurtosis], 0.0_wp, 'numbers of the law')
      call assertEqual(heights_johnson, q%normal%height_distribution, 'heights')
      call assertTrue(q%friction_is_plain, 'plain')
   end subroutine test_round_trip

   !> A value in each slot arrives in the component of its name.
   subroutine test_slots()
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      real(wp) :: props(n_props)

      props = props_from_properties(pair_properties())
      call assertEqual(0.0_wp*props(15:), props(15:), 0.0_wp, 'defaults are zeros')
      props(15:31) = [60.0_wp, 1.0_wp, -0.2_wp, 3.4_wp, 0.75_wp, 0.02_wp, 3.0_wp, 0.4_wp, 30.0_wp, &
         1.0_wp, -0.25_wp, 1.5_wp, 0.9_wp, 0.0_wp, 6.0_wp, 31.6_wp, 0.0_wp]
      call properties_from_props(props, p, error)
      call assertFalse(allocated(error), 'accepted')
      call assertEqual([60.0_wp, -0.2_wp, 3.4_wp], [p%normal%plastic_ratio, p%normal%skewness, &
         p%normal%kurtosis], 0.0_wp, '15, 17, 18')
      call assertEqual(heights_johnson, p%normal%height_distribution, '16')
      associate (f => p%friction)
         call assertEqual([0.75_wp, 0.02_wp, 3.0_wp, 0.4_wp, 30.0_wp], &
            [f%static_friction_coefficient, f%decay_slip, f%decay_slip_rate, &
            f%friction_coefficient_across, f%grain_angle], 0.0_wp, '19 to 23')
         call assertEqual(slip_direction_of_stress, f%slip_direction, '24')
         call assertEqual([-0.25_wp, 1.5_wp, 0.9_wp, 31.6_wp], [f%pressure_exponent, &
            f%reference_pressure, f%shear_limit, f%shear_modulus], 0.0_wp, '25 to 27, 30')
         call assertEqual(6, f%stick_elements, '29')
      end associate
      props(15:) = 0.0_wp
      props(28:31) = [1.0_wp, 0.0_wp, 31.6_wp, 2.0_wp]
      call properties_from_props([props, 0.5_wp, 1.25_wp, 2.0_wp, 0.75_wp], p, error)
      call assertFalse(allocated(error), 'accepted')
      call assertEqual([stick_summits, 2], [p%friction%stick, p%friction%friction_points], '28, 31')
      call assertEqual([0.5_wp, 2.0_wp], p%friction%friction_pressures(:2), 0.0_wp, '32, 34')
      call assertEqual([1.25_wp, 0.75_wp], p%friction%friction_factors(:2), 0.0_wp, '33, 35')
      ! a list that ends in between has zeros after its end
      props(28:31) = 0.0_wp
      props(18:20) = [0.0_wp, 0.6_wp, 0.05_wp]
      call properties_from_props(props(:20), p, error)
      call assertFalse(allocated(error), 'accepted')
      call assertEqual([110.0_wp, 3.0_wp, 0.6_wp, 0.05_wp, 0.0_wp], &
         [p%normal%plastic_ratio, p%normal%kurtosis, p%friction%static_friction_coefficient, &
         p%friction%decay_slip, p%friction%decay_slip_rate], 0.0_wp, 'a list of 20')
   end subroutine test_slots

   !> Lists of 12 and 14, and the same with zeros up to the longest: to the bit.
   subroutine test_old_lists()
      type(contact_properties) :: p
      type(host_point) :: short, long
      type(error_type), allocatable :: error
      type(random_stream) :: stream
      real(wp) :: props(n_props), overclosure, slip(2)
      integer :: unloading, i

      stream = random_stream(seed)
      p = pair_properties()
      props = props_from_properties(p)
      do unloading = 0, 1
         props(14) = unloading
         call new_host_point(short, uinter, p, props=props(:12 + 2*unloading))
         call new_host_point(long, uinter, p, props=props, nstatv=most_statev)
         do i = 1, 200
            overclosure = stream%uniform(0.0_wp, 0.15_wp)
            slip = [stream%uniform(-0.3_wp, 0.3_wp), stream%uniform(-0.3_wp, 0.3_wp)]
            call try_increment(short, overclosure, slip, dtime, error)
            call try_increment(long, overclosure, slip, dtime, error)
            call assertEqual(short%trial%stress, long%trial%stress, 0.0_wp, 'stress')
            call assertEqual(reshape(short%trial%ddsddr, [9]), reshape(long%trial%ddsddr, [9]), &
               0.0_wp, 'tangent')
            call assertEqual(short%trial%statev, long%trial%statev(:n_statev), 0.0_wp, 'STATEV')
            call assertEqual(0.0_wp*long%trial%statev(n_statev + 1:), &
               long%trial%statev(n_statev + 1:), 0.0_wp, 'slots that are not needed')
            call accept_increment(short)
            call accept_increment(long)
            if (anyExceptions()) return
         end do
      end do
   end subroutine test_old_lists

   !> All kinds, both rules and integrations, with rotations, and a STATEV longer than needed.
   subroutine test_same()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp) :: overclosure, slip(2), angle, turn(2, 2)
      integer :: kind, rule, i, j

      stream = random_stream(seed)
      do kind = 1, size(kinds) + 2
         do rule = 1, 2
            p = properties_of(stream, kind, rule, 3 - rule)
            call new_host_point(point, uinter, p, nstatv=statev_needed(p) + rule)
            r%state = contact_state()
            do i = 1, 50
               overclosure = stream%uniform(-0.05_wp, 0.15_wp)
               slip = [stream%uniform(-0.3_wp, 0.3_wp), stream%uniform(-0.3_wp, 0.3_wp)]
               angle = stream%uniform(-0.5_wp, 0.5_wp)
               turn = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
               call try_increment(point, overclosure, slip, dtime, error, turn)
               call assertFalse(allocated(error), 'UINTER kept its contract')
               call update_contact_point(p, (r%state), overclosure, slip, turn, r, dtime)
               call assertEqual(r%traction, point%trial%stress, 0.0_wp, 'stress')
               call assertEqual(reshape(r%tangent, [9]), reshape(point%trial%ddsddr, [9]), 0.0_wp, &
                  'tangent')
               call assertEqual(r%normal_energy + r%tangential_energy, point%trial%sed, 0.0_wp, &
                  'SED')
               call assertEqual(r%dissipation, point%trial%sfd, 0.0_wp, 'SFD')
               associate (statev => point%trial%statev, needed => statev_needed(p))
                  call assertEqual([r%state%motion_share, r%state%grain_turn], &
                     statev(state_motion_share:state_grain_turn), 0.0_wp, 'STATEV')
                  do j = 1, (needed - state_grain_turn)/2
                     call assertEqual(r%state%summit_slip(:, j), statev(state_summit_slip &
                        + 2*j - 2:state_summit_slip + 2*j - 1), 0.0_wp, 'elements')
                  end do
                  call assertEqual(0.0_wp*statev(needed + 1:), statev(needed + 1:), 0.0_wp, &
                     'slots beyond')
               end associate
               call accept_increment(point)
               if (anyExceptions()) return
            end do
         end do
      end do
   end subroutine test_same

   !> LINPER = 1 gives the tangent about the state that STATEV holds.
   subroutine test_perturbation()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r
      type(host_point) :: point
      type(error_type), allocatable :: error
      integer :: kind

      stream = random_stream(seed)
      do kind = 1, size(kinds) + 2
         p = properties_of(stream, kind)
         call new_host_point(point, uinter, p)
         call try_increment(point, 0.1_wp, [0.04_wp, 0.03_wp], dtime, error)
         call accept_increment(point)
         call update_contact_point(p, contact_state(), 0.1_wp, [0.04_wp, 0.03_wp], &
            reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2]), r, dtime)
         call try_increment(point, 1.0e-6_wp, [1.0e-6_wp, 0.0_wp], dtime, error, linper=1)
         call assertEqual(reshape(contact_tangent(p, r%state), [9]), &
            reshape(point%trial%ddsddr, [9]), 0.0_wp, 'tangent')
         call assertEqual(point%start%statev, point%trial%statev, 0.0_wp, 'state')
         if (anyExceptions()) return
      end do
   end subroutine test_perturbation

   !> Decay by rate: mu at rest over mu in motion at a rate of almost nothing, its formula between.
   subroutine test_time()
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp), parameter :: times(3) = [1.0e9_wp, 0.1_wp, 1.0e-9_wp], slip = 2.0_wp, rate = 10.0_wp
      integer :: i

      p = friction_properties(friction_settings(static_friction_coefficient=0.8_wp, &
         decay_slip_rate=rate))
      do i = 1, 3
         call new_host_point(point, uinter, p)
         call try_increment(point, 0.1_wp, [slip, 0.0_wp], times(i), error)
         call assertEqual((0.5_wp + 0.3_wp*exp(-slip/times(i)/rate))*point%trial%stress(1), &
            point%trial%stress(2), 1.0e-14_wp*point%trial%stress(1), 'shear stress')
      end do
      call new_host_point(point, uinter, p)
      call try_increment(point, 0.1_wp, [slip, 0.0_wp], 1.0e31_wp, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'a time that cannot be')
   end subroutine test_time

   subroutine test_refused()
      real(wp), parameter :: none(1) = 0.0_wp

      call expect(9, 0.0_wp, 'sigma', none)
      call expect(15, 9.0_wp, 'plastic_ratio = 9.0', none)
      call expect(16, 2.0_wp, 'PROPS(16) = 2.0 is not allowed: the height distribution', none)
      call expect(19, 0.4_wp, 'static_friction_coefficient = 0.4', none)
      call expect(19, 0.7_wp, 'static_friction_coefficient = 0.7', none)
      call expect(20, 0.1_wp, 'decay_slip = 0.1', none)
      call expect(21, 0.1_wp, 'decay_slip_rate = 0.1', none)
      call expect(22, -0.1_wp, 'friction_coefficient_across = -0.1', none)
      call expect(23, 400.0_wp, 'grain_angle = 400', none)
      call expect(24, 2.0_wp, 'PROPS(24) = 2.0 is not allowed: the slip direction', none)
      call expect(25, -1.0_wp, 'pressure_exponent = -1', none)
      call expect(26, -1.0_wp, 'reference_pressure = -1', none)
      call expect(27, -1.0_wp, 'shear_limit = -1', none)
      call expect(28, 2.0_wp, 'PROPS(28) = 2.0 is not allowed: what sticks', none)
      call expect(28, 1.0_wp, 'needs shear_modulus', none)
      call expect(29, 17.0_wp, 'PROPS(29) = 17.0 is not allowed: there are up to 16', none)
      call expect(29, 2.5_wp, 'PROPS(29) = 2.5 is not allowed', none)
      call expect(31, 9.0_wp, 'PROPS(31) = 9.0 is not allowed', none)
      call expect(31, 2.0_wp, 'PROPERTIES = 32 does not fit PROPS(31) = 2 friction points: '// &
         'give 35', none)
      call expect(31, 1.0_wp, 'pressure 1 of friction_points', [-1.0_wp, 1.0_wp])
      call expect(31, 1.0_wp, 'factor 1 of friction_points', [1.0_wp, 0.0_wp])
      call expect(31, 2.0_wp, 'pressure 2 of friction_points', [1.0_wp, 1.0_wp, 0.5_wp, 1.0_wp])
      call expect(31, 8.0_wp, 'PROPERTIES = 48 is not allowed: give 9 to 47', spread(1.0_wp, 1, 17))
   end subroutine test_refused

   !> A plain list with one slot of another value, and pairs after it, is refused with a text.
   subroutine expect(slot, value, text, pairs)
      integer, intent(in) :: slot
      real(wp), intent(in) :: value, pairs(:)
      character(len=*), intent(in) :: text
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp) :: props(n_props)

      props = props_from_properties(pair_properties())
      props(slot) = value
      call forget_calls()
      if (size(pairs) > 1 .or. slot == n_props) then
         call new_host_point(point, uinter, pair_properties(), props=[props, pairs])
      else
         call new_host_point(point, uinter, pair_properties(), props=props)
      end if
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(messages > 0, 'refused: '//text)
      call assertTrue(index(last_message, text) > 0, text//' in: '//trim(last_message))
   end subroutine expect

   subroutine test_statev()
      type(random_stream) :: stream
      type(contact_properties) :: p
      integer :: kind, i
      integer, parameter :: needed(4) = [13, 13, 13 + 16, 13 + 10]

      stream = random_stream(seed)
      call assertEqual(n_props + 16, most_props, 'longest list')
      call assertEqual(13 + 32, most_statev, 'longest STATEV')
      call assertEqual(11, statev_needed(pair_properties()), 'plain')
      do i = 1, 4
         kind = size(kinds) - 2 + i
         p = properties_of(stream, kind)
         call assertEqual(needed(i), statev_needed(p), 'needed')
         call refused(p, needed(i) - 1, 1, 0.0_wp, 'is too small: give DEPVAR = ')
         call refused(p, needed(i), state_motion_share, 1.5_wp, 'STATEV(12) = 1.5 is no share')
         call refused(p, needed(i), state_motion_share, -0.5_wp, 'STATEV(12) = -0.5 is no share')
         call not_computable(p, state_grain_turn)
      end do
      call not_computable(p, needed(4))
   end subroutine test_statev

   subroutine refused(p, length, slot, value, text)
      type(contact_properties), intent(in) :: p
      integer, intent(in) :: length, slot
      real(wp), intent(in) :: value
      character(len=*), intent(in) :: text
      type(host_point) :: point
      type(error_type), allocatable :: error

      call forget_calls()
      call new_host_point(point, uinter, p, nstatv=length)
      point%start%statev(slot) = value
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(index(last_message, text) > 0, text//' in: '//trim(last_message))
   end subroutine refused

   !> A number too large to compute with cuts the increment.
   subroutine not_computable(p, slot)
      type(contact_properties), intent(in) :: p
      integer, intent(in) :: slot
      type(host_point) :: point
      type(error_type), allocatable :: error

      call forget_calls()
      call new_host_point(point, uinter, p)
      point%start%statev(slot) = 1.0e31_wp
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'PNEWDT')
      call assertEqual(0, messages, 'no message')
   end subroutine not_computable

end module test_abaqus_friction
