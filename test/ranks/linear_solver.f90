!> The solver on ranks: a matrix that each rank has a part of, in rows of others as well.
module test_ranks_linear_solver
   use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
   use asperity, only: error_type, wp
   use asperity_solid_engine_linear_solver, only: linear_solver
   use test_ranks_engine, only: petsc
   use funit, only: assertEqual, assertFalse, assertLessThan, assertTrue, TestMethod, TestSuite
   implicit none
   private
   public :: suite_linear_solver

   !> Unknowns of a chain of springs and convection
   integer, parameter :: n = 40

contains

   function suite_linear_solver() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('linear solver')
      call suite%addTest(TestMethod('the sum of all parts is solved', test_solve))
      call suite%addTest(TestMethod('GMRES with factors of another matrix', test_iterate))
      call suite%addTest(TestMethod('multigrid', test_multigrid))
      call suite%addTest(TestMethod('a rank without rows', test_empty))
      call suite%addTest(TestMethod('what one rank cannot bear, none can', test_refused))
   end function suite_linear_solver

   !> Links of the chain, dealt out to the ranks in turn; rows in blocks, or all with the first.
   subroutine fill(solver, convection, all_with_first, by_multigrid)
      type(linear_solver), intent(inout) :: solver
      real(wp), intent(in) :: convection
      logical, intent(in), optional :: all_with_first, by_multigrid
      real(wp), allocatable :: constant(:, :)
      integer :: row_start(n + 1), columns(3*n), first_rows(0:petsc%ranks%size), i, j, k
      type(error_type), allocatable :: error

      ! a band of three, although a rank fills some of it alone
      k = 0
      do i = 1, n
         row_start(i) = k
         do j = max(i - 1, 1), min(i + 1, n)
            k = k + 1
            columns(k) = j - 1
         end do
      end do
      row_start(n + 1) = k
      first_rows = [(n*i/petsc%ranks%size, i=0, petsc%ranks%size)]
      if (present(all_with_first)) first_rows(1:) = n
      if (.not. associated(solver%values)) then
         solver%petsc = petsc
         ! without it there is no argument
         if (present(by_multigrid)) allocate (constant(n, 1), source=1.0_wp/sqrt(real(n, wp)))
         call solver%set_pattern(row_start, columns(:k), first_rows, error, constant)
         call assertFalse(allocated(error), 'pattern')
      end if
      solver%values = 0.0_wp
      do i = 1 + petsc%ranks%rank, n, petsc%ranks%size
         call add(i, i, 1.0_wp + 0.1_wp*i)
         if (i == n) cycle
         call add(i, i, 1.0_wp)
         call add(i + 1, i + 1, 1.0_wp)
         call add(i, i + 1, -1.0_wp + convection)
         call add(i + 1, i, -1.0_wp - convection)
      end do

   contains

      subroutine add(row, column, value)
         integer, intent(in) :: row, column
         real(wp), intent(in) :: value
         integer :: at

         do at = solver%row_start(row) + 1, solver%row_start(row + 1)
            if (solver%columns(at) == column - 1) solver%values(at) = solver%values(at) + value
         end do
      end subroutine add

   end subroutine fill

   !> The whole matrix times a vector, by a formula.
   function times(convection, x) result(y)
      real(wp), intent(in) :: convection, x(n)
      real(wp) :: y(n)
      integer :: i

      y = [(1.0_wp + 0.1_wp*i, i=1, n)]*x
      y(:n - 1) = y(:n - 1) + x(:n - 1) + (convection - 1.0_wp)*x(2:)
      y(2:) = y(2:) + x(2:) - (convection + 1.0_wp)*x(:n - 1)
   end function times

   subroutine test_solve()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(n), b(n)
      integer :: i

      call fill(solver, 0.5_wp)
      call solver%factorise(error)
      call assertFalse(allocated(error), 'factorised')
      b = [(sin(real(i, wp)), i=1, n)]
      call solver%solve(b, x, error)
      call assertFalse(allocated(error), 'solved')
      call assertLessThan(norm2(times(0.5_wp, x) - b), 1.0e-13_wp*norm2(b))
      call solver%release()
   end subroutine test_solve

   subroutine test_multigrid()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(n), b(n)
      logical :: has_converged

      call fill(solver, 0.5_wp, by_multigrid=.true.)
      call solver%factorise(error)
      call assertFalse(allocated(error), 'levels')
      b = 1.0_wp
      call solver%solve(b, x, error, 1.0e-10_wp)
      call assertFalse(allocated(error), 'solved')
      call assertLessThan(norm2(times(0.5_wp, x) - b), 1.01e-10_wp*norm2(b))
      call fill(solver, 0.4_wp)
      call solver%iterate(b, x, 1.0e-3_wp, has_converged, error)
      call assertTrue(has_converged .and. solver%is_multigrid)
      call assertLessThan(norm2(times(0.4_wp, x) - b), 1.01e-3_wp*norm2(b))
      call solver%release()
   end subroutine test_multigrid

   subroutine test_iterate()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(n), b(n)
      logical :: has_converged

      call fill(solver, 0.5_wp)
      call solver%factorise(error)
      call fill(solver, 0.4_wp)
      b = 1.0_wp
      call solver%iterate(b, x, 1.0e-3_wp, has_converged, error)
      call assertFalse(allocated(error))
      call assertTrue(has_converged, 'converged')
      call assertLessThan(norm2(times(0.4_wp, x) - b), 1.01e-3_wp*norm2(b))
      call assertEqual(1, solver%n_factorisations)
      call solver%release()
   end subroutine test_iterate

   subroutine test_empty()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error
      real(wp) :: x(n), b(n)

      call fill(solver, 0.5_wp, all_with_first=.true.)
      call solver%factorise(error)
      call assertFalse(allocated(error), 'factorised')
      b = 1.0_wp
      call solver%solve(b, x, error)
      call assertLessThan(norm2(times(0.5_wp, x) - b), 1.0e-13_wp*norm2(b))
      call solver%release()
   end subroutine test_empty

   subroutine test_refused()
      type(linear_solver) :: solver
      type(error_type), allocatable :: error

      call fill(solver, 0.5_wp)
      if (petsc%ranks%rank == petsc%ranks%size - 1) solver%values(7) = &
         ieee_value(1.0_wp, ieee_quiet_nan)
      call solver%factorise(error)
      call assertTrue(allocated(error), 'no number')
      solver%values = 0.0_wp
      call solver%factorise(error)
      call assertTrue(allocated(error), 'singular')
      call fill(solver, 0.5_wp)
      call solver%factorise(error)
      call assertFalse(allocated(error), 'as before')
      call solver%release()
   end subroutine test_refused

end module test_ranks_linear_solver
