!> What is fitted: a model beside a record.
module asperity_fit_problem
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: all_below
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: fit_problem, sum_of_squares

   !> Residuals of this size or larger, or no numbers, are as good as refused
   real(wp), parameter, public :: refused_residual = 1.0e30_wp
   !> Residuals of this size are rounding
   real(wp), parameter, public :: rounding = 1.0e-9_wp

   !> A model, and a record that it should give. Its procedures may be called by several threads.
   type, abstract :: fit_problem
   contains
      !> Residuals of one set of values
      procedure(find_residuals), deferred :: residuals
      !> Residuals of several sets
      procedure :: several_residuals
   end type fit_problem

   abstract interface
      !> Residuals, model minus record over a scale: without units, of the size 1 where the model is
      !> wrong by as much as the record is uncertain or large.
      recursive subroutine find_residuals(self, values, residuals, error)
         import :: error_type, fit_problem, wp
         !> The problem
         class(fit_problem), intent(in) :: self
         !> Values of the free parameters, in their units
         real(wp), intent(in) :: values(:)
         !> One for each number of the record
         real(wp), intent(out) :: residuals(:)
         !> Set when the model cannot be evaluated there
         type(error_type), allocatable, intent(out) :: error
      end subroutine find_residuals
   end interface

contains

   !> Sum of squared residuals; huge where one of them is as good as refused.
   pure real(wp) function sum_of_squares(residuals)
      !> The residuals
      real(wp), intent(in), contiguous :: residuals(:)

      sum_of_squares = huge(1.0_wp)
      if (all_below(residuals, refused_residual)) sum_of_squares = sum(residuals**2)
   end function sum_of_squares

   !> Residuals of several sets of values, one after the other; where they are dear, a problem has a
   !> procedure of its own that shares them among threads.
   recursive subroutine several_residuals(self, values, residuals, failed)
      !> The problem
      class(fit_problem), intent(in) :: self
      !> A column for each set
      real(wp), intent(in) :: values(:, :)
      !> A column for each set
      real(wp), intent(out) :: residuals(:, :)
      !> Whether a set could not be evaluated
      logical, intent(out) :: failed(:)
      type(error_type), allocatable :: error
      integer :: i

      do i = 1, size(values, 2)
         call self%residuals(values(:, i), residuals(:, i), error)
         failed(i) = allocated(error)
      end do
   end subroutine several_residuals

end module asperity_fit_problem
