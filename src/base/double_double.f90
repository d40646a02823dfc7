!> Products and quotients with twice the digits, as a sum of two doubles. The constants w1 and w2
!> are found with it: far in the tail of the heights one bit of theirs is worth 1e-12 of a result.
module asperity_base_double_double
   use, intrinsic :: iso_fortran_env, only: real32
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: double_double, quotient, operator(*), assignment(=)

   !> The number high + low, |low| at most half a unit in the last place of high.
   type :: double_double
      real(wp) :: high, low
   end type double_double

   !> Product of two, or of one and a real, to about 30 digits.
   interface operator(*)
      module procedure :: multiply
      module procedure :: multiply_real
   end interface operator(*)

   !> Round to a real.
   interface assignment(=)
      module procedure :: round
   end interface assignment(=)

   !> Not more than single precision holds
   real(wp), parameter :: largest = 3.0e38_wp

contains

   !> a/b to about 30 digits for operands and quotients of 1e-30 to 1e30.
   pure elemental function quotient(a, b) result(q)
      !> Numerator and denominator
      real(wp), intent(in) :: a, b
      type(double_double) :: q, back

      q%high = a/b
      back = exact_product(q%high, b)
      q%low = ((a - back%high) - back%low)/b
   end function quotient

   pure elemental function multiply(a, b) result(c)
      type(double_double), intent(in) :: a, b
      type(double_double) :: c

      c = exact_product(a%high, b%high)
      c%low = c%low + (a%high*b%low + a%low*b%high)
   end function multiply

   pure elemental function multiply_real(a, b) result(c)
      type(double_double), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_double) :: c

      c = exact_product(a%high, b)
      c%low = c%low + a%low*b
   end function multiply_real

   !> a*b without error (Dekker 1971).
   pure elemental function exact_product(a, b) result(c)
      real(wp), intent(in) :: a, b
      type(double_double) :: c
      real(wp) :: a_high, a_low, b_high, b_low

      c%high = a*b
      a_high = upper_half(a)
      b_high = upper_half(b)
      a_low = a - a_high
      b_low = b - b_high
      c%low = ((a_high*b_high - c%high) + a_high*b_low + a_low*b_high) + a_low*b_low
   end function exact_product

   !> The leading bits, rounded to nearest, as single precision holds them: without Dekker's
   !> multiplication, which a fused multiply-add would spoil. Beyond that range a product is what it
   !> is in double precision.
   pure elemental real(wp) function upper_half(a)
      real(wp), intent(in) :: a

      upper_half = real(real(min(a, largest), real32), wp)
   end function upper_half

   pure elemental subroutine round(x, a)
      real(wp), intent(out) :: x
      type(double_double), intent(in) :: a

      x = a%high + a%low
   end subroutine round

end module asperity_base_double_double
