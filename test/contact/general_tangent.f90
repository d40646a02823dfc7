!> Friction beyond one coefficient: every derivative of a spring that slides against differences.
module test_contact_general_tangent
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, contact_tangent, &
      friction_settings, no_rotation, rule_abaqus, rule_dissipative, slip_backward_euler, &
      slip_exact, status_open, status_slip, status_stick, update_contact_point, wp
   use extremes, only: worsen
   use friction_cases, only: friction_properties, kinds, random_friction, spring, spring_slides
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_general_tangent

   integer, parameter :: rules(2) = [rule_abaqus, rule_dissipative], &
      integrations(2) = [slip_exact, slip_backward_euler]

contains

   function suite_general_tangent() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('general tangent')
      call suite%addTest(TestMethod('derivatives of every kind of friction', test_derivatives))
      call suite%addTest(TestMethod('derivatives of a side at the rate of before', test_same_rate))
      call suite%addTest(TestMethod('tangent about a state, for perturbations', test_base_tangent))
   end function suite_general_tangent

   !> Random paths that open and close, rise and fall: central differences, left out at corners,
   !> where the two one-sided ones differ; these are few.
   subroutine test_derivatives()
      real(wp), parameter :: h = 1.0e-7_wp, time = 0.7_wp
      integer(int64), parameter :: seed = 26457513_int64
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: overclosure, slip(2), step(3), worst, scale, forward(2), backward(2)
      integer :: i, j, k, kind, corners, counts(3), compared

      stream = random_stream(seed)
      do kind = 1, size(kinds)
         worst = 0.0_wp
         counts = 0
         corners = 0
         compared = 0
         do i = 1, 400
            p = friction_properties(friction_settings(), rules(1 + mod(i, 2)), &
               integrations(merge(1, 2, mod(i, 4) < 2)))
            call random_friction(stream, kind, p%friction_coefficient, p%critical_slip, settings)
            p = friction_properties(settings, p%friction_rule, p%slip_integration)
            start = contact_state()
            do k = 1, 20
               overclosure = stream%uniform(-0.01_wp, 0.06_wp)
               slip = p%critical_slip*stream%log_uniform(0.1_wp, 2.0_wp) &
                  *[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
               r = spring_slides(p, start, overclosure, slip, time)
               call assertGreaterThanOrEqual(r%dissipation, 0.0_wp, 'dissipation '//kinds(kind))
               if (overclosure > 2.0_wp*h) then
                  scale = spring*2.0_wp + 2.0_wp*r%traction(1)/p%critical_slip
                  do j = 1, 3
                     step = 0.0_wp
                     step(j) = h
                     ahead = spring_slides(p, start, overclosure + step(1), slip + step(2:), time)
                     behind = spring_slides(p, start, overclosure - step(1), slip - step(2:), time)
                     forward = (ahead%traction(2:) - r%traction(2:))/h
                     backward = (r%traction(2:) - behind%traction(2:))/h
                     compared = compared + 1
                     if (maxval(abs(forward - backward)) > 1.0e-4_wp*scale) then
                        corners = corners + 1
                        cycle
                     end if
                     call worsen(worst, &
                        maxval(abs(0.5_wp*(forward + backward) - r%tangent(2:, j)))/scale)
                  end do
                  if (r%status == status_stick) counts(1) = counts(1) + 1
                  if (r%status == status_slip) counts(2) = counts(2) + 1
                  if (start%status == status_open) counts(3) = counts(3) + 1
               end if
               start = r%state
            end do
            if (anyExceptions()) return
         end do
         call record('friction.general_tangent.'//key(kinds(kind)), worst)
         call assertLessThan(worst, 1.0e-6_wp, 'derivatives: '//kinds(kind))
         call assertLessThan(real(corners, wp), 0.002_wp*compared, 'corners: '//kinds(kind))
         call assertGreaterThan(minval(counts), 200, message='stick, slip, closing')
      end do
   end subroutine test_derivatives

   !> Two increments of one length and time, at rest and falling pressure: where the second begins
   !> at the end of slip, a higher rate shrinks the domain and a lower one lets it stick first. The
   !> derivatives are those of one of these sides.
   subroutine test_same_rate()
      real(wp), parameter :: h = 1.0e-7_wp, time = 0.7_wp
      integer(int64), parameter :: seed = 24494897_int64
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: p
      type(contact_state) :: start
      type(contact_response) :: r, ahead, behind
      real(wp) :: slip(2), turn, overclosure, step(2), forward(2), backward(2), scale, off, worst
      integer :: i, j, n, corners

      stream = random_stream(seed)
      worst = 0.0_wp
      corners = 0
      n = 0
      do i = 1, 2000
         p = friction_properties(friction_settings(), rules(1 + mod(i, 2)))
         call random_friction(stream, size(kinds), p%friction_coefficient, p%critical_slip, &
            settings)
         p = friction_properties(settings, p%friction_rule)
         overclosure = 0.05_wp
         slip = p%critical_slip*[stream%uniform(-3.0_wp, 3.0_wp), stream%uniform(-3.0_wp, 3.0_wp)]
         start = contact_state()
         r = spring_slides(p, start, overclosure, [0.0_wp, 0.0_wp], time)
         start = r%state
         r = spring_slides(p, start, overclosure, slip, time)
         if (r%status /= status_slip) cycle
         start = r%state
         turn = stream%uniform(-1.5_wp, 1.5_wp)
         slip = matmul(reshape([cos(turn), sin(turn), -sin(turn), cos(turn)], [2, 2]), slip)
         if (mod(i, 4) < 2) overclosure = 0.03_wp
         r = spring_slides(p, start, overclosure, slip, time)
         scale = spring*2.0_wp + 2.0_wp*r%traction(1)/p%critical_slip
         do j = 1, 2
            step = 0.0_wp
            step(j) = h
            ahead = spring_slides(p, start, overclosure, slip + step, time)
            behind = spring_slides(p, start, overclosure, slip - step, time)
            forward = (ahead%traction(2:) - r%traction(2:))/h
            backward = (r%traction(2:) - behind%traction(2:))/h
            if (maxval(abs(forward - backward)) > 1.0e-4_wp*scale) corners = corners + 1
            off = min(maxval(abs(forward - r%tangent(2:, 1 + j))), &
               maxval(abs(backward - r%tangent(2:, 1 + j))))
            call worsen(worst, off/scale)
            n = n + 1
         end do
      end do
      ! a one-sided difference is off by the curvature of the law over h
      call assertLessThan(worst, 1.0e-5_wp, 'derivatives of a side')
      call assertGreaterThan(corners, 100, message='corners')
      call assertGreaterThan(n, 2000, message='cases')
   end subroutine test_same_rate

   !> About a state that sticks, the tangent of a small motion with its pressure; about one that
   !> slips, its own motion on changes nothing, by either rule of slip.
   subroutine test_base_tangent()
      integer(int64), parameter :: seed = 31622776_int64
      real(wp), parameter :: h = 1.0e-7_wp
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: p
      type(contact_response) :: r, s
      real(wp) :: slip(2), tangent(3, 3), worst, along(2), across(2)
      integer :: i, kind

      stream = random_stream(seed)
      worst = 0.0_wp
      do kind = 1, size(kinds)
         do i = 1, 50
            call random_friction(stream, kind, 0.5_wp, 0.31_wp, settings)
            p = friction_properties(settings)
            slip = [stream%uniform(-0.1_wp, 0.1_wp), stream%uniform(-0.1_wp, 0.1_wp)]
            call update_contact_point(p, contact_state(), 0.1_wp, slip, no_rotation, r)
            tangent = contact_tangent(p, r%state)
            call update_contact_point(p, (r%state), 0.1_wp, [0.0_wp, 0.0_wp], no_rotation, s)
            call worsen(worst, maxval(abs(tangent - s%tangent))/maxval(abs(tangent)))
            ! steady slip: on in its direction the stress stays, without decay
            call update_contact_point(p, contact_state(), 0.1_wp, 1.0e9_wp*slip, no_rotation, r)
            call update_contact_point(p, (r%state), 0.1_wp, 1.0e9_wp*slip, no_rotation, r)
            call assertEqual(status_slip, r%status, 'slips')
            tangent = contact_tangent(p, r%state)
            along = slip/norm2(slip)
            across = [-along(2), along(1)]
            call worsen(worst, norm2(matmul(tangent(2:, 2:), along))/maxval(abs(tangent)))
            ! and a bit aside it turns; far aside a point with a fast decay sticks
            call update_contact_point(p, (r%state), 0.1_wp, h*(0.1_wp*across + along), &
               no_rotation, s)
            call worsen(worst, 1.0e-2_wp*norm2(0.1_wp*matmul(tangent(2:, 2:), across) &
               - (s%traction(2:) - r%traction(2:))/h)/maxval(abs(tangent)))
         end do
         if (anyExceptions()) return
      end do
      call assertLessThan(worst, 1.0e-8_wp, 'tangents')
   end subroutine test_base_tangent

   !> A name with underscores for blanks.
   pure function key(name)
      character(len=*), intent(in) :: name
      character(len=len_trim(name)) :: key
      integer :: i

      do i = 1, len(key)
         key(i:i) = merge('_', name(i:i), name(i:i) == ' ')
      end do
   end function key

end module test_contact_general_tangent
