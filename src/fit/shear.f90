!> Friction from shear tests: a problem for `fit_least_squares`.
module asperity_fit_shear
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_problem, only: fit_problem
   use asperity_fit_shear_model, only: check_shear_tests, shear_critical_slip, shear_names, &
      shear_shear_compliance, shear_static_friction_coefficient, shear_stress_along, shear_test
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

   !> Normal stresses count as one up to this ratio
   real(wp), parameter :: most_equal = 1.01_wp

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

      call check_shear_tests(tests, error)
      if (allocated(error)) return
      problem%tests = tests
      problem%values = values
      problem%free = free
      problem%scale = scale
      if (any(free == shear_shear_compliance) .or. values(shear_shear_compliance) > 0.0_wp) &
         call check_areas(tests, error)
      if (.not. allocated(error)) call check_told_apart(problem, error)
   end subroutine new_shear_problem

   !> Set `error` unless all tests have the area that a compliance needs.
   pure subroutine check_areas(tests, error)
      type(shear_test), intent(in) :: tests(:)
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(tests)
         if (allocated(tests(i)%area)) cycle
         call fatal_error(error, 'shear test '//to_text(i)//' has no area of its faces, which '// &
            'shear_compliance needs', subject='shear_compliance')
         return
      end do
   end subroutine check_areas

   !> Set `error` when critical slip and compliance do the same: at one normal stress only
   !> critical_slip + shear_compliance times the largest force acts. Seen here, as the kinks of the
   !> model hide it from differences.
   pure subroutine check_told_apart(problem, error)
      type(shear_problem), intent(in) :: problem
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: lowest, highest
      integer :: i

      if (.not. (any(problem%free == shear_shear_compliance) &
         .and. any(problem%free == shear_critical_slip))) return
      if (any(problem%free == shear_static_friction_coefficient) &
         .or. problem%values(shear_static_friction_coefficient) > 0.0_wp) return
      associate (tests => problem%tests)
         lowest = minval([(minval(tests(i)%normal_stress), i=1, size(tests))])
         highest = maxval([(maxval(tests(i)%normal_stress), i=1, size(tests))])
      end associate
      if (highest <= most_equal*lowest) call fatal_error(error, 'critical_slip and '// &
         'shear_compliance cannot be told apart at one normal stress, '//to_text(lowest)// &
         ' MPa: fix one, or give tests at others', computation_error)
   end subroutine check_told_apart

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
