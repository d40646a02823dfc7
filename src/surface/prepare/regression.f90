!> The linear Gaussian regression filter of order 2 (ISO 16610-31 and -71 without their robustness):
!> the value at each point of the polynomial of degree 2 that is fitted to the points around by
!> least squares, with the weights exp(-pi (x^2 + y^2)/(gamma cutoff)^2) times those of the points.
!> Waves pass by (1 + u) exp(-u), u = pi (gamma cutoff/wave)^2: half of one of the cutoff's length.
!> Of order 0 it is the weighted mean, with alpha for gamma.
!>
!> The sums of the normal equations are those of `moment_sums` along x and then along y: 15 and 6 of
!> a map, 5 and 3 of a profile.
module asperity_surface_prepare_regression
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_surface_cholesky, only: factorize, solve
   use asperity_surface_prepare_line_filter, only: alpha
   use asperity_surface_prepare_moment_sums, only: delete_moment_sums, moment_sums, &
      new_moment_sums, sum_moments
   implicit none
   private
   public :: regress

   !> gamma of ISO 16610-31: (1 + u) exp(-u) = 1/2
   real(wp), parameter, public :: gamma_2 = sqrt(1.678346990016661_wp/pi)
   !> Lines of a block
   integer, parameter :: most_lines = 16
   !> Least share of the weights around a point that a fit may rest on, of which rounding is 1e-16
   real(wp), parameter :: least_share = 1.0e-9_wp
   !> Powers of x and y of the terms; those of a profile come first
   integer, parameter :: of_x(6) = [0, 1, 2, 0, 1, 0], of_y(6) = [0, 0, 0, 1, 1, 2]

contains

   !> Fit every point of a map or a profile.
   subroutine regress(z, weights, cutoff_x, cutoff_y, degree, line)
      !> Heights; of no matter where the weight is 0
      real(wp), intent(in) :: z(:, :)
      !> Weights of the points, 0 to 1
      real(wp), intent(in) :: weights(:, :)
      !> Length of the wave of which half passes, in steps along x and y
      real(wp), intent(in) :: cutoff_x, cutoff_y
      !> Order, 0 or 2
      integer, intent(in) :: degree
      !> The fit at each point; `none` where hardly a weight is near
      real(wp), intent(out) :: line(:, :)
      type(moment_sums) :: sums
      real(wp), allocatable :: of_weights(:, :, :), of_heights(:, :, :)
      real(wp) :: least, width
      integer :: first, last, nx, ny

      nx = size(z, 1)
      ny = size(z, 2)
      width = merge(gamma_2, alpha, degree == 2)
      allocate (of_weights(nx, ny, 0:2*degree), of_heights(nx, ny, 0:degree))
      call new_moment_sums(sums, nx, min(most_lines, ny), width*cutoff_x)
      do first = 1, ny, most_lines
         last = min(first + most_lines - 1, ny)
         call sum_moments(sums, weights(:, first:last), of_weights(:, first:last, :))
         call sum_moments(sums, weights(:, first:last)*z(:, first:last), &
            of_heights(:, first:last, :))
      end do
      call delete_moment_sums(sums)
      ! of the sum of the Gaussian over all points
      least = least_share*width*cutoff_x
      if (ny == 1) then
         call fit(reshape(of_weights, [nx, 1, 2*degree + 1, 1]), &
            reshape(of_heights, [nx, 1, degree + 1, 1]), degree + 1, least, line)
      else
         call fit_columns(of_weights, of_heights, width*cutoff_y, least*width*cutoff_y, line)
      end if
   end subroutine regress

   !> Sum along y and fit, some columns at a time.
   subroutine fit_columns(of_weights, of_heights, scale, least, line)
      real(wp), intent(in) :: of_weights(:, :, 0:), of_heights(:, :, 0:)
      real(wp), intent(in) :: scale, least
      real(wp), intent(out) :: line(:, :)
      type(moment_sums) :: sums
      real(wp), allocatable :: w(:, :, :, :), h(:, :, :, :), fitted(:, :)
      integer :: degree, first, last, n, ny, p

      ny = size(line, 2)
      degree = ubound(of_heights, 3)
      call new_moment_sums(sums, ny, min(most_lines, size(line, 1)), scale)
      do first = 1, size(line, 1), most_lines
         last = min(first + most_lines - 1, size(line, 1))
         n = last - first + 1
         allocate (w(ny, n, 0:2*degree, 0:2*degree), h(ny, n, 0:degree, 0:degree), fitted(ny, n))
         do p = 0, 2*degree
            call sum_moments(sums, transpose(of_weights(first:last, :, p)), &
               w(:, :, p, 0:2*degree - p))
            if (p <= degree) call sum_moments(sums, transpose(of_heights(first:last, :, p)), &
               h(:, :, p, 0:degree - p))
         end do
         call fit(w, h, (degree + 1)*(degree + 2)/2, least, fitted)
         line(first:last, :) = transpose(fitted)
         deallocate (w, h, fitted)
      end do
      call delete_moment_sums(sums)
   end subroutine fit_columns

   !> Solve the normal equations of each point. Where the points around do not determine the
   !> polynomial, the weighted mean of them is taken.
   pure subroutine fit(of_weights, of_heights, terms, least, fitted)
      !> Sums over weights, and over weights times heights: points by powers of x and of y
      real(wp), intent(in) :: of_weights(:, :, 0:, 0:), of_heights(:, :, 0:, 0:)
      !> Terms of the polynomial
      integer, intent(in) :: terms
      !> Least sum of weights
      real(wp), intent(in) :: least
      real(wp), intent(out) :: fitted(:, :)
      real(wp) :: matrix(terms, terms), right(terms)
      logical :: is_determined
      integer :: a, b, i, j

      do j = 1, size(fitted, 2)
         do i = 1, size(fitted, 1)
            associate (w => of_weights(i, j, :, :), h => of_heights(i, j, :, :))
               fitted(i, j) = none
               if (.not. w(1, 1) > least) cycle
               do b = 1, terms
                  do a = b, terms
                     matrix(a, b) = w(1 + of_x(a) + of_x(b), 1 + of_y(a) + of_y(b))/w(1, 1)
                  end do
                  right(b) = h(1 + of_x(b), 1 + of_y(b))/w(1, 1)
               end do
               fitted(i, j) = right(1)
               call factorize(matrix, is_determined)
               if (.not. is_determined) cycle
               do a = 1, terms
                  if (matrix(a, a)**2 <= least_share) is_determined = .false.
               end do
               if (.not. is_determined) cycle
               call solve(matrix, right)
               fitted(i, j) = right(1)
            end associate
         end do
      end do
   end subroutine fit

end module asperity_surface_prepare_regression
