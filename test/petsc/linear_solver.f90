!> The solver of solids: factors, GMRES with factors of another matrix, what it refuses.
module test_petsc_linear_solver
   use, intrinsic :: ieee_arithmetic, only: ieee_positive_inf, ieee_quiet_nan, ieee_value
   use, intrinsic :: iso_c_binding, only: c_int, c_loc
   use asperity, only: error_type, wp
   use asperity_solid_engine_convergence, only: convergence_context, residual_is_small
   use asperity_solid_engine_linear_solver, only: linear_solver
   use asperity_solid_engine_petsc, only: ksp_converged_iterating, ksp_converged_rtol, &
      ksp_diverged_its
   use test_petsc_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_linear_solver

   !> Cells along the side of the square
   integer, parameter :: side = 12

contains

   function suite_linear_solver() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('linear solver')
      call suite%addTest(TestMethod('no process is started beside', test_processes))
      call suite%addTest(TestMethod('factors solve', test_factors))
      call suite%addTest(TestMethod('old factors and GMRES solve what has changed', test_iterate))
      call suite%addTest(TestMethod('GMRES says that it gives up', test_gives_up))
      call suite%addTest(TestMethod('GMRES gives up at its bounds', test_bounds))
      call suite%addTest(TestMethod('multigrid solves, the next matrix too', test_multigrid))
      call suite%addTest(TestMethod('factors solve what multigrid does not', test_fallback))
      call suite%addTest(TestMethod('factors in place of multigrid fail', test_fallback_fails))
      call suite%addTest(TestMethod('small pivots are no zeros', test_small))
      call suite%addTest(TestMethod('singular and NaN are refused', test_refused))
   end function suite_linear_solver

   !> Linux lists the processes that this one has started.
   subroutine test_processes()
      character(len=80) :: children
      integer :: unit, status

      children = ''
      open (newunit=unit, file='/proc/thread-self/children', action='read', status='old', &
         iostat=status)
      if (status /= 0) return
      read (unit, '(a)', iostat=status) children
      if (status > 0) children = 'not read'
      close (unit)
      call assertEqual('', trim(children))
   end subroutine test_processes

   !> At each bound and beside it: of 1000 at first, 10 is enough and 300 hopeless after 20 vectors,
   !> and there are 40 at most.
   subroutine test_bounds()
      type(convergence_context), target :: context
      integer, target :: krylov

      context = convergence_context(1.0e-2_wp, 0.0_wp, 40, 20, 0)
      call assertEqual(ksp_converged_iterating, reason_at(0, 1000.0_wp), 'at first')
      call assertEqual(ksp_converged_iterating, reason_at(19, 1000.0_wp), 'before the trial')
      call assertEqual(ksp_converged_iterating, reason_at(20, 300.0_wp), 'of use')
      call assertEqual(ksp_diverged_its, reason_at(20, nearest(300.0_wp, 1.0_wp)), 'of no use')
      call assertEqual(ksp_converged_iterating, reason_at(21, 1000.0_wp), 'after the trial')
      call assertEqual(ksp_converged_iterating, reason_at(39, 1000.0_wp), 'one is left')
      call assertEqual(ksp_diverged_its, reason_at(40, 1000.0_wp), 'none is left')
      call assertEqual(ksp_converged_rtol, reason_at(40, 10.0_wp), 'the last one was enough')
      call assertEqual(ksp_converged_iterating, reason_at(1, nearest(10.0_wp, 1.0_wp)), &
         'not enough')
      call assertEqual(ksp_diverged_its, reason_at(1, ieee_value(1.0_wp, ieee_positive_inf)), &
         'no number')
      call assertEqual(1, context%vectors)

   contains

      integer function reason_at(iteration, residual)
         integer, intent(in) :: iteration
         real(wp), intent(in) :: residual
         integer(c_int) :: code, reason

         code = residual_is_small(c_loc(krylov), int(iteration, c_int), residual, reason, &
            c_loc(context))
         call assertEqual(0, int(code))
         reason_at = int(reason)
      end function reason_at

   end subroutine test_bounds

   !> Convection and diffusion on a square: unsymmetric, of a symmetric pattern.
   subroutine fill(solver, convection, scale, by_multigrid)
      type(linear_solver), intent(inout) :: solver
      real(wp), intent(in) :: convection, scale
      logical, intent(in), optional :: by_multigrid
      real(wp), allocatable :: constant(:, :)
      integer, allocatable :: row_start(:), columns(:)
      real(wp), allocatable :: values(:)
      type(error_type), allocatable :: error
      integer :: i, j, n

      allocate (row_start(side*side + 1), columns(0), values(0))
      n = 0
      do j = 0, side - 1
         do i = 0, side - 1
            row_start(i + side*j + 1) = size(columns)
            call add(i, j - 1, -1.0_wp)
            call add(i - 1, j, -1.0_wp - convection)
            call add(i, j, 4.0_wp)
            call add(i + 1, j, -1.0_wp + convection)
            call add(i, j + 1, -1.0_wp)
         end do
      end do
      row_start(side*side + 1) = size(columns)
      if (.not. associated(solver%values)) then
         solver%petsc = petsc
         ! without it there is no argument
         if (present(by_multigrid)) allocate (constant(side*side, 1), source=1.0_wp/side)
         call solver%set_pattern(row_start, columns, [0, side*side], error, constant)
         call assertFalse(allocated(error))
      end if
      solver%values = scale*values

   contains

      subroutine add(k, l, value)
         integer, intent(in) :: k, l
         real(wp), intent(in) :: value

         if (min(k, l) < 0 .or. max(k, l) >= side) return
         columns = [columns, k + side*l]
         values = [values, value]
      end subroutine add

   end subroutine fill

   !> Matrix times vector.
   function times(solver, x) result(y)
      type(linear_solver), intent(in) :: solver
      real(wp), intent(in) :: x(:)
      real(wp) :: y(size(x))
      integer :: i, k

      y = 0.0_wp
      do i = 1, solver%n
         do k = solver%row_start(i) + 1, solver%row_start(i + 1)
            y(i) = y(i) + solver%values(k)*x(solver%columns(k) + 1)
         end do
      end do
   end function times

   subroutine test_factors()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)
      integer :: i

      call fill(solver, 0.5_wp, 1.0_wp)
      call solver%factorise(error)
      call assertFalse(allocated(error))
      b = [(sin(real(i, wp)), i=1, side*side)]
      call solver%solve(b, x, error)
      call assertFalse(allocated(error))
      call assertLessThan(norm2(times(solver, x) - b), 1.0e-12_wp*norm2(b))
      call solver%release()
   end subroutine test_factors

   subroutine test_iterate()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)
      logical :: has_converged

      call fill(solver, 0.5_wp, 1.0_wp)
      call solver%factorise(error)
      call fill(solver, 0.4_wp, 1.1_wp)
      b = 1.0_wp
      call solver%iterate(b, x, 1.0e-3_wp, has_converged, error)
      call assertFalse(allocated(error))
      call assertTrue(has_converged)
      call assertLessThan(norm2(times(solver, x) - b), 1.01e-3_wp*norm2(b))
      call assertEqual(1, solver%n_factorisations)
      call solver%release()
   end subroutine test_iterate

   subroutine test_gives_up()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)
      logical :: has_converged
      integer :: i

      call fill(solver, 0.9_wp, 1.0_wp)
      call solver%factorise(error)
      call fill(solver, -0.9_wp, 1.0_wp)
      do i = 1, side*side
         solver%values(solver%row_start(i) + 1) = 3.0_wp*(-1)**i
      end do
      b = [(cos(3.0_wp*i), i=1, side*side)]
      call solver%iterate(b, x, 1.0e-9_wp, has_converged, error)
      call assertFalse(allocated(error))
      call assertFalse(has_converged)
      call solver%release()
   end subroutine test_gives_up

   subroutine test_multigrid()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)
      logical :: has_converged

      call fill(solver, 0.3_wp, 1.0_wp, .true.)
      call solver%factorise(error)
      call assertFalse(allocated(error))
      b = 1.0_wp
      call solver%solve(b, x, error, 1.0e-10_wp)
      call assertFalse(allocated(error))
      call assertLessThan(norm2(times(solver, x) - b), 1.01e-10_wp*norm2(b))
      call solver%solve(b, x, error)
      call assertLessThan(norm2(times(solver, x) - b), 1.01e-8_wp*norm2(b))
      call fill(solver, 0.2_wp, 1.5_wp)
      call solver%iterate(b, x, 1.0e-6_wp, has_converged, error)
      call assertTrue(has_converged)
      call assertLessThan(norm2(times(solver, x) - b), 1.01e-6_wp*norm2(b))
      call assertTrue(solver%is_multigrid)
      call assertEqual(1, solver%n_factorisations)
      call assertEqual(0, solver%n_multigrid_failures)
      call solver%release()
   end subroutine test_multigrid

   !> No number of vectors leaves nothing.
   subroutine test_fallback()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)

      call fill(solver, 0.3_wp, 1.0_wp, .true.)
      call solver%factorise(error)
      b = 1.0_wp
      call solver%solve(b, x, error, 0.0_wp)
      call assertFalse(allocated(error))
      call assertFalse(solver%is_multigrid)
      call assertLessThan(norm2(times(solver, x) - b), 1.0e-12_wp*norm2(b))
      call assertEqual(2, solver%n_factorisations)
      call assertEqual(1, solver%n_multigrid_failures)
      call solver%release()
   end subroutine test_fallback

   !> Nor can what takes multigrid's place do anything with a matrix of nothing.
   subroutine test_fallback_fails()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)

      call fill(solver, 0.3_wp, 0.0_wp, .true.)
      b = 1.0_wp
      call solver%factorise(error)
      if (.not. allocated(error)) call solver%solve(b, x, error)
      call assertTrue(allocated(error))
      if (allocated(error)) call assertTrue(index(error%message, &
         ', where multigrid has not converged') > 0, error%message)
      call solver%release()
   end subroutine test_fallback_fails

   !> PETSc's own LU takes pivots below 2.2e-14 for zero, and returns what is not finite.
   subroutine test_small()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(side*side), b(side*side)

      call fill(solver, 0.5_wp, 1.0e-18_wp)
      call solver%factorise(error)
      call assertFalse(allocated(error))
      b = 1.0e-18_wp
      call solver%solve(b, x, error)
      call assertLessThan(norm2(times(solver, x) - b), 1.0e-12_wp*norm2(b))
      call solver%release()
   end subroutine test_small

   subroutine test_refused()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error

      call fill(solver, 0.5_wp, 0.0_wp)
      call solver%factorise(error)
      call assertTrue(allocated(error))
      call assertFalse(solver%has_factors)
      call fill(solver, 0.5_wp, 1.0_wp)
      solver%values(7) = ieee_value(1.0_wp, ieee_quiet_nan)
      call solver%factorise(error)
      call assertTrue(allocated(error))
      if (.not. allocated(error)) return
      call assertTrue(index(error%message, 'not numbers') > 0)
      call fill(solver, 0.5_wp, 1.0_wp)
      call solver%factorise(error)
      call assertFalse(allocated(error))
      call solver%release()
   end subroutine test_refused

end module test_petsc_linear_solver
