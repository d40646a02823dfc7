!> UINTER as a host sees it: signs, outputs, the no-surface value, perturbations, errors, warnings.
module test_abaqus_uinter
   use, intrinsic :: ieee_arithmetic, only: ieee_negative_inf, ieee_quiet_nan, ieee_value
   use abaqus_stubs, only: exits, forget_calls, last_level, last_message, messages, warnings
   use asperity, only: contact_properties, contact_response, contact_state, error_type, &
      evaluate_normal_law, no_opposite_surface, no_rotation, normal_response, &
      roughness_number_low, rule_dissipative, slip_backward_euler, status_open, status_slip, &
      status_stick, update_contact_point, wp
   use asperity_abaqus_prop_slots, only: n_props
   use asperity_abaqus_props, only: props_from_properties, properties_from_props
   use asperity_abaqus_statev, only: n_statev, state_elastic_slip_1, state_elastic_slip_2, &
      state_from_statev, state_overclosure, state_pressure, state_status, state_validity, &
      state_warned
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_number_text, only: to_text
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      try_increment
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_uinter

   procedure(uinter_interface) :: uinter
   real(wp), parameter :: dtime = 0.1_wp

contains

   function suite_uinter() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('uinter')
      call suite%addTest(TestMethod('signs', test_signs))
      call suite%addTest(TestMethod('same numbers as the update, NDIR 2 and 3', test_same))
      call suite%addTest(TestMethod('no opposite surface, then contact', test_no_surface))
      call suite%addTest(TestMethod('energies: SED total, the rest incremental', test_energies))
      call suite%addTest(TestMethod('linear perturbation', test_perturbation))
      call suite%addTest(TestMethod('PNEWDT only when not computable', test_pnewdt))
      call suite%addTest(TestMethod('property lists that are refused', test_refused))
      call suite%addTest(TestMethod('property lists that are read', test_props))
      call suite%addTest(TestMethod('too small DEPVAR and wrong NDIR', test_sizes))
      call suite%addTest(TestMethod('how far PROPS(5) may be off pi', test_pi))
      call suite%addTest(TestMethod('later iterations do not warn', test_later_iterations))
      call suite%addTest(TestMethod('validity is warned of once', test_warning))
   end function suite_uinter

   !> Positive RDISP(1) presses, pressure is positive; shear has the sign of the motion; DDSDDR
   !> has positive diagonal.
   subroutine test_signs()
      type(host_point) :: point
      type(error_type), allocatable :: error
      integer :: i

      call new_host_point(point, uinter, pair_properties())
      call try_increment(point, 0.1_wp, [0.05_wp, -0.02_wp], dtime, error)
      call assertFalse(allocated(error), 'contract')
      call assertGreaterThan(point%trial%stress(1), 0.1_wp, 'pressure')
      call assertGreaterThan(point%trial%stress(2), 0.0_wp, 'shear 1')
      call assertLessThan(point%trial%stress(3), 0.0_wp, 'shear 2')
      do i = 1, 3
         call assertGreaterThan(point%trial%ddsddr(i, i), 0.0_wp, 'diagonal')
      end do
      call assertGreaterThan(point%trial%ddsddr(2, 1), 0.0_wp, 'pressing raises shear 1')
      call assertEqual(1, point%trial%lopenclose, 'closed')
      call assertEqual(status_stick, point%trial%lstate, 'status')
      call assertEqual(0, point%trial%lsdi, 'LSDI is not used')
      call accept_increment(point)
      call try_increment(point, 0.1_wp, [-0.2_wp, 0.0_wp], dtime, error)
      call assertLessThan(point%trial%stress(2), 0.0_wp, 'reversed')
      call try_increment(point, -0.5_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(0, point%trial%lopenclose, 'open')
      call assertEqual(status_open, point%trial%lstate, 'status')
   end subroutine test_signs

   subroutine test_same()
      type(contact_properties) :: p
      type(host_point) :: point
      type(contact_response) :: r
      type(error_type), allocatable :: error
      real(wp), parameter :: path(3, 4) = reshape([0.05_wp, 0.1_wp, 0.1_wp, 0.2_wp, 0.4_wp, &
         0.0_wp, 0.03_wp, -0.2_wp, 0.3_wp, -0.4_wp, 0.1_wp, 0.0_wp], [3, 4])
      real(wp) :: slip(2)
      integer :: ndir, i

      p = pair_properties()
      do ndir = 2, 3
         call new_host_point(point, uinter, p, ndir)
         r%state = contact_state()
         do i = 1, 4
            slip = path(2:3, i)
            if (ndir == 2) slip(2) = 0.0_wp
            call try_increment(point, path(1, i), slip(:ndir - 1), dtime, error)
            call update_contact_point(p, (r%state), path(1, i), slip, no_rotation, r)
            call assertEqual(r%traction(:ndir), point%trial%stress, 0.0_wp, 'stress')
            call assertEqual(reshape(r%tangent(:ndir, :ndir), [ndir**2]), &
               reshape(point%trial%ddsddr, [ndir**2]), 0.0_wp, 'tangent')
            call assertEqual(r%status, point%trial%lstate, 'status')
            call assertEqual([real(r%state%status, wp), r%state%overclosure, r%state%pressure, &
               r%state%normal_energy, r%state%elastic_slip, r%state%largest_closure, &
               r%state%dissipation, r%state%pressure_coupling, real(r%state%validity, wp)], &
               point%trial%statev(:10), 0.0_wp, 'STATEV')
            call accept_increment(point)
            if (anyExceptions()) return
         end do
      end do
   end subroutine test_same

   subroutine test_no_surface()
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error
      type(normal_response) :: law

      p = pair_properties()
      call new_host_point(point, uinter, p)
      call try_increment(point, no_opposite_surface, [0.3_wp, 0.0_wp], dtime, error)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], point%trial%stress, 0.0_wp, 'no stress')
      call assertEqual(0, point%trial%lopenclose, 'open')
      call assertEqual(0.0_wp, point%trial%sed, 0.0_wp, 'no energy')
      call accept_increment(point)
      ! DRDISP(1) is about 1e36 here
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      law = evaluate_normal_law(p%normal, p%initial_separation - 0.1_wp)
      call assertGreaterThan(point%trial%drdisp(1), 1.0e35_wp, 'DRDISP(1) is meaningless')
      call assertEqual(law%pressure, point%trial%stress(1), 0.0_wp, 'pressure')
      call assertEqual(law%energy, point%trial%sed, 0.0_wp, 'energy')
      call assertEqual(1, point%trial%lopenclose, 'closed')
   end subroutine test_no_surface

   subroutine test_energies()
      type(contact_properties) :: p
      type(host_point) :: point
      type(contact_response) :: r
      type(error_type), allocatable :: error
      integer :: i

      p = pair_properties()
      call new_host_point(point, uinter, p)
      do i = 1, 3
         call try_increment(point, 0.1_wp, [0.4_wp, 0.1_wp], dtime, error)
         call accept_increment(point)
         call update_contact_point(p, (r%state), 0.1_wp, [0.4_wp, 0.1_wp], no_rotation, r)
         call assertEqual(r%normal_energy + r%tangential_energy, point%start%sed, 0.0_wp, 'SED')
         call assertEqual(r%dissipation, point%start%sfd, 0.0_wp, 'SFD')
         call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], [point%start%spd, point%start%svd, &
            point%start%scd], 0.0_wp, 'others')
      end do
      call assertGreaterThan(r%dissipation, 0.0_wp, 'something was dissipated')
   end subroutine test_energies

   !> LINPER = 1: stress = base tangent times perturbation, nothing else changes.
   subroutine test_perturbation()
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp) :: perturbation(3)

      call new_host_point(point, uinter, pair_properties())
      call try_increment(point, 0.1_wp, [0.1_wp, 0.05_wp], dtime, error)
      call accept_increment(point)
      perturbation = [1.0e-6_wp, 2.0e-6_wp, -3.0e-6_wp]
      call try_increment(point, perturbation(1), perturbation(2:), dtime, error, linper=1)
      call assertFalse(allocated(error), 'contract')
      call assertEqual(matmul(point%trial%ddsddr, perturbation), point%trial%stress, 1.0e-20_wp, &
         'stress')
      call assertEqual(reshape(point%start%ddsddr, [9]), reshape(point%trial%ddsddr, [9]), &
         1.0e-12_wp, 'base tangent')
      call assertEqual(point%start%statev, point%trial%statev, 0.0_wp, 'state')
      call assertEqual(point%start%sed, point%trial%sed, 0.0_wp, 'SED')
      call assertEqual(point%start%lopenclose, point%trial%lopenclose, 'LOPENCLOSE')
      call assertEqual(0.0_wp, point%trial%sfd, 0.0_wp, 'SFD')
      call try_increment(point, 0.0_wp, [0.0_wp, 0.0_wp], dtime, error, linper=1)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], point%trial%stress, 0.0_wp, 'no perturbation')
      call try_increment(point, no_opposite_surface, [0.0_wp, 0.0_wp], dtime, error, linper=1)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], point%trial%stress, 0.0_wp, 'no surface')
      call assertGreaterThan(point%trial%pnewdt, 1.0_wp, 'no surface asks for no cut')
      call try_increment(point, 0.0_wp, [ieee_value(1.0_wp, ieee_quiet_nan), 0.0_wp], dtime, &
         error, linper=1)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'not computable')
   end subroutine test_perturbation

   subroutine test_pnewdt()
      type(host_point) :: point
      type(error_type), allocatable :: error

      call new_host_point(point, uinter, pair_properties())
      call try_increment(point, 0.1_wp, [0.1_wp, 0.0_wp], dtime, error)
      call assertGreaterThan(point%trial%pnewdt, 1.0_wp, 'untouched')
      call accept_increment(point)
      call try_increment(point, ieee_value(1.0_wp, ieee_quiet_nan), [0.1_wp, 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'RDISP not a number')
      call assertFalse(allocated(error), 'outputs are set all the same')
      call try_increment(point, 0.1_wp, [ieee_value(1.0_wp, ieee_quiet_nan), 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'DRDISP not a number')
      call try_increment(point, 1.0e35_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'overclosure of 1e35 mm')
      call assertEqual(point%start%statev, point%trial%statev, 0.0_wp, 'state is kept')
      call try_increment(point, 0.1_wp, [0.1_wp, 0.0_wp], dtime, error)
      call assertGreaterThan(point%trial%pnewdt, 1.0_wp, 'and goes on')
      call try_increment(point, -1.0e31_wp, [0.1_wp, 0.0_wp], dtime, error)
      call assertGreaterThan(point%trial%pnewdt, 1.0_wp, 'far away is no surface')
      call assertEqual(0, point%trial%lopenclose, 'far away is open')
   end subroutine test_pnewdt

   subroutine test_refused()
      type(contact_properties) :: p
      real(wp) :: props(n_props)
      integer :: i

      p = pair_properties()
      props = props_from_properties(p)
      call expect_error(props(:8), 'lack sigma')
      call expect_error(props(:5), 'PROPERTIES = 5')
      call expect_error([props, 1.0_wp], 'PROPERTIES = 32')
      call expect_error([props(2:9), 1.0_wp], 'must be pi')
      props(3) = -206.0_wp
      call expect_error(props, 'eta = -206.0')
      props = props_from_properties(p)
      props(11) = 3.0_wp
      call expect_error(props, 'PROPS(11) = 3.0')
      props = props_from_properties(p)
      props(12) = 1.5_wp
      call expect_error(props, 'PROPS(12) = 1.5')
      props = props_from_properties(p)
      props(13) = 2.0_wp
      call expect_error(props, 'PROPS(13) = 2.0')
      props = props_from_properties(p)
      props(3) = 2.06e-4_wp
      call expect_error(props(:12), 'eta looks like 1/um^2')
      props = props_from_properties(p)
      props(5) = 3.0_wp
      call expect_error(props, 'PROPS(5) = 3.0')
      do i = 1, n_props
         props = props_from_properties(p)
         props(i) = ieee_value(1.0_wp, ieee_quiet_nan)
         call expect_error(props, 'PROPS('//to_text(i)//') = NaN')
         props(i) = ieee_value(1.0_wp, ieee_negative_inf)
         call expect_error(props, 'PROPS('//to_text(i)//') = -Inf')
      end do
   end subroutine test_refused

   subroutine expect_error(props, text)
      real(wp), intent(in) :: props(:)
      character(len=*), intent(in) :: text
      type(host_point) :: point
      type(error_type), allocatable :: error

      call forget_calls()
      call new_host_point(point, uinter, pair_properties(), props=props)
      call try_increment(point, no_opposite_surface, [0.0_wp, 0.0_wp], dtime, error)
      call assertFalse(allocated(error), 'outputs are set')
      call assertEqual(0.0_wp, point%trial%sed, 0.0_wp, 'no energy')
      call assertTrue(messages >= 1 .and. messages == exits, 'one message, one XIT a call')
      call assertEqual(-3, last_level, 'error and stop')
      call assertTrue(index(last_message, text) > 0, text//' in: '//trim(last_message))
      call assertTrue(index(last_message, '%') == 0, 'no placeholder character')
   end subroutine expect_error

   !> PROPS(5) may be 0.01 off pi.
   subroutine test_pi()
      call check(acos(-1.0_wp) + 0.01_wp, 1)
      call check(acos(-1.0_wp) - 0.01_wp, -1)
   contains
      !> Two units in the last place on either side of the limit, which is rounded.
      subroutine check(limit, side)
         real(wp), intent(in) :: limit
         integer, intent(in) :: side
         type(contact_properties) :: read
         type(error_type), allocatable :: error
         real(wp) :: props(n_props)

         props = props_from_properties(pair_properties())
         props(5) = limit - 2*side*spacing(limit)
         call properties_from_props(props, read, error)
         call assertFalse(allocated(error), 'within')
         props(5) = limit + 2*side*spacing(limit)
         call properties_from_props(props, read, error)
         call assertTrue(allocated(error), 'beyond')
      end subroutine check
   end subroutine test_pi

   !> d0 is literal, zero and negative too; 4 sigma only with nine properties; 3.14 will do.
   subroutine test_props()
      type(contact_properties) :: p, read
      type(error_type), allocatable :: error
      real(wp) :: props(n_props)

      p = pair_properties()
      props = props_from_properties(p)
      props(5) = 3.14_wp
      call properties_from_props(props(:9), read, error)
      call assertFalse(allocated(error), 'nine')
      call assertEqual(4.0_wp*p%normal%sigma, read%initial_separation, 0.0_wp, '4 sigma')
      props(10) = 0.0_wp
      call properties_from_props(props(:10), read, error)
      call assertEqual(0.0_wp, read%initial_separation, 0.0_wp, 'zero is literal')
      props(10) = -0.02_wp
      call properties_from_props(props, read, error)
      call assertEqual(-0.02_wp, read%initial_separation, 0.0_wp, 'negative is literal')
      props(11:12) = [2.0_wp, 2.0_wp]
      call properties_from_props(props, read, error)
      call assertEqual([2, 2], [read%friction_rule, read%slip_integration], 'options')
      props(11:12) = 0.0_wp
      call properties_from_props(props, read, error)
      call assertEqual([1, 1], [read%friction_rule, read%slip_integration], 'zero is default')
      props = props_from_properties(p)
      call properties_from_props(props, read, error)
      call assertEqual(p%normal%sigma, read%normal%sigma, 0.0_wp, 'sigma')
      call assertEqual(p%normal%hardness, read%normal%hardness, 0.0_wp, 'hardness')
      call assertEqual(p%critical_slip, read%critical_slip, 0.0_wp, 'gcrit')
      p = pair_properties(rule_dissipative, slip_backward_euler)
      call properties_from_props(props_from_properties(p), read, error)
      call assertEqual([2, 2], [read%friction_rule, read%slip_integration], 'options kept')
      props(3) = 2.06e-4_wp
      call properties_from_props(props, read, error)
      call assertFalse(allocated(error), 'PROPS(13) = 1 lets it pass')
      call assertEqual(roughness_number_low, read%normal%validity, 'and flags it')
   end subroutine test_props

   subroutine test_sizes()
      integer, parameter :: slots(3) = [3, 10, 11]
      real(wp), parameter :: garbage(3) = [-100.0_wp, 1.0e20_wp, -1.0_wp]
      type(host_point) :: point
      type(error_type), allocatable :: error
      integer :: i

      call forget_calls()
      call new_host_point(point, uinter, pair_properties(), nstatv=n_statev - 1)
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(index(last_message, 'DEPVAR = 10 is too small') > 0, trim(last_message))
      call assertEqual(messages, exits, 'XIT')
      call forget_calls()
      call new_host_point(point, uinter, pair_properties(), ndir=4)
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(index(last_message, 'NDIR = 4') > 0, trim(last_message))
      call forget_calls()
      call new_host_point(point, uinter, pair_properties())
      point%start%statev(1) = 7.0_wp
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(index(last_message, 'STATEV(1) = 7.0 is no contact status') > 0, &
         trim(last_message))
      do i = 1, 3
         call forget_calls()
         call new_host_point(point, uinter, pair_properties())
         point%start%statev(slots(i)) = garbage(i)
         call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
         call assertTrue(index(last_message, 'nothing else may write to STATEV') > 0, &
            trim(last_message))
      end do
      call new_host_point(point, uinter, pair_properties())
      point%start%statev(7) = ieee_value(1.0_wp, ieee_quiet_nan)
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'STATEV not a number')
      call forget_calls()
      call new_host_point(point, uinter, pair_properties())
      point%start%statev(1) = ieee_value(1.0_wp, ieee_quiet_nan)
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(0.25_wp, point%trial%pnewdt, 0.0_wp, 'status not a number')
      call assertEqual(0, messages, 'which ends no job')
   end subroutine test_sizes

   !> Flags that come up in the second or third iteration, KIT = 1 and 2, are not spoken of then,
   !> but in the first iteration of the next increment.
   subroutine test_later_iterations()
      type(host_point) :: point
      type(error_type), allocatable :: error

      call forget_calls()
      call new_host_point(point, uinter, pair_properties())
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call accept_increment(point)
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual(1, point%trial%calls, 'KIT was 0')
      call try_increment(point, 0.2_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual([2, 0], [point%trial%calls, messages], 'KIT was 1')
      call try_increment(point, 0.2_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual([3, 0], [point%trial%calls, messages], 'KIT was 2')
      call accept_increment(point)
      call try_increment(point, 0.2_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertEqual([1, 1], [point%trial%calls, warnings], 'the next KIT of 0')
   end subroutine test_later_iterations

   !> Past the real area's limit: one warning at the point, however often it is called.
   subroutine test_warning()
      type(host_point) :: point
      type(error_type), allocatable :: error
      type(contact_state) :: state
      integer :: i

      call forget_calls()
      call new_host_point(point, uinter, pair_properties())
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call accept_increment(point)
      call assertEqual(0, messages, 'silent while valid')
      do i = 1, 5
         call try_increment(point, 0.2_wp, [0.0_wp, 0.0_wp], dtime, error)
         call try_increment(point, 0.2_wp, [0.0_wp, 0.0_wp], dtime, error)
         call assertGreaterThan(point%trial%stress(1), 1.0_wp, 'not aborted')
         call accept_increment(point)
      end do
      ! the first call of an increment, KIT = 0, warns; the second one forgets; the next warns again
      call assertEqual(2, warnings, 'once, and once more for a later iteration')
      call assertTrue(index(last_message, 'real area above nominal') > 0, trim(last_message))
      call assertEqual(0, exits, 'no XIT')
      call state_from_statev(point%start%statev, state)
      call assertTrue(iand(state%validity, 1) == 1, 'kept in STATEV')
      call assertEqual(point%start%statev(state_validity), point%start%statev(state_warned), &
         0.0_wp, 'warned of')
      call assertEqual(0.2_wp, point%start%statev(state_overclosure), 0.0_wp, 'overclosure')
      call assertEqual(point%start%stress(1), point%start%statev(state_pressure), 0.0_wp, 'p')
      call assertEqual(real(status_stick, wp), point%start%statev(state_status), 0.0_wp, 'status')
      call assertEqual(0.0_wp, point%start%statev(state_elastic_slip_2), 0.0_wp, 'slip')
      call assertFalse(status_slip == status_stick, 'statuses differ')
   end subroutine test_warning

end module test_abaqus_uinter
