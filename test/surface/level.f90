!> Levelling and removal of form: what is added comes out again, what is left is orthogonal to it.
!> Cholesky's method, by which the form is fitted, on Hilbert's matrices 1/(i + j - 1), whose
!> condition numbers are known.
module test_surface_level
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_cholesky, only: factorize, reciprocal_condition, solve
   use asperity_surface_prepare_level, only: highest_degree, level_plane, remove_form
   use extremes, only: largest_of, worsen
   use funit, only: assertEqual, assertFalse, assertGreaterThan, assertLessThan, assertTrue, &
      TestMethod, TestSuite
   use map_cases, only: flat_map, kept_map, punch_holes, random_map
   use measurements, only: record
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_level

   integer(int64), parameter :: seed = 20250601_int64
   !> Condition numbers of Hilbert's matrices of order 2 to 6 in the norm of column sums (Todd 1954)
   real(wp), parameter :: conditions(2:6) = &
      [27.0_wp, 748.0_wp, 28375.0_wp, 943656.0_wp, 29070279.0_wp]

contains

   function suite_surface_level() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_level')
      call suite%addTest(TestMethod('a plane with an offset comes out again', test_plane))
      call suite%addTest(TestMethod('what is left is orthogonal to the plane', test_orthogonal))
      call suite%addTest(TestMethod('points on one line lose their mean', test_line))
      call suite%addTest(TestMethod('forms of every degree come out again', test_forms))
      call suite%addTest(TestMethod('a form of lower degree leaves the rest', test_lower))
      call suite%addTest(TestMethod('refused degrees and maps', test_refused))
      call suite%addTest(TestMethod('condition numbers and solutions of Hilbert''s matrices', &
         test_hilbert))
      call suite%addTest(TestMethod('what is not positive definite is refused', test_indefinite))
   end function suite_surface_level

   !> An offset of 1e3 rounds heights to 1e-13; twice as much or so may be left after the fit.
   subroutine test_plane()
      type(random_stream) :: stream
      type(height_map) :: map, bare
      integer :: i, j

      stream = random_stream(seed)
      call random_map(bare, stream, 37, 23, 0.1_wp, 0.25_wp)
      call punch_holes(bare, stream, 0.2_wp)
      map = bare
      do j = 1, 23
         do i = 1, 37
            if (map%heights(i, j) < none) map%heights(i, j) = map%heights(i, j) &
               + 1000.0_wp + 0.3_wp*i - 0.7_wp*j
         end do
      end do
      call level_plane(map)
      call level_plane(bare)
      call assertLessThan(largest_of(map%heights - bare%heights), 5.0e-13_wp)
      call assertTrue(all(map%heights >= none .eqv. bare%heights >= none), &
         message='missing points stay')
   end subroutine test_plane

   subroutine test_orthogonal()
      type(random_stream) :: stream
      type(height_map) :: map
      real(wp) :: sums(3)
      integer :: i, j

      stream = random_stream(seed + 1)
      call random_map(map, stream, 41, 17, 1.0_wp, 1.0_wp)
      call punch_holes(map, stream, 0.5_wp)
      call level_plane(map)
      sums = 0.0_wp
      do j = 1, 17
         do i = 1, 41
            if (map%heights(i, j) < none) &
               sums = sums + map%heights(i, j)*[1.0_wp, real(i, wp)/41.0_wp, real(j, wp)/17.0_wp]
         end do
      end do
      ! some 350 heights of magnitude one, each rounded to 1e-16
      call assertLessThan(largest_of(sums), 1.0e-12_wp)
   end subroutine test_orthogonal

   subroutine test_line()
      type(height_map) :: map
      integer :: i

      call flat_map(map, 9, 7, 1.0_wp, 1.0_wp)
      map%heights = none
      map%heights(:, 4) = [(real(i, wp), i=1, 9)]
      call level_plane(map)
      call assertLessThan(largest_of(map%heights(:, 4) - [(real(i - 5, wp), i=1, 9)]), 1.0e-14_wp)
      call assertEqual(54, count(map%heights >= none))
   end subroutine test_line

   !> Polynomials of magnitude up to some hundred: what is left is their rounding, 1e-13, times
   !> what extrapolation into the corners that the holes cut off costs.
   subroutine test_forms()
      type(random_stream) :: stream
      type(height_map) :: map, bare
      type(error_type), allocatable :: error
      real(wp) :: worst
      integer :: degree

      stream = random_stream(seed + 2)
      worst = 0.0_wp
      do degree = 1, highest_degree
         call random_map(bare, stream, 31, 40, 0.01_wp, 0.02_wp)
         call punch_holes(bare, stream, 0.15_wp)
         bare%heights(:9, :12) = none
         map = bare
         call add_polynomial(map, stream, degree)
         call remove_form(map, degree, error)
         call assertFalse(allocated(error))
         call remove_form(bare, degree, error)
         call assertFalse(allocated(error))
         call worsen(worst, largest_of(map%heights - bare%heights))
         call assertTrue(all(map%heights >= none .eqv. bare%heights >= none))
      end do
      call record('surface.form.of_100', worst)
      call assertLessThan(worst, 1.0e-11_wp)
   end subroutine test_forms

   !> Add a random polynomial, its terms up to 10 each.
   subroutine add_polynomial(map, stream, degree)
      type(height_map), intent(inout) :: map
      type(random_stream), intent(inout) :: stream
      integer, intent(in) :: degree
      real(wp) :: factor
      integer :: a, b, i, j

      do b = 0, degree
         do a = 0, degree - b
            factor = stream%uniform(-10.0_wp, 10.0_wp)
            do j = 1, size(map%heights, 2)
               do i = 1, size(map%heights, 1)
                  if (map%heights(i, j) >= none) cycle
                  map%heights(i, j) = map%heights(i, j) + factor &
                     *(2.0_wp*i/size(map%heights, 1) - 1.0_wp)**a &
                     *(2.0_wp*j/size(map%heights, 2) - 1.0_wp)**b
               end do
            end do
         end do
      end do
   end subroutine add_polynomial

   !> x^3 less its fit of degree 2 is x^3 - c x with c = sum x^4/sum x^2, x about the middle.
   subroutine test_lower()
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp) :: x(11), expected(11)
      integer :: i, j

      call flat_map(map, 11, 6, 1.0_wp, 1.0_wp)
      x = [(real(i - 6, wp), i=1, 11)]
      do j = 1, 6
         map%heights(:, j) = x**3
      end do
      expected = x**3 - x*sum(x**4)/sum(x**2)
      call remove_form(map, 2, error)
      call assertFalse(allocated(error))
      do j = 1, 6
         call assertLessThan(largest_of(map%heights(:, j) - expected), 1.0e-11_wp)
      end do
      call assertGreaterThan(largest_of(map%heights), 10.0_wp)
   end subroutine test_lower

   subroutine test_refused()
      type(random_stream) :: stream
      type(height_map) :: map
      type(error_type), allocatable :: error
      real(wp), allocatable :: kept(:, :)

      stream = random_stream(seed + 3)
      call random_map(map, stream, 12, 8, 1.0_wp, 1.0_wp)
      allocate (kept, source=map%heights)
      call remove_form(map, 0, error)
      call check('a form of degree 0 is not allowed: from 1 to 8')
      call remove_form(map, highest_degree + 1, error)
      call check('a form of degree 9 is not allowed: from 1 to 8')
      ! eight rows are one too few for the ninth power
      call remove_form(map, 8, error)
      call check('test map: the measured points do not determine a form of degree 8')
      map%heights(4:, :) = none
      kept = map%heights
      call remove_form(map, 3, error)
      call check('test map: the measured points do not determine a form of degree 3')
      call remove_form(map, 2, error)
      call assertFalse(allocated(error), message='three columns determine degree 2')
      map%heights = none
      kept = map%heights
      call remove_form(map, 1, error)
      call check('test map: the measured points do not determine a form of degree 1')
      call level_plane(map)
      call assertTrue(kept_map(map, kept), message='nothing to level')

   contains

      subroutine check(expected)
         character(len=*), intent(in) :: expected

         call assertTrue(allocated(error), message=expected)
         if (allocated(error)) call assertEqual(expected, error%message)
         call assertTrue(kept_map(map, kept), message='changed: '//expected// &
            to_text(size(map%heights)))
      end subroutine check

   end subroutine test_refused

   !> x = 1, 2, ... comes back from its right-hand side, to the condition number in roundings.
   subroutine test_hilbert()
      real(wp), allocatable :: matrix(:, :), x(:), right(:)
      real(wp) :: norm
      logical :: is_definite
      integer :: n, i, j

      do n = lbound(conditions, 1), ubound(conditions, 1)
         allocate (matrix(n, n), x(n), right(n))
         matrix(:, :) = reshape([((1.0_wp/real(i + j - 1, wp), i=1, n), j=1, n)], [n, n])
         x(:) = [(real(i, wp), i=1, n)]
         right(:) = matmul(matrix, x)
         norm = maxval(sum(abs(matrix), 1))
         do j = 2, n
            matrix(:j - 1, j) = huge(1.0_wp)
         end do
         call factorize(matrix, is_definite)
         call assertTrue(is_definite)
         associate (roundings => epsilon(1.0_wp)*conditions(n))
            call assertLessThan(abs(reciprocal_condition(matrix, norm)*conditions(n) - 1.0_wp), &
               10.0_wp*roundings, 'condition')
            call solve(matrix, right)
            call assertTrue(all(abs(right - x) < 10.0_wp*n*roundings), 'solution')
         end associate
         deallocate (matrix, x, right)
      end do
   end subroutine test_hilbert

   subroutine test_indefinite()
      real(wp) :: matrix(2, 2)
      logical :: is_definite

      matrix = reshape([1.0_wp, 2.0_wp, 2.0_wp, 4.0_wp], [2, 2])
      call factorize(matrix, is_definite)
      call assertFalse(is_definite, 'singular')
      matrix = reshape([1.0_wp, 2.0_wp, 2.0_wp, 3.0_wp], [2, 2])
      call factorize(matrix, is_definite)
      call assertFalse(is_definite, 'indefinite')
   end subroutine test_indefinite

end module test_surface_level
