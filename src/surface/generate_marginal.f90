!> Heights of given skewness and kurtosis as a rising function of a Gaussian number x, and what it
!> does to correlations. The functions are Johnson's (1949) systems: z = exp(y) - q exp(-y) with
!> y = s x, unbounded, for kurtosis above that of the lognormal distribution of the same skewness,
!> z = exp(y)/(1 + q exp(y)), bounded, for kurtosis below it, 0 <= q <= 1. They reach any skewness
!> and kurtosis that distributions have, save for those next to the bound sku = ssk^2 + 1.
module surface_generate_marginal
   use asperity_error, only: error_type, fatal_error
   use asperity_kinds, only: wp
   use asperity_properties, only: pi
   use asperity_text, only: to_text
   implicit none
   private
   public :: new_marginal, marginal_height, distorted_correlation

   !> Half the number of points of the quadrature over x, and their distance
   integer, parameter :: n_half = 400
   real(wp), parameter :: dx = 0.04_wp
   !> Terms of the Hermite expansion
   integer, parameter :: n_terms = 80
   !> Least distance in kurtosis from the lognormal distributions, between the two systems
   real(wp), parameter :: least_side = 1.0e-6_wp
   !> Below this s the function is a line to rounding
   real(wp), parameter :: flattest = 1.0e-8_wp
   !> Steepness of the functions at the end of what is reached
   real(wp), parameter :: steepest_unbounded = 1.2_wp, steepest_bounded = 8.0_wp

   !> The function from a Gaussian number to a height of mean 0 and variance 1.
   type, public :: marginal_type
      !> Whether heights are Gaussian, which needs no function
      logical :: is_gaussian = .true.
      !> Sign of the skewness
      real(wp) :: sign = 1.0_wp
      !> The two parameters: with s^2 = a^2 + |d|, (1 - q)/(1 + q) = a/s; unbounded for d > 0
      real(wp) :: a = 0.0_wp, d = 0.0_wp
      !> Mean and standard deviation of the function before it is scaled
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
      integer, parameter :: n_steps(3) = [3, 12, 40]
      integer :: i
      logical :: is_found

      if (abs(ssk) < 1.0e-12_wp .and. abs(sku - 3.0_wp) < 1.0e-12_wp) return
      if (sku < ssk**2 + 1.0_wp) then
         call fatal_error(error, 'ssk = '//to_text(ssk)//' with sku = '//to_text(sku)// &
            ' is not allowed: no heights have sku below ssk^2 + 1 = '// &
            to_text(ssk**2 + 1.0_wp, 5))
         return
      end if
      marginal%is_gaussian = .false.
      marginal%sign = sign(1.0_wp, ssk)
      do i = 1, size(n_steps)
         call follow(marginal, abs(ssk), sku, n_steps(i), is_found)
         if (is_found) exit
      end do
      if (.not. is_found) then
         call fatal_error(error, 'ssk = '//to_text(ssk)//' with sku = '//to_text(sku)// &
            ' cannot be reached: give ssk from -4 to 4, and sku from 1.1 ssk^2 + 1.3 = '// &
            to_text(1.1_wp*ssk**2 + 1.3_wp, 5)//' to 60')
         return
      end if
      call expand(marginal)
   end subroutine new_marginal

   !> Go from the Gaussian distribution to the one asked for in steps, Newton's method at each, on
   !> one side of the lognormal distributions.
   pure subroutine follow(marginal, skewness, sku, n_steps, is_found)
      type(marginal_type), intent(inout) :: marginal
      real(wp), intent(in) :: skewness, sku
      integer, intent(in) :: n_steps
      logical, intent(out) :: is_found
      real(wp) :: target(2), reached, side
      integer :: i

      is_found = .false.
      side = sku - 3.0_wp - lognormal_excess(skewness)
      side = sign(max(abs(side), least_side), side)
      ! where s is small, the skewness is 3 a and the kurtosis 3 + 16 a^2 + d
      marginal%a = skewness/(3*n_steps)
      marginal%d = side/n_steps
      do i = 1, n_steps
         reached = real(i, wp)/n_steps
         target(1) = skewness*reached
         target(2) = lognormal_excess(target(1)) + side*reached*room(target(1))/room(skewness)
         call solve(marginal, target, is_found)
         if (.not. is_found) return
      end do
   end subroutine follow

   !> Kurtosis less 3 of the lognormal distribution of a skewness.
   pure real(wp) function lognormal_excess(skewness) result(excess)
      real(wp), intent(in) :: skewness
      real(wp) :: w
      integer :: i

      ! skewness = (w + 2) sqrt(w - 1), w = exp(s^2), by Newton on its square from above
      w = 1.0_wp + skewness**2
      do i = 1, 50
         w = w - ((w + 2.0_wp)**2*(w - 1.0_wp) - skewness**2)/(3.0_wp*w*(w + 2.0_wp))
      end do
      excess = (w - 1.0_wp)*(w*w*(w + 3.0_wp) + 6.0_wp*(w + 1.0_wp))
   end function lognormal_excess

   !> Distance in kurtosis of the lognormal distribution of a skewness from its bound.
   pure real(wp) function room(skewness)
      real(wp), intent(in) :: skewness

      room = lognormal_excess(skewness) + 2.0_wp - skewness**2
   end function room

   !> Newton's method for the two parameters, from those there are.
   pure subroutine solve(marginal, target, is_found)
      type(marginal_type), intent(inout) :: marginal
      !> |ssk| and sku - 3
      real(wp), intent(in) :: target(2)
      logical, intent(out) :: is_found
      type(marginal_type) :: trial
      real(wp) :: rest(2), new_rest(2), scales(2), jacobian(2, 2), step(2), determinant, factor, h
      integer :: i, j

      is_found = .false.
      rest = shape_of(marginal) - target
      scales = 1.0_wp + abs(target)
      do i = 1, 40
         is_found = maxval(abs(rest)/scales) < 1.0e-10_wp
         if (is_found) return
         h = 1.0e-5_wp
         trial = marginal
         trial%a = marginal%a + h
         jacobian(:, 1) = (shape_of(trial) - target - rest)/h
         trial = marginal
         ! by the logarithm of d, which keeps its sign
         trial%d = marginal%d*exp(h)
         jacobian(:, 2) = (shape_of(trial) - target - rest)/h
         determinant = jacobian(1, 1)*jacobian(2, 2) - jacobian(1, 2)*jacobian(2, 1)
         if (.not. abs(determinant) > tiny(1.0_wp)) return
         step = [jacobian(2, 2)*rest(1) - jacobian(1, 2)*rest(2), &
            jacobian(1, 1)*rest(2) - jacobian(2, 1)*rest(1)]/determinant
         factor = 1.0_wp
         do j = 1, 20
            trial%a = max(marginal%a - factor*step(1), 0.0_wp)
            trial%d = marginal%d*exp(max(min(-factor*step(2), 2.0_wp), -2.0_wp))
            if (steepness(trial) <= merge(steepest_unbounded, steepest_bounded, &
               trial%d > 0.0_wp)) then
               new_rest = shape_of(trial) - target
               if (sum((new_rest/scales)**2) < sum((rest/scales)**2)) exit
            end if
            factor = 0.5_wp*factor
         end do
         if (j > 20) return
         marginal%a = trial%a
         marginal%d = trial%d
         rest = new_rest
      end do
   end subroutine solve

   !> s of the function.
   pure real(wp) function steepness(marginal)
      type(marginal_type), intent(in) :: marginal

      steepness = sqrt(marginal%a**2 + merge(0.25_wp, -0.5_wp, marginal%d > 0.0_wp)*marginal%d)
   end function steepness

   !> The function before it is scaled to mean 0 and variance 1.
   pure elemental real(wp) function raw_height(marginal, x) result(z)
      type(marginal_type), intent(in) :: marginal
      real(wp), intent(in) :: x
      real(wp) :: s, w, y, t

      s = max(steepness(marginal), flattest)
      w = min(marginal%a/s, 1.0_wp)
      y = s*x
      if (marginal%d > 0.0_wp) then
         ! exp(y) - q exp(-y), less 1 - q and over 1 + q, free of cancellation at small s
         z = sinh(y) + 2.0_wp*w*sinh(0.5_wp*y)**2
      else
         t = tanh(0.5_wp*y)
         ! exp(y)/(1 + q exp(y)), less its value at 0 and over its slope there
         z = 2.0_wp*t/(1.0_wp - w*t)
      end if
      z = z/s
   end function raw_height

   !> Set mean and sigma, and return skewness and excess kurtosis.
   pure function shape_of(marginal) result(shape)
      type(marginal_type), intent(in) :: marginal
      real(wp) :: shape(2)
      real(wp) :: mean, sigma, moments(4)

      call moments_of(marginal, mean, sigma, moments)
      shape = [moments(3)/sigma**3, moments(4)/sigma**4 - 3.0_wp]
   end function shape_of

   !> Mean, standard deviation and central moments.
   pure subroutine moments_of(marginal, mean, sigma, moments)
      type(marginal_type), intent(in) :: marginal
      real(wp), intent(out) :: mean, sigma, moments(4)
      real(wp) :: x(-n_half:n_half), z(-n_half:n_half), p(-n_half:n_half)
      integer :: i

      x = dx*[(real(i, wp), i=-n_half, n_half)]
      p = dx/sqrt(2.0_wp*pi)*exp(-0.5_wp*x**2)
      z = raw_height(marginal, x)
      mean = sum(p*z)
      do i = 1, 4
         moments(i) = sum(p*(z - mean)**i)
      end do
      sigma = sqrt(moments(2))
   end subroutine moments_of

   !> Scale the function and expand it in Hermite polynomials.
   pure subroutine expand(marginal)
      type(marginal_type), intent(inout) :: marginal
      real(wp) :: moments(4), x, p, z, hermite(0:n_terms), sums(n_terms)
      integer :: i, n

      call moments_of(marginal, marginal%mean, marginal%sigma, moments)
      sums = 0.0_wp
      do i = -n_half, n_half
         x = dx*i
         p = dx/sqrt(2.0_wp*pi)*exp(-0.5_wp*x*x)
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
      z = (raw_height(marginal, marginal%sign*x) - marginal%mean)/marginal%sigma*marginal%sign
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

end module surface_generate_marginal
