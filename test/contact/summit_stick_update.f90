!> Summits that stick each for itself, in updates with pressure that changes and motion in two
!> directions: halves, turned axes, tangents and ledgers.
module test_contact_summit_stick_update
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_elements, only: find_friction_elements, friction_elements
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_contact_point, only: update_contact_point
   use asperity_contact_properties, only: contact_properties, slip_exact
   use asperity_contact_state, only: contact_response, contact_state, no_rotation, status_open
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   use stick_cases, only: full_slip, mu, random_sticking
   implicit none
   private
   public :: suite_summit_stick_update

contains

   function suite_summit_stick_update() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('summit stick, updates')
      call suite%addTest(TestMethod('two halves are one, and turned axes', test_halves))
      call suite%addTest(TestMethod('tangents', test_tangents))
      call suite%addTest(TestMethod('work is stored and dissipated', test_ledgers))
   end function suite_summit_stick_update

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

end module test_contact_summit_stick_update
