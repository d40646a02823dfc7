!> Energies of the tenon joint: the work of the load is that of all contact points; each point's
!> split is exact; both together converge with order two.
module test_replay_tenon_energy
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, error_type, evaluate_compiled_law, friction_settings, &
      rule_abaqus, rule_dissipative, stick_summits, wp
   use asperity_law_quadrature_gauss_legendre, only: n_points, nodes, weights
   use asperity_replay_tenon_contact_record, only: contact_record
   use asperity_replay_tenon_energy, only: point_split, stored_energy
   use asperity_replay_tenon_geometry, only: new_tenon_model, tenon_model
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   use extremes, only: largest_of, worsen
   use friction_cases, only: friction_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertGreaterThan, &
      assertGreaterThanOrEqual, assertLessThan, assertTrue, TestMethod, TestSuite
   use measurements, only: record
   use random_inputs, only: random_stream
   use tenon_cases, only: face_pair, plain_joint, run_joint, side_pair
   implicit none
   private
   public :: suite_tenon_energy

   character(len=5), parameter :: contacts(2) = ['hard ', 'rough']

contains

   function suite_tenon_energy() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('tenon energy')
      call suite%addTest(TestMethod('work of the load over the whole programme', test_work))
      call suite%addTest(TestMethod('work with shoulders and other axial rules', test_rules))
      call suite%addTest(TestMethod('work with friction of every kind', test_friction))
      call suite%addTest(TestMethod('split of a point', test_split))
      call suite%addTest(TestMethod('order two in the step', test_order))
      call suite%addTest(TestMethod('ledgers', test_ledgers))
   end function suite_tenon_energy

   !> Part of the last work that is not found in the points, the axial rule and the holding term: at
   !> the end, where the trapezoidal rules agree but for round-off, and at worst on the way, where
   !> they differ by sin^2(half the turn of a step) times the virial of the forces.
   pure function work_mismatch(steps) result(mismatch)
      type(tenon_step), intent(in) :: steps(0:)
      real(wp) :: mismatch(2)
      integer :: i

      mismatch = 0.0_wp
      do i = 0, ubound(steps, 1)
         mismatch(1) = abs(steps(i)%work - steps(i)%contact_work - steps(i)%axial_work &
            - steps(i)%holding_work)/steps(ubound(steps, 1))%work
         call worsen(mismatch(2), mismatch(1))
      end do
   end function work_mismatch

   subroutine test_work()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: mismatch(2)
      integer :: i

      do i = 1, 2
         s = tenon_settings(contact=contacts(i))
         call run_joint(s, steps)
         if (anyExceptions()) return
         mismatch = work_mismatch(steps)
         call record('tenon.work_of_load.'//trim(contacts(i)), mismatch(1))
         call record('tenon.work_of_load_on_the_way.'//trim(contacts(i)), mismatch(2))
         call assertLessThan(mismatch(1), 1.0e-6_wp, trim(contacts(i)))
         call assertLessThan(mismatch(2), 3.0e-6_wp, trim(contacts(i))//' on the way')
         call assertTrue(all(steps%holding_work < 1.0e-8_wp*maxval(steps%work)), 'holding term')
      end do
   end subroutine test_work

   subroutine test_rules()
      character(len=6), parameter :: rules(3) = ['fixed ', 'free  ', 'force ']
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: mismatch(2)
      integer :: i

      s = tenon_settings(axial_force=200.0_wp, amplitudes=[4.0_wp, 16.0_wp])
      do i = 1, 3
         s%axial_rule = rules(i)
         call run_joint(s, steps)
         if (anyExceptions()) return
         mismatch = work_mismatch(steps)
         call assertLessThan(mismatch(1), 1.0e-6_wp, trim(rules(i)))
         call assertLessThan(mismatch(2), 3.0e-5_wp, trim(rules(i))//' on the way')
      end do
      s%axial_rule = 'spring'
      s%shoulders = .true.
      call run_joint(s, steps)
      mismatch = work_mismatch(steps)
      call assertLessThan(mismatch(1), 1.0e-6_wp, 'shoulders')
      call assertLessThan(mismatch(2), 3.0e-5_wp, 'shoulders on the way')
   end subroutine test_rules

   !> Rest and motion, grain, pressure and limit, and summits that stick: the work is found, and
   !> UINTER gives the same joint.
   subroutine test_friction()
      type(friction_settings) :: kinds(3)
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:), through(:)
      type(contact_properties) :: faces
      integer :: i, j

      kinds(1) = friction_settings(static_friction_coefficient=0.7_wp, decay_slip=0.2_wp, &
         pressure_exponent=-0.1_wp, reference_pressure=1.0_wp)
      kinds(2) = friction_settings(friction_coefficient_across=0.3_wp, grain_angle=20.0_wp, &
         shear_limit=1.5_wp)
      kinds(3) = friction_settings(stick=stick_summits, shear_modulus=30.0_wp)
      do i = 1, size(kinds)
         faces = friction_properties(kinds(i))
         do j = 1, 2
            s = tenon_settings(contact=contacts(j), amplitudes=[4.0_wp, 16.0_wp])
            call run_joint(s, steps, faces=faces)
            if (anyExceptions()) return
            call assertLessThan(maxval(work_mismatch(steps)), 3.0e-5_wp, contacts(j))
            call assertGreaterThanOrEqual(minval(steps(1:)%friction - steps(:ubound(steps, 1) &
               - 1)%friction), 0.0_wp, 'friction never gives back')
         end do
         s%through_uinter = .true.
         call run_joint(s, through, faces=faces)
         if (anyExceptions()) return
         call assertLessThan(maxval(abs(through%moment - steps%moment)) &
            /maxval(abs(steps%moment)), 1.0e-8_wp, 'through UINTER')
      end do
   end subroutine test_friction

   !> Random increments of one point, hard and rough, up to yield and beyond: the normal work by
   !> quadrature over pieces without a bend, the tangential work in closed form for the mean of the
   !> two orders "pressure, then slip" and "slip, then pressure".
   subroutine test_split()
      type(tenon_settings) :: s
      type(tenon_model) :: model
      type(contact_properties) :: faces
      type(error_type), allocatable :: error
      type(contact_record) :: start, trial
      type(random_stream) :: stream
      real(wp) :: friction, plastic, coupling, work, split, worst(2), closure, slip, scale
      integer :: i, j

      worst = 0.0_wp
      stream = random_stream(20_int64)
      faces = face_pair()
      do j = 1, 2
         s = tenon_settings(contact=contacts(j), gap='first_touch')
         call new_tenon_model(model, s, faces, side_pair(), error)
         call assertFalse(allocated(error), 'model')
         start = contact_record()
         trial = start
         call press(model, start, -0.1_wp, 0.0_wp, trial)
         do i = 1, 200
            start = trial
            ! closed: after closing only a share of the slip counts
            closure = stream%uniform(0.2_wp, 6.0_wp) + sum(start%indentation)
            slip = stream%uniform(-0.5_wp, 0.5_wp)
            if (i == 1) slip = 0.0_wp
            call press(model, start, closure, slip, trial)
            call point_split(model, 1, start, trial, friction, plastic, coupling)
            work = normal_work(model, start, closure) + slip_work(faces, start, trial, slip)
            split = stored_energy(model, 1, trial) - stored_energy(model, 1, start) &
               + friction + plastic - coupling
            scale = max(stored_energy(model, 1, trial), stored_energy(model, 1, start), plastic)
            call worsen(worst(j), abs(work - split)/scale)
            call assertGreaterThanOrEqual(friction, 0.0_wp, 'friction dissipates')
            call assertGreaterThanOrEqual(plastic, 0.0_wp, 'yield dissipates')
         end do
         call record('tenon.point_split.'//trim(contacts(j)), worst(j))
      end do
      call assertLessThan(worst(1), 1.0e-12_wp, 'hard')
      ! the compiled law's energy is within 1e-10 of the interface's, a hundredth of the wood's
      call assertLessThan(worst(2), 1.0e-11_wp, 'rough')
   end subroutine test_split

   subroutine press(model, start, closure, slip, trial)
      type(tenon_model), intent(inout) :: model
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, slip
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable :: error

      call model%law%close(start, closure, [slip, 0.0_wp], trial, error)
      call assertFalse(allocated(error), 'overclosure found')
      trial%weight = 1.0_wp
   end subroutine press

   !> Integral of the pressure over the closure, split at touch and at the yield pressure.
   real(wp) function normal_work(model, start, closure)
      type(tenon_model), intent(inout) :: model
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure
      integer, parameter :: pieces = 12
      real(wp) :: from, ends(3), low, high, pressure, size
      type(contact_record) :: at
      integer :: i, j, k
      logical :: hard

      hard = model%settings%contact == 'hard'
      low = min(start%closure, closure)
      high = max(start%closure, closure)
      pressure = model%law%wood%yield(1) + model%law%wood%hardening(1)*start%indentation(1)
      ! where the wood begins to yield again
      ends(2) = pressure*model%law%wood%compliance + sum(start%indentation)
      if (.not. hard) ends(2) = ends(2) + overclosure_at(model, pressure)
      ends(2) = min(max(ends(2), low), high)
      ends(1) = low
      ends(3) = high
      if (hard) ends(1) = max(low, min(sum(start%indentation), high))
      normal_work = 0.0_wp
      do k = 1, 2
         size = (ends(k + 1) - ends(k))/pieces
         do j = 1, pieces
            from = ends(k) + (j - 1)*size
            at = start
            do i = 1, n_points
               call press(model, start, from + 0.5_wp*size*(1.0_wp + nodes(i)), 0.0_wp, at)
               normal_work = normal_work + 0.5_wp*size*weights(i)*at%state%pressure
            end do
         end do
      end do
      if (closure < start%closure) normal_work = -normal_work
   end function normal_work

   !> Overclosure of the rough face at a pressure, by bisection of the compiled law.
   real(wp) function overclosure_at(model, pressure)
      type(tenon_model), intent(in) :: model
      real(wp), intent(in) :: pressure
      real(wp) :: low, high, found, stiffness
      integer :: i

      low = 0.0_wp
      high = 1.0_wp
      do i = 1, 100
         overclosure_at = 0.5_wp*(low + high)
         call evaluate_compiled_law(model%law%faces%compiled, &
            model%law%faces%initial_separation - overclosure_at, found, stiffness)
         if (found > pressure) then
            high = overclosure_at
         else
            low = overclosure_at
         end if
      end do
   end function overclosure_at

   !> Tangential work: the mean of both orders, each in closed form.
   pure real(wp) function slip_work(faces, start, trial, slip)
      type(contact_properties), intent(in) :: faces
      type(contact_record), intent(in) :: start, trial
      real(wp), intent(in) :: slip
      real(wp) :: gamma, stick, length

      ! integral of gamma over the slip: stick to gcrit, then slip at gcrit
      gamma = start%state%elastic_slip(1)
      stick = min(abs(slip), faces%critical_slip - sign(1.0_wp, slip)*gamma)
      length = abs(slip) - stick
      slip_work = sign(1.0_wp, slip)*gamma*stick + 0.5_wp*stick**2 + faces%critical_slip*length
      slip_work = slip_work*faces%friction_coefficient/faces%critical_slip &
         *0.5_wp*(start%state%pressure + trial%state%pressure)
   end function slip_work

   !> Work by the trapezoidal rule against the exact ledgers: halving the step quarters the rest.
   subroutine test_order()
      real(wp), parameter :: steps_at(4) = [1.0_wp, 0.5_wp, 0.25_wp, 0.125_wp]
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: rest(4)
      integer :: i, j

      do j = 1, 2
         do i = 1, 4
            s = plain_joint()
            s%contact = contacts(j)
            s%axial_rule = 'spring'
            s%axial_stiffness = 100.0_wp
            s%amplitudes = [24.0_wp]
            s%points = 50
            s%displacement_increment = steps_at(i)
            call run_joint(s, steps)
            if (anyExceptions()) return
            rest(i) = abs(ledger_mismatch(steps))
            call record('tenon.energy_rest.'//trim(contacts(j))//'.'//achar(iachar('0') + i), &
               rest(i))
         end do
         ! order 2 is 3 halvings to 1/64; touch, yield and slip fall within a step at random
         call assertLessThan(rest(4), rest(1)/30.0_wp, 'falls with order two')
         call assertLessThan(rest(4), 2.0e-4_wp, 'is small')
      end do
   end subroutine test_order

   pure real(wp) function ledger_mismatch(steps)
      type(tenon_step), intent(in) :: steps(0:)

      associate (first => steps(0), last => steps(ubound(steps, 1)))
         ledger_mismatch = (last%contact_work - (last%stored - first%stored + last%friction &
            + last%plastic + last%edge - last%elastic_slip))/last%work
      end associate
   end function ledger_mismatch

   !> Dissipation never falls; the dissipative rule has no pressure coupling; faces sum up.
   subroutine test_ledgers()
      type(tenon_settings) :: s
      type(tenon_step), allocatable :: steps(:)
      real(wp) :: work(2), moment(2)
      integer, parameter :: rules(2) = [rule_abaqus, rule_dissipative]
      integer :: i, j, n

      do j = 1, 2
         do i = 1, 2
            s = tenon_settings(contact=contacts(j), amplitudes=[16.0_wp])
            call run_joint(s, steps, face_pair(friction_rule=rules(i)))
            if (anyExceptions()) return
            n = ubound(steps, 1)
            call assertTrue(all(steps(1:)%friction >= steps(:n - 1)%friction), 'friction')
            call assertTrue(all(steps(1:)%plastic >= steps(:n - 1)%plastic), 'plastic')
            call assertEqual(steps(n)%friction, sum(steps(n)%face_friction_energy), &
               1.0e-12_wp*steps(n)%friction, 'faces')
            if (i == 2) call assertEqual(0.0_wp, largest_of(steps%elastic_slip), &
               1.0e-9_wp*steps(n)%work, 'no coupling')
            work(i) = steps(n)%work
            moment(i) = maxval(steps%moment)
         end do
         call record('tenon.dissipative_rule_work.'//trim(contacts(j)), work(2)/work(1) - 1.0_wp)
         call assertEqual(moment(1), moment(2), 0.01_wp*moment(1), 'moment')
         call assertGreaterThan(abs(work(2)/work(1) - 1.0_wp), 1.0e-8_wp, 'another rule')
      end do
   end subroutine test_ledgers

end module test_replay_tenon_energy
