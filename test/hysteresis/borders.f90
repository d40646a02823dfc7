!> What a record is where that is a close thing: noise, hand-digitised steps, slip, overshoot.
module test_hysteresis_borders
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_analysis, only: hysteresis_result
   use asperity_hysteresis_cycles, only: find_peaks, measure_cycles
   use asperity_hysteresis_envelopes, only: find_envelope
   use asperity_hysteresis_turning_points, only: cut_cycles
   use asperity_hysteresis_types, only: hysteresis_cycle
   use backbone_models, only: backbone_fall, backbone_type, driven, programme_turns
   use extremes, only: worsen
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: add_noise, path_through, record_type, repeat_samples
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_borders

   integer, parameter :: runs = 40
   !> Samples on the way to the peak of the backbone
   real(wp), parameter :: fineness = 200.0_wp

contains

   function suite_hysteresis_borders() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis borders')
      call suite%addTest(TestMethod('noise and hand-digitised steps', test_noise))
      call suite%addTest(TestMethod('slip, overshoot, a programme before a push', test_borders))
      call suite%addTest(TestMethod('begins at a peak', test_begins))
      call suite%addTest(TestMethod('short of zero', test_short_of_zero))
      call suite%addTest(TestMethod('at zero, and once more', test_at_zero))
      call suite%addTest(TestMethod('unloaded to half of the force', test_reloading))
   end function suite_hysteresis_borders

   !> Noise makes no cycles, below the threshold and four times above it. The largest force is off
   !> by the noise of force, and the ultimate displacement by both noises.
   subroutine test_noise()
      type(random_stream) :: stream
      type(backbone_type) :: joint
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp) :: e, worst
      real(wp), parameter :: h = 0.01_wp
      integer :: run

      stream%state = 4711
      write (*, '(5x, a, i0)') 'seed ', stream%state
      worst = 0.0_wp
      do run = 1, runs
         joint = backbone_type(10.0_wp**stream%uniform(-3.0_wp, 6.0_wp), &
            10.0_wp**stream%uniform(-3.0_wp, 3.0_wp), stream%uniform(0.8_wp, 2.0_wp))
         e = merge(0.001_wp, 0.03_wp, modulo(run, 2) == 0)
         loops = driven(joint, joint%displacement*path_through([3.0_wp], 1.0_wp/fineness))
         call add_noise(stream, loops, e*joint%displacement, h*joint%force)
         if (modulo(run, 3) == 0) call repeat_samples(stream, loops)
         call analyse(loops, result)
         call assertEqual('monotonic', result%record_kind(:9), 'kind')
         call assertEqual(1, size(result%cycles), 'one cycle')
         call assertEqual(0, size(result%outliers) + size(result%gaps), 'no remark')
         associate (k => result%skeleton(1), u => backbone_fall(joint, 0.8_wp, .true.))
            call assertEqual(1.0_wp, k%peak_force/joint%force, 1.1_wp*h, 'peak')
            ! there the backbone falls by 0.37 force/displacement
            call assertEqual(u, k%ultimate_displacement, (2.0_wp*e + 2.0_wp*h/0.37_wp + 0.01_wp) &
               *joint%displacement, 'ultimate')
            call worsen(worst, abs(k%ultimate_displacement/u - 1.0_wp))
         end associate
         ! digitised by hand, in steps of 0.05 that are off by as much
         loops = driven(joint, joint%displacement*path_through([3.0_wp], 0.05_wp))
         call add_noise(stream, loops, 0.05_wp*joint%displacement, h*joint%force)
         call analyse(loops, result)
         call assertEqual('monotonic_with_unloading', trim(result%record_kind), 'kind')
         call assertEqual(1, size(result%cycles), 'one cycle')
         call assertEqual(1.0_wp, result%skeleton(1)%peak_force/joint%force, 1.5_wp*h, 'peak')
         ! cyclic, noise of half the threshold and of four times it, whose standard deviation is its
         ! amplitude over root 3. Uniform noise has a median 1.10 that of Gaussian noise; of 1000
         ! samples it is off by 4 %, four times which are allowed
         loops = driven(joint, joint%displacement*path_through(programme_turns([0.5_wp, 1.0_wp, &
            2.0_wp, 3.0_wp], [3, 3, 3, 3], 1.0_wp, .false.), 1.0_wp/fineness))
         e = merge(0.007_wp, 0.06_wp, modulo(run, 2) == 0)
         call add_noise(stream, loops, e*joint%displacement, h*joint%force)
         call analyse(loops, result)
         call assertEqual(1.10_wp, result%displacement_noise*sqrt(3.0_wp) &
            /(e*joint%displacement), 0.16_wp, 'noise')
         call assertTrue(result%noise_sets_threshold, 'makes the threshold')
         call assertEqual('cyclic', trim(result%record_kind), 'kind')
         call assertEqual(12, size(result%cycles), 'cycles')
         call assertEqual(1.0_wp, result%skeleton(1)%peak_force/joint%force, 1.1_wp*h, 'peak')
         call assertEqual(-1.0_wp, result%skeleton(2)%peak_force/joint%force, 1.1_wp*h, 'peak')
      end do
      call record('hysteresis.noisy_ultimate', worst)
   end subroutine test_noise

   !> What is just this and just not that.
   subroutine test_borders()
      type(backbone_type), parameter :: joint = backbone_type(10.0_wp, 1.0_wp, 1.0_wp)

      ! slip to the other side by 1 % of the way, overshoot by 4 % of the peaks beside
      call expect([-0.04_wp, 4.0_wp], 'monotonic_with_unloading')
      call expect([1.0_wp, -0.04_wp, 2.0_wp, -0.08_wp, 4.0_wp, 0.0_wp], 'one_sided')
      ! a small programme on both sides, then a push
      call expect([0.2_wp, -0.2_wp, 0.2_wp, -0.2_wp, 4.0_wp], 'cyclic')
      ! unloaded twice late, and twice early
      call expect([2.0_wp, 0.0_wp, 4.0_wp, 0.0_wp], 'one_sided')
      call expect([2.0_wp, 0.0_wp, 4.0_wp], 'monotonic_with_unloading')
      call expect([0.5_wp, 0.0_wp, 0.5_wp, 0.0_wp, 4.0_wp], 'monotonic_with_unloading')
      ! half a loop from peak to peak
      call expect([1.0_wp, -1.0_wp], 'cyclic')
   contains
      subroutine expect(turns, kind)
         real(wp), intent(in) :: turns(:)
         character(len=*), intent(in) :: kind
         type(hysteresis_result) :: result

         call analyse(driven(joint, path_through(turns, 1.0_wp/fineness)), result)
         call assertEqual(kind, trim(result%record_kind), 'kind')
      end subroutine expect
   end subroutine test_borders

   !> A record that begins further out than half its first turn begins at a peak: it is cut at its
   !> peaks. At just half it is cut at zero.
   subroutine test_begins()
      real(wp), parameter :: half = -0.5_wp, more = nearest(half, -1.0_wp)
      integer, parameter :: turns(4) = [2, 3, 4, 5]

      call expect(half, 0.01_wp, 3, 0.0_wp)
      call expect(more, 0.01_wp, 3, -1.0_wp)
      ! and further out than what counts as zero
      call expect(-0.75_wp, 0.75_wp, 3, 0.0_wp)
      call expect(-0.75_wp, nearest(0.75_wp, -1.0_wp), 3, -1.0_wp)
   contains
      subroutine expect(first, threshold, last, end)
         !> First displacement
         real(wp), intent(in) :: first, threshold
         !> Last sample and end of the first cycle
         integer, intent(in) :: last
         real(wp), intent(in) :: end
         type(hysteresis_cycle), allocatable :: cycles(:)
         real(wp) :: x(5)

         x = [first, 1.0_wp, -1.0_wp, 1.0_wp, -1.0_wp]
         call cut_cycles(x, x, threshold, turns, cycles)
         call assertEqual(2, size(cycles), 'cycles')
         call assertEqual(last, cycles(1)%last, 'last sample')
         call assertEqual(end, cycles(1)%end_displacement, 0.0_wp, 'end')
      end subroutine expect
   end subroutine test_begins

   !> A loop that ends short of zero by the threshold has the force of its end at zero, one that
   !> ends further out has no height there; a peak must be further out than the threshold.
   subroutine test_short_of_zero()
      real(wp), parameter :: threshold = 0.125_wp

      call expect(threshold, 0.25_wp)
      call expect(nearest(threshold, 1.0_wp), none)
      call peak_at(nearest(threshold, 1.0_wp), [2, 3])
      call peak_at(threshold, [0, 3])
   contains
      !> The loop 0.5, 2, -2 and its end: at zero the force is 1 on the way down, 0 at the end.
      subroutine expect(short, pinching)
         real(wp), intent(in) :: short, pinching
         type(hysteresis_cycle) :: loop(1)
         real(wp) :: x(4), f(4)

         x = [0.5_wp, 2.0_wp, -2.0_wp, -short]
         f = [3.0_wp, 1.0_wp, -3.0_wp, 0.0_wp]
         loop%first = 1
         loop%last = 4
         loop%start_force = 3.0_wp
         loop%end_displacement = -short
         loop%closed = .true.
         call find_peaks(x, f, threshold, [.true., .true.], .false., loop(1))
         call measure_cycles(x, f, threshold, 0.0_wp, loop)
         ! (0 - (1 - 3)/2)/(1 + 3)
         call assertEqual(pinching, loop(1)%pinching, 1.0e-15_wp, 'pinching')
      end subroutine expect

      subroutine peak_at(x, peaks)
         real(wp), intent(in) :: x
         integer, intent(in) :: peaks(2)
         type(hysteresis_cycle) :: loop

         loop%first = 1
         loop%last = 3
         call find_peaks([0.0_wp, x, -1.0_wp], [0.0_wp, 1.0_wp, -1.0_wp], threshold, &
            [.true., .true.], .false., loop)
         call assertEqual(peaks, loop%peak, 'peaks')
      end subroutine peak_at
   end subroutine test_short_of_zero

   !> Cycles are cut where the record is first at zero, though it may go back a little and pass it
   !> between two samples later.
   subroutine test_at_zero()
      real(wp), parameter :: x(8) = [0.0_wp, 1.0_wp, -1.0_wp, 0.0_wp, -0.005_wp, 1.0_wp, -1.0_wp, &
         0.0_wp]
      type(hysteresis_cycle), allocatable :: cycles(:)

      call cut_cycles(x, x, 0.01_wp, [2, 3, 6, 7], cycles)
      call assertEqual([4, 8], cycles%last, 'last samples')
      call assertEqual([1, 4], cycles%first, 'first samples')
   end subroutine test_at_zero

   !> A way back on which the force falls below half of what it returns with is an unloading: what
   !> comes after it joins the envelope where the force is again what it was.
   subroutine test_reloading()
      call expect(3.0_wp, [2, 3, 5, 6, 7])
      call expect(nearest(3.0_wp, -1.0_wp), [2, 3, 6, 7])
   contains
      subroutine expect(least, expected)
         real(wp), intent(in) :: least
         integer, intent(in) :: expected(:)
         type(hysteresis_cycle) :: loop(1)
         integer, allocatable :: samples(:), origin(:)
         real(wp) :: left

         loop%first = 1
         loop%last = 7
         loop(1)%peak = [7, 0]
         call find_envelope([0.0_wp, 1.0_wp, 2.0_wp, 1.0_wp, 2.1_wp, 2.2_wp, 3.0_wp], &
            [0.0_wp, 5.0_wp, 10.0_wp, least, 6.0_wp, 10.0_wp, 12.0_wp], 1, 0.01_wp, 0.05_wp, &
            loop, samples, origin, left)
         call assertEqual(size(expected), size(samples), 'samples')
         if (size(samples) == size(expected)) call assertEqual(expected, samples, 'envelope')
      end subroutine expect
   end subroutine test_reloading

end module test_hysteresis_borders
