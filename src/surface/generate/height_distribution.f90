!> Heights of given skewness and kurtosis as a rising function of a Gaussian number, and what that
!> does to correlations.
module asperity_surface_generate_height_distribution
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_law_johnson_fit, only: n_half, normal_point, normal_weight
   use asperity_law_johnson_heights, only: find_johnson_heights, height_of, johnson_heights
   implicit none
   private
   public :: new_marginal, marginal_height, distorted_correlation

   !> Terms of the Hermite expansion
   integer, parameter :: n_terms = 80

   !> The function from a Gaussian number to a height of mean 0 and variance 1.
   type, public :: marginal_type
      !> The function
      type(johnson_heights) :: heights = johnson_heights()
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

      call find_johnson_heights(marginal%heights, ssk, sku, ['ssk', 'sku'], error)
      if (allocated(error) .or. marginal%heights%is_gaussian) return
      call expand(marginal)
   end subroutine new_marginal

   !> Expand the function in Hermite polynomials.
   pure subroutine expand(marginal)
      type(marginal_type), intent(inout) :: marginal
      real(wp) :: x, p, z, hermite(0:n_terms), sums(n_terms)
      integer :: i, n

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

      z = height_of(marginal%heights, x)
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
      if (marginal%heights%is_gaussian .or. correlation >= 1.0_wp) return
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
