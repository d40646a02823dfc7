!> The consistent tangent of the contact-point update against central differences, in random
!> directions and in every branch: step 1e-5 sigma, error relative to the norm of the row.
module test_contact_tangent
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, no_rotation, &
      rule_abaqus, rule_dissipative, slip_backward_euler, slip_exact, status_open, status_slip, &
      status_stick, update_contact_point, wp
   use contact_cases, only: pair_properties, random_contact
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_contact_tangent

   integer(int64), parameter :: seed = 17320508_int64
   real(wp), parameter :: step = 1.0e-5_wp, allowed = 1.0e-6_wp

contains

   function suite_contact_tangent() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('contact tangent')
      call suite%addTest(TestMethod('every branch, random directions', test_branches))
      call suite%addTest(TestMethod('both sides of the stick-slip corner', test_corner))
      call suite%addTest(TestMethod('unsymmetric coupling', test_coupling))
   end function suite_contact_tangent

   subroutine test_branches()
      integer, parameter :: n_branches = 6
      character(len=8), parameter :: names(n_branches) = [character(len=8) :: 'open', 'stick', &
         'slip', 'rising', 'falling', 'closing']
      type(random_stream) :: stream
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: overclosure, from, slip(2), direction(3), h, worst(n_branches), error
      integer :: i, branch, counts(n_branches), row

      stream = random_stream(seed)
      worst = 0.0_wp
      counts = 0
      do i = 1, 40000
         branch = 1 + mod(i, n_branches)
         call random_contact(stream, p, merge(rule_abaqus, rule_dissipative, mod(i/6, 2) == 0), &
            merge(slip_exact, slip_backward_euler, mod(i/12, 2) == 0))
         h = step*p%normal%sigma
         call prepare(stream, p, branch, start, from, overclosure, slip)
         direction = [stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp), &
            stream%uniform(-1.0_wp, 1.0_wp)]
         direction = direction/norm2(direction)
         call update_contact_point(p, start, overclosure, slip, no_rotation, r)
         call update_contact_point(p, start, overclosure + h*direction(1), slip + h*direction(2:), &
            no_rotation, ahead)
         call update_contact_point(p, start, overclosure - h*direction(1), slip - h*direction(2:), &
            no_rotation, behind)
         if (ahead%status /= behind%status) cycle
         if (.not. in_branch(branch, start, r)) cycle
         counts(branch) = counts(branch) + 1
         do row = 1, 3
            error = abs((ahead%traction(row) - behind%traction(row))/(2.0_wp*h) &
               - dot_product(r%tangent(row, :), direction))
            if (norm2(r%tangent(row, :)) > tiny(1.0_wp)) then
               call worsen(worst(branch), error/norm2(r%tangent(row, :)))
            else
               call assertEqual(0.0_wp, error, 0.0_wp, 'row of zeros: '//names(branch))
            end if
         end do
         if (anyExceptions()) return
      end do
      do branch = 1, n_branches
         call record('contact_point.tangent.'//trim(names(branch)), worst(branch))
         call assertLessThan(worst(branch), allowed, names(branch))
         call assertGreaterThan(counts(branch), 1000, message='cases of '//names(branch))
      end do
   end subroutine test_branches

   !> A start state and an increment that lead to the branch.
   subroutine prepare(stream, p, branch, start, from, overclosure, slip)
      type(random_stream), intent(inout) :: stream
      type(contact_properties), intent(in) :: p
      integer, intent(in) :: branch
      type(contact_state), intent(out) :: start
      real(wp), intent(out) :: from, overclosure, slip(2)
      type(contact_response) :: r
      real(wp) :: h, angle, length

      angle = stream%uniform(0.0_wp, 6.3_wp)
      length = stream%uniform(0.1_wp, 2.0_wp)
      from = p%initial_separation - stream%uniform(-1.0_wp, 3.0_wp)*p%normal%sigma
      h = stream%uniform(0.01_wp, 1.0_wp)*p%normal%sigma
      overclosure = from + merge(h, -h, stream%uniform(0.0_wp, 1.0_wp) > 0.5_wp)
      select case (branch)
      case (1)
         overclosure = p%initial_separation - stream%uniform(6.5_wp, 9.0_wp)*p%normal%sigma
      case (2)
         length = stream%uniform(0.0_wp, 0.4_wp)
      case (3)
         length = stream%uniform(1.6_wp, 4.0_wp)
      case (4)
         overclosure = from + h
      case (5)
         overclosure = from - h
      case default
         from = p%initial_separation - stream%uniform(7.0_wp, 9.0_wp)*p%normal%sigma
         overclosure = p%initial_separation - stream%uniform(-1.0_wp, 4.0_wp)*p%normal%sigma
      end select
      call update_contact_point(p, start, from, &
         p%critical_slip*[stream%uniform(-0.4_wp, 0.4_wp), stream%uniform(-0.4_wp, 0.4_wp)], &
         no_rotation, r)
      start = r%state
      slip = length*p%critical_slip*[cos(angle), sin(angle)]
   end subroutine prepare

   pure logical function in_branch(branch, start, r)
      integer, intent(in) :: branch
      type(contact_state), intent(in) :: start
      type(contact_response), intent(in) :: r

      select case (branch)
      case (1)
         in_branch = r%status == status_open
      case (2)
         in_branch = r%status == status_stick
      case (3)
         in_branch = r%status == status_slip
      case (6)
         in_branch = start%status == status_open .and. r%status /= status_open
      case default
         in_branch = start%status /= status_open .and. r%status /= status_open
      end select
   end function in_branch

   !> At the corner the two one-sided differences differ, and each equals the tangent of its side.
   subroutine test_corner()
      type(contact_properties) :: p
      type(contact_response) :: inside, outside, further
      real(wp) :: h, slope
      integer :: integration

      do integration = slip_exact, slip_backward_euler
         p = pair_properties(rule_abaqus, integration)
         h = step*p%normal%sigma
         call update_contact_point(p, contact_state(), 0.1_wp, [p%critical_slip - h, 0.0_wp], &
            no_rotation, inside)
         call update_contact_point(p, contact_state(), 0.1_wp, &
            [p%critical_slip - 3.0_wp*h, 0.0_wp], no_rotation, further)
         slope = (inside%traction(2) - further%traction(2))/(2.0_wp*h)
         call assertEqual(status_stick, inside%status, 'stick')
         call assertEqual(slope, inside%tangent(2, 2), allowed*slope, 'stick side')
         call update_contact_point(p, contact_state(), 0.1_wp, [p%critical_slip + h, 0.0_wp], &
            no_rotation, outside)
         call update_contact_point(p, contact_state(), 0.1_wp, &
            [p%critical_slip + 3.0_wp*h, 0.0_wp], no_rotation, further)
         call assertEqual(status_slip, outside%status, 'slip')
         call assertEqual((further%traction(2) - outside%traction(2))/(2.0_wp*h), &
            outside%tangent(2, 2), allowed*slope, 'slip side')
         call assertGreaterThan(inside%tangent(2, 2) - outside%tangent(2, 2), 0.9_wp*slope, &
            'they differ')
      end do
   end subroutine test_corner

   !> d tau/d overclosure = mu gamma/gcrit dp/du, and d p/d slip = 0.
   subroutine test_coupling()
      type(contact_properties) :: p
      type(contact_response) :: r
      real(wp) :: pressure_slope

      p = pair_properties()
      call update_contact_point(p, contact_state(), 0.1_wp, [0.2_wp, 0.0_wp], no_rotation, r)
      pressure_slope = r%tangent(1, 1)
      call assertEqual(p%friction_coefficient*0.2_wp/p%critical_slip*pressure_slope, &
         r%tangent(2, 1), 1.0e-13_wp*pressure_slope, 'shear by overclosure')
      call assertEqual([0.0_wp, 0.0_wp], r%tangent(1, 2:3), 0.0_wp, 'pressure by slip')
   end subroutine test_coupling

end module test_contact_tangent
