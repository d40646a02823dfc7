!> Sums over the points around each point of a line, weighted by a Gaussian and by powers of the
!> distance: sum over k of (k/scale)^p exp(-pi (k/scale)^2) f(i + k), for lines of equal length with
!> zeros behind their ends, by Fourier transforms.
module asperity_surface_prepare_moment_sums
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_surface_fourier, only: delete_line_transform, easy_length, line_transform, &
      new_line_transform, transform_lines_backward, transform_lines_forward
   implicit none
   private
   public :: delete_moment_sums, moment_sums, new_moment_sums, sum_moments

   !> Highest power
   integer, parameter :: highest_power = 4
   !> Weights below this share of the largest are left out
   real(wp), parameter :: least_weight = 1.0e-16_wp

   !> Transforms of the weights for lines of one length.
   type :: moment_sums
      !> Points of a line, and lines of a block at most
      integer :: points = 0, lines = 0
      !> Lines with zeros behind, their spectra, and a product of these
      real(wp), allocatable, private :: padded(:, :)
      complex(wp), allocatable, private :: spectra(:, :), products(:, :)
      !> By power: the real spectrum of even weights, by i the imaginary one of odd ones
      real(wp), allocatable, private :: passes(:, :)
      type(line_transform), private :: transform
   end type moment_sums

contains

   !> Weights for lines; to be deleted after use.
   subroutine new_moment_sums(sums, points, lines, scale)
      !> The weights
      type(moment_sums), intent(out) :: sums
      !> Points of a line, and lines of a block at most
      integer, intent(in) :: points, lines
      !> Length of the Gaussian, in steps
      real(wp), intent(in) :: scale
      real(wp) :: weight
      integer :: k, length, p, reach

      sums%points = points
      sums%lines = lines
      reach = min(int(scale*sqrt(-log(least_weight)/pi)), points - 1)
      length = easy_length(points + reach)
      allocate (sums%padded(length, lines), sums%spectra(length/2 + 1, lines), &
         sums%products(length/2 + 1, lines), sums%passes(length/2 + 1, 0:highest_power))
      call new_line_transform(sums%transform, sums%padded, sums%spectra)
      do p = 0, highest_power
         sums%padded = 0.0_wp
         if (p == 0) sums%padded(1, 1) = 1.0_wp
         do k = 1, reach
            weight = (real(k, wp)/scale)**p*exp(-pi*(real(k, wp)/scale)**2)
            ! the point k behind is at -k of the one whose sum it enters
            sums%padded(length + 1 - k, 1) = weight
            sums%padded(1 + k, 1) = merge(weight, -weight, mod(p, 2) == 0)
         end do
         call transform_lines_forward(sums%transform, sums%padded, sums%spectra)
         ! transforms there and back multiply by the length
         if (mod(p, 2) == 0) then
            sums%passes(:, p) = real(sums%spectra(:, 1), wp)/real(length, wp)
         else
            sums%passes(:, p) = aimag(sums%spectra(:, 1))/real(length, wp)
         end if
      end do
      sums%padded = 0.0_wp
      sums%products = (0.0_wp, 0.0_wp)
   end subroutine new_moment_sums

   !> The sums of each point of some lines, for the powers 0, 1, 2 ...
   subroutine sum_moments(sums, lines, moments)
      !> The weights; their arrays are worked in
      type(moment_sums), intent(inout) :: sums
      !> Points by lines, at most as many as they take
      real(wp), intent(in) :: lines(:, :)
      !> Points by lines by powers from 0
      real(wp), intent(out) :: moments(:, :, 0:)
      integer :: line, n, p

      n = sums%points
      do line = 1, size(lines, 2)
         sums%padded(:n, line) = lines(:, line)
         sums%padded(n + 1:, line) = 0.0_wp
      end do
      call transform_lines_forward(sums%transform, sums%padded, sums%spectra)
      do p = 0, ubound(moments, 3)
         do line = 1, size(lines, 2)
            if (mod(p, 2) == 0) then
               sums%products(:, line) = sums%spectra(:, line)*sums%passes(:, p)
            else
               sums%products(:, line) = sums%spectra(:, line)*cmplx(0.0_wp, sums%passes(:, p), wp)
            end if
         end do
         call transform_lines_backward(sums%transform, sums%products, sums%padded)
         do line = 1, size(lines, 2)
            moments(:, line, p) = sums%padded(:n, line)
         end do
      end do
   end subroutine sum_moments

   !> Free the plans, which would not go with the variable.
   subroutine delete_moment_sums(sums)
      !> The weights
      type(moment_sums), intent(inout) :: sums

      call delete_line_transform(sums%transform)
   end subroutine delete_moment_sums

end module asperity_surface_prepare_moment_sums
