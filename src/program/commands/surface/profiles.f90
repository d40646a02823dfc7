!> Profiles of `asperity surface`: which files are taken for profiles, and what is found from all of
!> them.
module asperity_program_commands_surface_profiles
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: check_height_map, fewest_points, height_map
   use asperity_program_commands_surface_keys, only: surface_options
   use asperity_program_commands_surface_maps, only: get_map, settle_preparation
   use asperity_program_report_report, only: named_table
   use asperity_program_report_table, only: column_counts, new_table
   use asperity_program_system_progress, only: show_stage
   use asperity_program_system_strings, only: string_type
   use asperity_surface_analysis, only: surface_analysis_type
   use asperity_surface_profiles_analysis, only: add_profiles, analyse_profiles, groups_of, &
      profile_set
   use asperity_surface_profiles_moments, only: profile_moments
   use asperity_surface_remarks_on_profiles, only: find_profile_remarks, profile_facts
   use asperity_surface_remarks_remark, only: remark_type
   implicit none
   private
   public :: analyse_files, settle_kind

   !> Characters of a file's name in the table
   integer, parameter :: longest_name = 64
   !> Profiles up to which the terminal shows them
   integer, parameter :: most_shown = 40
   !> Root of the groups of profiles at most
   integer, parameter :: most_tiles = 100

contains

   !> Whether profiles are analysed, or a map. `error` names what does not go with it.
   pure subroutine settle_kind(options, map, error)
      !> The options
      type(surface_options), intent(inout) :: options
      !> The first file
      type(height_map), intent(in) :: map
      !> Set where options or files do not fit
      type(error_type), allocatable, intent(out) :: error
      integer :: lines

      lines = size(map%heights, 2)
      options%of_profiles = options%profiles .or. size(options%perpendicular) > 0 .or. &
         (lines == 1 .and. .not. options%pair)
      if (options%of_profiles) then
         call check_lines(options, map, error)
         if (allocated(error)) return
         if (options%route == 'paper') then
            call fatal_error(error, '--route paper: counts peaks, which profiles do not show; '// &
               'nayak is for them')
         else if (options%verify) then
            call fatal_error(error, '--verify: sums over the summits of a map, which profiles '// &
               'do not show')
         else if (options%map /= '') then
            call fatal_error(error, '--map: writes a map, and these are profiles')
         else if (options%analysis%tiles < 1 .or. options%analysis%tiles > most_tiles) then
            call fatal_error(error, 'tiles = '//to_text(options%analysis%tiles)//' is not '// &
               'allowed: it must be from 1 to '//to_text(most_tiles)//' for profiles', &
               subject='tiles')
         end if
         if (.not. allocated(options%stylus_radius) .or. allocated(error)) return
         if (.not. options%stylus_radius > 0.0_wp) call fatal_error(error, 'stylus_radius = '// &
            to_text(options%stylus_radius)//' mm is not allowed: it must be above 0', &
            subject='stylus_radius')
      else if (allocated(options%stylus_radius)) then
         call fatal_error(error, '--stylus-radius: is for profiles')
      else if (size(options%files) > 1 .and. .not. options%pair) then
         call fatal_error(error, options%files(2)%text//': a second map is only taken with '// &
            '--pair; --profiles takes the lines of maps for profiles')
      else if (options%pair) then
         call check_height_map(map, error)
      else if (lines < fewest_points) then
         call fatal_error(error, map%source//': '//to_text(size(map%heights, 1))//' x '// &
            to_text(lines)//' points are no map: at least '//to_text(fewest_points)// &
            ' are needed either way; --profiles takes their lines for profiles')
      end if
   end subroutine settle_kind

   !> Refuse a map among profiles.
   pure subroutine check_lines(options, map, error)
      type(surface_options), intent(in) :: options
      type(height_map), intent(in) :: map
      type(error_type), allocatable, intent(out) :: error

      if (options%profiles .or. size(map%heights, 2) == 1) return
      call fatal_error(error, map%source//': is a map of '//to_text(size(map%heights, 1))//' x '// &
         to_text(size(map%heights, 2))//' points among profiles; --profiles takes its lines')
   end subroutine check_lines

   !> Read all files, and find the parameters of the surface.
   subroutine analyse_files(options, map, analysis, tables, remarks, error)
      !> The options after `settle_kind`
      type(surface_options), intent(inout) :: options
      !> The first file; its first profile as it was analysed on return
      type(height_map), intent(inout) :: map
      !> What was found
      type(surface_analysis_type), intent(out) :: analysis
      !> The profiles
      type(named_table), allocatable, intent(out) :: tables(:)
      !> One line each
      type(string_type), allocatable, intent(out) :: remarks(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(profile_set) :: set
      type(height_map) :: next
      character(len=:), allocatable :: notes
      integer :: i

      allocate (tables(1), remarks(0))
      notes = ''
      call settle_preparation(options, error)
      if (.not. allocated(error)) call add(map, 1, 1)
      do i = 2, size(options%files)
         if (.not. allocated(error)) call get_map(options, options%files(i)%text, next, error)
         if (.not. allocated(error)) call add(next, i, 1)
      end do
      do i = 1, size(options%perpendicular)
         if (.not. allocated(error)) &
            call get_map(options, options%perpendicular(i)%text, next, error)
         if (.not. allocated(error)) call add(next, max(size(options%files), 1) + i, 2)
      end do
      if (allocated(error)) return
      call show_stage('summing up')
      call analyse_profiles(set, options%analysis%tiles**2, analysis)
      call say_remarks(options, set, analysis, remarks)
      call profile_table(options, set, tables(1))
      map = set%first(1)
      if (set%n > 1) map%source = to_text(set%n)//' profiles'
      map%notes = notes

   contains

      !> The profiles of a file, and what its reader had to say
      subroutine add(scan, file, direction)
         type(height_map), intent(in) :: scan
         integer, intent(in) :: file, direction

         call check_lines(options, scan, error)
         if (.not. allocated(error)) &
            call add_profiles(set, scan, file, direction, options%preparation, error)
         if (allocated(scan%notes)) notes = notes//scan%notes
      end subroutine add

   end subroutine analyse_files

   !> What is to be said of profiles.
   pure subroutine say_remarks(options, set, analysis, remarks)
      type(surface_options), intent(in) :: options
      type(profile_set), intent(in) :: set
      type(surface_analysis_type), intent(in) :: analysis
      type(string_type), allocatable, intent(out) :: remarks(:)
      type(remark_type), allocatable :: found(:)
      type(profile_facts) :: facts
      integer :: i, k

      do k = 1, 2
         facts%number(k) = count(set%profiles(:set%n)%direction == k)
         if (facts%number(k) == 0) cycle
         facts%step(k) = set%first(k)%step_x
         facts%length(k) = facts%step(k)*(size(set%first(k)%heights) - 1)
         facts%groups(k) = groups_of(set, k, options%analysis%tiles**2)
         facts%spacing(k) = set%spacing(k)
      end do
      if (allocated(options%stylus_radius)) facts%stylus = options%stylus_radius
      ! gfortran warns otherwise of what is intent(out) anyway
      allocate (found(0))
      call find_profile_remarks(analysis%values(:, 1), analysis%uncertainty, &
         analysis%values(:, 2), facts, found)
      allocate (remarks(size(found)))
      do i = 1, size(found)
         remarks(i)%text = found(i)%text
      end do
   end subroutine say_remarks

   !> One row a profile.
   pure subroutine profile_table(options, set, named)
      type(surface_options), intent(in) :: options
      type(profile_set), intent(in) :: set
      type(named_table), intent(out) :: named
      character(len=longest_name) :: files(set%n)
      real(wp), dimension(set%n) :: m0, m2, m4, alpha
      integer :: i

      do i = 1, set%n
         associate (profile => set%profiles(i))
            call profile_moments(profile%sums(1), m0(i), m2(i), m4(i))
            alpha(i) = none
            if (max(m0(i), m2(i), m4(i)) < none .and. m2(i) > 0.0_wp) &
               alpha(i) = (m0(i)/m2(i))*(m4(i)/m2(i))
            files(i) = path_of(options, profile%file)
         end associate
      end do
      named%name = 'profiles'
      named%title = ''
      if (set%n <= most_shown) named%title = 'Profiles, each about its own mean line'
      named%table = new_table(columns=11, rows=set%n)
      associate (table => named%table, profiles => set%profiles(:set%n))
         call table%add_texts('file', files)
         call table%add_codes('line', column_counts, profiles%line)
         call table%add_texts('along', merge('x', 'y', profiles%direction == 1))
         call table%add_codes('points', column_counts, profiles%points)
         call table%add_codes('missing', column_counts, profiles%missing)
         call table%add_numbers('step', 'mm', profiles%step, figures=4)
         call table%add_numbers('length', 'mm', profiles%step*(profiles%points - 1), figures=4)
         call table%add_numbers('m0', 'mm^2', m0, figures=4)
         call table%add_numbers('m2', '-', m2, figures=4)
         call table%add_numbers('m4', '1/mm^2', m4, figures=4)
         call table%add_numbers('alpha', '-', alpha, figures=4)
      end associate
   end subroutine profile_table

   !> Name of a file without its folders.
   pure function path_of(options, file) result(path)
      type(surface_options), intent(in) :: options
      integer, intent(in) :: file
      character(len=:), allocatable :: path

      if (file > max(size(options%files), 1)) then
         path = options%perpendicular(file - max(size(options%files), 1))%text
      else if (options%generate) then
         path = 'made'
      else
         path = options%files(file)%text
      end if
      path = path(index(path, '/', back=.true.) + 1:)
   end function path_of

end module asperity_program_commands_surface_profiles
