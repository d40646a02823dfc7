!> The host that plays ABAQUS, and UINTER under it: cut-backs, rejected increments, repeated calls,
!> analytic stick-slip paths, threads and a million random calls.
module test_replay_abaqus_host
   use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_positive_inf, &
      ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: contact_properties, error_type, evaluate_normal_law, no_opposite_surface, &
      normal_response, wp
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_replay_abaqus_host, only: accept_increment, host_point, new_host_point, &
      run_increment, try_increment
   use asperity_replay_abaqus_record, only: host_record, optional_outputs
   use contact_cases, only: pair_properties
   use funit, only: anyExceptions, assertEqual, assertFalse, assertTrue, TestMethod, TestSuite
   use random_inputs, only: random_stream
   use threads, only: check_two_threads
   implicit none
   private
   public :: suite_replay_host

   procedure(uinter_interface) :: uinter
   integer(int64), parameter :: seed = 22360679_int64
   integer, parameter :: thread_increments = 2000
   real(wp), parameter :: dtime = 0.1_wp

   !> Faults of `spoiled`: an optional output left unset, by its place; 0 is none; what must be
   !> there left unset or no number, from -11 down
   integer, parameter :: n_required = 6
   integer, parameter :: fault_cuts = -1, fault_flips = -2, fault_notes = -3
   integer :: fault = 0
   !> What the first calls got: KIT, MCRD; RDISP and DRDISP
   integer :: noted_calls(2, 4) = 0, noted = 0
   real(wp) :: noted_motion(4, 4) = 0.0_wp

contains

   function suite_replay_host() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('replay host')
      call suite%addTest(TestMethod('analytic path in one direction', test_one_direction))
      call suite%addTest(TestMethod('analytic path in two directions', test_two_directions))
      call suite%addTest(TestMethod('two half increments equal one', test_halves))
      call suite%addTest(TestMethod('same start values, same bits', test_same_bits))
      call suite%addTest(TestMethod('a rejected increment leaves no trace', test_rejected))
      call suite%addTest(TestMethod('cut back on PNEWDT', test_cut_back))
      call suite%addTest(TestMethod('an output left unset or no number is named', test_unset))
      call suite%addTest(TestMethod('an optional output left unset is noted', test_optional))
      call suite%addTest(TestMethod('the first call of an increment', test_first_call))
      call suite%addTest(TestMethod('history keeps every increment', test_history))
      call suite%addTest(TestMethod('two threads give the serial bits', test_threads))
      call suite%addTest(TestMethod('turned slip directions', test_rotation))
      call suite%addTest(TestMethod('a million random calls', test_million))
   end function suite_replay_host

   !> tau = mu p max(-1, min(1, gamma/g)) on a sawtooth at constant overclosure.
   subroutine test_one_direction()
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: gamma, step
      integer :: i

      p = pair_properties()
      law = evaluate_normal_law(p%normal, p%initial_separation - 0.1_wp)
      call new_host_point(point, uinter, p, 2)
      gamma = 0.0_wp
      do i = 1, 60
         step = merge(0.05_wp, -0.05_wp, mod(i, 30) < 15)
         call run_increment(point, 0.1_wp, [step], dtime, error)
         gamma = max(-p%critical_slip, min(p%critical_slip, gamma + step))
         call assertEqual(p%friction_coefficient*law%pressure*gamma/p%critical_slip, &
            point%start%stress(2), 1.0e-13_wp, 'shear stress')
         if (anyExceptions()) return
      end do
   end subroutine test_one_direction

   !> Slip to the plateau along x, then move along y: tan(theta/2) = exp(-s/g).
   subroutine test_two_directions()
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error
      type(normal_response) :: law
      real(wp) :: theta, plateau
      integer :: i
      real(wp), parameter :: step = 0.07_wp

      p = pair_properties()
      law = evaluate_normal_law(p%normal, p%initial_separation - 0.1_wp)
      plateau = p%friction_coefficient*law%pressure
      call new_host_point(point, uinter, p)
      call run_increment(point, 0.1_wp, [2.0_wp, 0.0_wp], dtime, error)
      do i = 1, 30
         call run_increment(point, 0.1_wp, [0.0_wp, step], dtime, error)
         theta = 2.0_wp*atan(exp(-i*step/p%critical_slip))
         call assertEqual(plateau*[sin(theta), cos(theta)], point%start%stress(2:), 1.0e-13_wp, &
            'shear stress')
         call assertEqual(law%pressure, point%start%stress(1), 0.0_wp, 'pressure')
         if (anyExceptions()) return
      end do
   end subroutine test_two_directions

   subroutine test_halves()
      type(random_stream) :: stream
      type(host_point) :: one, two
      type(error_type), allocatable :: error
      real(wp) :: overclosure, from, slip(2)
      integer :: i

      stream = random_stream(seed)
      call new_host_point(one, uinter, pair_properties())
      call new_host_point(two, uinter, pair_properties())
      from = 0.0_wp
      do i = 1, 200
         overclosure = stream%uniform(-0.02_wp, 0.15_wp)
         slip = [stream%uniform(-0.4_wp, 0.4_wp), stream%uniform(-0.4_wp, 0.4_wp)]
         call run_increment(one, overclosure, slip, dtime, error)
         call run_increment(two, 0.5_wp*(from + overclosure), 0.5_wp*slip, 0.5_wp*dtime, error)
         call run_increment(two, overclosure, 0.5_wp*slip, 0.5_wp*dtime, error)
         call assertEqual(one%start%stress, two%start%stress, 1.0e-12_wp, 'stress')
         from = overclosure
         if (anyExceptions()) return
      end do
   end subroutine test_halves

   subroutine test_same_bits()
      type(host_point) :: point
      type(host_record) :: first
      type(error_type), allocatable :: error

      call new_host_point(point, uinter, pair_properties())
      call run_increment(point, 0.08_wp, [0.2_wp, 0.1_wp], dtime, error)
      call try_increment(point, 0.1_wp, [0.3_wp, -0.1_wp], dtime, error)
      first = point%trial
      call try_increment(point, 0.02_wp, [-5.0_wp, 3.0_wp], dtime, error)
      call try_increment(point, no_opposite_surface, [0.0_wp, 0.0_wp], dtime, error)
      call try_increment(point, 0.1_wp, [0.3_wp, -0.1_wp], dtime, error)
      call assertEqual(first%stress, point%trial%stress, 0.0_wp, 'stress')
      call assertEqual(reshape(first%ddsddr, [9]), reshape(point%trial%ddsddr, [9]), 0.0_wp, &
         'tangent')
      call assertEqual(first%statev, point%trial%statev, 0.0_wp, 'state')
      call assertEqual([first%sed, first%sfd], [point%trial%sed, point%trial%sfd], 0.0_wp, 'energy')
   end subroutine test_same_bits

   subroutine test_rejected()
      type(host_point) :: clean, rejected
      type(error_type), allocatable :: error
      integer :: i

      call new_host_point(clean, uinter, pair_properties())
      call new_host_point(rejected, uinter, pair_properties())
      do i = 1, 10
         call run_increment(clean, 0.01_wp*i, [0.1_wp, 0.02_wp*i], dtime, error)
         call try_increment(rejected, -0.02_wp*i, [-1.0_wp, 0.5_wp], dtime, error)
         call try_increment(rejected, 0.3_wp, [2.0_wp, 0.5_wp], dtime, error)
         call run_increment(rejected, 0.01_wp*i, [0.1_wp, 0.02_wp*i], dtime, error)
         call assertEqual(clean%start%stress, rejected%start%stress, 0.0_wp, 'stress')
         call assertEqual(clean%start%statev(:9), rejected%start%statev(:9), 0.0_wp, 'state')
      end do
   end subroutine test_rejected

   !> A routine that asks for a quarter when the motion is large, and passes the rest to UINTER: the
   !> host takes what is asked for, once and twice.
   subroutine test_cut_back()
      type(host_point) :: whole, cut
      type(error_type), allocatable :: error

      call new_host_point(whole, uinter, pair_properties())
      fault = fault_cuts
      call new_host_point(cut, spoiled, pair_properties())
      call run_increment(whole, 0.05_wp, [0.0_wp, 0.0_wp], dtime, error)
      call run_increment(cut, 0.05_wp, [0.0_wp, 0.0_wp], dtime, error)
      call run_increment(whole, 0.1_wp, [0.4_wp, 0.3_wp], dtime, error)
      call run_increment(cut, 0.1_wp, [0.4_wp, 0.3_wp], dtime, error)
      call assertFalse(allocated(error), 'finished')
      call assertEqual([1, 5], [cut%cutbacks, cut%increments], 'cut to a quarter')
      call assertEqual(0.25_wp*dtime, cut%history(2:5)%dtime, 1.0e-15_wp, 'quarters')
      call assertEqual(whole%start%stress, cut%start%stress, 1.0e-13_wp, 'same end')
      call assertEqual(whole%start%rdisp, cut%start%rdisp, 1.0e-15_wp, 'RDISP accumulates')
      call assertEqual(whole%start%time(2), cut%start%time(2), 1.0e-15_wp, 'time')
      call run_increment(cut, 0.1_wp, [-1.6_wp, 1.2_wp], dtime, error)
      call assertEqual([3, 21], [cut%cutbacks, cut%increments], 'cut twice')
      call assertEqual(dtime/16.0_wp, cut%history(6:21)%dtime, 1.0e-15_wp, 'sixteenths')
      call run_increment(cut, ieee_value(1.0_wp, ieee_quiet_nan), [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(allocated(error), 'cut for ever is an error')
   end subroutine test_cut_back

   !> A routine that leaves a required output unset, computes what is no number, or never settles on
   !> open or closed must be caught, and the output named.
   subroutine test_unset()
      type(host_point) :: point
      type(error_type), allocatable :: error
      character(len=*), parameter :: said(n_required) = [character(len=31) :: &
         'UINTER left DDSDDR(3,1) unset', 'UINTER left DDSDDR unset', &
         'UINTER computed STRESS(2), ', 'UINTER computed SED, ', &
         'UINTER computed DDSDDR(1,2), ', 'UINTER computed FLUX(2), ']
      integer :: i

      fault = 0
      call new_host_point(point, spoiled, pair_properties())
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertFalse(allocated(error), 'no fault')
      call assertFalse(any(point%unset), 'nothing unset')
      do i = 1, n_required
         fault = -10 - i
         call new_host_point(point, spoiled, pair_properties())
         call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
         call assertTrue(allocated(error), said(i))
         if (allocated(error)) call assertEqual(1, index(error%message, trim(said(i))), &
            error%message)
      end do
      fault = fault_flips
      call new_host_point(point, spoiled, pair_properties())
      call try_increment(point, 0.1_wp, [0.0_wp, 0.0_wp], dtime, error)
      call assertTrue(allocated(error), 'LOPENCLOSE keeps changing')
      if (allocated(error)) call assertEqual(1, index(error%message, 'LOPENCLOSE keeps changing'))
   end subroutine test_unset

   !> An optional output that is left unset, even in one entry, is noted, counts as zero and changes
   !> nothing else.
   subroutine test_optional()
      type(host_point) :: whole, point
      type(error_type), allocatable :: error
      real(wp) :: totals(4)
      integer :: i

      fault = 0
      call new_host_point(whole, spoiled, pair_properties())
      call run_increment(whole, 0.1_wp, [0.0_wp, 1.0_wp], dtime, error)
      call assertTrue(whole%dissipation(1) > 0.0_wp, 'it slips')
      do fault = 1, size(optional_outputs)
         call new_host_point(point, spoiled, pair_properties())
         call run_increment(point, 0.1_wp, [0.0_wp, 1.0_wp], dtime, error)
         call assertFalse(allocated(error), optional_outputs(fault))
         call assertTrue(all(point%unset .eqv. [(i == fault, i=1, size(optional_outputs))]), &
            optional_outputs(fault))
         call assertEqual(whole%start%stress, point%start%stress, 0.0_wp, 'STRESS')
         totals = whole%dissipation
         where (fault == [6, 7, 8, 9]) totals = 0.0_wp
         call assertEqual(totals, point%dissipation, 0.0_wp, optional_outputs(fault))
      end do
   end subroutine test_optional

   !> In the first call of an increment nothing has moved; in two dimensions COORDS has two entries.
   subroutine test_first_call()
      type(host_point) :: point
      type(error_type), allocatable :: error

      fault = 0
      call new_host_point(point, spoiled, pair_properties(), 2)
      call run_increment(point, 0.1_wp, [0.3_wp], dtime, error)
      fault = fault_notes
      noted = 0
      call run_increment(point, 0.12_wp, [0.1_wp], 2.0_wp*dtime, error)
      call assertEqual(2, noted, 'calls')
      call assertEqual([0, 2, 1, 2], reshape(noted_calls(:, :2), [4]), 'KIT, MCRD')
      call assertEqual([0.1_wp, 0.3_wp, 0.0_wp, 0.0_wp], noted_motion(:, 1), 0.0_wp, 'first')
      call assertEqual([0.12_wp, 0.4_wp, 0.02_wp, 0.1_wp], noted_motion(:, 2), 1.0e-15_wp, &
         'second')
   end subroutine test_first_call

   subroutine test_history()
      type(host_point) :: point
      type(error_type), allocatable :: error
      integer :: i

      call new_host_point(point, uinter, pair_properties())
      do i = 1, 130
         call run_increment(point, 0.001_wp*i, [0.01_wp, 0.0_wp], dtime, error)
      end do
      call assertEqual(130, point%increments, 'count')
      call assertEqual(0.1_wp, point%history(100)%rdisp(1), 1.0e-15_wp, 'RDISP')
      call assertEqual(1.3_wp, point%history(130)%rdisp(2), 1.0e-12_wp, 'accumulated slip')
      call assertEqual(13.0_wp, point%history(130)%time(1), 1.0e-12_wp, 'time')
      call assertEqual(4, point%history(1)%calls, 'LOPENCLOSE changed twice, so two calls each')
      call assertEqual(2, point%history(130)%calls, 'settled')
   end subroutine test_history

   !> Each thread has a pair of its own; both at once give the bits that each gives alone.
   subroutine test_threads()
      call check_two_threads(thread_work, 3)
   end subroutine test_threads

   !> Sums of the stresses over a path of the pair with that number.
   subroutine thread_work(number, sums)
      integer, intent(in) :: number
      real(wp), intent(out) :: sums(:)
      type(random_stream) :: stream
      type(host_point) :: point
      type(error_type), allocatable :: error
      integer :: i

      stream = random_stream(seed + number)
      if (number == 1) then
         call new_host_point(point, uinter, pair_properties(pair='transverse-tangential'), &
            keep_history=.false.)
      else
         call new_host_point(point, uinter, pair_properties(pair='tangential-tangential'), &
            keep_history=.false.)
      end if
      sums = 0.0_wp
      do i = 1, thread_increments
         call try_increment(point, stream%uniform(-0.05_wp, 0.1_wp), [stream%uniform(-0.3_wp, &
            0.3_wp), stream%uniform(-0.3_wp, 0.3_wp)], dtime, error)
         call accept_increment(point)
         sums = sums + point%start%stress
      end do
   end subroutine thread_work

   !> Random motions over the whole range, eight combinations of pair, rule, integration and NDIR,
   !> with rotations, rejected increments and perturbations: every result finite, no negative
   !> pressure, no negative dissipation, shear within mu p.
   subroutine test_million()
      type(random_stream) :: stream
      integer :: bad, case

      stream = random_stream(seed)
      bad = 0
      do case = 0, 7
         call run_random(stream, case, 125000, bad)
      end do
      call assertEqual(0, bad, 'bad calls')
   end subroutine test_million

   subroutine run_random(stream, case, calls, bad)
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: case, calls
      integer, intent(inout) :: bad
      type(contact_properties) :: p
      type(host_point) :: point
      type(error_type), allocatable :: error
      real(wp) :: overclosure, slip(2), angle, rotation(2, 2)
      integer :: i, ndir, linper

      ndir = merge(2, 3, btest(case, 2))
      p = pair_properties(1 + ibits(case, 0, 1), 1 + ibits(case, 1, 1), &
         merge('transverse-tangential', 'tangential-tangential', btest(case, 0)))
      call new_host_point(point, uinter, p, ndir, keep_history=.false.)
      do i = 1, calls
         overclosure = stream%uniform(-0.3_wp, 0.2_wp)
         if (mod(i, 97) == 0) overclosure = no_opposite_surface
         if (mod(i, 89) == 0) overclosure = stream%uniform(-10.0_wp, 3.0_wp)
         slip = [stream%uniform(-0.5_wp, 0.5_wp), stream%uniform(-0.5_wp, 0.5_wp)]
         angle = merge(stream%uniform(-3.0_wp, 3.0_wp), 0.0_wp, mod(i, 5) == 0)
         rotation = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
         linper = merge(1, 0, mod(i, 53) == 0)
         call try_increment(point, overclosure, slip(:ndir - 1), dtime, error, rotation, linper)
         if (allocated(error)) bad = bad + 1
         associate (t => point%trial)
            if (.not. all(ieee_is_finite(t%stress)) .or. .not. all(ieee_is_finite(t%ddsddr)) &
               .or. .not. all(ieee_is_finite(t%statev)) .or. t%pnewdt < 1.0_wp) bad = bad + 1
            if (linper == 1) cycle
            if (.not. all([t%stress(1), t%sfd, t%sed] >= 0.0_wp)) bad = bad + 1
            if (.not. norm2(t%stress(2:)) <= &
               p%friction_coefficient*t%stress(1)*(1.0_wp + 1.0e-14_wp)) bad = bad + 1
         end associate
         if (mod(i, 3) /= 0) call accept_increment(point, rotation)
      end do
   end subroutine run_random

   !> Turned slip directions, through host and UINTER: the same stresses, turned.
   subroutine test_rotation()
      type(host_point) :: fixed, turned
      type(error_type), allocatable :: error
      real(wp) :: q(2, 2), total(2, 2)
      real(wp), parameter :: angle = 0.7_wp, slip(2) = [0.11_wp, -0.06_wp]
      integer :: i

      q = reshape([cos(angle), sin(angle), -sin(angle), cos(angle)], [2, 2])
      call new_host_point(fixed, uinter, pair_properties())
      call new_host_point(turned, uinter, pair_properties())
      total = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])
      do i = 1, 8
         total = matmul(q, total)
         call run_increment(fixed, 0.1_wp, slip*(-1)**(i/3), dtime, error)
         call run_increment(turned, 0.1_wp, matmul(total, slip*(-1)**(i/3)), dtime, error, q)
         call assertEqual(matmul(total, fixed%start%stress(2:)), turned%start%stress(2:), &
            1.0e-14_wp, 'shear stress')
         call assertEqual(fixed%start%sfd, turned%start%sfd, 1.0e-14_wp, 'dissipation')
         call assertEqual(matmul(total, fixed%start%rdisp(2:)), turned%start%rdisp(2:), &
            1.0e-14_wp, 'accumulated motion')
         call assertEqual(reshape(total, [4]), reshape(turned%rotation, [4]), 1.0e-14_wp, &
            'accumulated rotation')
      end do
      call run_increment(turned, ieee_value(1.0_wp, ieee_quiet_nan), slip, dtime, error, q)
      call assertTrue(allocated(error), 'an increment with rotation is not cut')
   end subroutine test_rotation

   !> UINTER with the fault that `fault` names.
   subroutine spoiled( &
      stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, &
      sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, &
      time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, drot, &
      area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, &
      linper, lopenclose, lstate, lsdi, lprint)
      integer, intent(in) :: node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit
      integer, intent(in) :: linper, lprint
      real(wp), intent(inout) :: stress(ndir)
      real(wp), intent(inout) :: ddsddr(ndir, ndir), dviscous(ndir, ndir), dstructural(ndir, ndir)
      real(wp), intent(inout) :: flux(2), ddfddt(2, 2), ddsddt(ndir, 2), ddfddr(2, ndir)
      real(wp), intent(inout) :: statev(nstatv)
      real(wp), intent(inout) :: sed, sfd, spd, svd, scd, pnewdt
      real(wp), intent(in) :: rdisp(ndir), drdisp(ndir), temp(2), dtemp(2)
      real(wp), intent(in) :: predef(2, npred), dpred(2, npred), time(2), dtime, freqr
      character(len=80), intent(in) :: ciname, slname, msname
      real(wp), intent(in) :: props(nprops), coords(mcrd), alocaldir(3, 3), drot(2, 2)
      real(wp), intent(in) :: area, chrlngth
      integer, intent(inout) :: lopenclose, lstate, lsdi

      real(wp) :: poison, nan

      poison = sfd
      nan = ieee_value(1.0_wp, ieee_quiet_nan)
      call uinter( &
         stress, ddsddr, dviscous, dstructural, flux, ddfddt, ddsddt, ddfddr, statev, &
         sed, sfd, spd, svd, scd, pnewdt, rdisp, drdisp, temp, dtemp, predef, dpred, &
         time, dtime, freqr, ciname, slname, msname, props, coords, alocaldir, drot, &
         area, chrlngth, node, ndir, nstatv, npred, nprops, mcrd, kstep, kinc, kit, &
         linper, lopenclose, lstate, lsdi, lprint)
      select case (fault)
      case (fault_cuts)
         if (norm2(drdisp(2:)) > 0.2_wp) pnewdt = 0.25_wp
      case (fault_flips)
         lopenclose = mod(kit, 2)
      case (fault_notes)
         noted = noted + 1
         noted_calls(:, noted) = [kit, mcrd]
         noted_motion(:, noted) = [rdisp, drdisp]
      case (1)
         dviscous(1, 1) = poison
      case (2)
         dstructural(1, ndir) = poison
      case (3)
         ddfddt(2, 1) = poison
      case (4)
         ddsddt(ndir, 2) = poison
      case (5)
         ddfddr(2, ndir) = poison
      case (6)
         sfd = poison
      case (7)
         spd = poison
      case (8)
         svd = poison
      case (9)
         scd = poison
      case (-11)
         ddsddr(ndir, 1) = poison
      case (-12)
         ddsddr = poison
      case (-13)
         stress(2) = nan
      case (-14)
         sed = nan
      case (-15)
         ddsddr(1, 2) = -nan
      case (-16)
         flux(2) = ieee_value(1.0_wp, ieee_positive_inf)
      case default
         continue
      end select
   end subroutine spoiled

end module test_replay_abaqus_host
