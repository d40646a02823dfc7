!> The picture of a replay.
module asperity_program_commands_replay_plot
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_contact_state, only: no_surface_limit
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_plot_figure, only: as_points, figure_type, panel_type, ring
   use asperity_program_plot_palette, only: black, blue, red
   use asperity_program_report_report, only: report_type
   use asperity_replay_motion_path, only: motion_path, traction_names
   implicit none
   private
   public :: draw_replay

   !> Evenly spaced points of a series that are drawn
   integer, parameter :: most_points = 2000
   integer, parameter :: colours(3) = [black, blue, red]

contains

   !> Pressure over overclosure, shear stresses over their slips, and all of them over time, with
   !> rings where something is expected.
   pure subroutine draw_replay(report, path)
      !> With its table; its picture is set
      type(report_type), intent(inout) :: report
      !> The motion
      type(motion_path), intent(in) :: path
      type(panel_type) :: panels(4)
      real(wp) :: overclosure(size(path%time))
      integer, allocatable :: rows(:)
      integer :: i, column

      allocate (rows, source=report%selected_rows(most_points))
      overclosure = merge(path%overclosure, none, path%overclosure > no_surface_limit)
      panels(1) = panel_type('overclosure (mm)', 'pressure (MPa)')
      panels(2) = panel_type('slip (mm)', 'shear stress (MPa)')
      panels(3) = panel_type('time (s)', 'pressure (MPa)')
      panels(4) = panel_type('time (s)', 'shear stress (MPa)')
      do i = 1, size(traction_names)
         column = report%table%find(trim(traction_names(i)))
         if (column == 0) cycle
         associate (found => report%table%columns(column)%values(rows))
            if (i == 1) then
               call add(panels(1), path, i, rows, overclosure(rows), found)
               call add(panels(3), path, i, rows, path%time(rows), found)
            else
               call add(panels(2), path, i, rows, path%slip(i - 1, rows), found)
               call add(panels(4), path, i, rows, path%time(rows), found)
            end if
         end associate
      end do
      report%picture_title = picture_title(report, 'Replay')
      allocate (report%pictures(1))
      report%pictures(1) = figure_type('', panels)
   end subroutine draw_replay

   !> One traction, and what is expected of it.
   pure subroutine add(panel, path, which, rows, x, found)
      type(panel_type), intent(inout) :: panel
      type(motion_path), intent(in) :: path
      integer, intent(in) :: which, rows(:)
      real(wp), intent(in) :: x(:), found(:)

      call panel%add(x, found, trim(traction_names(which)), colours(which))
      if (path%has_expected(which)) call panel%add(x, path%expected(which, rows), &
         trim(traction_names(which))//', expected', colours(which), as_points, mark=ring)
   end subroutine add

end module asperity_program_commands_replay_plot
