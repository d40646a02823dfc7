!> Heights of mean 0, standard deviation 1 and a given skewness and kurtosis, as a rising function
!> of a Gaussian number, by Johnson's distributions.
module asperity_law_johnson_heights
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_johnson_curve, only: height_at, height_beyond, height_slope, &
      johnson_curve_type, normal_number
   use asperity_law_johnson_fit, only: find_johnson, johnson_curve, johnson_moments, johnson_type
   implicit none
   private
   public :: find_johnson_heights, height_of, height_slope_at, height_step, johnson_heights, &
      normal_score

   !> Skewness and kurtosis as near to those of Gaussian heights as this are theirs
   real(wp), parameter :: gaussian_reach = 1.0e-12_wp
   integer, parameter :: reason_length = 120

   !> The function. Build it with `find_johnson_heights`; read only after.
   type :: johnson_heights
      !> Whether heights are Gaussian, which needs no function
      logical :: is_gaussian = .true.
      !> Sign of the skewness
      real(wp) :: sign = 1.0_wp
      !> Johnson's function of a skewness above zero, with its mean and standard deviation
      type(johnson_curve_type) :: curve = johnson_curve_type()
      real(wp) :: mean = 0.0_wp, sigma = 1.0_wp
   end type johnson_heights

contains

   !> Find the function. `error` is set where there is none.
   pure subroutine find_johnson_heights(heights, skewness, kurtosis, names, error)
      !> The function
      type(johnson_heights), intent(out) :: heights
      !> Skewness and kurtosis asked for
      real(wp), intent(in) :: skewness, kurtosis
      !> Their names, of one length, for messages
      character(len=*), intent(in) :: names(2)
      !> Set where no function has them
      type(error_type), allocatable, intent(out) :: error
      type(johnson_type) :: johnson
      character(len=reason_length) :: reason
      real(wp) :: moments(4)
      logical :: is_found

      if (abs(skewness) < gaussian_reach .and. abs(kurtosis - 3.0_wp) < gaussian_reach) return
      reason = ''
      if (kurtosis < skewness**2 + 1.0_wp) then
         reason = 'is not allowed: no heights have '//names(2)//' below '//names(1)//'^2 + 1 = '// &
            to_text(skewness**2 + 1.0_wp, 5)
      else
         call find_johnson(abs(skewness), kurtosis, johnson, is_found)
         if (.not. is_found) reason = 'cannot be reached: give '//names(1)//' from -4 to 4, '// &
            'and '//names(2)//' from 1.1 '//names(1)//'^2 + 1.3 = '// &
            to_text(1.1_wp*skewness**2 + 1.3_wp, 5)//' to 60'
      end if
      if (reason /= '') then
         call fatal_error(error, names(1)//' = '//to_text(skewness)//' with '//names(2)//' = '// &
            to_text(kurtosis)//' '//trim(reason), subject=names(1)//' '//names(2))
         return
      end if
      heights%is_gaussian = .false.
      heights%sign = sign(1.0_wp, skewness)
      heights%curve = johnson_curve(johnson)
      call johnson_moments(johnson, heights%mean, heights%sigma, moments)
   end subroutine find_johnson_heights

   !> Height of a Gaussian number.
   pure elemental real(wp) function height_of(heights, x) result(z)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number of mean 0 and variance 1
      real(wp), intent(in) :: x

      z = x
      if (heights%is_gaussian) return
      z = height_at(heights%curve, heights%sign*x) - heights%mean
      z = z*(heights%sign/heights%sigma)
   end function height_of

   !> How much higher the height of x + xi is than that of x, free of cancellation.
   pure elemental real(wp) function height_step(heights, x, xi) result(z)
      !> The function, which is not Gaussian
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number, and how far beyond
      real(wp), intent(in) :: x, xi

      if (heights%sign > 0.0_wp) then
         z = height_beyond(heights%curve, x, xi)/heights%sigma
      else
         z = height_beyond(heights%curve, -(x + xi), xi)/heights%sigma
      end if
   end function height_step

   !> Gaussian number of a height; huge in size beyond the ends of bounded heights.
   pure elemental real(wp) function normal_score(heights, z) result(x)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Height
      real(wp), intent(in) :: z

      x = z
      if (.not. heights%is_gaussian) x = heights%sign*normal_number(heights%curve, &
         heights%sign*z*heights%sigma + heights%mean)
   end function normal_score

   !> Derivative of the height by the Gaussian number.
   pure elemental real(wp) function height_slope_at(heights, x) result(slope)
      !> The function
      type(johnson_heights), intent(in) :: heights
      !> Gaussian number
      real(wp), intent(in) :: x

      slope = 1.0_wp
      if (.not. heights%is_gaussian) slope = height_slope(heights%curve, heights%sign*x) &
         /heights%sigma
   end function height_slope_at

end module asperity_law_johnson_heights
