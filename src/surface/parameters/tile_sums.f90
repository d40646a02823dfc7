!> Sums over the points of a part of a map. Every parameter is a function of such sums, so that
!> those of parts add up to those of the whole, and leaving a part out tells how sure it is.
module asperity_surface_parameters_tile_sums
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: surface_sums_type, summit_sums_type, summed

   !> Sums over summits.
   type :: summit_sums_type
      !> Their number
      real(wp) :: number = 0.0_wp
      !> Sums of z and z^2
      real(wp) :: height = 0.0_wp, height_2 = 0.0_wp
      !> Sums of the mean curvature -(z_xx + z_yy)/2, by three points a direction, and its square
      real(wp) :: curvature = 0.0_wp, curvature_2 = 0.0_wp
   end type summit_sums_type

   !> Sums over one tile. z is the height above the mean plane of the whole map, mm; subscripts are
   !> derivatives: z_x by neighbours, z_xx by three points in a row. A difference counts where all
   !> its points were measured, and belongs to the tile of its first (z_x) or middle point.
   type :: surface_sums_type
      !> Points, and sums of z, |z|, z^2, z^3, z^4
      real(wp) :: points = 0.0_wp, first = 0.0_wp, absolute = 0.0_wp, second = 0.0_wp, &
         third = 0.0_wp, fourth = 0.0_wp
      !> Extremes of z
      real(wp) :: lowest = huge(1.0_wp), highest = -huge(1.0_wp)
      !> Pairs of neighbours along x and along y, and sums of their slopes' squares
      real(wp) :: pairs_x = 0.0_wp, pairs_y = 0.0_wp, slope_x = 0.0_wp, slope_y = 0.0_wp
      !> Three points in a row along x and along y, and sums of z_xx^2 and z_yy^2
      real(wp) :: triples_x = 0.0_wp, triples_y = 0.0_wp, curvature_x = 0.0_wp, &
         curvature_y = 0.0_wp
      !> Points with all eight neighbours, where summits can be told. There: sums of the products
      !> of the central differences, slopes xx, xy, yy ...
      real(wp) :: inner = 0.0_wp, gradient_xx = 0.0_wp, gradient_xy = 0.0_wp, &
         gradient_yy = 0.0_wp
      !> ... and z_xx z_xx, z_yy z_yy, z_xx z_yy, z_xy z_xy, z_xx z_xy, z_yy z_xy
      real(wp) :: hessian_xx_xx = 0.0_wp, hessian_yy_yy = 0.0_wp, hessian_xx_yy = 0.0_wp, &
         hessian_xy_xy = 0.0_wp, hessian_xx_xy = 0.0_wp, hessian_yy_xy = 0.0_wp
      !> Summits: inner points higher than all eight neighbours
      type(summit_sums_type) :: summits
      !> Peaks: the summits of hills left after Wolf pruning
      type(summit_sums_type) :: peaks
   end type surface_sums_type

contains

   !> Sums of two parts together.
   pure elemental function added(a, b) result(c)
      !> The parts
      type(surface_sums_type), intent(in) :: a, b
      type(surface_sums_type) :: c

      c%points = a%points + b%points
      c%first = a%first + b%first
      c%absolute = a%absolute + b%absolute
      c%second = a%second + b%second
      c%third = a%third + b%third
      c%fourth = a%fourth + b%fourth
      c%lowest = min(a%lowest, b%lowest)
      c%highest = max(a%highest, b%highest)
      c%pairs_x = a%pairs_x + b%pairs_x
      c%pairs_y = a%pairs_y + b%pairs_y
      c%slope_x = a%slope_x + b%slope_x
      c%slope_y = a%slope_y + b%slope_y
      c%triples_x = a%triples_x + b%triples_x
      c%triples_y = a%triples_y + b%triples_y
      c%curvature_x = a%curvature_x + b%curvature_x
      c%curvature_y = a%curvature_y + b%curvature_y
      c%inner = a%inner + b%inner
      c%gradient_xx = a%gradient_xx + b%gradient_xx
      c%gradient_xy = a%gradient_xy + b%gradient_xy
      c%gradient_yy = a%gradient_yy + b%gradient_yy
      c%hessian_xx_xx = a%hessian_xx_xx + b%hessian_xx_xx
      c%hessian_yy_yy = a%hessian_yy_yy + b%hessian_yy_yy
      c%hessian_xx_yy = a%hessian_xx_yy + b%hessian_xx_yy
      c%hessian_xy_xy = a%hessian_xy_xy + b%hessian_xy_xy
      c%hessian_xx_xy = a%hessian_xx_xy + b%hessian_xx_xy
      c%hessian_yy_xy = a%hessian_yy_xy + b%hessian_yy_xy
      c%summits = added_summits(a%summits, b%summits)
      c%peaks = added_summits(a%peaks, b%peaks)
   end function added

   !> Sums over the summits of two parts together.
   pure elemental function added_summits(a, b) result(c)
      !> The parts
      type(summit_sums_type), intent(in) :: a, b
      type(summit_sums_type) :: c

      c%number = a%number + b%number
      c%height = a%height + b%height
      c%height_2 = a%height_2 + b%height_2
      c%curvature = a%curvature + b%curvature
      c%curvature_2 = a%curvature_2 + b%curvature_2
   end function added_summits

   !> Sums of all parts but one together.
   pure function summed(parts, without) result(whole)
      !> The parts
      type(surface_sums_type), intent(in) :: parts(:)
      !> The one left out; none when absent
      integer, intent(in), optional :: without
      type(surface_sums_type) :: whole
      integer :: i, left_out

      left_out = 0
      if (present(without)) left_out = without
      do i = 1, size(parts)
         if (i /= left_out) whole = added(whole, parts(i))
      end do
   end function summed

end module asperity_surface_parameters_tile_sums
