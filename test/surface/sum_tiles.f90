!> Sums over tiles: on polynomials and waves by formula, with holes by counting; thinned maps.
module test_surface_sum_tiles
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map, thinned
   use asperity_surface_parameters_sum_tiles, only: sum_map
   use asperity_surface_parameters_tile_sums, only: summed, surface_sums_type
   use asperity_surface_summits_find, only: find_summits, summit_set
   use extremes, only: largest_of
   use funit, only: assertEqual, assertFalse, assertLessThan, assertRelativelyEqual, assertTrue, &
      TestMethod, TestSuite
   use map_cases, only: flat_map, kept_map, punch_holes, random_map, random_whole
   use random_inputs, only: random_stream
   implicit none
   private
   public :: suite_surface_sum_map

   real(wp), parameter :: pi = 4.0_wp*atan(1.0_wp)
   !> Of sums of some thousand terms
   real(wp), parameter :: tolerance = 1.0e-11_wp
   integer(int64), parameter :: seed = 173205_int64

contains

   function suite_surface_sum_map() result(suite)
      type(TestSuite) :: suite

      suite = TestSuite('surface_sum_map')
      call suite%addTest(TestMethod('a quadratic form by its derivatives', test_quadratic))
      call suite%addTest(TestMethod('a wave by its differences'' transmission', test_wave))
      call suite%addTest(TestMethod('heights and their powers', test_powers))
      call suite%addTest(TestMethod('what is beside holes is left out', test_holes))
      call suite%addTest(TestMethod('tiles add up to the map', test_tiles))
      call suite%addTest(TestMethod('summits and peaks in their tiles', test_summits))
      call suite%addTest(TestMethod('thinned maps', test_thinned))
   end function suite_surface_sum_map

   !> Sums of a map as one tile.
   subroutine sum_whole(map, sums)
      type(height_map), intent(in) :: map
      type(surface_sums_type), intent(out) :: sums
      type(surface_sums_type), allocatable :: tiles(:)
      type(summit_set) :: summits
      type(error_type), allocatable :: error

      call find_summits(map, 0.05_wp, summits, error)
      call assertFalse(allocated(error))
      call sum_map(map, summits, 1, 1, tiles)
      sums = tiles(1)
   end subroutine sum_whole

   !> z = p x^2 + q x y + r y^2, of which central differences are exact, and those of neighbours
   !> halfway between them.
   subroutine test_quadratic()
      integer, parameter :: nx = 14, ny = 9
      real(wp), parameter :: p = 0.7_wp, q = -0.4_wp, r = 0.2_wp, dx = 0.01_wp, dy = 0.03_wp
      type(height_map) :: map
      type(surface_sums_type) :: s
      real(wp) :: x(nx), y(ny), expected(5)
      integer :: i, j

      call flat_map(map, nx, ny, dx, dy)
      x = [((i - 1)*dx, i=1, nx)]
      y = [((j - 1)*dy, j=1, ny)]
      expected = 0.0_wp
      do j = 1, ny
         do i = 1, nx
            map%heights(i, j) = p*x(i)**2 + q*x(i)*y(j) + r*y(j)**2
            if (i < nx) expected(1) = expected(1) + (2*p*(x(i) + 0.5_wp*dx) + q*y(j))**2
            if (j < ny) expected(2) = expected(2) + (q*x(i) + 2*r*(y(j) + 0.5_wp*dy))**2
            if (i == 1 .or. i == nx .or. j == 1 .or. j == ny) cycle
            associate (z_x => 2*p*x(i) + q*y(j), z_y => q*x(i) + 2*r*y(j))
               expected(3:) = expected(3:) + [z_x*z_x, z_x*z_y, z_y*z_y]
            end associate
         end do
      end do
      call sum_whole(map, s)
      call assertEqual(1.0_wp*(nx - 1)*ny, s%pairs_x, tolerance=0.0_wp)
      call assertEqual(1.0_wp*nx*(ny - 1), s%pairs_y, tolerance=0.0_wp)
      call assertEqual(1.0_wp*(nx - 2)*ny, s%triples_x, tolerance=0.0_wp)
      call assertEqual(1.0_wp*nx*(ny - 2), s%triples_y, tolerance=0.0_wp)
      call assertEqual(1.0_wp*(nx - 2)*(ny - 2), s%inner, tolerance=0.0_wp)
      call assertRelativelyEqual(expected, [s%slope_x, s%slope_y, s%gradient_xx, s%gradient_xy, &
         s%gradient_yy], tolerance)
      ! second differences of heights of 0.02 in steps of 0.01: 1e-13 of rounding each
      call assertRelativelyEqual(4*p**2*s%triples_x, s%curvature_x, 1.0e-10_wp)
      call assertRelativelyEqual(4*r**2*s%triples_y, s%curvature_y, 1.0e-10_wp)
      call assertRelativelyEqual(s%inner*[4*p**2, 4*r**2, 4*p*r, q**2, 2*p*q, 2*r*q], &
         [s%hessian_xx_xx, s%hessian_yy_yy, s%hessian_xx_yy, s%hessian_xy_xy, s%hessian_xx_xy, &
         s%hessian_yy_xy], 1.0e-10_wp)
   end subroutine test_quadratic

   !> A wave along x and y together over whole waves of the points that count: half its square times
   !> what the differences make of it.
   subroutine test_wave()
      integer, parameter :: points = 12
      real(wp), parameter :: dx = 0.02_wp, dy = 0.05_wp, k = 2.0_wp*pi/points
      type(height_map) :: map
      type(surface_sums_type) :: s
      real(wp) :: z_x, z_y, z_xx, z_yy, z_xy
      integer :: i, j

      ! 36 pairs along x, 24 along y; each row and column is some phase of a whole number of waves
      call flat_map(map, 3*points + 1, 2*points + 1, dx, dy)
      call add_wave()
      call sum_whole(map, s)
      call assertRelativelyEqual(0.5_wp*(2.0_wp*sin(0.5_wp*k)/dx)**2*s%pairs_x, s%slope_x, &
         tolerance)
      call assertRelativelyEqual(0.5_wp*(2.0_wp*sin(k)/dy)**2*s%pairs_y, s%slope_y, tolerance)
      ! two points more, so that triples and inner points make whole waves
      call flat_map(map, 3*points + 2, 2*points + 2, dx, dy)
      call add_wave()
      call sum_whole(map, s)
      z_x = sin(k)/dx
      z_y = sin(2*k)/dy
      z_xx = (2.0_wp*sin(0.5_wp*k)/dx)**2
      z_yy = (2.0_wp*sin(k)/dy)**2
      z_xy = sin(k)*sin(2*k)/(dx*dy)
      call assertRelativelyEqual(0.5_wp*[z_xx**2*s%triples_x, z_yy**2*s%triples_y], &
         [s%curvature_x, s%curvature_y], tolerance)
      call assertRelativelyEqual(0.5_wp*s%inner*[z_x*z_x, z_x*z_y, z_y*z_y], &
         [s%gradient_xx, s%gradient_xy, s%gradient_yy], tolerance)
      call assertRelativelyEqual(0.5_wp*s%inner*[z_xx**2, z_yy**2, z_xx*z_yy, z_xy**2, &
         z_xx*z_xy, z_yy*z_xy], [s%hessian_xx_xx, s%hessian_yy_yy, s%hessian_xx_yy, &
         s%hessian_xy_xy, s%hessian_xx_xy, s%hessian_yy_xy], tolerance)

   contains

      !> Of `points` steps along x and half as many along y.
      subroutine add_wave()
         do j = 1, size(map%heights, 2)
            do i = 1, size(map%heights, 1)
               map%heights(i, j) = cos(k*i + 2*k*j + 0.3_wp)
            end do
         end do
      end subroutine add_wave

   end subroutine test_wave

   subroutine test_powers()
      type(height_map) :: map
      type(surface_sums_type) :: s

      call flat_map(map, 5, 5, 1.0_wp, 1.0_wp)
      map%heights(2, 3) = -2.0_wp
      map%heights(4, 1) = 3.0_wp
      map%heights(1, 5) = none
      call sum_whole(map, s)
      call assertRelativelyEqual([24.0_wp, 1.0_wp, 5.0_wp, 13.0_wp, 19.0_wp, 97.0_wp, -2.0_wp, &
         3.0_wp], [s%points, s%first, s%absolute, s%second, s%third, s%fourth, s%lowest, &
         s%highest], 1.0e-15_wp)
   end subroutine test_powers

   !> Counts and sums of a random map with holes, point by point by the words of the definitions.
   subroutine test_holes()
      type(random_stream) :: stream
      type(height_map) :: map
      type(surface_sums_type) :: s
      real(wp) :: counts(5), sums(6)
      logical :: m(0:31, 0:21)
      integer :: i, j

      stream = random_stream(seed)
      call random_map(map, stream, 30, 20, 0.5_wp, 0.25_wp)
      call punch_holes(map, stream, 0.15_wp)
      call sum_whole(map, s)
      m = .false.
      m(1:30, 1:20) = map%heights < none
      counts = 0.0_wp
      sums = 0.0_wp
      associate (z => map%heights)
         do j = 1, 20
            do i = 1, 30
               if (m(i, j) .and. m(i + 1, j)) then
                  counts(1) = counts(1) + 1.0_wp
                  sums(1) = sums(1) + (2.0_wp*(z(i + 1, j) - z(i, j)))**2
               end if
               if (m(i, j) .and. m(i, j + 1)) then
                  counts(2) = counts(2) + 1.0_wp
                  sums(2) = sums(2) + (4.0_wp*(z(i, j + 1) - z(i, j)))**2
               end if
               if (all(m(i - 1:i + 1, j))) then
                  counts(3) = counts(3) + 1.0_wp
                  sums(3) = sums(3) + (4.0_wp*(z(i + 1, j) - 2.0_wp*z(i, j) + z(i - 1, j)))**2
               end if
               if (all(m(i, j - 1:j + 1))) then
                  counts(4) = counts(4) + 1.0_wp
                  sums(4) = sums(4) + (16.0_wp*(z(i, j + 1) - 2.0_wp*z(i, j) + z(i, j - 1)))**2
               end if
               if (.not. all(m(i - 1:i + 1, j - 1:j + 1))) cycle
               counts(5) = counts(5) + 1.0_wp
               sums(5) = sums(5) + (z(i + 1, j) - z(i - 1, j))*2.0_wp*(z(i, j + 1) - z(i, j - 1))
               sums(6) = sums(6) + 4.0_wp*(z(i + 1, j + 1) - z(i + 1, j - 1) - z(i - 1, j + 1) &
                  + z(i - 1, j - 1))**2
            end do
         end do
      end associate
      call assertRelativelyEqual(counts, [s%pairs_x, s%pairs_y, s%triples_x, s%triples_y, &
         s%inner], 1.0e-15_wp)
      call assertRelativelyEqual(sums, [s%slope_x, s%slope_y, s%curvature_x, s%curvature_y, &
         s%gradient_xy, s%hessian_xy_xy], tolerance)
   end subroutine test_holes

   subroutine test_tiles()
      type(random_stream) :: stream
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      type(surface_sums_type), allocatable :: whole(:), tiles(:)
      integer :: trial, tiles_x, tiles_y

      stream = random_stream(seed + 1)
      do trial = 1, 20
         call random_map(map, stream, random_whole(stream, 5, 40), random_whole(stream, 5, 40), &
            0.01_wp, 0.02_wp)
         if (modulo(trial, 2) == 0) call punch_holes(map, stream, 0.1_wp)
         call find_summits(map, 0.05_wp, summits, error)
         call assertFalse(allocated(error))
         tiles_x = random_whole(stream, 1, 5)
         tiles_y = random_whole(stream, 1, 5)
         call sum_map(map, summits, 1, 1, whole)
         call sum_map(map, summits, tiles_x, tiles_y, tiles)
         call assertEqual(1, size(whole))
         call assertEqual(tiles_x*tiles_y, size(tiles))
         ! sums of up to 1600 terms, some of either sign: by the size of their squares
         call assertLessThan(largest_of((listed(summed(tiles)) - listed(whole(1))) &
            /(abs(listed(whole(1))) + sqrt(whole(1)%points))), tolerance, message='map '// &
            to_text(trial)//' of seed '//to_text(int(seed + 1)))
      end do
   end subroutine test_tiles

   !> All sums, those of curvatures in units of what the steps make of heights.
   pure function listed(s) result(list)
      type(surface_sums_type), intent(in) :: s
      real(wp) :: list(39)

      list(:8) = [s%points, s%first, s%absolute, s%second, s%third, s%fourth, s%lowest, s%highest]
      list(9:16) = [s%pairs_x, s%pairs_y, s%slope_x, s%slope_y, s%triples_x, s%triples_y, &
         s%curvature_x, s%curvature_y]
      list(17:20) = [s%inner, s%gradient_xx, s%gradient_xy, s%gradient_yy]
      list(21:26) = [s%hessian_xx_xx, s%hessian_yy_yy, s%hessian_xx_yy, s%hessian_xy_xy, &
         s%hessian_xx_xy, s%hessian_yy_xy]*1.0e-8_wp
      list(27:31) = [s%summits%number, s%summits%height, s%summits%height_2, &
         s%summits%curvature*1.0e-4_wp, s%summits%curvature_2*1.0e-8_wp]
      list(32:36) = [s%peaks%number, s%peaks%height, s%peaks%height_2, &
         s%peaks%curvature*1.0e-4_wp, s%peaks%curvature_2*1.0e-8_wp]
      list(37:) = [s%slope_x, s%slope_y, s%gradient_xy]
   end function listed

   !> Tiles of 3, 2 and 2 points along x and 3 and 3 along y; two summits at corners of tiles, the
   !> second of relief 0.05 over the saddle between them, pruned.
   subroutine test_summits()
      type(height_map) :: map
      type(summit_set) :: summits
      type(error_type), allocatable :: error
      type(surface_sums_type), allocatable :: tiles(:)

      call flat_map(map, 7, 6, 0.5_wp, 0.25_wp)
      map%heights(3, 3) = 2.0_wp
      map%heights(4:6, 4) = [1.9_wp, 1.93_wp, 1.95_wp]
      call find_summits(map, 0.05_wp, summits, error)
      call assertFalse(allocated(error))
      call sum_map(map, summits, 3, 2, tiles)
      call assertRelativelyEqual([9.0_wp, 6.0_wp, 6.0_wp, 9.0_wp, 6.0_wp, 6.0_wp], tiles%points, &
         1.0e-15_wp)
      call assertEqual([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], &
         tiles%summits%number, tolerance=0.0_wp)
      call assertEqual([1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp], &
         tiles%peaks%number, tolerance=0.0_wp)
      ! z/step_x^2 + z/step_y^2, the second less half of 1.93/step_x^2
      associate (first => tiles(1)%summits, second => tiles(6)%summits)
         call assertRelativelyEqual([40.0_wp, 1600.0_wp, 35.14_wp, 35.14_wp**2], &
            [first%curvature, first%curvature_2, second%curvature, second%curvature_2], 1.0e-14_wp)
         call assertRelativelyEqual([2.0_wp, 4.0_wp, 1.95_wp, 3.8025_wp], &
            [first%height, first%height_2, second%height, second%height_2], 1.0e-14_wp)
      end associate
      call assertRelativelyEqual([2.0_wp, 4.0_wp, 40.0_wp, 1600.0_wp], [tiles(1)%peaks%height, &
         tiles(1)%peaks%height_2, tiles(1)%peaks%curvature, tiles(1)%peaks%curvature_2], &
         1.0e-14_wp)
   end subroutine test_summits

   subroutine test_thinned()
      type(random_stream) :: stream
      type(height_map) :: map, thin
      integer :: every

      stream = random_stream(seed + 2)
      call random_map(map, stream, 17, 12, 0.5_wp, 0.25_wp)
      map%heights(9, 5) = none
      do every = 1, 4
         call thinned(map, every, thin)
         call assertTrue(kept_map(thin, map%heights(::every, ::every)), message='heights')
         call assertEqual(0.5_wp*every, thin%step_x, tolerance=1.0e-15_wp)
         call assertEqual(0.25_wp*every, thin%step_y, tolerance=1.0e-15_wp)
         call assertEqual('test map', thin%source)
         call assertEqual('none', thin%format)
      end do
   end subroutine test_thinned

end module test_surface_sum_tiles
