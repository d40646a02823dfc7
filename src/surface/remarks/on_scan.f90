!> What the scan itself is worth, in words: units, outliers, points that were filled in, waves that
!> are too long or too short for it.
module asperity_surface_remarks_on_scan
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_surface_parameters_parameters, only: n_parameters, p_m0, p_m2_x, p_m2_y, p_m4_x, &
      p_m4_y, p_sdq, p_sp, p_sq, p_sv
   use asperity_surface_remarks_remark, only: add_remark, is_known, remark_type
   implicit none
   private
   public :: enough_steps, enough_waves, remark_scan, remark_slope

   !> Points across and length over width of a map that may be no map
   integer, parameter :: narrow = 12, long = 50
   !> Least and largest sdq of a scanned surface
   real(wp), parameter :: least_slope = 1.0e-4_wp, largest_slope = 10.0_wp
   !> Height over sq from which a point is an outlier; the highest of 1e9 Gaussian ones is at 6
   real(wp), parameter :: far_out = 12.0_wp
   !> Share of filled points that is worth a word
   real(wp), parameter :: much_filled = 0.01_wp
   !> Waves that a tile must hold, and steps that the shortest waves must span
   real(wp), parameter :: enough_waves = 1.0_wp, enough_steps = 6.0_wp

   !> What is known of the map besides its values.
   type, public :: map_facts
      !> Steps, mm
      real(wp) :: step_x = 0.0_wp, step_y = 0.0_wp
      !> Sides of a tile, mm; zero without tiles
      real(wp) :: tile_x = 0.0_wp, tile_y = 0.0_wp
      !> Number of peaks
      real(wp) :: peaks = 0.0_wp
      !> Points along x and y
      integer :: points(2) = 0
      !> Share of points that were filled in
      real(wp) :: filled = 0.0_wp
      !> Places of the highest and of the lowest point, mm
      real(wp) :: top(2) = 0.0_wp, bottom(2) = 0.0_wp
   end type map_facts

contains

   !> All remarks on the scan.
   pure subroutine remark_scan(values, facts, remarks)
      !> Values in the order of the table
      real(wp), intent(in) :: values(n_parameters)
      !> What else is known
      type(map_facts), intent(in) :: facts
      !> Where to add them
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      call remark_shape(facts%points, remarks)
      call remark_slope(values(p_sdq), remarks)
      call remark_outlier('highest', values(p_sp), values(p_sq), facts%top, remarks)
      call remark_outlier('lowest', values(p_sv), values(p_sq), facts%bottom, remarks)
      call remark_filled(facts%filled, remarks)
      call remark_waves(values, facts, remarks)
      call remark_resolution(values, facts, remarks)
   end subroutine remark_scan

   !> A text of columns that was taken for a matrix.
   pure subroutine remark_shape(points, remarks)
      integer, intent(in) :: points(2)
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (minval(points) > narrow .or. maxval(points) < long*max(minval(points), 1)) return
      call add_remark(remarks, 'shape', 'The map is '//to_text(points(1))//' x '// &
         to_text(points(2))//' points: if the file has columns of x, y, z and more, rather '// &
         'than rows of heights, leave the other columns out.')
   end subroutine remark_shape

   !> Slopes of no scanned surface are a slip of units.
   pure subroutine remark_slope(sdq, remarks)
      !> Root mean square gradient
      real(wp), intent(in) :: sdq
      !> Where to add it
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (.not. is_known(sdq)) return
      if (sdq >= least_slope .and. sdq <= largest_slope) return
      call add_remark(remarks, 'slope', 'sdq = '//to_text(sdq, 4)//' is no slope of a scanned '// &
         'surface, which is from '//to_text(least_slope)//' to '//to_text(largest_slope)// &
         ': check units and step (--lateral-unit, --height-unit, --step). The routes do not '// &
         'show such a slip: eta R sigma is the same in all units.')
   end subroutine remark_slope

   !> One point far out of the others.
   pure subroutine remark_outlier(what, size, sq, place, remarks)
      character(len=*), intent(in) :: what
      real(wp), intent(in) :: size, sq, place(2)
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (.not. (is_known(size) .and. is_known(sq))) return
      if (size <= far_out*sq) return
      call add_remark(remarks, 'outlier', 'The '//what//' point is '//to_text(size, 4)// &
         ' mm off the mean plane, '//to_text(size/sq, 3)//' times sq, at x '// &
         to_text(place(1), 5)//' mm, y '//to_text(place(2), 5)//' mm: a spike, or a number '// &
         'that marks a missing point? It raises sq and sz, and with sz the height of '// &
         'pruning: take it out of the file, or name the number in --missing-value.')
   end subroutine remark_outlier

   !> Points that nobody measured.
   pure subroutine remark_filled(share, remarks)
      real(wp), intent(in) :: share
      type(remark_type), allocatable, intent(inout) :: remarks(:)

      if (share <= much_filled) return
      call add_remark(remarks, 'filled', to_text(100.0_wp*share, 2)//' % of the points were '// &
         'filled in: slopes and curvatures there are not those of the surface. --missing mask '// &
         'leaves them out.')
   end subroutine remark_filled

   pure subroutine remark_waves(values, facts, remarks)
      real(wp), intent(in) :: values(:)
      type(map_facts), intent(in) :: facts
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      real(wp) :: waves

      if (.not. all(is_known(values([p_m0, p_m2_x, p_m2_y])))) return
      if (.not. min(facts%tile_x, facts%tile_y, values(p_m0)) > 0.0_wp) return
      waves = min(facts%tile_x*sqrt(values(p_m2_x)/values(p_m0)), &
         facts%tile_y*sqrt(values(p_m2_y)/values(p_m0)))/(2.0_wp*pi)
      if (waves >= enough_waves) return
      call add_remark(remarks, 'few_waves', 'A tile is only '//to_text(waves, 2)//' typical '// &
         'waves, 2 pi sqrt(m0/m2), long: tiles are not independent of each other, and the '// &
         'uncertainties too small. Take a larger map, fewer tiles, or remove the form or '// &
         'longer waves.')
   end subroutine remark_waves

   pure subroutine remark_resolution(values, facts, remarks)
      real(wp), intent(in) :: values(:)
      type(map_facts), intent(in) :: facts
      type(remark_type), allocatable, intent(inout) :: remarks(:)
      real(wp) :: steps

      if (.not. all(is_known(values([p_m2_x, p_m2_y, p_m4_x, p_m4_y])))) return
      if (.not. min(facts%step_x, facts%step_y, values(p_m4_x), values(p_m4_y)) > 0.0_wp) return
      steps = 2.0_wp*pi*min(sqrt(values(p_m2_x)/values(p_m4_x))/facts%step_x, &
         sqrt(values(p_m2_y)/values(p_m4_y))/facts%step_y)
      if (steps >= enough_steps) return
      call add_remark(remarks, 'resolution', 'The shortest waves, 2 pi sqrt(m2/m4), span '// &
         to_text(steps, 2)//' steps, fewer than '//to_text(nint(enough_steps))//': curvatures '// &
         'and summits depend on the step, noise counts as roughness. Scan with a shorter step '// &
         'or filter short waves out.')
   end subroutine remark_resolution

end module asperity_surface_remarks_on_scan
