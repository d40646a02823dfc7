!> Differences of the residuals by the parameters, and what they say at the end of a fit: intervals,
!> correlations, and which directions of the parameters the record tells apart.
module asperity_fit_sensitivities
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_finite, only: all_below, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_student, only: student_factor
   use asperity_fit_gsl_linear, only: decompose
   use asperity_fit_parameter, only: ends_of, fit_parameter, share_of, value_of, y_of
   use asperity_fit_problem, only: fit_problem, refused_residual, rounding
   use asperity_fit_types, only: fit_result, fit_settings
   implicit none
   private
   public :: differentiate, describe_minimum

   !> The end may be so far from the minimum, in standard errors, or of y
   real(wp), parameter :: most_step = 0.01_wp, least_step = 1.0e-6_wp
   !> How often a step is halved that leads nowhere
   integer, parameter :: most_halvings = 8
   !> A parameter is at its bound within this share of the way between its bounds
   real(wp), parameter :: bound_share = 1.0e-3_wp
   !> Directions that residuals feel less than the strongest by this factor are lost in the errors
   !> of differences
   real(wp), parameter :: difference_error = 1.0e-6_wp
   !> Largest standard error along a direction that counts as settled
   real(wp), parameter :: largest_error = 0.5_wp
   !> Standard error along one of which nothing is known
   real(wp), parameter :: unknown = 1.0e100_wp

contains

   !> d(residuals)/dy by central differences, on one side at a bound and where the other side cannot
   !> be evaluated.
   recursive subroutine differentiate(problem, parameters, y, step, transposed, fine)
      !> The problem
      class(fit_problem), intent(in) :: problem
      !> Its parameters, and where
      type(fit_parameter), intent(in) :: parameters(:)
      real(wp), intent(in) :: y(:)
      !> Step over the way between the bounds
      real(wp), intent(in) :: step
      !> A row for each parameter
      real(wp), intent(out) :: transposed(:, :)
      !> Whether it succeeded
      logical, intent(out) :: fine
      real(wp), allocatable :: values(:, :), residuals(:, :)
      logical, allocatable :: failed(:)
      real(wp) :: moved(size(y)), ends(2, size(y))
      integer :: i, k, p

      p = size(y)
      allocate (values(p, 2*p + 1), residuals(size(transposed, 2), 2*p + 1), failed(2*p + 1))
      do i = 1, p
         associate (low => y_of(parameters(i), parameters(i)%lower), &
               high => y_of(parameters(i), parameters(i)%upper))
            ends(:, i) = [min(y(i) + step*(high - low), high), max(y(i) - step*(high - low), low)]
         end associate
         do k = 1, 2
            moved = y
            moved(i) = ends(k, i)
            values(:, 2*i - 2 + k) = value_of(parameters, moved)
         end do
      end do
      values(:, 2*p + 1) = value_of(parameters, y)
      call problem%several_residuals(values, residuals, failed)
      do i = 1, size(failed)
         if (.not. failed(i)) failed(i) = .not. all_below(residuals(:, i), refused_residual)
      end do
      fine = .not. failed(2*p + 1)
      do i = 1, p
         do k = 1, 2
            if (.not. failed(2*i - 2 + k)) cycle
            residuals(:, 2*i - 2 + k) = residuals(:, 2*p + 1)
            ends(k, i) = y(i)
         end do
         fine = fine .and. ends(1, i) > ends(2, i)
         if (.not. fine) return
         transposed(i, :) = (residuals(:, 2*i - 1) - residuals(:, 2*i))/(ends(1, i) - ends(2, i))
      end do
      fine = all(is_finite(transposed))
   end subroutine differentiate

   !> Intervals, correlations and directions at the end of a fit.
   subroutine describe_minimum(problem, parameters, settings, y, result, error)
      !> The problem
      class(fit_problem), intent(in) :: problem
      !> Its parameters, and where
      type(fit_parameter), intent(in) :: parameters(:)
      !> How it was sought
      type(fit_settings), intent(in) :: settings
      !> Where
      real(wp), intent(in) :: y(:)
      !> With values and residuals on entry
      type(fit_result), intent(inout) :: result
      !> Set when the model cannot be evaluated around, or this is no minimum
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: transposed(:, :), strength(:), right(:, :), covariance(:, :)
      real(wp) :: noise, factor
      logical :: fine
      integer :: i, j, p

      p = size(y)
      allocate (transposed(p, size(result%residuals)), strength(p), right(p, p), covariance(p, p))
      call differentiate(problem, parameters, y, settings%difference_step, transposed, fine)
      result%evaluations = result%evaluations + 2*p + 1
      if (fine) call decompose(transposed, strength, right, fine)
      if (.not. fine) then
         call fatal_error(error, 'the model cannot be evaluated around the values found', &
            computation_error)
         return
      end if
      result%degrees_of_freedom = size(result%residuals) - p
      noise = sqrt(result%chi_squared/result%degrees_of_freedom)
      result%directions = right
      result%direction_errors = noise/max(strength, 1.0e-3_wp*difference_error*strength(1), &
         noise/unknown, tiny(noise))
      result%settled = strength > difference_error*strength(1) &
         .and. result%direction_errors < largest_error
      do j = 1, p
         do i = 1, p
            covariance(i, j) = sum(right(i, :)*right(j, :)*result%direction_errors**2)
         end do
      end do
      factor = student_factor(settings%confidence, result%degrees_of_freedom)
      allocate (result%standard_errors(p), result%lower(p), result%upper(p), &
         result%correlations(p, p), result%at_bound(p))
      do i = 1, p
         result%standard_errors(i) = sqrt(covariance(i, i))
         associate (ends => ends_of(parameters(i), y(i), factor*result%standard_errors(i)), &
               share => share_of(parameters(i), y(i)))
            result%lower(i) = ends(1)
            result%upper(i) = ends(2)
            result%at_bound(i) = min(share, 1.0_wp - share) < bound_share
         end associate
         do j = 1, p
            result%correlations(i, j) = covariance(i, j) &
               /max(sqrt(covariance(i, i))*sqrt(covariance(j, j)), tiny(noise))
         end do
      end do
      call check_step(problem, parameters, y, transposed, noise, result, error)
   end subroutine describe_minimum

   !> Set `error` when a step of Gauss and Newton along what is settled, or a part of it, leads
   !> lower: where the model has a kink, such as from stick to slip, the minimum may lie on it, and
   !> the step from there leads nowhere. `left` has the columns of U in its rows.
   subroutine check_step(problem, parameters, y, left, noise, result, error)
      class(fit_problem), intent(in) :: problem
      type(fit_parameter), intent(in) :: parameters(:)
      real(wp), intent(in) :: y(:), left(:, :), noise
      type(fit_result), intent(inout) :: result
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: refusal
      real(wp) :: along(size(y)), step(size(y)), residuals(size(result%residuals))
      integer :: i

      ! a model that is met to rounding has no better place
      if (any(result%at_bound) .or. noise <= rounding) return
      ! in standard errors along each direction
      along = merge(matmul(left, result%residuals)/noise, 0.0_wp, result%settled)
      step = matmul(result%directions, along*result%direction_errors)
      if (norm2(along) <= most_step .or. all(abs(step) <= least_step)) return
      do i = 0, most_halvings
         call problem%residuals(value_of(parameters, min(max(y - step/2**i, &
            y_of(parameters, parameters%lower)), y_of(parameters, parameters%upper))), residuals, &
            refusal)
         result%evaluations = result%evaluations + 1
         if (allocated(refusal) .or. .not. all(is_finite(residuals))) cycle
         if (.not. sum(residuals**2) < result%chi_squared - (most_step*noise)**2) cycle
         call fatal_error(error, 'the search ended '//to_text(norm2(along), 2)// &
            ' standard errors from the minimum after '//to_text(result%iterations)// &
            ' iterations: begin nearer, or free fewer parameters', computation_error)
         return
      end do
   end subroutine check_step

end module asperity_fit_sensitivities
