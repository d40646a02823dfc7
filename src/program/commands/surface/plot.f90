!> Picture of `asperity surface` as a gnuplot script: the map, its heights, the law.
module asperity_program_commands_surface_plot
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_program_report_table, only: table_type
   use asperity_program_system_strings, only: backslash
   use asperity_program_system_text_buffer, only: text_buffer
   use asperity_surface_parameters_parameters, only: p_sq
   implicit none
   private
   public :: write_script

   !> Points of the map that are drawn along its longer side, bins of heights
   integer, parameter :: most_pixels = 256, bins = 40
   !> Heights that are drawn, in standard deviations
   real(wp), parameter :: reach = 4.0_wp
   !> Colours that colour-blind people can tell apart (Okabe and Ito)
   character(len=*), parameter :: strokes(4) = [character(len=40) :: &
      'with lines lw 2 lc rgb "#0072B2"', 'with lines lw 2 lc rgb "#D55E00" dt 2', &
      'with points pt 6 ps 1.2 lc rgb "#009E73"', 'with points pt 2 ps 1.0 lc rgb "#CC79A7"']

   character(len=*), parameter :: legends(4) = [character(len=32) :: &
      'Gaussian law, paper''s route', 'Gaussian law, Nayak and McCool', &
      'sum over summits, route''s radius', 'sum over summits, own radii']

   character(len=*), parameter :: drawn(4) = [character(len=18) :: 'pressure_paper', &
      'pressure_nayak', 'pressure_summits', 'pressure_own_radii']

contains

   !> The picture of a map.
   pure subroutine write_script(map, values, summits, law, title, script, error)
      !> The map as it was analysed
      type(height_map), intent(in) :: map
      !> Its parameters
      real(wp), intent(in) :: values(:)
      !> Heights of its summits, mm
      real(wp), intent(in) :: summits(:)
      !> Separations and pressures; columns that are not there or have no value are left out
      type(table_type), intent(in) :: law
      !> Title
      character(len=*), intent(in) :: title
      !> The picture
      character(len=:), allocatable, intent(out) :: script
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(text_buffer) :: b

      call add_map(b, map)
      call add_heights(b, map, summits, values(p_sq))
      call add_law(b, law)
      call b%line("set multiplot title '"//harmless(title)//"'")
      call b%line('set key top right')
      call draw_map(b, values(p_sq))
      call draw_heights(b, size(summits) > 0)
      call draw_law(b, law)
      call b%line('unset multiplot')
      call b%take(script, error)
   end subroutine write_script

   !> A text that gnuplot takes for nothing but a text.
   pure function harmless(text) result(plain)
      character(len=*), intent(in) :: text
      character(len=len(text)) :: plain
      character(len=*), parameter :: taken = 'abcdefghijklmnopqrstuvwxyz'// &
         'ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 ._+-,()'
      integer :: i

      plain = text
      do i = 1, len(plain)
         if (index(taken, plain(i:i)) == 0) plain(i:i) = '?'
      end do
   end function harmless

   !> Data block of the heights, thinned.
   pure subroutine add_map(b, map)
      type(text_buffer), intent(inout) :: b
      type(height_map), intent(in) :: map
      integer :: i, j, every

      every = (maxval(shape(map%heights)) + most_pixels - 1)/most_pixels
      call b%line('$map << EOD')
      do j = 1, size(map%heights, 2), every
         do i = 1, size(map%heights, 1), every
            call b%numbers([real(i - 1, wp)*map%step_x, real(j - 1, wp)*map%step_y, &
               merge(none, map%heights(i, j), is_none(map%heights(i, j)))])
         end do
         call b%line()
      end do
      call b%line('EOD')
   end subroutine add_map

   !> Data block of the densities of heights and summits, and of the Gaussian one.
   pure subroutine add_heights(b, map, summits, sq)
      type(text_buffer), intent(inout) :: b
      type(height_map), intent(in) :: map
      real(wp), intent(in) :: summits(:), sq
      real(wp) :: points(bins), tops(bins), width, z
      real(wp), parameter :: root_2_pi = sqrt(2.0_wp*pi)
      integer :: i

      width = 2.0_wp*reach*sq/bins
      points = 0.0_wp
      do i = 1, size(map%heights, 2)
         points = points + counts(map%heights(:, i), sq, width)
      end do
      tops = counts(summits, sq, width)
      call b%line('$heights << EOD')
      do i = 1, bins
         z = (real(i, wp) - 0.5_wp)*width - reach*sq
         call b%numbers([z, points(i)/(sum(points)*width), &
            tops(i)/(max(sum(tops), 1.0_wp)*width), exp(-0.5_wp*(z/sq)**2)/(root_2_pi*sq)])
      end do
      call b%line('EOD')
   end subroutine add_heights

   !> How many heights are in each bin.
   pure function counts(heights, sq, width) result(numbers)
      real(wp), intent(in) :: heights(:), sq, width
      real(wp) :: numbers(bins)
      integer :: i, bin

      numbers = 0.0_wp
      do i = 1, size(heights)
         if (.not. abs(heights(i)) < reach*sq) cycle
         bin = min(bins, 1 + int((heights(i) + reach*sq)/width))
         numbers(bin) = numbers(bin) + 1.0_wp
      end do
   end function counts

   !> Data block of the law.
   pure subroutine add_law(b, law)
      type(text_buffer), intent(inout) :: b
      type(table_type), intent(in) :: law
      real(wp) :: row(1 + size(drawn))
      integer :: i, j, column

      call b%line('$law << EOD')
      do i = 1, law%rows
         row(1) = law%columns(1)%values(i)
         row(2:) = none
         do j = 1, size(drawn)
            column = law%find(trim(drawn(j)))
            if (column == 0) cycle
            ! the axis is logarithmic
            if (law%columns(column)%values(i) > 0.0_wp) row(j + 1) = law%columns(column)%values(i)
         end do
         call b%numbers(row)
      end do
      call b%line('EOD')
   end subroutine add_law

   !> The panel of the map.
   pure subroutine draw_map(b, sq)
      type(text_buffer), intent(inout) :: b
      real(wp), intent(in) :: sq

      call b%line('set size 0.5,0.5; set origin 0,0.46')
      call b%line("set xlabel 'x (mm)'; set ylabel 'y (mm)'; set cblabel 'height (mm)'")
      call b%line('set palette defined (0 "#08306b", 0.35 "#4292c6", 0.5 "#f7f7f7", '// &
         '0.65 "#ef8a62", 1 "#7f0000")')
      call b%line('set cbrange ['//to_text(-reach*sq, 6)//':'//to_text(reach*sq, 6)//']')
      call b%line('set autoscale xfix; set autoscale yfix; set size ratio -1; unset grid')
      call b%line('set xtics rotate by -30; set object 1 rectangle from graph 0,0 to graph 1,1 '// &
         'behind fillcolor rgb "#909090" fillstyle solid noborder')
      call b%line('plot $map using 1:2:3 with image notitle')
   end subroutine draw_map

   !> The panel of the heights.
   pure subroutine draw_heights(b, has_summits)
      type(text_buffer), intent(inout) :: b
      logical, intent(in) :: has_summits

      call b%line('set size noratio; set size 0.49,0.52; set origin 0.5,0.44; unset object 1')
      call b%line('set grid back lt 1 lw 0.7 lc rgb "#d0d0d0"')
      call b%line("set xlabel 'height above the mean plane (mm)'; set ylabel 'density (1/mm)'")
      call b%line('set autoscale x; set autoscale y; set yrange [0:*]; set xtics rotate by -30')
      call b%line('set key outside top center horizontal')
      call b%line('plot $heights using 1:2 '//trim(strokes(1))//" title 'all points', "//backslash)
      if (has_summits) call b%line('$heights using 1:3 '//trim(strokes(2))// &
         " title 'summits', "//backslash)
      call b%line("$heights using 1:4 with lines lw 1.2 lc rgb '#000000' dt 3 "// &
         "title 'Gaussian'")
   end subroutine draw_heights

   !> The panel of the law.
   pure subroutine draw_law(b, law)
      type(text_buffer), intent(inout) :: b
      type(table_type), intent(in) :: law
      character(len=:), allocatable :: lines
      integer :: i, column

      lines = ''
      do i = 1, size(drawn)
         column = law%find(trim(drawn(i)))
         if (column == 0) cycle
         if (.not. any(law%columns(column)%values > 0.0_wp &
            .and. .not. is_none(law%columns(column)%values))) cycle
         if (lines /= '') lines = lines//', '
         lines = lines//'$law using 1:'//to_text(i + 1)//' '//trim(strokes(i))//' title "'// &
            trim(legends(i))//'"'
      end do
      if (lines == '') return
      call b%line('set size 1,0.46; set origin 0,0; set xtics norotate')
      call b%line('set key outside center bottom horizontal')
      call b%line("set xlabel 'separation from the mean plane of summit heights (mm)'")
      call b%line("set ylabel 'pressure (MPa)'; set format y '%h'")
      call b%line('set logscale y; set autoscale y; set autoscale x')
      call b%line('plot '//lines)
   end subroutine draw_law

end module asperity_program_commands_surface_plot
