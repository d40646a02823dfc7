!> Two rough faces as one: the equivalent surface against a plane, and what aligned maps of both say
!> of the gap between them. The gap of two faces is that of their sum against a plane, so squares of
!> heights, slopes and curvatures add as far as the faces are not correlated.
module asperity_surface_pair_equivalent_surface
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_surface_parameters_parameters, only: n_parameters, p_eta_paper, p_peak_mean, &
      p_peak_sigma, p_radius_paper, p_sa, p_sku, p_sp, p_spc, p_spd, p_ssk, p_summit_curvature, &
      p_summit_density, p_summit_mean, p_summit_sigma, p_sv, p_sz
   use asperity_base_student, only: student_factor
   use asperity_surface_parameters_tile_sums, only: summed, surface_sums_type
   use asperity_surface_parameters_uncertainty, only: confidence, jackknife
   implicit none
   private
   public :: combine_values, map_correlation, pair_uncertainties, sum_of_maps

   !> Difference of steps, over the step, that counts as none
   real(wp), parameter :: same_step = 1.0e-6_wp

contains

   !> Parameters of the equivalent surface of a pair whose faces are not correlated: mean squares
   !> and products of heights, slopes and curvatures add, each along its own direction, and all that
   !> follows from them. Parameters without such a rule are `none`.
   pure subroutine combine_values(sums_1, sums_2, mirror, values)
      !> Sums over each face
      type(surface_sums_type), intent(in) :: sums_1, sums_2
      !> How the second is turned over, as for `sum_of_maps`
      character(len=*), intent(in) :: mirror
      !> Values of the pair, in the order of the table
      real(wp), intent(out) :: values(n_parameters)
      integer, parameter :: without_rule(*) = [p_sa, p_ssk, p_sku, p_sz, p_sp, p_sv, p_spd, p_spc, &
         p_summit_density, p_summit_curvature, p_summit_sigma, p_summit_mean, p_peak_sigma, &
         p_peak_mean, p_eta_paper, p_radius_paper]

      call parameters_of(added_means(sums_1, sums_2, mirror), 1.0_wp, values)
      values(without_rule) = none
   end subroutine combine_values

   !> Means over the points of two faces added, as the sums over one point.
   pure function added_means(a, b, mirror) result(c)
      type(surface_sums_type), intent(in) :: a, b
      character(len=*), intent(in) :: mirror
      type(surface_sums_type) :: c
      real(wp) :: turn

      c%points = both(a%points, b%points)
      c%second = mean(a%second, a%points) - mean(a%first, a%points)**2 &
         + mean(b%second, b%points) - mean(b%first, b%points)**2
      c%pairs_x = both(a%pairs_x, b%pairs_x)
      c%pairs_y = both(a%pairs_y, b%pairs_y)
      c%slope_x = mean(a%slope_x, a%pairs_x) + mean(b%slope_x, b%pairs_x)
      c%slope_y = mean(a%slope_y, a%pairs_y) + mean(b%slope_y, b%pairs_y)
      c%triples_x = both(a%triples_x, b%triples_x)
      c%triples_y = both(a%triples_y, b%triples_y)
      c%curvature_x = mean(a%curvature_x, a%triples_x) + mean(b%curvature_x, b%triples_x)
      c%curvature_y = mean(a%curvature_y, a%triples_y) + mean(b%curvature_y, b%triples_y)
      c%inner = both(a%inner, b%inner)
      c%gradient_xx = mean(a%gradient_xx, a%inner) + mean(b%gradient_xx, b%inner)
      c%gradient_yy = mean(a%gradient_yy, a%inner) + mean(b%gradient_yy, b%inner)
      c%hessian_xx_xx = mean(a%hessian_xx_xx, a%inner) + mean(b%hessian_xx_xx, b%inner)
      c%hessian_yy_yy = mean(a%hessian_yy_yy, a%inner) + mean(b%hessian_yy_yy, b%inner)
      c%hessian_xx_yy = mean(a%hessian_xx_yy, a%inner) + mean(b%hessian_xx_yy, b%inner)
      c%hessian_xy_xy = mean(a%hessian_xy_xy, a%inner) + mean(b%hessian_xy_xy, b%inner)
      ! odd in x and in y
      turn = merge(1.0_wp, -1.0_wp, mirror == 'none')
      c%gradient_xy = mean(a%gradient_xy, a%inner) + turn*mean(b%gradient_xy, b%inner)
      c%hessian_xx_xy = mean(a%hessian_xx_xy, a%inner) + turn*mean(b%hessian_xx_xy, b%inner)
      c%hessian_yy_xy = mean(a%hessian_yy_xy, a%inner) + turn*mean(b%hessian_yy_xy, b%inner)
   end function added_means

   !> One point where both faces have some, none elsewhere.
   pure real(wp) function both(a, b)
      real(wp), intent(in) :: a, b

      both = merge(1.0_wp, 0.0_wp, min(a, b) > 0.0_wp)
   end function both

   pure real(wp) function mean(total, number)
      real(wp), intent(in) :: total, number

      mean = 0.0_wp
      if (number > 0.0_wp) mean = total/number
   end function mean

   !> Half widths of the 95 % intervals of `combine_values`: the jackknife of each face with the
   !> other one whole, whose variances add; Student's t for degrees of freedom by Welch and
   !> Satterthwaite, rounded down.
   pure subroutine pair_uncertainties(sums_1, sums_2, mirror, uncertainty)
      !> Sums over the tiles of each face
      type(surface_sums_type), intent(in) :: sums_1(:), sums_2(:)
      !> How the second is turned over
      character(len=*), intent(in) :: mirror
      !> Half widths in the order of the table; `none` where there is none
      real(wp), intent(out) :: uncertainty(n_parameters)
      real(wp) :: variance_1(n_parameters), variance_2(n_parameters), total
      integer :: degrees_1, degrees_2, degrees, p

      uncertainty = none
      call vary_one(sums_1, sums_2, mirror, variance_1, degrees_1)
      call vary_one(sums_2, sums_1, mirror, variance_2, degrees_2)
      if (min(degrees_1, degrees_2) < 1) return
      do p = 1, n_parameters
         if (is_none(max(variance_1(p), variance_2(p)))) cycle
         total = variance_1(p) + variance_2(p)
         uncertainty(p) = 0.0_wp
         if (.not. total > 0.0_wp) cycle
         degrees = int(1.0_wp/((variance_1(p)/total)**2/degrees_1 &
            + (variance_2(p)/total)**2/degrees_2) + 1.0e-9_wp)
         uncertainty(p) = student_factor(confidence, degrees)*sqrt(total)
      end do
   end subroutine pair_uncertainties

   !> Variances of the pair's values from leaving out tiles of the first face. Which of the two is
   !> turned over makes no difference to them.
   pure subroutine vary_one(sums, others, mirror, variance, degrees)
      type(surface_sums_type), intent(in) :: sums(:), others(:)
      character(len=*), intent(in) :: mirror
      real(wp), intent(out) :: variance(n_parameters)
      integer, intent(out) :: degrees
      type(surface_sums_type) :: other
      real(wp) :: whole(n_parameters)
      real(wp), allocatable :: left(:, :)
      integer, allocatable :: tiles(:)
      integer :: i

      variance = none
      tiles = pack([(i, i=1, size(sums))], sums%inner > 0.0_wp)
      degrees = size(tiles) - 1
      if (degrees < 1) return
      other = summed(others)
      call combine_values(summed(sums), other, mirror, whole)
      allocate (left(n_parameters, size(tiles)))
      do i = 1, size(tiles)
         call combine_values(summed(sums, tiles(i)), other, mirror, left(:, i))
      end do
      call jackknife(whole, left, sums(tiles)%inner/sum(sums(tiles)%inner), variance)
   end subroutine vary_one

   !> Heights of two aligned maps added, the second one turned over to face the first. The gap at a
   !> distance of the mean planes is the distance less this sum, whose highest point touches first.
   !> A point missing from either is missing.
   pure subroutine sum_of_maps(map_1, map_2, mirror, map, error)
      !> Maps of the same points and steps, each seen from outside its own material
      type(height_map), intent(in) :: map_1, map_2
      !> How the second is turned over: about the y axis, which reverses `x`, about the x axis,
      !> which reverses `y`, or `none` when it was recorded from the side of the first
      character(len=*), intent(in) :: mirror
      !> The sum
      type(height_map), intent(out) :: map
      !> Set when the maps do not fit each other
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: other
      integer :: i, j, nx, ny, status

      call check_pair(map_1, map_2, mirror, error)
      if (allocated(error)) return
      nx = size(map_1%heights, 1)
      ny = size(map_1%heights, 2)
      map%step_x = map_1%step_x
      map%step_y = map_1%step_y
      map%source = map_1%source//' + '//map_2%source
      map%format = ''
      allocate (map%heights(nx, ny), stat=status)
      call check_memory(status, map%source, 8_int64*nx*ny, error)
      if (allocated(error)) return
      do j = 1, ny
         do i = 1, nx
            other = map_2%heights(merge(nx + 1 - i, i, mirror == 'x'), &
               merge(ny + 1 - j, j, mirror == 'y'))
            map%heights(i, j) = none
            if (.not. is_none(max(map_1%heights(i, j), other))) &
               map%heights(i, j) = map_1%heights(i, j) + other
         end do
      end do
   end subroutine sum_of_maps

   !> Correlation coefficient of the heights of two aligned maps, the second one turned over; 0
   !> where one of them is flat. Moments add only without it: m0 of the pair is m0_1 + m0_2
   !> + 2 correlation sqrt(m0_1 m0_2).
   pure subroutine map_correlation(map_1, map_2, mirror, correlation, error)
      !> Maps as for `sum_of_maps`
      type(height_map), intent(in) :: map_1, map_2
      !> `x`, `y` or `none`
      character(len=*), intent(in) :: mirror
      !> Coefficient, -1 to 1
      real(wp), intent(out) :: correlation
      !> Set when the maps do not fit each other
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: a, b, first(2), second(2), product, points
      integer :: i, j, nx, ny

      correlation = 0.0_wp
      call check_pair(map_1, map_2, mirror, error)
      if (allocated(error)) return
      nx = size(map_1%heights, 1)
      ny = size(map_1%heights, 2)
      points = 0.0_wp
      first = 0.0_wp
      second = 0.0_wp
      product = 0.0_wp
      do j = 1, ny
         do i = 1, nx
            a = map_1%heights(i, j)
            b = map_2%heights(merge(nx + 1 - i, i, mirror == 'x'), &
               merge(ny + 1 - j, j, mirror == 'y'))
            if (max(a, b) >= none) cycle
            points = points + 1.0_wp
            first = first + [a, b]
            second = second + [a*a, b*b]
            product = product + a*b
         end do
      end do
      if (.not. points > 0.0_wp) return
      first = first/points
      second = second/points - first**2
      if (minval(second) > 0.0_wp) correlation = &
         max(-1.0_wp, min(1.0_wp, &
         (product/points - first(1)*first(2))/sqrt(second(1))/sqrt(second(2))))
   end subroutine map_correlation

   !> Refuse maps that do not lie point on point.
   pure subroutine check_pair(map_1, map_2, mirror, error)
      type(height_map), intent(in) :: map_1, map_2
      character(len=*), intent(in) :: mirror
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: steps(2, 2)

      steps = reshape([map_1%step_x, map_1%step_y, map_2%step_x, map_2%step_y], [2, 2])
      if (all(mirror /= ['x   ', 'y   ', 'none'])) then
         call fatal_error(error, 'mirror = '//trim(mirror)//' is not known: give x, y or none', &
            subject='mirror')
      else if (any(shape(map_1%heights) /= shape(map_2%heights))) then
         call fatal_error(error, 'the maps have different points, '// &
            trim(size_text(map_1))//' in '// &
            map_1%source//' and '//trim(size_text(map_2))//' in '//map_2%source// &
            ': only maps that lie point on point have a gap')
      else if (any(abs(steps(:, 1) - steps(:, 2)) > same_step*steps(:, 1))) then
         call fatal_error(error, 'the maps have different steps, '//to_text(steps(1, 1), 8)// &
            ' x '//to_text(steps(2, 1), 8)//' mm in '//map_1%source//' and '// &
            to_text(steps(1, 2), 8)//' x '//to_text(steps(2, 2), 8)//' mm in '//map_2%source// &
            ': only maps that lie point on point have a gap')
      end if
   end subroutine check_pair

   pure function size_text(map) result(text)
      type(height_map), intent(in) :: map
      character(len=32) :: text

      text = to_text(size(map%heights, 1))//' x '//to_text(size(map%heights, 2))
   end function size_text

end module asperity_surface_pair_equivalent_surface
