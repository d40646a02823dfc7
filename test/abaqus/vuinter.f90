!> VUINTER as ABAQUS/Explicit sees it: signs, outputs, errors, warnings. In the precision that
!> VUINTER was compiled for; tolerances follow from `eps`, its rounding.
module test_abaqus_vuinter
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: real32, real64
   use abaqus_stubs, only: exits, forget_calls, last_level, last_message, messages, warnings
   use asperity, only: contact_properties, contact_response, contact_state, error_type, &
      no_opposite_surface, no_rotation, status_open, status_stick, update_contact_point, wp
   use asperity_abaqus_prop_slots, only: n_props
   use asperity_abaqus_props, only: props_from_properties, properties_from_props
   use asperity_abaqus_statev, only: n_statev, state_dissipation, state_from_statev, state_status, &
      state_validity, state_warned
   use asperity_abaqus_vuinter_precision, only: vp
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use vuinter_host, only: advance_nodes, guards_hold, new_slave_nodes, outputs_set, &
      outputs_untouched, slave_nodes, statev_of, stress_of
   implicit none
   private
   public :: suite_vuinter

   real(wp), parameter :: eps = real(epsilon(1.0_vp), wp)
   real(vp), parameter :: at_rest(2, 3) = 0.0_vp
   integer, parameter :: other = merge(real32, real64, vp == real64)

contains

   function suite_vuinter() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('vuinter')
      call suite%addTest(TestMethod('signs', test_signs))
      call suite%addTest(TestMethod('same numbers as the update, nDir 2 and 3', test_same))
      call suite%addTest(TestMethod('no opposite surface, then contact', test_no_surface))
      call suite%addTest(TestMethod('energies: sed total, the rest incremental', test_energies))
      call suite%addTest(TestMethod('a point at rest keeps its shear', test_rest))
      call suite%addTest(TestMethod('sticking in many small increments', test_small))
      call suite%addTest(TestMethod('no node, one, many; no cell outside', test_bounds))
      call suite%addTest(TestMethod('property lists that are refused', test_refused))
      call suite%addTest(TestMethod('a list in the other precision', test_precision))
      call suite%addTest(TestMethod('too small nStateVar, wrong nDir, foreign statev', test_sizes))
      call suite%addTest(TestMethod('numbers that are none end the job', test_diverged))
      call suite%addTest(TestMethod('results beyond the precision', test_overflow))
      call suite%addTest(TestMethod('validity is warned of once', test_warning))
   end function suite_vuinter

   subroutine test_signs()
      type(slave_nodes) :: nodes
      real(wp) :: stress(3), statev(n_statev)

      call new_slave_nodes(nodes, 1, pair_properties())
      call advance_nodes(nodes, [0.1_vp], reshape([0.05_vp, -0.02_vp], [2, 1]))
      stress = stress_of(nodes, 1)
      statev = statev_of(nodes, 1)
      call assertGreaterThan(stress(1), 0.1_wp, 'pressure')
      call assertGreaterThan(stress(2), 0.0_wp, 'shear 1')
      call assertLessThan(stress(3), 0.0_wp, 'shear 2')
      call assertEqual(real(status_stick, wp), statev(state_status), 0.0_wp, 'stick')
      call advance_nodes(nodes, [0.1_vp], reshape([-0.2_vp, 0.0_vp], [2, 1]))
      stress = stress_of(nodes, 1)
      call assertLessThan(stress(2), 0.0_wp, 'reversed')
      call advance_nodes(nodes, [-0.5_vp], reshape([0.0_vp, 0.0_vp], [2, 1]))
      statev = statev_of(nodes, 1)
      call assertEqual(real(status_open, wp), statev(state_status), 0.0_wp, 'open')
   end subroutine test_signs

   !> Each increment from the state that VUINTER keeps, so that rounding does not add up. Within
   !> 4 eps: one rounding to store, and what a rounded start pressure does to the elastic slip.
   subroutine test_same()
      type(contact_properties) :: p
      type(slave_nodes) :: nodes
      type(contact_response) :: r
      type(error_type), allocatable :: error
      real(vp), parameter :: path(3, 4) = reshape([0.05_vp, 0.1_vp, 0.1_vp, 0.2_vp, 0.4_vp, &
         0.0_vp, 0.03_vp, -0.2_vp, 0.3_vp, -0.4_vp, 0.1_vp, 0.0_vp], [3, 4])
      real(vp) :: rotation(2, 2, 1)
      real(wp) :: slip(2), turn(2, 2), statev(n_statev), wanted(10)
      integer :: n_dir, i

      rotation(:, :, 1) = reshape([0.8_vp, 0.6_vp, -0.6_vp, 0.8_vp], [2, 2])
      do n_dir = 2, 3
         call new_slave_nodes(nodes, 1, pair_properties(), n_dir)
         call properties_from_props(real(nodes%props, wp), p, error)
         r%state = contact_state()
         if (n_dir == 2) rotation = ieee_value(1.0_vp, ieee_quiet_nan)
         do i = 1, 4
            slip = real(path(2:3, i), wp)
            turn = no_rotation
            if (n_dir == 2) slip(2) = 0.0_wp
            if (n_dir == 3) turn = real(rotation(:, :, 1), wp)
            call advance_nodes(nodes, path(1:1, i), path(2:3, i:i), rotation)
            call update_contact_point(p, (r%state), real(path(1, i), wp), slip, turn, r)
            call assertEqual(r%traction(:n_dir)/r%traction(1), &
               stress_wp(nodes)/r%traction(1), 4.0_wp*eps, 'stress')
            statev = statev_of(nodes, 1)
            wanted = [real(r%state%status, wp), r%state%overclosure, r%state%pressure, &
               r%state%normal_energy, r%state%elastic_slip, r%state%largest_closure, &
               r%state%dissipation, r%state%pressure_coupling, real(r%state%validity, wp)]
            call assertEqual(wanted/max(1.0_wp, wanted), statev(:10)/max(1.0_wp, wanted), &
               4.0_wp*eps, 'statev')
            call state_from_statev(statev, r%state)
            if (anyExceptions()) return
         end do
         rotation(:, :, 1) = reshape([0.8_vp, 0.6_vp, -0.6_vp, 0.8_vp], [2, 2])
      end do
   end subroutine test_same

   function stress_wp(nodes) result(stress)
      type(slave_nodes), intent(in) :: nodes
      real(wp) :: stress(nodes%n_dir)
      real(wp) :: all_three(3)

      all_three = stress_of(nodes, 1)
      stress = all_three(:nodes%n_dir)
   end function stress_wp

   subroutine test_no_surface()
      type(slave_nodes) :: nodes, fresh
      real(vp), parameter :: slip(2, 1) = reshape([0.3_vp, 0.0_vp], [2, 1])

      call new_slave_nodes(nodes, 1, pair_properties())
      call advance_nodes(nodes, [real(no_opposite_surface, vp)], slip)
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], stress_of(nodes, 1), 0.0_wp, 'no stress')
      call assertEqual(0.0_wp, real(nodes%sed(1), wp), 0.0_wp, 'no energy')
      call advance_nodes(nodes, [0.1_vp], slip)
      call new_slave_nodes(fresh, 1, pair_properties())
      call advance_nodes(fresh, [0.1_vp], slip)
      call assertEqual(stress_of(fresh, 1), stress_of(nodes, 1), 0.0_wp, 'as a fresh point')
      call assertEqual(real(fresh%sed(1), wp), real(nodes%sed(1), wp), 0.0_wp, 'energy')
      call advance_nodes(nodes, [real(no_opposite_surface, vp)], slip)
      call assertEqual(0.0_wp, real(nodes%sed(1), wp), 0.0_wp, 'lost again')
      call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
   end subroutine test_no_surface

   subroutine test_energies()
      type(contact_properties) :: p
      type(slave_nodes) :: nodes
      type(contact_response) :: r
      type(error_type), allocatable :: error
      real(vp), parameter :: slip(2, 1) = reshape([0.4_vp, 0.1_vp], [2, 1])
      real(wp) :: statev(n_statev), sum_of_sfd
      integer :: i

      call new_slave_nodes(nodes, 1, pair_properties())
      call properties_from_props(real(nodes%props, wp), p, error)
      sum_of_sfd = 0.0_wp
      do i = 1, 3
         call advance_nodes(nodes, [0.1_vp], slip)
         call update_contact_point(p, (r%state), real(0.1_vp, wp), real(slip(:, 1), wp), &
            no_rotation, r)
         call assertEqual(r%normal_energy + r%tangential_energy, real(nodes%sed(1), wp), &
            10.0_wp*eps*r%normal_energy, 'sed')
         ! slipping along one line, each increment forgets the rounding of the last
         call assertEqual(r%dissipation, real(nodes%sfd(1), wp), 10.0_wp*eps*r%dissipation, 'sfd')
         call assertEqual([0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], real([nodes%spd(1), &
            nodes%svd(1), nodes%scd(1), nodes%flux_slave(1), nodes%flux_master(1)], wp), &
            0.0_wp, 'others')
         sum_of_sfd = sum_of_sfd + real(nodes%sfd(1), wp)
      end do
      statev = statev_of(nodes, 1)
      call assertGreaterThan(r%dissipation, 0.0_wp, 'something was dissipated')
      call assertEqual(sum_of_sfd, statev(state_dissipation), 4.0_wp*eps*sum_of_sfd, 'sum')
   end subroutine test_energies

   !> Rounding of STATEV must not wear the elastic slip away: with either rule, not a bit of the
   !> shear changes over many increments without motion.
   subroutine test_rest()
      type(slave_nodes) :: nodes
      real(wp) :: stress(3)
      integer :: rule, i

      do rule = 1, 2
         do i = 1, 60
            call new_slave_nodes(nodes, 1, pair_properties(rule))
            call advance_nodes(nodes, [0.1_vp + 0.001_vp*i], reshape([0.15_vp, 0.03_vp], [2, 1]))
            stress = stress_of(nodes, 1)
            call hold(nodes, 0.1_vp + 0.001_vp*i)
            call assertEqual(stress, stress_of(nodes, 1), 0.0_wp, 'held')
            if (anyExceptions()) return
         end do
      end do
   end subroutine test_rest

   subroutine hold(nodes, overclosure)
      type(slave_nodes), intent(inout) :: nodes
      real(vp), intent(in) :: overclosure
      integer :: i

      do i = 1, 500
         call advance_nodes(nodes, [overclosure], at_rest(:, :1))
      end do
   end subroutine hold

   !> Half of gcrit in a hundred thousand increments: STATEV rounds the elastic slip, which is below
   !> gcrit/2 and so has a rounding of eps/2 of that at most, once an increment.
   subroutine test_small()
      integer, parameter :: increments = 100000
      type(slave_nodes) :: nodes
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      real(vp) :: slip(2, 1)
      real(wp) :: stress(3), ratio
      integer :: i

      call new_slave_nodes(nodes, 1, pair_properties())
      call properties_from_props(real(nodes%props, wp), p, error)
      slip(:, 1) = [real(0.5_wp*p%critical_slip/increments, vp), 0.0_vp]
      do i = 1, increments
         call advance_nodes(nodes, [0.1_vp], slip)
      end do
      stress = stress_of(nodes, 1)
      ratio = stress(2)/(p%friction_coefficient*stress(1)*real(slip(1, 1), wp)*increments &
         /p%critical_slip)
      write (*, '(5x, a, es9.1)') 'relative error of the shear stress', abs(ratio - 1.0_wp)
      call assertEqual(1.0_wp, ratio, 0.5_wp*eps*increments, 'shear stress')
   end subroutine test_small

   !> Many nodes give what each gives alone; STATEV beyond the eleven is left alone.
   subroutine test_bounds()
      integer, parameter :: n_slots = n_statev + 2, counts(5) = [0, 1, 128, 129, 300]
      type(slave_nodes) :: nodes, alone
      real(vp), allocatable :: overclosure(:), slip(:, :)
      integer :: n_dir, n, i, k

      do n_dir = 2, 3
         do k = 1, 5
            n = counts(k)
            overclosure = [(real(modulo(37*i, 101) - 30, vp)*0.002_vp, i=1, n)]
            slip = reshape([(real(modulo(23*i, 97) - 40, vp)*0.01_vp, i=1, 2*n)], [2, n])
            call new_slave_nodes(nodes, n, pair_properties(), n_dir, n_slots=n_slots)
            if (n > 0) nodes%statev(n_slots) = 77.0_vp
            call advance_nodes(nodes, overclosure, slip)
            call advance_nodes(nodes, overclosure, slip)
            call assertTrue(guards_hold(nodes), 'no cell outside')
            call assertTrue(outputs_set(nodes), 'every output')
            if (n > 0) call assertEqual(77.0_wp, real(nodes%statev(n_slots), wp), 0.0_wp, 'slot 13')
            do i = 1, n
               call new_slave_nodes(alone, 1, pair_properties(), n_dir, n_slots=n_slots)
               call advance_nodes(alone, overclosure(i:i), slip(:, i:i))
               call advance_nodes(alone, overclosure(i:i), slip(:, i:i))
               call assertEqual(stress_of(alone, 1), stress_of(nodes, i), 0.0_wp, 'stress')
               call assertEqual(real([alone%sed(1), alone%sfd(1)], wp), &
                  real([nodes%sed(i), nodes%sfd(i)], wp), 0.0_wp, 'energies')
               if (anyExceptions()) return
            end do
         end do
      end do
   end subroutine test_bounds

   subroutine test_refused()
      real(vp) :: props(n_props), changed(n_props)

      props = real(props_from_properties(pair_properties()), vp)
      call expect_error(props(:8), 'lack sigma')
      call expect_error(props(:5), 'PROPERTIES = 5')
      call expect_error([props, 1.0_vp], 'PROPERTIES = 32')
      call expect_error([props(2:9), 1.0_vp], 'must be pi')
      call expect_error([props(2:9), 1.0_vp], 'or the run has another precision')
      changed = props
      changed(3) = -206.0_vp
      call expect_error(changed, 'eta = -206.0')
      changed = props
      changed(11) = 3.0_vp
      call expect_error(changed, 'PROPS(11) = 3.0')
      changed = props
      changed(5) = ieee_value(1.0_vp, ieee_quiet_nan)
      call expect_error(changed, 'PROPS(5) = NaN')
   end subroutine test_refused

   !> The list as the other precision lays it out, read as ours. Too short a list in double
   !> precision does not show its pi to VUINTER in single precision: the message names both causes.
   subroutine test_precision()
      real(other) :: list(2*n_props)
      real(vp) :: seen(n_props)

      list = 0.0_other
      list(:n_props) = real(props_from_properties(pair_properties()), other)
      seen = transfer(list, seen, n_props)
      if (vp == real64) then
         call expect_error(seen, 'PROPS is in single precision')
         call expect_error(seen, 'asperity_vuinter_single')
         call expect_error(seen(:9), 'PROPS is in single precision')
      else
         call expect_error(seen, 'PROPS is in double precision')
         call expect_error(seen, 'asperity_vuinter for')
         call expect_error(seen(:9), 'or the run has another precision')
      end if
   end subroutine test_precision

   !> A list that is refused ends the job before anything is written.
   subroutine expect_error(props, text)
      real(vp), intent(in) :: props(:)
      character(len=*), intent(in) :: text
      type(slave_nodes) :: nodes

      call forget_calls()
      call new_slave_nodes(nodes, 3, pair_properties(), props=props)
      call advance_nodes(nodes, [0.1_vp, 0.1_vp, 0.1_vp], at_rest)
      call expect_end(text)
      call assertTrue(outputs_untouched(nodes) .and. guards_hold(nodes), 'nothing was written')
      call assertTrue(all(abs(nodes%statev) < 1.0e4_vp), 'nor to statev')
   end subroutine expect_error

   !> One error that stops, one XPLB_EXIT, and this text.
   subroutine expect_end(text)
      character(len=*), intent(in) :: text

      call assertEqual([1, 1], [messages, exits], 'one message, one XPLB_EXIT')
      call assertEqual(-3, last_level, 'error and stop')
      call assertTrue(index(last_message, text) > 0, text//' in: '//trim(last_message))
      call assertTrue(index(last_message, '%') == 0, 'no placeholder character')
      call assertTrue(len_trim(last_message) <= 500, 'not longer than ABAQUS takes')
   end subroutine expect_end

   subroutine test_sizes()
      integer, parameter :: slots(4) = [1, 3, 10, 11]
      real(vp), parameter :: garbage(4) = [7.0_vp, -100.0_vp, 1.0e20_vp, -1.0_vp]
      type(slave_nodes) :: nodes
      integer :: i

      call forget_calls()
      call new_slave_nodes(nodes, 3, pair_properties(), n_slots=n_statev - 1)
      call advance_nodes(nodes, [0.1_vp, 0.1_vp, 0.1_vp], at_rest)
      call expect_end('DEPVAR = 10 is too small')
      call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
      do i = 1, 4, 3
         call forget_calls()
         call new_slave_nodes(nodes, 3, pair_properties(), n_dir=i)
         call advance_nodes(nodes, [0.1_vp, 0.1_vp, 0.1_vp], at_rest)
         call expect_end(merge('NDIR = 1', 'NDIR = 4', i == 1))
      end do
      do i = 1, 4
         call forget_calls()
         call new_slave_nodes(nodes, 3, pair_properties())
         nodes%statev(n_statev + slots(i)) = garbage(i)
         call advance_nodes(nodes, [0.1_vp, 0.1_vp, 0.1_vp], at_rest)
         call expect_end('NODE 102: STATEV(')
      end do
   end subroutine test_sizes

   subroutine test_diverged()
      type(slave_nodes) :: nodes
      real(vp) :: overclosure(3), slip(2, 3), rotation(2, 2, 3), bad
      integer :: fault, i

      bad = ieee_value(1.0_vp, ieee_quiet_nan)
      do fault = 1, 8
         call forget_calls()
         call new_slave_nodes(nodes, 3, pair_properties())
         overclosure = 0.1_vp
         slip = 0.05_vp
         rotation = spread(real(no_rotation, vp), 3, 3)
         call advance_nodes(nodes, overclosure, slip, rotation)
         select case (fault)
         case (1)
            overclosure(2) = bad
         case (2)
            overclosure(2) = 1.0e31_vp
         case (3)
            slip(2, 2) = bad
         case (4)
            slip(1, 2) = -1.0e31_vp
         case (5)
            rotation(1, 2, 2) = bad
         case (6)
            nodes%statev(n_statev + 1) = bad
         case (7)
            nodes%statev(n_statev + 7) = bad
         case default
            nodes%statev(n_statev + 5) = 1.0e31_vp
         end select
         call advance_nodes(nodes, overclosure, slip, rotation)
         call expect_end('NODE 102: '//trim(merge('RDISP ', 'STATEV', fault < 6)))
         call assertTrue(guards_hold(nodes), 'guards')
         do i = 1, 3
            call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], stress_of(nodes, i), 0.0_wp, 'no stress')
         end do
      end do
   end subroutine test_diverged

   !> 1e25 mm: an energy of 1e53, which single precision cannot hold.
   subroutine test_overflow()
      type(slave_nodes) :: nodes

      call forget_calls()
      call new_slave_nodes(nodes, 3, pair_properties())
      call advance_nodes(nodes, [0.1_vp, 0.1_vp, 1.0e25_vp], at_rest)
      if (vp == wp) then
         call assertEqual([1, 0], [warnings, exits], 'warned, no error')
      else
         call expect_end('NODE 103: pressure = ')
      end if
      call assertTrue(guards_hold(nodes) .and. outputs_set(nodes), 'outputs')
   end subroutine test_overflow

   !> Past the real area's limit: one message a call at most, and one a node and flag.
   subroutine test_warning()
      type(slave_nodes) :: nodes
      real(wp) :: statev(n_statev)
      integer :: i

      call forget_calls()
      call new_slave_nodes(nodes, 3, pair_properties())
      call advance_nodes(nodes, [0.1_vp, 0.1_vp, 0.1_vp], at_rest)
      call assertEqual(0, messages, 'silent while valid')
      do i = 1, 5
         call advance_nodes(nodes, [0.1_vp, 0.2_vp, 0.2_vp], at_rest)
      end do
      call assertEqual([1, 1], [messages, warnings], 'once for both nodes')
      call assertTrue(index(last_message, 'INTERACTION WOOD, 2 NODES, THE FIRST 102: ') > 0, &
         trim(last_message))
      call assertTrue(index(last_message, 'real area above nominal') > 0, trim(last_message))
      do i = 1, 5
         call advance_nodes(nodes, [0.2_vp, 0.1_vp, 0.2_vp], at_rest)
      end do
      call assertEqual([2, 2], [messages, warnings], 'once for the other')
      call assertTrue(index(last_message, 'INTERACTION WOOD, NODE 101: ') > 0, trim(last_message))
      call assertEqual(0, exits, 'no XPLB_EXIT')
      statev = statev_of(nodes, 2)
      call assertTrue(btest(nint(statev(state_validity)), 0), 'kept in statev')
      call assertEqual(statev(state_validity), statev(state_warned), 0.0_wp, 'warned of')
      call assertGreaterThan(real(nodes%stress(1), wp), 1.0_wp, 'not aborted')
   end subroutine test_warning

end module test_abaqus_vuinter
