!> The replays with summits that remember: what they find, against the law itself, by integrals and
!> by their ledgers.
module test_replay_memory
   use asperity, only: contact_properties, evaluate_normal_law, error_type, normal_response, &
      status_stick, wp
   use asperity_contact_state, only: contact_state
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_law, only: evaluate_unloading_law
   use asperity_replay_press, only: press_loop, press_settings, press_step, run_press
   use asperity_replay_shear_box, only: run_shear_box, shear_settings, shear_step
   use asperity_replay_tenon_contact_record, only: contact_record, leave_surface
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, assertLessThan, &
      assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use tenon_cases, only: face_pair, plain_joint, run_joint
   implicit none
   private
   public :: suite_memory

contains

   function suite_memory() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('memory')
      call suite%addTest(TestMethod('loops of a press', test_press))
      call suite%addTest(TestMethod('loss of a loop is its area', test_loss))
      call suite%addTest(TestMethod('loops without memory', test_reversible))
      call suite%addTest(TestMethod('shear box that turns', test_shear))
      call suite%addTest(TestMethod('a point that leaves the mortise', test_leaves))
      call suite%addTest(TestMethod('tenon: ledgers close', test_tenon))
      call suite%addTest(TestMethod('tenon through UINTER', test_tenon_uinter))
   end function suite_memory

   !> With the properties of a pair, summits that remember.
   function with_memory(properties) result(memory)
      type(contact_properties), intent(in) :: properties
      type(contact_properties) :: memory

      memory = properties
      memory%normal%unloading = unloading_elastic
   end function with_memory

   !> Peaks of 2, 4.7 and 3 MPa: first loading is the law's, the way back and up again that of the
   !> closest separation so far; a loop below the peak before loses nothing.
   subroutine test_press()
      type(contact_properties) :: p
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: closest
      integer :: i

      p = with_memory(pair_properties())
      call run_press(press_settings(peak=[2.0_wp, 4.7_wp, 3.0_wp], increments=20), p, steps, &
         loops, error)
      call assertFalse(allocated(error), 'runs')
      call assertEqual(121, size(steps), 'start and six ramps')
      closest = huge(closest)
      do i = 1, size(steps)
         associate (s => steps(i))
            closest = min(closest, s%separation)
            call assertEqual(closest, s%closest_separation, 1.0e-16_wp, 'memory')
            law = evaluate_unloading_law(p%normal, closest, s%separation - closest)
            ! of d0 - overclosure, twice rounded
            call assertEqual(law%pressure, s%pressure, 1.0e-11_wp*law%pressure, 'pressure')
            call assertEqual(law%energy, s%energy, 1.0e-11_wp*law%energy, 'recoverable')
            call assertEqual(law%plastic_dissipation, s%plastic_dissipation, &
               1.0e-11_wp*law%plastic_dissipation, 'dissipated')
            call assertEqual(law%area_fraction, s%area_fraction, 1.0e-11_wp*law%area_fraction, &
               'area')
         end associate
         if (anyExceptions()) return
      end do
      associate (up => steps(21 + 10), down => steps(21 - 10))
         call assertEqual(up%pressure, down%pressure, 1.0e-10_wp, 'half way up and down')
         call assertGreaterThan(up%overclosure, down%overclosure + 5.0e-3_wp, 'not as deep')
      end associate
      do i = 1, 3
         law = evaluate_unloading_law(p%normal, loops(i)%closest_separation, &
            p%initial_separation - loops(i)%residual_closure - loops(i)%closest_separation)
         call assertEqual(p%p_open, law%pressure, 1.0e-9_wp*p%p_open, 'residual closure')
      end do
      call assertEqual(0.0_wp, loops(3)%cycle_loss, 1.0e-15_wp, 'nothing below the peak before')
      call assertGreaterThan(loops(2)%residual_closure, loops(1)%residual_closure, 'deeper')
   end subroutine test_press

   !> Trapezoidal areas of loops of pressure over closure, with 350 and 700 increments: second
   !> order, extrapolated, against the ledger. The kink of the second way up is at one of them.
   subroutine test_loss()
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      real(wp) :: area(2, 2), worst
      integer :: i, k, n, first

      do i = 1, 2
         n = 350*i
         call run_press(press_settings('overclosure', [0.12_wp, 0.14_wp], n), &
            with_memory(pair_properties()), steps, loops, error)
         call assertFalse(allocated(error), 'runs')
         do k = 1, 2
            first = 2*n*(k - 1) + 1
            associate (s => steps(first:first + 2*n))
               area(k, i) = 0.5_wp*sum((s(2:)%pressure + s(:2*n)%pressure) &
                  *(s(2:)%overclosure - s(:2*n)%overclosure))
            end associate
         end do
      end do
      worst = maxval(abs((4.0_wp*area(:, 2) - area(:, 1))/3.0_wp/loops%cycle_loss - 1.0_wp))
      call record('press.cycle_loss', worst)
      call assertLessThan(worst, 1.0e-8_wp, 'loss is the area')
   end subroutine test_loss

   !> The reversible law loses nothing, and parts where it met.
   subroutine test_reversible()
      type(contact_properties) :: p
      type(press_step), allocatable :: steps(:)
      type(press_loop), allocatable :: loops(:)
      type(error_type), allocatable :: error
      type(normal_response) :: law

      p = pair_properties()
      call run_press(press_settings(peak=[1.0_wp, 4.7_wp], increments=5), p, steps, loops, error)
      call assertEqual(0.0_wp, loops%cycle_loss, 0.0_wp, 'no loss')
      call assertEqual(0.0_wp, steps%plastic_dissipation, 0.0_wp, 'no dissipation')
      law = evaluate_normal_law(p%normal, p%initial_separation - loops(2)%residual_closure)
      call assertEqual(p%p_open, law%pressure, 1.0e-11_wp*p%p_open, 'parts where it met')
   end subroutine test_reversible

   !> A box whose overlap shrinks and grows again: most is dissipated at rest, then nothing past the
   !> first peak; on the way back the faces stay closer than they came.
   subroutine test_shear()
      type(shear_settings) :: settings
      type(shear_step), allocatable :: steps(:), others(:)
      type(contact_properties) :: p
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: closest, dissipated
      integer :: i

      p = with_memory(pair_properties())
      settings%displacement = [5.0_wp, -5.0_wp, 5.0_wp]
      settings%displacement_increment = 0.5_wp
      call run_shear_box(settings, p, steps, error)
      call assertFalse(allocated(error), 'runs')
      call run_shear_box(settings, pair_properties(), others, error)
      call assertEqual(steps%shear_force, others%shear_force, &
         1.0e-9_wp*maxval(others%shear_force), 'the weight fixes the shear')
      closest = steps(1)%separation
      law = evaluate_unloading_law(p%normal, closest, 0.0_wp)
      dissipated = steps(1)%overlap_area*law%plastic_dissipation
      call assertEqual(dissipated, steps(1)%plastic_dissipation, 1.0e-10_wp*dissipated, 'at rest')
      do i = 2, size(steps)
         closest = min(closest, steps(i)%separation)
         call assertEqual(merge(1.0_wp, 0.0_wp, i <= 11), merge(1.0_wp, 0.0_wp, &
            steps(i)%plastic_dissipation > steps(i - 1)%plastic_dissipation), 0.0_wp, &
            'to the first peak alone')
         law = evaluate_unloading_law(p%normal, closest, steps(i)%separation - closest)
         call assertEqual(law%area_fraction, steps(i)%area_fraction, &
            1.0e-10_wp*law%area_fraction, 'area')
         if (i > 11 .and. abs(steps(i)%displacement) < 4.9_wp) call assertGreaterThan( &
            steps(i)%overclosure, others(i)%overclosure, 'stays closer')
         if (anyExceptions()) return
      end do
   end subroutine test_shear

   !> What leaves a surface keeps how flat it is; a point that never was on one has nothing to keep.
   subroutine test_leaves()
      type(contact_record) :: start, trial

      start%state = contact_state(status=status_stick, overclosure=0.1_wp, largest_closure=0.12_wp)
      call leave_surface(start, trial)
      call assertEqual(0.12_wp, trial%state%largest_closure, 0.0_wp, 'is kept')
      start = contact_record()
      call leave_surface(start, trial)
      call assertLessThan(trial%state%largest_closure, -1.0e30_wp, 'nothing to keep')
   end subroutine test_leaves

   !> Work of the contact points against what is stored, dissipated and lost: second order in the
   !> step, as without memory; the faces' dissipation never falls.
   subroutine test_tenon()
      real(wp), parameter :: steps_at(3) = [0.5_wp, 0.25_wp, 0.125_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: rest(3), share(3)
      integer :: i, n

      do i = 1, 3
         s = plain_joint()
         s%contact = 'rough'
         s%axial_rule = 'spring'
         s%amplitudes = [24.0_wp]
         s%points = 50
         s%displacement_increment = steps_at(i)
         call run_joint(s, steps, with_memory(face_pair()))
         if (anyExceptions()) return
         n = ubound(steps, 1)
         call assertTrue(all(steps(1:)%face_plastic >= steps(:n - 1)%face_plastic), 'faces')
         associate (first => steps(0), last => steps(n))
            rest(i) = abs(last%contact_work - (last%stored - first%stored + last%friction &
               + last%plastic + last%face_plastic + last%edge - last%elastic_slip))/last%work
            share(i) = last%face_plastic/last%work
         end associate
      end do
      call record('tenon.energy_rest.memory', rest(3))
      call record('tenon.face_share.memory', share(3))
      call assertLessThan(rest(3), rest(1)/8.0_wp, 'falls')
      call assertLessThan(rest(3), 0.05_wp*share(3), 'the faces count')
   end subroutine test_tenon

   !> Every point through UINTER: the same but for round-off of the compiled law.
   subroutine test_tenon_uinter()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), others(:)
      type(tenon_point), allocatable :: points(:), other_points(:)
      integer :: n

      s = tenon_settings(points=20, side_points=4, displacement_increment=2.0_wp, &
         amplitudes=[24.0_wp])
      call run_joint(s, steps, with_memory(face_pair()), [12, 30], points)
      s%through_uinter = .true.
      call run_joint(s, others, with_memory(face_pair()), [12, 30], other_points)
      if (anyExceptions()) return
      n = ubound(steps, 1)
      call assertEqual(steps%moment, others%moment, 1.0e-8_wp*maxval(steps%moment), 'moment')
      call assertEqual(steps(n)%face_plastic, others(n)%face_plastic, 1.0e-8_wp*steps(n)%work, &
         'dissipation of the faces')
      call assertEqual(steps(n)%stored, others(n)%stored, 1.0e-8_wp*steps(n)%work, 'stored')
      call assertEqual(points%pressure, other_points%pressure, 1.0e-7_wp, 'pressures')
      call assertEqual(0, count(points%status /= other_points%status), 'status')
   end subroutine test_tenon_uinter

end module test_replay_memory
