!> Functions of PETSc's C interface that the solver calls, as its headers declare them (3.18, real,
!> 32-bit indices). C's binding needs no module files of PETSc, which are made for one compiler.
!> Every function returns zero on success. Besides, the function of POSIX that sets the environment.
module asperity_petsc_calls
   use, intrinsic :: iso_c_binding, only: c_char, c_double, c_funptr, c_int, c_ptr
   implicit none
   private
   public :: set_environment, petsc_initialize, petsc_finalize, petsc_pop_signal_handler, &
      petsc_push_error_handler, petsc_return_error_handler, petsc_get_version, &
      mat_create_seq_aij_with_arrays, mat_assembly_begin, mat_assembly_end, mat_destroy, &
      mat_mumps_set_icntl, mat_mumps_set_cntl, mat_mumps_get_infog, vec_create_seq_with_array, &
      vec_destroy, ksp_create, ksp_destroy, ksp_set_operators, ksp_set_type, ksp_get_pc, &
      ksp_set_pc_side, ksp_set_tolerances, ksp_set_convergence_test, ksp_gmres_set_restart, &
      ksp_solve, ksp_get_converged_reason, pc_set_type, pc_factor_set_mat_solver_type, &
      pc_factor_set_up_mat_solver_type, pc_factor_get_matrix, pc_set_reuse_preconditioner, &
      pc_set_up, pc_apply, pc_get_failed_reason, pc_set_error_if_failure

   !> All ranks; a handle of MPI, whose size is that of a pointer in Open MPI
   type(c_ptr), bind(c, name='PETSC_COMM_WORLD'), public :: petsc_comm_world

   !> Values of PETSc's enumerations
   integer(c_int), parameter, public :: mat_final_assembly = 0, pc_right = 1, petsc_false = 0, &
      petsc_true = 1, ksp_converged_rtol = 2, ksp_converged_iterating = 0, ksp_diverged_its = -3

   interface
      integer(c_int) function set_environment(name, value, overwrites) bind(c, name='setenv')
         import :: c_char, c_int
         implicit none
         character(kind=c_char), intent(in) :: name(*), value(*)
         integer(c_int), value :: overwrites
      end function set_environment

      integer(c_int) function petsc_initialize() bind(c, name='PetscInitializeNoArguments')
         import :: c_int
         implicit none
      end function petsc_initialize

      integer(c_int) function petsc_finalize() bind(c, name='PetscFinalize')
         import :: c_int
         implicit none
      end function petsc_finalize

      integer(c_int) function petsc_get_version(major, minor, subminor, release) &
            bind(c, name='PetscGetVersionNumber')
         import :: c_int
         implicit none
         integer(c_int), intent(out) :: major, minor, subminor, release
      end function petsc_get_version

      integer(c_int) function petsc_pop_signal_handler() bind(c, name='PetscPopSignalHandler')
         import :: c_int
         implicit none
      end function petsc_pop_signal_handler

      integer(c_int) function petsc_push_error_handler(handler, context) &
            bind(c, name='PetscPushErrorHandler')
         import :: c_funptr, c_int, c_ptr
         implicit none
         type(c_funptr), value :: handler
         type(c_ptr), value :: context
      end function petsc_push_error_handler

      !> Returns its fifth argument and prints nothing
      integer(c_int) function petsc_return_error_handler(communicator, line, function_name, file, &
            code, kind, message, context) bind(c, name='PetscReturnErrorHandler')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: communicator, function_name, file, message, context
         integer(c_int), value :: line, code, kind
      end function petsc_return_error_handler

      integer(c_int) function mat_create_seq_aij_with_arrays(communicator, rows, columns, &
            row_start, column, values, matrix) bind(c, name='MatCreateSeqAIJWithArrays')
         import :: c_double, c_int, c_ptr
         implicit none
         type(c_ptr), value :: communicator
         integer(c_int), value :: rows, columns
         integer(c_int), intent(in) :: row_start(*), column(*)
         real(c_double), intent(in) :: values(*)
         type(c_ptr), intent(out) :: matrix
      end function mat_create_seq_aij_with_arrays

      integer(c_int) function mat_assembly_begin(matrix, kind) bind(c, name='MatAssemblyBegin')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: matrix
         integer(c_int), value :: kind
      end function mat_assembly_begin

      integer(c_int) function mat_assembly_end(matrix, kind) bind(c, name='MatAssemblyEnd')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: matrix
         integer(c_int), value :: kind
      end function mat_assembly_end

      integer(c_int) function mat_destroy(matrix) bind(c, name='MatDestroy')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), intent(inout) :: matrix
      end function mat_destroy

      integer(c_int) function mat_mumps_set_icntl(factors, place, value) &
            bind(c, name='MatMumpsSetIcntl')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: factors
         integer(c_int), value :: place, value
      end function mat_mumps_set_icntl

      integer(c_int) function mat_mumps_set_cntl(factors, place, value) &
            bind(c, name='MatMumpsSetCntl')
         import :: c_double, c_int, c_ptr
         implicit none
         type(c_ptr), value :: factors
         integer(c_int), value :: place
         real(c_double), value :: value
      end function mat_mumps_set_cntl

      integer(c_int) function mat_mumps_get_infog(factors, place, value) &
            bind(c, name='MatMumpsGetInfog')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: factors
         integer(c_int), value :: place
         integer(c_int), intent(out) :: value
      end function mat_mumps_get_infog

      integer(c_int) function vec_create_seq_with_array(communicator, block_size, n, values, &
            vector) bind(c, name='VecCreateSeqWithArray')
         import :: c_double, c_int, c_ptr
         implicit none
         type(c_ptr), value :: communicator
         integer(c_int), value :: block_size, n
         real(c_double), intent(in) :: values(*)
         type(c_ptr), intent(out) :: vector
      end function vec_create_seq_with_array

      integer(c_int) function vec_destroy(vector) bind(c, name='VecDestroy')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), intent(inout) :: vector
      end function vec_destroy

      integer(c_int) function ksp_create(communicator, solver) bind(c, name='KSPCreate')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: communicator
         type(c_ptr), intent(out) :: solver
      end function ksp_create

      integer(c_int) function ksp_destroy(solver) bind(c, name='KSPDestroy')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), intent(inout) :: solver
      end function ksp_destroy

      integer(c_int) function ksp_set_operators(solver, matrix, of_preconditioner) &
            bind(c, name='KSPSetOperators')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver, matrix, of_preconditioner
      end function ksp_set_operators

      integer(c_int) function ksp_set_type(solver, name) bind(c, name='KSPSetType')
         import :: c_char, c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         character(kind=c_char), intent(in) :: name(*)
      end function ksp_set_type

      integer(c_int) function ksp_get_pc(solver, preconditioner) bind(c, name='KSPGetPC')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         type(c_ptr), intent(out) :: preconditioner
      end function ksp_get_pc

      integer(c_int) function ksp_set_pc_side(solver, side) bind(c, name='KSPSetPCSide')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         integer(c_int), value :: side
      end function ksp_set_pc_side

      integer(c_int) function ksp_set_tolerances(solver, relative, absolute, divergence, most) &
            bind(c, name='KSPSetTolerances')
         import :: c_double, c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         real(c_double), value :: relative, absolute, divergence
         integer(c_int), value :: most
      end function ksp_set_tolerances

      integer(c_int) function ksp_set_convergence_test(solver, test, context, destroy) &
            bind(c, name='KSPSetConvergenceTest')
         import :: c_funptr, c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver, context
         type(c_funptr), value :: test, destroy
      end function ksp_set_convergence_test

      integer(c_int) function ksp_gmres_set_restart(solver, vectors) &
            bind(c, name='KSPGMRESSetRestart')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         integer(c_int), value :: vectors
      end function ksp_gmres_set_restart

      integer(c_int) function ksp_solve(solver, right_side, solution) bind(c, name='KSPSolve')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver, right_side, solution
      end function ksp_solve

      integer(c_int) function ksp_get_converged_reason(solver, reason) &
            bind(c, name='KSPGetConvergedReason')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: solver
         integer(c_int), intent(out) :: reason
      end function ksp_get_converged_reason

      integer(c_int) function pc_set_type(preconditioner, name) bind(c, name='PCSetType')
         import :: c_char, c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         character(kind=c_char), intent(in) :: name(*)
      end function pc_set_type

      integer(c_int) function pc_factor_set_mat_solver_type(preconditioner, name) &
            bind(c, name='PCFactorSetMatSolverType')
         import :: c_char, c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         character(kind=c_char), intent(in) :: name(*)
      end function pc_factor_set_mat_solver_type

      integer(c_int) function pc_factor_set_up_mat_solver_type(preconditioner) &
            bind(c, name='PCFactorSetUpMatSolverType')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
      end function pc_factor_set_up_mat_solver_type

      integer(c_int) function pc_factor_get_matrix(preconditioner, factors) &
            bind(c, name='PCFactorGetMatrix')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         type(c_ptr), intent(out) :: factors
      end function pc_factor_get_matrix

      integer(c_int) function pc_set_reuse_preconditioner(preconditioner, reuse) &
            bind(c, name='PCSetReusePreconditioner')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         integer(c_int), value :: reuse
      end function pc_set_reuse_preconditioner

      integer(c_int) function pc_set_up(preconditioner) bind(c, name='PCSetUp')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
      end function pc_set_up

      integer(c_int) function pc_apply(preconditioner, right_side, solution) bind(c, name='PCApply')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner, right_side, solution
      end function pc_apply

      integer(c_int) function pc_get_failed_reason(preconditioner, reason) &
            bind(c, name='PCGetFailedReason')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         integer(c_int), intent(out) :: reason
      end function pc_get_failed_reason

      integer(c_int) function pc_set_error_if_failure(preconditioner, stops) &
            bind(c, name='PCSetErrorIfFailure')
         import :: c_int, c_ptr
         implicit none
         type(c_ptr), value :: preconditioner
         integer(c_int), value :: stops
      end function pc_set_error_if_failure
   end interface

end module asperity_petsc_calls
