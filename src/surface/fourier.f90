!> Discrete Fourier transforms by FFTW, of maps and of many lines at once. None is normalised:
!> forward and backward multiplies by the number of points. Plans are estimated, not measured, so
!> that the same input gives the same numbers in every run.
module asperity_surface_fourier
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_double_complex, c_int, &
      c_null_ptr, c_ptr
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: delete_line_transform, easy_length, line_transform, new_line_transform, &
      transform_backward_2d, transform_forward_2d, transform_lines_backward, &
      transform_lines_forward

   !> FFTW's names for what we ask of a plan: to be estimated, and to take arrays of any alignment
   integer(c_int), parameter :: estimate = 64_c_int, unaligned = 2_c_int

   !> Plans for a block of lines of one length.
   type :: line_transform
      !> Points of a line
      integer :: points = 0
      !> Lines of a block
      integer :: lines = 0
      type(c_ptr), private :: forward = c_null_ptr, backward = c_null_ptr
   end type line_transform

   ! For C the last subscript is the fast one: sizes go in reverse order
   interface
      !> Plan from a real map to its spectrum.
      type(c_ptr) function fftw_plan_dft_r2c_2d(n0, n1, input, output, flags) &
         bind(c, name='fftw_plan_dft_r2c_2d')
         import :: c_double, c_double_complex, c_int, c_ptr
         integer(c_int), value, intent(in) :: n0, n1, flags
         real(c_double), intent(inout) :: input(*)
         complex(c_double_complex), intent(inout) :: output(*)
      end function fftw_plan_dft_r2c_2d

      !> Plan from a spectrum to its real map.
      type(c_ptr) function fftw_plan_dft_c2r_2d(n0, n1, input, output, flags) &
         bind(c, name='fftw_plan_dft_c2r_2d')
         import :: c_double, c_double_complex, c_int, c_ptr
         integer(c_int), value, intent(in) :: n0, n1, flags
         complex(c_double_complex), intent(inout) :: input(*)
         real(c_double), intent(inout) :: output(*)
      end function fftw_plan_dft_c2r_2d

      !> Plan from many real lines to their spectra.
      type(c_ptr) function fftw_plan_many_dft_r2c(rank, n, howmany, input, inembed, istride, &
         idist, output, onembed, ostride, odist, flags) bind(c, name='fftw_plan_many_dft_r2c')
         import :: c_double, c_double_complex, c_int, c_ptr
         integer(c_int), value, intent(in) :: rank, howmany, istride, idist, ostride, odist, flags
         integer(c_int), intent(in) :: n(*), inembed(*), onembed(*)
         real(c_double), intent(inout) :: input(*)
         complex(c_double_complex), intent(inout) :: output(*)
      end function fftw_plan_many_dft_r2c

      !> Plan from many spectra to their real lines.
      type(c_ptr) function fftw_plan_many_dft_c2r(rank, n, howmany, input, inembed, istride, &
         idist, output, onembed, ostride, odist, flags) bind(c, name='fftw_plan_many_dft_c2r')
         import :: c_double, c_double_complex, c_int, c_ptr
         integer(c_int), value, intent(in) :: rank, howmany, istride, idist, ostride, odist, flags
         integer(c_int), intent(in) :: n(*), inembed(*), onembed(*)
         complex(c_double_complex), intent(inout) :: input(*)
         real(c_double), intent(inout) :: output(*)
      end function fftw_plan_many_dft_c2r

      !> Carry out a plan from real to complex.
      subroutine fftw_execute_dft_r2c(plan, input, output) bind(c, name='fftw_execute_dft_r2c')
         import :: c_double, c_double_complex, c_ptr
         type(c_ptr), value, intent(in) :: plan
         real(c_double), intent(inout) :: input(*)
         complex(c_double_complex), intent(inout) :: output(*)
      end subroutine fftw_execute_dft_r2c

      !> Carry out a plan from complex to real.
      subroutine fftw_execute_dft_c2r(plan, input, output) bind(c, name='fftw_execute_dft_c2r')
         import :: c_double, c_double_complex, c_ptr
         type(c_ptr), value, intent(in) :: plan
         complex(c_double_complex), intent(inout) :: input(*)
         real(c_double), intent(inout) :: output(*)
      end subroutine fftw_execute_dft_c2r

      !> Free a plan.
      subroutine fftw_destroy_plan(plan) bind(c, name='fftw_destroy_plan')
         import :: c_ptr
         type(c_ptr), value, intent(in) :: plan
      end subroutine fftw_destroy_plan
   end interface

contains

   !> Spectrum of a map: sum over points (i, j) of z exp(-2 pi i ((i-1) (k-1)/nx + (j-1) (l-1)/ny)).
   subroutine transform_forward_2d(heights, spectrum)
      !> nx x ny values; kept
      real(wp), intent(inout), contiguous :: heights(:, :)
      !> Its half with k up to nx/2 + 1, and all l up to ny
      complex(wp), intent(inout), contiguous :: spectrum(:, :)
      type(c_ptr) :: plan

      plan = fftw_plan_dft_r2c_2d(size(heights, 2, c_int), size(heights, 1, c_int), heights, &
         spectrum, ior(estimate, unaligned))
      call fftw_execute_dft_r2c(plan, heights, spectrum)
      call fftw_destroy_plan(plan)
   end subroutine transform_forward_2d

   !> Map of a spectrum, the reverse of `transform_forward_2d` times the number of points.
   subroutine transform_backward_2d(spectrum, heights)
      !> (nx/2 + 1) x ny values; destroyed
      complex(wp), intent(inout), contiguous :: spectrum(:, :)
      !> nx x ny values
      real(wp), intent(inout), contiguous :: heights(:, :)
      type(c_ptr) :: plan

      plan = fftw_plan_dft_c2r_2d(size(heights, 2, c_int), size(heights, 1, c_int), spectrum, &
         heights, ior(estimate, unaligned))
      call fftw_execute_dft_c2r(plan, spectrum, heights)
      call fftw_destroy_plan(plan)
   end subroutine transform_backward_2d

   !> Plans for blocks of lines; to be deleted after use.
   subroutine new_line_transform(transform, lines, spectra)
      !> The plans
      type(line_transform), intent(out) :: transform
      !> Where the lines will be, one after the other: points x lines
      real(wp), intent(inout), contiguous :: lines(:, :)
      !> Where their spectra will be: (points/2 + 1) x lines
      complex(wp), intent(inout), contiguous :: spectra(:, :)
      integer(c_int) :: n(1), half(1)

      transform%points = size(lines, 1)
      transform%lines = size(lines, 2)
      n = size(lines, 1, c_int)
      half = size(spectra, 1, c_int)
      transform%forward = fftw_plan_many_dft_r2c(1_c_int, n, size(lines, 2, c_int), lines, n, &
         1_c_int, n(1), spectra, half, 1_c_int, half(1), ior(estimate, unaligned))
      transform%backward = fftw_plan_many_dft_c2r(1_c_int, n, size(lines, 2, c_int), spectra, &
         half, 1_c_int, half(1), lines, n, 1_c_int, n(1), ior(estimate, unaligned))
   end subroutine new_line_transform

   !> Spectra of a block of lines.
   subroutine transform_lines_forward(transform, lines, spectra)
      !> Plans
      type(line_transform), intent(in) :: transform
      !> The lines; kept
      real(wp), intent(inout), contiguous :: lines(:, :)
      !> Their spectra
      complex(wp), intent(inout), contiguous :: spectra(:, :)

      call fftw_execute_dft_r2c(transform%forward, lines, spectra)
   end subroutine transform_lines_forward

   !> Lines of a block of spectra.
   subroutine transform_lines_backward(transform, spectra, lines)
      !> Plans
      type(line_transform), intent(in) :: transform
      !> The spectra; destroyed
      complex(wp), intent(inout), contiguous :: spectra(:, :)
      !> Their lines
      real(wp), intent(inout), contiguous :: lines(:, :)

      call fftw_execute_dft_c2r(transform%backward, spectra, lines)
   end subroutine transform_lines_backward

   !> Free the plans.
   subroutine delete_line_transform(transform)
      !> Plans
      type(line_transform), intent(inout) :: transform

      if (c_associated(transform%forward)) call fftw_destroy_plan(transform%forward)
      if (c_associated(transform%backward)) call fftw_destroy_plan(transform%backward)
      transform = line_transform()
   end subroutine delete_line_transform

   !> The smallest length from `least` on without other prime factors than 2, 3, 5 and 7, which
   !> FFTW transforms fast; even, as real lines like it.
   pure integer function easy_length(least)
      !> Least length
      integer, intent(in) :: least
      integer, parameter :: primes(4) = [2, 3, 5, 7]
      integer :: i, rest

      easy_length = max(2, least + modulo(least, 2))
      do
         rest = easy_length
         do i = 1, size(primes)
            do while (modulo(rest, primes(i)) == 0)
               rest = rest/primes(i)
            end do
         end do
         if (rest == 1) return
         easy_length = easy_length + 2
      end do
   end function easy_length

end module asperity_surface_fourier
