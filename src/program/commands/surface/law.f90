!> The law with the parameters of a map: its settings, its properties, its case file.
module asperity_program_commands_surface_law
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_contact_properties, only: default_initial_separation
   use asperity_law_normal_properties, only: new_normal_properties, normal_properties
   use asperity_program_input_keys, only: belongs, command_surface, command_table, find_key, keys, &
      kind_real, n_keys
   use asperity_program_input_presets, only: apply_presets, fill
   use asperity_program_input_print_case, only: case_text
   use asperity_program_input_ranges, only: linear_range
   use asperity_program_input_settings, only: assign_values, settings_type
   use asperity_program_system_strings, only: quoted, string_type
   use asperity_surface_parameters_parameters, only: p_eta_nayak, p_eta_paper, p_radius_nayak, &
      p_radius_paper, p_sigma_nayak, p_sigma_paper, p_sp, p_summit_plane, parameters
   implicit none
   private
   public :: route_places, has_law, set_law, refusal, surface_case

   !> Names of the routes, and where they put asperity density, radius and sigma
   character(len=*), parameter, public :: routes(2) = [character(len=5) :: 'paper', 'nayak']
   integer, parameter :: places(3, 2) = reshape([p_eta_paper, p_radius_paper, p_sigma_paper, &
      p_eta_nayak, p_radius_nayak, p_sigma_nayak], [3, 2])
   character(len=*), parameter :: names(3) = [character(len=6) :: 'eta', 'radius', 'sigma']
   character(len=*), parameter :: meanings(2) = [character(len=64) :: &
      'the paper''s route (spd, 1/spc, sq; Eqs 28-30)', &
      'the route of Nayak and McCool (spectral moments)']

   !> Separations of the law that are drawn and verified, unless given
   integer, parameter :: default_points = 17

contains

   !> Places of asperity density, radius and sigma among the parameters.
   pure function route_places(route) result(three)
      !> One of `routes`
      character(len=*), intent(in) :: route
      integer :: three(3)

      three = places(:, findloc(routes == route, .true., 1))
   end function route_places

   !> Whether a map has the three parameters of a route.
   pure logical function has_law(values, route)
      !> Parameters of the map
      real(wp), intent(in) :: values(:)
      !> One of `routes`
      character(len=*), intent(in) :: route

      has_law = .not. any(is_none(values(route_places(route))))
   end function has_law

   !> Complete settings by the parameters of a map and what a pair of the paper gives beside, and
   !> check them all. What no face has is allowed here, and said in the case and the verdict.
   pure subroutine set_law(settings, values, route, properties, error)
      !> Settings
      type(settings_type), intent(inout) :: settings
      !> Parameters of the map, which has those of the route
      real(wp), intent(in) :: values(:)
      !> One of `routes`
      character(len=*), intent(in) :: route
      !> Checked properties
      type(normal_properties), intent(out) :: properties
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      integer :: i, three(3)

      three = route_places(route)
      do i = 1, size(names)
         call assign_values(settings%of(find_key(trim(names(i)))), [values(three(i))], &
            trim(parameters(three(i))%name))
      end do
      associate (pair => settings%of(find_key('pair')), &
            material => settings%of(find_key('material')))
         if (material%has_value) then
            pair%text = material%text
            pair%has_value = .true.
         end if
         call apply_presets(settings, command_surface, error)
         if (allocated(error)) return
         if (.not. material%has_value .and. pair%has_value) then
            material%text = pair%text
            material%has_value = .true.
         end if
      end associate
      associate (sigma => settings%real_of('sigma'))
         call fill(settings, 'initial_separation', [default_initial_separation*sigma], '4 sigma', &
            follows=.true.)
         call fill(settings, 'separation', linear_range(default_initial_separation*sigma, 0.0_wp, &
            default_points), '4 sigma to 0', follows=.true.)
      end associate
      call new_normal_properties(properties, settings%real_of('eta'), &
         settings%real_of('modulus'), settings%real_of('radius'), settings%real_of('hardness'), &
         settings%real_of('yield_factor'), settings%real_of('sigma'), error, &
         accept_unphysical=.true.)
   end subroutine set_law

   !> Why the law refuses the properties, empty where it does not.
   pure function refusal(settings) result(text)
      !> Settings after `set_law`
      type(settings_type), intent(in) :: settings
      character(len=:), allocatable :: text
      type(normal_properties) :: properties
      type(error_type), allocatable :: error
      character(len=*), parameter :: reason = ' has'

      text = ''
      call new_normal_properties(properties, settings%real_of('eta'), &
         settings%real_of('modulus'), settings%real_of('radius'), settings%real_of('hardness'), &
         settings%real_of('yield_factor'), settings%real_of('sigma'), error)
      ! what the likely slip of units would be is said of numbers that were typed
      if (allocated(error)) &
         text = error%message(:index(error%message, reason//': ') + len(reason) - 1)
   end function refusal

   !> The case file, for every command that takes properties.
   pure function surface_case(settings, values, uncertainty, route) result(text)
      !> Settings after `set_law`
      type(settings_type), intent(in) :: settings
      !> Parameters of the map, and half widths of their 95 % intervals
      real(wp), intent(in) :: values(:), uncertainty(:)
      !> One of `routes`
      character(len=*), intent(in) :: route
      character(len=:), allocatable :: text
      type(settings_type) :: law
      type(string_type) :: heading(8)
      integer :: i, key, n

      do key = 1, n_keys
         if (.not. (keys(key)%is_property .and. keys(key)%kind == kind_real)) cycle
         if (belongs(key, command_table) .and. settings%of(key)%has_value) &
            law%of(key) = settings%of(key)
      end do
      associate (three => route_places(route))
         heading(1)%text = 'Written by asperity surface, version '//version// &
            ', for asperity curve, press, shear, tenon and table'
         heading(2)%text = 'Map: '//quoted(settings%text_of('map_file'))
         if (settings%switch_of('generate')) heading(2)%text = 'Map: random surface of seed '// &
            to_text(settings%whole_of('seed'))
         if (settings%text_of('second_map') /= '') heading(2)%text = heading(2)%text//' and '// &
            quoted(settings%text_of('second_map'))
         heading(3)%text = 'eta, radius, sigma by '// &
            trim(meanings(findloc(routes == route, .true., 1)))//', 95 % intervals:'
         heading(4)%text = ' '
         do i = 1, size(names)
            heading(4)%text = heading(4)%text//' '//trim(names(i))//' '// &
               to_text(values(three(i)), 4)
            if (.not. is_none(uncertainty(three(i)))) heading(4)%text = heading(4)%text// &
               ' +- '//to_text(uncertainty(three(i)), 2)
            heading(4)%text = heading(4)%text//' '//trim(parameters(three(i))%unit)
            if (i < size(names)) heading(4)%text = heading(4)%text//','
         end do
      end associate
      heading(5)%text = 'Separation is from the mean plane of summit heights, '// &
         to_text(values(p_summit_plane), 4)//' mm above the mean plane of the surface;'
      heading(6)%text = '  no first touch is known'
      if (.not. is_none(values(p_sp))) heading(6)%text = &
         '  the highest point of the map touches at separation '// &
         to_text(values(p_sp) - values(p_summit_plane), 4)//' mm'
      heading(7)%text = 'Other properties: as given'
      if (settings%text_of('material') /= '') heading(7)%text = &
         'Other properties, unless given: pair '//settings%text_of('material')
      n = 7
      if (refusal(settings) /= '') then
         n = 8
         heading(2:n) = heading(:n - 1)
         heading(1)%text = 'The law refuses this case, hence accept_unphysical: '//refusal(settings)
         associate (accept => law%of(find_key('accept_unphysical')))
            accept%has_value = .true.
            accept%switch = .true.
         end associate
      end if
      text = case_text(law, command_table, heading(:n))
   end function surface_case

end module asperity_program_commands_surface_law
