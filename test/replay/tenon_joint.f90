!> The tenon joint as a whole: symmetry, limits, convergence, UINTER in place of the update, and
!> what is refused.
module test_replay_tenon_joint
   use asperity, only: computation_error, error_type, wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_run, only: run_tenon
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use asperity_wood_properties, only: wood_properties
   use extremes, only: largest_of
   use funit, only: anyExceptions, assertEqual, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use measurements, only: record
   use subjects, only: fits_subject
   use tenon_cases, only: face_pair, joint_with, plain_joint, run_joint, scaled_pair, side_pair
   implicit none
   private
   public :: suite_tenon_joint

   character(len=5), parameter :: contacts(2) = ['hard ', 'rough']

contains

   function suite_tenon_joint() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon joint')
      call suite%addTest(TestMethod('mirrored programme', test_mirror))
      call suite%addTest(TestMethod('hard contact is the limit of the rough law', test_limit))
      call suite%addTest(TestMethod('a softer face at equal touch is not stronger', test_softer))
      call suite%addTest(TestMethod('convergence in step and points', test_convergence))
      call suite%addTest(TestMethod('UINTER gives the same joint', test_uinter_joint))
      call suite%addTest(TestMethod('rest with too little clearance', test_interference))
      call suite%addTest(TestMethod('range of the paper', test_default))
      call suite%addTest(TestMethod('recorded displacements', test_displacement))
      call suite%addTest(TestMethod('sizes that follow from the height', test_followers))
      call suite%addTest(TestMethod('pull-out', test_pull_out))
      call suite%addTest(TestMethod('pulled out by a given force', test_pulled))
      call suite%addTest(TestMethod('settings that are refused', test_refused))
      call suite%addTest(TestMethod('sizes in another unit', test_sizes))
   end function suite_tenon_joint

   !> All signs turned: the moment turns, pull-out and energies stay.
   subroutine test_mirror()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)
      real(wp) :: largest
      integer :: i, n

      do i = 1, 2
         s = tenon_settings(contact=contacts(i), shoulders=i == 2)
         s%displacement = [4.0_wp, -4.0_wp, 16.0_wp, -16.0_wp, 5.0_wp]
         call run_joint(s, steps)
         s%displacement = -s%displacement
         call run_joint(s, others)
         if (anyExceptions()) return
         n = ubound(steps, 1)
         largest = largest_of(steps%moment)
         call record('tenon.mirror.'//trim(contacts(i)), &
            largest_of(steps%moment + others%moment)/largest)
         call assertEqual(-steps%moment, others%moment, 1.0e-8_wp*largest, 'moment')
         call assertEqual(steps%pull_out, others%pull_out, 1.0e-7_wp, 'pull-out')
         call assertEqual(steps(n)%friction, others(n)%friction, 1.0e-8_wp*steps(n)%work, &
            'friction')
         call assertEqual(steps(n)%face_friction_energy(1), others(n)%face_friction_energy(2), &
            1.0e-8_wp*steps(n)%work, 'upper is lower')
      end do
   end subroutine test_mirror

   !> sigma, R, d0 times s and eta over s^2: the energy tends to that of hard contact with s.
   subroutine test_limit()
      real(wp), parameter :: scales(4) = [1.0_wp, 0.3_wp, 0.1_wp, 0.03_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: hard(:), rough(:)
      real(wp) :: rest(4), moment(4)
      integer :: i, n

      s = plain_joint()
      s%axial_rule = 'spring'
      s%axial_stiffness = 100.0_wp
      s%amplitudes = [8.0_wp, 24.0_wp]
      call run_joint(s, hard)
      n = ubound(hard, 1)
      s%contact = 'rough'
      do i = 1, 4
         call run_joint(s, rough, scaled_pair(scales(i)))
         if (anyExceptions()) return
         rest(i) = rough(n)%work/hard(n)%work - 1.0_wp
         moment(i) = sum(abs(rough%moment - hard%moment))/sum(abs(hard%moment))
         call record('tenon.limit.energy.'//achar(iachar('0') + i), rest(i))
         call record('tenon.limit.moment.'//achar(iachar('0') + i), moment(i))
      end do
      call assertGreaterThan(rest(1), 0.02_wp, 'the rough joint dissipates more')
      ! of first order in s
      call assertLessThan(rest(4), 1.5_wp*0.03_wp*rest(1), 'energy')
      call assertLessThan(moment(4), 1.5_wp*0.03_wp*moment(1), 'moment')
   end subroutine test_limit

   !> Loaded one way with u fixed and equal first touch, a compliant face never raises the moment.
   subroutine test_softer()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: hard(:), rough(:)

      s = plain_joint()
      s%displacement = [48.0_wp]
      s%gap = 'first_touch'
      call run_joint(s, hard)
      s%contact = 'rough'
      call run_joint(s, rough)
      if (anyExceptions()) return
      ! the tail of the law carries 0.001 MPa at first touch, about 1e-4 of the end
      call assertTrue(all(rough%moment - hard%moment < 5.0e-4_wp*maxval(hard%moment)), &
         'never above')
      call assertLessThan(rough(ubound(rough, 1))%moment, hard(ubound(hard, 1))%moment, 'below')
      s%gap = 'mean_plane'
      call run_joint(s, rough)
      call assertGreaterThan(maxval(rough%moment - hard%moment), 0.01_wp*maxval(hard%moment), &
         'equal mean planes touch sooner')
   end subroutine test_softer

   !> Default step and points against four times finer, over the whole programme: moment and energy.
   subroutine test_convergence()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: coarse(:), fine(:)
      real(wp) :: moment, work
      integer :: i

      do i = 1, 2
         s = tenon_settings(contact=contacts(i), amplitudes=[4.0_wp, 16.0_wp, 48.0_wp])
         call run_joint(s, coarse)
         s%displacement_increment = 0.25_wp*s%displacement_increment
         s%points = 3*s%points
         s%side_points = 2*s%side_points
         call run_joint(s, fine)
         if (anyExceptions()) return
         moment = maxval(coarse%moment)/maxval(fine%moment) - 1.0_wp
         work = coarse(ubound(coarse, 1))%work/fine(ubound(fine, 1))%work - 1.0_wp
         call record('tenon.convergence.moment.'//trim(contacts(i)), abs(moment))
         call record('tenon.convergence.work.'//trim(contacts(i)), abs(work))
         call assertLessThan(abs(moment), 5.0e-3_wp, 'moment')
         call assertLessThan(abs(work), 5.0e-3_wp, 'work')
      end do
   end subroutine test_convergence

   !> Every point through UINTER, which evaluates the law directly: the same to the round-off of the
   !> compiled law, 1e-10 of the pressure.
   subroutine test_uinter_joint()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)
      type(tenon_point), allocatable :: points(:), other_points(:)
      integer :: i, at(2), n

      at = [12, 30]
      do i = 1, 2
         s = tenon_settings(points=40, side_points=6, shoulders=i == 2, &
            displacement_increment=2.0_wp, amplitudes=[24.0_wp])
         s%through_uinter = .false.
         call run_joint(s, steps, record_at=at, points=points)
         s%through_uinter = .true.
         call run_joint(s, others, record_at=at, points=other_points)
         if (anyExceptions()) return
         n = ubound(steps, 1)
         call record('tenon.uinter_moment.'//achar(iachar('0') + i), &
            largest_of(steps%moment - others%moment)/maxval(steps%moment))
         call assertEqual(steps%moment, others%moment, 1.0e-8_wp*maxval(steps%moment), 'moment')
         call assertEqual(steps%pull_out, others%pull_out, 1.0e-7_wp, 'pull-out')
         call assertEqual(steps(n)%friction, others(n)%friction, 1.0e-8_wp*steps(n)%work, &
            'friction')
         call assertEqual(steps(n)%elastic_slip, others(n)%elastic_slip, 1.0e-8_wp*steps(n)%work, &
            'pressure coupling')
         call assertEqual(steps(n)%stored, others(n)%stored, 1.0e-8_wp*steps(n)%work, 'stored')
         call assertEqual(points%pressure, other_points%pressure, 1.0e-7_wp, 'pressures')
         call assertEqual(points%shear_1, other_points%shear_1, 1.0e-7_wp, 'shear')
         call assertEqual(0, count(points%status /= other_points%status), 'status')
         call assertEqual(steps%validity, others%validity, 'validity')
         ! it warns of flags alone
         call assertEqual(0, maxval(others%validity), 'UINTER has nothing to say')
      end do
   end subroutine test_uinter_joint

   !> Less clearance than 4 sigma presses the rough faces at rest; with unequal clearances the tenon
   !> finds its height. A hard joint without clearance only touches.
   subroutine test_interference()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)

      s = tenon_settings(clearance_above=0.05_wp, clearance_below=0.05_wp, amplitudes=[0.5_wp])
      call run_joint(s, steps)
      if (anyExceptions()) return
      call assertGreaterThan(steps(0)%face_normal(1), 100.0_wp, 'pressed at rest')
      call assertEqual(steps(0)%face_normal(1), steps(0)%face_normal(2), 1.0e-3_wp, 'both faces')
      call assertEqual(0.0_wp, steps(0)%vertical, 1.0e-6_wp, 'in the middle')
      call assertGreaterThan(steps(0)%stored, 1.0_wp, 'stored at rest')
      call assertEqual(0.0_wp, steps(0)%work, 0.0_wp, 'no work yet')
      s%clearance_above = 0.0_wp
      call run_joint(s, steps)
      call assertLessThan(steps(0)%vertical, -0.01_wp, 'moves down')
      call assertEqual(0.0_wp, steps(0)%force, 1.0e-3_wp, 'no load at rest')
      s = tenon_settings(clearance_above=0.0_wp, clearance_below=0.0_wp, amplitudes=[0.5_wp], &
         contact='hard')
      call run_joint(s, steps)
      call assertEqual(0.0_wp, steps(0)%face_normal(1), 1.0e-9_wp, 'only touches')
   end subroutine test_interference

   !> The two models at their defaults, as the demonstration runs them: within what the study found
   !> for this rule, and apart by a per cent, not by the paper's 10.8. With the arm from the axis,
   !> as in the study, about 20.9 kN m.
   subroutine test_default()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: moment(2), work(2), study
      integer :: i

      do i = 1, 2
         s = tenon_settings(contact=contacts(i))
         call run_joint(s, steps)
         if (anyExceptions()) return
         moment(i) = maxval(steps%moment)
         work(i) = steps(ubound(steps, 1))%work
         call assertEqual(30, maxval(steps%cycle) + 11, 'cycles')
         call assertEqual(48.0_wp, maxval(steps%displacement), 0.0_wp, 'amplitude')
         call assertEqual(0.096_wp, maxval(steps%rotation), 1.0e-15_wp, 'rotation')
         call record('tenon.ultimate_moment.'//trim(contacts(i)), 1.0e-6_wp*moment(i))
         call record('tenon.work.'//trim(contacts(i)), 1.0e-6_wp*work(i))
         call assertGreaterThan(moment(i), 14.0e6_wp, 'range')
         call assertLessThan(moment(i), 21.0e6_wp, 'range')
      end do
      call assertEqual(1.0_wp, moment(2)/moment(1), 0.02_wp, 'ratio of the moments')
      call assertEqual(1.035_wp, work(2)/work(1), 0.03_wp, 'ratio of the energies')
      ! the study's case: spring 100 N/mm, no sides, no extension, 13.69 kN m and 7.04 kN m
      s = plain_joint()
      s%axial_rule = 'spring'
      s%axial_stiffness = 100.0_wp
      call run_joint(s, steps)
      study = maxval(steps%moment)
      call assertEqual(13.69e6_wp, study, 0.005_wp*study, 'study, hard')
      call assertEqual(7.04e6_wp, steps(ubound(steps, 1))%work, 0.01_wp*7.04e6_wp, 'its energy')
      s%contact = 'rough'
      call run_joint(s, steps)
      call assertEqual(7.51e6_wp, steps(ubound(steps, 1))%work, 0.01_wp*7.51e6_wp, 'study, rough')
   end subroutine test_default

   !> The same path given as displacements is the same joint; cycles are counted by passages.
   subroutine test_displacement()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)

      s%amplitudes = [4.0_wp, 8.0_wp]
      s%cycles = [1, 2]
      call run_joint(s, steps)
      s%displacement = [4.0_wp, -4.0_wp, 0.0_wp, 8.0_wp, -8.0_wp, 0.0_wp, 8.0_wp, -8.0_wp, 0.0_wp]
      call run_joint(s, others)
      call assertEqual(steps%moment, others%moment, 0.0_wp, 'moment')
      call assertEqual(3, maxval(others%cycle), 'cycles')
      ! two millimetres on the way back at once, as a recorder may give
      s%displacement = [8.0_wp, 8.0_wp, 6.0_wp]
      call run_joint(s, steps)
      call assertEqual(0.0_wp, steps(10)%displacement - steps(11)%displacement, 0.0_wp, 'no motion')
      call assertEqual(steps(10)%moment, steps(11)%moment, 1.0e-6_wp*steps(10)%moment, 'no change')
   end subroutine test_displacement

   !> Bearing depths of half the height, an extension of a fifth, shoulders of a sixth: a joint that
   !> names them is that which does not, to the bit.
   subroutine test_followers()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)
      integer :: i

      do i = 1, 2
         s = tenon_settings(height=180.0_wp, length=250.0_wp, width=60.0_wp, shoulders=i == 2, &
            amplitudes=[16.0_wp], points=40, side_points=4, displacement_increment=2.0_wp)
         call run_joint(s, steps)
         s%bearing_depth = 90.0_wp
         s%column_depth = 90.0_wp
         s%extension = 36.0_wp
         s%shoulder_height = 30.0_wp
         call run_joint(s, others)
         if (anyExceptions()) return
         call assertEqual(others%moment, steps%moment, 0.0_wp, 'moment')
         call assertEqual(others%stored, steps%stored, 0.0_wp, 'stored')
         ! 150 mm, half the height of the paper's joint, is another joint
         s%bearing_depth = 150.0_wp
         call run_joint(s, others)
         call assertGreaterThan(maxval(steps%moment), 1.02_wp*maxval(others%moment), 'stiffer')
      end do
   end subroutine test_followers

   !> Free along its axis and without sides, the tenon walks out: the run stops, names the step and
   !> returns what it has.
   subroutine test_pull_out()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), again(:)
      type(error_type), allocatable :: error
      integer :: n

      s = plain_joint()
      s%axial_rule = 'free'
      s%displacement_increment = 2.0_wp
      s%points = 50
      call run_tenon(s, face_pair(), side_pair(), steps, error)
      call assertTrue(allocated(error), 'walks out')
      if (.not. allocated(error)) return
      n = ubound(steps, 1)
      call assertEqual(1, index(error%message, 'step '), error%message)
      call assertTrue(index(error%message, 'more than half its length') > 0, error%message)
      call assertGreaterThan(abs(steps(n)%pull_out), 150.0_wp, 'half out')
      call assertLessThan(largest_of(steps(:n - 1)%pull_out), 150.0_wp, 'not before')
      ! the displacements so far replay it
      s%displacement = steps(1:)%displacement
      call run_tenon(s, face_pair(), side_pair(), again, error)
      call assertTrue(allocated(error), 'again')
      call assertEqual(steps%pull_out, again%pull_out, 0.0_wp, 'the same')
   end subroutine test_pull_out

   !> Pulled by more than half of what its sides hold, the tenon finds no balance once rotation
   !> takes its share of their friction: the step is named, and what went before returned.
   subroutine test_pulled()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      type(error_type), allocatable :: error

      ! the sides hold 18 kN
      s = tenon_settings(axial_rule='force', axial_force=1.0e4_wp, side_pressure=0.2_wp, points=50)
      call run_tenon(s, face_pair(), side_pair(), steps, error)
      call assertTrue(allocated(error), 'fails')
      if (.not. allocated(error)) return
      call assertEqual(computation_error, error%category, 'category')
      call assertEqual(1, index(error%message, 'step '//to_text(size(steps))//', displacement '), &
         error%message)
      call assertTrue(index(error%message, 'no equilibrium near rotation') > 0, error%message)
      call assertTrue(size(steps) > 10, 'steps before')
      s%axial_force = 1.79999e4_wp
      call run_tenon(s, face_pair(), side_pair(), steps, error)
      call assertTrue(allocated(error), 'fails at rest')
      if (allocated(error)) call assertTrue(index(error%message, 'at rest') > 0, error%message)
   end subroutine test_pulled

   subroutine test_refused()
      type(tenon_settings) :: s

      call expect(tenon_settings(length=-1.0_wp), 'length = -1.0')
      call expect(tenon_settings(height=0.0_wp), 'height = 0.0')
      call expect(tenon_settings(width=0.0_wp), 'width = 0.0')
      call expect(tenon_settings(arm=0.0_wp), 'arm = 0.0')
      call expect(tenon_settings(arm=100.0_wp, arm_datum='column_axis'), &
         'arm = 100.0 mm from the column axis ends inside the column')
      call expect(tenon_settings(clearance_above=-0.1_wp), 'clearance_above = -0.1')
      call expect(tenon_settings(clearance_below=-0.1_wp), 'clearance_below = -0.1')
      call expect(tenon_settings(extension=-1.0_wp), 'extension = -1.0')
      call expect(tenon_settings(shoulders=.true., shoulder_height=0.0_wp), 'shoulder_height = 0.0')
      call expect(tenon_settings(shoulder_gap=-1.0_wp), 'shoulder_gap = -1.0')
      call expect(tenon_settings(points=0), 'points = 0.0')
      call expect(tenon_settings(side_points=0), 'side_points = 0.0')
      call expect(tenon_settings(side_pressure=-1.0_wp), 'side_pressure = -1.0')
      call expect(joint_with('young_modulus_r', 0.0_wp), 'young_modulus_r = 0.0')
      call expect(joint_with('young_modulus_l', -1.0_wp), 'young_modulus_l = -1.0')
      call expect(tenon_settings(bearing_depth=0.0_wp), 'bearing_depth = 0.0')
      call expect(joint_with('compression_strength_r', 0.0_wp), 'compression_strength_r = 0.0')
      call expect(joint_with('compression_strength_l', 0.0_wp), 'compression_strength_l = 0.0')
      call expect(joint_with('hardening_across', -0.1_wp), 'hardening_across = -0.1')
      call expect(joint_with('hardening_along', -0.1_wp), 'hardening_along = -0.1')
      call expect(tenon_settings(column='stiff'), &
         "column = 'stiff' is unknown: it must be one of elastic, rigid")
      call expect(tenon_settings(wood=wood_properties(criterion='tresca')), &
         "criterion = 'tresca' is unknown: it must be one of none, mises")
      call expect(tenon_settings(displacement_increment=0.0_wp), 'displacement_increment = 0.0')
      call expect(tenon_settings(displacement_increment=1.0e-6_wp), &
         'displacement_increment = 1.0E-6')
      call expect(tenon_settings(gap='none'), &
         "gap = 'none' is unknown: it must be one of mean_plane")
      call expect(tenon_settings(arm_datum='x'), "arm_datum = 'x'")
      call expect(tenon_settings(contact='soft'), "contact = 'soft'")
      call expect(tenon_settings(axial_rule='glue'), "axial_rule = 'glue'")
      call expect(tenon_settings(axial_stiffness=0.0_wp), 'axial_stiffness = 0.0')
      call expect(tenon_settings(contact='hard', through_uinter=.true.), 'through_uinter needs')
      call expect(tenon_settings(axial_rule='force', axial_force=1.0_wp, side_pressure=0.0_wp), &
         'axial_force = 1.0 N has no equilibrium while the joint is open')
      call expect(tenon_settings(axial_rule='force', axial_force=-2.0e4_wp, side_pressure=0.2_wp), &
         'axial_force = -20000.0 N has no equilibrium')
      call expect(tenon_settings(amplitudes=[1.0_wp, 0.5_wp]), 'amplitudes = 0.5 mm after 1.0 mm')
      call expect(tenon_settings(amplitudes=[0.0_wp]), 'amplitudes = 0.0')
      call expect(tenon_settings(amplitudes=[600.0_wp]), 'amplitudes = 600.0')
      call expect(tenon_settings(amplitudes=[1.0_wp], cycles=[1, 2]), 'cycles has 2 entries')
      call expect(tenon_settings(amplitudes=[1.0_wp], cycles=[0]), 'cycles = 0')
      call expect(tenon_settings(displacement=[1.0_wp, 600.0_wp]), 'displacement = 600.0')
      allocate (s%displacement(0))
      call expect(s, 'displacement is empty')
      deallocate (s%displacement)
      allocate (s%amplitudes(0))
      call expect(s, 'amplitudes is empty')
   end subroutine test_refused

   !> Every size of the joint in metres, which the message names with what to write; clearance and
   !> rotation at their limits; all pass where they are accepted.
   subroutine test_sizes()
      character(len=*), parameter :: metres = ' looks like metres, write '
      integer :: i

      call slip(tenon_settings(length=0.25_wp), 'length = 0.25 mm', '0.25'//metres//'250.0;')
      call slip(tenon_settings(height=0.18_wp), 'height = 0.18 mm', '0.18'//metres//'180.0;')
      call slip(tenon_settings(width=0.06_wp), 'width = 0.06 mm', '0.06'//metres//'60.0;')
      call slip(tenon_settings(arm=0.5_wp), 'arm = 0.5 mm', '0.5'//metres//'500.0;')
      call slip(tenon_settings(clearance_above=0.001_wp), 'clearance_above = 0.001 mm', &
         '0.001'//metres//'1.0;')
      call slip(tenon_settings(clearance_below=200.0_wp), 'clearance_below = 200.0 mm', &
         '200.0 looks like micrometres, write 0.2;')
      call slip(tenon_settings(extension=0.06_wp), 'extension = 0.06 mm', '0.06'//metres//'60.0;')
      call slip(tenon_settings(shoulders=.true., shoulder_height=0.05_wp), &
         'shoulder_height = 0.05 mm', '0.05'//metres//'50.0;')
      call slip(tenon_settings(bearing_depth=0.15_wp), 'bearing_depth = 0.15 mm', metres//'150.0;')
      call slip(tenon_settings(column_depth=1.5e5_wp), 'column_depth = 150000.0 mm', &
         'looks like micrometres, write 150.0;')
      call slip(joint_with('young_modulus_r', 3.51e8_wp), 'young_modulus_r = 3.51E8 MPa', &
         'looks like Pa, write 351.0;')
      call slip(joint_with('young_modulus_l', 3.727_wp), 'young_modulus_l = 3.727 MPa', &
         '3.727 looks like GPa, write 3727.0;')
      call slip(joint_with('compression_strength_r', 4700.0_wp), &
         'compression_strength_r = 4700.0 MPa', 'looks like kPa, write 4.7;')
      call slip(joint_with('compression_strength_l', 5.01e7_wp), &
         'compression_strength_l = 5.01E7 MPa', 'looks like Pa, write 50.1;')
      call slip(tenon_settings(side_pressure=2.0e5_wp), 'side_pressure = 200000.0 MPa', &
         'looks like Pa, write 0.2;')
      call slip(tenon_settings(column_load=54.0_wp), 'column_load = 54.0 N', &
         '54.0 looks like kN, write 54000.0;')
      call slip(tenon_settings(displacement_increment=8.0e-4_wp), &
         'displacement_increment = 0.0008 mm', metres//'0.8;')
      ! a record in metres, one of rotations, one in micrometres, one that goes too far
      call slip(tenon_settings(displacement=[0.048_wp, -0.048_wp]), 'displacement = 0.048 mm', &
         '0.048'//metres//'48.0, or like a rotation in rad;')
      call slip(tenon_settings(displacement=[0.096_wp, -0.05_wp]), 'displacement = 0.096 mm', &
         'or like a rotation in rad;')
      call slip(tenon_settings(displacement=[1.0_wp, -4.8e4_wp]), 'displacement = -48000.0 mm', &
         'looks like micrometres, write -48.0')
      call slip(tenon_settings(displacement=[400.0_wp]), &
         'displacement = 400.0 mm is a rotation of 0.8 rad at arm = 500.0 mm, outside', &
         'check its unit and the arm; accept_sizes')
      call slip(tenon_settings(amplitudes=[5.0e-4_wp, 0.048_wp]), 'amplitudes = 0.048 mm', &
         metres//'48.0, ')
      ! the limits: a tenth of the height, 9 mm, a quarter of a radian
      call passes(tenon_settings(height=80.0_wp, clearance_above=8.0_wp), .true.)
      call passes(tenon_settings(height=80.0_wp, clearance_above=8.0000001_wp), .false.)
      call passes(tenon_settings(clearance_below=9.0_wp), .true.)
      call passes(tenon_settings(clearance_below=9.0000001_wp), .false.)
      ! what follows from the height is in range where the height is
      do i = 1, 2
         call passes(tenon_settings(height=5.0_wp, shoulders=i == 2), .true.)
         call passes(tenon_settings(height=4000.0_wp, shoulders=i == 2), .true.)
      end do
      call passes(tenon_settings(displacement=[125.0_wp]), .true.)
      call passes(tenon_settings(displacement=[-125.00001_wp]), .false.)
      call passes(tenon_settings(displacement=[0.130001_wp]), .true.)
      call passes(tenon_settings(displacement=[0.129999_wp]), .false.)
   end subroutine test_sizes

   !> Refused by a message with that start and that part, unless it is accepted.
   subroutine slip(settings, start, part)
      type(tenon_settings), intent(in) :: settings
      character(len=*), intent(in) :: start, part
      type(tenon_settings) :: accepted
      type(error_type), allocatable :: error

      call expect(settings, start)
      call check_tenon_settings(settings, error)
      if (allocated(error)) call assertTrue(index(error%message, part) > 0, error%message)
      accepted = settings
      accepted%accept_sizes = .true.
      call check_tenon_settings(accepted, error)
      ! beyond the arm it has no meaning, and steps without number no end
      if (allocated(error)) call assertTrue(index(error%message, 'must be a number between -') > 0 &
         .or. index(error%message, 'make it larger') > 0, error%message)
   end subroutine slip

   subroutine passes(settings, expected)
      type(tenon_settings), intent(in) :: settings
      logical, intent(in) :: expected
      type(error_type), allocatable :: error

      call check_tenon_settings(settings, error)
      call assertTrue(expected .neqv. allocated(error), 'limit')
   end subroutine passes

   subroutine expect(settings, text)
      type(tenon_settings), intent(in) :: settings
      character(len=*), intent(in) :: text
      type(tenon_step), allocatable :: steps(:)
      type(error_type), allocatable :: error

      call run_tenon(settings, face_pair(), side_pair(), steps, error)
      call assertTrue(allocated(error), text)
      if (.not. allocated(error)) return
      call assertEqual(1, index(error%message, text), error%message)
      call assertTrue(fits_subject(error), error%message)
   end subroutine expect

end module test_replay_tenon_joint
