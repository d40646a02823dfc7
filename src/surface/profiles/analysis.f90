!> Profiles to the parameters of their surface: each is levelled and filtered as a map of one line,
!> and its sums kept; the rest follows from the sums.
module asperity_surface_profiles_analysis
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: fewest_points, height_map, missing_points, thinned
   use asperity_surface_analysis, only: preparation_settings, prepare_surface, steps, &
      surface_analysis_type
   use asperity_surface_profiles_moments, only: profile_moments, profile_uncertainties, &
      profile_values
   use asperity_surface_profiles_sums, only: added, profile_sums, sum_profile
   implicit none
   private
   public :: add_profiles, analyse_profiles, groups_of, profile_set, profile_type

   !> Steps of one direction that differ by less are the same, as files round them
   real(wp), parameter :: same = 1.0e-3_wp

   !> One profile.
   type :: profile_type
      !> Numbers of its file and of its line there
      integer :: file = 0, line = 0
      !> 1 along x, 2 at right angles to it
      integer :: direction = 1
      !> Points, and those of them without height
      integer :: points = 0, missing = 0
      !> Distance of points, mm
      real(wp) :: step = 0.0_wp
      !> Sums at the multiples of the step at which parameters are found
      type(profile_sums) :: sums(size(steps))
   end type profile_type

   !> All profiles.
   type :: profile_set
      !> How many
      integer :: n = 0
      !> The first `n` are there
      type(profile_type), allocatable :: profiles(:)
      !> The first one of either direction as it was analysed
      type(height_map) :: first(2)
      !> Distance of neighbouring ones that are lines of a map, mm; 0 for others
      real(wp) :: spacing(2) = 0.0_wp
   end type profile_set

contains

   !> Prepare every line of a map as a profile of its own, and add it. `error` names the file.
   subroutine add_profiles(set, map, file, direction, settings, error)
      !> The profiles so far
      type(profile_set), intent(inout) :: set
      !> The map; one line is a profile
      type(height_map), intent(in) :: map
      !> Number of its file
      integer, intent(in) :: file
      !> 1 along x, 2 at right angles to it
      integer, intent(in) :: direction
      !> How to prepare each
      type(preparation_settings), intent(in) :: settings
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(profile_type), allocatable :: longer(:)
      type(height_map) :: line
      integer :: j

      allocate (longer(set%n + size(map%heights, 2)))
      if (set%n > 0) longer(:set%n) = set%profiles(:set%n)
      call move_alloc(longer, set%profiles)
      if (size(map%heights, 2) > 1) set%spacing(direction) = map%step_y
      do j = 1, size(map%heights, 2)
         line%heights = map%heights(:, j:j)
         line%step_x = map%step_x
         line%step_y = map%step_x
         line%source = map%source
         if (size(map%heights, 2) > 1) line%source = map%source//', line '//to_text(j)
         call check_step(set, line, direction, error)
         if (.not. allocated(error)) call prepare_surface(line, settings, error)
         if (allocated(error)) return
         if (.not. allocated(set%first(direction)%heights)) set%first(direction) = line
         set%n = set%n + 1
         call take(line, set%profiles(set%n))
         set%profiles(set%n)%file = file
         set%profiles(set%n)%line = j
         set%profiles(set%n)%direction = direction
      end do
   end subroutine add_profiles

   !> Refuse a profile of another step than those of its direction: m2 and m4 hang on it.
   pure subroutine check_step(set, line, direction, error)
      type(profile_set), intent(in) :: set
      type(height_map), intent(in) :: line
      integer, intent(in) :: direction
      type(error_type), allocatable, intent(out) :: error

      if (.not. allocated(set%first(direction)%heights)) return
      associate (step => set%first(direction)%step_x)
         if (abs(line%step_x - step) <= same*step) return
         call fatal_error(error, line%source//': its step, '//to_text(line%step_x, 6)// &
            ' mm, is not that of '//set%first(direction)%source//', '//to_text(step, 6)// &
            ' mm: slopes and curvatures hang on it, so that profiles of one direction must '// &
            'have the same')
      end associate
   end subroutine check_step

   !> Keep what is needed of a prepared profile.
   pure subroutine take(line, profile)
      type(height_map), intent(in) :: line
      type(profile_type), intent(inout) :: profile
      type(height_map) :: coarse
      integer :: k

      profile%points = size(line%heights)
      profile%missing = missing_points(line)
      profile%step = line%step_x
      do k = 1, size(steps)
         if (profile%points < steps(k)*fewest_points) exit
         call thinned(line, steps(k), coarse)
         call sum_profile(coarse%heights(:, 1), coarse%step_x, profile%sums(k:k))
      end do
   end subroutine take

   !> Parameters of the surface and their uncertainties: from the scatter of the profiles of each
   !> direction, of groups of neighbours where there are many, or of the parts of a single one.
   pure subroutine analyse_profiles(set, most_groups, analysis)
      !> The profiles, at least one along x
      type(profile_set), intent(in) :: set
      !> Groups of profiles, or parts of a single one, of each direction at most
      integer, intent(in) :: most_groups
      !> What was found; without summits
      type(surface_analysis_type), intent(out) :: analysis
      type(profile_sums) :: whole(size(steps), 2), of_groups(most_groups)
      type(profile_sums), allocatable :: groups(:)
      integer, allocatable :: direction(:), own(:)
      real(wp) :: m0, m2(2), m4
      integer :: directions, group, i, k, n, steeper

      directions = maxval(set%profiles(:set%n)%direction)
      do i = 1, set%n
         associate (profile => set%profiles(i))
            whole(:, profile%direction) = added(whole(:, profile%direction), profile%sums)
         end associate
      end do
      allocate (groups(0), direction(0))
      do k = 1, directions
         own = pack([(i, i=1, set%n)], set%profiles(:set%n)%direction == k)
         n = groups_of(set, k, most_groups)
         if (size(own) == 1) then
            call sum_profile(set%first(k)%heights(:, 1), set%first(k)%step_x, of_groups(:n))
         else
            of_groups = profile_sums()
            do i = 1, size(own)
               group = 1 + int(int(i - 1, int64)*n/size(own))
               of_groups(group) = added(of_groups(group), set%profiles(own(i))%sums(1))
            end do
         end if
         groups = [groups, of_groups(:n)]
         direction = [direction, [(k, i=1, n)]]
      end do
      steeper = 1
      if (directions == 2) then
         call profile_moments(whole(1, 1), m0, m2(1), m4)
         call profile_moments(whole(1, 2), m0, m2(2), m4)
         steeper = maxloc(m2, 1)
      end if
      do k = 1, size(steps)
         call profile_values(whole(k, :directions), steeper, analysis%values(:, k))
      end do
      call profile_uncertainties(groups, direction, steeper, analysis%uncertainty)
   end subroutine analyse_profiles

   !> Groups of profiles of a direction, or parts of a single one.
   pure integer function groups_of(set, direction, most_groups) result(n)
      !> The profiles
      type(profile_set), intent(in) :: set
      !> 1 along x, 2 at right angles to it
      integer, intent(in) :: direction
      !> At most
      integer, intent(in) :: most_groups

      n = count(set%profiles(:set%n)%direction == direction)
      if (n == 1) n = size(set%first(direction)%heights)/fewest_points
      n = max(1, min(n, most_groups))
   end function groups_of

end module asperity_surface_profiles_analysis
