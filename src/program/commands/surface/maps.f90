!> The height maps of `asperity surface`: read or made, prepared as the options say.
module asperity_program_commands_surface_maps
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map
   use asperity_paper_pairs, only: find_pair, pair_preset
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_system_progress, only: show_share, show_stage
   use asperity_program_system_strings, only: repeated
   use asperity_surface_analysis, only: prepare_surface
   use asperity_surface_generate_map, only: generate_surface
   use asperity_surface_generate_settings, only: most_points
   implicit none
   private
   public :: check_map_options, get_map, prepare_map, settle_preparation

   !> Step of a made map, mm, unless given
   real(wp), parameter :: made_step = 0.01_wp
   !> Correlation length and shortest wave of a made map, steps, unless given
   real(wp), parameter :: made_length = 10.0_wp, made_wave = 8.0_wp

contains

   !> Refuse files that do not fit the other options.
   pure subroutine check_map_options(options, error)
      !> The options
      type(surface_options), intent(in) :: options
      !> Set when options do not fit together
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: preset

      if (options%generate) then
         if (size(options%files) > 0) then
            call fatal_error(error, options%files(1)%text//': --generate makes a map and reads '// &
               'none')
         else if (options%pair) then
            call fatal_error(error, '--pair: needs the maps of two faces, --generate makes one')
         end if
      else if (size(options%files) == 0) then
         call fatal_error(error, 'no map is given: asperity surface FILE')
      else if (options%pair .and. (options%profiles .or. size(options%perpendicular) > 0)) then
         call fatal_error(error, '--pair: adds the maps of two faces, and no profiles')
      else if (options%pair .and. size(options%files) < 2) then
         call fatal_error(error, '--pair: needs the maps of two faces: asperity surface FILE '// &
            'FILE --pair')
      else if (options%pair .and. size(options%files) > 2) then
         call fatal_error(error, options%files(3)%text//': --pair takes the maps of two faces')
      else if (.not. options%pair .and. repeated([options%files, options%perpendicular]) /= '') then
         call fatal_error(error, repeated([options%files, options%perpendicular])// &
            ': is given twice')
      end if
      if (allocated(error) .or. options%material == '') return
      call find_pair(options%material, preset, error)
      if (allocated(error)) error%subject = 'material'
   end subroutine check_map_options

   !> Read or make a map. `error` names the file or the option.
   subroutine get_map(options, path, map, error)
      !> The options; what follows from the map is filled in
      type(surface_options), intent(inout) :: options
      !> Path of the file
      character(len=*), intent(in) :: path
      !> The map
      type(height_map), intent(out) :: map
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(map_hints) :: hints
      real(wp) :: step(2)

      if (options%generate) then
         call make_map(options, map, error)
         return
      end if
      hints = options%hints
      hints%has_missing_value = allocated(options%missing_value)
      if (hints%has_missing_value) hints%missing_value = options%missing_value
      if (allocated(options%step)) then
         call take_two(options%step, 'step', step, error)
         if (allocated(error)) return
         hints%step_x = step(1)
         hints%step_y = step(2)
      end if
      call show_stage('reading')
      if (size(options%files) + size(options%perpendicular) > 1) then
         ! of several files one may tell what another needs to be told
         call read_height_map(path, map_hints(has_missing_value=hints%has_missing_value, &
            missing_value=hints%missing_value), map, error, show_share)
         if (.not. allocated(error)) return
      end if
      call read_height_map(path, hints, map, error, show_share)
   end subroutine get_map

   !> Make a random map.
   subroutine make_map(options, map, error)
      type(surface_options), intent(inout) :: options
      type(height_map), intent(out) :: map
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: points(2), step(2), length(2)

      if (.not. allocated(options%step)) options%step = [made_step]
      call take_two(options%map_points, 'map_points', points, error)
      if (.not. allocated(error)) call take_two(options%step, 'step', step, error)
      if (.not. allocated(error) .and. abs(step(2) - step(1)) > 0.0_wp) &
         call fatal_error(error, 'step: a made map has one step in x and y', subject='step')
      if (.not. allocated(error) .and. any(abs(points - anint(points)) > 0.0_wp .or. &
         abs(points) > most_points)) call fatal_error(error, 'map_points: '// &
         to_text(points(1), 10)//' x '//to_text(points(2), 10)//' points are not allowed: they '// &
         'must be whole numbers up to '//to_text(most_points), subject='map_points')
      if (allocated(error)) return
      associate (made => options%made)
         made%points_x = nint(points(1))
         made%points_y = nint(points(2))
         made%step = step(1)
         if (made%spectrum == 'self_affine') then
            if (.not. allocated(options%longest_wave)) &
               options%longest_wave = 0.25_wp*minval(points)*step(1)
            if (.not. allocated(options%shortest_wave)) options%shortest_wave = made_wave*step(1)
            made%longest_wave = options%longest_wave
            made%shortest_wave = options%shortest_wave
         else
            if (.not. allocated(options%correlation_length)) &
               options%correlation_length = [made_length*step(1)]
            call take_two(options%correlation_length, 'correlation_length', length, error)
            if (allocated(error)) return
            made%correlation_length_x = length(1)
            made%correlation_length_y = length(2)
         end if
         call show_stage('making the surface')
         call generate_surface(made, map, error)
      end associate
   end subroutine make_map

   !> The values for x and y of a list of one or two.
   pure subroutine take_two(list, name, values, error)
      real(wp), intent(in) :: list(:)
      character(len=*), intent(in) :: name
      real(wp), intent(out) :: values(2)
      type(error_type), allocatable, intent(out) :: error

      values(1) = list(1)
      values(2) = list(size(list))
      if (size(list) > 2) call fatal_error(error, name//': takes one value or two, for x '// &
         'and y, found '//to_text(size(list)), subject=name)
   end subroutine take_two

   !> Level and filter a map as the options say. `error` names the option or the file.
   subroutine prepare_map(options, map, error)
      !> The options
      type(surface_options), intent(inout) :: options
      !> The map, changed in place
      type(height_map), intent(inout) :: map
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      call settle_preparation(options, error)
      if (.not. allocated(error)) &
         call prepare_surface(map, options%preparation, error, show_stage)
   end subroutine prepare_map

   !> What is done with a map or a profile before it is analysed. `error` names the option.
   pure subroutine settle_preparation(options, error)
      !> The options, whose preparation is completed
      type(surface_options), intent(inout) :: options
      !> Set where one is not allowed
      type(error_type), allocatable, intent(out) :: error

      call check_cutoff(error, 'short_cutoff', options%short_cutoff)
      if (.not. allocated(error)) call check_cutoff(error, 'long_cutoff', options%long_cutoff)
      if (allocated(error)) return
      associate (how => options%preparation)
         if (allocated(options%short_cutoff)) how%short_cutoff = options%short_cutoff
         if (allocated(options%long_cutoff)) how%long_cutoff = options%long_cutoff
         if (how%long_cutoff > 0.0_wp .and. .not. how%long_cutoff > how%short_cutoff) then
            call fatal_error(error, 'long_cutoff = '//to_text(how%long_cutoff)// &
               ' mm is not allowed: it must be above short_cutoff = '// &
               to_text(how%short_cutoff)//' mm', subject='long_cutoff')
         else if (how%form < 1 .or. how%form > 8) then
            call fatal_error(error, 'form = '//to_text(how%form)// &
               ' is not allowed: it must be a degree from 1 to 8', subject='form')
         else if (.not. (how%most_missing >= 0.0_wp .and. how%most_missing < 1.0_wp)) then
            call fatal_error(error, 'most_missing = '//to_text(how%most_missing)// &
               ' is not allowed: it must be a share from 0 to below 1', subject='most_missing')
         end if
      end associate
   end subroutine settle_preparation

   !> Refuse a cut-off that is given and not above zero.
   pure subroutine check_cutoff(error, name, value)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), allocatable, intent(in) :: value

      if (.not. allocated(value)) return
      if (.not. value > 0.0_wp) call fatal_error(error, name//' = '//to_text(value)// &
         ' mm is not allowed: it must be above 0', subject=name)
   end subroutine check_cutoff

end module asperity_program_commands_surface_maps
