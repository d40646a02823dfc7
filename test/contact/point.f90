!> The contact-point update: tractions, opening and closing, state.
module test_contact_point
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, contact_tangent, &
      error_type, evaluate_normal_law, new_contact_properties, no_opposite_surface, &
      no_rotation, normal_response, pairs, rule_abaqus, rule_dissipative, &
      separation_for_pressure, slip_backward_euler, slip_exact, status_open, status_slip, &
      status_stick, update_contact_point, wp
   use asperity_law_validity, only: implausible_property
   use contact_cases, only: pair_properties, random_contact
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   use subjects, only: fits_subject
   implicit none
   private
   public :: suite_contact_point

   integer(int64), parameter :: seed = 31415926_int64
   real(wp), parameter :: none(2) = 0.0_wp

contains

   function suite_contact_point() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact point')
      call suite%addTest(TestMethod('pressure is the law at every separation', test_pressure))
      call suite%addTest(TestMethod('shear stress is mu p gamma/gcrit', test_shear))
      call suite%addTest(TestMethod('opening and closing with hysteresis', test_opening))
      call suite%addTest(TestMethod('elastic slip does not survive separation', test_separation))
      call suite%addTest(TestMethod('two half increments equal one', test_halves))
      call suite%addTest(TestMethod('no opposite surface, then contact', test_no_surface))
      call suite%addTest(TestMethod('rules for a changing pressure', test_rules))
      call suite%addTest(TestMethod('frame indifference', test_frame))
      call suite%addTest(TestMethod('base tangent for perturbations', test_base_tangent))
      call suite%addTest(TestMethod('what opening releases', test_release))
      call suite%addTest(TestMethod('largest closure and totals are kept', test_memory))
      call suite%addTest(TestMethod('properties that are refused', test_refused))
   end function suite_contact_point

   subroutine test_pressure()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(normal_response) :: law
      type(contact_state) :: fresh
      real(wp) :: overclosure, at_zero, below
      integer :: i

      p = pair_properties()
      do i = -300, 300
         overclosure = 0.01_wp*i*p%normal%sigma*4.0_wp
         call update_contact_point(p, fresh, overclosure, none, no_rotation, r)
         law = evaluate_normal_law(p%normal, p%initial_separation - overclosure)
         call assertEqual(law%pressure, r%traction(1), 0.0_wp, 'pressure')
         call assertEqual(law%stiffness, r%tangent(1, 1), 0.0_wp, 'stiffness')
         call assertEqual(law%energy, r%normal_energy, 0.0_wp, 'energy')
         call assertEqual(law%validity, r%validity, 'validity')
         if (anyExceptions()) return
      end do
      ! no jump at zero overclosure: 1e-9 mm changes p by 1e-9 mm times the stiffness
      call update_contact_point(p, fresh, 0.0_wp, none, no_rotation, r)
      at_zero = r%traction(1)
      call assertGreaterThan(at_zero, 1.0e-3_wp, 'the tail carries at zero overclosure')
      call update_contact_point(p, fresh, -1.0e-9_wp, none, no_rotation, r)
      below = r%traction(1)
      call assertEqual(at_zero - 1.0e-9_wp*r%tangent(1, 1), below, 1.0e-13_wp, 'no jump')
   end subroutine test_pressure

   subroutine test_shear()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: state
      real(wp) :: gamma(2), pressure

      p = pair_properties()
      gamma = [0.1_wp, -0.2_wp]
      call update_contact_point(p, state, 0.1_wp, gamma, no_rotation, r)
      pressure = r%traction(1)
      call assertEqual(status_stick, r%status, 'stick')
      call assertEqual(p%friction_coefficient*pressure*gamma/p%critical_slip, r%traction(2:3), &
         1.0e-15_wp, 'stick')
      call assertEqual(gamma, r%state%elastic_slip, 0.0_wp, 'elastic slip')
      call update_contact_point(p, (r%state), 0.1_wp, 10.0_wp*gamma, no_rotation, r)
      call assertEqual(status_slip, r%status, 'slip')
      call assertEqual(p%friction_coefficient*pressure, norm2(r%traction(2:3)), 1.0e-14_wp, &
         'plateau')
   end subroutine test_shear

   !> Closes above 2 p_open, opens below p_open, keeps its status between.
   subroutine test_opening()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: state
      type(error_type), allocatable :: error
      real(wp), parameter :: factors(6) = [1.5_wp, 2.1_wp, 1.5_wp, 1.01_wp, 0.99_wp, 1.9_wp]
      logical, parameter :: open_then(6) = [.true., .false., .false., .false., .true., .true.]
      real(wp) :: d
      integer :: i

      p = pair_properties()
      do i = 1, size(factors)
         call separation_for_pressure(p%normal, factors(i)*p%p_open, d, error)
         call update_contact_point(p, state, p%initial_separation - d, [0.01_wp, 0.0_wp], &
            no_rotation, r)
         call assertTrue((r%status == status_open) .eqv. open_then(i), 'status')
         call assertEqual(factors(i), r%traction(1)/p%p_open, 1.0e-12_wp, 'the law stays')
         if (open_then(i)) then
            call assertEqual(none, r%state%elastic_slip, 0.0_wp, 'no elastic slip while open')
            call assertEqual(none, r%traction(2:3), 0.0_wp, 'no shear while open')
         end if
         state = r%state
      end do
   end subroutine test_opening

   !> Press, slide, lift, move back in the air, press again: no shear.
   subroutine test_separation()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: state
      integer :: rule

      do rule = rule_abaqus, rule_dissipative
         p = pair_properties(rule)
         state = contact_state()
         call update_contact_point(p, state, 0.12_wp, none, no_rotation, r)
         call update_contact_point(p, (r%state), 0.12_wp, [1.0_wp, 0.5_wp], no_rotation, r)
         call assertGreaterThan(r%traction(2), 0.1_wp, 'slides')
         call update_contact_point(p, (r%state), -1.0_wp, none, no_rotation, r)
         call assertEqual(status_open, r%status, 'lifted')
         call update_contact_point(p, (r%state), -1.0_wp, [-0.5_wp, 0.0_wp], no_rotation, r)
         call update_contact_point(p, (r%state), 0.12_wp, none, no_rotation, r)
         call assertEqual(none, r%traction(2:3), 0.0_wp, 'pressed again')
         call assertEqual(0.0_wp, r%tangential_energy, 0.0_wp, 'no energy stored')
      end do
   end subroutine test_separation

   !> Exact integration, rule abaqus: random straight increments, also ones that close the point.
   subroutine test_halves()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: whole, half
      real(wp) :: from, to, slip(2), part, worst
      integer :: i, closings

      stream = random_stream(seed)
      worst = 0.0_wp
      closings = 0
      do i = 1, 5000
         call random_contact(stream, p, rule_abaqus, slip_exact)
         from = p%initial_separation - stream%uniform(-1.0_wp, 9.0_wp)*p%normal%sigma
         to = p%initial_separation - stream%uniform(-1.0_wp, 4.0_wp)*p%normal%sigma
         slip = p%critical_slip*[stream%uniform(-2.0_wp, 2.0_wp), stream%uniform(-2.0_wp, 2.0_wp)]
         call update_contact_point(p, contact_state(), from, none, no_rotation, whole)
         call update_contact_point(p, (whole%state), from, &
            p%critical_slip*[stream%uniform(-2.0_wp, 2.0_wp), 0.3_wp], no_rotation, whole)
         start = whole%state
         call update_contact_point(p, start, to, slip, no_rotation, whole)
         part = stream%uniform(0.1_wp, 0.9_wp)
         call update_contact_point(p, start, from + part*(to - from), part*slip, no_rotation, half)
         call update_contact_point(p, (half%state), to, (1.0_wp - part)*slip, no_rotation, half)
         if (start%status == status_open .and. whole%status /= status_open) closings = closings + 1
         call worsen(worst, norm2(whole%state%elastic_slip - half%state%elastic_slip) &
            /p%critical_slip)
         call assertEqual(whole%status == status_open, half%status == status_open, message='open')
         if (anyExceptions()) return
      end do
      call record('contact_point.halves', worst)
      call assertGreaterThan(closings, 500, message='cases that close')
      ! closing is found to 4 eps of the separation, over a travel of at least 1e-3 sigma
      call assertLessThan(worst, 1.0e-11_wp, 'elastic slip')
   end subroutine test_halves

   subroutine test_no_surface()
      type(contact_properties) :: p
      type(contact_response) :: r, direct
      real(wp), parameter :: slip(2) = [0.05_wp, 0.0_wp]

      p = pair_properties()
      call update_contact_point(p, contact_state(), no_opposite_surface, none, no_rotation, r)
      call assertEqual(status_open, r%status, 'open')
      call assertEqual([0.0_wp, 0.0_wp, 0.0_wp], r%traction, 0.0_wp, 'no traction')
      call assertEqual(0.0_wp, r%normal_energy, 0.0_wp, 'no energy')
      call update_contact_point(p, (r%state), 0.1_wp, slip, no_rotation, r)
      call update_contact_point(p, contact_state(), 0.1_wp, slip, no_rotation, direct)
      call assertEqual(direct%traction, r%traction, 0.0_wp, 'first contact after it')
      call assertEqual(slip, r%state%elastic_slip, 0.0_wp, 'all motion counts')
      call assertEqual(0.1_wp, r%state%largest_closure, 0.0_wp, 'largest closure')
   end subroutine test_no_surface

   !> abaqus keeps the elastic slip; dissipative keeps the shear stress while p rises and the
   !> elastic slip while it falls.
   subroutine test_rules()
      type(contact_properties) :: p
      type(contact_response) :: low, high, back
      real(wp), parameter :: slip(2) = [0.2_wp, 0.1_wp]

      p = pair_properties(rule_abaqus)
      call update_contact_point(p, contact_state(), 0.05_wp, slip, no_rotation, low)
      call update_contact_point(p, low%state, 0.14_wp, none, no_rotation, high)
      call assertEqual(slip, high%state%elastic_slip, 0.0_wp, 'abaqus keeps the elastic slip')
      p = pair_properties(rule_dissipative)
      call update_contact_point(p, contact_state(), 0.05_wp, slip, no_rotation, low)
      call update_contact_point(p, low%state, 0.14_wp, none, no_rotation, high)
      call assertEqual(low%traction(2:3), high%traction(2:3), 1.0e-15_wp, 'rising keeps the stress')
      call update_contact_point(p, high%state, 0.05_wp, none, no_rotation, back)
      call assertEqual(high%state%elastic_slip, back%state%elastic_slip, 0.0_wp, &
         'falling keeps the elastic slip')
   end subroutine test_rules

   !> Turning motion, state and slip directions turns the shear stress and nothing else.
   subroutine test_frame()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r, turned
      real(wp) :: angle, q(2, 2), first(2), second(2)
      integer :: i

      stream = random_stream(seed)
      do i = 1, 300
         p = pair_properties(merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0), &
            merge(slip_exact, slip_backward_euler, mod(i, 3) == 0))
         angle = stream%uniform(-3.0_wp, 3.0_wp)
         q = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
         first = [stream%uniform(-0.5_wp, 0.5_wp), stream%uniform(-0.5_wp, 0.5_wp)]
         second = [stream%uniform(-0.5_wp, 0.5_wp), stream%uniform(-0.5_wp, 0.5_wp)]
         call update_contact_point(p, contact_state(), 0.08_wp, first, no_rotation, r)
         call update_contact_point(p, r%state, 0.1_wp, matmul(q, second), q, turned)
         call update_contact_point(p, (r%state), 0.1_wp, second, no_rotation, r)
         call assertEqual(matmul(q, r%traction(2:3)), turned%traction(2:3), 1.0e-14_wp, 'stress')
         call assertEqual(r%dissipation, turned%dissipation, 1.0e-14_wp, 'dissipation')
         call assertEqual(reshape(matmul(matmul(q, r%tangent(2:3, 2:3)), transpose(q)), [4]), &
            reshape(turned%tangent(2:3, 2:3), [4]), 1.0e-12_wp, 'tangent')
         if (anyExceptions()) return
      end do
   end subroutine test_frame

   !> Stick: the same as an update without motion. Slip: only motion across the slip is resisted.
   subroutine test_base_tangent()
      type(contact_properties) :: p
      type(contact_response) :: r, again
      real(wp) :: tangent(3, 3), pressure

      p = pair_properties()
      tangent = contact_tangent(p, contact_state())
      call assertEqual(0.0_wp, largest_of(tangent), 0.0_wp, 'fresh point')
      call update_contact_point(p, contact_state(), 0.1_wp, [0.1_wp, 0.05_wp], no_rotation, r)
      call update_contact_point(p, r%state, 0.1_wp, none, no_rotation, again)
      tangent = contact_tangent(p, r%state)
      call assertEqual(reshape(again%tangent, [9]), reshape(tangent, [9]), 1.0e-12_wp, 'stick')
      call update_contact_point(p, contact_state(), 0.1_wp, [3.0_wp, 0.0_wp], no_rotation, r)
      tangent = contact_tangent(p, r%state)
      pressure = r%traction(1)
      call assertEqual(0.0_wp, tangent(2, 2), 1.0e-15_wp, 'along the slip')
      call assertEqual(p%friction_coefficient*pressure/p%critical_slip, tangent(3, 3), &
         1.0e-14_wp, 'across the slip')
      call assertEqual(p%friction_coefficient*r%tangent(1, 1), tangent(2, 1), 1.0e-12_wp, &
         'coupling')
      call update_contact_point(p, (r%state), 0.1_wp, [3.0_wp, 4.0_wp]*1.0e3_wp, no_rotation, r)
      tangent = contact_tangent(p, r%state)
      call assertEqual([0.64_wp, -0.48_wp, -0.48_wp, 0.36_wp], &
         reshape(tangent(2:3, 2:3), [4])*p%critical_slip/(p%friction_coefficient*pressure), &
         1.0e-14_wp, 'oblique slip')
      call update_contact_point(p, (r%state), -1.0_wp, none, no_rotation, r)
      tangent = contact_tangent(p, r%state)
      call assertEqual(0.0_wp, largest_of(tangent(2:3, :)), 0.0_wp, 'open')
   end subroutine test_base_tangent

   !> Opening under the rule abaqus: the pressure falls at the elastic slip of the start, which is
   !> coupling, and what is left, mu p gamma^2/(2 gcrit), is lost. A rotation that lengthens the
   !> elastic slip cannot take it beyond gcrit.
   subroutine test_release()
      type(contact_properties) :: p
      type(contact_response) :: closed, r
      real(wp) :: stored, left

      p = pair_properties()
      call update_contact_point(p, contact_state(), 0.1_wp, [0.2_wp, 0.1_wp], no_rotation, closed)
      call update_contact_point(p, closed%state, -0.15_wp, none, no_rotation, r)
      call assertEqual(status_open, r%status, 'open')
      stored = 0.5_wp*p%friction_coefficient*closed%traction(1)*0.05_wp/p%critical_slip
      left = 0.5_wp*p%friction_coefficient*r%traction(1)*0.05_wp/p%critical_slip
      call assertEqual(stored, closed%tangential_energy, 1.0e-15_wp, 'stored before')
      call assertEqual(left, r%dissipation, 1.0e-12_wp*left, 'lost')
      call assertEqual(left - stored, r%pressure_coupling, 1.0e-15_wp, 'coupling')
      call assertEqual(1.0e-9_wp*2.0_wp*acos(-1.0_wp)*p%normal%eta*p%normal%radius &
         *p%normal%hardness*p%normal%sigma, p%p_open, 1.0e-20_wp, 'p_open')
      call update_contact_point(p, closed%state, 0.1_wp, none, 2.0_wp*no_rotation, r)
      call assertEqual(p%critical_slip*[2.0_wp, 1.0_wp]/sqrt(5.0_wp), r%state%elastic_slip, &
         1.0e-15_wp, 'no longer than gcrit')
      call update_contact_point(p, closed%state, 0.2_wp, none, no_rotation, r)
      call update_contact_point(p, (r%state), 0.1_wp, none, no_rotation, r)
      call assertEqual(0, r%validity, 'valid again')
      call assertTrue(r%state%validity > 0, 'but not forgotten')
   end subroutine test_release

   subroutine test_memory()
      type(contact_properties) :: p
      type(contact_response) :: r
      real(wp), parameter :: path(4) = [-0.3_wp, 0.11_wp, 0.05_wp, 0.08_wp]
      real(wp) :: dissipation, coupling
      integer :: i

      p = pair_properties()
      dissipation = 0.0_wp
      coupling = 0.0_wp
      do i = 1, size(path)
         call update_contact_point(p, (r%state), path(i), [0.4_wp, 0.0_wp], no_rotation, r)
         dissipation = dissipation + r%dissipation
         coupling = coupling + r%pressure_coupling
         call assertEqual(maxval(path(:i)), r%state%largest_closure, 0.0_wp, 'largest closure')
         call assertEqual(path(i), r%state%overclosure, 0.0_wp, 'overclosure')
      end do
      call assertEqual(dissipation, r%state%dissipation, 1.0e-15_wp, 'dissipation')
      call assertEqual(coupling, r%state%pressure_coupling, 1.0e-15_wp, 'pressure coupling')
   end subroutine test_memory

   subroutine test_refused()
      type(contact_properties) :: p, made
      type(error_type), allocatable :: error

      p = pair_properties()
      call new_contact_properties(made, p%normal, -0.1_wp, 0.31_wp, error)
      call expect('friction_coefficient = -0.1')
      call new_contact_properties(made, p%normal, ieee_value(1.0_wp, ieee_quiet_nan), 0.31_wp, &
         error)
      call expect('friction_coefficient = NaN')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.31_wp, error, -1.0e37_wp)
      call expect('initial_separation = -1.0E37')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.0_wp, error)
      call expect('critical_slip = 0.0')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.31_wp, error, &
         ieee_value(1.0_wp, ieee_positive_inf))
      call expect('initial_separation = Infinity')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.31_wp, error, friction_rule=3)
      call expect('friction_rule = 3')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.31_wp, error, slip_integration=0)
      call expect('slip_integration = 0')
      call new_contact_properties(made, p%normal, 0.0_wp, 0.31_wp, error, -1.0_wp)
      call assertFalse(allocated(error), 'mu = 0 and a negative d0 are allowed')
      call assertEqual(-1.0_wp, made%initial_separation, 0.0_wp, 'd0 is literal')
      ! gcrit and 4 sigma in um; a length just within the limit; both let pass
      call new_contact_properties(made, p%normal, 0.5_wp, 310.0_wp, error)
      call expect('critical_slip = 310.0 mm is above 10.0 mm, which no known face has: '// &
         'critical_slip looks like um, give it in mm (times 1e-3); if it is right, set accept_')
      call new_contact_properties(made, p%normal, 0.5_wp, 0.31_wp, error, 237.2_wp)
      call expect('initial_separation = 237.0 mm is above 10.0 mm')
      call new_contact_properties(made, p%normal, 0.5_wp, 10.0_wp, error, -10.0_wp)
      call assertFalse(allocated(error), '10 mm')
      call assertEqual(p%normal%validity, made%normal%validity, 'valid')
      call new_contact_properties(made, p%normal, 0.5_wp, 310.0_wp, error, 237.2_wp, &
         compiled=.true., accept_unphysical=.true.)
      call assertFalse(allocated(error), 'accepted')
      call assertEqual(ior(p%normal%validity, implausible_property), made%normal%validity, &
         'flagged')
      call assertEqual(made%normal%validity, made%compiled%properties%validity, 'compiled as well')
      ! a pair of the paper in one call, with each option in its place
      call new_contact_properties(made, pairs(2), error, -1.0_wp, rule_dissipative, &
         slip_backward_euler, .true.)
      call assertFalse(allocated(error), 'a pair')
      call assertEqual([0.5_wp, 0.31_wp, -1.0_wp, pairs(2)%sigma], [made%friction_coefficient, &
         made%critical_slip, made%initial_separation, made%normal%sigma], 0.0_wp)
      call assertEqual(rule_dissipative, made%friction_rule)
      call assertEqual(slip_backward_euler, made%slip_integration)
      call assertTrue(allocated(made%compiled), 'compiled')
      call new_contact_properties(made, pairs(2), error)
      call assertEqual(4.0_wp*pairs(2)%sigma, made%initial_separation, 0.0_wp)
      call new_contact_properties(made, pairs(1), error, 237.2_wp)
      call expect('initial_separation = 237.0 mm is above 10.0 mm')
      call new_contact_properties(made, pairs(1), error, 237.2_wp, accept_unphysical=.true.)
      call assertFalse(allocated(error), 'accepted')

   contains

      subroutine expect(text)
         character(len=*), intent(in) :: text

         call assertTrue(allocated(error), text)
         if (.not. allocated(error)) return
         call assertEqual(1, index(error%message, text), error%message)
         call assertTrue(fits_subject(error), error%message)
      end subroutine expect

   end subroutine test_refused

end module test_contact_point
