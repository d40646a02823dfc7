!> The contact-point update with memory: ledger, tangent on every branch and between them, what is
!> remembered and what is not.
module test_contact_memory
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, contact_tangent, &
      evaluate_normal_law, evaluate_unloading_law, memory_beyond_data, no_opposite_surface, &
      no_rotation, normal_response, rule_abaqus, rule_dissipative, slip_backward_euler, &
      slip_exact, status_open, status_stick, unloading_elastic, unloading_stiffness, &
      update_contact_point, wp
   use asperity_contact_properties, only: close_pressure_ratio
   use contact_cases, only: pair_properties, random_contact
   use contact_work, only: normal_work, tangential_work
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_memory

   integer(int64), parameter :: seed = 22360679_int64
   real(wp), parameter :: none(2) = 0.0_wp

contains

   function suite_contact_memory() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact memory')
      call suite%addTest(TestMethod('work = stored + dissipated - coupling', test_identity))
      call suite%addTest(TestMethod('tangent against differences, every branch', test_tangent))
      call suite%addTest(TestMethod('tangent about a state', test_perturbation))
      call suite%addTest(TestMethod('what a point remembers', test_memory))
      call suite%addTest(TestMethod('closing again', test_closing))
      call suite%addTest(TestMethod('beyond the data', test_flag))
   end function suite_contact_memory

   !> Random paths, both rules and both integrations; the error is relative to the energies that
   !> pass through the increment.
   subroutine test_identity()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: last, next
      real(wp) :: overclosure, slip(2), work, change, scale, worst
      integer :: i, j, unloaded, flattened

      stream = random_stream(seed)
      worst = 0.0_wp
      unloaded = 0
      flattened = 0
      do i = 1, 100
         call random_contact(stream, p, merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0), &
            merge(slip_exact, slip_backward_euler, mod(i/2, 2) == 0), unloading_elastic)
         last = contact_response()
         start = contact_state()
         do j = 1, 8
            overclosure = p%initial_separation - stream%uniform(-0.5_wp, 3.5_wp)*p%normal%sigma
            ! parting a little, too
            if (mod(j, 4) == 2) overclosure = start%overclosure &
               - p%normal%w1*stream%log_uniform(0.01_wp, 100.0_wp)
            slip = p%critical_slip &
               *[stream%uniform(-1.5_wp, 1.5_wp), stream%uniform(-1.5_wp, 1.5_wp)]
            call update_contact_point(p, start, overclosure, slip, no_rotation, next)
            work = normal_work(p, start, overclosure) + tangential_work(p, start, next, slip)
            change = next%normal_energy + next%tangential_energy &
               - last%normal_energy - last%tangential_energy
            scale = next%normal_energy + last%normal_energy + next%dissipation &
               + next%tangential_energy + last%tangential_energy &
               + max(next%plastic_dissipation, total_dissipation(p, next%state))
            call worsen(worst, abs(work - (change + next%dissipation &
               + next%plastic_dissipation - next%pressure_coupling))/scale)
            call assertGreaterThanOrEqual(next%plastic_dissipation, 0.0_wp, 'plastic dissipation')
            if (overclosure < start%largest_closure .and. j > 1) then
               call assertEqual(0.0_wp, next%plastic_dissipation, 0.0_wp, 'not closer than ever')
               unloaded = unloaded + 1
            else if (next%plastic_dissipation > 0.0_wp) then
               flattened = flattened + 1
            end if
            if (anyExceptions()) return
            last = next
            start = next%state
         end do
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call record('contact_point.memory.energy_identity', worst)
      call assertGreaterThan(unloaded, 150, message='increments that unload')
      call assertGreaterThan(flattened, 150, message='increments that flatten')
      call assertLessThan(worst, 1.0e-12_wp, 'largest error over the energies')
   end subroutine test_identity

   !> Plastic dissipation since first touch.
   function total_dissipation(p, state) result(total)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(in) :: state
      real(wp) :: total
      type(normal_response) :: law

      law = evaluate_unloading_law(p%normal, p%initial_separation - state%largest_closure, 0.0_wp)
      total = law%plastic_dissipation
   end function total_dissipation

   !> Central differences of step 1e-6 of the retraction's or sigma's size, error relative to the
   !> norm of the row: virgin, unloading, reloading, and increments from unloading to virgin.
   subroutine test_tangent()
      integer, parameter :: n_branches = 4
      character(len=9), parameter :: names(n_branches) = &
         ['virgin   ', 'unloading', 'reloading', 'passing  ']
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: overclosure, closest, u, slip(2), direction(3), h, worst(n_branches)
      integer :: i, branch, row, counts(n_branches)

      stream = random_stream(seed + 1)
      worst = 0.0_wp
      counts = 0
      do i = 1, 4000
         branch = 1 + mod(i, n_branches)
         call random_contact(stream, p, merge(rule_abaqus, rule_dissipative, mod(i/4, 2) == 0), &
            merge(slip_exact, slip_backward_euler, mod(i/8, 2) == 0), unloading_elastic)
         closest = p%initial_separation - stream%uniform(-1.0_wp, 3.0_wp)*p%normal%sigma
         slip = 0.4_wp*p%critical_slip &
            *[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
         call update_contact_point(p, contact_state(), closest, slip, no_rotation, r)
         start = r%state
         ! retractions over which the pressure falls by a part
         u = stream%uniform(0.05_wp, 0.6_wp)*r%normal_energy/r%traction(1)
         h = 1.0e-4_wp*u
         if (branch > 2) then
            call update_contact_point(p, start, closest - u, slip, no_rotation, r)
            start = r%state
         end if
         select case (branch)
         case (2)
            overclosure = closest - u
         case (3)
            overclosure = closest - 0.5_wp*u
         case default
            overclosure = closest + u
         end select
         direction = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), &
            stream%uniform(-1.0_wp, 1.0_wp)]
         direction = direction/norm2(direction)
         call update_contact_point(p, start, overclosure, slip, no_rotation, r)
         call update_contact_point(p, start, overclosure + h*direction(1), slip + h*direction(2:), &
            no_rotation, ahead)
         call update_contact_point(p, start, overclosure - h*direction(1), slip - h*direction(2:), &
            no_rotation, behind)
         if (ahead%status /= behind%status .or. r%status == status_open) cycle
         counts(branch) = counts(branch) + 1
         do row = 1, 3
            call worsen(worst(branch), abs((ahead%traction(row) - behind%traction(row))/(2.0_wp*h) &
               - dot_product(r%tangent(row, :), direction))/norm2(r%tangent(row, :)))
         end do
         if (anyExceptions()) return
      end do
      do branch = 1, n_branches
         call record('contact_point.memory.tangent.'//trim(names(branch)), worst(branch))
         call assertLessThan(worst(branch), 1.0e-6_wp, names(branch))
         call assertGreaterThan(counts(branch), 500, message='cases of '//names(branch))
      end do
   end subroutine test_tangent

   !> About a state at its largest closure the point parts, with the stiffness of unloading; an
   !> increment that rests there has the virgin one. About a state that has parted both are one.
   subroutine test_perturbation()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(normal_response) :: virgin
      real(wp) :: tangent(3, 3), separation
      real(wp), parameter :: overclosure = 0.1_wp

      p = pair_properties(unloading=unloading_elastic)
      separation = p%initial_separation - overclosure
      virgin = evaluate_normal_law(p%normal, separation)
      call update_contact_point(p, contact_state(), overclosure, none, no_rotation, r)
      call update_contact_point(p, (r%state), overclosure, none, no_rotation, r)
      call assertEqual(virgin%stiffness, r%tangent(1, 1), 0.0_wp, 'at rest')
      call assertEqual(0.0_wp, r%plastic_dissipation, 0.0_wp, 'nothing is flattened at rest')
      tangent = contact_tangent(p, r%state)
      call assertEqual(unloading_stiffness(p%normal, separation), tangent(1, 1), 0.0_wp, 'parting')
      call assertGreaterThan(tangent(1, 1), 2.0_wp*virgin%stiffness, 'much stiffer')
      call update_contact_point(p, (r%state), overclosure - 1.0e-3_wp, none, no_rotation, r)
      tangent = contact_tangent(p, r%state)
      call assertEqual(r%tangent(1, 1), tangent(1, 1), 0.0_wp, 'parted')
      call update_contact_point(p, (r%state), -1.0_wp, none, no_rotation, r)
      tangent = contact_tangent(p, r%state)
      call assertEqual(0.0_wp, maxval(abs(tangent)), 0.0_wp, 'open')
   end subroutine test_perturbation

   !> Pressure comes back where the point has been, and not before; what it was before does not
   !> matter; neither does a time without an opposite surface.
   subroutine test_memory()
      type(contact_properties) :: p
      type(contact_response) :: r, again
      type(contact_state) :: start
      type(normal_response) :: virgin
      real(wp) :: pressure
      integer :: i

      p = pair_properties(unloading=unloading_elastic)
      call update_contact_point(p, contact_state(), no_opposite_surface, none, no_rotation, r)
      call assertEqual(status_open, r%status, 'nothing opposite')
      call update_contact_point(p, (r%state), 0.05_wp, none, no_rotation, r)
      call update_contact_point(p, (r%state), 0.12_wp, none, no_rotation, r)
      call update_contact_point(p, contact_state(), 0.12_wp, none, no_rotation, again)
      call assertEqual(again%traction(1), r%traction(1), 0.0_wp, 'as pressed at once')
      pressure = r%traction(1)
      start = r%state
      do i = 1, 2
         call update_contact_point(p, start, merge(no_opposite_surface, 0.115_wp, i == 2), none, &
            no_rotation, r)
         call assertEqual(0.12_wp, r%state%largest_closure, 0.0_wp, 'remembered')
         call update_contact_point(p, (r%state), 0.115_wp, none, no_rotation, r)
         virgin = evaluate_normal_law(p%normal, p%initial_separation - 0.115_wp)
         call assertLessThan(r%traction(1), 0.7_wp*virgin%pressure, 'below the virgin branch')
         call update_contact_point(p, (r%state), 0.12_wp, none, no_rotation, r)
         call assertEqual(pressure, r%traction(1), 1.0e-14_wp*pressure, 'back where it was')
         call assertEqual(0.0_wp, r%plastic_dissipation, 0.0_wp, 'and no flatter')
      end do
      call update_contact_point(p, start, 0.06_wp, none, no_rotation, r)
      call assertEqual(status_open, r%status, 'the first closure is not reached again')
   end subroutine test_memory

   !> A point that opened closes again on its unloading branch, and slips from there on.
   subroutine test_closing()
      type(contact_properties) :: p
      type(contact_response) :: r
      type(contact_state) :: open
      type(normal_response) :: law
      real(wp) :: closing, near, far
      real(wp), parameter :: slip(2) = [0.02_wp, 0.0_wp], largest = 0.12_wp, end = 0.118_wp
      integer :: i

      p = pair_properties(unloading=unloading_elastic)
      call update_contact_point(p, contact_state(), largest, none, no_rotation, r)
      call update_contact_point(p, (r%state), 0.0_wp, none, no_rotation, r)
      open = r%state
      call assertEqual(status_open, r%status, 'open')
      near = 0.0_wp
      far = largest
      do i = 1, 60
         closing = 0.5_wp*(near + far)
         law = evaluate_unloading_law(p%normal, p%initial_separation - largest, closing)
         if (law%pressure > close_pressure_ratio*p%p_open) then
            near = closing
         else
            far = closing
         end if
      end do
      closing = largest - closing
      call update_contact_point(p, open, end, slip, no_rotation, r)
      call assertEqual(status_stick, r%status, 'closed')
      call assertEqual(slip(1)*(end - closing)/end, r%state%elastic_slip(1), 1.0e-13_wp, &
         'only the motion after closing counts')
      ! past where it has been
      call update_contact_point(p, open, 0.13_wp, slip, no_rotation, r)
      call assertEqual(slip(1)*(0.13_wp - closing)/0.13_wp, r%state%elastic_slip(1), 1.0e-13_wp, &
         'in one increment with new closure')
   end subroutine test_closing

   subroutine test_flag()
      type(contact_properties) :: p
      type(contact_response) :: r

      p = pair_properties(unloading=unloading_elastic)
      call update_contact_point(p, contact_state(), p%initial_separation, none, no_rotation, r)
      call assertEqual(0, iand(r%validity, memory_beyond_data), 'mean deformation 53 w1')
      call update_contact_point(p, (r%state), p%initial_separation + 3.0_wp*p%normal%sigma, none, &
         no_rotation, r)
      call assertEqual(memory_beyond_data, iand(r%validity, memory_beyond_data), '220 w1')
      call update_contact_point(p, (r%state), -1.0_wp, none, no_rotation, r)
      call assertEqual(memory_beyond_data, iand(r%state%validity, memory_beyond_data), 'kept')
   end subroutine test_flag

end module test_contact_memory
