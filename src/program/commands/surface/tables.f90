!> Tables of `asperity surface`.
module asperity_program_commands_surface_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_height_map_type, only: height_map, missing_points
   use asperity_program_commands_surface_law, only: has_law, route_places, routes
   use asperity_program_report_table, only: column_counts, new_table, table_type
   use asperity_surface_analysis, only: surface_analysis_type
   use asperity_surface_parameters_parameters, only: n_parameters, p_sp, p_summit_plane, parameters
   use asperity_surface_summits_find, only: summit_set
   implicit none
   private
   public :: law_parameters_table, map_table, parameter_table

   !> Figures of a value, and of an uncertainty, on the terminal
   integer, parameter :: value_figures = 4, uncertainty_figures = 2

contains

   !> What the map is, in one row.
   pure function map_table(map, name, summits) result(table)
      !> The map as it was analysed
      type(height_map), intent(in) :: map
      !> Its name
      character(len=*), intent(in) :: name
      !> Its summits
      type(summit_set), intent(in) :: summits
      type(table_type) :: table

      table = new_table(columns=9, rows=1)
      call table%add_texts('map', [name])
      call table%add_texts('format', [map%format])
      call table%add_codes('points_x', column_counts, [size(map%heights, 1)])
      call table%add_codes('points_y', column_counts, [size(map%heights, 2)])
      call table%add_numbers('step_x', 'mm', [map%step_x], figures=value_figures)
      call table%add_numbers('step_y', 'mm', [map%step_y], figures=value_figures)
      call table%add_codes('missing', column_counts, [missing_points(map)])
      call table%add_codes('summits', column_counts, [size(summits%height)])
      call table%add_codes('peaks', column_counts, [count(summits%is_peak)])
   end function map_table

   !> One row a parameter: value, half width of its 95 % interval, and the values at multiples of
   !> the step.
   pure function parameter_table(analysis, only_known) result(table)
      !> What was found
      type(surface_analysis_type), intent(in) :: analysis
      !> Leave parameters without value out, which profiles do not give
      logical, intent(in) :: only_known
      type(table_type) :: table
      integer, allocatable :: rows(:)
      integer :: i

      rows = pack([(i, i=1, n_parameters)], .not. (only_known .and. is_none(analysis%values(:, 1))))
      table = new_table(columns=7, rows=size(rows), leading=2)
      call table%add_texts('parameter', parameters(rows)%name)
      call table%add_texts('unit', parameters(rows)%unit)
      call table%add_numbers('value', '-', analysis%values(rows, 1), figures=value_figures)
      call table%add_numbers('uncertainty', '-', analysis%uncertainty(rows), &
         figures=uncertainty_figures)
      call table%add_numbers('step_2', '-', analysis%values(rows, 2), figures=value_figures)
      call table%add_numbers('step_4', '-', analysis%values(rows, 3), figures=value_figures)
      call table%add_texts('meaning', parameters(rows)%meaning)
   end function parameter_table

   !> What the law takes, one row a route, and where the map lies.
   pure function law_parameters_table(analysis) result(table)
      !> What was found
      type(surface_analysis_type), intent(in) :: analysis
      type(table_type) :: table
      real(wp) :: three(3, size(routes)), spread(3, size(routes)), number(size(routes))
      integer :: i

      associate (values => analysis%values(:, 1))
         do i = 1, size(routes)
            three(:, i) = values(route_places(routes(i)))
            spread(:, i) = analysis%uncertainty(route_places(routes(i)))
            number(i) = none
            if (has_law(values, routes(i))) number(i) = product(three(:, i))
         end do
         table = new_table(columns=10, rows=size(routes))
         call table%add_texts('route', routes)
         call add_pair(table, 'eta', '1/mm^2', three(1, :), spread(1, :))
         call add_pair(table, 'radius', 'mm', three(2, :), spread(2, :))
         call add_pair(table, 'sigma', 'mm', three(3, :), spread(3, :))
         call table%add_numbers('roughness_number', '-', number, figures=value_figures)
         call table%add_numbers('summit_plane', 'mm', both(values(p_summit_plane)), &
            figures=value_figures)
         call table%add_numbers('first_touch', 'mm', both(first_touch(values)), &
            figures=value_figures)
      end associate
   end function law_parameters_table

   !> A column of values and that of their uncertainties.
   pure subroutine add_pair(table, name, unit, values, uncertainty)
      type(table_type), intent(inout) :: table
      character(len=*), intent(in) :: name, unit
      real(wp), intent(in) :: values(:), uncertainty(:)

      call table%add_numbers(name, unit, values, figures=value_figures)
      call table%add_numbers(name//'_uncertainty', unit, uncertainty, figures=uncertainty_figures)
   end subroutine add_pair

   !> Separation, from the summit mean plane, at which the highest point touches.
   pure real(wp) function first_touch(values)
      real(wp), intent(in) :: values(:)

      first_touch = none
      if (.not. is_none(max(values(p_summit_plane), values(p_sp)))) &
         first_touch = values(p_sp) - values(p_summit_plane)
   end function first_touch

   !> The same for either route.
   pure function both(value) result(values)
      real(wp), intent(in) :: value
      real(wp) :: values(size(routes))

      values = value
   end function both

end module asperity_program_commands_surface_tables
