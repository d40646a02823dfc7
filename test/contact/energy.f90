!> Energy ledgers of the contact-point update: the work is integrated independently, by Gauss
!> quadrature of the tractions along the path, never taken from the ledgers.
module test_contact_energy
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, &
      evaluate_normal_law, no_rotation, normal_response, rule_abaqus, rule_dissipative, &
      slip_backward_euler, slip_exact, status_open, status_slip, update_contact_point, wp
   use contact_cases, only: pair_properties, random_contact
   use contact_work, only: normal_work, tangential_work
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_energy

   integer(int64), parameter :: seed = 14142135_int64
   real(wp), parameter :: none(2) = 0.0_wp

contains

   function suite_contact_energy() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact energy')
      call suite%addTest(TestMethod('work = stored + dissipated - coupling', test_identity))
      call suite%addTest(TestMethod('pressure coupling of the rule abaqus', test_coupling))
      call suite%addTest(TestMethod('the dissipative rule creates no energy', test_no_creation))
      call suite%addTest(TestMethod('the work integral can fail', test_work_can_fail))
   end function suite_contact_energy

   !> Random paths of six increments, both rules and both integrations. The error is relative to
   !> the energies that pass through the increment.
   subroutine test_identity()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: last, next
      real(wp) :: overclosure, slip(2), work, change, scale, worst
      integer :: i, j, rule, integration, slipping, opened

      stream = random_stream(seed)
      worst = 0.0_wp
      slipping = 0
      opened = 0
      do i = 1, 800
         rule = merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0)
         integration = merge(slip_exact, slip_backward_euler, mod(i/2, 2) == 0)
         call random_contact(stream, p, rule, integration)
         last = contact_response()
         start = contact_state()
         do j = 1, 6
            overclosure = p%initial_separation &
               - stream%uniform(-0.5_wp, merge(7.0_wp, 3.5_wp, j == 5))*p%normal%sigma
            slip = p%critical_slip &
               *[stream%uniform(-1.5_wp, 1.5_wp), stream%uniform(-1.5_wp, 1.5_wp)]
            call update_contact_point(p, start, overclosure, slip, no_rotation, next)
            work = normal_work(p, start, overclosure) + tangential_work(p, start, next, slip)
            change = next%normal_energy + next%tangential_energy &
               - last%normal_energy - last%tangential_energy
            scale = next%normal_energy + last%normal_energy + next%dissipation &
               + next%tangential_energy + last%tangential_energy
            call worsen(worst, abs(work - (change + next%dissipation - next%pressure_coupling)) &
               /scale)
            call assertGreaterThanOrEqual(next%dissipation, 0.0_wp, 'dissipation')
            if (anyExceptions()) return
            if (next%status == status_slip) slipping = slipping + 1
            if (next%status == status_open) opened = opened + 1
            last = next
            start = next%state
         end do
      end do
      call record('contact_point.energy_identity', worst)
      call assertGreaterThan(slipping, 1000, message='increments that slip')
      call assertGreaterThan(opened, 20, message='increments that open')
      call assertLessThan(worst, 1.0e-12_wp, 'largest error over the energies')
   end subroutine test_identity

   !> Slip at 0.05 MPa, press to 4.7 MPa, slip back, release: mu gamma^2/(2 gcrit) times the
   !> change of pressure comes out of nothing, and stands in the ledger of the coupling.
   subroutine test_coupling()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(normal_response) :: low, high
      real(wp), parameter :: gamma = 0.3_wp
      real(wp) :: coupling, expected

      p = pair_properties(rule_abaqus)
      low = evaluate_normal_law(p%normal, p%initial_separation - 0.0541_wp)
      high = evaluate_normal_law(p%normal, p%initial_separation - 0.1423_wp)
      call update_contact_point(p, contact_state(), 0.0541_wp, [gamma, 0.0_wp], no_rotation, r)
      call update_contact_point(p, (r%state), 0.1423_wp, none, no_rotation, r)
      coupling = r%pressure_coupling
      expected = 0.5_wp*p%friction_coefficient*gamma**2/p%critical_slip &
         *(high%pressure - low%pressure)
      call assertEqual(expected, coupling, 1.0e-14_wp, 'pressing stores')
      call assertEqual(0.3375_wp, coupling, 0.001_wp, 'about 4.65 MPa')
      call update_contact_point(p, (r%state), 0.1423_wp, [-gamma, 0.0_wp], no_rotation, r)
      call assertEqual(0.0_wp, r%tangential_energy, 1.0e-15_wp, 'slipping back gives it out')
      call update_contact_point(p, (r%state), 0.0541_wp, none, no_rotation, r)
      call assertEqual(0.0_wp, r%pressure_coupling, 1.0e-15_wp, 'nothing to take back')
      call assertEqual(0.0_wp, r%state%dissipation, 0.0_wp, 'nothing was dissipated')
   end subroutine test_coupling

   !> Closed cycles from and to the open state: the work put in is never negative.
   subroutine test_no_creation()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: start
      real(wp) :: work, least, overclosure, slip(2), loss
      integer :: i, j

      stream = random_stream(seed + 1)
      least = huge(1.0_wp)
      do i = 1, 300
         call random_contact(stream, p, rule_dissipative, &
            merge(slip_exact, slip_backward_euler, mod(i, 2) == 0))
         start = contact_state()
         work = 0.0_wp
         loss = 0.0_wp
         do j = 1, 12
            overclosure = p%initial_separation - stream%uniform(0.0_wp, 3.0_wp)*p%normal%sigma
            if (j == 12) overclosure = p%initial_separation - 40.0_wp*p%normal%sigma
            slip = p%critical_slip &
               *[stream%uniform(-0.7_wp, 0.7_wp), stream%uniform(-0.7_wp, 0.7_wp)]
            call update_contact_point(p, start, overclosure, slip, no_rotation, r)
            work = work + normal_work(p, start, overclosure) + tangential_work(p, start, r, slip)
            loss = loss + r%dissipation
            call assertEqual(0.0_wp, r%pressure_coupling, 0.0_wp, 'no coupling')
            start = r%state
         end do
         least = min(least, work/loss)
         if (anyExceptions()) return
      end do
      call record('contact_point.dissipative.least_work_over_loss', least)
      call assertEqual(1.0_wp, least, 1.0e-9_wp, 'all work is lost, none created')
   end subroutine test_no_creation

   !> The independent work differs from what a wrong coefficient would give.
   subroutine test_work_can_fail()
      type(contact_properties) :: p, wrong
      type(contact_response) :: r
      real(wp), parameter :: slip(2) = [0.5_wp, 0.2_wp]
      real(wp) :: work

      p = pair_properties()
      wrong = p
      wrong%friction_coefficient = 1.001_wp*p%friction_coefficient
      call update_contact_point(p, contact_state(), 0.1_wp, slip, no_rotation, r)
      work = tangential_work(p, contact_state(), r, slip)
      call assertEqual(r%tangential_energy + r%dissipation, work, 1.0e-13_wp, 'right')
      call update_contact_point(wrong, contact_state(), 0.1_wp, slip, no_rotation, r)
      call assertGreaterThan(abs(r%tangential_energy + r%dissipation - work), 1.0e-4_wp*work, &
         'wrong')
   end subroutine test_work_can_fail

end module test_contact_energy
