!> Nonlinear least squares with bounded parameters: GSL's trust region (Levenberg-Marquardt), and
!> checks of our own of what it calls a success.
!>
!> GSL 2.7.1 takes a point that is no number for converged, tests the gradient in the units of the
!> residuals, and asks again and again for a point that is refused. So residuals have no units, the
!> parameters are free of bounds, a set that cannot be evaluated gives huge residuals, and the end is
!> tested here: finite, no worse than the start, and no step of Gauss and Newton left.
module asperity_fit_least_squares
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int, &
      c_loc, c_null_funptr, c_null_ptr, c_ptr, c_size_t
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_student, only: student_factor
   use asperity_fit_gsl_linear, only: decompose, view_of_vector
   use asperity_fit_gsl_multifit, only: c_alloc, c_default_parameters, c_driver, c_free, &
      c_iterations, c_position, c_set_error_handler_off, c_winit, gsl_ebadfunc, gsl_emaxiter, &
      gsl_fdf, gsl_matrix, gsl_parameters, gsl_success, gsl_trust, gsl_vector
   use asperity_fit_parameter, only: check_parameters, fit_parameter, free_of, plain_slope, &
      spread_of, value_of, y_of
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_types, only: fit_result, fit_settings
   implicit none
   private
   public :: fit_least_squares

   !> Residual where the model cannot be evaluated: any step there is taken back
   real(wp), parameter :: refused_residual = 1.0e30_wp
   !> The end may be so far from the minimum, in standard errors, or of the parameter itself
   real(wp), parameter :: most_step = 0.01_wp, least_step = 1.0e-6_wp
   !> A parameter is at its bound within this share of the way between its bounds
   real(wp), parameter :: bound_share = 1.0e-3_wp
   !> Directions that residuals feel less than the strongest by this factor are unknown
   real(wp), parameter :: round_off = 1.0e-12_wp

   !> What GSL hands back to the callbacks
   type :: fit_context
      class(fit_problem), pointer :: problem => null()
      type(fit_parameter), allocatable :: parameters(:)
      real(wp) :: step = 0.0_wp
      integer :: evaluations = 0
   end type fit_context

contains

   !> Find the values of least squared residuals.
   subroutine fit_least_squares(problem, n_residuals, parameters, settings, result, error)
      !> Model and record
      class(fit_problem), intent(inout), target :: problem
      !> Number of residuals
      integer, intent(in) :: n_residuals
      !> Free parameters, in the order of the problem
      type(fit_parameter), intent(in) :: parameters(:)
      !> How it is sought
      type(fit_settings), intent(in) :: settings
      !> What was found
      type(fit_result), intent(out) :: result
      !> Set when the input is refused, the model fails at the start, or no minimum is found
      type(error_type), allocatable, intent(out) :: error
      type(fit_context), target :: context
      real(wp), allocatable, target :: t(:)
      real(wp), allocatable :: start(:)
      integer(c_int) :: status

      call check_parameters(parameters, error)
      if (allocated(error)) return
      if (n_residuals <= size(parameters)) then
         call fatal_error(error, to_text(n_residuals)//' numbers of the record cannot settle '// &
            to_text(size(parameters))//' free parameters: free fewer, or give more')
         return
      end if
      allocate (result%residuals(n_residuals))
      allocate (start(size(parameters)))
      start = parameters%start
      call problem%residuals(start, result%residuals, error)
      if (allocated(error)) return
      result%start_chi_squared = sum(result%residuals**2)
      if (.not. is_finite(result%start_chi_squared)) then
         call fatal_error(error, 'the model gives no finite numbers at the start', &
            computation_error)
         return
      end if
      context%problem => problem
      allocate (context%parameters, source=parameters)
      context%step = settings%difference_step
      allocate (t(size(parameters)), source=free_of(parameters, parameters%start))
      call search(context, n_residuals, settings, t, result%iterations, status)
      allocate (result%values(size(t)), source=value_of(parameters, t))
      call problem%residuals(result%values, result%residuals, error)
      if (allocated(error)) return
      result%chi_squared = sum(result%residuals**2)
      call describe_minimum(context, settings, t, result, error)
      result%evaluations = context%evaluations + 2
      if (.not. allocated(error)) call check_end(status, settings, result, error)
   end subroutine fit_least_squares

   !> Let GSL search from t on.
   subroutine search(context, n, settings, t, iterations, status)
      type(fit_context), intent(inout), target :: context
      integer, intent(in) :: n
      type(fit_settings), intent(in) :: settings
      real(wp), intent(inout), target, contiguous :: t(:)
      integer, intent(out) :: iterations
      integer(c_int), intent(out) :: status
      type(gsl_parameters) :: parameters
      type(gsl_fdf) :: fdf
      type(gsl_vector), pointer :: position
      real(c_double), pointer :: found(:)
      type(c_ptr) :: work, handler
      integer(c_int) :: reason

      handler = c_set_error_handler_off()
      parameters = c_default_parameters()
      work = c_alloc(gsl_trust, parameters, int(n, c_size_t), size(t, kind=c_size_t))
      iterations = 0
      status = gsl_ebadfunc
      if (.not. c_associated(work)) return
      fdf = gsl_fdf(c_funloc(residuals_at), c_funloc(jacobian_at), c_null_funptr, &
         int(n, c_size_t), size(t, kind=c_size_t), c_loc(context))
      status = c_winit(view_of_vector(t), c_null_ptr, fdf, work)
      if (status == gsl_success) status = c_driver(int(settings%max_iterations, c_size_t), &
         1.0e-10_c_double, 1.0e-12_c_double, 0.0_c_double, c_null_funptr, c_null_ptr, reason, work)
      call c_f_pointer(c_position(work), position)
      call c_f_pointer(position%values, found, shape=shape(t))
      t = found
      iterations = int(c_iterations(work))
      call c_free(work)
   end subroutine search

   ! The two callbacks are no bind(c) procedures, which may not take a type of Fortran's; all that GSL
   ! hands them are addresses, as any Fortran compiler for C's platform takes them

   !> Residuals for GSL.
   integer(c_int) function residuals_at(t, fit, residuals)
      type(gsl_vector), intent(in) :: t
      type(fit_context), intent(inout) :: fit
      type(gsl_vector), intent(inout) :: residuals
      real(c_double), pointer :: at(:), r(:)
      type(error_type), allocatable :: error

      call c_f_pointer(t%values, at, shape=[int(t%size)])
      call c_f_pointer(residuals%values, r, shape=[int(residuals%size)])
      call fit%problem%residuals(value_of(fit%parameters, at), r, error)
      fit%evaluations = fit%evaluations + 1
      if (allocated(error) .or. .not. all(is_finite(r))) r = refused_residual
      residuals_at = gsl_success
   end function residuals_at

   !> Jacobian for GSL.
   integer(c_int) function jacobian_at(t, fit, jacobian)
      type(gsl_vector), intent(in) :: t
      type(fit_context), intent(inout) :: fit
      type(gsl_matrix), intent(inout) :: jacobian
      real(c_double), pointer :: at(:), j(:, :)
      logical :: fine

      call c_f_pointer(t%values, at, shape=[int(t%size)])
      call c_f_pointer(jacobian%values, j, shape=[int(jacobian%columns), int(jacobian%rows)])
      call differentiate(fit, at, j, fine)
      jacobian_at = merge(gsl_success, gsl_ebadfunc, fine)
   end function jacobian_at

   !> d(residuals)/dt by central differences, on one side where the other cannot be evaluated.
   subroutine differentiate(fit, t, transposed, fine)
      type(fit_context), intent(inout) :: fit
      real(wp), intent(in) :: t(:)
      real(wp), intent(out) :: transposed(:, :)
      logical, intent(out) :: fine
      real(wp), allocatable :: values(:, :), residuals(:, :)
      logical, allocatable :: failed(:)
      real(wp) :: moved(size(t))
      integer :: i, p

      p = size(t)
      allocate (values(p, 2*p + 1), residuals(size(transposed, 2), 2*p + 1), failed(2*p + 1))
      do i = 1, p
         moved = t
         moved(i) = t(i) + fit%step
         values(:, 2*i - 1) = value_of(fit%parameters, moved)
         moved(i) = t(i) - fit%step
         values(:, 2*i) = value_of(fit%parameters, moved)
      end do
      values(:, 2*p + 1) = value_of(fit%parameters, t)
      call fit%problem%several_residuals(values, residuals, failed)
      fit%evaluations = fit%evaluations + size(failed)
      do i = 1, size(failed)
         if (.not. failed(i)) failed(i) = .not. all(is_finite(residuals(:, i)))
      end do
      fine = .not. failed(2*p + 1)
      do i = 1, p
         associate (up => 2*i - 1, down => 2*i)
            fine = fine .and. .not. (failed(up) .and. failed(down))
            if (.not. fine) return
            if (failed(up)) residuals(:, up) = residuals(:, 2*p + 1)
            if (failed(down)) residuals(:, down) = residuals(:, 2*p + 1)
            transposed(i, :) = (residuals(:, up) - residuals(:, down)) &
               /(fit%step*merge(1, 2, failed(up) .or. failed(down)))
         end associate
      end do
   end subroutine differentiate

   !> Intervals, correlations and directions from the sensitivities at the end.
   subroutine describe_minimum(context, settings, t, result, error)
      type(fit_context), intent(inout) :: context
      type(fit_settings), intent(in) :: settings
      real(wp), intent(in) :: t(:)
      type(fit_result), intent(inout) :: result
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable, target :: transposed(:, :), values(:), right(:, :)
      real(wp), allocatable :: covariance(:, :), ends(:)
      real(wp) :: noise, factor
      logical :: fine
      integer :: i, j, p

      p = size(t)
      allocate (transposed(p, size(result%residuals)), values(p), right(p, p), covariance(p, p))
      call differentiate(context, t, transposed, fine)
      if (fine) then
         do i = 1, p
            transposed(i, :) = transposed(i, :)/plain_slope(context%parameters(i), t(i))
         end do
         fine = all(is_finite(transposed))
      end if
      if (fine) call decompose(transposed, values, right, fine)
      if (.not. fine) then
         call fatal_error(error, 'the model cannot be evaluated around the values found', &
            computation_error)
         return
      end if
      result%degrees_of_freedom = size(result%residuals) - p
      noise = sqrt(result%chi_squared/result%degrees_of_freedom)
      values = max(values, tiny(noise) + round_off*values(1))
      allocate (result%directions, source=right)
      allocate (result%direction_errors(p), source=noise/values)
      do j = 1, p
         do i = 1, p
            covariance(i, j) = sum(right(i, :)*right(j, :)*result%direction_errors**2)
         end do
      end do
      factor = student_factor(settings%confidence, result%degrees_of_freedom)
      allocate (result%standard_errors(p), result%lower(p), result%upper(p), &
         result%correlations(p, p), result%at_bound(p))
      do i = 1, p
         associate (parameter => context%parameters(i), value => result%values(i))
            result%standard_errors(i) = sqrt(covariance(i, i))
            ends = spread_of(parameter, value, factor*result%standard_errors(i))
            result%lower(i) = ends(1)
            result%upper(i) = ends(2)
            associate (low => y_of(parameter, parameter%lower), &
                  high => y_of(parameter, parameter%upper), y => y_of(parameter, value))
               result%at_bound(i) = min(y - low, high - y) < bound_share*(high - low)
            end associate
         end associate
         do j = 1, p
            result%correlations(i, j) = covariance(i, j) &
               /max(sqrt(covariance(i, i)*covariance(j, j)), tiny(noise))
         end do
      end do
      call check_step(transposed, noise, result, error)
   end subroutine describe_minimum

   !> Set `error` when a step of Gauss and Newton would still lead away; `left` has the columns of U.
   subroutine check_step(left, noise, result, error)
      real(wp), intent(in) :: left(:, :), noise
      type(fit_result), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: along(size(left, 1)), step(size(left, 1))

      if (any(result%at_bound) .or. noise <= 0.0_wp) return
      ! in standard errors along each direction
      along = matmul(left, result%residuals)/noise
      step = abs(matmul(result%directions, along*result%direction_errors))
      if (norm2(along) > most_step .and. any(step > least_step*max(1.0_wp, abs(result%values)))) &
         call fatal_error(error, 'the search ended '//to_text(real(nint(100.0_wp*norm2(along)), &
         wp)/100.0_wp)//' standard errors from the minimum after '//to_text(result%iterations)// &
         ' iterations: begin nearer, or free fewer parameters', computation_error)
   end subroutine check_step

   !> Set `error` unless the end is finite and better than the start.
   subroutine check_end(status, settings, result, error)
      integer(c_int), intent(in) :: status
      type(fit_settings), intent(in) :: settings
      type(fit_result), intent(in) :: result
      type(error_type), allocatable, intent(out) :: error

      if (.not. (is_finite(result%chi_squared) .and. all(is_finite(result%values)) &
         .and. result%chi_squared <= result%start_chi_squared)) then
         call fatal_error(error, 'no minimum was found: the values are no better than those at '// &
            'the start', computation_error)
      else if (status == gsl_emaxiter) then
         call fatal_error(error, 'no minimum was found in '//to_text(settings%max_iterations)// &
            ' iterations: begin nearer, or free fewer parameters', computation_error)
      end if
   end subroutine check_end

end module asperity_fit_least_squares
