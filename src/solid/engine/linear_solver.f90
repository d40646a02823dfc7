!> The sparse matrix of a solid and its solver by PETSc: GMRES, preconditioned while the matrix
!> changes by LU of an earlier one or by multigrid. Each rank has a share of the rows; what it adds
!> to rows of others goes there: the matrix is the sum of all. Vectors are whole on every rank.
!> Libraries raise floating-point flags as they like: who calls them does not stop at that, and
!> Fortran gives the caller its own way back.
module asperity_solid_engine_linear_solver
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_funloc, c_int, c_loc, c_null_funptr, &
      c_null_ptr, c_ptr
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_engine_convergence, only: convergence_context, residual_is_small
   use asperity_solid_engine_krylov, only: most_vectors, new_krylov
   use asperity_solid_engine_matrix, only: new_matrix, set_modes
   use asperity_solid_engine_petsc, only: insert_values, petsc_false, petsc_library, petsc_true
   implicit none
   private
   public :: linear_solver

   !> This rank's part of the sum by rows, and the solver.
   type :: linear_solver
      !> PETSc, loaded
      type(petsc_library) :: petsc
      !> Number of rows of all; the first of this rank's, counted from 0, and how many they are
      integer :: n = 0, first = 0, n_own = 0
      !> Where each row of all begins in `columns` and `values`, counted from 0, and one more
      integer(c_int), pointer, contiguous :: row_start(:) => null()
      !> Column of each value, counted from 0, rising within a row
      integer(c_int), pointer, contiguous :: columns(:) => null()
      !> The values
      real(wp), pointer, contiguous :: values(:) => null()
      !> Whether multigrid preconditions, and not factors; whether there are factors, or levels of
      !> multigrid, of these values or of earlier ones
      logical :: is_multigrid = .false., has_factors = .false.
      !> Whether they have not served yet
      logical, private :: is_new = .false.
      !> What multigrid must be able to follow, a column each
      real(wp), pointer, contiguous, private :: modes(:, :) => null()
      !> How many patterns, factorisations or sets of levels, and vectors of GMRES
      integer :: n_patterns = 0, n_factorisations = 0, n_vectors = 0
      !> How often multigrid has not converged, so that factors serve until there is another pattern
      integer :: n_multigrid_failures = 0
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

   !> Room that factors are given beyond MUMPS' estimate, %, and MUMPS' error when it is too little
   integer(c_int), parameter :: first_room = 60, room_error = -9, largest_room = 1000
   !> Most vectors of GMRES by factors of an earlier matrix, and by levels of an earlier one, which
   !> cost no more than some tens of vectors
   integer(c_int), parameter :: most_by_factors = 10, most_by_levels = 40
   !> Vectors that must be of use. By levels, those that got there had at most 0.14 of the residual
   !> left after twenty, and those that had 0.4 or more after twenty had not got there after a
   !> hundred (cycle of 48 mm, 30 and 20 mm)
   integer(c_int), parameter :: trial_by_factors = 4, trial_by_levels = 20
   !> Residual that `solve` leaves by multigrid unless it is told otherwise
   real(wp), parameter :: default_tolerance = 1.0e-8_wp

contains

   !> Take a new pattern. The matrix has the union of those of all ranks.
   subroutine set_pattern(self, row_start, columns, first_rows, error, modes)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Where each row begins, from 0, and one more; columns from 0, rising in each row
      integer, intent(in) :: row_start(:), columns(:)
      !> First row of each rank, from 0, and one more
      integer, intent(in) :: first_rows(0:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> Vectors at right angles that the matrix takes to next to nothing, a column each and whole:
      !> multigrid is to precondition
      real(wp), intent(in), optional :: modes(:, :)
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      call self%release()
      self%is_multigrid = present(modes)
      self%n = size(row_start) - 1
      allocate (self%row_start(size(row_start)), source=int(row_start, c_int))
      allocate (self%columns(size(columns)), source=int(columns, c_int))
      allocate (self%values(size(columns)), source=0.0_wp)
      associate (rank => self%petsc%ranks%rank)
         self%first = first_rows(rank)
         self%n_own = first_rows(rank + 1) - self%first
      end associate
      call new_matrix(self%petsc, self%n_own, self%row_start, self%columns, self%matrix, code)
      if (present(modes)) then
         allocate (self%modes, source=modes(self%first + 1:self%first + self%n_own, :))
         if (code == 0) code = set_modes(self%petsc, self%matrix, self%modes)
      end if
      self%room = first_room
      if (code == 0) code = renew_krylov(self)
      call check(self, code, 'take the matrix', error)
      self%n_patterns = self%n_patterns + 1
   end subroutine set_pattern

   !> Factorise the matrix, or find the levels of multigrid; where it has none, factors serve.
   !> `error` is set when the matrix is singular or there is no memory.
   subroutine factorise(self, error)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code, reason, mumps_code
      type(c_ptr) :: factors

      call ieee_set_halting_mode(ieee_all, .false.)
      self%has_factors = .false.
      if (self%petsc%ranks%any(.not. all(abs(self%values) <= huge(1.0_wp)))) then
         call fatal_error(error, 'the matrix has entries that are not numbers', &
            computation_error)
         return
      end if
      do
         reason = 0
         mumps_code = 0
         code = self%petsc%mat_set_values(self%matrix, self%values, insert_values)
         if (code == 0) code = self%petsc%pc_set_reuse(self%preconditioner, petsc_false)
         if (code == 0) code = self%petsc%pc_set_up(self%preconditioner)
         if (code == 0) code = self%petsc%pc_set_reuse(self%preconditioner, petsc_true)
         if (code == 0) code = self%petsc%pc_get_failed_reason(self%preconditioner, reason)
         if (self%is_multigrid) then
            self%has_factors = .not. self%petsc%ranks%any(code /= 0 .or. reason /= 0)
            if (.not. self%has_factors) call use_factors(self, error)
            if (allocated(error)) return
            if (.not. self%has_factors) cycle
         else
            if (code == 0) code = self%petsc%pc_factor_get_matrix(self%preconditioner, factors)
            if (code == 0) code = self%petsc%get_infog(factors, 1_c_int, mumps_code)
            call check(self, code, 'factorise the matrix', error)
            if (allocated(error)) return
            self%has_factors = reason == 0 .and. mumps_code >= 0
         end if
         self%n_factorisations = self%n_factorisations + 1
         self%is_new = .true.
         if (self%has_factors) exit
         ! PETSc's MUMPS does not factorise again where it has failed
         if (mumps_code == room_error .and. self%room < largest_room) self%room = 2*self%room
         code = renew_krylov(self)
         call check(self, code, 'begin again', error)
         if (allocated(error)) return
         if (mumps_code /= room_error .or. self%room > largest_room) exit
      end do
      if (self%has_factors) return
      call fatal_error(error, 'the matrix cannot be factorised: MUMPS says '// &
         to_text(mumps_code), computation_error)
      if (associated(self%modes)) error%message = error%message// &
         ', where multigrid has not converged'
   end subroutine factorise

   !> Solve by the factors alone; by GMRES with multigrid, and by factors where that fails.
   subroutine solve(self, right_side, solution, error, tolerance)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Right side
      real(wp), intent(in), contiguous, target :: right_side(:)
      !> Solution
      real(wp), intent(out), contiguous, target :: solution(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> What multigrid may leave of the residual, over the right side; 1e-8 unless given
      real(wp), intent(in), optional :: tolerance
      integer(c_int) :: code
      real(wp) :: left
      logical :: has_converged
      type(c_ptr) :: b, x

      if (self%is_multigrid) then
         left = default_tolerance
         if (present(tolerance)) left = tolerance
         call self%iterate(right_side, solution, left, has_converged, error)
         if (allocated(error) .or. has_converged) return
         call use_factors(self, error)
         if (.not. allocated(error)) call self%factorise(error)
         if (allocated(error)) return
      end if
      call ieee_set_halting_mode(ieee_all, .false.)
      solution = 0.0_wp
      code = new_vectors(self, right_side, solution, b, x)
      if (code == 0) code = self%petsc%pc_apply(self%preconditioner, b, x)
      if (code == 0) code = self%petsc%vec_destroy(b)
      if (code == 0) code = self%petsc%vec_destroy(x)
      call check(self, code, 'solve', error)
      if (.not. allocated(error)) call self%petsc%ranks%sum(solution)
   end subroutine solve

   !> Solve with the present values by GMRES, preconditioned from the right. By factors it gives up
   !> after four vectors that leave more than 0.3 of the residual, or ten; by levels after twenty
   !> that do, or forty, or a hundred if they have not served before.
   subroutine iterate(self, right_side, solution, tolerance, has_converged, error)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Right side
      real(wp), intent(in), contiguous, target :: right_side(:)
      !> Solution, where it has converged
      real(wp), intent(out), contiguous, target :: solution(:)
      !> What may be left of the residual, over the right side
      real(wp), intent(in) :: tolerance
      !> Whether it has
      logical, intent(out) :: has_converged
      !> Set on failure of another kind
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code, reason
      type(c_ptr) :: b, x
      type(convergence_context), target :: context

      call ieee_set_halting_mode(ieee_all, .false.)
      has_converged = .false.
      context = convergence_context(tolerance, 0.0_wp, most_by_factors, trial_by_factors, 0)
      if (self%is_multigrid) then
         context%most = merge(most_vectors, most_by_levels, self%is_new)
         context%trial = trial_by_levels
      end if
      self%is_new = .false.
      solution = 0.0_wp
      code = self%petsc%mat_set_values(self%matrix, self%values, insert_values)
      if (code == 0) code = self%petsc%ksp_set_tolerances(self%krylov, tolerance, tiny(1.0_wp), &
         huge(1.0_wp), most_vectors)
      if (code == 0) code = self%petsc%ksp_set_convergence_test(self%krylov, &
         c_funloc(residual_is_small), c_loc(context), c_null_funptr)
      if (code == 0) code = new_vectors(self, right_side, solution, b, x)
      if (code == 0) code = self%petsc%ksp_solve(self%krylov, b, x)
      if (code == 0) code = self%petsc%ksp_get_converged_reason(self%krylov, reason)
      self%n_vectors = self%n_vectors + context%vectors
      if (code == 0) code = self%petsc%vec_destroy(b)
      if (code == 0) code = self%petsc%vec_destroy(x)
      call check(self, code, 'solve by GMRES', error)
      if (allocated(error)) return
      call self%petsc%ranks%sum(solution)
      has_converged = reason > 0 .and. all(abs(solution) <= huge(1.0_wp))
   end subroutine iterate

   !> Give all memory back.
   subroutine release(self)
      !> The solver
      class(linear_solver), intent(inout) :: self
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      if (c_associated(self%krylov)) code = self%petsc%ksp_destroy(self%krylov)
      if (c_associated(self%matrix)) code = self%petsc%mat_destroy(self%matrix)
      self%krylov = c_null_ptr
      self%matrix = c_null_ptr
      self%preconditioner = c_null_ptr
      if (associated(self%values)) deallocate (self%row_start, self%columns, self%values)
      if (associated(self%modes)) deallocate (self%modes)
      self%has_factors = .false.
   end subroutine release

   !> Krylov solver and preconditioner for the matrix, in place of any there are.
   integer(c_int) function renew_krylov(self) result(code)
      type(linear_solver), intent(inout) :: self

      call new_krylov(self%petsc, self%matrix, self%is_multigrid, self%room, self%krylov, &
         self%preconditioner, code)
   end function renew_krylov

   !> Factors in place of multigrid, which has failed, until there is another pattern.
   subroutine use_factors(self, error)
      type(linear_solver), intent(inout) :: self
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code

      self%is_multigrid = .false.
      self%n_multigrid_failures = self%n_multigrid_failures + 1
      code = renew_krylov(self)
      call check(self, code, 'leave multigrid', error)
   end subroutine use_factors

   !> Vectors of PETSc over this rank's parts of two arrays.
   integer(c_int) function new_vectors(self, right_side, solution, b, x) result(code)
      type(linear_solver), intent(in) :: self
      real(wp), intent(in), contiguous, target :: right_side(:), solution(:)
      type(c_ptr), intent(out) :: b, x

      code = self%petsc%mat_create_vectors(self%matrix, x, b)
      if (code == 0) code = self%petsc%vec_place_array(b, right_side(self%first + 1:))
      if (code == 0) code = self%petsc%vec_place_array(x, solution(self%first + 1:))
   end function new_vectors

   !> Set `error` when a function of PETSc has failed, on whatever rank.
   subroutine check(solver, code, doing, error)
      class(linear_solver), intent(in) :: solver
      integer(c_int), intent(in) :: code
      character(len=*), intent(in) :: doing
      type(error_type), allocatable, intent(out) :: error

      if (code /= 0) call fatal_error(error, 'PETSc cannot '//doing//': its error code is '// &
         to_text(code), computation_error)
      call solver%petsc%ranks%agree(error)
   end subroutine check

end module asperity_solid_engine_linear_solver
