!> The path of the elastic slip: exact integration, backward Euler, and their derivatives.
module test_contact_slip_path
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: slip_backward_euler, slip_exact, wp
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use extremes, only: worsen
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, &
      assertGreaterThanOrEqual, assertLessThan, assertTrue, TestMethod, &
      TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_slip_path

   real(wp), parameter :: g = 0.31_wp, pi = acos(-1.0_wp)
   integer(int64), parameter :: seed = 27182818_int64

contains

   function suite_slip_path() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('slip path')
      call suite%addTest(TestMethod('one direction: stick, slip, reversal', test_one_direction))
      call suite%addTest(TestMethod('two directions: against the differential equation', test_ode))
      call suite%addTest(TestMethod('two half increments equal one', test_halves))
      call suite%addTest(TestMethod('degenerate directions', test_degenerate))
      call suite%addTest(TestMethod('the smallest reversal', test_reversal))
      call suite%addTest(TestMethod('creeping outwards', test_creep))
      call suite%addTest(TestMethod('dissipation is g ln(sin theta0/sin theta)', test_slipped))
      call suite%addTest(TestMethod('derivatives against differences', test_derivatives))
      call suite%addTest(TestMethod('corner between stick and slip', test_corner))
      call suite%addTest(TestMethod('backward Euler: radial return and its error', test_radial))
   end function suite_slip_path

   !> A sawtooth in one direction has the exact elastic slip max(-g, min(g, ...)).
   subroutine test_one_direction()
      real(wp), parameter :: increments(5) = [0.2_wp, 0.5_wp, -0.3_wp, -0.9_wp, 0.1_wp]
      real(wp) :: gamma, elastic(2), slipped
      type(slip_path) :: path
      integer :: i, scheme

      do scheme = slip_exact, slip_backward_euler
         gamma = 0.0_wp
         elastic = 0.0_wp
         do i = 1, size(increments)
            path = integrate_slip(elastic, [increments(i), 0.0_wp], g, scheme)
            slipped = max(abs(gamma + increments(i)) - g, 0.0_wp)
            gamma = max(-g, min(g, gamma + increments(i)))
            elastic = path%elastic_slip
            call assertEqual([gamma, 0.0_wp], elastic, 1.0e-15_wp, 'elastic slip')
            call assertEqual(slipped, path%slipped, 1.0e-15_wp, 'slipped length')
            call assertTrue(path%slips .eqv. slipped > 0.0_wp, 'status')
         end do
      end do
   end subroutine test_one_direction

   !> On the circle d gamma/ds = e - (e.gamma) gamma/g^2: Runge-Kutta with 4000 steps, whose own
   !> error is below 1e-12 g.
   subroutine test_ode()
      type(random_stream) :: stream
      type(slip_path) :: path
      real(wp) :: gamma(2), e(2), k1(2), k2(2), k3(2), k4(2), angle, ds, length
      integer :: i, j
      integer, parameter :: steps = 4000

      stream = random_stream(seed)
      do i = 1, 20
         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         e = [cos(angle), sin(angle)]
         angle = angle + stream%uniform(-0.5_wp*pi, 0.5_wp*pi)
         gamma = g*[cos(angle), sin(angle)]
         length = stream%uniform(0.1_wp, 5.0_wp)*g
         path = integrate_slip(gamma, length*e, g, slip_exact)
         ds = length/steps
         do j = 1, steps
            k1 = rate(gamma, e)
            k2 = rate(gamma + 0.5_wp*ds*k1, e)
            k3 = rate(gamma + 0.5_wp*ds*k2, e)
            k4 = rate(gamma + ds*k3, e)
            gamma = gamma + ds/6.0_wp*(k1 + 2.0_wp*k2 + 2.0_wp*k3 + k4)
         end do
         call assertEqual(gamma, path%elastic_slip, 1.0e-11_wp*g, 'elastic slip')
         if (anyExceptions()) return
      end do

   contains

      pure function rate(gamma, e)
         real(wp), intent(in) :: gamma(2), e(2)
         real(wp) :: rate(2)

         rate = e - dot_product(e, gamma)*gamma/g**2
      end function rate

   end subroutine test_ode

   subroutine test_halves()
      type(random_stream) :: stream
      type(slip_path) :: whole, first, second
      real(wp) :: start(2), increment(2), part, worst, worst_slipped
      integer :: i

      stream = random_stream(seed)
      worst = 0.0_wp
      worst_slipped = 0.0_wp
      do i = 1, 100000
         call random_slip(stream, start, increment)
         part = stream%uniform(0.0_wp, 1.0_wp)
         whole = integrate_slip(start, increment, g, slip_exact)
         first = integrate_slip(start, part*increment, g, slip_exact)
         second = integrate_slip(first%elastic_slip, (1.0_wp - part)*increment, g, slip_exact)
         call worsen(worst, norm2(whole%elastic_slip - second%elastic_slip)/g)
         call worsen(worst_slipped, &
            abs(whole%slipped - first%slipped - second%slipped)/(g + norm2(increment)))
      end do
      call record('friction.halves.slip', worst)
      call record('friction.halves.dissipation', worst_slipped)
      call assertLessThan(worst, 1.0e-14_wp, 'elastic slip')
      call assertLessThan(worst_slipped, 1.0e-14_wp, 'dissipation')
   end subroutine test_halves

   subroutine test_degenerate()
      type(slip_path) :: path
      real(wp), parameter :: s = 0.7_wp
      real(wp) :: theta

      path = integrate_slip([g, 0.0_wp], [s, 0.0_wp], g, slip_exact)
      call assertEqual([g, 0.0_wp], path%elastic_slip, 1.0e-16_wp, 'along the slip')
      call assertEqual(s, path%slipped, 1.0e-15_wp, 'along the slip: dissipation')

      path = integrate_slip([g, 0.0_wp], [-s - 2.0_wp*g, 0.0_wp], g, slip_exact)
      call assertEqual([-g, 0.0_wp], path%elastic_slip, 1.0e-16_wp, 'reversal')
      call assertEqual(s, path%slipped, 1.0e-15_wp, 'reversal: dissipation')

      ! at right angles tan(theta/2) = exp(-s/g), with theta from the motion
      path = integrate_slip([g, 0.0_wp], [0.0_wp, s], g, slip_exact)
      theta = 2.0_wp*atan(exp(-s/g))
      call assertEqual(g*[sin(theta), cos(theta)], path%elastic_slip, 1.0e-15_wp, 'right angle')
      call assertEqual(-g*log(sin(theta)), path%slipped, 1.0e-15_wp, 'right angle: dissipation')

      path = integrate_slip([0.0_wp, 0.0_wp], [0.0_wp, 0.0_wp], g, slip_exact)
      call assertEqual([0.0_wp, 0.0_wp], path%elastic_slip, 0.0_wp, 'no motion at rest')
      path = integrate_slip([g, 0.0_wp], [0.0_wp, 0.0_wp], g, slip_exact)
      call assertEqual([g, 0.0_wp], path%elastic_slip, 0.0_wp, 'no motion on the circle')
      call assertFalse(path%slips, 'no motion does not slip')

      path = integrate_slip([0.0_wp, 0.0_wp], [1.0e6_wp, 1.0e6_wp], g, slip_exact)
      call assertEqual(g*sqrt(0.5_wp)*[1.0_wp, 1.0_wp], path%elastic_slip, 1.0e-15_wp, 'far')
      path = integrate_slip(g*[0.6_wp, 0.8_wp], [1.0e-13_wp, 0.0_wp], g, slip_exact)
      call assertEqual(g*[0.6_wp, 0.8_wp] + 1.0e-13_wp*[0.64_wp, -0.48_wp], path%elastic_slip, &
         1.0e-16_wp, 'tiny step follows the tangent')
      call assertEqual(reshape([0.64_wp, -0.48_wp, -0.48_wp, 0.36_wp], [4]), &
         reshape(path%by_increment, [4]), 1.0e-9_wp, 'tiny step: derivative is the projection')
   end subroutine test_degenerate

   !> After slip the elastic slip may lie outside the circle by round-off; the smallest motion back
   !> must not carry it across.
   subroutine test_reversal()
      type(random_stream) :: stream
      type(slip_path) :: path, back
      real(wp) :: angle, e(2), size
      integer :: i, scheme

      stream = random_stream(seed)
      do i = 1, 20000
         scheme = merge(slip_exact, slip_backward_euler, mod(i, 2) == 0)
         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         e = [cos(angle), sin(angle)]
         path = integrate_slip([0.0_wp, 0.0_wp], 3.0_wp*g*e, g, scheme)
         size = stream%log_uniform(1.0e-40_wp, 1.0e-3_wp)
         back = integrate_slip(path%elastic_slip, -size*e, g, scheme)
         call assertEqual(path%elastic_slip - size*e, back%elastic_slip, 1.0e-15_wp, 'reversal')
         if (anyExceptions()) return
      end do
   end subroutine test_reversal

   !> Motion by less than the elastic slip is rounded to, again and again, slips like any other: it
   !> does not creep out of the circle.
   subroutine test_creep()
      real(wp), parameter :: step(2) = [0.9_wp*epsilon(1.0_wp)*g, 0.0_wp]
      type(slip_path) :: path
      real(wp) :: gamma(2)
      integer :: i, scheme

      do scheme = slip_exact, slip_backward_euler
         gamma = [g, 0.0_wp]
         do i = 1, 1000
            path = integrate_slip(gamma, step, g, scheme)
            gamma = path%elastic_slip
         end do
         call assertEqual([g, 0.0_wp], gamma, 4.0_wp*spacing(g), 'stays on the circle')
      end do
   end subroutine test_creep

   subroutine test_slipped()
      type(random_stream) :: stream
      type(slip_path) :: path
      real(wp) :: angle, start, length, theta
      integer :: i

      stream = random_stream(seed)
      do i = 1, 1000
         angle = stream%uniform(0.0_wp, 2.0_wp*pi)
         start = stream%uniform(0.01_wp, 0.5_wp*pi)
         length = stream%uniform(0.01_wp, 4.0_wp)*g
         path = integrate_slip(g*[cos(angle + start), sin(angle + start)], &
            length*[cos(angle), sin(angle)], g, slip_exact)
         theta = 2.0_wp*atan(tan(0.5_wp*start)*exp(-length/g))
         call assertEqual(g*log(sin(start)/sin(theta)), path%slipped, 1.0e-14_wp, 'dissipation')
         call assertGreaterThanOrEqual(path%slipped, 0.0_wp, 'sign')
         if (anyExceptions()) return
      end do
   end subroutine test_slipped

   !> Central differences with steps of 1e-5 g are good to 1e-9; kinks within a step are skipped.
   subroutine test_derivatives()
      type(random_stream) :: stream
      type(slip_path) :: path, ahead, behind
      real(wp) :: start(2), increment(2), step(2), numeric(2), worst
      integer :: i, j, scheme, checked
      real(wp), parameter :: h = 1.0e-5_wp*g

      stream = random_stream(seed)
      worst = 0.0_wp
      checked = 0
      do i = 1, 20000
         scheme = merge(slip_exact, slip_backward_euler, mod(i, 2) == 0)
         call random_slip(stream, start, increment)
         if (norm2(increment) < 0.05_wp*g .or. norm2(start) > 0.999_wp*g) cycle
         path = integrate_slip(start, increment, g, scheme)
         do j = 1, 2
            step = 0.0_wp
            step(j) = h
            ahead = integrate_slip(start, increment + step, g, scheme)
            behind = integrate_slip(start, increment - step, g, scheme)
            if (ahead%slips .neqv. behind%slips) cycle
            numeric = (ahead%elastic_slip - behind%elastic_slip)/(2.0_wp*h)
            call worsen(worst, norm2(numeric - path%by_increment(:, j)))
            ahead = integrate_slip(start + step, increment, g, scheme)
            behind = integrate_slip(start - step, increment, g, scheme)
            if (ahead%slips .neqv. behind%slips) cycle
            numeric = (ahead%elastic_slip - behind%elastic_slip)/(2.0_wp*h)
            call worsen(worst, norm2(numeric - path%by_start(:, j)))
            checked = checked + 1
         end do
      end do
      call record('friction.derivative', worst)
      call assertLessThan(worst, 1.0e-6_wp, 'largest error')
      call assertGreaterThan(checked, 10000, message='cases')
   end subroutine test_derivatives

   !> At the corner the derivative is the identity before and the projection after it.
   subroutine test_corner()
      type(slip_path) :: path
      real(wp), parameter :: identity(4) = [1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp]
      real(wp), parameter :: small = 1.0e-9_wp
      integer :: scheme

      do scheme = slip_exact, slip_backward_euler
         path = integrate_slip([0.0_wp, 0.0_wp], [g*(1.0_wp - small), 0.0_wp], g, scheme)
         call assertFalse(path%slips, 'before')
         call assertEqual(identity, reshape(path%by_increment, [4]), 0.0_wp, 'before')
         path = integrate_slip([0.0_wp, 0.0_wp], [g*(1.0_wp + small), 0.0_wp], g, scheme)
         call assertTrue(path%slips, 'after')
         call assertEqual([0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], reshape(path%by_increment, [4]), &
            1.0e-8_wp, 'after')
      end do
   end subroutine test_corner

   !> Backward Euler scales the trial slip back. For a motion L at right angles to a slip on the
   !> circle it turns by atan(g/L) where the exact path turns by 2 atan(exp(-L/g)); the largest
   !> difference, at L = 3 g, is 22 % of mu p in one step.
   subroutine test_radial()
      type(slip_path) :: exact, euler
      real(wp) :: start(2), trial(2), increment(2), worst, worst_formula, length
      integer :: i, j

      worst = 0.0_wp
      worst_formula = 0.0_wp
      start = [g, 0.0_wp]
      do i = 1, 180
         do j = 1, 400
            length = 0.02_wp*j*g
            increment = length*[cos(i*pi/180.0_wp), sin(i*pi/180.0_wp)]
            exact = integrate_slip(start, increment, g, slip_exact)
            euler = integrate_slip(start, increment, g, slip_backward_euler)
            trial = start + increment
            if (euler%slips) call assertEqual(g*trial/norm2(trial), euler%elastic_slip, &
               1.0e-15_wp, 'radial return')
            call worsen(worst, norm2(exact%elastic_slip - euler%elastic_slip)/g)
            call worsen(worst_formula, 2.0_wp*sin(0.5_wp*abs(atan(g/length) &
               - 2.0_wp*atan(exp(-length/g)))))
            if (anyExceptions()) return
         end do
      end do
      call record('friction.backward_euler.error', worst)
      call assertEqual(worst_formula, worst, 1.0e-12_wp, 'largest error over g')
   end subroutine test_radial

   subroutine random_slip(stream, start, increment)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(out) :: start(2), increment(2)
      real(wp) :: angle, size

      angle = stream%uniform(0.0_wp, 2.0_wp*pi)
      size = min(stream%uniform(0.0_wp, 1.5_wp), 1.0_wp)
      start = size*g*[cos(angle), sin(angle)]
      angle = stream%uniform(0.0_wp, 2.0_wp*pi)
      size = stream%log_uniform(1.0e-3_wp, 1.0e2_wp)
      increment = size*g*[cos(angle), sin(angle)]
   end subroutine random_slip

end module test_contact_slip_path
