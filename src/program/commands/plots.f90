!> Pictures as gnuplot scripts with their data inside.
module asperity_program_commands_plots
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_tenon_plots, only: picture_sheet
   use asperity_program_input_keys, only: command_curve, command_hysteresis, command_press, &
      command_surface, command_table
   use asperity_program_input_presets, only: faces_text
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: backslash, string_type
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: plot_script

   !> Evenly spaced points of each run that are drawn
   integer, parameter :: most_points = 1000
   !> Room above and below the closures, as a part of their range, or of sigma
   real(wp), parameter :: margin = 0.05_wp
   !> Colours that colour-blind people can tell apart (Okabe and Ito)
   character(len=7), parameter :: colours(7) = ['#0072B2', '#D55E00', '#009E73', '#CC79A7', &
      '#E69F00', '#56B4E9', '#000000']
   integer, parameter :: blue = 1, red = 2, green = 3, sky = 6, black = 7

contains

   !> The picture of a report.
   pure function plot_script(report) result(script)
      !> The report
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: script
      type(text_buffer) :: b

      if (allocated(report%pictures)) then
         script = picture_sheet(report%picture_data, report%pictures, &
            title(report, 'Tenon joint'))
         return
      end if
      call b%line('set grid back lt 1 lw 0.7 lc rgb "#d0d0d0"')
      call b%line('set key Left reverse spacing 1.2 samplen 2.5')
      call b%line('set style data lines')
      select case (report%command)
      case (command_curve)
         call add_curve(b, report)
      case (command_press)
         call add_press(b, report)
      case (command_hysteresis, command_surface, command_table)
         call b%add(report%picture_data)
      case default
         call add_shear(b, report)
      end select
      script = b%text()
   end function plot_script

   !> Pressure (logarithmic) and real area against separation.
   pure subroutine add_curve(b, report)
      type(text_buffer), intent(inout) :: b
      type(report_type), intent(in) :: report
      type(string_type) :: lines(3)

      call add_data(b, report, 1, [character(len=20) :: 'separation', 'pressure', &
         'area_fraction', 'validity'])
      call b%line('set title "'//title(report, 'Normal contact law')//'"')
      call b%line("set xlabel 'separation (mm)'")
      call b%line("set ylabel 'pressure (MPa)'")
      call b%line("set y2label 'real area / nominal area'")
      call b%line('set bmargin 6.5')
      call b%line('set key at screen 0.5,0.045 center horizontal')
      if (any(column(report, 'pressure') > 0.0_wp)) call b%line('set logscale y')
      call b%line("set format y '%h'")
      call b%line('set ytics nomirror')
      call b%line('set y2tics')
      call b%line('set y2range [0:*]')
      lines(1)%text = drawn(1, '1:2', 'pressure (left)', blue, '')
      lines(2)%text = drawn(1, '1:3', 'real area (right)', red, 'axes x1y2 dt 2')
      lines(3)%text = drawn(1, '1:($4>0 ? $2 : NaN)', 'past a limit of the law', black, &
         'with points pt 6 ps 1')
      if (report%validity() == 0) then
         call add_plot(b, lines(:2))
      else
         call add_plot(b, lines)
      end if
   end subroutine add_curve

   !> Normal stress against step time, with the stages that carry it (the paper's Fig. 17), and
   !> the overclosure.
   pure subroutine add_press(b, report)
      type(text_buffer), intent(inout) :: b
      type(report_type), intent(in) :: report
      type(string_type) :: lines(4), line(1)

      call add_data(b, report, 1, [character(len=20) :: 'time', 'pressure', 'elastic_share', &
         'plastic_share', 'overclosure'])
      call start_panels(b, title(report, 'Press and release'), 'step time (s)', &
         'normal stress (MPa)')
      call b%line('set style fill solid 0.6 noborder')
      call b%line('set yrange [0:*]')
      lines(1)%text = drawn(1, '1:(0):($2*$4)', 'plastic', red, 'with filledcurves')
      lines(2)%text = drawn(1, '1:($2*$4):($2*(1-$3))', 'elasto-plastic', sky, &
         'with filledcurves')
      lines(3)%text = drawn(1, '1:($2*(1-$3)):2', elastic_legend(report), green, &
         'with filledcurves')
      lines(4)%text = drawn(1, '1:2', 'normal stress', black, '')
      call add_plot(b, lines)
      call b%line('set yrange [*:*]')
      call start_second_panel(b, 'overclosure (mm)', '0.67')
      line(1)%text = drawn(1, '1:5', 'overclosure', blue, '')
      call add_plot(b, line)
      call b%line('unset multiplot')
   end subroutine add_press

   !> Legend of the elastic stage, whose band is too thin to see.
   pure function elastic_legend(report) result(legend)
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: legend

      associate (share => column(report, 'elastic_share'))
         legend = 'elastic ('//to_text(100.0_wp*share(maxloc(column(report, 'pressure'), 1)), 2) &
            //' % at peak)'
      end associate
   end function elastic_legend

   !> Shear stress, and closure, against displacement for all normal stresses (Fig. 18).
   pure subroutine add_shear(b, report)
      type(text_buffer), intent(inout) :: b
      type(report_type), intent(in) :: report
      type(string_type) :: stress(2*(size(report%first_rows) - 1)), closure(size(stress)/2)
      character(len=:), allocatable :: name
      integer :: run

      name = ''
      do run = 1, size(closure)
         call add_data(b, report, run, [character(len=20) :: 'displacement', &
            'shear_stress_nominal', 'shear_stress', 'overclosure'])
         associate (nominal => column(report, 'normal_stress_nominal'))
            name = to_text(nominal(report%first_rows(run)), 4)//' MPa'
         end associate
         stress(2*run - 1)%text = drawn(run, '1:2', name//', full disc', run, '')
         stress(2*run)%text = drawn(run, '1:3', name//', overlap', run, 'dt 2')
         closure(run)%text = drawn(run, '1:4', name, run, '')
      end do
      call start_panels(b, title(report, 'Direct shear'), 'displacement (mm)', &
         'shear stress (MPa)')
      call add_plot(b, stress)
      call start_second_panel(b, 'overclosure (mm)', '0.77')
      call add_separation_axis(b, report)
      call add_plot(b, closure)
      call b%line('unset multiplot')
   end subroutine add_shear

   !> Axes of overclosure on the left and of the same separation, over sigma, on the right.
   pure subroutine add_separation_axis(b, report)
      type(text_buffer), intent(inout) :: b
      type(report_type), intent(in) :: report
      real(wp) :: low, high, d0, sigma

      d0 = report%settings%real_of('initial_separation')
      sigma = report%settings%real_of('sigma')
      associate (overclosure => column(report, 'overclosure'))
         low = minval(overclosure)
         high = maxval(overclosure)
      end associate
      low = low - max(margin*(high - low), margin*sigma)
      high = high + max(margin*(high - low), margin*sigma)
      call b%line("set y2label 'separation / sigma'")
      call b%line('set ytics nomirror')
      call b%line('set y2tics')
      call b%line('set yrange ['//to_text(low)//':'//to_text(high)//']')
      call b%line('set y2range ['//to_text((d0 - low)/sigma)//':'//to_text((d0 - high)/sigma)//']')
   end subroutine add_separation_axis

   !> Two panels, one below the other, of the same width.
   pure subroutine start_panels(b, heading, x_label, y_label)
      type(text_buffer), intent(inout) :: b
      character(len=*), intent(in) :: heading, x_label, y_label

      call b%line('set lmargin at screen 0.12')
      call b%line('set rmargin at screen 0.66')
      call b%line('set multiplot layout 2,1 title "'//heading//'"')
      call b%line('set key at screen 0.67,0.90 left top')
      call b%line("set xlabel '"//x_label//"'")
      call b%line("set ylabel '"//y_label//"'")
   end subroutine start_panels

   !> The lower panel, its legend at a part of the picture's width.
   pure subroutine start_second_panel(b, y_label, legend)
      type(text_buffer), intent(inout) :: b
      character(len=*), intent(in) :: y_label, legend

      call b%line("set ylabel '"//y_label//"'")
      call b%line('set key at screen '//legend//',0.44 left top')
   end subroutine start_second_panel

   !> One line of a plot.
   pure function drawn(run, columns, legend, colour, style) result(text)
      integer, intent(in) :: run, colour
      character(len=*), intent(in) :: columns, legend, style
      character(len=:), allocatable :: text

      text = '$run'//to_text(run)//' using '//columns//' '//style//' lw 2 lc rgb "'// &
         colours(1 + modulo(colour - 1, size(colours)))//'" title "'//legend//'"'
   end function drawn

   !> The `plot` command of some lines.
   pure subroutine add_plot(b, lines)
      type(text_buffer), intent(inout) :: b
      type(string_type), intent(in) :: lines(:)
      integer :: i

      call b%add('plot ')
      do i = 1, size(lines) - 1
         call b%line(lines(i)%text//', '//backslash)
      end do
      call b%line(lines(size(lines))%text)
   end subroutine add_plot

   !> Title of a picture, which also says when results pass a limit of the law.
   pure function title(report, what) result(text)
      type(report_type), intent(in) :: report
      character(len=*), intent(in) :: what
      character(len=:), allocatable :: text

      text = what//': '//faces_text(report%settings)
      if (report%validity() /= 0) text = text//' (partly past the limits of the law)'
   end function title

   !> Values of a column.
   pure function column(report, name) result(values)
      type(report_type), intent(in) :: report
      character(len=*), intent(in) :: name
      real(wp), allocatable :: values(:)

      allocate (values, source=report%table%columns(report%table%find(name))%values)
   end function column

   !> Data block of some columns of one run.
   pure subroutine add_data(b, report, run, names)
      type(text_buffer), intent(inout) :: b
      type(report_type), intent(in) :: report
      integer, intent(in) :: run
      character(len=*), intent(in) :: names(:)
      character(len=17) :: number
      integer, allocatable :: rows(:)
      integer :: i, j

      allocate (rows, source=report%selected_rows(most_points))
      call b%line('$run'//to_text(run)//' << EOD')
      do i = 1, size(rows)
         if (rows(i) < report%first_rows(run) .or. rows(i) >= report%first_rows(run + 1)) cycle
         do j = 1, size(names)
            associate (column => report%table%columns(report%table%find(trim(names(j)))))
               if (allocated(column%values)) then
                  write (number, '(es17.8e3)') column%values(rows(i))
               else
                  write (number, '(i17)') column%codes(rows(i))
               end if
            end associate
            call b%add(number)
         end do
         call b%line()
      end do
      call b%line('EOD')
   end subroutine add_data

end module asperity_program_commands_plots
