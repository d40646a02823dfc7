!> The sparse matrix in PETSc.
module asperity_solid_engine_matrix
   use, intrinsic :: iso_c_binding, only: c_int, c_null_char, c_ptr, c_ptrdiff_t
   use asperity_base_kinds, only: wp
   use asperity_solid_engine_petsc, only: petsc_false, petsc_library
   implicit none
   private
   public :: new_matrix, set_modes

contains

   !> An empty matrix with the union of the patterns of all ranks.
   subroutine new_matrix(petsc, n_own, row_start, columns, matrix, code)
      !> PETSc
      type(petsc_library), intent(in) :: petsc
      !> How many rows this rank has
      integer, intent(in) :: n_own
      !> Where each row of all begins, from 0, and one more; columns, from 0, rising in each row
      integer(c_int), intent(in) :: row_start(:), columns(:)
      !> Result
      type(c_ptr), intent(out) :: matrix
      !> PETSc's error code
      integer(c_int), intent(out) :: code
      integer(c_int), allocatable :: rows(:), columns_too(:)
      integer :: i, n

      n = size(row_start) - 1
      allocate (rows(size(columns)))
      ! PETSc may change both lists
      allocate (columns_too, source=columns)
      do i = 1, n
         rows(row_start(i) + 1:row_start(i + 1)) = i - 1
      end do
      code = petsc%mat_create(petsc%world, matrix)
      if (code == 0) code = petsc%mat_set_sizes(matrix, n_own, n_own, n, n)
      if (code == 0) code = petsc%mat_set_type(matrix, 'aij'//c_null_char)
      if (code == 0) code = petsc%mat_set_places(matrix, size(rows, kind=c_ptrdiff_t), rows, &
         columns_too)
   end subroutine new_matrix

   !> Tell multigrid what its coarse levels must be able to follow. Returns PETSc's error code.
   integer(c_int) function set_modes(petsc, matrix, modes) result(code)
      !> PETSc; the matrix
      type(petsc_library), intent(in) :: petsc
      type(c_ptr), intent(in) :: matrix
      !> This rank's part of vectors at right angles, a column each, which must stay where they are
      real(wp), intent(in), target, contiguous :: modes(:, :)
      type(c_ptr) :: vectors(size(modes, 2)), product, space
      integer :: i

      code = 0
      do i = 1, size(vectors)
         if (code == 0) code = petsc%mat_create_vectors(matrix, vectors(i), product)
         if (code == 0) code = petsc%vec_destroy(product)
         if (code == 0) code = petsc%vec_place_array(vectors(i), modes(:, i))
      end do
      if (code == 0) code = petsc%create_space(petsc%world, petsc_false, &
         size(vectors, kind=c_int), vectors, space)
      if (code == 0) code = petsc%mat_set_near_null_space(matrix, space)
      if (code == 0) code = petsc%destroy_space(space)
      do i = 1, size(vectors)
         if (code == 0) code = petsc%vec_destroy(vectors(i))
      end do
   end function set_modes

end module asperity_solid_engine_matrix
