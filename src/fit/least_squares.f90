!> Nonlinear least squares with bounded parameters: searches by GSL from the start and from the best
!> of many sets of values, and checks of our own of what it calls a success.
!>
!> GSL 2.7.1 takes a point that is no number for converged. So its word is not taken: the end is the
!> lowest finite sum seen at the beginning or end of a search, and is an end if no step of Gauss and
!> Newton leads away from it.
module asperity_fit_least_squares
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_parameter, only: check_parameters, fit_parameter, value_of, y_of
   use asperity_fit_problem, only: fit_problem, rounding, sum_of_squares
   use asperity_fit_search, only: search_type
   use asperity_fit_sensitivities, only: describe_minimum
   use asperity_fit_spread_sets, only: spread_set
   use asperity_fit_types, only: fit_result, fit_settings
   implicit none
   private
   public :: fit_least_squares

   !> Searches whose sums of squares differ by less than this share came to the same minimum
   real(wp), parameter :: same_minimum = 1.0e-6_wp

contains

   !> Find the values of least squared residuals. A result may still have parameters at a bound, or
   !> directions that the record does not settle: the caller says what that means.
   subroutine fit_least_squares(problem, n_residuals, parameters, settings, result, error)
      !> Model and record
      class(fit_problem), intent(in), target :: problem
      !> Number of residuals
      integer, intent(in) :: n_residuals
      !> Free parameters, in the order of the problem
      type(fit_parameter), intent(in) :: parameters(:)
      !> How it is sought
      type(fit_settings), intent(in) :: settings
      !> What was found
      type(fit_result), intent(out) :: result
      !> Set when the input is refused, the model fails wherever a search begins, or no minimum is
      !> found
      type(error_type), allocatable, intent(out) :: error
      type(search_type) :: search
      real(wp), allocatable :: starts(:, :), y(:)

      call check_parameters(parameters, error)
      if (allocated(error)) return
      if (n_residuals <= size(parameters)) then
         call fatal_error(error, to_text(n_residuals)//' numbers of the record cannot settle '// &
            to_text(size(parameters))//' free parameters: free fewer, or give more')
         return
      end if
      search%problem => problem
      allocate (search%parameters, source=parameters)
      search%n_residuals = n_residuals
      search%step = settings%difference_step
      search%max_iterations = settings%max_iterations
      allocate (y(size(parameters)))
      allocate (result%values(size(parameters)), source=0.0_wp)
      allocate (result%residuals(n_residuals), source=0.0_wp)
      call find_starts(search, settings, starts, result, error)
      if (allocated(error)) return
      call search_from(search, starts, y, result)
      result%iterations = search%iterations
      result%evaluations = result%evaluations + search%evaluations
      call describe_minimum(problem, parameters, settings, y, result, error)
   end subroutine fit_least_squares

   !> Where searches begin: at the start, and at the best of the sets that are spread.
   subroutine find_starts(search, settings, starts, result, error)
      type(search_type), intent(in) :: search
      type(fit_settings), intent(in) :: settings
      !> y, a column a search
      real(wp), allocatable, intent(out) :: starts(:, :)
      type(fit_result), intent(inout) :: result
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: refusal
      real(wp), allocatable :: sets(:, :), residuals(:, :), sums(:)
      logical, allocatable :: failed(:)
      integer :: best, i, n

      associate (p => search%parameters)
         n = 1 + (settings%searches - 1)*settings%spread_sets
         allocate (sets(size(p), n), residuals(search%n_residuals, n), failed(n), sums(n))
         sets(:, 1) = y_of(p, p%start)
         do i = 2, n
            sets(:, i) = spread_set(p, i - 1)
         end do
         call search%problem%residuals(value_of(p, sets(:, 1)), residuals(:, 1), refusal)
         failed(1) = allocated(refusal)
         if (n > 1) call search%problem%several_residuals(reshape([(value_of(p, sets(:, i)), &
            i=2, n)], [size(p), n - 1]), residuals(:, 2:), failed(2:))
         do i = 1, n
            sums(i) = huge(1.0_wp)
            if (.not. failed(i)) sums(i) = sum_of_squares(residuals(:, i))
         end do
         result%evaluations = n
         result%start_chi_squared = sums(1)
         allocate (starts(size(p), 0))
         do i = 1, settings%searches
            best = 1
            if (i > 1) best = minloc(sums, 1)
            if (sums(best) < huge(1.0_wp)) starts = reshape([starts, sets(:, best)], &
               [size(p), size(starts, 2) + 1])
            sums(best) = huge(1.0_wp)
         end do
      end associate
      if (size(starts, 2) > 0) return
      if (allocated(refusal)) then
         call move_alloc(refusal, error)
      else
         call fatal_error(error, 'the model gives no finite numbers at the start', &
            computation_error)
      end if
   end subroutine find_starts

   !> Search from each start, and keep the lowest end. A search that ends no lower than it began
   !> ends where it began.
   subroutine search_from(search, starts, y, result)
      type(search_type), intent(inout) :: search
      real(wp), intent(in) :: starts(:, :)
      !> The lowest end
      real(wp), intent(out) :: y(:)
      type(fit_result), intent(inout) :: result
      real(wp) :: sums(size(starts, 2)), begin(size(starts, 1)), end(size(starts, 1))
      real(wp) :: residuals(search%n_residuals)
      integer :: i

      y = starts(:, 1)
      result%chi_squared = huge(1.0_wp)
      do i = 1, size(sums)
         begin = starts(:, i)
         call take(begin)
         sums(i) = sum_of_squares(residuals)
         end = begin
         call search%run(end)
         call take(end)
         sums(i) = min(sums(i), sum_of_squares(residuals))
      end do
      result%searches = size(sums)
      result%agreeing = count(sums <= result%chi_squared*(1.0_wp + same_minimum) &
         + search%n_residuals*rounding**2)

   contains

      !> Evaluate a set, and keep it if it is the lowest.
      subroutine take(set)
         real(wp), intent(in) :: set(:)
         type(error_type), allocatable :: error

         call search%problem%residuals(value_of(search%parameters, set), residuals, error)
         search%evaluations = search%evaluations + 1
         if (allocated(error)) residuals = huge(1.0_wp)
         if (.not. sum_of_squares(residuals) < result%chi_squared) return
         y = set
         result%values(:) = value_of(search%parameters, set)
         result%residuals(:) = residuals
         result%chi_squared = sum_of_squares(residuals)
      end subroutine take
   end subroutine search_from

end module asperity_fit_least_squares
