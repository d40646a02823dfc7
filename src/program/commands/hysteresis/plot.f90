!> Picture of a record as a gnuplot script: loops with skeleton, stiffness, energy, damping.
module asperity_program_commands_hysteresis_plot
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: hysteresis_result, hysteresis_skeleton, negative_side, &
      positive_side
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_system_strings, only: backslash, escaped, string_type
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: write_script, write_loops_script, start_sheet

   !> Samples of the record that are drawn, besides the peaks
   integer, parameter :: most_samples = 5000
   !> Points of a skeleton that are marked
   integer, parameter :: most_marks = 60
   !> Colours that colour-blind people can tell apart (Okabe and Ito)
   character(len=*), parameter :: sky = 'lc rgb "#56B4E9"', blue = 'lc rgb "#0072B2"', &
      red = 'lc rgb "#D55E00"', green = 'lc rgb "#009E73"', black = 'lc rgb "#000000"'

contains

   !> The picture of a record.
   pure subroutine write_script(displacement, force, result, labels, script, error)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> The picture
      character(len=:), allocatable, intent(out) :: script
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(string_type) :: lines(2)
      type(text_buffer) :: b

      call add_record(b, displacement, force, result)
      call add_skeletons(b, result)
      call add_cycles(b, result)
      call b%add(start_sheet(labels%title, 4))
      call add_loops_panel(b, result, labels)
      call b%line('set xrange [0:*]')
      call b%line('set yrange [0:*]')
      lines(1)%text = '$cycles using 2:3 with points pt 7 ps 0.9 '//blue//' notitle'
      call add_panel(b, 'mean of the two peaks ('//labels%x_unit//')', &
         'secant stiffness ('//labels%stiffness_unit()//')', lines(:1))
      call b%line('set xrange [*:*]')
      call b%line('set yrange [*:*]')
      call b%line('set offsets 0.5, 0.5, graph 0.04, graph 0.04')
      lines(1)%text = '$cycles using 1:5 with linespoints lw 2 pt 7 ps 0.7 '//blue// &
         " title 'cumulative'"
      lines(2)%text = '$cycles using 1:4 with impulses lw 3 '//red//" title 'of the cycle'"
      call add_panel(b, 'cycle', 'energy ('//labels%energy_unit()//')', lines)
      if (any(.not. is_none(result%cycles%damping))) then
         lines(1)%text = '$cycles using 1:6 with linespoints lw 2 pt 7 ps 0.7 '//blue// &
            " title 'viscous damping'"
         lines(2)%text = '$cycles using 1:7 with linespoints lw 2 pt 5 ps 0.7 '//green// &
            " title 'pinching'"
         call add_panel(b, 'cycle', 'ratio', lines)
      else
         call b%line('unset tics')
         call b%line('unset offsets')
         call b%line('unset grid')
         lines(1)%text = "[0:1][0:1] 2 with lines lc rgb '#ffffff' "// &
            "title 'no damping: no closed cycle'"
         call add_panel(b, '', '', lines(:1))
      end if
      call b%line('unset multiplot')
      call b%take(script, error)
   end subroutine write_script

   !> The loops of one test as a panel of a sheet of several.
   pure subroutine write_loops_script(displacement, force, result, labels, script, error)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> What was found in it
      type(hysteresis_result), intent(in) :: result
      !> Names and units; the title is that of the panel
      type(record_labels), intent(in) :: labels
      !> The picture
      character(len=:), allocatable, intent(out) :: script
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(text_buffer) :: b

      call add_record(b, displacement, force, result)
      call add_skeletons(b, result)
      call b%line('set title '//label(labels%title))
      call add_loops_panel(b, result, labels)
      call b%take(script, error)
   end subroutine write_loops_script

   !> The beginning of a sheet of panels, which ends with `unset multiplot`.
   pure function start_sheet(title, panels) result(script)
      !> Its title
      character(len=*), intent(in) :: title
      !> How many panels there will be
      integer, intent(in) :: panels
      character(len=:), allocatable :: script
      type(text_buffer) :: b
      integer :: columns

      columns = ceiling(sqrt(real(panels, wp)))
      call b%line('set multiplot layout '//to_text((panels - 1)/columns + 1)//','// &
         to_text(columns)//' title '//label(title))
      call b%line('set key tmargin center horizontal')
      call b%line('set offsets graph 0.03, graph 0.03, graph 0.04, graph 0.04')
      script = b%text()
   end function start_sheet

   !> Loops, skeletons, yield and ultimate points.
   pure subroutine add_loops_panel(b, result, labels)
      type(text_buffer), intent(inout) :: b
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      type(string_type) :: lines(4)
      integer :: n

      lines(1)%text = '$record using 1:2 with lines lw 1 '//sky//" title 'record'"
      lines(2)%text = '$skeleton using 1:2 with linespoints lw 2 pt 7 ps 0.5 '//red// &
         " title 'skeleton'"
      ! points of a record that is its own skeleton would hide it
      if (maxval([size(result%skeleton(1)%force), size(result%skeleton(2)%force)]) > most_marks) &
         lines(2)%text = '$skeleton using 1:2 with lines lw 2 '//red//" title 'skeleton'"
      n = 2
      if (any(.not. is_none(result%skeleton%yield_force))) then
         n = n + 1
         lines(n)%text = '$points using 1:2 with points pt 6 ps 1.3 lw 2 '//black//" title 'yield'"
      end if
      if (any(.not. is_none(result%skeleton%ultimate_force))) then
         n = n + 1
         lines(n)%text = '$points using 3:4 with points pt 2 ps 1.3 lw 2 '//black// &
            " title 'ultimate'"
      end if
      call add_panel(b, labels%x//' ('//labels%x_unit//')', labels%f//' ('//labels%f_unit//')', &
         lines(:n))
   end subroutine add_loops_panel

   !> One panel.
   pure subroutine add_panel(b, x_label, y_label, lines)
      type(text_buffer), intent(inout) :: b
      character(len=*), intent(in) :: x_label, y_label
      type(string_type), intent(in) :: lines(:)
      integer :: i

      call b%line('set xlabel '//label(x_label))
      call b%line('set ylabel '//label(y_label))
      call b%add('plot ')
      do i = 1, size(lines) - 1
         call b%line(lines(i)%text//', '//backslash)
      end do
      call b%line(lines(size(lines))%text)
   end subroutine add_panel

   !> A text of the user in single quotes, in which gnuplot substitutes nothing.
   pure function label(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: quoted
      integer :: i

      quoted = text
      do i = 1, len(quoted)
         if (iachar(quoted(i:i)) < 32) quoted(i:i) = '?'
      end do
      quoted = "'"//escaped(quoted, "'", "''")//"'"
   end function label

   !> Evenly spaced samples and all turning points of the record.
   pure subroutine add_record(b, displacement, force, result)
      type(text_buffer), intent(inout) :: b
      real(wp), intent(in) :: displacement(:), force(:)
      type(hysteresis_result), intent(in) :: result
      integer :: i, step, turn

      step = max(1, size(force)/most_samples)
      turn = 1
      call b%line('$record << EOD')
      do i = 1, size(force)
         if (turn <= size(result%turning_points)) then
            if (result%turning_points(turn) == i) then
               turn = turn + 1
               call b%numbers([displacement(i), force(i)])
               cycle
            end if
         end if
         if (modulo(i - 1, step) == 0 .or. i == size(force)) &
            call b%numbers([displacement(i), force(i)])
      end do
      call b%line('EOD')
   end subroutine add_record

   !> Both skeletons through the origin, and the yield and ultimate point of each.
   pure subroutine add_skeletons(b, result)
      type(text_buffer), intent(inout) :: b
      type(hysteresis_result), intent(in) :: result
      integer :: i

      call b%line('$skeleton << EOD')
      associate (n => result%skeleton(negative_side), p => result%skeleton(positive_side))
         do i = size(n%force), 1, -1
            call b%numbers([n%displacement(i), n%force(i)])
         end do
         call b%numbers([0.0_wp, 0.0_wp])
         do i = 1, size(p%force)
            call b%numbers([p%displacement(i), p%force(i)])
         end do
      end associate
      call b%line('EOD')
      call b%line('$points << EOD')
      do i = positive_side, negative_side
         associate (s => result%skeleton(i))
            call b%numbers([s%yield_displacement, s%yield_force, s%ultimate_displacement, &
               s%ultimate_force])
         end associate
      end do
      call b%line('EOD')
   end subroutine add_skeletons

   !> Number, amplitude, stiffness, energy, cumulative energy, damping, pinching of each cycle.
   pure subroutine add_cycles(b, result)
      type(text_buffer), intent(inout) :: b
      type(hysteresis_result), intent(in) :: result
      integer :: i
      logical :: there(2)

      call b%line('$cycles << EOD')
      do i = 1, size(result%cycles)
         associate (c => result%cycles(i))
            there = c%peak > 0
            call b%add(to_text(i))
            call b%numbers([sum(abs(c%displacement), mask=there)/max(1, count(there)), &
               c%secant_stiffness, c%energy, c%cumulative_energy, c%damping, c%pinching])
         end associate
      end do
      call b%line('EOD')
   end subroutine add_cycles

end module asperity_program_commands_hysteresis_plot
