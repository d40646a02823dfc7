!> The law with the parameters of a map against separation: the Gaussian integral, and the sum over
!> the summits of the map.
module asperity_program_commands_surface_verify
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_paper_wood, only: wood_strength_across
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_law, only: has_law, law_faces, routes
   use asperity_program_report_report, only: named_table
   use asperity_program_report_table, only: new_table, table_type
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: surface_analysis_type
   use asperity_surface_pair_law_on_summits, only: sum_over_summits, summit_curve
   use asperity_surface_parameters_parameters, only: p_summit_plane
   implicit none
   private
   public :: law_curves, add_summit_curve, take_summits, unloading_table

   !> Pressures at which the remarks compare, MPa: the paper's shear test, and the strength fc90
   real(wp), parameter :: pressures(2) = [0.2_wp, wood_strength_across]
   !> Shares of the larger one at which they are compared on the way back
   real(wp), parameter :: shares(*) = [1.0_wp, 0.5_wp, 0.2_wp, 0.05_wp, 0.01_wp]

contains

   !> Pressure of the Gaussian law by both routes, at the separations of the settings.
   pure subroutine law_curves(options, values, table)
      !> The options after `set_law`
      type(surface_options), intent(in) :: options
      !> Parameters of the map
      real(wp), intent(in) :: values(:)
      !> One row a separation
      type(table_type), intent(out) :: table
      type(faces_type) :: law
      type(normal_properties) :: properties
      type(normal_response), allocatable :: response(:)
      type(error_type), allocatable :: error
      real(wp), allocatable :: pressure(:)
      integer :: i

      associate (separation => options%separation)
         table = new_table(columns=11, rows=size(separation))
         call table%add_numbers('separation', 'mm', separation)
         call table%add_numbers('separation_surface', 'mm', separation + values(p_summit_plane))
         call table%add_numbers('overclosure', 'mm', options%faces%initial_separation &
            - separation)
         allocate (pressure(size(separation)), response(size(separation)))
         do i = 1, size(routes)
            pressure = none
            if (has_law(values, routes(i))) then
               law = law_faces(options, values, routes(i))
               call law%normal(properties, error)
               if (.not. allocated(error)) then
                  response = evaluate_normal_law(properties, separation)
                  pressure = response%pressure
               end if
            end if
            call table%add_numbers('pressure_'//routes(i), 'MPa', pressure)
         end do
      end associate
   end subroutine law_curves

   !> Append the sums over the summits to a table of `law_curves`, and say in words how they
   !> compare. The paper's route takes the peaks of spd, Nayak's all summits.
   pure subroutine add_summit_curve(table, analysis, properties, route, remarks, error)
      !> The table
      type(table_type), intent(inout) :: table
      !> What was found on the map
      type(surface_analysis_type), intent(in) :: analysis
      !> The law by the route
      type(normal_properties), intent(in) :: properties
      !> One of `routes`
      character(len=*), intent(in) :: route
      !> One line each
      type(string_type), allocatable, intent(out) :: remarks(:)
      !> Set when there are no summits
      type(error_type), allocatable, intent(out) :: error
      type(summit_curve) :: curve
      real(wp), allocatable :: heights(:), curvatures(:)
      real(wp) :: separations(size(pressures))
      character(len=:), allocatable :: what
      integer :: i

      what = 'peaks'
      if (route == 'nayak') what = 'summits'
      call take_summits(analysis, route, heights, curvatures)
      call sum_over_summits(properties, heights, curvatures, analysis%area, &
         table%columns(1)%values, curve, error)
      if (allocated(error)) return
      call table%add_numbers('pressure_summits', 'MPa', curve%mean_radius)
      call table%add_numbers('pressure_summits_error', 'MPa', curve%mean_radius_error)
      call table%add_numbers('pressure_own_radii', 'MPa', curve%own_radius)
      call table%add_numbers('pressure_own_radii_error', 'MPa', curve%own_radius_error)
      call table%add_numbers('contact_density', '1/mm^2', curve%contact_density)
      call table%add_numbers('gaussian_density', '1/mm^2', curve%gaussian_density)

      do i = 1, size(pressures)
         call separation_for_pressure(properties, pressures(i), separations(i), error)
         if (allocated(error)) return
      end do
      call sum_over_summits(properties, heights, curvatures, analysis%area, separations, curve, &
         error)
      if (allocated(error)) return
      allocate (remarks(size(pressures) + merge(1, 0, curve%without_radius > 0)))
      do i = 1, size(pressures)
         remarks(i)%text = 'Where the Gaussian law gives '//to_text(pressures(i), 3)// &
            ' MPa, the sum over the '//to_text(size(heights))//' '//what//' of the map gives '// &
            with_error(curve%mean_radius(i), curve%mean_radius_error(i))// &
            ' with the radius of the route, '// &
            with_error(curve%own_radius(i), curve%own_radius_error(i))//' with the own radii.'
      end do
      if (curve%without_radius > 0) remarks(size(remarks))%text = to_text(curve%without_radius)// &
         ' of them have no curvature above zero and take the radius of the route.'
   end subroutine add_summit_curve

   !> The same for faces that were pressed and part again, with memory, at retractions where the
   !> law gives some shares of the pressure that they were pressed to.
   pure subroutine unloading_table(named, analysis, properties, route, error)
      !> The table
      type(named_table), intent(out) :: named
      !> What was found on the map
      type(surface_analysis_type), intent(in) :: analysis
      !> The law by the route
      type(normal_properties), intent(in) :: properties
      !> One of `routes`
      character(len=*), intent(in) :: route
      !> Set when there are no summits
      type(error_type), allocatable, intent(out) :: error
      type(summit_curve) :: curve
      real(wp), allocatable :: heights(:), curvatures(:)
      real(wp) :: closest, retractions(size(shares))
      integer :: i

      call separation_for_pressure(properties, pressures(2), closest, error)
      if (allocated(error)) return
      retractions(1) = 0.0_wp
      do i = 2, size(shares)
         retractions(i) = retraction_for_pressure(properties, closest, shares(i)*pressures(2))
      end do
      call take_summits(analysis, route, heights, curvatures)
      call sum_over_summits(properties, heights, curvatures, analysis%area, closest + retractions, &
         curve, error, closest)
      if (allocated(error)) return
      named%name = 'unloading'
      named%title = 'Pressed to '//to_text(pressures(2), 3)//' MPa of the Gaussian law and '// &
         'released, with memory'
      named%table = new_table(columns=8, rows=size(shares))
      associate (table => named%table)
         call table%add_numbers('separation', 'mm', curve%separation)
         call table%add_numbers('retraction', 'mm', retractions)
         call table%add_numbers('pressure_'//trim(route), 'MPa', curve%gaussian)
         call table%add_numbers('pressure_summits', 'MPa', curve%mean_radius)
         call table%add_numbers('pressure_summits_error', 'MPa', curve%mean_radius_error)
         call table%add_numbers('pressure_own_radii', 'MPa', curve%own_radius)
         call table%add_numbers('contact_density', '1/mm^2', curve%contact_density)
         call table%add_numbers('gaussian_density', '1/mm^2', curve%gaussian_density)
      end associate
   end subroutine unloading_table

   !> The peaks that the paper's route takes, or all summits for Nayak's.
   pure subroutine take_summits(analysis, route, heights, curvatures)
      !> What was found on the map
      type(surface_analysis_type), intent(in) :: analysis
      !> One of `routes`
      character(len=*), intent(in) :: route
      !> Heights above the summit mean plane, mm, and curvatures, 1/mm
      real(wp), allocatable, intent(out) :: heights(:), curvatures(:)
      logical, allocatable :: taken(:)

      associate (summits => analysis%summits)
         allocate (taken, source=summits%is_peak .or. route == 'nayak')
         heights = pack(summits%height, taken) - analysis%values(p_summit_plane, 1)
         curvatures = pack(summits%curvature, taken)
      end associate
   end subroutine take_summits

   !> A value and its standard error.
   pure function with_error(value, error) result(text)
      real(wp), intent(in) :: value, error
      character(len=:), allocatable :: text

      text = to_text(value, 3)//' MPa (standard error '//to_text(error, 2)//')'
   end function with_error

end module asperity_program_commands_surface_verify
