!> Pictures of the tenon joint as gnuplot scripts: what the paper shows in its Figs 25 to 33.
module asperity_program_commands_tenon_plots
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_tenon_compare_models, only: joint_type, model_names
   use asperity_program_commands_tenon_plot_data, only: add_cycles, add_skeleton, add_states, &
      add_steps, state_block, state_steps
   use asperity_program_report_report, only: picture_type
   use asperity_program_system_strings, only: backslash
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: joint_pictures, picture_sheet

   !> Names of the models, and their lines in colours that colour-blind people can tell apart
   character(len=12), parameter :: legends(2) = ['hard contact', 'rough law   ']
   character(len=*), parameter :: strokes(2) = [character(len=28) :: &
      'lw 1.6 lc rgb "#0072B2"', 'lw 1.6 lc rgb "#D55E00" dt 2']
   character(len=*), parameter :: marks(2) = [character(len=12) :: 'pt 4 ps 0.9', 'pt 7 ps 0.6']

contains

   !> All pictures, and the data that they draw.
   subroutine joint_pictures(joints, data, pictures, error)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Data blocks, to come first in a script
      character(len=:), allocatable, intent(out) :: data
      !> The pictures
      type(picture_type), allocatable, intent(out) :: pictures(:)
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(text_buffer) :: b
      real(wp) :: tick
      integer :: i

      do i = 1, size(joints)
         call add_steps(b, joints(i))
         call add_skeleton(b, joints(i))
         call add_cycles(b, joints(i))
         call add_states(b, joints(i))
      end do
      call b%take(data, error)
      if (allocated(error)) return
      tick = round_number(0.4_wp*maxval(abs(joints(1)%steps%rotation)))
      allocate (pictures(9))
      pictures(1) = picture('Moment, all cycles', 'rotation (rad)', 'moment (kN m)', 'left top', &
         'all using 1:2 with lines', tick, &
         'Moment of both models over the whole programme (the paper''s Fig. 25).')
      pictures(2) = picture('Moment, largest loop', 'rotation (rad)', 'moment (kN m)', &
         'left top', 'loop using 1:2 with lines', tick, &
         'The first loop of the largest amplitude (Fig. 26). The joint runs against the '// &
         'friction of its sides while the gap closes that the indented wood has left: that '// &
         'pinches the loop.')
      pictures(3) = picture('Skeleton', 'rotation (rad)', 'moment (kN m)', 'right bottom', &
         'skeleton using 1:2 with linespoints', tick, 'Peaks of the first cycle of each '// &
         'amplitude; crosses are the yield points of equal energy (Fig. 28).')
      pictures(4) = picture('Secant stiffness', 'rotation (rad)', 'stiffness (kN m/rad)', &
         'right top', 'cycles using 1:3 with points', 0.5_wp*tick, &
         'Secant stiffness of every cycle, mean of both sides (Fig. 29).')
      pictures(5) = picture('Energy of the loops', 'cycle', 'energy (J)', 'left top', &
         'cycles using 2:4 with linespoints', 0.0_wp, &
         'Area of all moment-rotation loops up to each cycle (Fig. 30).')
      pictures(6) = picture('Dissipation by friction', 'cycle', 'energy (J)', 'left top', &
         'cycles using 2:5 with linespoints', 0.0_wp, &
         'Dissipated by friction on all faces up to each cycle (Fig. 35).')
      pictures(7) = picture('Normal force of the upper face, largest loop', 'rotation (rad)', &
         'normal force (kN)', 'left top', 'loop using 1:3 with lines', tick, &
         'Normal force of the upper face in the first loop of the largest amplitude (Fig. 34).')
      pictures(8) = picture('Pull-out, largest loop', 'rotation (rad)', 'pull-out (mm)', &
         'left bottom', 'loop using 1:4 with lines', tick, &
         'Pull-out of the tenon at the column face in the same loop.')
      pictures(9) = state_picture(joints)
   end subroutine joint_pictures

   !> All panels on one sheet of three columns.
   pure function picture_sheet(data, pictures, title) result(script)
      !> From `joint_pictures`
      character(len=*), intent(in) :: data
      !> The pictures
      type(picture_type), intent(in) :: pictures(:)
      !> Title of the sheet
      character(len=*), intent(in) :: title
      character(len=:), allocatable :: script
      type(text_buffer) :: b
      integer :: i, j, panels

      panels = sum([(size(pictures(i)%panels), i=1, size(pictures))])
      call b%add(data)
      call b%line('set multiplot layout '//to_text((panels + 2)/3)//',3 title "'//title//'"')
      do i = 1, size(pictures)
         do j = 1, size(pictures(i)%panels)
            call b%add(pictures(i)%panels(j)%text)
         end do
      end do
      call b%line('unset multiplot')
      script = b%text()
   end function picture_sheet

   !> One quantity against another for both models, ticks at some distance unless that is zero.
   pure function picture(title, x_label, y_label, key, what, tick, caption)
      character(len=*), intent(in) :: title, x_label, y_label, key, what, caption
      real(wp), intent(in) :: tick
      type(picture_type) :: picture
      character(len=:), allocatable :: mark
      type(text_buffer) :: b
      integer :: i

      call start_panel(b, title, x_label, y_label, key)
      if (tick > 0.0_wp) call b%line('set xtics '//to_text(tick, 4))
      call b%add('plot ')
      mark = ''
      do i = 1, size(legends)
         if (index(what, 'points') > 0) mark = trim(marks(i))
         if (i > 1) call b%line(', '//backslash)
         call b%add('$'//trim(model_names(i))//'_'//what//' '//mark//' '//trim(strokes(i))// &
            ' title "'//trim(legends(i))//'"')
         if (index(what, 'skeleton') == 1) call b%add(', $'//trim(model_names(i))//'_yield '// &
            'using 1:2 with points pt 2 ps 1.6 '//trim(strokes(i))//' notitle')
      end do
      call b%line()
      picture%caption = caption
      allocate (picture%panels(1))
      picture%panels(1)%text = b%text()
   end function picture

   !> Title, axes and legend of a panel; nothing of the one before stays.
   pure subroutine start_panel(b, title, x_label, y_label, key)
      type(text_buffer), intent(inout) :: b
      character(len=*), intent(in) :: title, x_label, y_label, key

      call b%line('set grid back lt 1 lw 0.7 lc rgb "#d8d8d8"')
      call b%line('set key inside '//key//' Left reverse spacing 1.1 samplen 2')
      call b%line('set title "'//title//'"')
      call b%line('set xlabel "'//x_label//'"')
      call b%line('set ylabel "'//y_label//'"')
      call b%line('unset arrow')
      call b%line('set xtics autofreq')
      call b%line('set xrange [*:*]')
      call b%line('set yrange [*:*]')
      call b%line('set format y "%g"')
      call b%line('set xzeroaxis lt 1 lw 0.8 lc rgb "#808080"')
      call b%line('set yzeroaxis lt 1 lw 0.8 lc rgb "#808080"')
   end subroutine start_panel

   !> The smallest of 1, 2, 5, 10, 20, ... and so on that is not below a number above zero.
   pure real(wp) function round_number(number)
      real(wp), intent(in) :: number
      real(wp) :: power

      power = 10.0_wp**floor(log10(number))
      round_number = power*10.0_wp
      if (number <= 5.0_wp*power) round_number = 5.0_wp*power
      if (number <= 2.0_wp*power) round_number = 2.0_wp*power
   end function round_number

   !> Open, sticking and slipping points along the upper and the lower face.
   function state_picture(joints) result(picture)
      type(joint_type), intent(in) :: joints(:)
      type(picture_type) :: picture
      integer, allocatable :: steps(:)
      type(text_buffer) :: b
      integer :: i, j

      call state_steps(joints(1), steps)
      picture%caption = 'Contact along the upper face (pressure drawn upwards) and the lower '// &
         'face (drawn downwards): open, sticking and slipping points (Figs 31 to 33). The '// &
         'column face is at 0.'
      allocate (picture%panels(size(steps)*size(joints)))
      do j = 1, size(steps)
         do i = 1, size(joints)
            b = text_buffer()
            associate (displacement => joints(i)%steps(steps(j))%displacement)
               call start_panel(b, trim(legends(i))//', '//to_text(displacement, 4)//' mm', &
                  'place in the tenon (mm)', 'pressure (MPa)', 'left bottom')
            end associate
            call b%line('set arrow from 0, graph 0 to 0, graph 1 nohead dt 3 lc rgb "#404040"')
            call b%line('unset yzeroaxis')
            call b%line('plot '//state_line(i, j, 1, 'open', '#777777', 'pt 6 ps 0.4')//', '// &
               backslash)
            call b%line(state_line(i, j, 2, 'stick', '#D55E00', 'pt 7 ps 0.45')//', '//backslash)
            call b%line(state_line(i, j, 3, 'slip', '#009E73', 'pt 5 ps 0.35'))
            picture%panels(2*(j - 1) + i)%text = b%text()
         end do
      end do
   end function state_picture

   !> Points of one state.
   pure function state_line(model, which, state, legend, colour, mark) result(text)
      integer, intent(in) :: model, which, state
      character(len=*), intent(in) :: legend, colour, mark
      character(len=:), allocatable :: text

      text = state_block(model, which)//' using 1:($3=='//to_text(state)//' ? $2 : NaN) '// &
         'with points '//mark//' lc rgb "'//colour//'" title "'//legend//'"'
   end function state_line

end module asperity_program_commands_tenon_plots
