!> PETSc, found when it is needed: a program that solves no solid loads neither it nor MPI, and
!> needs neither to be built. What is called is PETSc's C interface as its headers have it (real
!> numbers, 32-bit indices, Open MPI, as Debian builds it); its module files are those of one
!> Fortran compiler. Every function returns zero on success.
module asperity_solid_engine_petsc
   use, intrinsic :: ieee_exceptions, only: ieee_all, ieee_set_halting_mode
   use, intrinsic :: iso_c_binding, only: c_associated, c_char, c_f_pointer, c_f_procpointer, &
      c_funptr, c_int, c_null_char, c_null_ptr, c_ptr
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_replay_shared_library, only: find_data, find_procedure, open_library, &
      shared_library
   use asperity_solid_engine_petsc_functions, only: cntl_function, destroys, finds, gives_number, &
      handler_function, icntl_function, infog_function, matrix_function, of_one, of_three, of_two, &
      option_function, place_function, places_function, plain, sizes_function, space_function, &
      test_function, tolerances_function, values_function, vectors_function, version_function, &
      with_name, with_number
   use asperity_solid_engine_ranks, only: find_ranks, meet_ranks, rank_team
   implicit none
   private
   public :: petsc_library, load_petsc, unload_petsc

   !> Values of PETSc's enumerations
   integer(c_int), parameter, public :: insert_values = 1, pc_right = 1, petsc_false = 0, &
      petsc_true = 1, ksp_converged_rtol = 2, ksp_converged_iterating = 0, ksp_diverged_its = -3

   !> Functions of PETSc.
   type :: petsc_library
      !> All ranks, and MPI's handle of them
      type(rank_team) :: ranks
      type(c_ptr) :: world = c_null_ptr
      procedure(plain), pointer, nopass :: initialize => null(), finalize => null(), &
         pop_signal_handler => null()
      procedure(version_function), pointer, nopass :: get_version => null()
      procedure(handler_function), pointer, nopass :: push_error_handler => null()
      procedure(matrix_function), pointer, nopass :: mat_create => null()
      procedure(sizes_function), pointer, nopass :: mat_set_sizes => null()
      procedure(places_function), pointer, nopass :: mat_set_places => null()
      procedure(values_function), pointer, nopass :: mat_set_values => null()
      procedure(vectors_function), pointer, nopass :: mat_create_vectors => null()
      procedure(place_function), pointer, nopass :: vec_place_array => null()
      procedure(with_number), pointer, nopass :: ksp_set_pc_side => null(), &
         ksp_gmres_set_restart => null(), pc_set_reuse => null(), &
         pc_set_error_if_failure => null()
      procedure(space_function), pointer, nopass :: create_space => null()
      procedure(of_two), pointer, nopass :: mat_set_near_null_space => null()
      procedure(option_function), pointer, nopass :: set_option => null()
      procedure(destroys), pointer, nopass :: mat_destroy => null(), vec_destroy => null(), &
         ksp_destroy => null(), destroy_space => null()
      procedure(finds), pointer, nopass :: ksp_create => null(), ksp_get_pc => null(), &
         pc_factor_get_matrix => null()
      procedure(with_name), pointer, nopass :: mat_set_type => null(), ksp_set_type => null(), &
         pc_set_type => null(), pc_set_prefix => null(), pc_factor_set_solver => null()
      procedure(of_one), pointer, nopass :: pc_factor_set_up_solver => null(), pc_set_up => null()
      procedure(of_three), pointer, nopass :: ksp_set_operators => null(), ksp_solve => null(), &
         pc_apply => null()
      procedure(gives_number), pointer, nopass :: ksp_get_converged_reason => null(), &
         pc_get_failed_reason => null()
      procedure(icntl_function), pointer, nopass :: set_icntl => null()
      procedure(cntl_function), pointer, nopass :: set_cntl => null()
      procedure(infog_function), pointer, nopass :: get_infog => null()
      procedure(tolerances_function), pointer, nopass :: ksp_set_tolerances => null()
      procedure(test_function), pointer, nopass :: ksp_set_convergence_test => null()
   end type petsc_library

   !> Releases whose interface this is: Debian 12, Ubuntu 24.04 and between
   integer, parameter :: major = 3, first_minor = 18, last_minor = 20
   !> Names a library in place of those
   character(len=*), parameter :: variable = 'ASPERITY_PETSC'

   interface
      integer(c_int) function c_setenv(name, value, overwrites) bind(c, name='setenv')
         import :: c_char, c_int
         character(kind=c_char), intent(in) :: name(*), value(*)
         integer(c_int), value :: overwrites
      end function c_setenv
   end interface

contains

   !> Find and start PETSc, once in a process. `error` is set when it is not installed.
   subroutine load_petsc(petsc, error)
      !> Result
      type(petsc_library), intent(out) :: petsc
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(shared_library) :: library
      type(c_ptr) :: handler, world
      type(c_ptr), pointer :: started
      integer(c_int) :: code, version(4)
      logical :: is_whole

      ! libraries raise floating-point flags as they like; on return the caller's way is back
      call ieee_set_halting_mode(ieee_all, .false.)
      call find_library(library, error)
      if (allocated(error)) return
      call take_functions(petsc, library, handler, world, is_whole)
      if (.not. is_whole) then
         call fatal_error(error, 'the PETSc that is installed lacks functions that the solid '// &
            'joint needs: it must have MUMPS', computation_error)
         return
      end if
      ! Else Open MPI starts a process orted beside a program that mpirun has not started
      code = c_setenv('OMPI_MCA_ess_singleton_isolated'//c_null_char, '1'//c_null_char, 0_c_int)
      if (code == 0) code = petsc%initialize()
      if (code == 0) code = petsc%pop_signal_handler()
      if (code == 0) code = petsc%push_error_handler(handler, c_null_ptr)
      if (code == 0) code = petsc%get_version(version(1), version(2), version(3), version(4))
      if (code /= 0) then
         call fatal_error(error, 'PETSc does not start: its error code is '//to_text(code), &
            computation_error)
         return
      end if
      call c_f_pointer(world, started)
      petsc%world = started
      call meet_ranks(petsc%ranks, petsc%world, code)
      if (version(1) /= major .or. version(2) < first_minor .or. version(2) > last_minor) then
         call fatal_error(error, 'PETSc '//to_text(version(1))//'.'//to_text(version(2))// &
            ' is not a version that the solid joint knows: 3.18 to 3.20', computation_error)
      end if
   end subroutine load_petsc

   !> The library that the environment names, or one that is installed; all others find its symbols,
   !> as Open MPI's parts ask for.
   subroutine find_library(library, error)
      type(shared_library), intent(out) :: library
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: path, failure
      integer :: minor, length

      call get_environment_variable(variable, length=length)
      if (length > 0) then
         allocate (character(len=length) :: path)
         call get_environment_variable(variable, path)
         call open_library(path, library, failure, is_global=.true.)
         if (allocated(failure)) call fatal_error(error, 'environment variable '// &
            variable//' = '//path//' is no library that can be loaded: it is to name '// &
            'libpetsc_real.so of PETSc 3.18 to 3.20')
         return
      end if
      do minor = first_minor, last_minor
         call open_library('libpetsc_real.so.'//to_text(major)//'.'//to_text(minor), library, &
            failure, is_global=.true.)
         if (.not. allocated(failure)) return
      end do
      call fatal_error(error, 'PETSc is not installed, which solves the equations of the solid '// &
         'joint: apt-get install libpetsc-real3.18 (Debian 12; versions 3.18 to 3.20 serve). '// &
         'Nothing else needs it', computation_error)
   end subroutine find_library

   !> Stop PETSc.
   subroutine unload_petsc(petsc)
      !> The library
      type(petsc_library), intent(in) :: petsc
      integer(c_int) :: code

      call ieee_set_halting_mode(ieee_all, .false.)
      if (associated(petsc%finalize)) code = petsc%finalize()
   end subroutine unload_petsc

   !> Find every function by its name.
   subroutine take_functions(petsc, library, handler, world, is_whole)
      type(petsc_library), intent(inout) :: petsc
      type(shared_library), intent(in) :: library
      !> Error handler that returns the code and prints nothing
      type(c_ptr), intent(out) :: handler
      !> Where MPI's handle of all ranks is, once PETSc has started
      type(c_ptr), intent(out) :: world
      logical, intent(out) :: is_whole

      is_whole = .true.
      handler = address('PetscReturnErrorHandler')
      world = address('PETSC_COMM_WORLD')
      call find_ranks(petsc%ranks, library, is_whole)
      call c_f_procpointer(of('PetscInitializeNoArguments'), petsc%initialize)
      call c_f_procpointer(of('PetscFinalize'), petsc%finalize)
      call c_f_procpointer(of('PetscPopSignalHandler'), petsc%pop_signal_handler)
      call c_f_procpointer(of('PetscPushErrorHandler'), petsc%push_error_handler)
      call c_f_procpointer(of('PetscGetVersionNumber'), petsc%get_version)
      call c_f_procpointer(of('MatCreate'), petsc%mat_create)
      call c_f_procpointer(of('MatSetSizes'), petsc%mat_set_sizes)
      call c_f_procpointer(of('MatSetType'), petsc%mat_set_type)
      call c_f_procpointer(of('MatSetPreallocationCOO'), petsc%mat_set_places)
      call c_f_procpointer(of('MatSetValuesCOO'), petsc%mat_set_values)
      call c_f_procpointer(of('MatCreateVecs'), petsc%mat_create_vectors)
      call c_f_procpointer(of('MatDestroy'), petsc%mat_destroy)
      call c_f_procpointer(of('VecPlaceArray'), petsc%vec_place_array)
      call c_f_procpointer(of('VecDestroy'), petsc%vec_destroy)
      call c_f_procpointer(of('MatNullSpaceCreate'), petsc%create_space)
      call c_f_procpointer(of('MatNullSpaceDestroy'), petsc%destroy_space)
      call c_f_procpointer(of('MatSetNearNullSpace'), petsc%mat_set_near_null_space)
      call c_f_procpointer(of('PetscOptionsSetValue'), petsc%set_option)
      call c_f_procpointer(of('KSPCreate'), petsc%ksp_create)
      call c_f_procpointer(of('KSPDestroy'), petsc%ksp_destroy)
      call c_f_procpointer(of('KSPSetOperators'), petsc%ksp_set_operators)
      call c_f_procpointer(of('KSPSetType'), petsc%ksp_set_type)
      call c_f_procpointer(of('KSPGetPC'), petsc%ksp_get_pc)
      call c_f_procpointer(of('KSPSetPCSide'), petsc%ksp_set_pc_side)
      call c_f_procpointer(of('KSPGMRESSetRestart'), petsc%ksp_gmres_set_restart)
      call c_f_procpointer(of('KSPSetTolerances'), petsc%ksp_set_tolerances)
      call c_f_procpointer(of('KSPSetConvergenceTest'), petsc%ksp_set_convergence_test)
      call c_f_procpointer(of('KSPSolve'), petsc%ksp_solve)
      call c_f_procpointer(of('KSPGetConvergedReason'), petsc%ksp_get_converged_reason)
      call c_f_procpointer(of('PCSetType'), petsc%pc_set_type)
      call c_f_procpointer(of('PCSetOptionsPrefix'), petsc%pc_set_prefix)
      call c_f_procpointer(of('PCSetErrorIfFailure'), petsc%pc_set_error_if_failure)
      call c_f_procpointer(of('PCFactorSetMatSolverType'), petsc%pc_factor_set_solver)
      call c_f_procpointer(of('PCFactorSetUpMatSolverType'), petsc%pc_factor_set_up_solver)
      call c_f_procpointer(of('PCFactorGetMatrix'), petsc%pc_factor_get_matrix)
      call c_f_procpointer(of('PCSetReusePreconditioner'), petsc%pc_set_reuse)
      call c_f_procpointer(of('PCSetUp'), petsc%pc_set_up)
      call c_f_procpointer(of('PCApply'), petsc%pc_apply)
      call c_f_procpointer(of('PCGetFailedReason'), petsc%pc_get_failed_reason)
      call c_f_procpointer(of('MatMumpsSetIcntl'), petsc%set_icntl)
      call c_f_procpointer(of('MatMumpsSetCntl'), petsc%set_cntl)
      call c_f_procpointer(of('MatMumpsGetInfog'), petsc%get_infog)

   contains

      !> Address of a name.
      type(c_ptr) function address(name)
         character(len=*), intent(in) :: name

         call find_data(library, name, address)
         is_whole = is_whole .and. c_associated(address)
      end function address

      !> Address of a function.
      type(c_funptr) function of(name)
         character(len=*), intent(in) :: name

         call find_procedure(library, name, of)
         is_whole = is_whole .and. c_associated(of)
      end function of

   end subroutine take_functions

end module asperity_solid_engine_petsc
