!> Whether a real is a finite number, by its bits: options such as -ffast-math do not spoil it, and
!> unlike IEEE_ARITHMETIC it does not make gfortran save and restore the floating-point state in
!> every external procedure that uses a module of ours, which takes as long as the law itself.
module asperity_base_finite
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: all_finite, is_finite, is_nan

   !> Exponent bits of a double: all set in an infinity and in what is not a number
   integer(int64), parameter :: exponent_bits = int(z'7FF0000000000000', int64)

   integer(int64), parameter :: fraction_bits = int(z'000FFFFFFFFFFFFF', int64)

contains

   !> False for infinities and for what is not a number.
   pure elemental logical function is_finite(x)
      !> Any number
      real(wp), intent(in) :: x

      is_finite = iand(transfer(x, exponent_bits), exponent_bits) /= exponent_bits
   end function is_finite

   !> Whether all are finite.
   pure logical function all_finite(values)
      !> Any numbers
      real(wp), intent(in) :: values(:)
      integer :: i

      all_finite = .true.
      do i = 1, size(values)
         all_finite = all_finite .and. is_finite(values(i))
      end do
   end function all_finite

   !> True for what is not a number.
   pure elemental logical function is_nan(x)
      !> Any number
      real(wp), intent(in) :: x

      is_nan = .not. is_finite(x) .and. iand(transfer(x, exponent_bits), fraction_bits) /= 0_int64
   end function is_nan

end module asperity_base_finite
