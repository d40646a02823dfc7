!> Divided differences of the natural logarithm. In the eigenvectors of a matrix the first and the
!> second derivative of its logarithm consist of them, equal eigenvalues or not (R. Bhatia, Matrix
!> Analysis, Springer 1997, section V.3).
module asperity_solid_element_logarithm
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: first_differences, second_differences

   !> Spread of three values over their mean, below which a series takes the place of a difference
   !> of differences. On either side of it the error is some 1e-14.
   real(wp), parameter :: near = 0.02_wp
   !> Terms of the series, for rounding at that spread
   integer, parameter :: n_terms = 8

contains

   !> (ln a - ln b)/(a - b) of all pairs, the derivative 1/a where both are one: with
   !> h = ln(a/b)/2 that is h/sinh(h)/sqrt(a b), in which nothing cancels.
   pure function first_differences(values) result(differences)
      !> Values above zero
      real(wp), intent(in) :: values(3)
      real(wp) :: differences(3, 3)
      real(wp) :: h
      integer :: i, j

      do j = 1, 3
         do i = 1, j
            differences(i, j) = 1.0_wp/sqrt(values(i)*values(j))
            h = 0.5_wp*log(values(i)/values(j))
            if (abs(h) > 0.0_wp) differences(i, j) = differences(i, j)*h/sinh(h)
            differences(j, i) = differences(i, j)
         end do
      end do
   end function first_differences

   !> The difference of first differences (f(a, b) - f(b, c))/(a - c) of all three values, the same
   !> in any order of a, b and c.
   pure function second_differences(values, first) result(differences)
      !> Values above zero
      real(wp), intent(in) :: values(3)
      !> Their first differences
      real(wp), intent(in) :: first(3, 3)
      real(wp) :: differences(3, 3, 3)
      integer :: i, j, k

      do k = 1, 3
         do j = 1, k
            do i = 1, j
               differences(i, j, k) = second_difference(values([i, j, k]), &
                  [first(j, k), first(k, i), first(i, j)])
               differences(j, k, i) = differences(i, j, k)
               differences(k, i, j) = differences(i, j, k)
               differences(i, k, j) = differences(i, j, k)
               differences(k, j, i) = differences(i, j, k)
               differences(j, i, k) = differences(i, j, k)
            end do
         end do
      end do
   end function second_differences

   !> Of three values; `first` are those of the other two of each. Near each other the logarithm's
   !> series about the mean m is summed: -1/m^2 sum (-1)^n h_n/(n + 2), h_n the complete symmetric
   !> polynomials of the deviations over m.
   pure real(wp) function second_difference(values, first) result(difference)
      real(wp), intent(in) :: values(3), first(3)
      real(wp) :: mean, x(3), pairs, product_of_all, h(-2:n_terms)
      integer :: low, high, n

      low = minloc(values, 1)
      high = maxloc(values, 1)
      mean = sum(values)/3.0_wp
      if (values(high) - values(low) > near*mean) then
         difference = (first(low) - first(high))/(values(high) - values(low))
         return
      end if
      x = values/mean - 1.0_wp
      pairs = x(1)*x(2) + x(2)*x(3) + x(3)*x(1)
      product_of_all = x(1)*x(2)*x(3)
      h(-2:-1) = 0.0_wp
      h(0) = 1.0_wp
      h(1) = 0.0_wp
      difference = 0.5_wp
      do n = 2, n_terms
         ! no term of h_(n - 1), as deviations from the mean add up to zero
         h(n) = product_of_all*h(n - 3) - pairs*h(n - 2)
         difference = difference + (1 - 2*mod(n, 2))*h(n)/(n + 2)
      end do
      difference = -difference/mean**2
   end function second_difference

end module asperity_solid_element_logarithm
