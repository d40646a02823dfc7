!> Picture of `asperity surface`: the map, its heights, the law.
module asperity_program_commands_surface_plot
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_height_map_type, only: height_map
   use asperity_program_plot_figure, only: as_line, as_map, as_points, as_steps, cross, dashed, &
      disc, dotted, figure_type, panel_type, ring, solid
   use asperity_program_plot_palette, only: black, blue, green, pink, red
   use asperity_program_report_table, only: table_type
   use asperity_surface_parameters_parameters, only: p_sq
   implicit none
   private
   public :: surface_picture

   !> Points of the map that are drawn along its longer side, bins of heights
   integer, parameter :: most_pixels = 256, most_bins = 40
   !> Points of a profile that are drawn
   integer, parameter :: most_drawn = 2000
   !> Where the map or the profile is drawn
   real(wp), parameter :: scan_place(4) = [0.0_wp, 0.46_wp, 0.5_wp, 0.54_wp]
   !> Heights that are drawn, in standard deviations
   real(wp), parameter :: reach = 4.0_wp

   !> Curves of the law.
   type :: curve_type
      character(len=18) :: column
      character(len=32) :: legend
      integer :: colour, form, stroke, mark
   end type curve_type

   type(curve_type), parameter :: curves(4) = [ &
      curve_type('pressure_paper', 'Gaussian law, paper''s route', blue, as_line, solid, disc), &
      curve_type('pressure_nayak', 'Gaussian law, Nayak and McCool', red, as_line, dashed, disc), &
      curve_type('pressure_summits', 'sum over summits, route''s radius', green, as_points, solid, &
      ring), curve_type('pressure_own_radii', 'sum over summits, own radii', pink, as_points, &
      solid, cross)]

contains

   !> The picture of a map.
   pure function surface_picture(map, values, summits, law) result(picture)
      !> The map as it was analysed
      type(height_map), intent(in) :: map
      !> Its parameters
      real(wp), intent(in) :: values(:)
      !> Heights of its summits, mm
      real(wp), intent(in) :: summits(:)
      !> Separations and pressures; columns that are not there or have no value are left out
      type(table_type), intent(in) :: law
      type(figure_type) :: picture

      type(panel_type) :: scan

      if (size(map%heights, 2) == 1) then
         scan = profile_panel(map)
      else
         scan = map_panel(map, values(p_sq))
      end if
      picture = figure_type('', [scan, heights_panel(map, summits, values(p_sq)), law_panel(law)])
   end function surface_picture

   !> Heights against x, thinned.
   pure function profile_panel(map) result(panel)
      type(height_map), intent(in) :: map
      type(panel_type) :: panel
      integer :: every, i

      every = (size(map%heights, 1) + most_drawn - 1)/most_drawn
      panel = panel_type('x (mm)', 'height (mm)')
      panel%place = scan_place
      call panel%add([(real(i, wp)*map%step_x, i=0, size(map%heights, 1) - 1, every)], &
         map%heights(::every, 1), '', blue)
   end function profile_panel

   !> Heights by colours, thinned.
   pure function map_panel(map, sq) result(panel)
      type(height_map), intent(in) :: map
      real(wp), intent(in) :: sq
      type(panel_type) :: panel
      real(wp), allocatable :: x(:, :), y(:, :), z(:, :)
      integer :: every, i, j

      every = (maxval(shape(map%heights)) + most_pixels - 1)/most_pixels
      allocate (z, source=map%heights(::every, ::every))
      where (is_none(z)) z = none
      allocate (x, y, mold=z)
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            x(i, j) = real((i - 1)*every, wp)*map%step_x
            y(i, j) = real((j - 1)*every, wp)*map%step_y
         end do
      end do
      panel = panel_type('x (mm)', 'y (mm)')
      panel%place = scan_place
      panel%colours%label = 'height (mm)'
      panel%colours%low = -reach*sq
      panel%colours%high = reach*sq
      call panel%add([x], [y], '', blue, as_map, z=[z])
   end function map_panel

   !> Densities of heights and summits, and the Gaussian one.
   pure function heights_panel(map, summits, sq) result(panel)
      type(height_map), intent(in) :: map
      real(wp), intent(in) :: summits(:), sq
      type(panel_type) :: panel
      real(wp) :: points(most_bins)
      real(wp), parameter :: root_2_pi = sqrt(2.0_wp*pi)
      integer :: i, n

      panel = panel_type('height above the mean plane (mm)', 'density (1/mm)')
      panel%place = [0.5_wp, 0.46_wp, 0.5_wp, 0.54_wp]
      panel%y%low = 0.0_wp
      points = 0.0_wp
      do i = 1, size(map%heights, 2)
         points = points + counts(map%heights(:, i), sq, most_bins)
      end do
      associate (z => middles(sq, most_bins))
         call panel%add(z, density(points, sq), 'all points', blue)
         call panel%add(z, exp(-0.5_wp*(z/sq)**2)/(root_2_pi*sq), 'Gaussian', black, stroke=dotted)
      end associate
      if (size(summits) == 0) return
      n = bins_of(summits, sq)
      call panel%add(middles(sq, n), density(counts(summits, sq, n), sq), 'summits', red, as_steps)
   end function heights_panel

   !> Bins over all heights drawn by Scott's rule: few where there are few summits.
   pure integer function bins_of(heights, sq)
      real(wp), intent(in) :: heights(:), sq
      real(wp) :: deviation, n

      n = real(size(heights), wp)
      deviation = sqrt(sum((heights - sum(heights)/n)**2)/n)
      bins_of = most_bins
      if (deviation > 0.0_wp) bins_of = ceiling(min(real(most_bins, wp), &
         2.0_wp*reach*sq/(3.49_wp*deviation)*n**(1.0_wp/3.0_wp)))
   end function bins_of

   !> Middles of bins.
   pure function middles(sq, bins) result(z)
      real(wp), intent(in) :: sq
      integer, intent(in) :: bins
      real(wp) :: z(bins)
      integer :: i

      z = [((2.0_wp*(real(i, wp) - 0.5_wp)/real(bins, wp) - 1.0_wp)*reach*sq, i=1, bins)]
   end function middles

   !> How many heights are in each bin.
   pure function counts(heights, sq, bins) result(numbers)
      real(wp), intent(in) :: heights(:), sq
      integer, intent(in) :: bins
      real(wp) :: numbers(bins)
      integer :: i, bin

      numbers = 0.0_wp
      do i = 1, size(heights)
         if (.not. abs(heights(i)) < reach*sq) cycle
         bin = min(bins, 1 + int((heights(i)/(reach*sq) + 1.0_wp)*0.5_wp*real(bins, wp)))
         numbers(bin) = numbers(bin) + 1.0_wp
      end do
   end function counts

   !> Parts of all in each bin over its width.
   pure function density(numbers, sq)
      real(wp), intent(in) :: numbers(:), sq
      real(wp) :: density(size(numbers))

      density = numbers/max(sum(numbers), 1.0_wp)*real(size(numbers), wp)/(2.0_wp*reach*sq)
   end function density

   !> Pressure against separation.
   pure function law_panel(law) result(panel)
      type(table_type), intent(in) :: law
      type(panel_type) :: panel
      integer :: i, column

      panel = panel_type('separation from the mean plane of summit heights (mm)', 'pressure (MPa)')
      panel%place = [0.0_wp, 0.0_wp, 1.0_wp, 0.46_wp]
      panel%y%logarithmic = .true.
      panel%empty = 'no law'
      do i = 1, size(curves)
         column = law%find(trim(curves(i)%column))
         if (column > 0) call panel%add(law%columns(1)%values, law%columns(column)%values, &
            trim(curves(i)%legend), curves(i)%colour, curves(i)%form, curves(i)%stroke, &
            curves(i)%mark)
      end do
   end function law_panel

end module asperity_program_commands_surface_plot
