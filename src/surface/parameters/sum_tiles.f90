!> Sums over the tiles of a map, its points in one sweep.
module asperity_surface_parameters_sum_tiles
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_type, only: height_map
   use asperity_surface_parameters_tile_sums, only: summed, summit_sums_type, surface_sums_type
   use asperity_surface_summits_find, only: summit_set
   implicit none
   private
   public :: sum_map, sum_summits

   !> A row with a point more either side: heights, 0 where missing, and 1 where measured, else 0.
   !> Products with the weights leave missing points out without a branch for each
   type :: weighted_row
      real(wp), allocatable :: z(:), weight(:)
   end type weighted_row

contains

   !> Sum over tiles of a levelled map. Tiles are as equal as whole points allow and numbered along
   !> x first.
   pure subroutine sum_map(map, summits, tiles_x, tiles_y, sums)
      !> The map, about its mean plane
      type(height_map), intent(in) :: map
      !> Its summits
      type(summit_set), intent(in) :: summits
      !> Tiles along x and y, at least one and at most as many as points
      integer, intent(in) :: tiles_x, tiles_y
      !> Sums of each tile
      type(surface_sums_type), allocatable, intent(out) :: sums(:)
      type(weighted_row) :: rows(3)
      integer :: j, n, tile_x, tile

      allocate (sums(tiles_x*tiles_y))
      associate (nx => size(map%heights, 1), ny => size(map%heights, 2))
         do n = 1, 3
            allocate (rows(n)%z(0:nx + 1), rows(n)%weight(0:nx + 1))
         end do
         call read_row(map%heights, 0, rows(1))
         call read_row(map%heights, 1, rows(2))
         do j = 1, ny
            call read_row(map%heights, j + 1, rows(slot(j + 1)))
            do tile_x = 1, tiles_x
               tile = tile_x + tiles_x*(tile_of(j, ny, tiles_y) - 1)
               call add_row(first_of(tile_x, nx, tiles_x), first_of(tile_x + 1, nx, tiles_x) - 1, &
                  rows(slot(j - 1)), rows(slot(j)), rows(slot(j + 1)), sums(tile))
            end do
         end do
         do tile = 1, size(sums)
            call divide_by_steps(sums(tile), map%step_x, map%step_y)
         end do
      end associate
      call sum_summits(map, summits, summits%is_peak, tiles_x, tiles_y, sums)
   end subroutine sum_map

   !> Sum summits and peaks anew over the same tiles, in place of those that are in the sums.
   pure subroutine sum_summits(map, summits, is_peak, tiles_x, tiles_y, sums)
      !> The map and its summits
      type(height_map), intent(in) :: map
      type(summit_set), intent(in) :: summits
      !> Which of them are peaks
      logical, intent(in) :: is_peak(:)
      !> Tiles along x and y
      integer, intent(in) :: tiles_x, tiles_y
      !> Sums of each tile
      type(surface_sums_type), intent(inout) :: sums(:)
      integer :: n, tile

      sums%summits = summit_sums_type()
      sums%peaks = summit_sums_type()
      associate (nx => size(map%heights, 1), ny => size(map%heights, 2))
         do n = 1, size(summits%height)
            tile = tile_of(summits%i(n), nx, tiles_x) &
               + tiles_x*(tile_of(summits%j(n), ny, tiles_y) - 1)
            call add_summit(sums(tile)%summits, summits%height(n), summits%curvature(n))
            if (is_peak(n)) &
               call add_summit(sums(tile)%peaks, summits%height(n), summits%curvature(n))
         end do
      end associate
   end subroutine sum_summits

   !> Where a row is kept: each takes the place of the third before.
   pure integer function slot(j)
      integer, intent(in) :: j

      slot = modulo(j, 3) + 1
   end function slot

   !> First point of a tile along one axis, of that many points and tiles.
   pure integer function first_of(tile, points, tiles)
      integer, intent(in) :: tile, points, tiles

      ! points by tiles may be beyond the default integers
      first_of = points/tiles*(tile - 1) + min(tile - 1, modulo(points, tiles)) + 1
   end function first_of

   !> Tile of a point along one axis, the reverse of `first_of`.
   pure integer function tile_of(point, points, tiles)
      integer, intent(in) :: point, points, tiles
      integer :: short, longer

      short = points/tiles
      longer = modulo(points, tiles)
      if (point <= longer*(short + 1)) then
         tile_of = (point - 1)/(short + 1) + 1
      else
         tile_of = longer + (point - 1 - longer*(short + 1))/short + 1
      end if
   end function tile_of

   !> A row of the map, nothing measured outside of it.
   pure subroutine read_row(z, j, row)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: j
      type(weighted_row), intent(inout) :: row
      integer :: i

      row%z = 0.0_wp
      row%weight = 0.0_wp
      if (j < 1 .or. j > size(z, 2)) return
      do i = 1, size(z, 1)
         if (z(i, j) >= none) cycle
         row%z(i) = z(i, j)
         row%weight(i) = 1.0_wp
      end do
   end subroutine read_row

   !> Add part of a row, `b`, between the row before and the one after it. Differences are not
   !> divided by steps yet.
   pure subroutine add_row(first, last, a, b, c, sums)
      integer, intent(in) :: first, last
      type(weighted_row), intent(in) :: a, b, c
      type(surface_sums_type), intent(inout) :: sums
      type(surface_sums_type) :: part
      real(wp) :: z, w, inner, x, y, xx, yy, xy, square
      integer :: i

      do i = first, last
         z = b%z(i)
         w = b%weight(i)
         square = z*z
         part%points = part%points + w
         part%first = part%first + z
         part%absolute = part%absolute + abs(z)
         part%second = part%second + square
         part%third = part%third + square*z
         part%fourth = part%fourth + square*square
         if (w > 0.5_wp) then
            part%lowest = min(part%lowest, z)
            part%highest = max(part%highest, z)
         end if
         x = w*b%weight(i + 1)
         part%pairs_x = part%pairs_x + x
         part%slope_x = part%slope_x + x*(b%z(i + 1) - z)**2
         y = w*c%weight(i)
         part%pairs_y = part%pairs_y + y
         part%slope_y = part%slope_y + y*(c%z(i) - z)**2
         xx = b%z(i + 1) - 2.0_wp*z + b%z(i - 1)
         yy = c%z(i) - 2.0_wp*z + a%z(i)
         x = x*b%weight(i - 1)
         y = y*a%weight(i)
         part%triples_x = part%triples_x + x
         part%curvature_x = part%curvature_x + x*xx**2
         part%triples_y = part%triples_y + y
         part%curvature_y = part%curvature_y + y*yy**2
         inner = x*y*a%weight(i - 1)*a%weight(i + 1)*c%weight(i - 1)*c%weight(i + 1)
         part%inner = part%inner + inner
         x = inner*(b%z(i + 1) - b%z(i - 1))
         y = inner*(c%z(i) - a%z(i))
         part%gradient_xx = part%gradient_xx + x*x
         part%gradient_xy = part%gradient_xy + x*y
         part%gradient_yy = part%gradient_yy + y*y
         xy = inner*(c%z(i + 1) - a%z(i + 1) - c%z(i - 1) + a%z(i - 1))
         xx = inner*xx
         yy = inner*yy
         part%hessian_xx_xx = part%hessian_xx_xx + xx*xx
         part%hessian_yy_yy = part%hessian_yy_yy + yy*yy
         part%hessian_xx_yy = part%hessian_xx_yy + xx*yy
         part%hessian_xy_xy = part%hessian_xy_xy + xy*xy
         part%hessian_xx_xy = part%hessian_xx_xy + xx*xy
         part%hessian_yy_xy = part%hessian_yy_xy + yy*xy
      end do
      sums = summed([sums, part])
   end subroutine add_row

   !> From sums of differences to those of derivatives.
   pure subroutine divide_by_steps(sums, step_x, step_y)
      type(surface_sums_type), intent(inout) :: sums
      real(wp), intent(in) :: step_x, step_y

      associate (s => sums, x => 1.0_wp/step_x, y => 1.0_wp/step_y)
         s%slope_x = s%slope_x*x**2
         s%slope_y = s%slope_y*y**2
         s%curvature_x = s%curvature_x*x**4
         s%curvature_y = s%curvature_y*y**4
         s%gradient_xx = 0.25_wp*s%gradient_xx*x**2
         s%gradient_xy = 0.25_wp*s%gradient_xy*x*y
         s%gradient_yy = 0.25_wp*s%gradient_yy*y**2
         s%hessian_xx_xx = s%hessian_xx_xx*x**4
         s%hessian_yy_yy = s%hessian_yy_yy*y**4
         s%hessian_xx_yy = s%hessian_xx_yy*(x*y)**2
         s%hessian_xy_xy = 0.0625_wp*s%hessian_xy_xy*(x*y)**2
         s%hessian_xx_xy = 0.25_wp*s%hessian_xx_xy*x**3*y
         s%hessian_yy_xy = 0.25_wp*s%hessian_yy_xy*x*y**3
      end associate
   end subroutine divide_by_steps

   !> Add a summit.
   pure subroutine add_summit(sums, height, curvature)
      type(summit_sums_type), intent(inout) :: sums
      real(wp), intent(in) :: height, curvature

      sums%number = sums%number + 1.0_wp
      sums%height = sums%height + height
      sums%height_2 = sums%height_2 + height**2
      sums%curvature = sums%curvature + curvature
      sums%curvature_2 = sums%curvature_2 + curvature**2
   end subroutine add_summit

end module asperity_surface_parameters_sum_tiles
