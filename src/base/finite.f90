!> Whether a real is a finite number, by its bits: options such as -ffast-math do not spoil it, and
!> unlike IEEE_ARITHMETIC it does not make gfortran save and restore the floating-point state in
!> every external procedure that uses a module of ours, which takes as long as the law itself.
module asperity_base_finite
   use, intrinsic :: iso_c_binding, only: c_size_t
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: all_below, all_finite, all_within, is_finite, is_nan

   interface
      !> C's own. flang makes a library call of every `transfer`, which takes as long as twenty of
      !> these, and gfortran allocates memory for those of arrays.
      pure subroutine copy_bytes(to, from, n) bind(c, name='memcpy')
         import :: c_size_t
         implicit none
         type(*), intent(inout) :: to(*)
         type(*), intent(in) :: from(*)
         integer(c_size_t), intent(in), value :: n
      end subroutine copy_bytes
   end interface

   !> Exponent bits of a double: all set in an infinity and in what is not a number
   integer(int64), parameter :: exponent_bits = int(z'7FF0000000000000', int64)

   !> Numbers whose bits are looked at side by side
   integer, parameter :: block = 32
   integer(int64), parameter :: sign_bit = ibset(0_int64, 63)
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
      real(wp), intent(in), contiguous :: values(:)

      all_finite = largest_bits(size(values), values) < exponent_bits
   end function all_finite

   !> Whether all are numbers smaller in size than a limit.
   pure logical function all_below(values, limit)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)
      !> A number above zero
      real(wp), intent(in) :: limit

      real(wp) :: limits(1)
      integer(int64) :: bits(1)

      limits = limit
      call copy_bytes(bits, limits, storage_size(limits, c_size_t)/8)
      all_below = largest_bits(size(values), values) < bits(1)
   end function all_below

   !> Whether all are numbers within a range above zero.
   pure logical function all_within(values, lowest, highest)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)
      !> Ends of the range, above zero
      real(wp), intent(in) :: lowest, highest
      real(wp) :: ends(2)
      integer(int64) :: limits(2)

      ends(1) = lowest
      ends(2) = highest
      call copy_bytes(limits, ends, 2*storage_size(ends, c_size_t)/8)
      all_within = bits_within(size(values), values, limits)
   end function all_within

   !> Bits of the largest in size: in the order of positive numbers, infinity and what is none above
   !> all others.
   pure integer(int64) function largest_bits(n, values) result(largest)
      integer, intent(in) :: n
      real(wp), intent(in) :: values(n)
      integer(int64) :: bits(block)
      integer :: first, m, i

      largest = 0_int64
      do first = 1, n, block
         m = min(block, n - first + 1)
         call copy_bytes(bits, values(first), m*storage_size(values, c_size_t)/8)
         do i = 1, m
            largest = max(largest, iand(bits(i), not(sign_bit)))
         end do
      end do
   end function largest_bits

   pure logical function bits_within(n, values, limits)
      integer, intent(in) :: n
      real(wp), intent(in) :: values(n)
      integer(int64), intent(in) :: limits(2)
      integer(int64) :: bits(block)
      integer :: first, m, i

      bits_within = .true.
      do first = 1, n, block
         m = min(block, n - first + 1)
         call copy_bytes(bits, values(first), m*storage_size(values, c_size_t)/8)
         do i = 1, m
            bits_within = bits_within .and. bits(i) >= limits(1) .and. bits(i) <= limits(2)
         end do
      end do
   end function bits_within

   !> True for what is not a number.
   pure elemental logical function is_nan(x)
      !> Any number
      real(wp), intent(in) :: x

      is_nan = .not. is_finite(x) .and. iand(transfer(x, exponent_bits), fraction_bits) /= 0_int64
   end function is_nan

end module asperity_base_finite
