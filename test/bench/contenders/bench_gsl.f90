!> Contender: pressure and stiffness by GSL's adaptive quadrature QAG, as a careful user would have
!> it: one workspace, split where the force of a summit has its kinks, cut where the density of
!> heights is negligible, the elastic stage in u = sqrt(w) where it is smooth, the smaller pieces
!> to the accuracy that the sum needs, and the rule that was measured to be the quickest.
module bench_gsl
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_funloc, c_funptr, c_int, &
      c_f_pointer, c_loc, c_null_ptr, c_ptr, c_size_t
   use asperity, only: normal_properties, wp
   use bench_law, only: array_contender, point_arrays
   implicit none
   private
   public :: gsl_law, new_gsl_law, free_gsl_law

   !> Relative accuracy asked of QAG
   real(c_double), parameter, public :: gsl_accuracy = 1.0e-10_c_double
   !> Heights beyond this exponent less than that of the densest, e**-30, count for nothing
   real(wp), parameter :: negligible = 30.0_wp
   integer(c_size_t), parameter :: limit = 1000_c_size_t

   type, bind(C) :: gsl_function
      type(c_funptr) :: procedure
      type(c_ptr) :: parameters
   end type gsl_function

   !> What an integrand needs: d/sigma, sigma/w1 and the exponent of the force.
   type, bind(C) :: integrand_parameters
      real(c_double) :: h, per_w1, exponent
   end type integrand_parameters

   !> Law by QAG.
   type, extends(array_contender) :: gsl_law
      !> Gauss-Kronrod rule, 1 to 6 for 15 to 61 points; 61 was measured to be the quickest
      integer(c_int) :: key = 6_c_int
      type(c_ptr) :: workspace = c_null_ptr
   contains
      procedure :: pass => pass_gsl
   end type gsl_law

   abstract interface
      function integrand(x, parameters) bind(C) result(y)
         import :: c_double, c_ptr
         implicit none
         real(c_double), intent(in), value :: x
         type(c_ptr), intent(in), value :: parameters
         real(c_double) :: y
      end function integrand
   end interface

   interface
      function allocate_workspace(n) bind(C, name='gsl_integration_workspace_alloc') result(space)
         import :: c_ptr, c_size_t
         implicit none
         integer(c_size_t), intent(in), value :: n
         type(c_ptr) :: space
      end function allocate_workspace

      subroutine free_workspace(space) bind(C, name='gsl_integration_workspace_free')
         import :: c_ptr
         implicit none
         type(c_ptr), intent(in), value :: space
      end subroutine free_workspace

      function handler_off() bind(C, name='gsl_set_error_handler_off') result(old)
         import :: c_funptr
         implicit none
         type(c_funptr) :: old
      end function handler_off

      function qag(f, a, b, absolute, relative, n, key, space, value, error) &
            bind(C, name='gsl_integration_qag') result(status)
         import :: c_double, c_int, c_ptr, c_size_t, gsl_function
         implicit none
         type(gsl_function), intent(in) :: f
         real(c_double), intent(in), value :: a, b, absolute, relative
         integer(c_size_t), intent(in), value :: n
         integer(c_int), intent(in), value :: key
         type(c_ptr), intent(in), value :: space
         real(c_double), intent(out) :: value, error
         integer(c_int) :: status
      end function qag
   end interface

contains

   !> The law at the first `points` of some separations.
   subroutine new_gsl_law(gsl, on, properties, points)
      type(gsl_law), intent(out) :: gsl
      type(point_arrays), intent(in) :: on
      type(normal_properties), intent(in) :: properties
      integer, intent(in) :: points
      type(c_funptr) :: old_handler

      ! GSL would end the program where it meets round-off; the results are checked instead
      old_handler = handler_off()
      associate (unused => old_handler)
      end associate
      gsl%workspace = allocate_workspace(limit)
      if (.not. c_associated(gsl%workspace)) error stop 'bench: GSL has no memory left'
      gsl%on = on
      gsl%properties = properties
      gsl%has_error = .true.
      gsl%error_limit = 10.0_wp*gsl_accuracy
      gsl%points = points
   end subroutine new_gsl_law

   !> Give GSL's workspace back.
   subroutine free_gsl_law(gsl)
      type(gsl_law), intent(inout) :: gsl

      call free_workspace(gsl%workspace)
      gsl%workspace = c_null_ptr
   end subroutine free_gsl_law

   subroutine pass_gsl(this)
      class(gsl_law), intent(inout) :: this
      real(wp) :: force, slope
      integer :: i

      associate (p => this%properties, on => this%on)
         do i = 1, this%points
            call integrate_pieces(this, on%separation(i)/p%sigma, force, slope)
            on%pressure(i) = p%eta*p%n1*force
            on%stiffness(i) = p%eta*p%n1/p%w1*slope
         end do
         this%checksum = this%checksum + on%pressure(1) + on%stiffness(this%points)
      end associate
   end subroutine pass_gsl

   !> Integrals over the three stages of the force, in N1, and its slope, in N1/w1, each times the
   !> density of heights at t + h, with t = w/sigma and h = d/sigma.
   subroutine integrate_pieces(this, h, force, slope)
      type(gsl_law), intent(in) :: this
      real(wp), intent(in) :: h
      real(wp), intent(out) :: force, slope
      type(integrand_parameters), target :: p
      real(wp) :: a, b, lower, upper

      a = this%properties%w1/this%properties%sigma
      b = this%properties%w2/this%properties%sigma
      lower = max(0.0_wp, -h - sqrt(2.0_wp*negligible))
      upper = sqrt(max(h, 0.0_wp)**2 + 2.0_wp*negligible) - h
      force = 0.0_wp
      slope = 0.0_wp
      associate (b3 => this%properties%b3, hard => 2.0_wp/this%properties%yield_factor)
         p = integrand_parameters(h, 1.0_wp/a, b3)
         call add_piece(this, power, p, max(lower, a), min(upper, b), 1.0_wp, force)
         call add_piece(this, linear, p, max(lower, b), upper, hard, force)
         call add_piece(this, elastic_force, p, sqrt(lower), sqrt(min(upper, a)), 1.0_wp, force)
         p%exponent = b3 - 1.0_wp
         call add_piece(this, power, p, max(lower, a), min(upper, b), b3, slope)
         call add_piece(this, constant, p, max(lower, b), upper, hard, slope)
         call add_piece(this, elastic_slope, p, sqrt(lower), sqrt(min(upper, a)), 1.0_wp, slope)
      end associate
   end subroutine integrate_pieces

   !> Add `factor` times an integral, to the accuracy of the sum so far.
   subroutine add_piece(this, f, parameters, lower, upper, factor, total)
      type(gsl_law), intent(in) :: this
      procedure(integrand) :: f
      type(integrand_parameters), intent(in), target :: parameters
      real(wp), intent(in) :: lower, upper, factor
      real(wp), intent(inout) :: total
      real(c_double) :: value, error
      integer(c_int) :: status

      if (.not. lower < upper) return
      status = qag(gsl_function(c_funloc(f), c_loc(parameters)), lower, upper, &
         gsl_accuracy*total/factor, gsl_accuracy, limit, this%key, this%workspace, value, error)
      associate (unused => status)
      end associate
      total = total + factor*value
   end subroutine add_piece

   !> Elasto-plastic stage: (w/w1)**exponent.
   function power(x, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: x
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p

      call c_f_pointer(parameters, p)
      y = density(x + p%h)*(x*p%per_w1)**p%exponent
   end function power

   !> Plastic stage: w/w1.
   function linear(x, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: x
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p

      call c_f_pointer(parameters, p)
      y = density(x + p%h)*x*p%per_w1
   end function linear

   !> Its slope.
   function constant(x, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: x
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p

      call c_f_pointer(parameters, p)
      y = density(x + p%h)
   end function constant

   !> Elastic stage, (w/w1)**1.5, in u = sqrt(t): dt = 2 u du.
   function elastic_force(u, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: u
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p
      real(c_double) :: ratio

      call c_f_pointer(parameters, p)
      ratio = u*u*p%per_w1
      y = density(u*u + p%h)*2.0_wp*ratio*ratio*sqrt(1.0_wp/p%per_w1)
   end function elastic_force

   !> Its slope, 1.5 (w/w1)**0.5.
   function elastic_slope(u, parameters) bind(C) result(y)
      real(c_double), intent(in), value :: u
      type(c_ptr), intent(in), value :: parameters
      real(c_double) :: y
      type(integrand_parameters), pointer :: p

      call c_f_pointer(parameters, p)
      y = density(u*u + p%h)*3.0_wp*u*u*sqrt(p%per_w1)
   end function elastic_slope

   !> Gaussian density.
   pure function density(z) result(y)
      real(wp), intent(in) :: z
      real(wp) :: y
      real(wp), parameter :: factor = 0.39894228040143267794_wp

      y = factor*exp(-0.5_wp*z*z)
   end function density

end module bench_gsl
