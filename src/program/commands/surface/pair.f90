!> Two maps of `asperity surface --pair`: each face, the equivalent surface, the gap between them.
module asperity_program_commands_surface_pair
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: height_map
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_maps, only: get_map, prepare_map
   use asperity_program_report_report, only: named_table
   use asperity_program_report_table, only: new_table
   use asperity_program_system_progress, only: show_stage
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: analyse_surface, surface_analysis_type
   use asperity_surface_pair_equivalent_surface, only: combine_values, map_correlation, &
      pair_uncertainties, sum_of_maps
   use asperity_surface_pair_first_touch_gap, only: find_gap, gap_distribution
   use asperity_surface_parameters_parameters, only: n_parameters, p_alpha, p_eta_nayak, p_m0, &
      p_m2, p_m4, p_radius_nayak, p_sigma_nayak, p_sq, parameters
   use asperity_surface_parameters_tile_sums, only: summed
   use asperity_surface_prepare_level, only: level_plane
   implicit none
   private
   public :: analyse_pair

   !> Columns of the table of faces
   integer, parameter :: shown(*) = [p_sq, p_m0, p_m2, p_m4, p_alpha, p_eta_nayak, &
      p_radius_nayak, p_sigma_nayak]
   !> Shares of the area at which the gap is told
   real(wp), parameter :: shares(*) = [0.001_wp, 0.01_wp, 0.05_wp, 0.1_wp, 0.25_wp, 0.5_wp, &
      0.75_wp, 0.9_wp, 0.99_wp]
   !> Correlation above which moments are said not to add
   real(wp), parameter :: correlated = 0.1_wp

contains

   !> Read the second map, analyse both, add them. The first map becomes the sum of both where they
   !> are aligned; where they are not, only squares add.
   subroutine analyse_pair(options, map, analysis, aligned, tables, remarks, error)
      !> The options
      type(surface_options), intent(inout) :: options
      !> The first map, prepared; their sum on return, where they are aligned
      type(height_map), intent(inout) :: map
      !> What was found of the pair
      type(surface_analysis_type), intent(out) :: analysis
      !> Whether there is a sum
      logical, intent(out) :: aligned
      !> Faces, and the gap where there is a sum
      type(named_table), allocatable, intent(out) :: tables(:)
      !> One line each
      type(string_type), allocatable, intent(out) :: remarks(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(error_type), allocatable :: why_not
      type(height_map) :: second, together
      type(surface_analysis_type) :: faces(2)
      real(wp) :: added(n_parameters), correlation

      aligned = .false.
      call get_map(options, options%files(2)%text, second, error)
      if (.not. allocated(error)) call prepare_map(options, second, error)
      if (allocated(second%notes)) then
         if (allocated(map%notes)) second%notes = map%notes//second%notes
         call move_alloc(second%notes, map%notes)
      end if
      if (.not. allocated(error)) &
         call analyse_surface(map, options%analysis, faces(1), error, show_stage)
      if (.not. allocated(error)) &
         call analyse_surface(second, options%analysis, faces(2), error, show_stage)
      if (allocated(error)) return
      call combine_values(summed(faces(1)%sums), summed(faces(2)%sums), &
         options%mirror, added)

      call map_correlation(map, second, options%mirror, correlation, why_not)
      if (allocated(why_not)) then
         analysis%values(:, 1) = added
         call pair_uncertainties(faces(1)%sums, faces(2)%sums, options%mirror, &
            analysis%uncertainty)
         allocate (tables(1), remarks(1))
         tables(1) = face_table(faces, added)
         remarks(1)%text = 'Not aligned: '//why_not%message//'. So only mean squares are '// &
            'added, direction by direction; there is no gap and no route of the paper.'
         return
      end if
      aligned = .true.
      call sum_of_maps(map, second, options%mirror, together, error)
      if (allocated(error)) return
      deallocate (second%heights)
      call move_alloc(together%heights, map%heights)
      map%source = together%source
      call level_plane(map)
      call analyse_surface(map, options%analysis, analysis, error, show_stage)
      if (allocated(error)) return
      allocate (tables(2), remarks(1))
      tables(1) = face_table(faces, added, analysis%values(:, 1))
      call gap_table(map, tables(2), error)
      remarks(1)%text = 'Correlation of the two maps: '//to_text(correlation, 3)//'.'
      if (abs(correlation) > correlated) remarks(1)%text = remarks(1)%text// &
         ' Moments add only without it; the values here are of the sum of the maps.'
   end subroutine analyse_pair

   !> One row each for the two faces, for their squares added, for the sum of their maps.
   pure function face_table(faces, added, together) result(named)
      type(surface_analysis_type), intent(in) :: faces(2)
      real(wp), intent(in) :: added(n_parameters)
      real(wp), intent(in), optional :: together(n_parameters)
      type(named_table) :: named
      character(len=*), parameter :: rows(4) = [character(len=14) :: 'first', 'second', &
         'squares added', 'maps added']
      real(wp), allocatable :: values(:, :)
      integer :: i, n

      n = merge(4, 3, present(together))
      allocate (values(n_parameters, n))
      values(:, 1) = faces(1)%values(:, 1)
      values(:, 2) = faces(2)%values(:, 1)
      values(:, 3) = added
      if (present(together)) values(:, 4) = together
      named%name = 'faces'
      named%title = 'The two faces and the pair'
      named%table = new_table(columns=1 + size(shown), rows=n)
      call named%table%add_texts('face', rows(:n))
      do i = 1, size(shown)
         call named%table%add_numbers(trim(parameters(shown(i))%name), &
            trim(parameters(shown(i))%unit), values(shown(i), :), figures=4)
      end do
   end function face_table

   !> Quantiles of the gap when the faces just touch.
   pure subroutine gap_table(map, named, error)
      type(height_map), intent(in) :: map
      type(named_table), intent(out) :: named
      type(error_type), allocatable, intent(out) :: error
      type(gap_distribution) :: gap

      call find_gap(map, shares, gap, error)
      if (allocated(error)) return
      named%name = 'gap'
      named%title = 'Gap at first touch, mean '//to_text(gap%mean, 4)// &
         ' mm, standard deviation '//to_text(gap%sigma, 4)//' mm'
      named%table = new_table(columns=2, rows=size(shares))
      call named%table%add_numbers('area_share', '-', shares, figures=4)
      call named%table%add_numbers('gap', 'mm', gap%quantiles, figures=4)
   end subroutine gap_table

end module asperity_program_commands_surface_pair
