!> Samples that cannot be what the test did, and those that can: outliers, gaps, zeros; and what is
!> formed from forces at round-off.
module test_hysteresis_samples
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use backbone_models, only: backbone_type, driven, programme_turns
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: add_noise, path_through, record_type, repeat_samples, response, &
      spring_type, total_work
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_samples

   type(backbone_type), parameter :: joint = backbone_type(10.0_wp, 1.0_wp, 1.0_wp)

contains

   function suite_hysteresis_samples() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis samples')
      call suite%addTest(TestMethod('outliers are left out', test_outliers))
      call suite%addTest(TestMethod('what is no outlier', test_no_outliers))
      call suite%addTest(TestMethod('gaps', test_gaps))
      call suite%addTest(TestMethod('zeros', test_zeros))
      call suite%addTest(TestMethod('forces at round-off', test_round_off))
   end function suite_hysteresis_samples

   function loops_of(stream, noise) result(loops)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: noise
      type(record_type) :: loops

      loops = driven(joint, path_through(programme_turns([0.5_wp, 1.0_wp, 2.0_wp, 3.0_wp], &
         [1, 3, 3, 3], 1.0_wp, .false.), 0.01_wp))
      call add_noise(stream, loops, 0.01_wp*noise, 0.1_wp*noise)
   end function loops_of

   !> Single samples of displacement, of force and of both, above 20 times the noise and 2 % of the
   !> range, at any place: named, and without a trace in the analysis. The work is that of the
   !> record without them.
   subroutine test_outliers()
      type(record_type) :: clean, spoilt
      type(hysteresis_result) :: a, b
      type(random_stream) :: stream
      real(wp) :: leap
      integer :: run, k, last

      stream%state = 400
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do run = 1, 100
         clean = loops_of(stream, 0.5_wp)
         ! not where the displacement turns, where force may well leap
         last = size(clean%force)
         do
            k = int(stream%uniform(20.0_wp, real(last - 20, wp)))
            if (abs(clean%displacement(k + 5) - clean%displacement(k - 5)) > 0.08_wp) exit
         end do
         spoilt = clean
         leap = 10.0_wp**stream%uniform(0.0_wp, 4.0_wp)
         if (stream%uniform(0.0_wp, 1.0_wp) < 0.5_wp) leap = -leap
         if (modulo(run, 3) < 2) spoilt%displacement(k) = spoilt%displacement(k) + leap
         if (modulo(run, 3) > 0) spoilt%force(k) = spoilt%force(k) + 5.0_wp*leap
         call analyse(spoilt, b)
         call assertTrue(size(b%outliers) > 0, 'found')
         if (size(b%outliers) == 0) return
         call assertTrue(all(b%outliers%sample == k), 'its sample')
         if (modulo(run, 3) < 2) then
            call assertEqual('displacement', trim(b%outliers(1)%quantity), 'quantity')
            call assertEqual(spoilt%displacement(k), b%outliers(1)%value, 0.0_wp, 'value')
         else
            call assertEqual('force', trim(b%outliers(1)%quantity), 'quantity')
            call assertEqual(spoilt%force(k), b%outliers(1)%value, 0.0_wp, 'value')
         end if
         clean%displacement = [clean%displacement(:k - 1), clean%displacement(k + 1:)]
         clean%force = [clean%force(:k - 1), clean%force(k + 1:)]
         call analyse(clean, a)
         call assertEqual(size(a%cycles), size(b%cycles), 'cycles')
         call assertEqual(total_work(clean), b%cycles(size(b%cycles))%cumulative_energy, &
            1.0e-12_wp*total_work(clean), 'work')
         call assertEqual(a%skeleton%peak_force, b%skeleton%peak_force, 0.0_wp, 'peak')
         call assertEqual(a%skeleton%ultimate_displacement, b%skeleton%ultimate_displacement, &
            1.0e-3_wp, 'ultimate')
      end do
      ! as measured, if so wished
      call analyse(spoilt, b, hysteresis_settings(outliers='keep'))
      call assertTrue(size(b%outliers) > 0, 'still named')
      call assertEqual(total_work(spoilt), b%cycles(size(b%cycles))%cumulative_energy, &
         1.0e-12_wp*sum(abs(spoilt%force)), 'work as measured')
   end subroutine test_outliers

   !> Noise, repeated samples, brittle drops, tips of slack loops with few samples, and records of
   !> tips alone.
   subroutine test_no_outliers()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      integer :: run, i

      stream%state = 401
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do run = 1, 100
         loops = loops_of(stream, stream%uniform(0.0_wp, 3.0_wp))
         if (modulo(run, 2) == 0) call repeat_samples(stream, loops)
         ! cracks: the force falls to a half and stays there
         if (modulo(run, 3) == 0) then
            i = size(loops%force)/2
            loops%force(i:) = 0.5_wp*loops%force(i:)
         end if
         call analyse(loops, result)
         call assertEqual(0, size(result%outliers), 'noise and cracks')
      end do
      ! all the force within one step of the tip
      loops = driven(backbone_type(10.0_wp, 1.0_wp, 40.0_wp), path_through(programme_turns( &
         [1.0_wp, 2.0_wp], [3, 3], 1.0_wp, .false.), 0.125_wp))
      call analyse(loops, result)
      call assertEqual(0, size(result%outliers), 'slack loops')
      loops = driven(joint, programme_turns([0.1_wp, 0.2_wp, 1.0_wp, 2.0_wp, 3.0_wp], &
         [6, 3, 3, 3, 3], 0.75_wp, .false.))
      call analyse(loops, result)
      call assertEqual(0, size(result%outliers) + size(result%gaps), 'tips alone')
   end subroutine test_no_outliers

   !> Samples that are missing, and steps that grow with the amplitude.
   subroutine test_gaps()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      real(wp) :: speed
      integer :: run, i, k, n

      stream%state = 402
      write (*, '(5x, a, i0)') 'seed ', stream%state
      do run = 1, 50
         loops = loops_of(stream, 0.5_wp)
         n = size(loops%force)
         ! well inside the way from 3 to -3
         k = n - 900 + int(stream%uniform(100.0_wp, 400.0_wp))
         loops%displacement = [loops%displacement(:k), loops%displacement(k + 30:)]
         loops%force = [loops%force(:k), loops%force(k + 30:)]
         call analyse(loops, result)
         call assertEqual(1, size(result%gaps), 'one gap')
         if (size(result%gaps) /= 1) return
         call assertEqual(k, result%gaps(1)%sample, 'after this sample')
         call assertEqual(0.3_wp, result%gaps(1)%step, 0.0101_wp, 'its step')
      end do
      ! sine waves of one period, 40 samples each, with a rest before and after
      loops%displacement = [(0.0_wp, i=1, 30), &
         (0.1_wp*sin(0.05_wp*acos(-1.0_wp)*i), i=0, 80), (0.0_wp, i=1, 30), &
         (10.0_wp*sin(0.05_wp*acos(-1.0_wp)*i), i=0, 80), (0.0_wp, i=1, 30)]
      loops%force = loops%displacement
      call analyse(loops, result)
      call assertEqual(0, size(result%gaps), 'speeds')
      speed = maxval(abs(loops%displacement(2:) - loops%displacement(:size(loops%force) - 1)))
      call assertTrue(speed > 1.0_wp, 'which differ')
   end subroutine test_gaps

   !> A record displaced or loaded as a whole, and one that begins at a peak.
   subroutine test_zeros()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream

      stream%state = 403
      write (*, '(5x, a, i0)') 'seed ', stream%state
      loops = loops_of(stream, 0.2_wp)
      call analyse(loops, result)
      call assertEqual([none, none], [result%unloaded_displacement, &
         result%loaded_force], 0.0_wp, 'zeros are right')
      loops%displacement = loops%displacement + 60.0_wp
      call analyse(loops, result)
      call assertEqual(60.0_wp, result%unloaded_displacement, 0.002_wp, 'not zeroed')
      call assertEqual('cyclic', trim(result%record_kind), 'what it is about its own zero')
      loops%displacement = loops%displacement - 60.0_wp
      loops%force = loops%force + 2.0_wp
      call analyse(loops, result)
      call assertEqual(2.0_wp, result%loaded_force, 0.02_wp, 'force not zeroed')
      loops%displacement = [3.0_wp, -3.0_wp, 3.0_wp]
      loops%force = [2.0_wp, -2.0_wp, 2.0_wp]
      call analyse(loops, result)
      call assertEqual([none, none], [result%unloaded_displacement, &
         result%loaded_force], 0.0_wp, 'begun at a peak')
   end subroutine test_zeros

   !> A joint with play: no stiffness, damping or ratio of the cycles within it, nor of a record
   !> that has nothing but round-off.
   subroutine test_round_off()
      type(record_type) :: loops, back
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      integer :: i

      stream%state = 404
      write (*, '(5x, a, i0)') 'seed ', stream%state
      loops = response(spring_type(stiffness=8.0_wp, limit=[4.0_wp, 4.0_wp]), &
         path_through([1.0_wp, -1.0_wp, 2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], 0.125_wp))
      where (abs(loops%displacement) <= 1.0_wp) loops%force = 0.0_wp
      do i = 1, size(loops%force)
         loops%force(i) = loops%force(i) + stream%uniform(-1.0e-12_wp, 1.0e-12_wp)
      end do
      call analyse(loops, result)
      associate (c => result%cycles(1))
         call assertEqual([none, none, none, none, none, none], &
            [c%secant_stiffness, c%mean_secant_stiffness, c%stiffness_ratio, c%damping, &
            c%pinching, c%fullness], 0.0_wp, &
            'play')
         call assertEqual(0.0_wp, c%energy, 1.0e-10_wp, 'its work')
      end associate
      call assertEqual(2.0_wp, result%cycles(2)%secant_stiffness, 1.0e-11_wp, 'beyond it')
      call assertEqual(none, result%cycles(2)%stiffness_ratio, 0.0_wp, 'over nothing')
      call assertTrue(result%cycles(3)%damping < 1.0_wp, 'damping')
      ! a loop that gives energy back
      back = response(spring_type(stiffness=8.0_wp, limit=[4.0_wp, 4.0_wp]), &
         path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], 0.125_wp))
      back%force = 4.0_wp*back%displacement - back%force
      call analyse(back, result)
      associate (c => result%cycles(2))
         call assertTrue(c%closed .and. c%loop_area < 0.0_wp, 'energy back')
         call assertEqual([none, none, none], [c%damping, c%pinching, c%fullness], &
            0.0_wp, 'is no damping')
      end associate
      call analyse(loops, result)
      ! a floor from outside
      loops%force = 1.0e-9_wp*loops%force
      call analyse(loops, result, hysteresis_settings(force_floor=1.0e-7_wp))
      do i = 1, 3
         associate (c => result%cycles(i))
            call assertEqual([none, none, none, none, none, none], &
               [c%secant_stiffness, c%mean_secant_stiffness, c%stiffness_ratio, c%damping, &
            c%pinching, c%fullness], 0.0_wp, &
               'below the floor')
         end associate
      end do
      call assertEqual([none, none], result%skeleton%peak_force, 0.0_wp, 'no peak')
      call assertEqual([none, none], result%skeleton%elastic_stiffness, 0.0_wp, 'no Ke')
   end subroutine test_round_off

end module test_hysteresis_samples
