!> The contact-point update with the compiled law: against the direct one, its tangent, and one set
!> of properties in two threads.
module test_contact_compiled_points
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, contact_states, &
      error_type, evaluate_compiled_law, evaluate_normal_law, new_contact_properties, &
      new_contact_states, new_normal_properties, no_rotation, normal_properties, normal_response, &
      rule_dissipative, status_open, status_slip, update_contact_point, &
      update_contact_points, wp
   use asperity_law_validity, only: closure_above_half_radius
   use contact_cases, only: pair_properties
   use extremes, only: largest_of, worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      TestMethod, TestSuite
   use measurements, only: record
   use points_cases, only: compile, random_pair, random_slip
   use random_inputs, only: random_stream
   use threads, only: check_two_threads
   implicit none
   private
   public :: suite_compiled_points

   integer(int64), parameter :: seed = 26457513_int64
   integer, parameter :: thread_points = 200, thread_increments = 100

   !> Shared by the two threads, which only read it
   type(contact_properties) :: shared_properties

contains

   function suite_compiled_points() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('compiled points')
      call suite%addTest(TestMethod('numbers of the compiled law, bit by bit', test_law))
      call suite%addTest(TestMethod('as the direct law to 1e-10', test_direct))
      call suite%addTest(TestMethod('the same flags by every way, beyond 39 sigma too', test_flags))
      call suite%addTest(TestMethod('tangent by differences', test_tangent))
      call suite%addTest(TestMethod('two threads give the serial bits', test_threads))
   end function suite_compiled_points

   !> Direct law, compiled law, and a contact point with either. Far out summits in contact are
   !> pressed in by sigma/h on average, so that with a radius below 0.05 sigma the flag of half a
   !> radius is set up to 39 sigma; beyond, nothing touches and nothing is flagged.
   subroutine test_flags()
      type(random_stream) :: stream
      type(contact_properties) :: direct, compiled
      type(contact_response) :: r
      type(normal_properties) :: p
      type(normal_response) :: normal
      type(error_type), allocatable :: error
      real(wp) :: h(60), sigma, radius, separation, pressure, stiffness
      integer :: i, j, flags(4), far_flags, differ

      stream = random_stream(seed)
      far_flags = 0
      differ = 0
      do i = 1, 60
         sigma = stream%log_uniform(1.0e-3_wp, 0.1_wp)
         radius = sigma*stream%log_uniform(0.01_wp, 10.0_wp)
         call new_normal_properties(p, stream%log_uniform(0.03_wp, 4.0_wp)/(radius*sigma), &
            300.0_wp, radius, 25.0_wp, 0.4_wp, sigma, error)
         call assertFalse(allocated(error), 'properties')
         ! no datum between overclosure and separation, to have the same separation to the bit
         call new_contact_properties(direct, p, 0.5_wp, 0.3_wp, error, initial_separation=0.0_wp)
         call compile(direct, compiled)
         do j = 1, size(h)
            h(j) = stream%uniform(-10.0_wp, 50.0_wp)
         end do
         h(:5) = [nearest(39.0_wp, -1.0_wp), 39.0_wp, nearest(39.0_wp, 1.0_wp), 1.0e10_wp, 38.5_wp]
         do j = 1, size(h)
            separation = h(j)*sigma
            normal = evaluate_normal_law(p, separation)
            flags(1) = normal%validity
            call evaluate_compiled_law(compiled%compiled, separation, pressure, stiffness, &
               validity=flags(2))
            call update_contact_point(direct, contact_state(), -separation, [0.0_wp, 0.0_wp], &
               no_rotation, r)
            flags(3) = r%validity
            call update_contact_point(compiled, contact_state(), -separation, [0.0_wp, 0.0_wp], &
               no_rotation, r)
            flags(4) = r%validity
            if (any(flags /= flags(1))) differ = differ + 1
            if (separation > 39.0_wp*sigma) then
               call assertEqual(p%validity, flags(1), 'nothing touches')
            else if (h(j) > 38.0_wp) then
               far_flags = ior(far_flags, flags(1))
            end if
         end do
         if (anyExceptions()) return
      end do
      call assertEqual(0, differ, 'points with other flags')
      call assertEqual(closure_above_half_radius, iand(far_flags, closure_above_half_radius), &
         'flagged far out')
   end subroutine test_flags

   !> The compiled law is what is used: its last bits differ from the direct ones.
   subroutine test_law()
      integer, parameter :: n = 200
      type(contact_properties) :: p
      type(contact_response) :: r
      type(normal_response) :: direct
      real(wp) :: separation, pressure, stiffness, energy
      integer :: i, validity, differ

      call compile(pair_properties(), p)
      differ = 0
      do i = 1, n
         separation = p%normal%sigma*(0.05_wp*i - 3.0_wp)
         call evaluate_compiled_law(p%compiled, p%initial_separation &
            - (p%initial_separation - separation), pressure, stiffness, energy=energy, &
            validity=validity)
         call update_contact_point(p, contact_state(), p%initial_separation - separation, &
            [0.0_wp, 0.0_wp], no_rotation, r)
         call assertEqual([pressure, stiffness, energy], &
            [r%traction(1), r%tangent(1, 1), r%normal_energy], 0.0_wp, 'compiled')
         call assertEqual(validity, r%validity, 'validity')
         direct = evaluate_normal_law(p%normal, separation)
         if (abs(direct%pressure - pressure) > 0.0_wp) differ = differ + 1
      end do
      call assertGreaterThan(differ, n/4, message='differ from the direct law')
   end subroutine test_law

   !> Random paths, from -9 sigma, where the law is evaluated directly, to 8. Both updates start
   !> from the state that the compiled one left. Stresses and their tangent go with the pressure
   !> and the stiffness.
   subroutine test_direct()
      type(random_stream) :: stream
      type(contact_properties) :: direct, compiled
      type(contact_state) :: start
      type(contact_response) :: c, d
      real(wp) :: overclosure, slip(2), scale, worst(4)
      integer :: i, j, set

      stream = random_stream(seed)
      worst = 0.0_wp
      do set = 1, 200
         call random_pair(stream, set, direct, compiled)
         start = contact_state()
         do i = 1, 20
            overclosure = direct%initial_separation &
               - stream%uniform(-9.0_wp, 8.0_wp)*direct%normal%sigma
            slip = random_slip(stream, direct, 1.5_wp)
            call update_contact_point(compiled, start, overclosure, slip, no_rotation, c)
            call update_contact_point(direct, start, overclosure, slip, no_rotation, d)
            call assertEqual(d%status, c%status, 'status')
            call assertEqual(d%validity, c%validity, 'validity')
            call worsen(worst(1), largest_of(c%traction - d%traction)/d%traction(1))
            do j = 1, 3
               scale = norm2(d%tangent(j, :))
               if (scale > 0.0_wp) call worsen(worst(2), &
                  largest_of(c%tangent(j, :) - d%tangent(j, :))/scale)
            end do
            call worsen(worst(3), abs(c%normal_energy/d%normal_energy - 1.0_wp))
            scale = direct%friction_coefficient*(start%pressure + d%traction(1)) &
               *max(norm2(slip), direct%critical_slip)
            call worsen(worst(4), [abs(c%tangential_energy - d%tangential_energy)/scale, &
               abs(c%dissipation - d%dissipation)/scale, &
               abs(c%pressure_coupling - d%pressure_coupling)/scale])
            if (anyExceptions()) return
            start = c%state
         end do
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call record('compiled_points.traction', worst(1))
      call record('compiled_points.tangent', worst(2))
      call record('compiled_points.normal_energy', worst(3))
      call record('compiled_points.friction_energy', worst(4))
      call assertLessThan(maxval(worst), 1.0e-10_wp, 'relative difference')
   end subroutine test_direct

   !> Central differences in random directions, as for the direct law: step 1e-5 sigma, error
   !> relative to the norm of the row. Cases where the status changes within the step are left out.
   subroutine test_tangent()
      type(random_stream) :: stream
      type(contact_properties) :: direct, p
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: overclosure, slip(2), v(3), h, scale, worst
      integer :: i, row, cases(status_open:status_slip)

      stream = random_stream(seed + 2)
      worst = 0.0_wp
      cases = 0
      do i = 1, 4000
         if (mod(i, 10) == 1) call random_pair(stream, i/10, direct, p)
         h = 1.0e-5_wp*p%normal%sigma
         overclosure = p%initial_separation - stream%uniform(-2.0_wp, 8.0_wp)*p%normal%sigma
         call update_contact_point(p, contact_state(), overclosure, &
            random_slip(stream, p, 0.5_wp), no_rotation, r)
         start = r%state
         overclosure = overclosure + stream%uniform(-1.0_wp, 1.0_wp)*p%normal%sigma
         slip = random_slip(stream, p, 2.0_wp)
         v = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), &
            stream%uniform(-1.0_wp, 1.0_wp)]
         v = v/norm2(v)
         call update_contact_point(p, start, overclosure, slip, no_rotation, r)
         call update_contact_point(p, start, overclosure + h*v(1), slip + h*v(2:), no_rotation, &
            ahead)
         call update_contact_point(p, start, overclosure - h*v(1), slip - h*v(2:), no_rotation, &
            behind)
         if (ahead%status /= behind%status) cycle
         cases(r%status) = cases(r%status) + 1
         do row = 1, 3
            scale = norm2(r%tangent(row, :))
            if (scale > 0.0_wp) call worsen(worst, abs((ahead%traction(row) &
               - behind%traction(row))/(2.0_wp*h) - dot_product(r%tangent(row, :), v))/scale)
         end do
      end do
      call record('compiled_points.tangent_by_differences', worst)
      call assertGreaterThan(minval(cases), 500, message='cases of each status')
      call assertLessThan(worst, 1.0e-6_wp, 'largest error of a row')
   end subroutine test_tangent

   !> The same properties in both threads at once, and on different paths.
   subroutine test_threads()
      call compile(pair_properties(rule_dissipative), shared_properties)
      call check_two_threads(thread_work, 6)
   end subroutine test_threads

   !> Sums of stresses, energies and tangents over the path with that number.
   subroutine thread_work(number, sums)
      integer, intent(in) :: number
      real(wp), intent(out) :: sums(:)
      integer, parameter :: n = thread_points
      type(random_stream) :: stream
      type(contact_states) :: states
      type(error_type), allocatable :: error
      real(wp) :: overclosure(n), slip(n, 2), traction(n, 3), tangent(n, 3, 3), energy(n), loss(n)
      integer :: i, k

      stream = random_stream(seed + 10 + number)
      call new_contact_states(states, n, error)
      sums = 0.0_wp
      do i = 1, thread_increments
         do k = 1, n
            overclosure(k) = stream%uniform(-0.3_wp, 0.7_wp)
            slip(k, :) = random_slip(stream, shared_properties, 1.0_wp)
         end do
         call update_contact_points(shared_properties, states, overclosure, slip, traction, error, &
            tangent=tangent, tangential_energy=energy, dissipation=loss)
         if (allocated(error)) return
         sums = sums + [sum(traction, dim=1), sum(tangent), sum(energy + states%normal_energy), &
            sum(loss)]
      end do
   end subroutine thread_work

end module test_contact_compiled_points
