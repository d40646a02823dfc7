!> Compiles the normal law: values and slopes of the direct evaluation at four points of each
!> interval become the polynomials of `asperity_law_compiled_law`. All intervals, or those alone
!> that a range of separations needs.
module asperity_law_compile_law
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_compiled_intervals, only: first, first_of_johnson, intervals_below, last, &
      last_of_johnson, n_all, n_near, place_interval
   use asperity_law_compiled_law, only: compiled_law, evaluate_compiled_law
   use asperity_law_hermite_polynomial, only: degree, hermite_points, hermite_polynomial
   use asperity_law_johnson_heights, only: height_of, height_slope_at, normal_score
   use asperity_law_normal_law, only: evaluate_scaled_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_validity, only: closure_above_half_radius
   implicit none
   private
   public :: new_compiled_law, compiling_pays

   !> So many points an interval take as long directly as compiled: three samples of an interval,
   !> each a direct evaluation, and as much again for all else
   integer, parameter :: points_to_pay = 6

contains

   !> Compile the law. `error` is set when the properties were never built.
   pure subroutine new_compiled_law(law, properties, error, range)
      !> Result
      type(compiled_law), intent(out) :: law
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Set when the properties were never built
      type(error_type), allocatable, intent(out) :: error
      !> Least and largest separation, mm, to compile for; beyond them the law is evaluated
      !> directly. When absent, the whole range of polynomials
      real(wp), intent(in), optional :: range(2)
      real(wp), dimension(4, 3) :: values, slopes
      real(wp) :: middle, half_width
      integer :: i, j

      if (.not. properties%sigma > 0.0_wp) then
         call fatal_error(error, 'the properties of the normal law are not set: build them '// &
            'with new_normal_properties')
         return
      end if
      law%properties = properties
      law%inverse_sigma = 1.0_wp/properties%sigma
      law%columns = [1, n_all]
      if (present(range)) law%columns = columns_of(properties, range)
      law%last_near = merge(n_near, n_all, properties%heights%is_gaussian)
      do i = law%columns(1), law%columns(2)
         call place_interval(i, properties%heights%is_gaussian, middle, half_width)
         if (i == law%columns(1) .or. i == law%last_near + 1) then
            call sample(properties, middle - half_width, i > law%last_near, values(1, :), &
               slopes(1, :))
         else
            values(1, :) = values(4, :)
            slopes(1, :) = slopes(4, :)
         end if
         do j = 2, 4
            call sample(properties, middle + half_width*hermite_points(j), i > law%last_near, &
               values(j, :), slopes(j, :))
         end do
         law%pressure(:degree, i) = hermite_polynomial(values(:, 1), slopes(:, 1), half_width)
         law%pressure(degree + 1, i) = middle
         law%area_fraction(:, i) = hermite_polynomial(values(:, 2), slopes(:, 2), half_width)
         law%energy(:, i) = hermite_polynomial(values(:, 3), slopes(:, 3), half_width)
      end do
      call find_limits(law)
   end subroutine new_compiled_law

   !> Whether so many points are evaluated sooner when the law is compiled for their range first.
   pure logical function compiling_pays(points, properties, range)
      !> Number of points
      integer, intent(in) :: points
      !> Checked properties
      type(normal_properties), intent(in) :: properties
      !> Least and largest separation, mm
      real(wp), intent(in) :: range(2)
      integer :: columns(2)

      columns = columns_of(properties, range)
      compiling_pays = points > points_to_pay*max(columns(2) - columns(1) + 1, 1)
   end function compiling_pays

   !> First and last column that a range of separations needs, one at least.
   pure function columns_of(properties, range) result(columns)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: range(2)
      integer :: columns(2)
      real(wp) :: h(2)

      h = normal_score(properties%heights, range/properties%sigma)
      if (properties%heights%is_gaussian) then
         h = min(max(h, first), last)
      else
         h = min(max(h, first_of_johnson), last_of_johnson)
      end if
      columns = min(1 + int(intervals_below(h, properties%heights%is_gaussian)), n_all)
   end function columns_of

   !> Pressure, area fraction and energy, and their derivatives by h, d/sigma or the Gaussian number
   !> that belongs to it; over exp(-h^2/2) if `scaled`.
   pure subroutine sample(properties, h, scaled, values, slopes)
      type(normal_properties), intent(in) :: properties
      real(wp), intent(in) :: h
      logical, intent(in) :: scaled
      real(wp), intent(out) :: values(:), slopes(:)
      type(normal_response) :: r
      real(wp) :: area_stiffness, decay

      call evaluate_scaled_law(properties, height_of(properties%heights, h)*properties%sigma, r, &
         area_stiffness)
      values = [r%pressure, r%area_fraction, r%energy]
      slopes = -properties%sigma*height_slope_at(properties%heights, h) &
         *[r%stiffness, area_stiffness, r%pressure]
      if (scaled) then
         slopes = slopes + h*values
      else
         decay = exp(-0.5_wp*max(h, 0.0_wp)**2)
         values = values*decay
         slopes = slopes*decay
      end if
   end subroutine sample

   !> Find where the law's limits are passed, by bisection. What lies outside the polynomials is
   !> evaluated, and judged, directly.
   pure subroutine find_limits(law)
      type(compiled_law), intent(inout) :: law
      real(wp) :: lowest, highest, near, distant, h, middle, half_width
      integer :: i

      associate (is_gaussian => law%properties%heights%is_gaussian)
         call place_interval(law%columns(1), is_gaussian, middle, half_width)
         lowest = middle - half_width
         call place_interval(law%columns(2), is_gaussian, middle, half_width)
         highest = middle + half_width
      end associate
      do i = 1, 3
         law%limits(i) = lowest
         if (.not. is_passed(law, i, lowest)) cycle
         near = lowest
         distant = highest
         ! the first place where it is passed no more, as of heavy tails it may be again far out
         if (.not. law%properties%heights%is_gaussian) then
            distant = lowest
            do while (distant < highest)
               distant = distant + 2.0_wp*half_width
               if (.not. is_passed(law, i, distant)) exit
               near = distant
            end do
         end if
         do while (distant - near > epsilon(h)*max(1.0_wp, abs(near)))
            h = 0.5_wp*(near + distant)
            if (is_passed(law, i, h)) then
               near = h
            else
               distant = h
            end if
         end do
         law%limits(i) = distant
      end do
   end subroutine find_limits

   !> Whether a limit is passed at a separation over sigma: nominal area, hardness, half the radius.
   pure logical function is_passed(law, limit, h)
      type(compiled_law), intent(in) :: law
      integer, intent(in) :: limit
      real(wp), intent(in) :: h
      real(wp) :: d, pressure, stiffness, area_fraction
      type(normal_response) :: r

      d = height_of(law%properties%heights, h)*law%properties%sigma
      if (limit < 3) then
         call evaluate_compiled_law(law, d, pressure, stiffness, area_fraction)
         is_passed = merge(area_fraction > 1.0_wp, pressure > law%properties%hardness, limit == 1)
      else
         call evaluate_scaled_law(law%properties, d, r)
         is_passed = iand(r%validity, closure_above_half_radius) > 0
      end if
   end function is_passed

end module asperity_law_compile_law
