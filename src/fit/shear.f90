!> Friction from shear tests: a problem for `fit_least_squares`.
module asperity_fit_shear
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_shear_model, only: check_shear_tests, shear_names, shear_shear_compliance, &
      shear_stress_along, shear_test
   implicit none
   private
   public :: shear_problem, new_shear_problem

   !> Shear tests beside the model. Residuals are differences of shear stress over a scale.
   type, extends(fit_problem) :: shear_problem
      !> The tests
      type(shear_test), allocatable :: tests(:)
      !> Numbers of the model, in the order of `shear_names`, and which of them are free
      real(wp) :: values(size(shear_names)) = 0.0_wp
      integer, allocatable :: free(:)
      !> What the differences are divided by, MPa, one for each sample of all tests
      real(wp), allocatable :: scale(:)
   contains
      procedure :: residuals => find_residuals
   end type shear_problem

contains

   !> A problem of checked tests.
   pure subroutine new_shear_problem(problem, tests, values, free, scale, error)
      !> The problem
      type(shear_problem), intent(out) :: problem
      !> The tests
      type(shear_test), intent(in) :: tests(:)
      !> Numbers of the model, of no matter where they are free
      real(wp), intent(in) :: values(:)
      !> Those that are free, in the order of the parameters
      integer, intent(in) :: free(:)
      !> What differences are divided by, MPa, one for each sample of all tests
      real(wp), intent(in) :: scale(:)
      !> Set when the tests cannot be followed
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      call check_shear_tests(tests, error)
      if (allocated(error)) return
      problem%tests = tests
      problem%values = values
      problem%free = free
      problem%scale = scale
      if (.not. (any(free == shear_shear_compliance) .or. &
         values(shear_shear_compliance) > 0.0_wp)) return
      do i = 1, size(tests)
         if (allocated(tests(i)%area)) cycle
         call fatal_error(error, 'shear test '//to_text(i)//' has no area of its faces, which '// &
            'shear_compliance needs', subject='shear_compliance')
         return
      end do
   end subroutine new_shear_problem

   !> Model less record, over the scale.
   recursive subroutine find_residuals(self, values, residuals, error)
      !> The problem
      class(shear_problem), intent(in) :: self
      !> Values of the free numbers
      real(wp), intent(in) :: values(:)
      !> One for each sample, test after test
      real(wp), intent(out) :: residuals(:)
      !> Set when a number is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: all_values(size(shear_names))
      integer :: i, first, last

      all_values = self%values
      all_values(self%free) = values
      last = 0
      do i = 1, size(self%tests)
         first = last + 1
         last = last + size(self%tests(i)%displacement)
         call shear_stress_along(all_values, self%tests(i), residuals(first:last), error)
         if (allocated(error)) return
         residuals(first:last) = (residuals(first:last) - self%tests(i)%shear_stress) &
            /self%scale(first:last)
      end do
   end subroutine find_residuals

end module asperity_fit_shear
