!> Which of Johnson's distributions heights of summits may have.
module asperity_law_johnson_summits
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_johnson_heights, only: find_johnson_heights, johnson_heights
   implicit none
   private
   public :: find_summit_heights

   !> Skewness and kurtosis that Johnson's distributions are sought for
   real(wp), parameter :: largest_skewness = 4.0_wp, largest_kurtosis = 60.0_wp
   !> Above this s bounded heights have two peaks (Johnson 1949), or all but a cliff where they are
   !> skewed
   real(wp), parameter :: steepest_of_one_peak = sqrt(2.0_wp)

contains

   !> Find the heights of a skewness and a kurtosis. `error` is set where none have them, or those
   !> that do have two peaks.
   pure subroutine find_summit_heights(heights, skewness, kurtosis, error)
      !> The function
      type(johnson_heights), intent(inout) :: heights
      !> Skewness and kurtosis
      real(wp), intent(in) :: skewness, kurtosis
      !> Set where they are refused
      type(error_type), allocatable, intent(inout) :: error

      call check_range(error, 'skewness', skewness, -largest_skewness, largest_skewness, '')
      if (.not. allocated(error)) &
         call check_range(error, 'kurtosis', kurtosis, 1.0_wp, largest_kurtosis, '')
      if (.not. allocated(error)) call find_johnson_heights(heights, skewness, kurtosis, &
         ['skewness', 'kurtosis'], error)
      if (allocated(error) .or. heights%is_gaussian) return
      if (heights%curve%is_bounded .and. heights%curve%s > steepest_of_one_peak) &
         call fatal_error(error, 'kurtosis = '//to_text(kurtosis)//' with skewness = '// &
         to_text(skewness)//' is not allowed: such heights have two peaks or a cliff; the '// &
         'kurtosis of heights with one peak is higher', subject='kurtosis')
   end subroutine find_summit_heights

end module asperity_law_johnson_summits
