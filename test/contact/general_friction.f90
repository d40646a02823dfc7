!> Friction beyond one coefficient against closed forms, on faces that close like a spring: rest and
!> motion, slip rate, an ellipse, pressure; two halves, plain limits, turning slip directions.
module test_contact_general_friction
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, friction_settings, &
      no_rotation, rule_abaqus, rule_dissipative, slip_backward_euler, slip_direction_associated, &
      slip_direction_of_stress, slip_exact, status_slip, status_stick, update_contact_point, wp
   use extremes, only: worsen
   use friction_cases, only: friction_properties, kinds, random_friction, spring, spring_slides
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertLessThan, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_general_friction

   !> Of the pair; overclosure and pressure of the spring
   real(wp), parameter :: mu = 0.5_wp, g = 0.31_wp, closed = 0.01_wp, p = spring*closed

contains

   function suite_general_friction() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('general friction')
      call suite%addTest(TestMethod('a peak at rest and its decay by slip', test_decay_by_slip))
      call suite%addTest(TestMethod('elastic travel renews rest, noise does not', test_renewal))
      call suite%addTest(TestMethod('steady slip at a rate', test_rate))
      call suite%addTest(TestMethod('steady slip on an ellipse, both rules', test_ellipse))
      call suite%addTest(TestMethod('plateaus by pressure', test_plateaus))
      call suite%addTest(TestMethod('two halves equal one in one dimension', test_halves))
      call suite%addTest(TestMethod('settings that say nothing are plain friction', test_plain))
      call suite%addTest(TestMethod('grain that turns with the face', test_turning))
   end function suite_general_friction

   !> mu_s p at rest, then mu_k p + (mu_s - mu_k) p exp(-l/decay_slip), with l = motion - tau/k;
   !> friction times slip is lost. A decay faster than elastic slip drops at once to the lower of
   !> the two stresses that the motion has.
   subroutine test_decay_by_slip()
      real(wp), parameter :: static = 0.8_wp, decays(3) = [2.0_wp, 0.2_wp, 0.02_wp]
      type(contact_properties) :: c
      type(contact_response) :: r
      real(wp) :: motion, slipped, expected, worst, k, lost
      integer :: i, n

      worst = 0.0_wp
      k = static*p/g
      do n = 1, size(decays)
         c = friction_properties(friction_settings(static_friction_coefficient=static, &
            decay_slip=decays(n)))
         r = spring_slides(c, contact_state(), closed, [g, 0.0_wp])
         call assertEqual(status_stick, r%status, 'sticks up to gcrit')
         call assertEqual(static*p, r%traction(2), 1.0e-15_wp, 'peak')
         motion = g
         do i = 1, 60
            r = spring_slides(c, r%state, closed, [0.007_wp*i, 0.0_wp])
            motion = motion + 0.007_wp*i
            slipped = motion - r%traction(2)/k
            associate (fade => exp(-slipped/decays(n)))
               expected = p*(mu + (static - mu)*fade)
               call worsen(worst, abs(r%traction(2) - expected)/p)
               call worsen(worst, abs(r%state%motion_share - (1.0_wp - fade)))
               lost = p*(mu*slipped + (static - mu)*decays(n)*(1.0_wp - fade))
            end associate
            if (n == 1) call worsen(worst, abs(r%state%dissipation - lost)/lost)
            call assertEqual(status_slip, r%status, 'slips')
         end do
      end do
      call record('friction.decay_by_slip', worst)
      call assertLessThan(worst, 1.0e-13_wp, 'decay')
   end subroutine test_decay_by_slip

   !> Back from motion, the point sticks while |gamma| is below g (mu_k + (mu_s - mu_k) (1 - m
   !> exp(-s/(decay_slip + g - g mu_k/mu_s))))/mu_s after a travel s. Motions of round-off renew
   !> nothing.
   subroutine test_renewal()
      real(wp), parameter :: static = 0.8_wp, decay = 0.4_wp, small = 1.0e-9_wp
      type(contact_properties) :: c
      type(contact_response) :: moved, r
      real(wp) :: travel, low, high, radius, share
      integer :: i

      c = friction_properties(friction_settings(static_friction_coefficient=static, &
         decay_slip=decay))
      moved = spring_slides(c, contact_state(), closed, [2.0_wp, 0.0_wp])
      low = 0.0_wp
      high = 3.0_wp*g
      do i = 1, 100
         travel = 0.5_wp*(low + high)
         share = moved%state%motion_share*exp(-travel/(decay + g*(1.0_wp - mu/static)))
         radius = g*(mu + (static - mu)*(1.0_wp - share))/static
         if (travel - moved%state%elastic_slip(1) > radius) then
            high = travel
         else
            low = travel
         end if
      end do
      r = spring_slides(c, moved%state, closed, [small - travel, 0.0_wp])
      call assertEqual(status_stick, r%status, 'sticks')
      call assertEqual(share, r%state%motion_share, 1.0e-8_wp, 'renewed')
      r = spring_slides(c, moved%state, closed, [-small - travel, 0.0_wp])
      call assertEqual(status_slip, r%status, 'slips')
      call assertEqual(-static*p/g*radius, r%traction(2), 1.0e-8_wp, 'the other peak')

      r = moved
      do i = 1, 2000
         r = spring_slides(c, r%state, closed, [merge(-1.0e-13_wp, 1.0e-13_wp, mod(i, 2) == 0), &
            0.0_wp])
      end do
      call assertEqual(moved%state%motion_share, r%state%motion_share, 1.0e-9_wp, 'noise')
      call assertEqual(moved%traction(2), r%traction(2), 1.0e-9_wp, 'noise')
   end subroutine test_renewal

   !> At a steady rate v mu = mu_k + (mu_s - mu_k) exp(-v/decay_slip_rate), whatever the size of the
   !> increments; without time mu_s. Stopping changes nothing; a sudden rate lets elastic slip go,
   !> whose energy is lost.
   subroutine test_rate()
      real(wp), parameter :: static = 0.8_wp, decay_rate = 1.5_wp, rates(3) = &
         [0.1_wp, 1.0_wp, 20.0_wp], times(3) = [1.0e-4_wp, 1.0e-2_wp, 1.0_wp]
      type(contact_properties) :: c
      type(contact_response) :: r, stopped, slow
      real(wp) :: mu_v, worst, motion
      integer :: i, j

      c = friction_properties(friction_settings(static_friction_coefficient=static, &
         decay_slip_rate=decay_rate))
      worst = 0.0_wp
      do j = 1, size(times)
         do i = 1, size(rates)
            mu_v = mu + (static - mu)*exp(-rates(i)/decay_rate)
            r = contact_response()
            motion = 0.0_wp
            do while (motion < 2.0_wp*g)
               r = spring_slides(c, r%state, closed, [rates(i)*times(j), 0.0_wp], times(j))
               motion = motion + rates(i)*times(j)
            end do
            call worsen(worst, abs(r%traction(2) - mu_v*p)/p)
            stopped = spring_slides(c, r%state, closed, [0.0_wp, 0.0_wp], times(j))
            call worsen(worst, abs(stopped%traction(2) - r%traction(2))/p)
            call assertEqual(0.0_wp, stopped%dissipation, 0.0_wp, 'rest costs nothing')
         end do
      end do
      slow = spring_slides(c, contact_state(), closed, [2.0_wp*g, 0.0_wp])
      call worsen(worst, abs(slow%traction(2) - static*p)/p)
      motion = 1.0e-9_wp
      r = spring_slides(c, slow%state, closed, [motion, 0.0_wp], motion/20.0_wp)
      call worsen(worst, abs(slow%tangential_energy + motion*r%traction(2) - r%tangential_energy &
         - r%dissipation)/slow%tangential_energy)
      call record('friction.decay_by_rate', worst)
      call assertLessThan(worst, 1.0e-13_wp, 'steady slip')
   end subroutine test_rate

   !> Along e, with m_i = mu_i p in the axes of the grain: tau_i = m_i^2 e_i/sqrt(sum m_i^2 e_i^2)
   !> where slip is normal to the ellipse, e/sqrt(sum e_i^2/m_i^2) where it goes along the stress.
   subroutine test_ellipse()
      real(wp), parameter :: across = 0.2_wp, degree = 0.017453292519943295_wp
      type(contact_properties) :: c
      type(contact_response) :: r
      real(wp) :: e(2), m(2), expected(2), found(2), grain, angle, worst, axes(2, 2)
      integer :: i, j, rule

      worst = 0.0_wp
      m = p*[mu, across]
      do rule = slip_direction_associated, slip_direction_of_stress
         do i = 0, 35
            grain = 20.0_wp*i - 350.0_wp
            c = friction_properties(friction_settings(friction_coefficient_across=across, &
               grain_angle=grain, slip_direction=rule))
            angle = 0.7_wp*i
            r = contact_response()
            do j = 1, 400
               r = spring_slides(c, r%state, closed, 0.1_wp*[cos(angle), sin(angle)])
            end do
            axes = reshape([cos(grain*degree), sin(grain*degree), -sin(grain*degree), &
               cos(grain*degree)], [2, 2])
            e = matmul([cos(angle), sin(angle)], axes)
            found = matmul(r%traction(2:), axes)
            expected = e/norm2(e/m)
            if (rule == slip_direction_associated) expected = m**2*e/norm2(m*e)
            call worsen(worst, norm2(found - expected)/p)
            call worsen(worst, abs(norm2(found/m) - 1.0_wp))
         end do
      end do
      call record('friction.ellipse', worst)
      call assertLessThan(worst, 1.0e-12_wp, 'steady slip')
   end subroutine test_ellipse

   !> Plateaus of the power, the points and the limit; rest and across have the same factor.
   subroutine test_plateaus()
      real(wp), parameter :: overclosures(4) = [0.0125_wp, 0.025_wp, 0.0375_wp, 0.1_wp]
      type(friction_settings) :: by_points
      type(contact_properties) :: c
      type(contact_response) :: r
      real(wp) :: pressure
      integer :: i

      by_points = friction_settings(friction_points=3)
      by_points%friction_pressures(:3) = [1.0_wp, 2.0_wp, 3.0_wp]
      by_points%friction_factors(:3) = [1.2_wp, 0.8_wp, 0.7_wp]
      do i = 1, size(overclosures)
         pressure = spring*overclosures(i)
         c = friction_properties(friction_settings(pressure_exponent=-0.25_wp, &
            reference_pressure=2.0_wp))
         r = spring_slides(c, contact_state(), overclosures(i), [1.0_wp, 0.0_wp])
         call assertEqual(mu*pressure*(pressure/2.0_wp)**(-0.25_wp), r%traction(2), 1.0e-14_wp, &
            'power')
         c = friction_properties(friction_settings(shear_limit=0.6_wp, &
            friction_coefficient_across=0.25_wp))
         r = spring_slides(c, contact_state(), overclosures(i), [1.0_wp, 0.0_wp])
         call assertEqual(min(mu*pressure, 0.6_wp), r%traction(2), 1.0e-14_wp, 'limit')
         r = spring_slides(c, contact_state(), overclosures(i), [0.0_wp, 1.0_wp])
         call assertEqual(0.5_wp*min(mu*pressure, 0.6_wp), r%traction(3), 1.0e-14_wp, 'across')
         c = friction_properties(by_points)
         r = spring_slides(c, contact_state(), overclosures(i), [0.0_wp, -1.0_wp])
         associate (factors => [1.2_wp*0.5_wp, 1.2_wp, 1.0_wp, 0.7_wp])
            if (i == 1) then
               call assertEqual(-1.2_wp*mu*pressure, r%traction(3), 1.0e-14_wp, 'below')
            else if (i == 2) then
               call assertEqual(-1.2_wp*mu*pressure, r%traction(3), 1.0e-14_wp, 'first')
            else if (i == 3) then
               call assertEqual(-factors(3)*mu*pressure, r%traction(3), 1.0e-14_wp, 'between')
            else
               call assertEqual(-0.7_wp*mu*pressure, r%traction(3), 1.0e-14_wp, 'above')
            end if
         end associate
      end do
   end subroutine test_plateaus

   !> Any kind, along the grain: state and ledgers of one increment and of its halves. The pressure
   !> is that of the start.
   subroutine test_halves()
      integer(int64), parameter :: seed = 14142135_int64
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: c
      type(contact_response) :: one, half, two
      real(wp) :: slip(2), worst, time, lost
      integer :: i, kind, k

      stream = random_stream(seed)
      worst = 0.0_wp
      do kind = 1, size(kinds)
         do i = 1, 200
            call random_friction(stream, kind, mu, g, settings)
            settings%grain_angle = 0.0_wp
            c = friction_properties(settings)
            one = spring_slides(c, contact_state(), closed, [0.0_wp, 0.0_wp])
            do k = 1, 20
               time = stream%log_uniform(0.1_wp, 10.0_wp)
               slip = [stream%uniform(-1.5_wp, 1.5_wp), 0.0_wp]*g
               half = spring_slides(c, one%state, closed, 0.5_wp*slip, 0.5_wp*time)
               two = spring_slides(c, half%state, closed, 0.5_wp*slip, 0.5_wp*time)
               lost = half%dissipation + two%dissipation
               one = spring_slides(c, one%state, closed, slip, time)
               call worsen(worst, abs(one%traction(2) - two%traction(2)))
               call worsen(worst, abs(one%state%motion_share - two%state%motion_share))
               call worsen(worst, abs(one%dissipation - lost))
            end do
         end do
         if (anyExceptions()) return
      end do
      call record('friction.general_halves', worst)
      call assertLessThan(worst, 1.0e-12_wp, 'one and two')
   end subroutine test_halves

   !> An excess at rest of zero, a coefficient across like that along, a limit out of reach: plain
   !> friction by backward Euler, or exactly where nothing changes the coefficient.
   subroutine test_plain()
      integer(int64), parameter :: seed = 17320508_int64
      type(friction_settings) :: nothings(4)
      type(contact_properties) :: c, plain
      type(contact_response) :: r, s
      type(random_stream) :: stream
      real(wp) :: overclosure, slip(2), worst
      integer :: i, k, n, rule, integration

      nothings(1)%static_friction_coefficient = mu
      nothings(1)%decay_slip = 0.1_wp
      nothings(1)%decay_slip_rate = 0.1_wp
      nothings(2)%friction_coefficient_across = mu
      nothings(2)%grain_angle = 33.0_wp
      nothings(3)%shear_limit = 1.0e3_wp
      nothings(4)%friction_points = 1
      nothings(4)%friction_pressures(1) = 1.0_wp
      nothings(4)%friction_factors(1) = 1.0_wp
      stream = random_stream(seed)
      worst = 0.0_wp
      do n = 1, size(nothings)
         do rule = rule_abaqus, rule_dissipative
            do integration = merge(slip_backward_euler, slip_exact, n <= 2), slip_backward_euler
               c = friction_properties(nothings(n), rule, integration)
               plain = friction_properties(friction_settings(), rule, integration)
               do i = 1, 50
                  r = contact_response()
                  s = contact_response()
                  do k = 1, 20
                     overclosure = stream%uniform(-0.01_wp, 0.05_wp)
                     slip = g*[stream%uniform(-1.5_wp, 1.5_wp), stream%uniform(-1.5_wp, 1.5_wp)]
                     r = spring_slides(c, r%state, overclosure, slip, 0.3_wp)
                     s = spring_slides(plain, s%state, overclosure, slip)
                     call assertEqual(s%status, r%status, 'status')
                     call worsen(worst, maxval(abs(r%traction - s%traction)))
                     call worsen(worst, maxval(abs(r%tangent - s%tangent)))
                     call worsen(worst, abs(r%tangential_energy - s%tangential_energy))
                     call worsen(worst, abs(r%dissipation - s%dissipation))
                     call worsen(worst, abs(r%pressure_coupling - s%pressure_coupling))
                  end do
               end do
               if (anyExceptions()) return
            end do
         end do
      end do
      call record('friction.general_plain', worst)
      call assertLessThan(worst, 1.0e-12_wp, 'plain')
   end subroutine test_plain

   !> The same path in slip directions that stay and in some that turn: tractions turn with them,
   !> and the grain, whose angle is the same at the start, turns with the face.
   subroutine test_turning()
      integer(int64), parameter :: seed = 22360679_int64
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: c
      type(contact_response) :: r, s
      real(wp) :: overclosure, slip(2), worst, turn(2, 2), whole(2, 2), angle, all_turns
      integer :: i, k, kind

      stream = random_stream(seed)
      worst = 0.0_wp
      do kind = 1, size(kinds)
         do i = 1, 40
            call random_friction(stream, kind, mu, g, settings)
            c = friction_properties(settings, merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0))
            r = contact_response()
            s = contact_response()
            whole = no_rotation
            all_turns = 0.0_wp
            do k = 1, 20
               overclosure = stream%uniform(-0.01_wp, 0.15_wp)
               slip = g*[stream%uniform(-1.0_wp, 1.0_wp), stream%uniform(-1.0_wp, 1.0_wp)]
               angle = stream%uniform(-0.5_wp, 0.5_wp)
               all_turns = all_turns + angle
               turn = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
               whole = matmul(turn, whole)
               call update_contact_point(c, (r%state), overclosure, slip, no_rotation, r, 0.2_wp)
               call update_contact_point(c, (s%state), overclosure, matmul(whole, slip), turn, s, &
                  0.2_wp)
               call worsen(worst, maxval(abs(matmul(whole, r%traction(2:)) - s%traction(2:))))
               call worsen(worst, maxval(abs(matmul(whole, r%tangent(2:, 1)) - s%tangent(2:, 1))))
               call worsen(worst, maxval(abs(matmul(whole, r%tangent(2:, 2:)) &
                  - matmul(s%tangent(2:, 2:), whole))))
               call worsen(worst, abs(all_turns - s%state%grain_turn))
            end do
         end do
         if (anyExceptions()) return
      end do
      call record('friction.turning', worst)
      call assertLessThan(worst, 1.0e-11_wp, 'frame')
      call assertGreaterThan(size(kinds), 8, message='kinds')
   end subroutine test_turning

end module test_contact_general_friction
