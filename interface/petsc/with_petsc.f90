!> The solver of solids by PETSc: AIJ matrix over the caller's own arrays, LU by MUMPS, GMRES.
!>
!> MUMPS and not PETSc's own LU, which takes pivots below 2.2e-14 for zero. The pattern is
!> symmetric and so is the order of elimination: no permutation by values, small pivots are kept.
!> Libraries raise floating-point flags as they like: who calls them does not stop at that, and
!> Fortran gives the caller its own way back on return.
submodule(asperity_solid_engine_linear_solver) with_petsc
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_double, c_null_char, c_null_funptr
   use asperity_base_error, only: fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_petsc_calls, only: ksp_converged_iterating, ksp_converged_rtol, ksp_create, &
      ksp_destroy, ksp_diverged_its, ksp_get_converged_reason, ksp_get_pc, ksp_gmres_set_restart, &
      ksp_set_convergence_test, ksp_set_operators, ksp_set_pc_side, ksp_set_tolerances, &
      ksp_set_type, ksp_solve, mat_assembly_begin, mat_assembly_end, &
      mat_create_seq_aij_with_arrays, mat_destroy, mat_final_assembly, mat_mumps_get_infog, &
      mat_mumps_set_cntl, mat_mumps_set_icntl, pc_apply, pc_factor_get_matrix, &
      pc_factor_set_mat_solver_type, pc_factor_set_up_mat_solver_type, pc_get_failed_reason, &
      pc_right, pc_set_error_if_failure, pc_set_reuse_preconditioner, pc_set_type, pc_set_up, &
      petsc_comm_world, petsc_false, petsc_finalize, petsc_get_version, petsc_initialize, &
      petsc_pop_signal_handler, petsc_push_error_handler, petsc_return_error_handler, petsc_true, &
      set_environment, vec_create_seq_with_array, vec_destroy
   implicit none

   !> Choices of MUMPS' manual: 6 permutation by values (0: none), 7 ordering (5: METIS), 8 scaling
   !> (0: none), 14 room beyond the estimate (%); 1 threshold of partial pivoting
   integer(c_int), parameter :: mumps_places(3) = [6, 7, 8], mumps_values(3) = [0, 5, 0], &
      room_place = 14, first_room = 60, room_error = -9, largest_room = 1000
   real(wp), parameter :: pivot_threshold = 1.0e-3_wp
   !> Most vectors of GMRES; after so many it gives up when more than this share of the residual is
   !> left
   integer(c_int), parameter :: most_vectors = 10, trial_vectors = 4
   real(wp), parameter :: hopeless = 0.3_wp
   !> The interface is that of this release, and is checked when PETSc starts
   integer(c_int), parameter :: known_major = 3, first_minor = 18, last_minor = 20

   !> What the convergence test is told
   type, bind(c) :: test_context
      real(c_double) :: tolerance
      real(c_double) :: first
   end type test_context

contains

   module procedure start_engine
      integer(c_int) :: code, version(4)

      call ieee_set_halting_mode(ieee_all, .false.)
      ! Else Open MPI starts a process orted beside a program that mpirun has not started
      code = set_environment('OMPI_MCA_ess_singleton_isolated'//c_null_char, '1'//c_null_char, &
         overwrites=0_c_int)
      if (code == 0) code = petsc_initialize()
      if (code == 0) code = petsc_pop_signal_handler()
      if (code == 0) code = petsc_push_error_handler(c_funloc(petsc_return_error_handler), &
         c_null_ptr)
      if (code == 0) code = petsc_get_version(version(1), version(2), version(3), version(4))
      call check(code, 'start', error)
      if (allocated(error)) return
      if (version(1) /= known_major .or. version(2) < first_minor .or. version(2) > last_minor) &
         call fatal_error(error, 'PETSc '//to_text(version(1))//'.'//to_text(version(2))// &
         ' is not a version that the solid joint knows: 3.18 to 3.20')
   end procedure start_engine

   module procedure stop_engine
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      code = petsc_finalize()
   end procedure stop_engine

   module procedure set_pattern
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      call self%release()
      self%n = size(row_start) - 1
      allocate (self%row_start(size(row_start)), source=int(row_start, c_int))
      allocate (self%columns(size(columns)), source=int(columns, c_int))
      allocate (self%values(size(columns)), source=0.0_wp)
      code = mat_create_seq_aij_with_arrays(petsc_comm_world, self%n, self%n, self%row_start, &
         self%columns, self%values, self%matrix)
      self%room = first_room
      if (code == 0) code = new_krylov(self)
      call check(code, 'take the matrix', error)
      self%n_patterns = self%n_patterns + 1
   end procedure set_pattern

   module procedure factorise
      integer(c_int) :: code, reason, mumps_code
      type(c_ptr) :: factors

      call ieee_set_halting_mode(ieee_all, .false.)
      self%has_factors = .false.
      if (.not. all(abs(self%values) <= huge(1.0_wp))) then
         call fatal_error(error, 'the matrix has entries that are not numbers')
         return
      end if
      do
         code = mat_assembly_begin(self%matrix, mat_final_assembly)
         if (code == 0) code = mat_assembly_end(self%matrix, mat_final_assembly)
         if (code == 0) code = pc_set_reuse_preconditioner(self%preconditioner, petsc_false)
         if (code == 0) code = pc_set_up(self%preconditioner)
         if (code == 0) code = pc_set_reuse_preconditioner(self%preconditioner, petsc_true)
         if (code == 0) code = pc_get_failed_reason(self%preconditioner, reason)
         if (code == 0) code = pc_factor_get_matrix(self%preconditioner, factors)
         if (code == 0) code = mat_mumps_get_infog(factors, 1_c_int, mumps_code)
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
         'MUMPS says '//to_text(mumps_code))
   end procedure factorise

   module procedure solve
      integer(c_int) :: code
      type(c_ptr) :: b, x

      call ieee_set_halting_mode(ieee_all, .false.)
      code = new_vectors(right_side, solution, b, x)
      if (code == 0) code = pc_apply(self%preconditioner, b, x)
      self%n_solutions = self%n_solutions + 1
      if (code == 0) code = vec_destroy(b)
      if (code == 0) code = vec_destroy(x)
      call check(code, 'solve', error)
   end procedure solve

   module procedure iterate
      integer(c_int) :: code, reason
      type(c_ptr) :: b, x
      type(test_context), target :: context

      call ieee_set_halting_mode(ieee_all, .false.)
      has_converged = .false.
      context = test_context(tolerance, 0.0_wp)
      code = mat_assembly_begin(self%matrix, mat_final_assembly)
      if (code == 0) code = mat_assembly_end(self%matrix, mat_final_assembly)
      if (code == 0) code = ksp_set_tolerances(self%krylov, tolerance, tiny(1.0_wp), &
         huge(1.0_wp), most_vectors)
      if (code == 0) code = set_test(self%krylov, context)
      if (code == 0) code = new_vectors(right_side, solution, b, x)
      if (code == 0) code = ksp_solve(self%krylov, b, x)
      if (code == 0) code = ksp_get_converged_reason(self%krylov, reason)
      if (code == 0) code = vec_destroy(b)
      if (code == 0) code = vec_destroy(x)
      call check(code, 'solve by GMRES', error)
      if (allocated(error)) return
      has_converged = reason > 0 .and. all(abs(solution) <= huge(1.0_wp))
   end procedure iterate

   module procedure release
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      if (c_associated(self%krylov)) code = ksp_destroy(self%krylov)
      if (c_associated(self%matrix)) code = mat_destroy(self%matrix)
      self%krylov = c_null_ptr
      self%matrix = c_null_ptr
      self%preconditioner = c_null_ptr
      if (associated(self%values)) deallocate (self%row_start, self%columns, self%values)
      self%has_factors = .false.
   end procedure release

   !> Krylov solver and preconditioner for the matrix, in place of any there are.
   integer(c_int) function new_krylov(self) result(code)
      type(linear_solver), intent(inout) :: self
      type(c_ptr) :: factors
      integer :: i

      code = 0
      if (c_associated(self%krylov)) code = ksp_destroy(self%krylov)
      if (code == 0) code = ksp_create(petsc_comm_world, self%krylov)
      if (code == 0) code = ksp_set_operators(self%krylov, self%matrix, self%matrix)
      if (code == 0) code = ksp_set_type(self%krylov, 'gmres'//c_null_char)
      if (code == 0) code = ksp_gmres_set_restart(self%krylov, most_vectors)
      if (code == 0) code = ksp_set_pc_side(self%krylov, pc_right)
      if (code == 0) code = ksp_get_pc(self%krylov, self%preconditioner)
      if (code == 0) code = pc_set_type(self%preconditioner, 'lu'//c_null_char)
      if (code == 0) code = pc_set_error_if_failure(self%preconditioner, petsc_false)
      if (code == 0) code = pc_factor_set_mat_solver_type(self%preconditioner, &
         'mumps'//c_null_char)
      if (code == 0) code = pc_factor_set_up_mat_solver_type(self%preconditioner)
      if (code == 0) code = pc_factor_get_matrix(self%preconditioner, factors)
      do i = 1, size(mumps_places)
         if (code == 0) code = mat_mumps_set_icntl(factors, mumps_places(i), mumps_values(i))
      end do
      if (code == 0) code = mat_mumps_set_icntl(factors, room_place, self%room)
      if (code == 0) code = mat_mumps_set_cntl(factors, 1_c_int, pivot_threshold)
   end function new_krylov

   !> Vectors of PETSc over two arrays.
   integer(c_int) function new_vectors(right_side, solution, b, x) result(code)
      real(wp), intent(in), target :: right_side(:), solution(:)
      type(c_ptr), intent(out) :: b, x

      x = c_null_ptr
      code = vec_create_seq_with_array(petsc_comm_world, 1_c_int, size(right_side, kind=c_int), &
         right_side, b)
      if (code == 0) code = vec_create_seq_with_array(petsc_comm_world, 1_c_int, &
         size(solution, kind=c_int), solution, x)
   end function new_vectors

   !> Let GMRES be stopped by `residual_is_small`.
   integer(c_int) function set_test(krylov, context) result(code)
      type(c_ptr), intent(in) :: krylov
      type(test_context), intent(in), target :: context

      code = ksp_set_convergence_test(krylov, c_funloc(residual_is_small), c_loc(context), &
         c_null_funptr)
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
         to_text(code))
   end subroutine check

end submodule with_petsc
