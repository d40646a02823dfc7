!> The height maps of `asperity surface`: read or made, prepared as the options say.
module asperity_program_commands_surface_maps
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_read, only: map_hints, read_height_map
   use asperity_height_map_type, only: height_map
   use asperity_paper_pairs, only: find_pair, pair_preset
   use asperity_program_input_keys, only: command_surface, find_key
   use asperity_program_input_presets, only: fill
   use asperity_program_input_settings, only: forget, settings_type
   use asperity_program_system_progress, only: show_share, show_stage
   use asperity_surface_analysis, only: preparation_settings, prepare_surface
   use asperity_surface_generate_map, only: generate_surface
   use asperity_surface_generate_settings, only: surface_settings
   implicit none
   private
   public :: check_map_options, get_map, prepare_map

   !> Options of --generate, and those of a file
   character(len=*), parameter :: made(*) = [character(len=20) :: 'map_points', 'sq', &
      'correlation_length', 'length_direction', 'spectrum', 'hurst', 'longest_wave', &
      'shortest_wave', 'ssk', 'sku', 'seed']
   character(len=*), parameter :: read_in(*) = [character(len=20) :: 'lateral_unit', &
      'height_unit', 'missing_value']
   character(len=*), parameter :: of_correlation(*) = [character(len=20) :: &
      'correlation_length', 'length_direction']
   character(len=*), parameter :: of_waves(*) = [character(len=20) :: 'hurst', 'longest_wave', &
      'shortest_wave']
   !> Most points of a made map along a side
   real(wp), parameter :: most_points = 1.0e5_wp
   !> Step of a made map, mm, unless given
   real(wp), parameter :: made_step = 0.01_wp
   !> Correlation length and shortest wave of a made map, steps, unless given
   real(wp), parameter :: made_length = 10.0_wp, made_wave = 8.0_wp

contains

   !> Refuse options that would have no effect, and forget those that do not matter.
   pure subroutine check_map_options(settings, error)
      !> Settings in effect
      type(settings_type), intent(inout) :: settings
      !> Set when options do not fit together
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: preset
      logical :: pair

      pair = settings%of(find_key('pair', command_surface))%switch
      if (settings%switch_of('generate')) then
         if (settings%given('map_file')) then
            call fatal_error(error, settings%text_of('map_file')// &
               ': --generate makes a map and reads none')
         else if (pair) then
            call fatal_error(error, '--pair: needs the maps of two faces, --generate makes one')
         end if
         call refuse_given(settings, read_in, 'is for files, which tell or need it; a made '// &
            'map is in mm', error)
         if (settings%text_of('spectrum') == 'self_affine') then
            call refuse_given(settings, of_correlation, 'is not for --spectrum self_affine', error)
         else
            call refuse_given(settings, of_waves, 'is for --spectrum self_affine', error)
         end if
      else if (.not. settings%given('map_file')) then
         call fatal_error(error, 'no map is given: asperity surface FILE')
      else if (pair .and. .not. settings%given('second_map')) then
         call fatal_error(error, '--pair: needs the maps of two faces: asperity surface FILE '// &
            'FILE --pair')
      else if (settings%given('second_map') .and. .not. pair) then
         call fatal_error(error, settings%text_of('second_map')// &
            ': a second map is only taken with --pair')
      else
         call refuse_given(settings, made, 'is for --generate', error)
      end if
      if (allocated(error)) return
      if (settings%given('mirror') .and. .not. pair) then
         call fatal_error(error, '--mirror: is for --pair')
      else if (settings%given('material')) then
         call find_pair(settings%text_of('material'), preset, error)
         if (allocated(error)) error%message = '--material: '//error%message
      end if
      if (.not. pair) call forget(settings%of(find_key('mirror')))
      if (.not. pair) call forget(settings%of(find_key('pair', command_surface)))
      if (.not. settings%given('generate')) call forget(settings%of(find_key('generate')))
   end subroutine check_map_options

   !> Refuse the first of some options that is given, forget them all.
   pure subroutine refuse_given(settings, names, why, error)
      type(settings_type), intent(inout) :: settings
      character(len=*), intent(in) :: names(:), why
      type(error_type), allocatable, intent(inout) :: error
      integer :: i

      do i = 1, size(names)
         if (allocated(error)) return
         associate (setting => settings%of(find_key(trim(names(i)))))
            if (setting%given) call fatal_error(error, setting%source//': '//why)
            call forget(setting)
         end associate
      end do
   end subroutine refuse_given

   !> Read or make a map. `error` names the file or the option.
   subroutine get_map(settings, name, map, error)
      !> Settings; what follows from the map is filled in
      type(settings_type), intent(inout) :: settings
      !> `map_file` or `second_map`
      character(len=*), intent(in) :: name
      !> The map
      type(height_map), intent(out) :: map
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(map_hints) :: hints
      real(wp) :: step(2)

      if (settings%switch_of('generate')) then
         call make_map(settings, map, error)
         return
      end if
      hints%lateral_unit = settings%text_of('lateral_unit')
      hints%height_unit = settings%text_of('height_unit')
      hints%has_missing_value = settings%given('missing_value')
      if (hints%has_missing_value) hints%missing_value = settings%real_of('missing_value')
      if (settings%given('step')) then
         call take_two(settings, 'step', step, error)
         if (allocated(error)) return
         hints%step_x = step(1)
         hints%step_y = step(2)
      end if
      call show_stage('reading')
      if (settings%given('second_map')) then
         ! of two files one may tell what the other needs to be told
         call read_height_map(settings%text_of(name), map_hints( &
            has_missing_value=hints%has_missing_value, missing_value=hints%missing_value), map, &
            error, show_share)
         if (.not. allocated(error)) return
      end if
      call read_height_map(settings%text_of(name), hints, map, error, show_share)
   end subroutine get_map

   !> Make a random map.
   subroutine make_map(settings, map, error)
      type(settings_type), intent(inout) :: settings
      type(height_map), intent(out) :: map
      type(error_type), allocatable, intent(out) :: error
      type(surface_settings) :: surface
      real(wp) :: points(2), step(2), length(2)

      call fill(settings, 'step', [made_step], 'default')
      call take_two(settings, 'map_points', points, error)
      if (.not. allocated(error)) call take_two(settings, 'step', step, error)
      if (.not. allocated(error) .and. abs(step(2) - step(1)) > 0.0_wp) &
         call fatal_error(error, 'step: a made map has one step in x and y')
      if (.not. allocated(error) .and. any(abs(points - anint(points)) > 0.0_wp .or. &
         abs(points) > most_points)) call fatal_error(error, 'map_points: '// &
         to_text(points(1), 10)//' x '//to_text(points(2), 10)//' points are not allowed: they '// &
         'must be whole numbers up to 100000')
      if (allocated(error)) return
      surface%points_x = nint(points(1))
      surface%points_y = nint(points(2))
      surface%step = step(1)
      surface%sq = settings%real_of('sq')
      surface%spectrum = settings%text_of('spectrum')
      if (surface%spectrum == 'self_affine') then
         call fill(settings, 'longest_wave', [0.25_wp*minval(points)*step(1)], &
            'quarter of the map')
         call fill(settings, 'shortest_wave', [made_wave*step(1)], '8 steps')
         surface%hurst = settings%real_of('hurst')
         surface%longest_wave = settings%real_of('longest_wave')
         surface%shortest_wave = settings%real_of('shortest_wave')
      else
         call fill(settings, 'correlation_length', [made_length*step(1)], '10 steps')
         call take_two(settings, 'correlation_length', length, error)
         if (allocated(error)) return
         surface%correlation_length_x = length(1)
         surface%correlation_length_y = length(2)
         surface%direction = settings%real_of('length_direction')
      end if
      surface%ssk = settings%real_of('ssk')
      surface%sku = settings%real_of('sku')
      surface%seed = settings%whole_of('seed')
      call show_stage('making the surface')
      call generate_surface(surface, map, error)
      if (.not. allocated(error)) return
      ! the settings of the library are not called as the options are
      if (index(error%message, 'points_') == 1) error%message = '--map-points: '//error%message
      if (index(error%message, 'correlation_length_') == 1) &
         error%message = '--correlation-length: '//error%message
      if (index(error%message, 'direction') == 1) &
         error%message = '--length-direction: '//error%message
   end subroutine make_map

   !> The values for x and y of a list of one or two.
   pure subroutine take_two(settings, name, values, error)
      type(settings_type), intent(in) :: settings
      character(len=*), intent(in) :: name
      real(wp), intent(out) :: values(2)
      type(error_type), allocatable, intent(out) :: error

      associate (list => settings%of(find_key(name))%values)
         values(1) = list(1)
         values(2) = list(size(list))
         if (size(list) > 2) call fatal_error(error, name//': takes one value or two, for x '// &
            'and y, found '//to_text(size(list)))
      end associate
   end subroutine take_two

   !> Level and filter a map as the options say. `error` names the option or the file.
   subroutine prepare_map(settings, map, error)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> The map, changed in place
      type(height_map), intent(inout) :: map
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(preparation_settings) :: preparation

      preparation%fills = settings%text_of('missing') == 'fill'
      preparation%most_missing = settings%real_of('most_missing')
      preparation%form = settings%whole_of('form')
      if (settings%given('short_cutoff')) &
         preparation%short_cutoff = settings%real_of('short_cutoff')
      if (settings%given('long_cutoff')) preparation%long_cutoff = settings%real_of('long_cutoff')
      call check_cutoffs(settings, preparation, error)
      if (.not. allocated(error)) call prepare_surface(map, preparation, error, show_stage)
   end subroutine prepare_map

   !> Refuse cut-offs and forms that mean nothing.
   pure subroutine check_cutoffs(settings, preparation, error)
      type(settings_type), intent(in) :: settings
      type(preparation_settings), intent(in) :: preparation
      type(error_type), allocatable, intent(out) :: error

      if (settings%given('short_cutoff') .and. .not. preparation%short_cutoff > 0.0_wp) then
         call fatal_error(error, 'short_cutoff = '//to_text(preparation%short_cutoff)// &
            ' mm is not allowed: it must be above 0')
      else if (settings%given('long_cutoff') .and. .not. preparation%long_cutoff > 0.0_wp) then
         call fatal_error(error, 'long_cutoff = '//to_text(preparation%long_cutoff)// &
            ' mm is not allowed: it must be above 0')
      else if (settings%given('long_cutoff') &
            .and. .not. preparation%long_cutoff > preparation%short_cutoff) then
         call fatal_error(error, 'long_cutoff = '//to_text(preparation%long_cutoff)// &
            ' mm is not allowed: it must be above short_cutoff = '// &
            to_text(preparation%short_cutoff)//' mm')
      else if (preparation%form < 1 .or. preparation%form > 8) then
         call fatal_error(error, 'form = '//to_text(preparation%form)// &
            ' is not allowed: it must be a degree from 1 to 8')
      else if (.not. (preparation%most_missing >= 0.0_wp .and. preparation%most_missing < 1.0_wp)) &
            then
         call fatal_error(error, 'most_missing = '//to_text(preparation%most_missing)// &
            ' is not allowed: it must be a share from 0 to below 1')
      end if
   end subroutine check_cutoffs

end module asperity_program_commands_surface_maps
