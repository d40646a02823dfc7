!> Summits that stick each for itself, in the contact-point update: backbone, Masing's rule, random
!> paths, tangents and ledgers.
module test_contact_summit_stick
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: find_friction_elements, friction_elements
   use asperity_contact_friction_settings, only: fewest_stick_elements, friction_settings, &
      most_stick_elements, stick_summits
   use asperity_contact_point, only: contact_tangent, update_contact_point
   use asperity_contact_properties, only: contact_properties, new_contact_properties, rule_abaqus, &
      rule_dissipative, slip_backward_euler, slip_exact
   use asperity_contact_state, only: contact_response, contact_state, no_rotation, status_open, &
      status_slip, status_stick
   use asperity_contact_stick_elements, only: find_stick_elements, stick_elements, summit_backbone
   use asperity_law_normal_properties, only: normal_properties
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: normal_of_pair, random_properties, random_stream
   implicit none
   private
   public :: suite_summit_stick

   real(wp), parameter :: shear_modulus = 31.6_wp, mu = 0.5_wp

contains

   function suite_summit_stick() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('summit stick')
      call suite%addTest(TestMethod('backbone: its elements, and Mindlin''s sum', test_backbone))
      call suite%addTest(TestMethod('Masing: branches are the backbone doubled', test_masing))
      call suite%addTest(TestMethod('random paths against 500 elements', test_random_path))
      call suite%addTest(TestMethod('stiffness at first touch', test_first_touch))
      call suite%addTest(TestMethod('two halves are one, and turned axes', test_halves))
      call suite%addTest(TestMethod('tangents', test_tangents))
      call suite%addTest(TestMethod('work is stored and dissipated', test_ledgers))
      call suite%addTest(TestMethod('coefficient by pressure, shear limit', test_strength))
   end function suite_summit_stick

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

   subroutine test_backbone()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: fresh
      type(stick_elements) :: elements
      real(wp) :: overclosure, slip, chords, curve
      integer :: i, j

      p = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 0)
      chords = 0.0_wp
      curve = 0.0_wp
      do i = 0, 6
         overclosure = 0.7_wp*real(i, wp)*p%normal%sigma
         call find_stick_elements(p%normal, shear_modulus, 8, p%initial_separation - overclosure, &
            elements)
         do j = 0, 50
            slip = 0.03_wp*full_slip(p, overclosure)*real(j, wp)
            call move(p, fresh, overclosure, slip, r)
            call worsen(chords, abs(r%traction(2)/(mu*r%traction(1)) &
               - sum(elements%share(:8)*min(slip/(mu*elements%unit_slip(:8)), 1.0_wp))))
            call worsen(curve, abs(r%traction(2)/(mu*r%traction(1)) - summit_backbone(p%normal, &
               shear_modulus, p%initial_separation - overclosure, slip/mu)))
            call assertEqual(merge(status_slip, status_stick, j > 33), r%status, 'status')
         end do
      end do
      call record('summit_stick.backbone.chords', chords)
      call record('summit_stick.backbone.mindlin', curve)
      call assertLessThan(chords, 1.0e-14_wp, 'elements')
      call assertLessThan(curve, 0.01_wp, 'Mindlin')
   end subroutine test_backbone

   !> Loops between random turning points at constant pressure, each leg in 20 steps: from a turn on
   !> the stress falls by twice the backbone of half the way, and loops close.
   subroutine test_masing()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r, half
      type(contact_state) :: fresh, state
      real(wp) :: full, overclosure, amplitude, way, turned, error
      integer :: i, j

      stream = random_stream(1926)
      error = 0.0_wp
      do i = 1, 100
         call random_sticking(stream, i, p)
         overclosure = p%initial_separation - stream%uniform(-2.0_wp, 5.0_wp)*p%normal%sigma
         full = full_slip(p, overclosure)
         amplitude = full*stream%uniform(0.05_wp, 1.3_wp)
         call move(p, fresh, overclosure, amplitude, r)
         turned = r%traction(2)
         state = r%state
         do j = 1, 40
            way = 0.1_wp*amplitude*min(j, 40 - j)
            call move(p, state, overclosure, merge(-0.1_wp, 0.1_wp, j <= 20)*amplitude, r)
            state = r%state
            if (j <= 20) then
               call move(p, fresh, overclosure, 0.5_wp*way, half)
               call worsen(error, abs((r%traction(2) - turned + 2.0_wp*half%traction(2)) &
                  /(mu*r%traction(1))))
            else
               call move(p, fresh, overclosure, 0.1_wp*amplitude*(0.5_wp*real(j - 20, wp)), half)
               call worsen(error, abs((r%traction(2) + turned - 2.0_wp*half%traction(2)) &
                  /(mu*r%traction(1))))
            end if
         end do
         call worsen(error, abs((r%traction(2) - turned)/(mu*r%traction(1))))
      end do
      call record('summit_stick.masing', error)
      call assertLessThan(error, 1.0e-12_wp, 'branches')
   end subroutine test_masing

   !> Random motion to and fro at constant pressure against an Iwan model of its own, of 500 chords
   !> of Mindlin's sum. The first leg is off by the
   !> distance of the chords, 0.8 %, each turn that is remembered by up to twice that.
   subroutine test_random_path()
      integer, parameter :: seed = 1967, fine = 500
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: state
      real(wp) :: overclosure, full, slip, error, knot(0:fine), chord(fine + 1), share(fine)
      real(wp) :: gamma(fine), height(0:fine)
      integer :: i, j, n

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      error = 0.0_wp
      do n = 1, 12
         p = sticking(normal_of_pair(merge('transverse-tangential ', 'tangential-tangential ', &
            mod(n, 2) == 0)), rule_abaqus, slip_exact, 8)
         overclosure = p%initial_separation - stream%uniform(-1.0_wp, 5.0_wp)*p%normal%sigma
         full = full_slip(p, overclosure)
         knot(0) = 0.0_wp
         height(0) = 0.0_wp
         do i = 1, fine
            knot(i) = 3.0_wp*full*(real(i, wp)/fine)**2
            height(i) = summit_backbone(p%normal, shear_modulus, &
               p%initial_separation - overclosure, knot(i)/mu)
            chord(i) = (height(i) - height(i - 1))/(knot(i) - knot(i - 1))
         end do
         chord(fine + 1) = 0.0_wp
         share = knot(1:)*(chord(:fine) - chord(2:))
         gamma = 0.0_wp
         state = contact_state()
         call move(p, state, overclosure, 0.0_wp, r)
         do j = 1, 400
            slip = full*stream%uniform(-0.7_wp, 0.7_wp)
            state = r%state
            call move(p, state, overclosure, slip, r)
            gamma = min(max(gamma + slip, -knot(1:)), knot(1:))
            call worsen(error, abs(r%traction(2)/(mu*r%traction(1)) - sum(share*gamma/knot(1:))))
         end do
      end do
      call record('summit_stick.random_path', error)
      call assertLessThan(error, 0.025_wp, 'random paths')
   end subroutine test_random_path

   !> Sum of the elements' stiffnesses, by the tangent at rest and by the stick of a small motion:
   !> with 8 elements up to 12 % below 8 G* a of all summits.
   subroutine test_first_touch()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: fresh
      type(stick_elements) :: elements
      real(wp) :: tangent(3, 3), overclosure
      integer :: i

      p = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 8)
      do i = 1, 6
         overclosure = 0.7_wp*real(i, wp)*p%normal%sigma
         call find_stick_elements(p%normal, shear_modulus, 8, p%initial_separation - overclosure, &
            elements)
         call move(p, fresh, overclosure, 1.0e-7_wp, r)
         tangent = contact_tangent(p, r%state)
         call assertEqual(1.0_wp, tangent(2, 2)/r%tangent(2, 2), 1.0e-12_wp, 'tangent of a state')
         call assertEqual(1.0_wp, tangent(3, 3)/r%tangent(2, 2), 1.0e-12_wp, 'across')
         call assertEqual(0.94_wp, tangent(2, 2)/elements%stiffness, 0.06_wp, 'first touch')
      end do
   end subroutine test_first_touch

   !> Two halves of a straight increment equal one where slip is exact; slip directions that turn
   !> give the same stress, turned.
   subroutine test_halves()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: whole, half, turned
      type(contact_state) :: start, other
      real(wp) :: overclosure, full, slip(2), angle, q(2, 2), error, frame
      integer :: i

      stream = random_stream(1938)
      error = 0.0_wp
      frame = 0.0_wp
      do i = 1, 200
         call random_sticking(stream, 4*i, p)
         overclosure = p%initial_separation - stream%uniform(-1.0_wp, 4.0_wp)*p%normal%sigma
         full = full_slip(p, overclosure)
         call update_contact_point(p, contact_state(), overclosure, full*[ &
            stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)], no_rotation, whole)
         start = whole%state
         slip = full*[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
         call update_contact_point(p, start, overclosure, slip, no_rotation, whole)
         call update_contact_point(p, start, overclosure, 0.5_wp*slip, no_rotation, half)
         other = half%state
         call update_contact_point(p, other, overclosure, 0.5_wp*slip, no_rotation, half)
         call worsen(error, largest_of(whole%traction(2:) - half%traction(2:)) &
            /(mu*whole%traction(1)))
         angle = stream%uniform(-3.0_wp, 3.0_wp)
         q = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
         call update_contact_point(p, start, overclosure, matmul(q, slip), q, turned)
         call worsen(frame, largest_of(turned%traction(2:) - matmul(q, whole%traction(2:))) &
            /(mu*whole%traction(1)))
      end do
      call record('summit_stick.halves', error)
      call record('summit_stick.frame', frame)
      call assertLessThan(error, 1.0e-12_wp, 'halves')
      call assertLessThan(frame, 1.0e-12_wp, 'frame')
   end subroutine test_halves

   !> Central differences in random directions over increments in which the pressure changes, for
   !> both rules and both integrations, also where the point closes; not where an element is between
   !> stick and slip.
   subroutine test_tangents()
      integer, parameter :: seed = 2236
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r, ahead, behind
      type(contact_state) :: start
      real(wp) :: overclosure, slip(2), direction(3), h, error, worst
      integer :: i, row, n

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      worst = 0.0_wp
      n = 0
      do i = 1, 6000
         call random_sticking(stream, i, p)
         call prepare(stream, i, p, start, overclosure, slip)
         direction = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), &
            stream%uniform(-1.0_wp, 1.0_wp)]
         h = 1.0e-6_wp*min(p%normal%sigma, full_slip(p, overclosure))
         call update_contact_point(p, start, overclosure, slip, no_rotation, r)
         call update_contact_point(p, start, overclosure + h*direction(1), slip + h*direction(2:), &
            no_rotation, ahead)
         call update_contact_point(p, start, overclosure - h*direction(1), slip - h*direction(2:), &
            no_rotation, behind)
         if (any([ahead%status, behind%status] /= r%status)) cycle
         if (any(slipping(p, ahead%state) .neqv. slipping(p, behind%state))) cycle
         if (r%status == status_open) cycle
         n = n + 1
         do row = 2, 3
            error = (ahead%traction(row) - behind%traction(row))/(2.0_wp*h) &
               - dot_product(r%tangent(row, :), direction)
            call worsen(worst, abs(error/norm2(r%tangent(row, :))))
         end do
      end do
      call record('summit_stick.tangent', worst)
      call assertLessThan(worst, 1.0e-6_wp, 'tangents')
      call assertGreaterThan(n, 4000, message='cases')
   end subroutine test_tangents

   !> A start that has moved in two directions, or is open, and an increment.
   subroutine prepare(stream, i, p, start, overclosure, slip)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: i
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(out) :: start
      real(wp), intent(out) :: overclosure, slip(2)
      type(contact_response) :: r
      real(wp) :: full
      integer :: j

      overclosure = p%initial_separation - merge(8.0_wp, stream%uniform(-1.0_wp, 4.0_wp), &
         mod(i, 5) == 0)*p%normal%sigma
      full = full_slip(p, overclosure)
      do j = 1, 2
         slip = full*[stream%uniform(-1.2_wp, 1.2_wp), stream%uniform(-1.2_wp, 1.2_wp)]
         call update_contact_point(p, start, overclosure, slip, no_rotation, r)
         start = r%state
      end do
      if (mod(i, 5) == 0) overclosure = p%initial_separation - 4.0_wp*p%normal%sigma
      overclosure = overclosure + stream%uniform(-0.5_wp, 0.5_wp)*p%normal%sigma
      slip = full*[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
   end subroutine prepare

   !> Which elements are at their largest elastic slip.
   function slipping(p, state) result(at)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(in) :: state
      logical :: at(most_stick_elements)
      type(friction_elements) :: elements
      integer :: j

      at = .false.
      call find_friction_elements(p, state%overclosure, 1.0_wp, 0.0_wp, elements)
      do j = 1, elements%n
         at(j) = norm2(state%summit_slip(:, j)) > (1.0_wp - 1.0e-9_wp)*elements%radius(j)
      end do
   end function slipping

   !> Random paths in two directions with changing pressure, opening and closing: work of the shear
   !> stresses on the way, at the pressure of the end of each increment, against the ledgers. No
   !> dissipation is negative, and an open point remembers nothing.
   subroutine test_ledgers()
      integer, parameter :: seed = 1687, parts = 400
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r, part
      type(contact_state) :: start
      real(wp) :: overclosure, slip(2), full, work, ledger, energy, error, before(2)
      integer :: i, j, k

      write (*, '(5x, a, i0)') 'seed ', seed
      stream = random_stream(seed)
      error = 0.0_wp
      do i = 1, 40
         call random_sticking(stream, i, p)
         p%slip_integration = slip_exact
         start = contact_state()
         energy = 0.0_wp
         do j = 1, 25
            overclosure = p%initial_separation &
               - merge(9.0_wp, stream%uniform(0.0_wp, 3.0_wp), mod(j, 7) == 0)*p%normal%sigma
            full = full_slip(p, min(overclosure, p%initial_separation))
            slip = full*[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
            call update_contact_point(p, start, overclosure, slip, no_rotation, r)
            call assertGreaterThanOrEqual(r%dissipation, 0.0_wp, 'dissipation')
            if (r%status == status_open) then
               call assertEqual(0.0_wp, largest_of(r%state%summit_slip), 0.0_wp, 'forgotten')
               call assertEqual(0.0_wp, r%tangential_energy, 0.0_wp, 'nothing stored')
            else if (start%status /= status_open) then
               work = 0.0_wp
               call update_contact_point(p, start, overclosure, [0.0_wp, 0.0_wp], no_rotation, part)
               before = part%traction(2:)
               do k = 1, parts
                  call update_contact_point(p, start, overclosure, slip*real(k, wp)/parts, &
                     no_rotation, part)
                  work = work + 0.5_wp*dot_product(before + part%traction(2:), slip)/parts
                  before = part%traction(2:)
               end do
               ledger = r%tangential_energy - energy + r%dissipation - r%pressure_coupling
               call worsen(error, abs((work - ledger)/(mu*r%traction(1)*full)))
            end if
            energy = r%tangential_energy
            start = r%state
         end do
         if (anyExceptions()) return
      end do
      call record('summit_stick.ledgers', error)
      call assertLessThan(error, 1.0e-5_wp, 'work')
   end subroutine test_ledgers

   !> Plateaus are the strength; the stiffness is that of the solids, whatever the coefficient.
   subroutine test_strength()
      type(contact_properties) :: p, plain
      type(contact_response) :: r, first, other
      type(contact_state) :: fresh
      type(friction_settings) :: settings
      real(wp) :: overclosure

      plain = sticking(normal_of_pair('transverse-tangential'), rule_abaqus, slip_exact, 8)
      overclosure = 2.0_wp*plain%normal%sigma
      settings%pressure_exponent = -0.3_wp
      settings%reference_pressure = 0.1_wp
      p = sticking(plain%normal, rule_abaqus, slip_exact, 8, settings)
      call move(p, fresh, overclosure, 1.0_wp, r)
      call assertEqual(mu*r%traction(1)*(r%traction(1)/0.1_wp)**(-0.3_wp), r%traction(2), &
         1.0e-13_wp, 'power')
      call move(p, fresh, overclosure, 1.0e-6_wp, first)
      call move(plain, fresh, overclosure, 1.0e-6_wp, other)
      call assertEqual(other%traction(2), first%traction(2), 1.0e-15_wp, 'stiffness')
      settings = friction_settings(shear_limit=0.2_wp)
      p = sticking(plain%normal, rule_abaqus, slip_exact, 8, settings)
      call move(p, fresh, overclosure, 1.0_wp, r)
      call assertTrue(mu*r%traction(1) > 0.2_wp)
      call assertEqual(0.2_wp, r%traction(2), 1.0e-14_wp, 'limit')
   end subroutine test_strength

end module test_contact_summit_stick
