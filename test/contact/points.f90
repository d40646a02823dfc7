!> The update of many contact points against the update of one, bit by bit.
module test_contact_points
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, contact_states, &
      error_type, friction_settings, get_contact_state, new_contact_states, no_rotation, &
      rule_abaqus, &
      rule_dissipative, slip_backward_euler, slip_exact, status_open, status_slip, status_stick, &
      status_unset, unloading_elastic, unloading_reversible, update_contact_point, &
      update_contact_points, wp
   use contact_cases, only: pair_properties, random_contact
   use friction_cases, only: friction_properties, kinds, random_friction
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertTrue, &
      TestMethod, TestSuite
   use points_cases, only: call_arguments, compile, numbers_of, random_arguments, update
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_points

   integer(int64), parameter :: seed = 16180339_int64

contains

   function suite_contact_points() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact points')
      call suite%addTest(TestMethod('as the update of one point, bit by bit', test_same))
      call suite%addTest(TestMethod('every choice of optional arguments', test_optional))
      call suite%addTest(TestMethod('no points and one point', test_few))
      call suite%addTest(TestMethod('friction that is not plain', test_friction))
   end function suite_contact_points

   !> Random paths of 30 points: both rules, both integrations, direct and compiled law, with memory
   !> and without; now and then no opposite surface, and a rotation that turns or stretches a bit.
   subroutine test_same()
      integer, parameter :: points = 30, increments = 20
      type(random_stream) :: stream
      type(contact_properties) :: p, direct
      type(contact_states) :: states
      type(contact_state) :: alone(points)
      type(call_arguments) :: a
      type(error_type), allocatable :: error
      integer :: set, i, seen(0:3)

      stream = random_stream(seed)
      seen = 0
      do set = 0, 63
         call random_contact(stream, p, merge(rule_dissipative, rule_abaqus, btest(set, 0)), &
            merge(slip_exact, slip_backward_euler, btest(set, 1)), &
            merge(unloading_elastic, unloading_reversible, btest(set, 5)))
         if (btest(set, 2)) then
            direct = p
            call compile(direct, p)
         end if
         call new_contact_states(states, points, error)
         alone = contact_state()
         do i = 1, increments
            call random_arguments(stream, p, points, a)
            if (i == 1 .or. btest(set, 3)) deallocate (a%rotation)
            call update(p, states, a, error)
            call assertFalse(allocated(error), 'accepted')
            call compare(p, alone, a, states, seen)
            if (anyExceptions()) return
         end do
      end do
      write (*, '(5x, a, i0)') 'seed ', seed
      call assertEqual(0, seen(status_unset), 'points that were not updated')
      call assertGreaterThan(seen(status_open), 2000, message='open points')
      call assertGreaterThan(seen(status_stick), 2000, message='sticking points')
      call assertGreaterThan(seen(status_slip), 2000, message='slipping points')
   end subroutine test_same

   !> All 64 choices give the same states and, where present, the same results.
   subroutine test_optional()
      integer, parameter :: points = 5
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_states) :: states
      type(contact_state) :: alone(points)
      type(call_arguments) :: a
      type(error_type), allocatable :: error
      integer :: choice, seen(0:3)

      stream = random_stream(seed + 1)
      p = pair_properties(rule_dissipative)
      call new_contact_states(states, points, error)
      alone = contact_state()
      do choice = 127, 0, -1
         call random_arguments(stream, p, points, a)
         if (.not. btest(choice, 0)) deallocate (a%rotation)
         if (.not. btest(choice, 1)) deallocate (a%tangent)
         if (.not. btest(choice, 2)) deallocate (a%tangential_energy)
         if (.not. btest(choice, 3)) deallocate (a%dissipation)
         if (.not. btest(choice, 4)) deallocate (a%coupling)
         if (.not. btest(choice, 5)) deallocate (a%validity)
         if (.not. btest(choice, 6)) deallocate (a%plastic)
         call update(p, states, a, error)
         call assertFalse(allocated(error), 'accepted')
         call compare(p, alone, a, states, seen)
         if (anyExceptions()) return
      end do
   end subroutine test_optional

   subroutine test_few()
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_states) :: states
      type(contact_state), allocatable :: alone(:)
      type(call_arguments) :: a
      type(error_type), allocatable :: error
      integer :: points, seen(0:3)

      stream = random_stream(seed + 2)
      p = pair_properties()
      do points = 0, 1
         call new_contact_states(states, points, error)
         call assertFalse(allocated(error), 'built')
         call assertEqual(points, size(states%elastic_slip, 1), 'points')
         allocate (alone(points))
         call random_arguments(stream, p, points, a)
         call update(p, states, a, error)
         call assertFalse(allocated(error), 'accepted')
         call compare(p, alone, a, states, seen)
         deallocate (alone)
      end do
   end subroutine test_few

   !> Advance the single points, and demand the same numbers of states and results.
   subroutine compare(p, alone, a, states, seen)
      type(contact_properties), intent(in) :: p
      type(contact_state), intent(inout) :: alone(:)
      type(call_arguments), intent(in) :: a
      type(contact_states), intent(in) :: states
      !> Count of each status
      integer, intent(inout) :: seen(0:3)
      type(contact_state) :: found
      type(contact_response) :: r
      real(wp) :: rotation(2, 2)
      integer :: i

      do i = 1, size(alone)
         rotation = no_rotation
         if (allocated(a%rotation)) rotation = a%rotation(i, :, :)
         call update_contact_point(p, alone(i), a%overclosure(i), a%slip(i, :), rotation, r)
         alone(i) = r%state
         seen(r%status) = seen(r%status) + 1
         found = get_contact_state(states, i)
         call assertEqual(numbers_of(r%state), numbers_of(found), 0.0_wp, 'state')
         call assertEqual(r%traction, a%traction(i, :), 0.0_wp, 'traction')
         if (allocated(a%tangent)) call assertEqual(reshape(r%tangent, [9]), &
            reshape(a%tangent(i, :, :), [9]), 0.0_wp, 'tangent')
         if (allocated(a%tangential_energy)) call assertEqual(r%tangential_energy, &
            a%tangential_energy(i), 0.0_wp, 'tangential energy')
         if (allocated(a%dissipation)) &
            call assertEqual(r%dissipation, a%dissipation(i), 0.0_wp, 'dissipation')
         if (allocated(a%plastic)) call assertEqual(r%plastic_dissipation, a%plastic(i), 0.0_wp, &
            'plastic dissipation')
         if (allocated(a%coupling)) &
            call assertEqual(r%pressure_coupling, a%coupling(i), 0.0_wp, 'pressure coupling')
         if (allocated(a%validity)) call assertEqual(r%validity, a%validity(i), 'validity')
      end do
   end subroutine compare

   !> Every kind of friction: tractions and states as one point has them, bit by bit; plain friction
   !> keeps no arrays for it.
   subroutine test_friction()
      integer, parameter :: points = 7, increments = 15
      real(wp), parameter :: time = 0.3_wp
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: p
      type(contact_states) :: states
      type(contact_state) :: alone(points), found
      type(contact_response) :: r
      type(error_type), allocatable :: error
      real(wp) :: overclosure(points), slip(points, 2), traction(points, 3)
      real(wp) :: turn(points, 2, 2), angle
      integer :: kind, i, j

      stream = random_stream(seed + 7)
      do kind = 0, size(kinds)
         settings = friction_settings()
         if (kind > 0) call random_friction(stream, kind, 0.5_wp, 0.31_wp, settings)
         p = friction_properties(settings)
         call new_contact_states(states, points, error)
         alone = contact_state()
         do i = 1, increments
            do j = 1, points
               overclosure(j) = stream%uniform(-0.05_wp, 0.15_wp)
               slip(j, :) = [stream%uniform(-0.4_wp, 0.4_wp), stream%uniform(-0.4_wp, 0.4_wp)]
               angle = stream%uniform(-0.3_wp, 0.3_wp)
               turn(j, :, :) = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
            end do
            call update_contact_points(p, states, overclosure, slip, traction, error, &
               rotation=turn, time_increment=time)
            call assertFalse(allocated(error), 'updated')
            do j = 1, points
               call update_contact_point(p, alone(j), overclosure(j), slip(j, :), turn(j, :, :), &
                  r, time)
               alone(j) = r%state
               found = get_contact_state(states, j)
               call assertEqual(0.0_wp, maxval(abs(r%traction - traction(j, :))), 0.0_wp, &
                  'traction')
               call assertEqual(alone(j)%motion_share, found%motion_share, 0.0_wp, 'share')
               call assertEqual(alone(j)%grain_turn, found%grain_turn, 0.0_wp, 'turn')
            end do
            if (anyExceptions()) return
         end do
         call assertTrue(allocated(states%grain_turn) .eqv. kind > 0, 'arrays')
         call assertFalse(allocated(states%summit_slip), 'summits')
      end do
   end subroutine test_friction

end module test_contact_points
