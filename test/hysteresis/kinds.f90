!> What a record is, for every programme of tests with random joints, and its cycles and envelope,
!> which are known.
module test_hysteresis_kinds
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_analysis, only: hysteresis_result
   use backbone_models, only: backbone_area, backbone_fall, backbone_force, backbone_type, driven, &
      programme_turns
   use funit, only: assertEqual, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: path_through, record_type, total_work
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_kinds

   integer, parameter :: runs = 40
   !> Samples on the way to the peak of the backbone
   real(wp), parameter :: fineness = 200.0_wp

contains

   function suite_hysteresis_kinds() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis kinds')
      call suite%addTest(TestMethod('monotonic', test_monotonic))
      call suite%addTest(TestMethod('EN 26891: unloaded once', test_unloaded_once))
      call suite%addTest(TestMethod('pauses, preloading, way back', test_pauses))
      call suite%addTest(TestMethod('EN 12512, ISO 16670, CUREE', test_programmes))
      call suite%addTest(TestMethod('one-sided', test_one_sided))
      call suite%addTest(TestMethod('back-slips', test_back_slips))
   end function suite_hysteresis_kinds

   !> A joint of any size.
   subroutine new_joint(stream, joint)
      type(random_stream), intent(inout) :: stream
      type(backbone_type), intent(out) :: joint

      joint%force = 10.0_wp**stream%uniform(-3.0_wp, 6.0_wp)
      joint%displacement = 10.0_wp**stream%uniform(-3.0_wp, 3.0_wp)
      joint%unloading = stream%uniform(0.8_wp, 2.0_wp)
   end subroutine new_joint

   !> Analyse a path given in displacements of the largest force, on either side, and compare with
   !> the backbone. Its envelope is the backbone, but for the distance of samples: the largest force
   !> is off by half a step at most, and chords are below a curve by 1/8 of its curvature (2.72 at
   !> most) times the square of a step.
   subroutine check(joint, stream, path, kind, cycles)
      type(backbone_type), intent(in) :: joint
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: path(:)
      character(len=*), intent(in) :: kind
      integer, intent(in) :: cycles
      type(record_type) :: loops
      type(hysteresis_result) :: result
      real(wp) :: s, u, step, last
      integer :: side

      s = merge(1.0_wp, -1.0_wp, stream%uniform(0.0_wp, 1.0_wp) > 0.5_wp)
      step = 1.0_wp/fineness
      loops = driven(joint, s*joint%displacement*path)
      call analyse(loops, result)
      call assertEqual(kind, trim(result%record_kind), 'kind')
      call assertEqual(cycles, size(result%cycles), kind//': cycles')
      call assertEqual(0, size(result%outliers) + size(result%gaps), kind//': no remark')
      call assertEqual(1.0_wp, result%cycles(size(result%cycles))%cumulative_energy &
         /total_work(loops), 1.0e-12_wp, kind//': work')
      do side = 1, 2
         if (kind /= 'cyclic' .and. (side == 1 .neqv. s > 0.0_wp)) then
            call assertEqual(0, size(result%skeleton(side)%force), kind//': no other side')
            cycle
         end if
         associate (k => result%skeleton(side), sign_of => real(3 - 2*side, wp))
            call assertTrue(all(abs(k%force - sign_of*backbone_force(joint, &
               sign_of*k%displacement)) < 1.0e-12_wp*joint%force), kind//': on the backbone')
            call assertEqual(sign_of, k%peak_force/joint%force, 0.7_wp*step**2, kind//': peak')
            call assertEqual(sign_of, k%peak_displacement/joint%displacement, 1.01_wp*step, &
               kind//': displacement of the peak')
            u = backbone_fall(joint, 0.8_wp, .true.)
            call assertTrue(k%ultimate_reached, kind//': falls')
            call assertEqual(sign_of*u, k%ultimate_displacement, &
               4.0_wp*step**2*joint%displacement, kind//': ultimate')
            call assertEqual(backbone_area(joint, u), k%area, &
               8.0_wp*step**2*joint%force*joint%displacement, kind//': area')
            u = backbone_fall(joint, 0.4_wp, .false.)
            last = 0.4_wp*joint%force/u
            call assertEqual(last, k%elastic_stiffness, 8.0_wp*step**2*last, kind//': Ke')
         end associate
      end do
   end subroutine check

   subroutine start(stream, seed)
      type(random_stream), intent(out) :: stream
      integer, intent(in) :: seed

      stream%state = seed
      write (*, '(5x, a, i0)') 'seed ', seed
   end subroutine start

   subroutine test_monotonic()
      type(random_stream) :: stream
      type(backbone_type) :: joint
      integer :: run

      call start(stream, 20261129)
      do run = 1, runs
         call new_joint(stream, joint)
         call check(joint, stream, path_through([stream%uniform(2.0_wp, 6.0_wp)], &
            1.0_wp/fineness), 'monotonic', 1)
      end do
   end subroutine test_monotonic

   !> To 0.4 of the force, back to 0.1 or any other share, to failure.
   subroutine test_unloaded_once()
      type(random_stream) :: stream
      type(backbone_type) :: joint
      real(wp) :: top, bottom
      integer :: run

      call start(stream, 26891)
      do run = 1, runs
         call new_joint(stream, joint)
         top = backbone_fall(joint, 0.4_wp, .false.)/joint%displacement
         bottom = top - stream%uniform(0.5_wp, 1.0_wp)*0.4_wp/(exp(1.0_wp)*joint%unloading)
         call check(joint, stream, path_through([top, bottom, stream%uniform(2.0_wp, 6.0_wp)], &
            1.0_wp/fineness), 'monotonic_with_unloading', 1)
      end do
   end subroutine test_unloaded_once

   !> Pauses with part-unloading anywhere; three loadings before the test; back to zero at its end.
   subroutine test_pauses()
      type(random_stream) :: stream
      type(backbone_type) :: joint
      real(wp) :: turns(9)
      integer :: run, i

      call start(stream, 6891)
      do run = 1, runs
         call new_joint(stream, joint)
         do i = 1, 4
            turns(2*i - 1) = 0.5_wp*i + stream%uniform(0.0_wp, 0.2_wp)
            turns(2*i) = turns(2*i - 1) - stream%uniform(0.02_wp, 0.1_wp)
         end do
         turns(9) = 3.5_wp
         call check(joint, stream, path_through(turns, 1.0_wp/fineness), &
            'monotonic_with_unloading', 1)
         turns(1:6) = [0.1_wp, 0.0_wp, 0.1_wp, 0.0_wp, 0.1_wp, 0.0_wp]
         call check(joint, stream, path_through([turns(1:6), 3.0_wp], 1.0_wp/fineness), &
            'monotonic_with_unloading', 1)
         call check(joint, stream, path_through([3.0_wp, 0.0_wp], 1.0_wp/fineness), &
            'monotonic_with_unloading', 1)
      end do
   end subroutine test_pauses

   !> The programmes as commonly cited: EN 12512, amplitudes in yield displacements; ISO 16670 and
   !> CUREE, shares of the ultimate or of a reference displacement, CUREE with smaller cycles after
   !> each primary one.
   subroutine test_programmes()
      real(wp), parameter :: en(7) = [0.25_wp, 0.5_wp, 0.75_wp, 1.0_wp, 2.0_wp, 4.0_wp, 6.0_wp]
      integer, parameter :: en_times(7) = [1, 1, 3, 3, 3, 3, 3]
      real(wp), parameter :: iso(10) = [0.0125_wp, 0.025_wp, 0.05_wp, 0.075_wp, 0.1_wp, 0.2_wp, &
         0.4_wp, 0.6_wp, 0.8_wp, 1.0_wp]
      integer, parameter :: iso_times(10) = [1, 1, 1, 1, 1, 3, 3, 3, 3, 3]
      real(wp), parameter :: curee(9) = [0.05_wp, 0.075_wp, 0.1_wp, 0.2_wp, 0.3_wp, 0.4_wp, &
         0.7_wp, 1.0_wp, 1.5_wp]
      integer, parameter :: curee_times(9) = [6, 7, 7, 4, 4, 3, 3, 3, 3]
      type(random_stream) :: stream
      type(backbone_type) :: joint
      real(wp) :: scale
      integer :: run

      call start(stream, 16670)
      do run = 1, runs
         call new_joint(stream, joint)
         scale = stream%uniform(0.4_wp, 0.8_wp)
         call check(joint, stream, path_through(programme_turns(scale*en, en_times, 1.0_wp, &
            .false.), 1.0_wp/fineness), 'cyclic', sum(en_times))
         scale = stream%uniform(2.0_wp, 4.0_wp)
         call check(joint, stream, path_through(programme_turns(scale*iso, iso_times, 1.0_wp, &
            .false.), 1.0_wp/fineness), 'cyclic', sum(iso_times))
         scale = stream%uniform(1.5_wp, 3.0_wp)
         call check(joint, stream, path_through(programme_turns(scale*curee, curee_times, 0.75_wp, &
            .false.), 1.0_wp/fineness), 'cyclic', sum(curee_times))
      end do
   end subroutine test_programmes

   !> To one side and back to zero, or to where the force is gone.
   subroutine test_one_sided()
      real(wp), parameter :: amplitudes(6) = [0.25_wp, 0.5_wp, 1.0_wp, 1.5_wp, 2.0_wp, 3.0_wp]
      type(random_stream) :: stream
      type(backbone_type) :: joint
      real(wp) :: turns(12)
      integer :: run, i

      call start(stream, 12512)
      do run = 1, runs
         call new_joint(stream, joint)
         call check(joint, stream, path_through(programme_turns(amplitudes, [1, 1, 3, 3, 3, 1], &
            1.0_wp, .true.), 1.0_wp/fineness), 'one_sided', 12)
         do i = 1, 6
            associate (a => amplitudes(i))
               turns(2*i - 1) = a
               turns(2*i) = max(0.0_wp, a - 1.05_wp*backbone_force(joint, a*joint%displacement) &
                  /(joint%force*exp(1.0_wp)*joint%unloading))
            end associate
         end do
         ! without force, 5 % of the range back or half way: a return
         call check(joint, stream, path_through(turns, 1.0_wp/fineness), 'one_sided', &
            1 + count(turns(2:10:2) < turns(1:9:2) - 0.15_wp .or. &
            turns(2:10:2) < 0.5_wp*turns(1:9:2)))
      end do
   end subroutine test_one_sided

   !> 200 back-slips of 1/169 of the way make no cycles, in a monotonic record and in a cyclic one.
   subroutine test_back_slips()
      type(random_stream) :: stream
      type(backbone_type) :: joint
      real(wp) :: turns(401), x
      type(record_type) :: loops
      type(hysteresis_result) :: plain, slipped
      integer :: run, i

      call start(stream, 200)
      do run = 1, 10
         call new_joint(stream, joint)
         do i = 1, 200
            x = 4.0_wp*(i - stream%uniform(0.1_wp, 0.3_wp))/200.0_wp
            turns(2*i - 1:2*i) = [x, x - 4.0_wp/169.0_wp]
         end do
         turns(401) = 4.0_wp
         call check(joint, stream, path_through(turns, 1.0_wp/fineness), &
            'monotonic_with_unloading', 1)
      end do
      ! on the way to the last amplitude and back
      joint = backbone_type(10.0_wp, 1.0_wp, 1.0_wp)
      loops = driven(joint, path_through([1.0_wp, -1.0_wp, 4.0_wp, -4.0_wp, 0.0_wp], &
         1.0_wp/fineness))
      call analyse(loops, plain)
      loops = driven(joint, path_through([1.0_wp, -1.0_wp, turns(101:), turns(400:101:-1), &
         -4.0_wp, 0.0_wp], 1.0_wp/fineness))
      call analyse(loops, slipped)
      call assertEqual('cyclic', trim(slipped%record_kind), 'kind')
      call assertEqual(size(plain%cycles), size(slipped%cycles), 'cycles')
      call assertEqual([4.0_wp, -4.0_wp], slipped%cycles(2)%displacement, 0.0_wp, 'tips')
      call assertEqual(plain%skeleton(1)%peak_force, slipped%skeleton(1)%peak_force, &
         1.0e-4_wp*plain%skeleton(1)%peak_force, 'peak')
      call assertEqual(plain%skeleton(1)%ultimate_displacement, &
         slipped%skeleton(1)%ultimate_displacement, 1.0e-3_wp, 'ultimate')
   end subroutine test_back_slips

end module test_hysteresis_kinds
