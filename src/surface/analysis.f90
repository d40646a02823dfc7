!> What is done with a height map: prepared once, then everything is found from it.
module asperity_surface_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: check_height_map, check_heights, fewest_points, &
      height_map, missing_points, thinned
   use asperity_surface_parameters_from_sums, only: parameters_of
   use asperity_surface_parameters_parameters, only: n_parameters
   use asperity_surface_parameters_sum_tiles, only: sum_map, sum_summits
   use asperity_surface_parameters_tile_sums, only: summed, surface_sums_type
   use asperity_surface_parameters_uncertainty, only: uncertainties
   use asperity_surface_prepare_fill_holes, only: fill_missing, missing_share
   use asperity_surface_prepare_gaussian_filter, only: filter_long, filter_short
   use asperity_surface_prepare_level, only: level_plane, remove_form
   use asperity_surface_prepare_robust_filter, only: filter_long_robust
   use asperity_surface_summits_find, only: find_summits, summit_set
   implicit none
   private
   public :: preparation_settings, analysis_settings, surface_analysis_type, prepare_surface, &
      analyse_surface, most_tiles, stage_listener

   !> How a map is prepared.
   type :: preparation_settings
      !> Missing points are filled in; left out otherwise
      logical :: fills = .false.
      !> Share of missing points up to which a map is taken
      real(wp) :: most_missing = 0.05_wp
      !> Degree of the form that is removed, 1 (a plane) to 8
      integer :: form = 1
      !> Cut-offs of the S and the L filter, mm; zero for none
      real(wp) :: short_cutoff = 0.0_wp, long_cutoff = 0.0_wp
      !> The L filter is the robust one, not the linear one
      logical :: is_robust = .false.
   end type preparation_settings

   !> How it is analysed.
   type :: analysis_settings
      !> Hills lower than this share of sz are no peaks
      real(wp) :: pruning = 0.05_wp
      !> Tiles along either side
      integer :: tiles = 4
   end type analysis_settings

   !> Heights below this share of the largest before levelling are rounding
   real(wp), parameter :: rounding = 1.0e-13_wp
   !> Factor of the height of pruning by which the peaks' share of the uncertainties is found
   real(wp), parameter :: rise = 1.1_wp

   !> Multiples of the step at which the parameters are found
   integer, parameter, public :: steps(3) = [1, 2, 4]

   !> What was found.
   type :: surface_analysis_type
      !> Parameters in the order of `parameters`, at the steps above; `none` where there is none
      real(wp) :: values(n_parameters, size(steps)) = none
      !> Half widths of their 95 % intervals at the map's own step
      real(wp) :: uncertainty(n_parameters) = none
      !> Summits of the map
      type(summit_set) :: summits
      !> Area of one point, and of all those where summits can be told, mm^2
      real(wp) :: cell_area = 0.0_wp, area = 0.0_wp
      !> Sums over the tiles
      type(surface_sums_type), allocatable :: sums(:)
   end type surface_analysis_type

   abstract interface
      !> Hears what is under way, for work that takes long.
      subroutine stage_listener(what)
         !> Such as `levelling`
         character(len=*), intent(in) :: what
      end subroutine stage_listener
   end interface

contains

   !> Level a map or a profile, treat missing points and filter it, in the order of ISO 25178-3: S
   !> filter, form, L filter. Its heights are above its mean plane after that. `error` is set when a
   !> setting or the map is refused.
   subroutine prepare_surface(map, settings, error, tell)
      !> The map, changed in place
      type(height_map), intent(inout) :: map
      !> What to do
      type(preparation_settings), intent(in) :: settings
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> Hears what is under way
      procedure(stage_listener), optional :: tell
      real(wp) :: largest

      call check_heights(map, error)
      if (.not. allocated(error)) call check_missing(map, settings%most_missing, error)
      if (allocated(error)) return
      largest = largest_height(map)
      call say('levelling')
      call level_plane(map)
      if (settings%fills .and. missing_points(map) > 0) then
         call say('filling missing points')
         ! coarser maps take a third of the map and are marked, each hole has a load and a place
         call check_room(map%source, 8_int64*size(map%heights, kind=int64) + &
            32_int64*int(missing_points(map), int64), error)
         if (.not. allocated(error)) call fill_missing(map, error)
         if (allocated(error)) return
      end if
      if (settings%short_cutoff > 0.0_wp) then
         call say('S filter')
         call filter_short(map, settings%short_cutoff, error)
         if (allocated(error)) return
      end if
      if (settings%form > 1) then
         call say('removing the form')
         call remove_form(map, settings%form, error)
         if (allocated(error)) return
      end if
      if (settings%long_cutoff > 0.0_wp) then
         call say('L filter')
         if (settings%is_robust) then
            call filter_long_robust(map, settings%long_cutoff, error)
         else
            call filter_long(map, settings%long_cutoff, error)
         end if
         if (allocated(error)) return
      end if
      ! else nothing has come since that has a plane of its own
      if (settings%fills .or. max(settings%short_cutoff, settings%long_cutoff) > 0.0_wp) &
         call level_plane(map)
      if (largest_height(map) <= rounding*largest) call fatal_error(error, map%source// &
         ': has no roughness: all heights are on one plane or form, but for rounding')

   contains

      subroutine say(what)
         character(len=*), intent(in) :: what

         if (present(tell)) call tell(what)
      end subroutine say

   end subroutine prepare_surface

   !> Largest height of either sign.
   pure real(wp) function largest_height(map)
      type(height_map), intent(in) :: map
      integer :: i, j

      largest_height = 0.0_wp
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (map%heights(i, j) < none) &
               largest_height = max(largest_height, abs(map%heights(i, j)))
         end do
      end do
   end function largest_height

   !> Refuse a map of too many missing points.
   pure subroutine check_missing(map, most, error)
      type(height_map), intent(in) :: map
      real(wp), intent(in) :: most
      type(error_type), allocatable, intent(out) :: error

      if (missing_share(map) <= most) return
      call fatal_error(error, map%source//': '//to_text(missing_points(map))//' of '// &
         to_text(size(map%heights))//' points are missing, a share of '// &
         to_text(missing_share(map), 3)//'; most_missing = '//to_text(most)// &
         ' is allowed, raise it if the rest is the surface')
   end subroutine check_missing

   !> Parameters, their uncertainties and summits of a prepared map, and the parameters of every
   !> second and fourth point. `error` is set when a setting is refused or the map has no relief.
   subroutine analyse_surface(map, settings, analysis, error, tell)
      !> A prepared map
      type(height_map), intent(in) :: map
      !> How to analyse it
      type(analysis_settings), intent(in) :: settings
      !> What was found
      type(surface_analysis_type), intent(out) :: analysis
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> Hears what is under way
      procedure(stage_listener), optional :: tell
      type(surface_sums_type), allocatable :: raised(:), thinned_sums(:)
      type(surface_sums_type) :: whole
      type(summit_set) :: other_summits
      type(height_map) :: thinned_map
      integer :: k

      call check_height_map(map, error)
      if (.not. allocated(error)) call check_tiles(map, settings%tiles, error)
      if (allocated(error)) return
      if (present(tell)) call tell('finding summits')
      call find_summits(map, settings%pruning, analysis%summits, error)
      if (allocated(error)) return
      if (present(tell)) call tell('summing up')
      call sum_map(map, analysis%summits, settings%tiles, settings%tiles, analysis%sums)
      whole = summed(analysis%sums)
      analysis%cell_area = map%step_x*map%step_y
      analysis%area = whole%inner*analysis%cell_area
      call parameters_of(whole, analysis%cell_area, analysis%values(:, 1))
      if (present(tell)) call tell('uncertainties')
      if (settings%pruning > 0.0_wp .and. rise*settings%pruning <= 1.0_wp) then
         raised = analysis%sums
         call sum_summits(map, analysis%summits, &
            analysis%summits%relief >= rise*analysis%summits%pruned_below, settings%tiles, &
            settings%tiles, raised)
         call uncertainties(analysis%sums, analysis%cell_area, analysis%uncertainty, raised, rise)
      else
         call uncertainties(analysis%sums, analysis%cell_area, analysis%uncertainty)
      end if
      do k = 2, size(steps)
         if (minval(shape(map%heights)) < steps(k)*fewest_points) exit
         if (present(tell)) call tell('every point in '//to_text(steps(k)))
         call check_room(map%source, 8_int64*size(map%heights, kind=int64)/steps(k), error)
         if (allocated(error)) return
         call thinned(map, steps(k), thinned_map)
         call find_summits(thinned_map, settings%pruning, other_summits, error)
         if (allocated(error)) return
         call sum_map(thinned_map, other_summits, 1, 1, thinned_sums)
         call parameters_of(thinned_sums(1), thinned_map%step_x*thinned_map%step_y, &
            analysis%values(:, k))
      end do
   end subroutine analyse_surface

   !> Tiles along either side that a map can be split into at most.
   pure integer function most_tiles(map)
      !> The map
      type(height_map), intent(in) :: map

      most_tiles = minval(shape(map%heights))/fewest_points
   end function most_tiles

   !> Refuse more tiles than a map can be split into.
   pure subroutine check_tiles(map, tiles, error)
      type(height_map), intent(in) :: map
      integer, intent(in) :: tiles
      type(error_type), allocatable, intent(out) :: error
      integer :: most

      most = most_tiles(map)
      if (tiles < 1 .or. tiles > most) call fatal_error(error, 'tiles = '//to_text(tiles)// &
         ' is not allowed: it must be from 1 to '//to_text(most)//' for '// &
         to_text(size(map%heights, 1))//' x '//to_text(size(map%heights, 2))//' points', &
         subject='tiles')
   end subroutine check_tiles

end module asperity_surface_analysis
