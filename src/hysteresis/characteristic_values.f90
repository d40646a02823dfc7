!> Mean, variation and 5 % fractile of a quantity in several tests, by EN 14358 as it is commonly
!> cited: lognormal, at a confidence of 75 %,
!>
!>     exp(mean of ln m - k_s(n) s_y), s_y at least 0.05,
!>
!> k_s(n) the factor of a one-sided tolerance limit, the 75 % quantile of the noncentral t of n - 1
!> degrees of freedom and noncentrality 1.645 root n, over root n. It is computed here; the standard
!> tabulates it.
module asperity_hysteresis_characteristic_values
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   implicit none
   private
   public :: characteristic_values, tolerance_factor

   !> Fewest tests of a fractile
   integer, parameter, public :: fewest_tests = 3
   !> Least standard deviation of the logarithms
   real(wp), parameter :: least_deviation = 0.05_wp
   !> Confidence, and the quantile of the normal distribution that has 95 % below it
   real(wp), parameter :: confidence = 0.75_wp, quantile = 1.6448536269514722_wp
   !> Intervals of an integral, an even number, and its reach in standard deviations
   integer, parameter :: intervals = 2000
   real(wp), parameter :: reach = 9.0_wp

contains

   !> Mean, coefficient of variation and 5 % fractile; `none` where there are too few tests, or
   !> where these have not all the same sign.
   pure subroutine characteristic_values(values, mean, variation, fractile)
      !> One value a test
      real(wp), intent(in) :: values(:)
      !> What they come to, with their sign
      real(wp), intent(out) :: mean, variation, fractile
      real(wp) :: logs(size(values)), mean_log
      integer :: n

      mean = none
      variation = none
      fractile = none
      n = size(values)
      if (n == 0) return
      mean = sum(values)/n
      if (n > 1 .and. abs(mean) > 0.0_wp) &
         variation = sqrt(sum((values - mean)**2)/(n - 1))/abs(mean)
      if (n < fewest_tests .or. .not. minval(values*sign(1.0_wp, mean)) > 0.0_wp) return
      logs = log(abs(values))
      mean_log = sum(logs)/n
      fractile = sign(exp(mean_log - tolerance_factor(n) &
         *max(least_deviation, sqrt(sum((logs - mean_log)**2)/(n - 1)))), mean)
   end subroutine characteristic_values

   !> k_s(n) for a 5 % fractile at a confidence of 75 %.
   pure real(wp) function tolerance_factor(n) result(factor)
      !> Number of tests, at least two
      integer, intent(in) :: n
      real(wp) :: low, high
      integer :: i

      low = 0.0_wp
      high = 20.0_wp
      do i = 1, digits(high)
         factor = 0.5_wp*(low + high)
         if (share_below(factor, n) < confidence) then
            low = factor
         else
            high = factor
         end if
      end do
   end function tolerance_factor

   !> How often a mean less so many standard deviations lies below the true fractile: integral over
   !> the standard deviation of samples, by Simpson's rule.
   pure real(wp) function share_below(factor, n) result(share)
      real(wp), intent(in) :: factor
      integer, intent(in) :: n
      real(wp) :: s, low, step, freedom, log_scale, root_n
      integer :: i

      freedom = real(n - 1, wp)
      root_n = sqrt(real(n, wp))
      low = max(0.0_wp, 1.0_wp - reach/sqrt(2.0_wp*freedom))
      step = (1.0_wp + reach/sqrt(2.0_wp*freedom) - low)/intervals
      log_scale = log(2.0_wp) + 0.5_wp*freedom*log(0.5_wp*freedom) - log_gamma(0.5_wp*freedom)
      share = 0.0_wp
      do i = 0, intervals
         s = low + i*step
         associate (weight => merge(1, merge(4, 2, modulo(i, 2) == 1), i == 0 .or. i == intervals))
            share = share + weight*exp(log_scale + (freedom - 1.0_wp)*log(max(s, tiny(s))) &
               - 0.5_wp*freedom*s**2)*0.5_wp*erfc((quantile - factor*s)*root_n/sqrt(2.0_wp))
         end associate
      end do
      share = share*step/3.0_wp
   end function share_below

end module asperity_hysteresis_characteristic_values
