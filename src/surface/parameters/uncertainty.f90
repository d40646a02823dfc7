!> How sure the parameters of a map are: each is evaluated again with one tile of the map left out
!> at a time (delete-one-group jackknife), and the scatter of the results says how far parameters of
!> other maps of the same face would lie from it.
module asperity_surface_parameters_uncertainty
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_surface_parameters_parameters, only: n_parameters, p_direction, p_sp, p_sv, p_sz
   use asperity_base_student, only: student_factor
   use asperity_surface_parameters_tile_sums, only: summed, surface_sums_type
   implicit none
   private
   public :: jackknife, uncertainties

   !> Share of maps within the stated uncertainty
   real(wp), parameter, public :: confidence = 0.95_wp
   !> Half width of the interval of a direction that is not known at all, deg
   real(wp), parameter :: any_direction = 90.0_wp

contains

   !> Half widths of the 95 % intervals of all parameters, by Student's t for one degree of freedom
   !> less than tiles with inner points. What the tiles have in common, the plane, the form and the
   !> height of pruning, is not seen by leaving one out. For pruning it can be added: it is a share
   !> of sz, an extreme, which differs much from map to map.
   pure subroutine uncertainties(sums, cell_area, uncertainty, raised, rise)
      !> Sums over the tiles
      type(surface_sums_type), intent(in) :: sums(:)
      !> Area of one inner point, step_x step_y, mm^2
      real(wp), intent(in) :: cell_area
      !> Half widths in the order of the table; `none` where there is none: for extremes,
      !> for what does not exist on every remainder, for fewer than two tiles
      real(wp), intent(out) :: uncertainty(n_parameters)
      !> Sums over the tiles with the height of pruning `rise` times as high
      type(surface_sums_type), intent(in), optional :: raised(:)
      !> Factor of that height, other than 1; 1.1, say
      real(wp), intent(in), optional :: rise
      real(wp), allocatable :: left(:, :), weights(:)
      real(wp) :: whole(n_parameters)
      integer, allocatable :: tiles(:)
      integer :: i

      uncertainty = none
      tiles = pack([(i, i=1, size(sums))], sums%inner > 0.0_wp)
      if (size(tiles) < 2) return
      call parameters_of(summed(sums), cell_area, whole)
      allocate (left(n_parameters, size(tiles)))
      do i = 1, size(tiles)
         call parameters_of(summed(sums, tiles(i)), cell_area, left(:, i))
      end do
      weights = sums(tiles)%inner/sum(sums(tiles)%inner)
      call jackknife(whole, left, weights, uncertainty)
      if (present(raised) .and. present(rise)) &
         call add_pruning(sums(tiles), summed(raised), rise, cell_area, whole, uncertainty)
      where (.not. is_none(uncertainty)) &
         uncertainty = student_factor(confidence, size(tiles) - 1)*sqrt(uncertainty)
      if (.not. is_none(uncertainty(p_direction))) &
         uncertainty(p_direction) = min(uncertainty(p_direction), any_direction)
   end subroutine uncertainties

   !> Add to the variances of what depends on pruning that of the logarithm of sz times the square
   !> of the slope by it. The largest of many heights scatters as the largest of fewer does, as far
   !> as heights end exponentially (Gumbel): the tiles show by how much.
   pure subroutine add_pruning(sums, raised, rise, cell_area, whole, variance)
      type(surface_sums_type), intent(in) :: sums(:), raised
      real(wp), intent(in) :: rise, cell_area, whole(n_parameters)
      real(wp), intent(inout) :: variance(n_parameters)
      real(wp) :: other(n_parameters), scatter
      integer :: n

      n = size(sums)
      if (.not. whole(p_sz) > 0.0_wp .or. is_none(whole(p_sz))) return
      call parameters_of(raised, cell_area, other)
      scatter = (sum((sums%highest - sum(sums%highest)/n)**2) &
         + sum((sums%lowest - sum(sums%lowest)/n)**2))/(n - 1)/whole(p_sz)**2
      where (.not. is_none(max(variance, whole, other))) &
         variance = variance + scatter*((other - whole)/log(rise))**2
   end subroutine add_pruning

   !> Variances of all parameters from their values with one tile left out, for tiles of unequal
   !> size (Busing, Meijer & van der Leeden 1999).
   pure subroutine jackknife(whole, left, weights, variance)
      !> Values of all tiles together
      real(wp), intent(in) :: whole(n_parameters)
      !> Values without one tile each, (parameter, tile)
      real(wp), intent(in) :: left(:, :)
      !> Shares of the tiles in the map, of sum 1
      real(wp), intent(in) :: weights(:)
      !> Variances; `none` where there is none
      real(wp), intent(out) :: variance(n_parameters)
      real(wp) :: change(size(weights)), bias
      integer :: p

      variance = none
      do p = 1, n_parameters
         if (p == p_sz .or. p == p_sp .or. p == p_sv) cycle
         if (is_none(max(whole(p), maxval(left(p, :))))) cycle
         change = left(p, :) - whole(p)
         if (p == p_direction) change = modulo(change + 90.0_wp, 180.0_wp) - 90.0_wp
         bias = sum((1.0_wp - weights)*change)
         ! pseudo-values whole - (1/weight - 1) change about their estimate whole - bias
         change = bias - (1.0_wp - weights)/weights*change
         variance(p) = sum(change**2*weights/(1.0_wp - weights))/size(weights)
      end do
   end subroutine jackknife

end module asperity_surface_parameters_uncertainty
