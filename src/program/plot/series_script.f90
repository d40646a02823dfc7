!> A series of a panel as data and style of gnuplot.
module asperity_program_plot_series_script
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_plot_figure, only: as_band, as_bars, as_boxes, as_line, &
      as_line_and_points, as_points, as_steps, series_type
   use asperity_program_plot_palette, only: palette
   use asperity_program_system_strings, only: escaped
   implicit none
   private
   public :: add_data, style, label

   !> gnuplot's numbers of disc, ring, block, box and cross, and their sizes
   integer, parameter :: marks(5) = [7, 6, 5, 4, 2]
   real(wp), parameter :: mark_sizes(5) = [0.5_wp, 1.0_wp, 0.5_wp, 0.9_wp, 1.4_wp]

contains

   !> Data block of a series.
   pure subroutine add_data(b, series, which)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The series
      type(series_type), intent(in) :: series
      !> Its number
      integer, intent(in) :: which
      integer :: i

      call b%line('$data'//to_text(which)//' << EOD')
      do i = 1, size(series%x)
         call b%add(number(series%x(i))//number(series%y(i)))
         ! half of a box lies on each side
         if (allocated(series%sizes)) &
            call b%add(number(0.5_wp*series%sizes(1, i))//number(0.5_wp*series%sizes(2, i)))
         if (allocated(series%z)) call b%add(number(series%z(i)))
         call b%line()
      end do
      call b%line('EOD')
   end subroutine add_data

   pure function number(value) result(text)
      real(wp), intent(in) :: value
      character(len=17) :: text

      text = ' NaN'
      if (.not. is_none(value)) write (text, '(es17.8e3)') value
   end function number

   !> How a series is drawn, after its data.
   pure function style(series) result(text)
      !> The series
      type(series_type), intent(in) :: series
      character(len=:), allocatable :: text

      associate (points => ' pt '//to_text(marks(series%mark))//' ps '// &
            to_text(mark_sizes(series%mark), 3), strokes => ' lw 1.6 dt '//to_text(series%stroke))
         select case (series%form)
         case (as_line)
            text = '1:2 with lines'//strokes
         case (as_points)
            text = '1:2 with points'//points
         case (as_line_and_points)
            text = '1:2 with linespoints'//strokes//points
         case (as_bars)
            text = '1:2 with impulses lw 3'
         case (as_steps)
            text = '1:2 with histeps'//strokes
         case (as_band)
            text = '1:3:2 with filledcurves fillstyle solid 0.6 noborder'
         case (as_boxes)
            if (allocated(series%z)) then
               text = '1:2:3:4:5 with boxxyerror fillstyle solid noborder lc palette notitle'
               return
            end if
            text = '1:2:3:4 with boxxyerror fillstyle solid noborder'
         case default
            text = '1:2:3 with image notitle'
            return
         end select
      end associate
      text = text//' lc rgb "'//palette(series%colour)//'"'
      if (series%right) text = text//' axes x1y2'
      if (series%legend == '') then
         text = text//' notitle'
      else
         text = text//' title '//label(series%legend)
      end if
   end function style

   !> A text, perhaps of the user, in single quotes, in which gnuplot substitutes nothing.
   pure function label(text) result(quoted)
      !> The text
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: quoted
      integer :: i

      quoted = text
      do i = 1, len(quoted)
         if (iachar(quoted(i:i)) < 32) quoted(i:i) = '?'
      end do
      quoted = "'"//escaped(quoted, "'", "''")//"'"
   end function label

end module asperity_program_plot_series_script
