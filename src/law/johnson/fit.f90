!> Johnson's (1949) systems of distributions: heights z as a rising function of a Gaussian number x,
!> with y = s x. Above the lognormal distribution of the same skewness kurtosis takes the unbounded
!> one, z = exp(y) - q exp(-y), below it the bounded one, z = exp(y)/(1 + q exp(y)), 0 <= q <= 1.
!> They reach any skewness and kurtosis that distributions have, save for those next to the bound
!> kurtosis = skewness^2 + 1.
module asperity_law_johnson_fit
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_law_johnson_curve, only: flattest, height_at, johnson_curve_type
   implicit none
   private
   public :: find_johnson, johnson_curve, johnson_moments, johnson_type, normal_point, &
      normal_weight

   !> Half the number of points of a quadrature over x that is fine enough for all, and their
   !> distance
   integer, parameter, public :: n_half = 400
   real(wp), parameter :: dx = 0.04_wp
   !> What moments need: the trapezoidal rule errs by exp(-2 pi^2/step^2), and by the poles of
   !> bounded functions, pi/s from the axis, by exp(-2 pi^2/(s step)); the powers of unbounded ones
   !> have their largest part at 4 s
   real(wp), parameter :: widest = 0.5_wp, step_by_pole = 0.35_wp
   real(wp), parameter :: reach_bounded = 9.0_wp, reach_unbounded = 15.0_wp
   !> Least distance in kurtosis from the lognormal distributions, between the two systems
   real(wp), parameter :: least_side = 1.0e-6_wp
   !> Steepness of the functions at the end of what is reached
   real(wp), parameter :: steepest_unbounded = 1.2_wp, steepest_bounded = 8.0_wp

   !> One distribution, of skewness zero or above.
   type :: johnson_type
      !> s^2 = a^2 + d/4, unbounded, for d > 0, a^2 - d/2, bounded, else; (1 - q)/(1 + q) = a/s
      real(wp) :: a = 0.0_wp, d = 0.0_wp
   end type johnson_type

contains

   !> Find the distribution.
   pure subroutine find_johnson(skewness, kurtosis, found, is_found)
      !> Skewness, not below zero
      real(wp), intent(in) :: skewness
      !> Kurtosis, above skewness^2 + 1
      real(wp), intent(in) :: kurtosis
      !> The distribution
      type(johnson_type), intent(out) :: found
      !> False where it is not reached
      logical, intent(out) :: is_found
      integer, parameter :: n_steps(4) = [1, 3, 12, 40]
      integer :: i

      do i = 1, size(n_steps)
         call follow(found, skewness, kurtosis, n_steps(i), is_found)
         if (is_found) return
      end do
   end subroutine find_johnson

   !> Point i of the quadrature over a Gaussian number, -n_half to n_half.
   pure elemental real(wp) function normal_point(i)
      !> Its number
      integer, intent(in) :: i

      normal_point = dx*i
   end function normal_point

   !> Its weight, the Gaussian density included.
   pure elemental real(wp) function normal_weight(i)
      !> Its number
      integer, intent(in) :: i

      normal_weight = dx/sqrt(2.0_wp*pi)*exp(-0.5_wp*(dx*i)**2)
   end function normal_weight

   !> Go from the Gaussian distribution to the one asked for in steps, Newton's method at each, on
   !> one side of the lognormal distributions.
   pure subroutine follow(johnson, skewness, kurtosis, n_steps, is_found)
      type(johnson_type), intent(inout) :: johnson
      real(wp), intent(in) :: skewness, kurtosis
      integer, intent(in) :: n_steps
      logical, intent(out) :: is_found
      real(wp) :: target(2), reached, side
      integer :: i

      is_found = .false.
      side = kurtosis - 3.0_wp - lognormal_excess(skewness)
      side = sign(max(abs(side), least_side), side)
      ! where s is small, the skewness is 3 a and the kurtosis 3 + 16 a^2 + d
      johnson%a = min(skewness/(3*n_steps), 1.0_wp)
      johnson%d = max(min(side/n_steps, 1.0_wp), -1.0_wp)
      do i = 1, n_steps
         reached = real(i, wp)/n_steps
         target(1) = skewness*reached
         target(2) = lognormal_excess(target(1)) + side*reached*room(target(1))/room(skewness)
         call solve(johnson, target, is_found)
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

   !> Newton's method for the two parameters, from those there are. It is quadratic: one step from
   !> 1e-10 it is at round-off.
   pure subroutine solve(johnson, target, is_found)
      type(johnson_type), intent(inout) :: johnson
      !> Skewness and kurtosis - 3
      real(wp), intent(in) :: target(2)
      logical, intent(out) :: is_found
      logical :: settled
      type(johnson_type) :: trial
      real(wp) :: rest(2), new_rest(2), scales(2), jacobian(2, 2), step(2), determinant, factor, h
      integer :: i, j

      is_found = .false.
      rest = shape_of(johnson) - target
      scales = 1.0_wp + abs(target)
      settled = .false.
      do i = 1, 40
         is_found = maxval(abs(rest)/scales) < 1.0e-10_wp
         if (settled) return
         settled = is_found
         h = 1.0e-5_wp
         trial = johnson
         trial%a = johnson%a + h
         jacobian(:, 1) = (shape_of(trial) - target - rest)/h
         trial = johnson
         ! by the logarithm of d, which keeps its sign
         trial%d = johnson%d*exp(h)
         jacobian(:, 2) = (shape_of(trial) - target - rest)/h
         determinant = jacobian(1, 1)*jacobian(2, 2) - jacobian(1, 2)*jacobian(2, 1)
         if (.not. abs(determinant) > tiny(1.0_wp)) return
         step = [jacobian(2, 2)*rest(1) - jacobian(1, 2)*rest(2), &
            jacobian(1, 1)*rest(2) - jacobian(2, 1)*rest(1)]/determinant
         factor = 1.0_wp
         do j = 1, 20
            trial%a = max(johnson%a - factor*step(1), 0.0_wp)
            trial%d = johnson%d*exp(max(min(-factor*step(2), 2.0_wp), -2.0_wp))
            if (steepness(trial) <= merge(steepest_unbounded, steepest_bounded, &
               trial%d > 0.0_wp)) then
               new_rest = shape_of(trial) - target
               if (sum((new_rest/scales)**2) < sum((rest/scales)**2)) exit
            end if
            factor = 0.5_wp*factor
         end do
         ! no better: at round-off where it had settled, else lost
         if (j > 20) return
         johnson%a = trial%a
         johnson%d = trial%d
         rest = new_rest
      end do
   end subroutine solve

   !> s of the function.
   pure real(wp) function steepness(johnson)
      type(johnson_type), intent(in) :: johnson

      steepness = sqrt(johnson%a**2 + excess_of(johnson))
   end function steepness

   !> s^2 - a^2.
   pure real(wp) function excess_of(johnson)
      type(johnson_type), intent(in) :: johnson

      excess_of = merge(0.25_wp, -0.5_wp, johnson%d > 0.0_wp)*johnson%d
   end function excess_of

   !> The function of a distribution.
   pure elemental function johnson_curve(johnson) result(curve)
      !> The distribution
      type(johnson_type), intent(in) :: johnson
      type(johnson_curve_type) :: curve

      curve%is_bounded = .not. johnson%d > 0.0_wp
      curve%s = max(steepness(johnson), flattest)
      curve%w = min(johnson%a/curve%s, 1.0_wp)
      curve%rest = 1.0_wp - curve%w
      if (curve%s > flattest) curve%rest = excess_of(johnson)/(curve%s*(curve%s + johnson%a))
   end function johnson_curve

   !> Skewness and excess kurtosis.
   pure function shape_of(johnson) result(shape)
      type(johnson_type), intent(in) :: johnson
      real(wp) :: shape(2)
      real(wp) :: mean, sigma, moments(4)

      call johnson_moments(johnson, mean, sigma, moments)
      shape = [moments(3)/sigma**3, moments(4)/sigma**4 - 3.0_wp]
   end function shape_of

   !> Mean, standard deviation and central moments.
   pure subroutine johnson_moments(johnson, mean, sigma, moments)
      !> The distribution
      type(johnson_type), intent(in) :: johnson
      !> Mean, standard deviation, and means of the first four powers about the mean
      real(wp), intent(out) :: mean, sigma, moments(4)
      type(johnson_curve_type) :: curve
      real(wp) :: z(-n_half:n_half), p(-n_half:n_half), step
      integer :: i, n

      curve = johnson_curve(johnson)
      step = min(widest, step_by_pole/curve%s)
      n = ceiling(merge(reach_bounded, reach_unbounded, curve%is_bounded)/step)
      do i = -n, n
         p(i) = step/sqrt(2.0_wp*pi)*exp(-0.5_wp*(step*i)**2)
         z(i) = height_at(curve, step*i)
      end do
      mean = sum(p(-n:n)*z(-n:n))
      do i = 1, 4
         moments(i) = sum(p(-n:n)*(z(-n:n) - mean)**i)
      end do
      sigma = sqrt(moments(2))
   end subroutine johnson_moments

end module asperity_law_johnson_fit
