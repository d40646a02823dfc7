!> Polynomials through values at Chebyshev-Lobatto points, for compiling the law with memory.
module asperity_law_unloading_chebyshev
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: chebyshev_points, chebyshev_coefficients, powers_of_chebyshev

contains

   !> The points cos(pi i/n), i = n to 0: both ends of (-1, 1) are among them.
   pure function chebyshev_points(n) result(points)
      !> Degree of the polynomial
      integer, intent(in) :: n
      real(wp) :: points(0:n)
      integer :: i

      points = [(sin(0.5_wp*pi*(2*i - n)/n), i=0, n)]
   end function chebyshev_points

   !> Coefficients of the Chebyshev polynomials T_0 to T_n; their fall tells how good the fit is.
   pure function chebyshev_coefficients(values) result(c)
      !> Values at `chebyshev_points`
      real(wp), intent(in) :: values(0:)
      real(wp) :: c(0:size(values) - 1)
      real(wp) :: halved(0:size(values) - 1), cosines(0:2*size(values) - 3)
      integer :: i, k, n

      n = size(values) - 1
      ! the points count up from -1, their angles down from pi
      halved = values(n:0:-1)
      halved([0, n]) = 0.5_wp*halved([0, n])
      cosines = [(cos(pi*i/n), i=0, 2*n - 1)]
      do k = 0, n
         c(k) = 2.0_wp/n*sum([(halved(i)*cosines(mod(i*k, 2*n)), i=0, n)])
      end do
      c([0, n]) = 0.5_wp*c([0, n])
   end function chebyshev_coefficients

   !> Coefficients of the powers of x, where the Chebyshev polynomials are of t = scale x + shift.
   !> From the small coefficients of a good fit the large powers get no large round-off.
   pure function powers_of_chebyshev(c, scale, shift) result(powers)
      !> Coefficients of the Chebyshev polynomials of t
      real(wp), intent(in) :: c(0:)
      !> t = scale x + shift
      real(wp), intent(in) :: scale, shift
      real(wp) :: powers(0:size(c) - 1)
      real(wp), dimension(0:size(c) - 1) :: last, this, next
      integer :: k, n

      n = size(c) - 1
      last = 0.0_wp
      last(0) = 1.0_wp
      this = 0.0_wp
      this(0:1) = [shift, scale]
      powers = c(0)*last + c(1)*this
      do k = 2, n
         next = 2.0_wp*(shift*this + scale*eoshift(this, -1)) - last
         powers = powers + c(k)*next
         last = this
         this = next
      end do
   end function powers_of_chebyshev

end module asperity_law_unloading_chebyshev
