!> What a random surface shall be, and whether it can be.
module asperity_surface_generate_settings
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_type, only: fewest_points
   implicit none
   private
   public :: surface_settings, check_surface_settings

   !> Fewest steps in a correlation length or in the shortest wave
   real(wp), parameter :: fewest_steps = 2.0_wp
   !> Numbers without a unit must be smaller in size
   real(wp), parameter :: largest_number = 1.0e6_wp
   !> Most points along a side
   integer, parameter, public :: most_points = 100000

   !> A random surface.
   type :: surface_settings
      !> Points along x and y
      integer :: points_x = 512, points_y = 512
      !> Distance of neighbours, mm
      real(wp) :: step = 0.005_wp
      !> Root mean square height of the ensemble, mm. That of one map scatters about it, as that of
      !> a measured map does, and so does its mean about zero
      real(wp) :: sq = 0.02_wp
      !> `gaussian`, autocorrelation exp(-(u/lx)^2 - (v/ly)^2), `exponential`,
      !> exp(-sqrt((u/lx)^2 + (v/ly)^2)), or `self_affine`, power spectrum as wave number to the
      !> power -2 - 2 hurst from the longest to the shortest wave, constant beyond the longest and
      !> nothing below the shortest
      character(len=12) :: spectrum = 'gaussian'
      !> Correlation lengths lx and ly, mm, along u and v: where the autocorrelation is 1/e
      real(wp) :: correlation_length_x = 0.1_wp, correlation_length_y = 0.1_wp
      !> Angle of u from x towards y, deg; v is at right angles to u
      real(wp) :: direction = 0.0_wp
      !> Hurst exponent of a self-affine surface, above 0, up to 1
      real(wp) :: hurst = 0.8_wp
      !> Its longest and shortest waves, mm
      real(wp) :: longest_wave = 0.5_wp, shortest_wave = 0.04_wp
      !> Skewness and kurtosis of the ensemble of heights
      real(wp) :: ssk = 0.0_wp, sku = 3.0_wp
      !> Any integer: the same seed gives the same surface
      integer :: seed = 1
   end type surface_settings

contains

   !> Set `error` unless there are such surfaces. Skewness and kurtosis are not tried here.
   pure subroutine check_surface_settings(s, error)
      !> The settings
      type(surface_settings), intent(in) :: s
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: side_x, side_y

      call check_points(error, 'points_x', s%points_x)
      if (.not. allocated(error)) call check_points(error, 'points_y', s%points_y)
      if (.not. allocated(error)) call check_positive(error, 'step', s%step, 'mm')
      if (.not. allocated(error)) call check_positive(error, 'sq', s%sq, 'mm')
      if (.not. allocated(error)) call check_number(error, 'ssk', s%ssk)
      if (.not. allocated(error)) call check_number(error, 'sku', s%sku)
      if (.not. allocated(error)) call check_number(error, 'direction', s%direction)
      if (allocated(error)) return
      side_x = s%step*s%points_x
      side_y = s%step*s%points_y
      select case (s%spectrum)
      case ('gaussian', 'exponential')
         call check_length(error, 'correlation_length_x', s%correlation_length_x, s%step, &
            max(side_x, side_y))
         if (.not. allocated(error)) call check_length(error, 'correlation_length_y', &
            s%correlation_length_y, s%step, max(side_x, side_y))
      case ('self_affine')
         call check_range(error, 'hurst', s%hurst, 0.01_wp, 1.0_wp, '')
         if (.not. allocated(error)) call check_length(error, 'shortest_wave', s%shortest_wave, &
            s%step, min(side_x, side_y))
         if (.not. allocated(error)) call check_length(error, 'longest_wave', s%longest_wave, &
            s%step, min(side_x, side_y))
         if (allocated(error)) return
         if (s%longest_wave < s%shortest_wave) call fatal_error(error, 'longest_wave = '// &
            to_text(s%longest_wave)//' mm is below shortest_wave = '// &
            to_text(s%shortest_wave)//' mm', subject='longest_wave shortest_wave')
      case default
         call fatal_error(error, 'spectrum = '//trim(s%spectrum)//' is not known: give '// &
            'gaussian, exponential or self_affine', subject='spectrum')
      end select
   end subroutine check_surface_settings

   !> Refuse too few or too many points.
   pure subroutine check_points(error, name, points)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      integer, intent(in) :: points

      if (points < fewest_points .or. points > most_points) call fatal_error(error, &
         name//' = '//to_text(points)//' is not allowed: it must be from '// &
         to_text(fewest_points)//' to '//to_text(most_points), subject=name)
   end subroutine check_points

   !> Refuse what is not finite.
   pure subroutine check_number(error, name, value)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value

      if (is_finite(value)) then
         if (abs(value) < largest_number) return
      end if
      call fatal_error(error, name//' = '//to_text(value)// &
         ' is not allowed: it must be a number below 1e6 in size', subject=name)
   end subroutine check_number

   !> Refuse a length that the step does not resolve or that the map does not hold.
   pure subroutine check_length(error, name, length, step, longest)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: length, step, longest

      call check_positive(error, name, length, 'mm')
      if (allocated(error)) return
      if (length < fewest_steps*step*(1.0_wp - 1.0e-9_wp)) then
         call fatal_error(error, name//' = '//to_text(length)//' mm is not resolved by step = '// &
            to_text(step)//' mm: at least two steps are needed', subject=name)
      else if (length > longest) then
         call fatal_error(error, name//' = '//to_text(length)//' mm is longer than the map, '// &
            to_text(longest, 5)//' mm: give more points or a longer step', subject=name)
      end if
   end subroutine check_length

end module asperity_surface_generate_settings
