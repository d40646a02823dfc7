!> Interface of GSL's singular value decomposition (gsl_linalg.h).
module asperity_fit_gsl_linear
   use, intrinsic :: iso_c_binding, only: c_int, c_loc, c_null_ptr, c_size_t
   use asperity_base_kinds, only: wp
   use asperity_fit_gsl_multifit, only: gsl_matrix, gsl_success, gsl_vector
   implicit none
   private
   public :: decompose, view_of_matrix, view_of_vector

   interface
      integer(c_int) function c_sv_decomp_jacobi(a, v, s) &
         bind(c, name='gsl_linalg_SV_decomp_jacobi')
         import :: c_int, gsl_matrix, gsl_vector
         type(gsl_matrix), intent(inout) :: a, v
         type(gsl_vector), intent(inout) :: s
      end function c_sv_decomp_jacobi
   end interface

contains

   !> Singular values of a matrix with at least as many rows as columns, given by its transpose.
   subroutine decompose(transposed, values, right, fine)
      !> Columns of it are rows of the matrix; those of U on return
      real(wp), intent(inout), target, contiguous :: transposed(:, :)
      !> Singular values, largest first
      real(wp), intent(out), target, contiguous :: values(:)
      !> Column j is the direction of value j
      real(wp), intent(out), target, contiguous :: right(:, :)
      !> Whether it succeeded
      logical, intent(out) :: fine
      type(gsl_matrix) :: a, v
      type(gsl_vector) :: s

      a = view_of_matrix(transposed)
      v = view_of_matrix(right)
      s = view_of_vector(values)
      fine = c_sv_decomp_jacobi(a, v, s) == gsl_success
      ! rows of GSL are columns here
      right = transpose(right)
   end subroutine decompose

   !> GSL's view of an array as a matrix, whose rows are the array's columns.
   function view_of_matrix(array) result(view)
      !> The array
      real(wp), intent(in), target, contiguous :: array(:, :)
      type(gsl_matrix) :: view

      view = gsl_matrix(size(array, 2, c_size_t), size(array, 1, c_size_t), &
         size(array, 1, c_size_t), c_loc(array), c_null_ptr, 0_c_int)
   end function view_of_matrix

   !> GSL's view of an array as a vector.
   function view_of_vector(array) result(view)
      !> The array
      real(wp), intent(in), target, contiguous :: array(:)
      type(gsl_vector) :: view

      view = gsl_vector(size(array, kind=c_size_t), 1_c_size_t, c_loc(array), c_null_ptr, 0_c_int)
   end function view_of_vector

end module asperity_fit_gsl_linear
