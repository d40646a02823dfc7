!> `asperity surface`: from a height map to the parameters of the law.
module asperity_program_commands_surface_command
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_height_map_type, only: height_map, note_end
   use asperity_height_map_write, only: height_map_bytes
   use asperity_law_normal_properties, only: normal_properties
   use asperity_program_commands_surface_law, only: has_law, set_law, surface_case
   use asperity_program_commands_surface_maps, only: check_map_options, get_map, prepare_map
   use asperity_program_commands_surface_pair, only: analyse_pair
   use asperity_program_commands_surface_plot, only: surface_picture
   use asperity_program_commands_surface_tables, only: law_parameters_table, map_table, &
      parameter_table
   use asperity_program_commands_surface_verdict, only: surface_verdict
   use asperity_program_commands_surface_verify, only: add_summit_curve, law_curves
   use asperity_program_input_keys, only: command_surface, find_key
   use asperity_program_input_settings, only: settings_type
   use asperity_program_report_report, only: named_table, report_type
   use asperity_program_report_table, only: new_table
   use asperity_program_system_progress, only: clear_steps, show_stage
   use asperity_program_system_strings, only: lower_case, quoted, string_type
   use asperity_surface_analysis, only: analyse_surface, analysis_settings, most_tiles, &
      surface_analysis_type
   use asperity_surface_prepare_fill_holes, only: missing_share
   use asperity_surface_remarks_on_analysis, only: find_remarks, map_facts, remark_type
   implicit none
   private
   public :: report_surface

contains

   !> Read or make the map, analyse it, and report. `error` names the option or the file.
   subroutine report_surface(report, error)
      !> Its settings on entry, its tables on return
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(height_map) :: map
      type(surface_analysis_type) :: analysis
      type(analysis_settings) :: how
      type(named_table), allocatable :: more(:)
      type(string_type), allocatable :: notes(:)
      real(wp) :: filled
      logical :: has_map

      has_map = .true.
      filled = 0.0_wp
      call check_map_options(report%settings, error)
      if (.not. allocated(error)) call get_map(report%settings, 'map_file', map, error)
      if (.not. allocated(error)) then
         if (report%settings%text_of('missing') == 'fill') filled = missing_share(map)
         call prepare_map(report%settings, map, error)
      end if
      if (.not. allocated(error)) then
         how%pruning = report%settings%real_of('pruning')
         call fit_tiles(report%settings, map)
         how%tiles = report%settings%whole_of('tiles')
         if (report%settings%of(find_key('pair', command_surface))%switch) then
            call analyse_pair(report%settings, how, map, analysis, has_map, more, &
               report%remarks, error)
         else
            allocate (more(0), report%remarks(0))
            call analyse_surface(map, how, analysis, error, show_stage)
         end if
      end if
      if (.not. allocated(error) .and. .not. has_map) &
         call refuse_without_map(report%settings, error)
      call clear_steps()
      if (allocated(error)) return

      if (has_map) call add_remarks(report, map, analysis, filled, how%tiles)
      call map_notes(map, notes)
      report%remarks = [notes, report%remarks]
      report%summary = law_parameters_table(analysis)
      report%table = parameter_table(analysis)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%shows_table = .false.
      allocate (report%more(size(more) + 3))
      report%more(4:) = more
      report%more([1, 3]) = named_table('', '', new_table(columns=0, rows=0))
      if (has_map) report%more(1) = named_table('map', 'The map', &
         map_table(map, title(map), analysis%summits))
      report%more(2) = named_table('', 'Parameters; half widths of 95 % intervals; values of '// &
         'every second and every fourth point', report%table, columns_shown=6)
      call add_law(report, map, analysis, error)
   end subroutine report_surface

   !> The law with the parameters of the map, and what is made of it: curve, case, picture, map.
   subroutine add_law(report, map, analysis, error)
      type(report_type), intent(inout) :: report
      type(height_map), intent(in) :: map
      type(surface_analysis_type), intent(in) :: analysis
      type(error_type), allocatable, intent(out) :: error
      type(normal_properties) :: properties
      type(string_type), allocatable :: remarks(:)
      character(len=:), allocatable :: route
      logical :: verifies

      route = report%settings%text_of('route')
      verifies = report%settings%switch_of('verify')
      allocate (report%decks(2))
      report%decks%option = [character(len=8) :: 'case', 'map']
      if (report%settings%given('map')) then
         call show_stage('writing the map')
         call height_map_bytes(map, ending(report%settings%text_of('map')), &
            report%decks(2)%text, error)
         if (allocated(error)) error%message = '--map: '//error%message
         if (allocated(error)) return
      end if
      associate (values => analysis%values(:, 1), s => report%settings)
         if (has_law(values, route)) then
            call set_law(s, values, route, properties, error)
            if (allocated(error)) return
            report%decks(1)%text = surface_case(s, values, analysis%uncertainty, route)
            report%more(3)%name = 'law'
            call law_curves(s, values, report%more(3)%table)
         else if (verifies .or. s%given('case')) then
            call refuse_law(title(map), route, error)
            return
         end if
         if (verifies) then
            call show_stage('summing the law over summits')
            call add_summit_curve(report%more(3)%table, analysis, properties, route, remarks, error)
            if (allocated(error)) return
            report%more(3)%columns_shown = 9
            report%more(3)%title = 'The law on this map: Gaussian integral by either route, '// &
               'and sums over its summits (route '//route//')'
            report%remarks = [report%remarks, remarks]
         end if
         report%verdict = surface_verdict(s, analysis, route)
         if (.not. report%is_drawn()) return
         report%picture_title = title(map)
         report%pictures = [surface_picture(map, values, &
            pack(analysis%summits%height, analysis%summits%is_peak .or. route == 'nayak'), &
            report%more(3)%table)]
      end associate
   end subroutine add_law

   !> Fewer tiles than the default on a map too small for it.
   pure subroutine fit_tiles(settings, map)
      type(settings_type), intent(inout) :: settings
      type(height_map), intent(in) :: map

      associate (tiles => settings%of(find_key('tiles')))
         if (tiles%given .or. most_tiles(map) >= tiles%whole) return
         tiles%whole = most_tiles(map)
         tiles%source = 'as many as the map allows'
      end associate
   end subroutine fit_tiles

   !> What is to be said of the map and its parameters.
   pure subroutine add_remarks(report, map, analysis, filled, tiles)
      type(report_type), intent(inout) :: report
      type(height_map), intent(in) :: map
      type(surface_analysis_type), intent(in) :: analysis
      real(wp), intent(in) :: filled
      integer, intent(in) :: tiles
      type(map_facts) :: facts
      type(remark_type), allocatable :: found(:)
      type(string_type), allocatable :: lines(:)
      integer :: i

      facts%filled = filled
      facts%points = shape(map%heights)
      facts%top = map_place(map, maxloc(map%heights, mask=.not. is_none(map%heights)))
      facts%bottom = map_place(map, minloc(map%heights))
      facts%step_x = map%step_x
      facts%step_y = map%step_y
      if (tiles > 1) then
         facts%tile_x = map%step_x*real(size(map%heights, 1)/tiles, wp)
         facts%tile_y = map%step_y*real(size(map%heights, 2)/tiles, wp)
      end if
      facts%peaks = real(count(analysis%summits%is_peak), wp)
      ! gfortran warns otherwise of what is intent(out) anyway
      allocate (found(0))
      call find_remarks(analysis%values(:, 1), analysis%uncertainty, facts, &
         report%settings%text_of('route'), found, analysis%values(:, 2))
      allocate (lines(size(found)))
      do i = 1, size(found)
         lines(i)%text = found(i)%text
      end do
      report%remarks = [lines, report%remarks]
   end subroutine add_remarks

   !> What the readers had to say of the map.
   pure subroutine map_notes(map, notes)
      type(height_map), intent(in) :: map
      type(string_type), allocatable, intent(out) :: notes(:)
      integer :: finish, i, start

      if (.not. allocated(map%notes)) then
         allocate (notes(0))
         return
      end if
      allocate (notes(count([(map%notes(i:i) == note_end, i=1, len(map%notes))])))
      start = 1
      do i = 1, size(notes)
         finish = start - 1 + index(map%notes(start:), note_end)
         notes(i)%text = map%notes(start:finish - 1)
         start = finish + 1
      end do
   end subroutine map_notes

   !> Coordinates of a point.
   pure function map_place(map, point) result(place)
      type(height_map), intent(in) :: map
      integer, intent(in) :: point(2)
      real(wp) :: place(2)

      place = real(point - 1, wp)*[map%step_x, map%step_y]
   end function map_place

   !> Where the map comes from.
   pure function title(map) result(text)
      type(height_map), intent(in) :: map
      character(len=:), allocatable :: text

      text = quoted(map%source(index(map%source, '/', back=.true.) + 1:))
      text = text(2:len(text) - 1)
   end function title

   !> The end of a file's name after its last point, in lower case.
   pure function ending(path) result(text)
      character(len=*), intent(in) :: path
      character(len=:), allocatable :: text

      text = lower_case(path(index(path, '.', back=.true.) + 1:))
   end function ending

   !> Refuse what needs the maps of a pair to be aligned.
   pure subroutine refuse_without_map(settings, error)
      type(settings_type), intent(in) :: settings
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: names(3) = [character(len=6) :: 'verify', 'plot', 'map']
      integer :: i

      do i = 1, size(names)
         if (.not. settings%given(trim(names(i)))) cycle
         call fatal_error(error, '--'//trim(names(i))//': needs maps of the same points and '// &
            'steps, which these are not')
         return
      end do
      if (settings%given('case') .and. settings%text_of('route') == 'paper') &
         call fatal_error(error, '--case: route paper needs maps of the same points and steps, '// &
         'which these are not; --route nayak adds their moments')
   end subroutine refuse_without_map

   !> Refuse a law without parameters.
   pure subroutine refuse_law(name, route, error)
      character(len=*), intent(in) :: name, route
      type(error_type), allocatable, intent(out) :: error

      if (route == 'paper') then
         call fatal_error(error, name//': no peak is left after pruning, so route paper has no '// &
            'eta and radius for --case and --verify; lower --pruning or take a larger map', &
            computation_error)
      else
         call fatal_error(error, name//': no slope or curvature in some direction, so route '// &
            'nayak has no eta and radius for --case and --verify; try --route paper', &
            computation_error)
      end if
   end subroutine refuse_law

end module asperity_program_commands_surface_command
