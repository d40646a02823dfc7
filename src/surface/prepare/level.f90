!> Taking the mean plane or a polynomial form out of a map by least squares; out of a profile, which
!> is a map of one line, the mean line or a polynomial of x.
module asperity_surface_prepare_level
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_cholesky, only: factorize, reciprocal_condition, solve
   implicit none
   private
   public :: level_plane, remove_form

   !> Highest total degree of a form
   integer, parameter, public :: highest_degree = 8
   !> Smallest reciprocal condition number of the normal equations, scaled to a diagonal of ones.
   !> The first fit errs by up to epsilon over this, relatively, and the second takes out the rest
   real(wp), parameter :: least_condition = 1.0e-10_wp

contains

   !> Subtract the least-squares plane of the measured points; where they lie on one line, which
   !> leaves the plane's tilt across it open, their mean.
   pure subroutine level_plane(map)
      !> The map
      type(height_map), intent(inout) :: map
      logical :: is_determined

      call subtract_fit(map, 1, is_determined)
      if (.not. is_determined) call subtract_fit(map, 0, is_determined)
   end subroutine level_plane

   !> Subtract the least-squares polynomial of the measured points.
   pure subroutine remove_form(map, degree, error)
      !> The map; unchanged after an error
      type(height_map), intent(inout) :: map
      !> Total degree in x and y, 1 to `highest_degree`
      integer, intent(in) :: degree
      !> Set when the degree is not allowed or the measured points do not determine the polynomial
      type(error_type), allocatable, intent(out) :: error
      logical :: is_determined

      if (degree < 1 .or. degree > highest_degree) then
         call fatal_error(error, 'a form of degree '//to_text(degree)//' is not allowed: from 1'// &
            ' to '//to_text(highest_degree), subject='form')
         return
      end if
      call subtract_fit(map, degree, is_determined)
      if (.not. is_determined) call fatal_error(error, map%source//': the measured points do '// &
         'not determine a form of degree '//to_text(degree))
   end subroutine remove_form

   !> Subtract the least-squares sum of products P_a(x) P_b(y), a + b <= degree, of Legendre
   !> polynomials with x and y from -1 to 1 over the map. On a full map of many points they are
   !> almost orthogonal, so that the normal equations are almost diagonal and as good as any
   !> other way; holes make them worse, which the condition number tells. Twice: the second time
   !> takes out what rounding left, of a large offset above all.
   pure subroutine subtract_fit(map, degree, is_determined)
      type(height_map), intent(inout) :: map
      integer, intent(in) :: degree
      !> Whether the measured points determine the fit; the map is kept otherwise
      logical, intent(out) :: is_determined
      real(wp), allocatable :: px(:, :), py(:, :), normal(:, :), right(:), scales(:)
      integer, allocatable :: a(:), b(:)
      integer :: terms, i, j, pass
      real(wp) :: norm

      terms = (degree + 1)*(degree + 2)/2
      if (size(map%heights, 2) == 1) terms = degree + 1
      allocate (a(terms), b(terms), normal(terms, terms), right(terms), scales(terms), &
         px(size(map%heights, 1), 0:degree), py(size(map%heights, 2), 0:degree))
      if (size(map%heights, 2) == 1) then
         a(:) = [(i, i=0, degree)]
         b(:) = 0
      else
         a(:) = [((i, i=0, degree - j), j=0, degree)]
         b(:) = [((j, i=0, degree - j), j=0, degree)]
      end if
      call legendre(px)
      call legendre(py)
      do pass = 1, 2
         call sum_products(map%heights, px, py, a, b, normal, right, only_right=pass == 2)
         if (pass == 1) then
            scales(:) = [(normal(i, i), i=1, terms)]
            is_determined = all(scales > 0.0_wp)
            if (.not. is_determined) return
            scales(:) = 1.0_wp/sqrt(scales)
            do i = 1, terms
               normal(:, i) = normal(:, i)*scales*scales(i)
            end do
            norm = maxval(sum(abs(normal), 1))
            call factorize(normal, is_determined)
            if (is_determined) &
               is_determined = reciprocal_condition(normal, norm) >= least_condition
            if (.not. is_determined) return
         end if
         right(:) = right*scales
         call solve(normal, right)
         call subtract(map%heights, px, py, a, b, right*scales)
      end do
   end subroutine subtract_fit

   !> Sums over the measured points of the products of two terms, lower half, and of a term and
   !> the height.
   pure subroutine sum_products(z, px, py, a, b, normal, right, only_right)
      real(wp), intent(in), contiguous :: z(:, :)
      !> Polynomials by point and degree from 0
      real(wp), intent(in) :: px(:, 0:), py(:, 0:)
      !> Degrees of the terms
      integer, intent(in) :: a(:), b(:)
      real(wp), intent(inout) :: normal(:, :), right(:)
      !> Whether `normal` stays as it is
      logical, intent(in) :: only_right
      !> Sums over a row: of heights by polynomial, and of products of two, of a full one as well
      real(wp) :: row_right(0:ubound(px, 2)), row_normal(0:ubound(px, 2), 0:ubound(px, 2)), &
         full_normal(0:ubound(px, 2), 0:ubound(px, 2))
      real(wp), allocatable :: height(:), weight(:), weighted(:)
      integer :: i, j, k, l
      logical :: has_holes

      allocate (height(size(z, 1)), weight(size(z, 1)), weighted(size(z, 1)))
      if (.not. only_right) then
         normal = 0.0_wp
         weight = 1.0_wp
         call sum_pairs(px, weight, weighted, full_normal)
      end if
      right = 0.0_wp
      do j = 1, size(z, 2)
         has_holes = .false.
         do i = 1, size(z, 1)
            if (z(i, j) >= none) has_holes = .true.
         end do
         height(:) = z(:, j)
         if (has_holes) where (height >= none) height = 0.0_wp
         do k = 0, ubound(px, 2)
            row_right(k) = dot_product(height, px(:, k))
         end do
         do k = 1, size(right)
            right(k) = right(k) + row_right(a(k))*py(j, b(k))
         end do
         if (only_right) cycle
         row_normal = full_normal
         if (has_holes) then
            weight = merge(0.0_wp, 1.0_wp, z(:, j) >= none)
            call sum_pairs(px, weight, weighted, row_normal)
         end if
         do l = 1, size(right)
            do k = l, size(right)
               normal(k, l) = normal(k, l) + row_normal(a(k), a(l))*py(j, b(k))*py(j, b(l))
            end do
         end do
      end do
      do l = 2, size(right)
         normal(:l - 1, l) = normal(l, :l - 1)
      end do
   end subroutine sum_products

   !> Sums over a row of the products of two polynomials by weight.
   pure subroutine sum_pairs(px, weight, weighted, sums)
      real(wp), intent(in) :: px(:, 0:), weight(:)
      !> To work in
      real(wp), intent(inout) :: weighted(:)
      real(wp), intent(out) :: sums(0:, 0:)
      integer :: m, n

      do n = 0, ubound(px, 2)
         weighted = weight*px(:, n)
         do m = 0, n
            sums(m, n) = dot_product(weighted, px(:, m))
            sums(n, m) = sums(m, n)
         end do
      end do
   end subroutine sum_pairs

   !> Subtract the sum of terms from the measured points.
   pure subroutine subtract(z, px, py, a, b, factors)
      real(wp), intent(inout), contiguous :: z(:, :)
      real(wp), intent(in) :: px(:, 0:), py(:, 0:)
      integer, intent(in) :: a(:), b(:)
      !> Factor of each term
      real(wp), intent(in) :: factors(:)
      real(wp), allocatable :: form(:)
      real(wp) :: row_factor
      integer :: i, j, k, l

      allocate (form(size(z, 1)))
      do j = 1, size(z, 2)
         form = 0.0_wp
         do k = 0, ubound(px, 2)
            row_factor = 0.0_wp
            do l = 1, size(factors)
               if (a(l) == k) row_factor = row_factor + factors(l)*py(j, b(l))
            end do
            form = form + row_factor*px(:, k)
         end do
         do i = 1, size(z, 1)
            if (z(i, j) < none) z(i, j) = z(i, j) - form(i)
         end do
      end do
   end subroutine subtract

   !> Legendre polynomials at equidistant points from -1 to 1, by point and degree.
   pure subroutine legendre(p)
      real(wp), intent(out) :: p(:, 0:)
      real(wp) :: x
      integer :: i, n

      do i = 1, size(p, 1)
         x = real(2*i - size(p, 1) - 1, wp)/real(max(size(p, 1) - 1, 1), wp)
         p(i, 0) = 1.0_wp
         if (ubound(p, 2) > 0) p(i, 1) = x
         do n = 1, ubound(p, 2) - 1
            p(i, n + 1) = (real(2*n + 1, wp)*x*p(i, n) - real(n, wp)*p(i, n - 1))/real(n + 1, wp)
         end do
      end do
   end subroutine legendre

end module asperity_surface_prepare_level
