!> One search for the minimum by GSL's trust region (Levenberg-Marquardt with geodesic
!> acceleration). GSL 2.7.1 asks again and again for a point that is refused, so a set that cannot
!> be evaluated gives huge residuals here.
module asperity_fit_search
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int, &
      c_loc, c_null_funptr, c_null_ptr, c_ptr, c_size_t
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: all_below, is_finite
   use asperity_base_kinds, only: wp
   use asperity_fit_gsl_linear, only: view_of_vector
   use asperity_fit_gsl_multifit, only: c_alloc, c_default_parameters, c_driver, c_free, &
      c_iterations, c_position, c_set_error_handler_off, c_winit, gsl_accelerated, &
      gsl_ebadfunc, gsl_fdf, gsl_matrix, gsl_parameters, gsl_success, gsl_trust, gsl_vector
   use asperity_fit_parameter, only: fit_parameter, slope_of, t_of, value_of, y_at
   use asperity_fit_problem, only: fit_problem, refused_residual
   use asperity_fit_sensitivities, only: differentiate
   implicit none
   private
   public :: search_type

   !> A step so small over t ends a search. GSL's test of the gradient would depend on the units of
   !> the residuals
   real(c_double), parameter :: least_step = 1.0e-10_c_double, no_test = 0.0_c_double

   !> A search, and what GSL hands back to the callbacks.
   type :: search_type
      !> The problem, its parameters, the number of residuals
      class(fit_problem), pointer :: problem => null()
      type(fit_parameter), allocatable :: parameters(:)
      integer :: n_residuals = 0
      !> Step of differences, most iterations
      real(wp) :: step = 0.0_wp
      integer :: max_iterations = 0
      !> What all searches have taken
      integer :: iterations = 0, evaluations = 0
   contains
      procedure :: run
   end type search_type

contains

   !> Search from y on.
   subroutine run(self, y)
      !> The search
      class(search_type), intent(inout), target :: self
      !> Where it begins, and ends
      real(wp), intent(inout) :: y(:)
      real(wp), allocatable, target :: t(:)
      type(gsl_parameters) :: parameters
      type(gsl_fdf) :: fdf
      type(gsl_vector), pointer :: position
      real(c_double), pointer :: found(:)
      type(c_ptr) :: work, handler
      integer(c_int) :: reason, status

      allocate (t(size(y)), source=t_of(self%parameters, y))
      handler = c_set_error_handler_off()
      parameters = c_default_parameters()
      ! valleys of parameters that are known together only are long and bent
      parameters%method = gsl_accelerated
      work = c_alloc(gsl_trust, parameters, int(self%n_residuals, c_size_t), &
         size(t, kind=c_size_t))
      if (.not. c_associated(work)) return
      fdf = gsl_fdf(c_funloc(residuals_at), c_funloc(jacobian_at), c_null_funptr, &
         int(self%n_residuals, c_size_t), size(t, kind=c_size_t), address_of(self))
      status = c_winit(view_of_vector(t), c_null_ptr, fdf, work)
      if (status == gsl_success) then
         status = c_driver(int(self%max_iterations, c_size_t), least_step, no_test, no_test, &
            c_null_funptr, c_null_ptr, reason, work)
         call c_f_pointer(c_position(work), position)
         call c_f_pointer(position%values, found, shape=shape(t))
         if (all(is_finite(found))) y = y_at(self%parameters, found)
         self%iterations = self%iterations + int(c_iterations(work))
      end if
      call c_free(work)
   end subroutine run

   !> Address of a search of this very type.
   type(c_ptr) function address_of(search)
      type(search_type), intent(in), target :: search

      address_of = c_loc(search)
   end function address_of

   ! The two callbacks are no bind(c) procedures, which may not take a type of Fortran's; all that
   ! GSL hands them are addresses, as any Fortran compiler for C's platform takes them

   !> Residuals for GSL.
   integer(c_int) function residuals_at(t, search, residuals)
      type(gsl_vector), intent(in) :: t
      type(search_type), intent(inout) :: search
      type(gsl_vector), intent(inout) :: residuals
      real(c_double), pointer :: at(:), r(:)
      type(error_type), allocatable :: error

      call c_f_pointer(t%values, at, shape=[int(t%size)])
      call c_f_pointer(residuals%values, r, shape=[int(residuals%size)])
      residuals_at = gsl_success
      ! a step of no number leads nowhere, and one where the model cannot be evaluated is taken back
      r = refused_residual
      if (.not. all(is_finite(at))) return
      call search%problem%residuals(value_of(search%parameters, y_at(search%parameters, at)), r, &
         error)
      search%evaluations = search%evaluations + 1
      if (allocated(error)) then
         r = refused_residual
      else if (.not. all_below(r, refused_residual)) then
         r = refused_residual
      end if
   end function residuals_at

   !> Jacobian for GSL.
   integer(c_int) function jacobian_at(t, search, jacobian)
      type(gsl_vector), intent(in) :: t
      type(search_type), intent(inout) :: search
      type(gsl_matrix), intent(inout) :: jacobian
      real(c_double), pointer :: at(:), j(:, :)
      logical :: fine
      integer :: i

      jacobian_at = gsl_ebadfunc
      call c_f_pointer(t%values, at, shape=[int(t%size)])
      call c_f_pointer(jacobian%values, j, shape=[int(jacobian%columns), int(jacobian%rows)])
      if (.not. all(is_finite(at))) return
      call differentiate(search%problem, search%parameters, y_at(search%parameters, at), &
         search%step, j, fine)
      search%evaluations = search%evaluations + 2*size(at) + 1
      if (.not. fine) return
      do i = 1, size(at)
         j(i, :) = j(i, :)*slope_of(search%parameters(i), at(i))
      end do
      ! no way leads from where nothing changes, and GSL would take the logarithm of zero
      if (any(abs(j) > 0.0_wp)) jacobian_at = gsl_success
   end function jacobian_at

end module asperity_fit_search
