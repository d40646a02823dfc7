!> Random numbers that are the same with every compiler: L'Ecuyer's combined multiple recursive
!> generator MRG32k3a (1999), period 2^191, whose products stay below 2^53.
module asperity_surface_generate_random_stream
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: random_type, new_random, next_uniform, fill_normal

   integer(int64), parameter :: modulus_1 = 4294967087_int64, modulus_2 = 4294944443_int64
   integer(int64), parameter :: low_32 = 4294967295_int64

   !> State of one stream.
   type :: random_type
      !> Last three numbers of the two recurrences; neither all zero
      integer(int64) :: a(3) = 1_int64, b(3) = 1_int64
   end type random_type

contains

   !> Begin a stream. Every seed, whatever its sign, gives another one.
   pure subroutine new_random(stream, seed)
      !> The stream
      type(random_type), intent(out) :: stream
      !> Any integer
      integer, intent(in) :: seed
      integer(int64) :: word
      integer :: i

      word = iand(int(seed, int64), low_32)
      do i = 1, 3
         word = mixed(word + 1640531527_int64)
         stream%a(i) = 1_int64 + mod(word, modulus_1 - 1_int64)
         word = mixed(word + 1640531527_int64)
         stream%b(i) = 1_int64 + mod(word, modulus_2 - 1_int64)
      end do
   end subroutine new_random

   !> Scramble 32 bits, one to one. Factors are below 2^31, so that no product overflows.
   pure integer(int64) function mixed(word)
      integer(int64), intent(in) :: word

      mixed = iand(word, low_32)
      mixed = ieor(mixed, ishft(mixed, -16))
      mixed = iand(mixed*2146121005_int64, low_32)
      mixed = ieor(mixed, ishft(mixed, -15))
      mixed = iand(mixed*1825351331_int64, low_32)
      mixed = ieor(mixed, ishft(mixed, -16))
   end function mixed

   !> A number above 0 and below 1.
   pure subroutine next_uniform(stream, x)
      !> The stream
      type(random_type), intent(inout) :: stream
      !> The number
      real(wp), intent(out) :: x
      integer(int64) :: p, q

      associate (a => stream%a, b => stream%b)
         p = modulo(1403580_int64*a(2) - 810728_int64*a(1), modulus_1)
         a(1) = a(2)
         a(2) = a(3)
         a(3) = p
         q = modulo(527612_int64*b(3) - 1370589_int64*b(1), modulus_2)
         b(1) = b(2)
         b(2) = b(3)
         b(3) = q
      end associate
      p = p - q
      if (p <= 0_int64) p = p + modulus_1
      x = real(p, wp)/real(modulus_1 + 1_int64, wp)
   end subroutine next_uniform

   !> Independent numbers of Gaussian distribution, mean 0, variance 1 (Box and Muller).
   pure subroutine fill_normal(stream, x)
      !> The stream
      type(random_type), intent(inout) :: stream
      !> The numbers
      real(wp), intent(out) :: x(:)
      real(wp) :: u, v, r
      integer :: i

      do i = 1, size(x), 2
         call next_uniform(stream, u)
         call next_uniform(stream, v)
         r = sqrt(-2.0_wp*log(u))
         v = 2.0_wp*pi*v
         x(i) = r*cos(v)
         if (i < size(x)) x(i + 1) = r*sin(v)
      end do
   end subroutine fill_normal

end module asperity_surface_generate_random_stream
