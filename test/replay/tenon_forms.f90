!> The tenon joint against closed forms.
module test_replay_tenon_forms
   use asperity, only: status_open, wp
   use asperity_replay_tenon_geometry, only: tenon_faces
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use extremes, only: largest_of
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use tenon_cases, only: face_pair, plain_joint, run_joint
   implicit none
   private
   public :: suite_tenon_forms

contains

   function suite_tenon_forms() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon closed forms')
      call suite%addTest(TestMethod('elastic couple', test_couple))
      call suite%addTest(TestMethod('first touch', test_first_touch))
      call suite%addTest(TestMethod('plastic plateau', test_plateau))
      call suite%addTest(TestMethod('plateau is never exceeded', test_bound))
      call suite%addTest(TestMethod('pivot', test_pivot))
      call suite%addTest(TestMethod('balance of the recorded points', test_points))
      call suite%addTest(TestMethod('third cycle indents no more', test_third_cycle))
      call suite%addTest(TestMethod('axial spring and force', test_axial))
      call suite%addTest(TestMethod('shoulders', test_shoulders))
      call suite%addTest(TestMethod('column parallel to grain', test_column))
   end function suite_tenon_forms

   !> Without friction and yield, and under a couple (an arm of a kilometre), the ends bear on
   !> triangles from x0 to L/2, x measured from the middle of the mortise. What the model adds is
   !> the discrete points: second order in their distance.
   subroutine test_couple()
      real(wp), parameter :: t = 0.02_wp, clearances(2) = [0.0_wp, 0.5_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: x0, n, i, moment, k, l2, h2
      integer :: j

      do j = 1, 2
         s = plain_joint()
         s%arm = 1.0e6_wp
         s%accept_sizes = .true.
         s%points = 400
         s%clearance_above = clearances(j)
         s%clearance_below = clearances(j)
         s%wood%criterion = 'none'
         s%displacement = [t*s%arm]
         s%displacement_increment = 0.05_wp*t*s%arm
         call run_joint(s, steps, face_pair(0.0_wp))
         if (anyExceptions()) return
         k = s%wood%young_moduli(2)/(0.5_wp*s%height)
         l2 = 0.5_wp*s%length
         h2 = 0.5_wp*s%height
         x0 = (h2*(1.0_wp - cos(t)) + clearances(j))/sin(t)
         n = 0.5_wp*k*s%width*sin(t)*(l2 - x0)**2
         i = k*s%width*sin(t)*((l2**3 - x0**3)/3.0_wp - 0.5_wp*x0*(l2**2 - x0**2))
         moment = 2.0_wp*(i*cos(t) - n*h2*sin(t))
         associate (last => steps(ubound(steps, 1)))
            call record('tenon.elastic_couple.'//achar(iachar('0') + j), &
               abs(last%moment/moment - 1.0_wp))
            call assertEqual(moment, last%moment, 2.0e-4_wp*moment, 'moment')
            ! the load of the long arm, some 10 N, is the difference of the two
            call assertEqual([n, n], last%face_normal(1:2), 5.0e-4_wp*n, 'normal force')
         end associate
      end do
   end subroutine test_couple

   !> Nothing bears before (L/2) sin t - (h/2)(1 - cos t) = c; the outermost points stand half a
   !> cell from the end, so that they touch that much later.
   subroutine test_first_touch()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: t, touch
      integer :: i

      s = plain_joint()
      s%displacement = [4.0_wp]
      s%displacement_increment = 0.02_wp
      call run_joint(s, steps)
      touch = 0.0_wp
      do i = 1, 100
         ! a fixed-point iteration of the formula with the outermost point
         touch = asin((0.5_wp + 150.0_wp*(1.0_wp - cos(touch)))/148.5_wp)
      end do
      do i = 0, ubound(steps, 1)
         t = steps(i)%rotation
         if (t < touch*(1.0_wp - 1.0e-9_wp)) then
            call assertEqual(0.0_wp, steps(i)%force, 1.0e-3_wp, 'free play')
         else if (t > touch + 1.0e-4_wp) then
            call assertGreaterThan(steps(i)%force, 1.0_wp, 'bears')
         end if
      end do
      ! the ideal tenon would touch at 0.003339 rad
      call assertEqual(0.003339_wp, touch*148.5_wp/150.0_wp, 1.0e-6_wp, 'first touch')
   end subroutine test_first_touch

   !> Rigid-plastic bearing with the vertical force of the load: q = f b, a = arm + L/2,
   !> F (a + mu h/2) + F^2/(4 q) = q L^2/4 + mu h q L/2, without mu h/2 on the left when u is fixed.
   !> The joint stays below, by what is elastic near the turning point and the rotation.
   subroutine test_plateau()
      real(wp), parameter :: mus(5) = [0.0_wp, 0.2_wp, 0.2_wp, 0.5_wp, 0.5_wp]
      logical, parameter :: free(5) = [.false., .true., .false., .true., .false.]
      real(wp), parameter :: expected(5) = &
         [16861.0_wp, 22484.0_wp, 23486.0_wp, 30002.0_wp, 33301.0_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      integer :: i

      do i = 1, 5
         s = plain_joint()
         if (free(i)) s%axial_rule = 'free'
         s%wood%young_moduli(2) = 1.0e3_wp*s%wood%young_moduli(2)
         s%accept_sizes = .true.
         s%wood%hardening_across = 0.0_wp
         s%clearance_above = 0.0_wp
         s%clearance_below = 0.0_wp
         s%displacement = [10.0_wp]
         s%displacement_increment = 0.1_wp
         call run_joint(s, steps, face_pair(mus(i)))
         if (anyExceptions()) return
         call assertEqual(expected(i), plateau(s, mus(i), free(i)), 1.0_wp, 'formula')
         call record('tenon.plateau_ratio.'//achar(iachar('0') + i), &
            steps(ubound(steps, 1))%force/expected(i))
         call assertGreaterThan(steps(ubound(steps, 1))%force, 0.96_wp*expected(i), 'near')
         call assertTrue(all(steps%force <= expected(i)), 'never above')
      end do
   end subroutine test_plateau

   !> The positive root of the plateau's equation.
   pure real(wp) function plateau(s, mu, free)
      type(tenon_settings), intent(in) :: s
      real(wp), intent(in) :: mu
      logical, intent(in) :: free
      real(wp) :: q, a, b

      q = s%wood%compression_strengths(2)*s%width
      a = s%arm + 0.5_wp*s%length
      if (free) a = a + 0.5_wp*mu*s%height
      b = q*(0.25_wp*s%length**2 + 0.5_wp*mu*s%height*s%length)
      plateau = 2.0_wp*q*(sqrt(a**2 + b/q) - a)
   end function plateau

   !> Over the whole programme no force passes the plateau without hardening: hard and rough.
   subroutine test_bound()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      character(len=5), parameter :: contacts(2) = ['hard ', 'rough']
      integer :: i

      do i = 1, 2
         s = plain_joint()
         s%contact = contacts(i)
         s%wood%hardening_across = 0.0_wp
         s%points = 50
         s%displacement_increment = 2.0_wp
         call run_joint(s, steps)
         call record('tenon.bound_ratio.'//trim(contacts(i)), &
            largest_of(steps%force)/plateau(s, 0.5_wp, .false.))
         call assertLessThan(largest_of(steps%force), plateau(s, 0.5_wp, .false.), 'bound')
      end do
   end subroutine test_bound

   !> Free along the axis and loaded one way: the heavier face sticks, so that u = (h/2) t less
   !> the elastic slip.
   subroutine test_pivot()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)

      s = plain_joint()
      s%axial_rule = 'free'
      s%clearance_above = 0.0_wp
      s%clearance_below = 0.0_wp
      s%displacement = [10.0_wp]
      s%displacement_increment = 0.2_wp
      call run_joint(s, steps)
      associate (last => steps(ubound(steps, 1)))
         call assertEqual(0.02_wp, last%rotation, 1.0e-15_wp, 'rotation')
         call assertLessThan(last%pull_out, 3.0_wp, 'no more than the pivot')
         call assertGreaterThan(last%pull_out, 3.0_wp - 0.31_wp, 'less the elastic slip at most')
         call record('tenon.pivot_pull_out', last%pull_out)
      end associate
   end subroutine test_pivot

   !> Force, axial force, moment and normal forces again from the points; with shoulders too.
   subroutine test_points()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      type(tenon_point), allocatable :: points(:)
      real(wp) :: force(2), total(2), normal(tenon_faces), moment, x, y
      integer :: i, j, k, at(3)

      s%amplitudes = [16.0_wp]
      at = [20, 37, 60]
      do k = 1, 2
         s%shoulders = k == 2
         call run_joint(s, steps, record_at=at, points=points)
         if (anyExceptions()) return
         do j = 1, 3
            associate (step => steps(at(j)))
               total = [step%axial_force, step%force]
               normal = 0.0_wp
               moment = step%force*500.0_wp*cos(step%rotation)
               do i = 1, size(points)
                  associate (p => points(i))
                     if (p%step /= at(j)) cycle
                     normal(p%face) = normal(p%face) + p%area*p%pressure
                     select case (p%face)
                     case (1)
                        force = -p%area*[p%shear_1, p%pressure]
                     case (2)
                        force = -p%area*[p%shear_1, -p%pressure]
                     case (3, 4)
                        force = -p%area*[p%shear_1, p%shear_2]
                     case default
                        force = p%area*[p%pressure, -p%shear_1]
                     end select
                     x = p%x*cos(step%rotation) - p%y*sin(step%rotation)
                     y = p%x*sin(step%rotation) + p%y*cos(step%rotation)
                     moment = moment + x*force(2) - y*force(1)
                     total = total + force
                     if (p%status == status_open) &
                        call assertLessThan(p%pressure, 1.0e-6_wp, 'open')
                  end associate
               end do
               call assertEqual(step%face_normal, normal, 1.0e-9_wp*maxval(normal), 'normal forces')
               call assertEqual(step%moment, step%force*500.0_wp, 1.0e-9_wp*abs(step%moment), 'M')
               ! what the solver lets pass: 1e-9 of strength times width times length, times the arm
               call assertEqual([0.0_wp, 0.0_wp], total, 2.0e-4_wp, 'Fx = 0, Fy = 0')
               call assertEqual(0.0_wp, moment, 0.1_wp, 'moment about O')
               call assertEqual(-500.0_wp*step%pull_out, step%axial_force, 1.0e-9_wp, 'spring')
            end associate
         end do
      end do
   end subroutine test_points

   !> With u fixed the third cycle of 48 mm finds the wood already indented.
   subroutine test_third_cycle()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: second, third, first

      s = plain_joint()
      s%amplitudes = [48.0_wp]
      s%cycles = [3]
      s%displacement_increment = 2.0_wp
      call run_joint(s, steps)
      if (anyExceptions()) return
      first = maxval(steps%plastic, mask=steps%cycle == 1)
      second = maxval(steps%plastic, mask=steps%cycle == 2)
      third = maxval(steps%plastic, mask=steps%cycle == 3)
      call record('tenon.plastic_work_of_third_cycle', (third - second)/first)
      call assertLessThan(third - second, 2.0e-3_wp*first, 'plastic work')
      call assertEqual(maxval(steps%moment, mask=steps%cycle == 2), &
         maxval(steps%moment, mask=steps%cycle == 3), 2.0e-3_wp*maxval(steps%moment), 'moment')
      ! and the loop is pinched: little moment on the way back through half the amplitude
      call assertTrue(all(steps%moment < 0.1_wp*maxval(steps%moment) .or. steps%cycle /= 3 .or. &
         abs(steps%displacement) >= 1.0_wp), 'pinched')
   end subroutine test_third_cycle

   !> A very stiff spring is a fixed tenon; a force of zero is a free one; a force moves it.
   subroutine test_axial()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)

      s%amplitudes = [8.0_wp]
      s%axial_rule = 'fixed'
      call run_joint(s, steps)
      s%axial_rule = 'spring'
      s%axial_stiffness = 1.0e10_wp
      call run_joint(s, others)
      call assertEqual(steps%moment, others%moment, 1.0e-4_wp*maxval(steps%moment), 'fixed')
      call assertEqual(steps%axial_force, others%axial_force, 1.0_wp, 'axial force')
      s%axial_rule = 'free'
      call run_joint(s, steps)
      s%axial_rule = 'force'
      call run_joint(s, others)
      call assertEqual(steps%pull_out, others%pull_out, 1.0e-9_wp, 'free')
      s%axial_force = 1.0e3_wp
      call run_joint(s, others)
      call assertGreaterThan(others(ubound(others, 1))%pull_out, &
         steps(ubound(steps, 1))%pull_out + 0.01_wp, 'pulled out')
   end subroutine test_axial

   !> The shoulder that turns inwards bears, the other opens; the moment grows.
   subroutine test_shoulders()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)

      s%contact = 'hard'
      s%amplitudes = [8.0_wp]
      s%extension = 0.0_wp
      call run_joint(s, others)
      s%shoulders = .true.
      call run_joint(s, steps)
      if (anyExceptions()) return
      associate (top => steps(10), bottom => steps(30))
         call assertEqual([8.0_wp, -8.0_wp], [top%displacement, bottom%displacement], 1.0e-12_wp, &
            'amplitudes')
         call assertGreaterThan(top%face_normal(5), 100.0_wp, 'upper shoulder')
         call assertGreaterThan(bottom%face_normal(6), 100.0_wp, 'lower shoulder')
         call assertEqual([0.0_wp, 0.0_wp], [top%face_normal(6), bottom%face_normal(5)], 0.0_wp, &
            'open')
         call assertGreaterThan(top%moment, 1.1_wp*others(10)%moment, 'moment')
         ! it pushes out what the spring and friction hold
         call assertGreaterThan(top%pull_out, others(10)%pull_out, 'pull-out')
      end associate
      call assertEqual(0.0_wp, largest_of(others%face_normal(5)), 0.0_wp, 'none without')
      s%shoulder_gap = 50.0_wp
      s%accept_sizes = .true.
      call run_joint(s, steps)
      call assertEqual(others%moment, steps%moment, 1.0e-9_wp*maxval(others%moment), 'far away')
   end subroutine test_shoulders

   !> Two woods in series: a column of twice the tenon's compliance in all acts as one of that sum.
   subroutine test_column()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)

      s = plain_joint()
      s%contact = 'rough'
      s%amplitudes = [16.0_wp]
      s%column = 'elastic'
      s%wood%young_moduli(1) = s%wood%young_moduli(2)
      s%wood%hardening_across = 0.02_wp
      call run_joint(s, steps)
      s%column = 'rigid'
      s%bearing_depth = s%height
      s%wood%hardening_across = 0.04_wp
      call run_joint(s, others)
      call assertEqual(others%moment, steps%moment, 1.0e-9_wp*maxval(steps%moment), 'elastic')
      s = plain_joint()
      s%amplitudes = [16.0_wp]
      s%column = 'elastic'
      s%wood%young_moduli(1) = s%wood%young_moduli(2)
      s%wood%compression_strengths(1) = s%wood%compression_strengths(2)
      call run_joint(s, steps)
      s%column = 'rigid'
      s%bearing_depth = s%height
      call run_joint(s, others)
      call assertEqual(others%moment, steps%moment, 1.0e-9_wp*maxval(steps%moment), 'both yield')
   end subroutine test_column

end module test_replay_tenon_forms
