!> Fourier transforms: against the sums that define them, there and back.
module test_surface_fourier
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   use asperity_surface_fourier, only: delete_line_transform, easy_length, line_transform, &
      new_line_transform, transform_backward_2d, transform_forward_2d, transform_lines_backward, &
      transform_lines_forward
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertLessThan, TestMethod, TestSuite
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_fourier

   real(wp), parameter :: two_pi = 8.0_wp*atan(1.0_wp)
   !> Rounding of sums of some hundred terms of magnitude one
   real(wp), parameter :: tolerance = 1.0e-12_wp

contains

   function suite_surface_fourier() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_fourier')
      call suite%addTest(TestMethod('maps by their definition, and back', test_maps))
      call suite%addTest(TestMethod('lines by their definition, and back', test_lines))
      call suite%addTest(TestMethod('lengths that transform fast', test_lengths))
   end function suite_surface_fourier

   !> Odd and even sizes, so that a swapped or halved size shows.
   subroutine test_maps()
      integer, parameter :: sizes_x(3) = [6, 7, 5], sizes_y(3) = [5, 4, 7]
      type(random_stream) :: stream
      real(wp), allocatable :: map(:, :), kept(:, :)
      complex(wp), allocatable :: spectrum(:, :)
      complex(wp) :: expected
      integer :: case, i, j, k, l
      real(wp) :: worst

      stream = random_stream(31415_int64)
      do case = 1, size(sizes_x)
         associate (nx => sizes_x(case), ny => sizes_y(case))
            if (allocated(map)) deallocate (map, kept, spectrum)
            allocate (map(nx, ny), kept(nx, ny), spectrum(nx/2 + 1, ny))
            do j = 1, ny
               do i = 1, nx
                  map(i, j) = stream%uniform(-1.0_wp, 1.0_wp)
               end do
            end do
            kept = map
            call transform_forward_2d(map, spectrum)
            call assertLessThan(largest_of(map - kept), tiny(1.0_wp), message='the map is kept')
            worst = 0.0_wp
            do l = 1, ny
               do k = 1, nx/2 + 1
                  expected = (0.0_wp, 0.0_wp)
                  do j = 1, ny
                     do i = 1, nx
                        expected = expected + kept(i, j)*turn(real((i - 1)*(k - 1), wp)/nx &
                           + real((j - 1)*(l - 1), wp)/ny)
                     end do
                  end do
                  call worsen(worst, abs(spectrum(k, l) - expected))
               end do
            end do
            call assertLessThan(worst, tolerance, message='forward')
            call transform_backward_2d(spectrum, map)
            call assertLessThan(largest_of(map/(nx*ny) - kept), tolerance, message='backward')
         end associate
      end do
   end subroutine test_maps

   !> Three lines of ten points.
   subroutine test_lines()
      integer, parameter :: points = 10, n = 3
      type(random_stream) :: stream
      type(line_transform) :: transform
      real(wp) :: lines(points, n), kept(points, n)
      complex(wp) :: spectra(points/2 + 1, n), expected
      integer :: i, k, line
      real(wp) :: worst

      stream = random_stream(2718_int64)
      call new_line_transform(transform, lines, spectra)
      do line = 1, n
         do i = 1, points
            lines(i, line) = stream%uniform(-1.0_wp, 1.0_wp)
         end do
      end do
      kept = lines
      call transform_lines_forward(transform, lines, spectra)
      call assertLessThan(largest_of(lines - kept), tiny(1.0_wp), message='the lines are kept')
      worst = 0.0_wp
      do line = 1, n
         do k = 1, points/2 + 1
            expected = (0.0_wp, 0.0_wp)
            do i = 1, points
               expected = expected + kept(i, line)*turn(real((i - 1)*(k - 1), wp)/points)
            end do
            call worsen(worst, abs(spectra(k, line) - expected))
         end do
      end do
      call assertLessThan(worst, tolerance, message='forward')
      call transform_lines_backward(transform, spectra, lines)
      call assertLessThan(largest_of(lines/points - kept), tolerance, message='backward')
      call delete_line_transform(transform)
      call assertEqual(0, transform%points, message='deleted')
   end subroutine test_lines

   !> exp(-2 pi i x).
   pure complex(wp) function turn(x)
      real(wp), intent(in) :: x

      turn = cmplx(cos(two_pi*x), -sin(two_pi*x), wp)
   end function turn

   !> Even, not below what is asked, and of small factors.
   subroutine test_lengths()
      call assertEqual(2, easy_length(1))
      call assertEqual(2, easy_length(2))
      call assertEqual(4, easy_length(3))
      call assertEqual(12, easy_length(11))
      call assertEqual(126, easy_length(122))
      call assertEqual(4096, easy_length(4096))
      call assertEqual(4116, easy_length(4097))
   end subroutine test_lengths

end module test_surface_fourier
