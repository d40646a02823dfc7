!> Which route to take for a map, why, and how good it is by the sum over the map's summits.
module asperity_program_commands_surface_verdict
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_properties, only: normal_properties
   use asperity_law_plausibility, only: roughness_number_max, roughness_number_min, &
      roughness_number_min_sq
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_law, only: has_law, law_faces, refusal, &
      route_places
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: surface_analysis_type
   use asperity_surface_pair_law_on_summits, only: sum_over_summits, summit_curve
   use asperity_surface_parameters_parameters, only: p_summit_plane
   implicit none
   private
   public :: surface_verdict

   !> Pressures at which a route is judged, over the hardness: about so much of the area touches
   real(wp), parameter :: judged(2) = [0.01_wp, 0.2_wp]
   !> Up to these factors between the sum and the law a route holds, or is near
   real(wp), parameter :: factors(2) = [1.25_wp, 2.0_wp]
   character(len=*), parameter :: grades(3) = [character(len=7) :: 'holds', 'is near', 'is off']

contains

   !> Two lines: the route, and the sum over the summits; one where there is no sum.
   pure function surface_verdict(options, analysis) result(lines)
      !> The options, after `set_law` where the map has the law of the route
      type(surface_options), intent(in) :: options
      !> What was found; without summits where maps of a pair do not fit
      type(surface_analysis_type), intent(in) :: analysis
      type(string_type), allocatable :: lines(:)
      type(string_type) :: verdict, sums
      type(faces_type) :: law
      type(normal_properties) :: properties
      type(error_type), allocatable :: error

      verdict%text = choice(analysis%values(:, 1), options%route, &
         trim(merge('these profiles', 'this map      ', options%of_profiles)))//'.'
      sums%text = ''
      if (has_law(analysis%values(:, 1), options%route)) then
         law = law_faces(options, analysis%values(:, 1), options%route)
         call law%normal(properties, error)
         if (.not. allocated(error)) then
            if (refusal(law) /= '') verdict%text = verdict%text//' The law takes it only with '// &
               'accept_unphysical: '//refusal(law)//'.'
            call judge(properties, analysis, options%route, sums%text)
         end if
      end if
      if (sums%text == '') then
         lines = [verdict]
      else
         lines = [verdict, sums]
      end if
   end function surface_verdict

   !> Which route to take, and why. That of Nayak, unless no Gaussian surface has the map's moments:
   !> the paper's rests on the peaks that pruning leaves, few and sharp ones.
   pure function choice(values, route, scan) result(text)
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: route, scan
      character(len=:), allocatable :: text
      logical :: nayak_exists, paper_exists

      nayak_exists = is_law(values, 'nayak', roughness_number_min)
      paper_exists = is_law(values, 'paper', roughness_number_min)
      if (route == 'nayak' .and. nayak_exists) then
         text = 'route nayak, '//number(values, route)//': all summits of a Gaussian surface '// &
            'with the moments of '//scan
      else if (route == 'nayak') then
         text = 'route nayak does not describe '//scan
         if (has_law(values, route)) text = text//', '//number(values, route)
         if (paper_exists) text = text//'; take --route paper, '//number(values, 'paper')
      else if (nayak_exists .and. .not. is_law(values, 'paper', roughness_number_min_sq)) then
         text = 'take --route nayak, '//number(values, 'nayak')//', unless values like the '// &
            'paper''s are wanted'
         if (has_law(values, route)) text = text//': route paper has '// &
            number(values, route)//' of the peaks that pruning leaves, and no isotropic '// &
            'Gaussian surface has less than '//to_text(roughness_number_min_sq, 3)
      else if (has_law(values, route)) then
         text = 'route paper, '//number(values, route)
         if (.not. nayak_exists) text = text//': no Gaussian surface has the moments of '//scan
      else
         text = 'no route describes '//scan
      end if
   end function choice

   !> Whether a route has a law, and eta R sigma is neither below a limit nor beyond all faces.
   pure logical function is_law(values, route, limit)
      real(wp), intent(in) :: values(:), limit
      character(len=*), intent(in) :: route

      is_law = has_law(values, route)
      if (.not. is_law) return
      associate (number => product(values(route_places(route))))
         is_law = number >= limit .and. number <= roughness_number_max
      end associate
   end function is_law

   !> eta R sigma of a route.
   pure function number(values, route) result(text)
      real(wp), intent(in) :: values(:)
      character(len=*), intent(in) :: route
      character(len=:), allocatable :: text

      text = 'eta R sigma = '//to_text(product(values(route_places(route))), 3)
   end function number

   !> Say how the law by a route compares with the sum over the map's summits, or the peaks of the
   !> paper's route, at the judged pressures; nothing where there is no summit.
   pure subroutine judge(properties, analysis, route, text)
      !> The law by the route
      type(normal_properties), intent(in) :: properties
      type(surface_analysis_type), intent(in) :: analysis
      character(len=*), intent(in) :: route
      character(len=:), allocatable, intent(out) :: text
      type(summit_curve) :: curve
      type(error_type), allocatable :: error
      real(wp), allocatable :: heights(:), curvatures(:)
      real(wp) :: pressure(2), separation(2)
      integer :: i, grade(2)

      text = ''
      if (.not. allocated(analysis%summits%height)) return
      pressure = judged*properties%hardness
      do i = 1, 2
         call separation_for_pressure(properties, pressure(i), separation(i), error)
         if (allocated(error)) return
      end do
      associate (summits => analysis%summits, &
            taken => analysis%summits%is_peak .or. route == 'nayak')
         heights = pack(summits%height, taken) - analysis%values(p_summit_plane, 1)
         curvatures = pack(summits%curvature, taken)
      end associate
      call sum_over_summits(properties, heights, curvatures, analysis%area, separation, curve, &
         error)
      if (allocated(error)) return
      grade = grade_of(curve%mean_radius, curve%mean_radius_error, pressure)
      associate (sums => curve%mean_radius, doubts => curve%mean_radius_error)
         text = 'Where the law of route '//trim(route)//' gives '// &
            to_text(pressure(1), 3)//' and '// &
            to_text(pressure(2), 3)//' MPa, the sum over the '//to_text(size(heights))// &
            trim(merge(' peaks  ', ' summits', route == 'paper'))//' of the map gives '// &
            to_text(sums(1), 3)//' +- '//to_text(doubts(1), 2)//' and '//to_text(sums(2), 3)// &
            ' +- '//to_text(doubts(2), 2)//': it '
         if (grade(1) == grade(2)) then
            text = text//trim(grades(grade(1)))//' at both.'
         else
            text = text//trim(grades(grade(1)))//' at the first and '//trim(grades(grade(2)))// &
               ' at the second.'
         end if
      end associate
   end subroutine judge

   !> How near a sum is to the pressure of the law, twice its standard error left aside.
   pure elemental integer function grade_of(found, doubt, pressure) result(grade)
      real(wp), intent(in) :: found, doubt, pressure

      do grade = 1, size(factors)
         if (found - 2.0_wp*doubt <= factors(grade)*pressure &
            .and. found + 2.0_wp*doubt >= pressure/factors(grade)) return
      end do
   end function grade_of

end module asperity_program_commands_surface_verdict
