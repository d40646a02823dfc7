!> The sparse matrix of a solid and its solver by PETSc: AIJ matrix over arrays of this module, LU
!> by MUMPS, which serves, while the matrix changes, as preconditioner of GMRES.
!>
!> MUMPS and not PETSc's own LU, which takes pivots below 2.2e-14 for zero. The pattern is
!> symmetric and so is the order of elimination: no permutation by values, small pivots are kept.
!> Rows are laid out by owner; here all are this rank's. Libraries raise floating-point flags as
!> they like: who calls them does not stop at that, and Fortran gives the caller its own way back.
module asperity_solid_engine_linear_solver
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int, &
      c_loc, c_null_char, c_null_funptr, c_null_ptr, c_ptr
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_solid_engine_petsc, only: ksp_converged_iterating, ksp_converged_rtol, &
      ksp_diverged_its, mat_final_assembly, pc_right, petsc_false, petsc_library, petsc_true
   implicit none
   private
   public :: linear_solver

   !> Matrix by rows and its solver.
   type :: linear_solver
      !> PETSc, loaded
      type(petsc_library) :: petsc
      !> Number of rows; where each begins in `columns` and `values`, counted from 0, and one more
      integer :: n = 0
      integer(c_int), pointer, contiguous :: row_start(:) => null()
      !> Column of each value, counted from 0, rising within a row
      integer(c_int), pointer, contiguous :: columns(:) => null()
      !> The values
      real(wp), pointer, contiguous :: values(:) => null()
      !> Whether there are factors, of these values or of earlier ones
      logical :: has_factors = .false.
      !> How many patterns, factorisations, and solutions by factors alone
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

   !> Choices of MUMPS' manual: 6 permutation by values (0: none), 7 ordering (5: METIS), 8 scaling
   !> (0: none), 14 room beyond the estimate (%); 1 threshold of partial pivoting
   integer(c_int), parameter :: mumps_places(3) = [6, 7, 8], mumps_values(3) = [0, 5, 0], &
      room_place = 14, first_room = 60, room_error = -9, largest_room = 1000
   real(wp), parameter :: pivot_threshold = 1.0e-3_wp
   !> Most vectors of GMRES; after so many it gives up when more than this share of the residual is
   !> left
   integer(c_int), parameter :: most_vectors = 10, trial_vectors = 4
   real(wp), parameter :: hopeless = 0.3_wp
   !> What the convergence test is told
   type, bind(c) :: test_context
      real(c_double) :: tolerance
      real(c_double) :: first
   end type test_context

contains

   !> Take a new pattern.
   subroutine set_pattern(self, row_start, columns, error)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Where each row begins, from 0, and one more; columns from 0, rising in each row
      integer, intent(in) :: row_start(:), columns(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      call self%release()
      self%n = size(row_start) - 1
      allocate (self%row_start(size(row_start)), source=int(row_start, c_int))
      allocate (self%columns(size(columns)), source=int(columns, c_int))
      allocate (self%values(size(columns)), source=0.0_wp)
      code = self%petsc%mat_create(self%petsc%world, self%n, self%n, self%row_start, &
         self%columns, self%values, self%matrix)
      self%room = first_room
      if (code == 0) code = new_krylov(self)
      call check(code, 'take the matrix', error)
      self%n_patterns = self%n_patterns + 1
   end subroutine set_pattern

   !> Factorise the matrix. `error` is set when it is singular or there is no memory.
   subroutine factorise(self, error)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code, reason, mumps_code
      type(c_ptr) :: factors

      call ieee_set_halting_mode(ieee_all, .false.)
      self%has_factors = .false.
      if (.not. all(abs(self%values) <= huge(1.0_wp))) then
         call fatal_error(error, 'the matrix has entries that are not numbers', &
            computation_error)
         return
      end if
      do
         code = self%petsc%mat_assembly_begin(self%matrix, mat_final_assembly)
         if (code == 0) code = self%petsc%mat_assembly_end(self%matrix, mat_final_assembly)
         if (code == 0) code = self%petsc%pc_set_reuse(self%preconditioner, petsc_false)
         if (code == 0) code = self%petsc%pc_set_up(self%preconditioner)
         if (code == 0) code = self%petsc%pc_set_reuse(self%preconditioner, petsc_true)
         if (code == 0) code = self%petsc%pc_get_failed_reason(self%preconditioner, reason)
         if (code == 0) code = self%petsc%pc_factor_get_matrix(self%preconditioner, factors)
         if (code == 0) code = self%petsc%get_infog(factors, 1_c_int, mumps_code)
         call check(code, 'factorise the matrix', error)
         if (allocated(error)) return
         self%n_factorisations = self%n_factorisations + 1
         self%has_factors = reason == 0 .and. mumps_code >= 0
         if (self%has_factors) exit
         ! PETSc's MUMPS does not factorise again where it has failed
         if (mumps_code == room_error .and. self%room < largest_room) self%room = 2*self%room
         code = new_krylov(self)
         call check(code, 'begin again', error)
         if (allocated(error)) return
         if (mumps_code /= room_error .or. self%room > largest_room) exit
      end do
      if (.not. self%has_factors) call fatal_error(error, 'the matrix cannot be factorised: '// &
         'MUMPS says '//to_text(mumps_code), computation_error)
   end subroutine factorise

   !> Solve by the factors alone.
   subroutine solve(self, right_side, solution, error)
      !> The solver
      class(linear_solver), intent(inout) :: self
      !> Right side
      real(wp), intent(in), target :: right_side(:)
      !> Solution
      real(wp), intent(out), target :: solution(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer(c_int) :: code
      type(c_ptr) :: b, x

      call ieee_set_halting_mode(ieee_all, .false.)
      code = new_vectors(self, right_side, solution, b, x)
      if (code == 0) code = self%petsc%pc_apply(self%preconditioner, b, x)
      self%n_solutions = self%n_solutions + 1
      if (code == 0) code = self%petsc%vec_destroy(b)
      if (code == 0) code = self%petsc%vec_destroy(x)
      call check(code, 'solve', error)
   end subroutine solve

   !> Solve with the present values by GMRES, preconditioned from the right by the factors. It gives
   !> up after four vectors that leave more than 0.3 of the residual, or after ten.
   subroutine iterate(self, right_side, solution, tolerance, has_converged, error)
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
      integer(c_int) :: code, reason
      type(c_ptr) :: b, x
      type(test_context), target :: context

      call ieee_set_halting_mode(ieee_all, .false.)
      has_converged = .false.
      context = test_context(tolerance, 0.0_wp)
      code = self%petsc%mat_assembly_begin(self%matrix, mat_final_assembly)
      if (code == 0) code = self%petsc%mat_assembly_end(self%matrix, mat_final_assembly)
      if (code == 0) code = self%petsc%ksp_set_tolerances(self%krylov, tolerance, tiny(1.0_wp), &
         huge(1.0_wp), most_vectors)
      if (code == 0) code = set_test(self, context)
      if (code == 0) code = new_vectors(self, right_side, solution, b, x)
      if (code == 0) code = self%petsc%ksp_solve(self%krylov, b, x)
      if (code == 0) code = self%petsc%ksp_get_converged_reason(self%krylov, reason)
      if (code == 0) code = self%petsc%vec_destroy(b)
      if (code == 0) code = self%petsc%vec_destroy(x)
      call check(code, 'solve by GMRES', error)
      if (allocated(error)) return
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
      self%has_factors = .false.
   end subroutine release

   !> Krylov solver and preconditioner for the matrix, in place of any there are.
   integer(c_int) function new_krylov(self) result(code)
      type(linear_solver), intent(inout) :: self
      type(c_ptr) :: factors
      integer :: i

      code = 0
      if (c_associated(self%krylov)) code = self%petsc%ksp_destroy(self%krylov)
      if (code == 0) code = self%petsc%ksp_create(self%petsc%world, self%krylov)
      if (code == 0) code = self%petsc%ksp_set_operators(self%krylov, self%matrix, self%matrix)
      if (code == 0) code = self%petsc%ksp_set_type(self%krylov, 'gmres'//c_null_char)
      if (code == 0) code = self%petsc%ksp_gmres_set_restart(self%krylov, most_vectors)
      if (code == 0) code = self%petsc%ksp_set_pc_side(self%krylov, pc_right)
      if (code == 0) code = self%petsc%ksp_get_pc(self%krylov, self%preconditioner)
      if (code == 0) code = self%petsc%pc_set_type(self%preconditioner, 'lu'//c_null_char)
      if (code == 0) code = self%petsc%pc_set_error_if_failure(self%preconditioner, petsc_false)
      if (code == 0) code = self%petsc%pc_factor_set_solver(self%preconditioner, &
         'mumps'//c_null_char)
      if (code == 0) code = self%petsc%pc_factor_set_up_solver(self%preconditioner)
      if (code == 0) code = self%petsc%pc_factor_get_matrix(self%preconditioner, factors)
      do i = 1, size(mumps_places)
         if (code == 0) code = self%petsc%set_icntl(factors, mumps_places(i), mumps_values(i))
      end do
      if (code == 0) code = self%petsc%set_icntl(factors, room_place, self%room)
      if (code == 0) code = self%petsc%set_cntl(factors, 1_c_int, pivot_threshold)
   end function new_krylov

   !> Vectors of PETSc over two arrays.
   integer(c_int) function new_vectors(self, right_side, solution, b, x) result(code)
      class(linear_solver), intent(in) :: self
      real(wp), intent(in), target :: right_side(:), solution(:)
      type(c_ptr), intent(out) :: b, x

      x = c_null_ptr
      code = self%petsc%vec_create(self%petsc%world, 1_c_int, size(right_side, kind=c_int), &
         right_side, b)
      if (code == 0) code = self%petsc%vec_create(self%petsc%world, 1_c_int, &
         size(solution, kind=c_int), solution, x)
   end function new_vectors

   !> Let GMRES be stopped by `residual_is_small`.
   integer(c_int) function set_test(self, context) result(code)
      class(linear_solver), intent(in) :: self
      type(test_context), intent(in), target :: context

      code = self%petsc%ksp_set_convergence_test(self%krylov, c_funloc(residual_is_small), &
         c_loc(context), c_null_funptr)
   end function set_test

   !> PETSc's convergence test: the tolerance, and no more vectors where the first were no use.
   integer(c_int) function residual_is_small(krylov, iteration, residual, reason, context) bind(c)
      type(c_ptr), value :: krylov, context
      integer(c_int), value :: iteration
      real(c_double), value :: residual
      integer(c_int), intent(out) :: reason
      type(test_context), pointer :: asked

      residual_is_small = 0
      if (.not. c_associated(krylov)) residual_is_small = 1
      call c_f_pointer(context, asked)
      if (iteration == 0) asked%first = residual
      reason = ksp_converged_iterating
      if (residual <= asked%tolerance*asked%first) then
         reason = ksp_converged_rtol
      else if (iteration >= most_vectors .or. .not. residual <= huge(1.0_wp)) then
         reason = ksp_diverged_its
      else if (iteration == trial_vectors .and. residual > hopeless*asked%first) then
         reason = ksp_diverged_its
      end if
   end function residual_is_small

   !> Set `error` when a function of PETSc has failed.
   subroutine check(code, doing, error)
      integer(c_int), intent(in) :: code
      character(len=*), intent(in) :: doing
      type(error_type), allocatable, intent(out) :: error

      if (code /= 0) call fatal_error(error, 'PETSc cannot '//doing//': its error code is '// &
         to_text(code), computation_error)
   end subroutine check

end module asperity_solid_engine_linear_solver
