!> GMRES and what preconditions it: factors by MUMPS, or algebraic multigrid by PETSc's GAMG.
!>
!> MUMPS and not PETSc's own LU, which takes pivots below 2.2e-14 for zero. The pattern is
!> symmetric and so is the order of elimination: no permutation by values, small pivots are kept.
module asperity_solid_engine_krylov
   use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_char, c_null_ptr, c_ptr
   use asperity_base_kinds, only: wp
   use asperity_solid_engine_petsc, only: pc_right, petsc_false, petsc_library
   implicit none
   private
   public :: new_krylov

   !> Vectors after which GMRES begins anew, which nobody waits for
   integer(c_int), parameter, public :: most_vectors = 100

   !> Choices of MUMPS' manual: 6 permutation by values (0: none), 7 ordering (5: METIS, or PORD
   !> where MUMPS is built without METIS, as Debian's is), 8 scaling (0: none), 14 room beyond the
   !> estimate (%); 1 threshold of partial pivoting
   integer(c_int), parameter :: mumps_places(3) = [6, 7, 8], mumps_values(3) = [0, 5, 0], &
      room_place = 14
   real(wp), parameter :: pivot_threshold = 1.0e-3_wp

   !> Options of multigrid: smoothing by incomplete factors of this rank's rows, once before and
   !> once after each coarser level: twice needs a tenth fewer vectors, each of twice the time.
   !> Small aggregates leave empty rows on coarse levels, which the shift lets pass.
   !> On several ranks the rows next to a rank's own are smoothed with them: without, eight ranks
   !> need 6 to 12 times the vectors of one (30 and 60 mm), with them 1.2 to 1.6 times.
   character(len=*), parameter :: prefix = 'asperity_', options(*) = [character(len=36) :: &
      'mg_levels_ksp_type', 'mg_levels_ksp_max_it', 'mg_levels_sub_pc_type', &
      'mg_levels_sub_pc_factor_shift_type', 'mg_levels_pc_type'], choices(*) = &
      [character(len=10) :: 'richardson', '1', 'ilu', 'nonzero'], alone = 'bjacobi   ', &
      several = 'asm       '

contains

   !> Krylov solver and preconditioner for a matrix, in place of any there are.
   subroutine new_krylov(petsc, matrix, is_multigrid, room, krylov, preconditioner, code)
      !> PETSc; the matrix
      type(petsc_library), intent(in) :: petsc
      type(c_ptr), intent(in) :: matrix
      !> Whether multigrid preconditions, not factors; room beyond the estimate that those take, %
      logical, intent(in) :: is_multigrid
      integer(c_int), intent(in) :: room
      !> Result
      type(c_ptr), intent(inout) :: krylov
      type(c_ptr), intent(out) :: preconditioner
      !> PETSc's error code
      integer(c_int), intent(out) :: code

      code = 0
      if (c_associated(krylov)) code = petsc%ksp_destroy(krylov)
      if (code == 0) code = petsc%ksp_create(petsc%world, krylov)
      if (code == 0) code = petsc%ksp_set_operators(krylov, matrix, matrix)
      if (code == 0) code = petsc%ksp_set_type(krylov, 'gmres'//c_null_char)
      if (code == 0) code = petsc%ksp_gmres_set_restart(krylov, most_vectors)
      if (code == 0) code = petsc%ksp_set_pc_side(krylov, pc_right)
      if (code == 0) code = petsc%ksp_get_pc(krylov, preconditioner)
      if (code == 0) code = petsc%pc_set_error_if_failure(preconditioner, petsc_false)
      if (code /= 0) return
      if (is_multigrid) then
         code = set_multigrid(petsc, preconditioner)
      else
         code = set_factors(petsc, preconditioner, room)
      end if
   end subroutine new_krylov

   !> Factors of the whole matrix.
   integer(c_int) function set_factors(petsc, preconditioner, room) result(code)
      type(petsc_library), intent(in) :: petsc
      type(c_ptr), intent(in) :: preconditioner
      integer(c_int), intent(in) :: room
      type(c_ptr) :: factors
      integer :: i

      code = petsc%pc_set_type(preconditioner, 'lu'//c_null_char)
      if (code == 0) code = petsc%pc_factor_set_solver(preconditioner, 'mumps'//c_null_char)
      if (code == 0) code = petsc%pc_factor_set_up_solver(preconditioner)
      if (code == 0) code = petsc%pc_factor_get_matrix(preconditioner, factors)
      do i = 1, size(mumps_places)
         if (code == 0) code = petsc%set_icntl(factors, mumps_places(i), mumps_values(i))
      end do
      if (code == 0) code = petsc%set_icntl(factors, room_place, room)
      if (code == 0) code = petsc%set_cntl(factors, 1_c_int, pivot_threshold)
   end function set_factors

   !> One cycle of multigrid by smoothed aggregation.
   integer(c_int) function set_multigrid(petsc, preconditioner) result(code)
      type(petsc_library), intent(in) :: petsc
      type(c_ptr), intent(in) :: preconditioner
      character(len=len(choices)) :: values(size(options))
      integer :: i

      values = [choices, merge(alone, several, petsc%ranks%size == 1)]
      code = petsc%pc_set_type(preconditioner, 'gamg'//c_null_char)
      if (code == 0) code = petsc%pc_set_prefix(preconditioner, prefix//c_null_char)
      do i = 1, size(options)
         if (code == 0) code = petsc%set_option(c_null_ptr, &
            '-'//prefix//trim(options(i))//c_null_char, trim(values(i))//c_null_char)
      end do
   end function set_multigrid

end module asperity_solid_engine_krylov
