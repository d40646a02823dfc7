!> Heights of given skewness and kurtosis as a rising function of a Gaussian number, and what that
!> does to correlations.
module asperity_surface_generate_height_distribution
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_law_johnson, only: find_johnson, johnson_height, johnson_moments, &
      johnson_type, n_half, normal_point, normal_weight
   implicit none
   private
   public :: new_marginal, marginal_height, distorted_correlation

   !> Terms of the Hermite expansion
   integer, parameter :: n_terms = 80

   !> The function from a Gaussian number to a height of mean 0 and variance 1.
   type, public :: marginal_type
      !> Whether heights are Gaussian, which needs no function
      logical :: is_gaussian = .true.
      !> Sign of the skewness
      real(wp) :: sign = 1.0_wp
      !> The distribution, with its mean and standard deviation
      type(johnson_type) :: johnson = johnson_type()
      real(wp) :: mean = 0.0_wp, sigma = 1.0_wp
      !> Shares of the powers 1, 2 ... of the Gaussian correlation in that of the heights
      real(wp) :: shares(n_terms) = 0.0_wp
   end type marginal_type

contains

   !> Find the function. `error` is set where there is none.
   pure subroutine new_marginal(marginal, ssk, sku, error)
      !> The function
      type(marginal_type), intent(out) :: marginal
      !> Skewness and kurtosis asked for
      real(wp), intent(in) :: ssk, sku
      !> Set where no function has them
      type(error_type), allocatable, intent(out) :: error
      logical :: is_found

      if (abs(ssk) < 1.0e-12_wp .and. abs(sku - 3.0_wp) < 1.0e-12_wp) return
      if (sku < ssk**2 + 1.0_wp) then
         call fatal_error(error, 'ssk = '//to_text(ssk)//' with sku = '//to_text(sku)// &
            ' is not allowed: no heights have sku below ssk^2 + 1 = '// &
            to_text(ssk**2 + 1.0_wp, 5), subject='ssk sku')
         return
      end if
      call find_johnson(abs(ssk), sku, marginal%johnson, is_found)
      if (.not. is_found) then
         call fatal_error(error, 'ssk = '//to_text(ssk)//' with sku = '//to_text(sku)// &
            ' cannot be reached: give ssk from -4 to 4, and sku from 1.1 ssk^2 + 1.3 = '// &
            to_text(1.1_wp*ssk**2 + 1.3_wp, 5)//' to 60', subject='ssk sku')
         return
      end if
      marginal%is_gaussian = .false.
      marginal%sign = sign(1.0_wp, ssk)
      call expand(marginal)
   end subroutine new_marginal

   !> Scale the function and expand it in Hermite polynomials.
   pure subroutine expand(marginal)
      type(marginal_type), intent(inout) :: marginal
      real(wp) :: moments(4), x, p, z, hermite(0:n_terms), sums(n_terms)
      integer :: i, n

      call johnson_moments(marginal%johnson, marginal%mean, marginal%sigma, moments)
      sums = 0.0_wp
      do i = -n_half, n_half
         x = normal_point(i)
         p = normal_weight(i)
         z = marginal_height(marginal, x)
         hermite(0) = 1.0_wp
         hermite(1) = x
         do n = 1, n_terms - 1
            hermite(n + 1) = (x*hermite(n) - sqrt(real(n, wp))*hermite(n - 1))/sqrt(n + 1.0_wp)
         end do
         sums = sums + p*z*hermite(1:)
      end do
      marginal%shares = sums**2/sum(sums**2)
   end subroutine expand

   !> Height of mean 0 and variance 1 for a Gaussian number.
   pure elemental real(wp) function marginal_height(marginal, x) result(z)
      !> The function
      type(marginal_type), intent(in) :: marginal
      !> Gaussian number of mean 0 and variance 1
      real(wp), intent(in) :: x

      z = x
      if (marginal%is_gaussian) return
      z = johnson_height(marginal%johnson, marginal%sign*x) - marginal%mean
      z = z*(marginal%sign/marginal%sigma)
   end function marginal_height

   !> The correlation that two Gaussian numbers must have for their heights to have the one given,
   !> or the lowest there is where that is not low enough.
   pure elemental real(wp) function distorted_correlation(marginal, correlation) result(r)
      !> The function
      type(marginal_type), intent(in) :: marginal
      !> Correlation of heights, -1 to 1
      real(wp), intent(in) :: correlation
      real(wp) :: value, slope, low, high, next
      integer :: i, n, last

      r = correlation
      if (marginal%is_gaussian .or. correlation >= 1.0_wp) return
      r = max(min(correlation/marginal%shares(1), 1.0_wp), -1.0_wp)
      if (abs(r) < 1.0e-18_wp) return
      low = -1.0_wp
      high = 1.0_wp
      do i = 1, 60
         value = 0.0_wp
         slope = 0.0_wp
         ! terms that rounding hides are left out
         last = n_terms
         if (abs(r) < 0.6_wp) last = int(-40.0_wp/log(max(abs(r), 1.0e-30_wp))) + 2
         do n = last, 1, -1
            slope = slope*r + n*marginal%shares(n)
            value = (value + marginal%shares(n))*r
         end do
         if (value > correlation) then
            high = r
         else
            low = r
         end if
         next = low
         if (slope > 0.0_wp) next = r - (value - correlation)/slope
         if (next <= low .or. next >= high) next = 0.5_wp*(low + high)
         if (abs(next - r) <= 4.0_wp*epsilon(1.0_wp)*abs(r) + 1.0e-30_wp) exit
         r = next
      end do
   end function distorted_correlation

end module asperity_surface_generate_height_distribution
