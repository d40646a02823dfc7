!> Picture of a comparison: expected values as lines, those found as rings, over time.
module asperity_program_commands_compare_plot
   use asperity_base_kinds, only: wp
   use asperity_program_commands_compare_departures, only: departure_type
   use asperity_program_commands_compare_history, only: history_type
   use asperity_program_plot_figure, only: as_points, figure_type, panel_type, ring
   use asperity_program_report_report, only: report_type
   implicit none
   private
   public :: draw_comparison

contains

   !> One panel a unit.
   pure subroutine draw_comparison(report, departures, expected, found)
      !> Its picture is set
      type(report_type), intent(inout) :: report
      !> The columns that were compared
      type(departure_type), intent(in) :: departures(:)
      !> What is expected, and what is found in its rows and columns
      type(history_type), intent(in) :: expected
      real(wp), intent(in) :: found(:, :)
      type(panel_type), allocatable :: panels(:)
      logical :: is_first(size(departures))
      integer :: i, j, n, column

      do i = 1, size(departures)
         is_first(i) = all(departures(:i - 1)%unit /= departures(i)%unit)
      end do
      allocate (panels(count(is_first)))
      n = 0
      do i = 1, size(departures)
         if (.not. is_first(i)) cycle
         n = n + 1
         panels(n) = panel_type('time (s)', axis_text(departures(i)%unit))
         do j = i, size(departures)
            if (departures(j)%unit /= departures(i)%unit) cycle
            column = findloc(expected%names == departures(j)%name, .true., 1)
            call panels(n)%add(expected%time, expected%values(:, column), &
               trim(departures(j)%name)//', expected', j)
            call panels(n)%add(expected%time, found(:, column), 'found', j, as_points, mark=ring)
         end do
      end do
      report%picture_title = 'Expected and found'
      allocate (report%pictures(1))
      report%pictures(1) = figure_type('', panels)
   end subroutine draw_comparison

   !> What the axis on the left is called.
   pure function axis_text(unit) result(text)
      character(len=*), intent(in) :: unit
      character(len=:), allocatable :: text

      select case (unit)
      case ('N')
         text = 'force (N)'
      case ('MPa')
         text = 'stress (MPa)'
      case ('mm')
         text = 'length (mm)'
      case default
         text = 'value'
         if (unit /= '') text = 'value ('//trim(unit)//')'
      end select
   end function axis_text

end module asperity_program_commands_compare_plot
