!> The sparse matrix of a solid and its solver: an LU factorisation that serves, while the matrix
!> changes, as preconditioner of GMRES. PETSc holds both (`interface/petsc`), where the build found
!> it; elsewhere `without_petsc.f90` says what to install.
!>
!> Rows are laid out by owner; here all are this rank's.
module asperity_solid_engine_linear_solver
   ! more than is used here: gfortran 12 does not see what a submodule names itself
   use, intrinsic :: iso_c_binding, only: c_associated, c_f_pointer, c_funloc, c_int, c_loc, &
      c_null_ptr, c_ptr
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: linear_solver, start_engine, stop_engine

   !> What the failure of a build without the engine begins with
   character(len=*), parameter, public :: no_engine = 'this build has no PETSc'

   !> Matrix by rows and its solver.
   type :: linear_solver
      !> Number of rows; where each begins in `columns` and `values`, counted from 0, and one more
      integer :: n = 0
      integer(c_int), pointer, contiguous :: row_start(:) => null()
      !> Column of each value, counted from 0, rising within a row
      integer(c_int), pointer, contiguous :: columns(:) => null()
      !> The values
      real(wp), pointer, contiguous :: values(:) => null()
      !> Whether there are factors, of these values or of earlier ones
      logical :: has_factors = .false.
      !> Counts since `start`: patterns, factorisations, solutions with factors
      integer :: n_patterns = 0, n_factorisations = 0, n_solutions = 0
      !> Room beyond the estimate that the factors take, %
      integer(c_int), private :: room = 0
      !> PETSc's matrix, Krylov solver and preconditioner
      type(c_ptr), private :: matrix = c_null_ptr, krylov = c_null_ptr, &
         preconditioner = c_null_ptr
   contains
      !> A new pattern: values become zero, factors are gone
      procedure :: set_pattern
      !> Factors of the present values
      procedure :: factorise
      !> Solution by the factors, whatever matrix they are of
      procedure :: solve
      !> Solution for the present values by GMRES with the factors
      procedure :: iterate
      !> Give all memory back
      procedure :: release
   end type linear_solver

   interface
      !> Start PETSc, once in a process. `error` is set where the build has none.
      module subroutine start_engine(error)
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine start_engine

      !> Stop PETSc, if it was started.
      module subroutine stop_engine()
      end subroutine stop_engine

      !> Take a new pattern.
      module subroutine set_pattern(self, row_start, columns, error)
         !> The solver
         class(linear_solver), intent(inout) :: self
         !> Where each row begins, from 0, and one more; columns from 0, rising in each row
         integer, intent(in) :: row_start(:), columns(:)
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine set_pattern

      !> Factorise the matrix. `error` is set when it is singular or there is no memory.
      module subroutine factorise(self, error)
         !> The solver
         class(linear_solver), intent(inout) :: self
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine factorise

      !> Solve by the factors alone.
      module subroutine solve(self, right_side, solution, error)
         !> The solver
         class(linear_solver), intent(inout) :: self
         !> Right side
         real(wp), intent(in), target :: right_side(:)
         !> Solution
         real(wp), intent(out), target :: solution(:)
         !> Set on failure
         type(error_type), allocatable, intent(out) :: error
      end subroutine solve

      !> Solve with the present values by GMRES, preconditioned from the right by the factors. It
      !> gives up after four vectors that leave more than 0.3 of the residual, or after ten.
      module subroutine iterate(self, right_side, solution, tolerance, has_converged, error)
         !> The solver
         class(linear_solver), intent(inout) :: self
         !> Right side
         real(wp), intent(in), target :: right_side(:)
         !> Solution, where it has converged
         real(wp), intent(out), target :: solution(:)
         !> What may be left of the residual, over the right side
         real(wp), intent(in) :: tolerance
         !> Whether it has
         logical, intent(out) :: has_converged
         !> Set on failure of another kind
         type(error_type), allocatable, intent(out) :: error
      end subroutine iterate

      !> Give all memory back.
      module subroutine release(self)
         !> The solver
         class(linear_solver), intent(inout) :: self
      end subroutine release
   end interface

end module asperity_solid_engine_linear_solver
