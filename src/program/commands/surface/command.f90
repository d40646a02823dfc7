!> `asperity surface`: from a height map to the parameters of the law.
module asperity_program_commands_surface_command
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_height_map_type, only: height_map
   use asperity_height_map_write, only: height_map_bytes
   use asperity_law_normal_properties, only: normal_properties
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_law, only: has_law, law_faces, set_law, surface_case
   use asperity_program_commands_surface_maps, only: check_map_options, get_map, prepare_map
   use asperity_program_commands_surface_pair, only: analyse_pair
   use asperity_program_commands_surface_plot, only: surface_picture
   use asperity_program_commands_surface_profiles, only: analyse_files, settle_kind
   use asperity_program_commands_surface_remarks, only: add_heights_remark, add_remarks, &
      map_notes
   use asperity_program_commands_surface_tables, only: law_parameters_table, map_table, &
      parameter_table
   use asperity_program_commands_surface_verdict, only: surface_verdict
   use asperity_program_commands_surface_verify, only: add_summit_curve, law_curves, &
      unloading_table
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: named_table, report_type
   use asperity_program_report_table, only: new_table
   use asperity_program_system_progress, only: clear_steps, show_stage
   use asperity_program_system_strings, only: lower_case, newline, quoted, string_type
   use asperity_surface_analysis, only: analyse_surface, most_tiles, surface_analysis_type
   use asperity_surface_prepare_fill_holes, only: missing_share
   implicit none
   private
   public :: surface_command

   !> Analyses a map.
   type, extends(command_type) :: surface_command
      private
      type(surface_options) :: options
   contains
      procedure :: describe, declare, check, run
   end type surface_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(surface_command), intent(inout) :: self

      self%name = 'surface'
      self%summary = 'parameters of the law from a scanned height map'
      self%usage = 'FILE [FILE --pair] [options]'//newline//'PROFILE... [options]'//newline// &
         '--generate [options]'
      self%purpose = 'From a scanned surface to the parameters of the law: roughness of a '// &
         'height map (ISO 25178-2), spectral moments, summits, asperity density, radius and '// &
         'sigma (Eqs 28-30), how sure they are, and whether the law holds on the map. Or from '// &
         'profiles of it, by Nayak''s route. Reads SDF, X3P, SUR, PLU, PLUX, GWY, GSF, xyz, '// &
         'asc, csv.'
      self%headings = [character(len=52) :: 'Properties that a map does not give', &
         'The map, or profiles']
      self%takes_case = .false.
   end subroutine describe

   !> Maps, how they are analysed, and the law made of them.
   pure subroutine declare(self, keys)
      !> The command
      class(surface_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%options%declare_maps(keys)
      call self%options%declare_generated(keys)
      call self%options%declare_law(keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check that files and options fit together.
   subroutine check(self, error)
      !> The command
      class(surface_command), intent(inout) :: self
      !> Set when they do not
      type(error_type), allocatable, intent(out) :: error

      call check_map_options(self%options, error)
   end subroutine check

   !> Read or make the map, analyse it, and report. `error` names the option or the file.
   subroutine run(self, report, error)
      !> The command
      class(surface_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(height_map) :: map
      type(surface_analysis_type) :: analysis
      type(named_table), allocatable :: more(:)
      type(string_type), allocatable :: notes(:)
      real(wp) :: filled
      logical :: has_map

      has_map = .true.
      filled = 0.0_wp
      associate (options => self%options)
         call get_first(options, map, error)
         if (.not. allocated(error)) call settle_kind(options, map, error)
         if (allocated(error)) then
            continue
         else if (options%of_profiles) then
            has_map = .false.
            call analyse_files(options, map, analysis, more, report%remarks, error)
         else
            if (options%preparation%fills) filled = missing_share(map)
            call prepare_map(options, map, error)
         end if
         if (.not. (allocated(error) .or. options%of_profiles)) then
            call fit_tiles(options, map)
            if (options%pair) then
               call analyse_pair(options, map, analysis, has_map, more, report%remarks, error)
            else
               allocate (more(0), report%remarks(0))
               call analyse_surface(map, options%analysis, analysis, error, show_stage)
            end if
            if (.not. (allocated(error) .or. has_map)) call refuse_without_map(self, error)
         end if
      end associate
      call clear_steps()
      if (allocated(error)) return

      if (has_map) call add_remarks(self%options, report, map, analysis, filled)
      call map_notes(map, notes)
      report%remarks = [notes, report%remarks]
      report%summary = law_parameters_table(analysis)
      report%table = parameter_table(analysis, only_known=self%options%of_profiles)
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
      call add_law(self, report, map, analysis, error)
      call self%declare(report%keys)
   end subroutine run

   !> The first file, or the map that is made.
   subroutine get_first(options, map, error)
      type(surface_options), intent(inout) :: options
      type(height_map), intent(out) :: map
      type(error_type), allocatable, intent(out) :: error

      if (options%generate) then
         call get_map(options, '', map, error)
      else
         call get_map(options, options%files(1)%text, map, error)
      end if
   end subroutine get_first

   !> The law with the parameters of the map, and what is made of it: curve, case, picture, map.
   subroutine add_law(self, report, map, analysis, error)
      class(surface_command), intent(inout) :: self
      type(report_type), intent(inout) :: report
      type(height_map), intent(in) :: map
      type(surface_analysis_type), intent(in) :: analysis
      type(error_type), allocatable, intent(out) :: error
      type(faces_type) :: law
      type(normal_properties) :: properties
      type(string_type), allocatable :: remarks(:)
      type(named_table) :: unloading

      allocate (report%decks(2))
      report%decks%option = [character(len=8) :: 'case', 'map']
      if (self%options%map /= '') then
         call show_stage('writing the map')
         call height_map_bytes(map, ending(self%options%map), report%decks(2)%text, error)
         if (allocated(error)) error%message = '--map: '//error%message
         if (allocated(error)) return
      end if
      associate (values => analysis%values(:, 1), options => self%options, &
            route => self%options%route)
         if (has_law(values, route)) then
            call set_law(options, values, error)
            if (allocated(error)) return
            call self%declare(report%keys)
            law = law_faces(options, values, route)
            call law%normal(properties, error)
            if (allocated(error)) return
            report%decks(1)%text = surface_case(options, values, analysis%uncertainty)
            report%more(3)%name = 'law'
            call law_curves(options, values, report%more(3)%table)
            call add_heights_remark(report, analysis, properties, route)
         else if (options%verify .or. options%case /= '') then
            call refuse_law(title(map), route, error)
            return
         end if
         if (options%verify) then
            call show_stage('summing the law over summits')
            call add_summit_curve(report%more(3)%table, analysis, properties, route, remarks, error)
            if (allocated(error)) return
            report%more(3)%columns_shown = 9
            report%more(3)%title = 'The law on this map: Gaussian integral by either route, '// &
               'and sums over its summits (route '//trim(route)//')'
            report%remarks = [report%remarks, remarks]
            if (options%faces%has_memory) then
               call unloading_table(unloading, analysis, properties, route, error)
               if (allocated(error)) return
               report%more = [report%more, unloading]
            end if
         end if
         report%verdict = surface_verdict(options, analysis)
         if (.not. report%is_drawn()) return
         report%picture_title = title(map)
         if (options%of_profiles) then
            report%pictures = [surface_picture(map, values, [real(wp) ::], report%more(3)%table)]
         else
            report%pictures = [surface_picture(map, values, &
               pack(analysis%summits%height, analysis%summits%is_peak .or. route == 'nayak'), &
               report%more(3)%table)]
         end if
      end associate
   end subroutine add_law

   !> Fewer tiles than the default on a map too small for it.
   pure subroutine fit_tiles(options, map)
      type(surface_options), intent(inout) :: options
      type(height_map), intent(in) :: map

      if (options%tiles_given .or. most_tiles(map) >= options%analysis%tiles) return
      options%analysis%tiles = most_tiles(map)
      options%tiles_source = 'as many as the map allows'
   end subroutine fit_tiles

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
   pure subroutine refuse_without_map(self, error)
      class(surface_command), intent(in) :: self
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: option

      option = ''
      if (self%options%map /= '') option = '--map'
      if (self%plot /= '') option = '--plot'
      if (self%options%verify) option = '--verify'
      if (option /= '') then
         call fatal_error(error, option//': needs maps of the same points and steps, which '// &
            'these are not')
      else if (self%options%case /= '' .and. self%options%route == 'paper') then
         call fatal_error(error, '--case: route paper needs maps of the same points and steps, '// &
            'which these are not; --route nayak adds their moments')
      end if
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
