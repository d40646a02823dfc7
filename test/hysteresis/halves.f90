!> Half cycles of records, and the mean of both skeletons, against formulas.
module test_hysteresis_halves
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_settings
   use extremes, only: worsen
   use funit, only: assertEqual, assertGreaterThan, assertTrue, TestMethod, TestSuite
   use hysteresis_checks, only: analyse
   use hysteresis_models, only: path_through, random_path, record_type, response, spring_type
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_hysteresis_halves

   real(wp), parameter :: exact = 1.0e-12_wp

contains

   function suite_hysteresis_halves() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('hysteresis halves')
      call suite%addTest(TestMethod('halves of a parallelogram', test_parallelogram))
      call suite%addTest(TestMethod('halves make the whole', test_whole))
      call suite%addTest(TestMethod('one-sided cycles', test_one_sided))
      call suite%addTest(TestMethod('mean of equal sides', test_equal_sides))
      call suite%addTest(TestMethod('mean of tips', test_mean_of_tips))
      call suite%addTest(TestMethod('mean of random sides', test_random_sides))
   end function suite_hysteresis_halves

   !> Elastic and plastic, 4 at 0.5, to both sides as far: each half of a loop has half its area.
   subroutine test_parallelogram()
      type(hysteresis_result) :: result
      integer :: side

      call analyse(response(spring_type(stiffness=8.0_wp, limit=[4.0_wp, 4.0_wp]), &
         path_through([2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 0.0_wp], 0.125_wp)), result)
      associate (c => result%cycles(2))
         do side = 1, 2
            call assertEqual(2.0_wp*4.0_wp*1.5_wp, c%half_energy(side), exact, 'half of 24')
            call assertEqual(12.0_wp/(pi*8.0_wp), c%half_damping(side), exact, 'damping')
            call assertEqual(c%damping, c%half_damping(side), exact, 'as of the whole')
         end do
      end associate
   end subroutine test_parallelogram

   !> Unlike sides, random samples: both halves have the work of the loop, and the damping of the
   !> whole is their mean, weighted by F X.
   subroutine test_whole()
      type(hysteresis_result) :: result
      type(record_type) :: loops
      type(random_stream) :: stream
      real(wp), allocatable :: path(:)
      real(wp) :: worst
      integer :: i, n

      stream%state = 20261131
      write (*, '(5x, a, i0)') 'seed ', stream%state
      call random_path(stream, [1.0_wp, -1.5_wp, 2.0_wp, -2.5_wp, 2.0_wp, -2.5_wp, 3.0_wp, &
         -3.5_wp, 0.0_wp], 0.125_wp, path)
      loops = response(spring_type(8.0_wp, [4.0_wp, 3.0_wp], 0.5_wp, 6.0_wp, 5.0_wp), path)
      call analyse(loops, result)
      worst = 0.0_wp
      n = 0
      do i = 1, size(result%cycles)
         associate (c => result%cycles(i))
            if (.not. c%closed) cycle
            n = n + 1
            call worsen(worst, abs(sum(c%half_energy)/c%loop_area - 1.0_wp))
            call worsen(worst, abs(sum(c%half_damping*c%force*c%displacement) &
               /sum(c%force*c%displacement)/c%damping - 1.0_wp))
         end associate
      end do
      call assertGreaterThan(n, 3, message='closed cycles')
      call assertEqual(0.0_wp, worst, exact, 'sums')
   end subroutine test_whole

   !> Up to (2, 10), down to a rest of 1 without force, up to (4, 12), down to 3, and so on: the
   !> loops do not close, and have 10 - 5, 18 - 6 and 21 - 7 of work. The last, which stays out
   !> under force, is no half cycle.
   subroutine test_one_sided()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 2.0_wp, 1.0_wp, 4.0_wp, 3.0_wp, 6.0_wp, 5.0_wp, 8.0_wp]
      loops%force = [0.0_wp, 10.0_wp, 0.0_wp, 12.0_wp, 0.0_wp, 14.0_wp, 0.0_wp, 16.0_wp]
      call analyse(loops, result)
      call assertEqual('one_sided', result%record_kind, 'kind')
      associate (c => result%cycles)
         call assertEqual(4, size(c), 'cycles')
         call assertTrue(.not. any(c%closed), 'none is closed')
         call assertEqual([none, none, none, none], c%damping, 0.0_wp, 'no damping of the whole')
         call assertEqual([5.0_wp, 12.0_wp, 14.0_wp, none], [c(1)%half_energy(1), &
            c(2)%half_energy(1), c(3)%half_energy(1), c(4)%half_energy(1)], exact, 'work')
         call assertEqual([5.0_wp/(20.0_wp*pi), 12.0_wp/(48.0_wp*pi), 14.0_wp/(84.0_wp*pi)], &
            [c(1)%half_damping(1), c(2)%half_damping(1), c(3)%half_damping(1)], exact, 'damping')
         call assertTrue(all(is_none([c(1)%half_damping(2), c(2)%half_damping(2)])), 'other side')
      end associate
      ! with a twentieth of the force left it counts; back by more than half, but with a fifth of
      ! the force, neither this cycle nor the next does
      loops%force(3) = 0.5_wp
      call analyse(loops, result)
      call assertEqual(4.75_wp, result%cycles(1)%half_energy(1), exact, 'a twentieth is left')
      loops%displacement(3) = 0.9_wp
      loops%force(3) = 2.0_wp
      call analyse(loops, result)
      associate (c => result%cycles)
         call assertEqual(4, size(c), 'still cycles')
         call assertEqual([none, none, 14.0_wp], [c(1)%half_energy(1), c(2)%half_energy(1), &
            c(3)%half_energy(1)], exact, 'a fifth is left')
      end associate
   end subroutine test_one_sided

   !> Both sides the same: their mean is either, in all its numbers.
   subroutine test_equal_sides()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops = response(spring_type(8.0_wp, [4.0_wp, 4.0_wp], 0.5_wp), path_through([1.0_wp, &
         -1.0_wp, 2.0_wp, -2.0_wp, 2.0_wp, -2.0_wp, 4.0_wp, -4.0_wp, 0.0_wp], 0.125_wp))
      call analyse(loops, result, hysteresis_settings(peaks='displacement'))
      associate (m => result%mean_skeleton, p => result%skeleton(1))
         call assertEqual(p%displacement, m%displacement, exact, 'displacement')
         call assertEqual(p%force, m%force, exact, 'force')
         call assertEqual(p%cycle, m%cycle, 'cycles')
         call assertEqual([p%yield_force, p%ductility, p%area, p%en_12512%tangent_force], &
            [m%yield_force, m%ductility, m%area, m%en_12512%tangent_force], 10.0_wp*exact, &
            'what follows')
      end associate
      ! nothing to take the mean with
      loops%displacement = [0.0_wp, 1.0_wp, 2.0_wp]
      loops%force = [0.0_wp, 1.0_wp, 1.5_wp]
      call analyse(loops, result)
      call assertEqual(0, size(result%mean_skeleton%force), 'one side')
   end subroutine test_equal_sides

   !> Tips (1, 10), (3, 14), and (-2, -6), (-4, -12): means (1.5, 8), (3.5, 13). A third cycle that
   !> goes further on one side only is no part.
   subroutine test_mean_of_tips()
      type(record_type) :: loops
      type(hysteresis_result) :: result

      loops%displacement = [0.0_wp, 1.0_wp, -2.0_wp, 3.0_wp, -4.0_wp, 5.0_wp, -4.0_wp, 0.0_wp]
      loops%force = [0.0_wp, 10.0_wp, -6.0_wp, 14.0_wp, -12.0_wp, 15.0_wp, -11.0_wp, 0.0_wp]
      call analyse(loops, result, hysteresis_settings(peaks='displacement'))
      associate (m => result%mean_skeleton)
         call assertEqual([1.5_wp, 3.5_wp], m%displacement, exact, 'displacement')
         call assertEqual([8.0_wp, 13.0_wp], m%force, exact, 'force')
         call assertEqual([1, 2], m%cycle, 'cycles')
         call assertEqual([3.5_wp, 13.0_wp], [m%peak_displacement, m%peak_force], exact, 'peak')
      end associate
   end subroutine test_mean_of_tips

   !> Monotonic forces on both sides, random samples, equal tips: at each point of the mean the mean
   !> of both, interpolated here.
   subroutine test_random_sides()
      type(record_type) :: loops
      type(hysteresis_result) :: result
      type(random_stream) :: stream
      real(wp), allocatable :: path(:)
      real(wp) :: worst
      integer :: i

      stream%state = 20261132
      write (*, '(5x, a, i0)') 'seed ', stream%state
      call random_path(stream, [1.0_wp, -1.0_wp, 2.0_wp, -2.0_wp, 4.0_wp, -4.0_wp, 0.0_wp], &
         0.125_wp, path)
      loops%displacement = path
      loops%force = merge(10.0_wp*path/(1.0_wp + path), path**3, path > 0.0_wp)
      call analyse(loops, result)
      worst = 0.0_wp
      associate (m => result%mean_skeleton)
         call assertEqual(4.0_wp, m%displacement(size(m%force)), exact, 'to the tips')
         call assertGreaterThan(size(m%force), size(result%skeleton(1)%force), &
            message='points of both')
         do i = 1, size(m%force)
            call worsen(worst, abs(m%force(i) - 0.5_wp*(force_at(1, m%displacement(i)) &
               - force_at(2, -m%displacement(i)))))
         end do
      end associate
      call assertEqual(0.0_wp, worst, 100.0_wp*exact, 'mean of both')
   contains
      !> Force of a skeleton, by its own interpolation
      pure real(wp) function force_at(side, x)
         integer, intent(in) :: side
         real(wp), intent(in) :: x
         integer :: k

         force_at = 0.0_wp
         associate (s => result%skeleton(side))
            k = count(abs(s%displacement) < abs(x)*(1.0_wp - 1.0e-13_wp)) + 1
            if (k > size(s%force)) k = size(s%force)
            if (k == 1) then
               force_at = s%force(1)*x/s%displacement(1)
            else
               force_at = s%force(k - 1) + (s%force(k) - s%force(k - 1)) &
                  *(x - s%displacement(k - 1))/(s%displacement(k) - s%displacement(k - 1))
            end if
         end associate
      end function force_at
   end subroutine test_random_sides

end module test_hysteresis_halves
