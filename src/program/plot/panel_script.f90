!> A panel of a figure as commands of gnuplot with its data inside.
module asperity_program_plot_panel_script
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_plot_figure, only: as_boxes, as_map, axis_type, panel_type, series_type
   use asperity_program_plot_palette, only: grid_colour, map_palette, map_places, missing_colour, &
      zero_colour
   use asperity_program_plot_series_script, only: add_data, label, style
   use asperity_program_system_strings, only: backslash
   implicit none
   private
   public :: add_panel

   !> Characters below which labels of ticks are taken to stay; what is beside a panel's axes
   integer, parameter :: label_length = 7, margins = 13
   !> Characters that gnuplot takes for the sample of a legend and the blanks around both
   integer, parameter :: legend_sample = 14
   !> Steps between ticks below boxes
   real(wp), parameter :: most_on_boxes = 2.5_wp

contains

   !> One panel; nothing of the one before stays.
   pure subroutine add_panel(b, panel, place, letters, line, right)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The panel
      type(panel_type), intent(in) :: panel
      !> Left, bottom, width and height as parts of the sheet
      real(wp), intent(in) :: place(4)
      !> Characters that fit across the panel
      integer, intent(in) :: letters
      !> Height of a line of text as a part of the sheet
      real(wp), intent(in) :: line
      !> Room for an axis on the right whether there is one or not
      logical, intent(in) :: right
      logical :: is_flat, has_colours, there(size(panel%series))
      integer :: i

      there = [(has_points(panel%series(i), panel%y%logarithmic), i=1, size(panel%series))]
      ! both axes have one scale
      is_flat = any(panel%series%form == as_map .or. panel%series%form == as_boxes)
      has_colours = panel%colours%label /= ''
      call b%line('reset')
      call b%line('set origin '//pair(place(1:2))//'; set size '// &
         trim(merge('ratio -1', 'noratio ', is_flat))//' '//pair(place(3:4)))
      call b%line('set lmargin 10; set rmargin '//trim(merge('5 ', merge('10', '3 ', &
         right .or. panel%right%label /= ''), has_colours)))
      call add_heading(b, panel, there, place, letters, line)
      if (.not. any(there)) then
         call b%line('unset tics; unset key; set label 2 '//label(panel%empty)// &
            ' at graph 0.5,0.5 center')
         call b%line('plot [0:1][0:1] -1 notitle')
         return
      end if
      if (.not. is_flat) call b%line('set grid back lt 1 lw 0.7 lc rgb "'//grid_colour//'"')
      if (panel%zero_lines) call b%line('set xzeroaxis lt 1 lw 0.8 lc rgb "'//zero_colour// &
         '"; set yzeroaxis lt 1 lw 0.8 lc rgb "'//zero_colour//'"')
      ! gnuplot's own format begins with a blank, which shifts labels
      call b%line("set format '%h'")
      call add_axis(b, 'x', panel%x)
      ! all of one length
      if (panel%x%logarithmic) call b%line("set format x '%.0te%T'")
      call add_axis(b, 'y', panel%y)
      call add_ticks(b, panel, max(2, (letters - margins)/label_length))
      if (panel%right%label /= '') then
         call add_axis(b, 'y2', panel%right)
         call b%line('set ytics nomirror; set y2tics')
      end if
      if (any(panel%series%form == as_map)) call b%line('set object 1 rectangle from graph 0,0 '// &
         'to graph 1,1 behind fillcolor rgb "'//missing_colour//'" fillstyle solid noborder')
      if (has_colours) call add_colours(b, panel%colours)
      do i = 1, size(panel%series)
         if (there(i)) call add_data(b, panel%series(i), i)
      end do
      call b%add('plot ')
      do i = 1, size(panel%series)
         if (.not. there(i)) cycle
         if (any(there(:i - 1))) call b%add(', '//backslash//new_line('a'))
         call b%add('$data'//to_text(i)//' using '//style(panel%series(i)))
      end do
      call b%line()
   end subroutine add_panel

   !> Title, and below it a legend of as many columns as fit, both above the axes.
   pure subroutine add_heading(b, panel, there, place, letters, line)
      type(growing_text), intent(inout) :: b
      type(panel_type), intent(in) :: panel
      logical, intent(in) :: there(:)
      real(wp), intent(in) :: place(4), line
      integer, intent(in) :: letters
      real(wp) :: centre, top
      integer :: columns, entries, i, longest

      centre = place(1) + 0.5_wp*place(3)
      top = place(2) + place(4)
      if (panel%title /= '') then
         call b%line('set label 1 '//label(panel%title)//' at screen '// &
            pair([centre, top - 0.5_wp*line])//' center')
         top = top - line
      end if
      entries = count([(there(i) .and. panel%series(i)%legend /= '', i=1, size(there))])
      if (entries > 0) then
         longest = maxval([(len(panel%series(i)%legend), i=1, size(there))])
         columns = max(1, min(entries, letters/(longest + legend_sample)))
         ! a legend of very many entries must leave room for axes
         associate (rows => max(1, min((entries - 1)/columns + 1, int(0.4_wp*place(4)/line))))
            call b%line('set key at screen '//pair([centre, top])// &
               ' center top vertical maxrows '//to_text(rows)//' Left reverse samplen 2')
            top = top - real(rows, wp)*line
         end associate
      end if
      call b%line('set tmargin at screen '//to_text(top - 0.4_wp*line, 5))
   end subroutine add_heading

   !> Whether there is a point that gnuplot could draw.
   pure logical function has_points(series, logarithmic)
      type(series_type), intent(in) :: series
      logical, intent(in) :: logarithmic

      has_points = any(.not. is_none(series%x) .and. .not. is_none(series%y) &
         .and. (.not. logarithmic .or. series%right .or. series%y > 0.0_wp))
   end function has_points

   !> Label, ends and scale of an axis.
   pure subroutine add_axis(b, name, axis)
      type(growing_text), intent(inout) :: b
      character(len=*), intent(in) :: name
      type(axis_type), intent(in) :: axis

      call b%line('set '//name//'label '//label(axis%label)//'; set '//name//'range '//ends(axis))
      if (axis%logarithmic) call b%line('set logscale '//name)
   end subroutine add_axis

   !> Ends of an axis.
   pure function ends(axis) result(text)
      type(axis_type), intent(in) :: axis
      character(len=:), allocatable :: text

      text = '['
      if (.not. is_none(axis%low)) text = text//to_text(axis%low)
      text = text//':'
      if (.not. is_none(axis%high)) text = text//to_text(axis%high)
      text = text//']'
   end function ends

   !> Ticks of the x axis so far apart that so many labels at most stand side by side, and room
   !> above and below what is drawn.
   pure subroutine add_ticks(b, panel, most)
      type(growing_text), intent(inout) :: b
      type(panel_type), intent(in) :: panel
      integer, intent(in) :: most
      real(wp) :: low, high, lowest, largest, step
      logical :: is_flat
      integer :: i

      is_flat = any(panel%series%form == as_map .or. panel%series%form == as_boxes)
      low = none
      high = -none
      lowest = none
      largest = 0.0_wp
      do i = 1, size(panel%series)
         associate (s => panel%series(i))
            low = min(low, minval(s%x))
            high = max(high, maxval(s%x, mask=.not. is_none(s%x)))
            if (s%right) cycle
            lowest = min(lowest, minval(s%y))
            largest = max(largest, maxval(abs(s%y), mask=.not. is_none(s%y)))
         end associate
      end do
      if (.not. is_none(panel%x%low)) low = panel%x%low
      if (.not. is_none(panel%x%high)) high = panel%x%high
      if (high > low .and. .not. panel%x%logarithmic) then
         ! the height may leave them less width than there is
         step = round_number((high - low)/merge(min(real(most, wp), most_on_boxes), &
            real(most, wp), any(panel%series%form == as_boxes)))
         if (panel%x%whole) step = max(1.0_wp, step)
         call b%line('set xtics '//to_text(step, 4))
         ! maps have one scale
         if (is_flat) call b%line('set ytics '//to_text(step, 4))
      end if
      ! room for labels with an exponent
      if (largest < 1.0e-4_wp .or. largest >= 1.0e6_wp) call b%line('set lmargin 12')
      if (is_flat) then
         call b%line('set autoscale xfix; set autoscale yfix')
      else if (.not. panel%y%logarithmic .and. is_none(panel%y%high)) then
         call b%line('set offsets '//merge('0.5,0.5', '0.0,0.0', panel%x%whole)// &
            ',graph 0.04,'//trim(merge('graph 0.04', '0         ', &
            is_none(panel%y%low) .and. lowest < 0.0_wp)))
      end if
   end subroutine add_ticks

   !> The smallest of 1, 2, 5, 10, 20, ... and so on that is not below a number above zero.
   pure real(wp) function round_number(number)
      real(wp), intent(in) :: number
      real(wp) :: power

      power = 10.0_wp**floor(log10(number))
      round_number = power*10.0_wp
      if (number <= 5.0_wp*power) round_number = 5.0_wp*power
      if (number <= 2.0_wp*power) round_number = 2.0_wp*power
   end function round_number

   !> The colours of a map or of boxes.
   pure subroutine add_colours(b, axis)
      type(growing_text), intent(inout) :: b
      type(axis_type), intent(in) :: axis
      integer :: i

      call b%add('set palette defined (')
      do i = 1, size(map_palette)
         if (i > 1) call b%add(', ')
         call b%add(to_text(map_places(i), 4)//' "'//map_palette(i)//'"')
      end do
      call b%line('); set cblabel '//label(axis%label)//'; set cbrange '//ends(axis)// &
         '; set cbtics '//to_text(round_number((axis%high - axis%low)/4.0_wp), 4))
   end subroutine add_colours

   pure function pair(numbers) result(text)
      real(wp), intent(in) :: numbers(2)
      character(len=:), allocatable :: text

      text = to_text(numbers(1), 5)//','//to_text(numbers(2), 5)
   end function pair

end module asperity_program_plot_panel_script
