!> Friction beyond one coefficient over paths: the ledgers against work by quadrature, in one
!> dimension, and the steps in two dimensions against an integration of their own in tiny steps.
module test_contact_general_path
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, contact_response, contact_state, friction_settings, &
      rule_abaqus, rule_dissipative, slip_direction_associated, slip_direction_of_stress, wp
   use extremes, only: worsen
   use friction_cases, only: friction_properties, kinds, random_friction, spring, spring_slides
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertGreaterThanOrEqual, &
      assertLessThan, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_general_path

   !> Of the pair; overclosure and pressure of the spring
   real(wp), parameter :: mu = 0.5_wp, g = 0.31_wp, closed = 0.01_wp, p = spring*closed

   !> A point of the integration in tiny steps
   type :: tiny_point
      real(wp) :: gamma(2) = 0.0_wp, moved = 0.0_wp, lost = 0.0_wp
   end type tiny_point

contains

   function suite_general_path() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('general path')
      call suite%addTest(TestMethod('work = stored + dissipated - coupling', test_ledgers))
      call suite%addTest(TestMethod('the dissipative rule creates no energy', test_no_creation))
      call suite%addTest(TestMethod('steps in two dimensions converge', test_convergence))
   end function suite_general_path

   !> Random paths along the grain of points that stay closed, both rules.
   subroutine test_ledgers()
      integer(int64), parameter :: seed = 24494897_int64
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: c
      type(contact_response) :: last, next
      real(wp) :: overclosure, slip, time, work, worst, scale, change
      integer :: i, k, kind

      stream = random_stream(seed)
      worst = 0.0_wp
      do kind = 1, size(kinds)
         do i = 1, 16
            call random_friction(stream, kind, mu, g, settings)
            settings%grain_angle = 0.0_wp
            c = friction_properties(settings, merge(rule_abaqus, rule_dissipative, mod(i, 2) == 0))
            last = spring_slides(c, contact_state(), closed, [0.0_wp, 0.0_wp])
            do k = 1, 8
               overclosure = stream%uniform(0.005_wp, 0.05_wp)
               slip = stream%uniform(-1.5_wp, 1.5_wp)*g
               time = stream%log_uniform(0.1_wp, 10.0_wp)
               next = spring_slides(c, last%state, overclosure, [slip, 0.0_wp], time)
               work = slip*mean_stress(c, last%state, overclosure, slip, time, 0.0_wp, 1.0_wp)
               change = next%tangential_energy - last%tangential_energy
               scale = next%dissipation + next%tangential_energy + last%tangential_energy
               call worsen(worst, &
                  abs(work - change - next%dissipation + next%pressure_coupling)/scale)
               call assertGreaterThanOrEqual(next%dissipation, 0.0_wp, 'dissipation')
               last = next
            end do
         end do
         if (anyExceptions()) return
      end do
      call record('friction.general_ledgers', worst)
      call assertLessThan(worst, 1.0e-11_wp, 'ledgers')
   end subroutine test_ledgers

   !> Mean shear stress over shares of an increment: Lobatto's rule, whose points at the ends see
   !> corners, by halving until halves agree with the whole or what is left is a corner or a drop.
   recursive function mean_stress(c, start, overclosure, slip, time, from, to) result(mean)
      type(contact_properties), intent(in) :: c
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip, time, from, to
      real(wp) :: mean, middle

      middle = 0.5_wp*(from + to)
      mean = lobatto(from, middle) + lobatto(middle, to)
      if (to - from < 1.0e-12_wp) return
      if (to - from < 0.02_wp .and. abs(mean - lobatto(from, to)) < 1.0e-14_wp) return
      mean = mean_stress(c, start, overclosure, slip, time, from, middle) &
         + mean_stress(c, start, overclosure, slip, time, middle, to)

   contains

      function lobatto(low, high)
         real(wp), intent(in) :: low, high
         real(wp), parameter :: x(4) = [-1.0_wp, -sqrt(0.2_wp), sqrt(0.2_wp), 1.0_wp], &
            weights(4) = [1.0_wp, 5.0_wp, 5.0_wp, 1.0_wp]/12.0_wp
         real(wp) :: lobatto, share
         type(contact_response) :: r
         integer :: i

         lobatto = 0.0_wp
         do i = 1, 4
            share = 0.5_wp*(low + high) + 0.5_wp*(high - low)*x(i)
            r = spring_slides(c, start, overclosure, [share*slip, 0.0_wp], share*time)
            lobatto = lobatto + (high - low)*weights(i)*r%traction(2)
         end do
      end function lobatto

   end function mean_stress

   !> Closed cycles of any kind in two dimensions: the work of fine steps is not below zero, and no
   !> increment of any path dissipates less than nothing.
   subroutine test_no_creation()
      integer(int64), parameter :: seed = 28284271_int64
      integer, parameter :: steps = 200
      type(random_stream) :: stream
      type(friction_settings) :: settings
      type(contact_properties) :: c
      type(contact_response) :: last, next
      real(wp) :: work, slip(2), least, overclosure
      integer :: i, j, k, kind

      stream = random_stream(seed)
      least = huge(1.0_wp)
      do kind = 1, size(kinds)
         do i = 1, 6
            call random_friction(stream, kind, mu, g, settings)
            c = friction_properties(settings, rule_dissipative)
            last = contact_response()
            work = 0.0_wp
            do k = 1, 10
               overclosure = stream%uniform(0.001_wp, 0.05_wp)
               slip = g*[stream%uniform(-0.7_wp, 0.7_wp), stream%uniform(-0.7_wp, 0.7_wp)]/steps
               do j = 1, steps
                  next = spring_slides(c, last%state, overclosure, slip, 1.0_wp/steps)
                  work = work + 0.5_wp*dot_product(next%traction(2:) + last%traction(2:), slip)
                  call assertGreaterThanOrEqual(next%dissipation, 0.0_wp, 'dissipation')
                  call assertEqual(0.0_wp, next%pressure_coupling, 0.0_wp, 'coupling')
                  last = next
               end do
            end do
            next = spring_slides(c, last%state, -0.01_wp, [0.0_wp, 0.0_wp])
            least = min(least, work/next%state%dissipation)
            if (anyExceptions()) return
         end do
      end do
      call record('friction.general_least_work', least)
      call assertGreaterThan(least, 0.9_wp, 'work over what is lost')
   end subroutine test_no_creation

   !> Four straight strokes at angles to each other, in 1 to 64 increments each: the error of the
   !> shear stress at their ends, over mu_s p, and of the dissipation, over all of it.
   subroutine test_convergence()
      integer, parameter :: strokes = 4, most = 64
      real(wp), parameter :: way(2, strokes) = reshape([0.9_wp, 0.2_wp, -0.3_wp, 0.8_wp, -0.9_wp, &
         -0.5_wp, 0.7_wp, -0.9_wp], [2, strokes])
      character(len=*), parameter :: names(3) = [character(len=10) :: 'decay', 'associated', &
         'stress']
      type(friction_settings) :: settings(3)
      type(contact_properties) :: c
      type(contact_response) :: r
      type(tiny_point) :: tiny(strokes)
      real(wp) :: errors(0:6), lost(0:6), strength
      integer :: i, j, k, n

      settings(1) = friction_settings(static_friction_coefficient=0.8_wp, decay_slip=0.4_wp)
      settings(2) = friction_settings(friction_coefficient_across=0.25_wp, grain_angle=20.0_wp, &
         slip_direction=slip_direction_associated)
      settings(3) = friction_settings(friction_coefficient_across=0.25_wp, grain_angle=20.0_wp, &
         slip_direction=slip_direction_of_stress, static_friction_coefficient=0.8_wp, &
         decay_slip=0.4_wp)
      do i = 1, size(settings)
         c = friction_properties(settings(i))
         strength = p*max(mu, settings(i)%static_friction_coefficient)
         call go_in_tiny_steps(settings(i), way, tiny)
         do k = 0, 6
            n = 2**k
            errors(k) = 0.0_wp
            r = contact_response()
            do j = 1, strokes*n
               r = spring_slides(c, r%state, closed, way(:, 1 + (j - 1)/n)/n)
               if (mod(j, n) == 0) call worsen(errors(k), &
                  maxval(abs(r%state%elastic_slip - tiny(j/n)%gamma))/g)
            end do
            lost(k) = abs(r%state%dissipation/(strength/g*tiny(strokes)%lost) - 1.0_wp)
         end do
         write (*, '(5x, a, 7es10.2)') names(i)//' slip', errors
         write (*, '(5x, a, 7es10.2)') names(i)//' loss', lost
         call record('friction.steps.'//trim(names(i)), errors(3))
         call assertLessThan(errors(6), 0.55_wp*errors(5), 'first order')
         call assertLessThan(lost(6), 0.55_wp*lost(5), 'first order')
         call assertLessThan(errors(6), 0.01_wp, 'slip')
         call assertLessThan(lost(6), 0.01_wp, 'loss')
         call assertEqual(most, n, 'increments')
      end do
   end subroutine test_convergence

   !> The differential equations of the law in the axes of the grain, by Runge and Kutta's midpoint
   !> rule, brought back to the circle after each step.
   subroutine go_in_tiny_steps(settings, way, ends)
      type(friction_settings), intent(in) :: settings
      real(wp), intent(in) :: way(:, :)
      type(tiny_point), intent(out) :: ends(:)
      integer, parameter :: steps = 40000
      type(tiny_point) :: point, middle
      real(wp) :: static, r(2), w(2), axes(2, 2), angle, ds, e(2), kinetic, excess, radius
      integer :: i, j

      static = max(mu, settings%static_friction_coefficient)
      r = 1.0_wp
      angle = 0.0_wp
      if (settings%friction_coefficient_across > 0.0_wp) then
         r(2) = settings%friction_coefficient_across/mu
         angle = settings%grain_angle*acos(-1.0_wp)/180.0_wp
      end if
      w = r
      if (settings%slip_direction == slip_direction_associated) w = 1.0_wp/r
      axes = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
      kinetic = g*mu/static
      excess = g - kinetic
      do j = 1, size(ends)
         ds = norm2(way(:, j))/steps
         e = matmul(way(:, j), axes)/norm2(way(:, j))
         do i = 1, steps
            middle = stepped(point, point, 0.5_wp*ds)
            point = stepped(point, middle, ds)
            radius = kinetic + excess*(1.0_wp - point%moved)
            if (norm2(point%gamma) > radius) point%gamma = point%gamma*radius/norm2(point%gamma)
         end do
         ends(j) = point
         ends(j)%gamma = matmul(axes, point%gamma)
      end do

   contains

      !> `from` plus a step with the rates of `by`.
      function stepped(from, by, length) result(to)
         type(tiny_point), intent(in) :: from, by
         real(wp), intent(in) :: length
         type(tiny_point) :: to
         real(wp) :: rate, slip(2), size, decay

         decay = 0.0_wp
         if (settings%decay_slip > 0.0_wp) decay = 1.0_wp/settings%decay_slip
         size = norm2(by%gamma)
         slip = w*by%gamma
         to = from
         if (size < (kinetic + excess*(1.0_wp - by%moved))*(1.0_wp - 1.0e-7_wp) &
            .or. dot_product(by%gamma, e) <= 0.0_wp) then
            to%gamma = from%gamma + length*e
            if (decay > 0.0_wp) to%moved = from%moved - length*by%moved/(1.0_wp/decay + excess)
         else
            rate = dot_product(by%gamma, e)/(dot_product(slip, by%gamma) &
               - size*excess*(1.0_wp - by%moved)*decay*norm2(slip))
            to%gamma = from%gamma + length*(e - rate*slip)
            to%moved = from%moved + length*(1.0_wp - by%moved)*decay*rate*norm2(slip)
            to%lost = from%lost + length*rate*dot_product(r*by%gamma, slip)
         end if
      end function stepped

   end subroutine go_in_tiny_steps

end module test_contact_general_path
