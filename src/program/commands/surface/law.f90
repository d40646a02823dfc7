!> The law with the parameters of a map: its settings, its properties, its case file.
module asperity_program_commands_surface_law
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_law_normal_properties, only: normal_properties
   use asperity_paper_pairs, only: find_pair, pair_preset
   use asperity_program_commands_faces_presets, only: default_pair
   use asperity_program_commands_faces_properties, only: n_properties, of_surface, pair_values
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_surface_keys, only: of_pair, surface_options
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_text
   use asperity_program_system_strings, only: quoted, string_type
   use asperity_surface_parameters_parameters, only: p_eta_nayak, p_eta_paper, p_radius_nayak, &
      p_radius_paper, p_sigma_nayak, p_sigma_paper, p_sp, p_summit_plane, parameters
   implicit none
   private
   public :: route_places, has_law, set_law, law_faces, refusal, surface_case

   !> Names of the routes, and where they put asperity density, radius and sigma
   character(len=*), parameter, public :: routes(2) = [character(len=5) :: 'paper', 'nayak']
   integer, parameter :: places(3, 2) = reshape([p_eta_paper, p_radius_paper, p_sigma_paper, &
      p_eta_nayak, p_radius_nayak, p_sigma_nayak], [3, 2])
   character(len=*), parameter :: names(3) = [character(len=6) :: 'eta', 'radius', 'sigma']
   character(len=*), parameter :: meanings(2) = [character(len=64) :: &
      'the paper''s route (spd, 1/spc, sq; Eqs 28-30)', &
      'the route of Nayak and McCool (spectral moments)']

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

   !> Complete the law of the options by the parameters of a map and what a pair of the paper gives
   !> beside.
   pure subroutine set_law(options, values, error)
      !> The options, whose law is to be declared anew
      type(surface_options), intent(inout) :: options
      !> Parameters of the map, which has those of the route
      real(wp), intent(in) :: values(:)
      !> Set when there is no such pair
      type(error_type), allocatable, intent(out) :: error
      type(pair_preset) :: pair

      options%has_law = .true.
      options%faces%usual(of_surface) = values(route_places(options%route))
      if (options%material == '' .and. any(is_none(options%faces%values(of_pair)))) &
         options%material = default_pair
      if (options%material == '') return
      call find_pair(options%material, pair, error)
      if (allocated(error)) return
      associate (given => pair_values(pair))
         options%faces%usual(of_pair) = given(of_pair)
      end associate
   end subroutine set_law

   !> The faces with the parameters of a map by a route. What no face has is allowed here, and said
   !> in the case and the verdict.
   pure function law_faces(options, values, route) result(faces)
      !> The options after `set_law`
      type(surface_options), intent(in) :: options
      !> Parameters of the map, which has those of the route
      real(wp), intent(in) :: values(:)
      !> One of `routes`
      character(len=*), intent(in) :: route
      type(faces_type) :: faces

      faces = options%faces
      faces%values(of_surface) = values(route_places(route))
      faces%accept_unphysical = .true.
   end function law_faces

   !> Why the law refuses the properties, empty where it does not.
   pure function refusal(faces) result(text)
      !> From `law_faces`
      type(faces_type), intent(in) :: faces
      character(len=:), allocatable :: text
      type(faces_type) :: strict
      type(normal_properties) :: properties
      type(error_type), allocatable :: error
      character(len=*), parameter :: reason = ' has'

      text = ''
      strict = faces
      strict%accept_unphysical = .false.
      call strict%normal(properties, error)
      ! what the likely slip of units would be is said of numbers that were typed
      if (allocated(error)) &
         text = error%message(:index(error%message, reason//': ') + len(reason) - 1)
   end function refusal

   !> Where the parameters come from: maps, or profiles.
   pure function origin(options) result(text)
      type(surface_options), intent(in) :: options
      character(len=:), allocatable :: text

      text = 'Map: random surface of seed '//to_text(options%made%seed)
      if (size(options%files) > 0) text = 'Map: '//quoted(options%files(1)%text)
      if (options%of_profiles) text = 'Profiles'//text(4:)
      if (size(options%files) == 2) text = text//' and '//quoted(options%files(2)%text)
      if (size(options%files) > 2) text = text//' and '//to_text(size(options%files) - 1)// &
         ' files more'
      if (size(options%perpendicular) > 0) text = text//'; at right angles '// &
         quoted(options%perpendicular(1)%text)
      if (size(options%perpendicular) > 1) text = text//' and '// &
         to_text(size(options%perpendicular) - 1)//' more'
   end function origin

   !> The case file, for every command that takes properties.
   pure function surface_case(options, values, uncertainty) result(text)
      !> The options after `set_law`
      type(surface_options), intent(in) :: options
      !> Parameters of the map, and half widths of their 95 % intervals
      real(wp), intent(in) :: values(:), uncertainty(:)
      character(len=:), allocatable :: text
      type(faces_type) :: law
      type(key_list) :: own
      type(string_type) :: heading(8)
      integer :: i, n
      logical, parameter :: all_properties(n_properties) = .true.

      law = law_faces(options, values, options%route)
      law%usual = law%values
      call law%declare_values(own, all_properties)
      call law%declare_separation(own)
      if (options%faces%has_separation) then
         law%initial_separation = options%faces%initial_separation
         call own%real('initial_separation', law%initial_separation, 'mm', '')
      end if
      call law%declare_unloading(own)
      call law%heights%declare(own)
      associate (three => route_places(options%route))
         heading(1)%text = 'Written by asperity surface, version '//version// &
            ', for asperity curve, press, shear, tenon and table'
         heading(2)%text = origin(options)
         heading(3)%text = 'eta, radius, sigma by '// &
            trim(meanings(findloc(routes == options%route, .true., 1)))//', 95 % intervals:'
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
      if (options%material /= '') heading(7)%text = &
         'Other properties, unless given: pair '//options%material
      n = 7
      if (refusal(law) /= '') then
         n = 8
         heading(2:n) = heading(:n - 1)
         heading(1)%text = 'The law refuses this case, hence accept_unphysical: '//refusal(law)
         call law%declare_accept(own)
      end if
      text = case_text(own, heading(:n))
   end function surface_case

end module asperity_program_commands_surface_law
