!> Interfaces of GSL's nonlinear least squares (gsl_multifit_nlinear.h).
module asperity_fit_gsl_multifit
   use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_null_funptr, c_null_ptr, &
      c_ptr, c_size_t
   implicit none
   private
   public :: c_alloc, c_default_parameters, c_driver, c_free, c_iterations, c_position, &
      c_set_error_handler_off, c_winit, gsl_accelerated, gsl_fdf, gsl_matrix, gsl_parameters, &
      gsl_trust, gsl_vector

   !> What callbacks return
   integer(c_int), parameter, public :: gsl_success = 0_c_int, gsl_ebadfunc = 9_c_int

   !> gsl_vector.
   type, bind(c) :: gsl_vector
      integer(c_size_t) :: size, stride
      type(c_ptr) :: values
      type(c_ptr) :: block
      integer(c_int) :: is_owner
   end type gsl_vector

   !> gsl_matrix, rows one after the other.
   type, bind(c) :: gsl_matrix
      integer(c_size_t) :: rows, columns, row_length
      type(c_ptr) :: values
      type(c_ptr) :: block
      integer(c_int) :: is_owner
   end type gsl_matrix

   !> gsl_multifit_nlinear_fdf.
   type, bind(c) :: gsl_fdf
      type(c_funptr) :: residuals = c_null_funptr, jacobian = c_null_funptr, second = c_null_funptr
      integer(c_size_t) :: n = 0_c_size_t, p = 0_c_size_t
      type(c_ptr) :: context = c_null_ptr
      integer(c_size_t) :: n_residuals = 0_c_size_t, n_jacobian = 0_c_size_t, n_second = 0_c_size_t
   end type gsl_fdf

   !> gsl_multifit_nlinear_parameters.
   type, bind(c) :: gsl_parameters
      type(c_ptr) :: method = c_null_ptr, scale = c_null_ptr, solver = c_null_ptr
      integer(c_int) :: difference = 0_c_int
      real(c_double) :: factor_up = 0.0_c_double, factor_down = 0.0_c_double, &
         most_acceleration = 0.0_c_double, step = 0.0_c_double, second_step = 0.0_c_double
   end type gsl_parameters

   !> The trust-region method, and Levenberg's and Marquardt's step with geodesic acceleration
   type(c_ptr), bind(c, name='gsl_multifit_nlinear_trust') :: gsl_trust
   type(c_ptr), bind(c, name='gsl_multifit_nlinear_trs_lmaccel') :: gsl_accelerated

   interface
      type(gsl_parameters) function c_default_parameters() &
         bind(c, name='gsl_multifit_nlinear_default_parameters')
         import :: gsl_parameters
      end function c_default_parameters
      type(c_ptr) function c_alloc(method, parameters, n, p) &
         bind(c, name='gsl_multifit_nlinear_alloc')
         import :: c_ptr, c_size_t, gsl_parameters
         type(c_ptr), value :: method
         type(gsl_parameters), intent(in) :: parameters
         integer(c_size_t), value :: n, p
      end function c_alloc
      subroutine c_free(work) bind(c, name='gsl_multifit_nlinear_free')
         import :: c_ptr
         type(c_ptr), value :: work
      end subroutine c_free
      integer(c_int) function c_winit(start, weights, fdf, work) &
         bind(c, name='gsl_multifit_nlinear_winit')
         import :: c_int, c_ptr, gsl_fdf, gsl_vector
         type(gsl_vector), intent(in) :: start
         type(c_ptr), value :: weights
         type(gsl_fdf), intent(inout) :: fdf
         type(c_ptr), value :: work
      end function c_winit
      integer(c_int) function c_driver(most, step, gradient, decrease, callback, context, reason, &
         work) bind(c, name='gsl_multifit_nlinear_driver')
         import :: c_double, c_funptr, c_int, c_ptr, c_size_t
         integer(c_size_t), value :: most
         real(c_double), value :: step, gradient, decrease
         type(c_funptr), value :: callback
         type(c_ptr), value :: context
         integer(c_int), intent(out) :: reason
         type(c_ptr), value :: work
      end function c_driver
      type(c_ptr) function c_position(work) bind(c, name='gsl_multifit_nlinear_position')
         import :: c_ptr
         type(c_ptr), value :: work
      end function c_position
      integer(c_size_t) function c_iterations(work) bind(c, name='gsl_multifit_nlinear_niter')
         import :: c_ptr, c_size_t
         type(c_ptr), value :: work
      end function c_iterations
      type(c_ptr) function c_set_error_handler_off() bind(c, name='gsl_set_error_handler_off')
         import :: c_ptr
      end function c_set_error_handler_off
   end interface

end module asperity_fit_gsl_multifit
