!> Products and quotients with twice the digits, as a sum of two doubles. The constants w1 and w2
!> are found with it: far in the tail of the heights one bit of theirs is worth 1e-12 of a result.
module asperity_base_double_double
   use, intrinsic :: iso_fortran_env, only: int64, real32
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

   !> Sizes whose upper half single precision holds
   real(wp), parameter :: smallest = 1.0e-37_wp, largest = 1.0e38_wp
   !> Bits of the lower half of a double
   integer, parameter :: half_bits = 27

contains

   !> a/b to about 30 digits. Operands between 1e-140 and 1e140 in size.
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

   !> The leading bits, rounded to nearest: as single precision holds them, of other sizes by the
   !> bits, which flang gets at by a library call; without Dekker's multiplication, which a fused
   !> multiply-add would spoil.
   pure elemental real(wp) function upper_half(a)
      real(wp), intent(in) :: a
      integer(int64), parameter :: lower = 2_int64**half_bits - 1_int64
      integer(int64), parameter :: half = 2_int64**(half_bits - 1)

      if (abs(a) > smallest .and. abs(a) < largest) then
         upper_half = real(real(a, real32), wp)
      else
         upper_half = transfer(iand(transfer(a, lower) + half, not(lower)), a)
      end if
   end function upper_half

   pure elemental subroutine round(x, a)
      real(wp), intent(out) :: x
      type(double_double), intent(in) :: a

      x = a%high + a%low
   end subroutine round

end module asperity_base_double_double
