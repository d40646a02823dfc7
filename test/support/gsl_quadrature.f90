!> GSL's adaptive quadrature and the moments of a Gaussian tail by GSL's function U, through
!> iso_c_binding: the tests' independent numbers.
module gsl_quadrature
   use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_funptr, c_int, c_ptr, c_size_t
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: integrand, integrate, gaussian_moment

   integer(c_size_t), parameter :: limit = 2000_c_size_t
   integer(c_int), parameter :: rule_61 = 6_c_int

   type, bind(C) :: gsl_function
      type(c_funptr) :: procedure
      type(c_ptr) :: parameters
   end type gsl_function

   abstract interface
      !> Function to be integrated.
      function integrand(x, parameters) bind(C) result(y)
         import :: c_double, c_ptr
         real(c_double), intent(in), value :: x
         type(c_ptr), intent(in), value :: parameters
         real(c_double) :: y
      end function integrand
   end interface

   interface
      function allocate_workspace(n) bind(C, name='gsl_integration_workspace_alloc') result(space)
         import :: c_ptr, c_size_t
         integer(c_size_t), intent(in), value :: n
         type(c_ptr) :: space
      end function allocate_workspace

      subroutine free_workspace(space) bind(C, name='gsl_integration_workspace_free')
         import :: c_ptr
         type(c_ptr), intent(in), value :: space
      end subroutine free_workspace

      function handler_off() bind(C, name='gsl_set_error_handler_off') result(old)
         import :: c_funptr
         type(c_funptr) :: old
      end function handler_off

      function qag(f, a, b, absolute, relative, n, key, space, value, error) &
            bind(C, name='gsl_integration_qag') result(status)
         import :: c_double, c_int, c_ptr, c_size_t, gsl_function
         type(gsl_function), intent(in) :: f
         real(c_double), intent(in), value :: a, b, absolute, relative
         integer(c_size_t), intent(in), value :: n
         integer(c_int), intent(in), value :: key
         type(c_ptr), intent(in), value :: space
         real(c_double), intent(out) :: value, error
         integer(c_int) :: status
      end function qag

      function qagiu(f, a, absolute, relative, n, space, value, error) &
            bind(C, name='gsl_integration_qagiu') result(status)
         import :: c_double, c_int, c_ptr, c_size_t, gsl_function
         type(gsl_function), intent(in) :: f
         real(c_double), intent(in), value :: a, absolute, relative
         integer(c_size_t), intent(in), value :: n
         type(c_ptr), intent(in), value :: space
         real(c_double), intent(out) :: value, error
         integer(c_int) :: status
      end function qagiu

      !> Confluent hypergeometric function U(a, b, x) (DLMF 13.2).
      function hypergeometric_u(a, b, x) bind(C, name='gsl_sf_hyperg_U') result(u)
         import :: c_double
         real(c_double), intent(in), value :: a, b, x
         real(c_double) :: u
      end function hypergeometric_u
   end interface

contains

   !> Integral of `f` over lower..upper, or lower..infinity without `upper`, and GSL's estimate
   !> of its error. The caller judges the error: GSL's status also complains of round-off.
   subroutine integrate(f, parameters, lower, value, error, upper)
      !> Function to be integrated
      procedure(integrand) :: f
      !> Address that `f` is given
      type(c_ptr), intent(in) :: parameters
      !> Lower limit
      real(c_double), intent(in) :: lower
      !> Integral, and the estimate of its absolute error
      real(c_double), intent(out) :: value, error
      !> Upper limit, infinity when absent
      real(c_double), intent(in), optional :: upper
      real(c_double), parameter :: absolute = 0.0_c_double, relative = 1.0e-12_c_double
      type(gsl_function) :: wrapped
      type(c_ptr) :: space
      type(c_funptr) :: old_handler
      integer(c_int) :: status

      old_handler = handler_off()
      wrapped = gsl_function(c_funloc(f), parameters)
      space = allocate_workspace(limit)
      if (present(upper)) then
         status = qag(wrapped, lower, upper, absolute, relative, limit, rule_61, space, value, &
            error)
      else
         status = qagiu(wrapped, lower, absolute, relative, limit, space, value, error)
      end if
      call free_workspace(space)
      associate (unused_1 => old_handler, unused_2 => status)
      end associate
   end subroutine integrate

   !> F_p(h) = integral_0^inf t^p phi(t + h) dt: for h > 0 by U (DLMF 12.5.1 with 12.7.14), else
   !> by its Taylor series in -h, all of whose terms are then positive:
   !> phi(h) sum_k (-h)^k/k! 2^((p+k-1)/2) Gamma((p+k+1)/2).
   function gaussian_moment(p, h) result(f)
      !> Power p, and h
      real(wp), intent(in) :: p, h
      real(wp) :: f, term
      integer :: k

      if (h > 0.0_wp) then
         f = gamma(p + 1.0_wp)*2.0_wp**(-0.5_wp*(p + 1.0_wp)) &
            *hypergeometric_u(0.5_wp*(p + 1.0_wp), 0.5_wp, 0.5_wp*h*h)
      else
         f = 2.0_wp**(0.5_wp*(p - 1.0_wp))*gamma(0.5_wp*(p + 1.0_wp))
         term = 1.0_wp
         do k = 1, 200
            term = -term*h/real(k, wp)
            f = f + term*2.0_wp**(0.5_wp*(p + k - 1.0_wp))*gamma(0.5_wp*(p + k + 1.0_wp))
         end do
      end if
      f = f*exp(-0.5_wp*h*h)/sqrt(8.0_wp*atan(1.0_wp))
   end function gaussian_moment

end module gsl_quadrature
