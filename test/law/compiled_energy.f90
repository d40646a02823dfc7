!> Energies of the contact-point update with the compiled law: the work is integrated from the
!> tractions along the path, never taken from the ledgers.
module test_law_compiled_energy
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, no_rotation, &
      slip_exact, status_open, status_slip, update_contact_point, wp
   use contact_cases, only: pair_properties
   use contact_work, only: normal_work, tangential_work
   use extremes, only: worsen
   use funit, only: assertEqual, assertGreaterThan, assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use points_cases, only: compile, random_pair, random_slip
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_compiled_energy

   integer(int64), parameter :: seed = 26457514_int64

contains

   function suite_compiled_energy() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled energy')
      call suite%addTest(TestMethod('work = stored + dissipated - coupling', test_energy))
      call suite%addTest(TestMethod('the work integral can fail', test_energy_can_fail))
   end function suite_compiled_energy

   !> Closed points on random paths, the slip integrated exactly. The compiled energy is a
   !> polynomial of its own: pressure and energy agree to the law's error, not to round-off.
   subroutine test_energy()
      type(random_stream) :: stream
      type(contact_properties) :: direct, p
      type(contact_state) :: start
      type(contact_response) :: last, next
      real(wp) :: overclosure, slip(2), work, change, scale, worst
      integer :: set, i, slipping

      stream = random_stream(seed)
      worst = 0.0_wp
      slipping = 0
      do set = 1, 200
         call random_pair(stream, 2 + mod(set, 2), direct, p)
         call assertEqual(slip_exact, p%slip_integration, 'exact')
         start = contact_state()
         last = contact_response()
         do i = 1, 8
            overclosure = p%initial_separation - stream%uniform(-2.0_wp, 3.0_wp)*p%normal%sigma
            slip = random_slip(stream, p, 1.5_wp)
            call update_contact_point(p, start, overclosure, slip, no_rotation, next)
            work = normal_work(p, start, overclosure) + tangential_work(p, start, next, slip)
            change = next%normal_energy + next%tangential_energy &
               - last%normal_energy - last%tangential_energy
            scale = next%normal_energy + last%normal_energy + next%dissipation &
               + next%tangential_energy + last%tangential_energy
            call worsen(worst, abs(work - (change + next%dissipation - next%pressure_coupling)) &
               /scale)
            if (next%status == status_slip) slipping = slipping + 1
            call assertGreaterThan(next%status, status_open, message='closed')
            last = next
            start = next%state
         end do
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call record('compiled_points.energy_identity', worst)
      call assertGreaterThan(slipping, 800, message='increments that slip')
      call assertLessThan(worst, 1.0e-10_wp, 'largest error over the energies')
   end subroutine test_energy

   !> The work, which is found without the ledgers, differs where the friction does.
   subroutine test_energy_can_fail()
      type(contact_properties) :: p, wrong
      type(contact_response) :: r
      real(wp), parameter :: slip(2) = [0.5_wp, 0.2_wp]
      real(wp) :: work

      call compile(pair_properties(), p)
      wrong = p
      wrong%friction_coefficient = (1.0_wp + 1.0e-8_wp)*p%friction_coefficient
      call update_contact_point(p, contact_state(), 0.1_wp, slip, no_rotation, r)
      work = tangential_work(p, contact_state(), r, slip)
      call assertEqual(work, r%tangential_energy + r%dissipation, 1.0e-13_wp*work, 'right')
      call update_contact_point(wrong, contact_state(), 0.1_wp, slip, no_rotation, r)
      call assertGreaterThan(abs(r%tangential_energy + r%dissipation - work), 0.9e-8_wp*work, &
         'wrong')
   end subroutine test_energy_can_fail

end module test_law_compiled_energy
