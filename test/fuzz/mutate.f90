!> Repeatable random damage to the bytes of files.
module fuzz_mutate
   use, intrinsic :: iso_fortran_env, only: int64
   implicit none
   private
   public :: dice, mutate

   integer(int64), parameter :: modulus = 2147483647_int64, multiplier = 48271_int64

   !> Lehmer generator, x -> 48271 x mod (2^31 - 1).
   type :: dice
      !> Seed, then state; between 1 and 2^31 - 2
      integer(int64) :: state = 1_int64
   contains
      procedure :: below
   end type dice

   !> What stands for numbers where readers may stumble
   character(len=*), parameter :: words(40) = [character(len=24) :: '0', '-0', '1e308', '1e309', &
      '-1e309', '1e-320', '1e-400', 'inf', '-inf', 'nan', 'NaN', 'BAD', 'No Data', &
      '1e99999999999', &
      '99999999999999999999', '1000000', '4294967296', '2147483648', '-1', '-9999', '1,5', '1;5', &
      '1.5.5', '--1', '+', '-', '.', 'e5', '1e', '1e+', '0x10', '9.999999999999999999999', &
      '1.7976931348623157e308', '4.9e-324', '0.1e-22', '123456789012345678901234', '1.#QNAN', '*', &
      '# step_x: 1 mm', 'ncols 1000000']
   !> Bytes of extreme numbers
   integer, parameter :: bytes(8, 10) = reshape([ &
      255, 255, 255, 255, 255, 255, 255, 255, &
      255, 255, 255, 127, 255, 255, 255, 127, &
      0, 0, 0, 128, 0, 0, 0, 128, &
      0, 0, 0, 0, 0, 0, 0, 0, &
      0, 0, 128, 127, 0, 0, 240, 127, &
      1, 0, 128, 127, 1, 0, 240, 127, &
      1, 0, 128, 255, 1, 0, 240, 255, &
      1, 0, 0, 0, 0, 0, 0, 0, &
      255, 255, 127, 127, 255, 255, 239, 127, &
      64, 66, 15, 0, 64, 66, 15, 0], [8, 10])

contains

   !> A whole number from 0 to n - 1.
   integer function below(self, n)
      !> The generator
      class(dice), intent(inout) :: self
      !> How many
      integer, intent(in) :: n

      self%state = mod(multiplier*self%state, modulus)
      below = int(mod(self%state/7_int64, int(max(n, 1), int64)))
   end function below

   !> Damage a file in one to four ways.
   subroutine mutate(chance, file, other)
      !> The generator
      type(dice), intent(inout) :: chance
      !> The file
      character(len=:), allocatable, intent(inout) :: file
      !> Another one, to splice
      character(len=*), intent(in) :: other
      integer :: i

      do i = 0, chance%below(4)
         call damage(chance, file, other)
      end do
   end subroutine mutate

   subroutine damage(chance, file, other)
      type(dice), intent(inout) :: chance
      character(len=:), allocatable, intent(inout) :: file
      character(len=*), intent(in) :: other
      integer :: a, b, k, n, kind

      n = len(file)
      if (n == 0) then
         file = other
         return
      end if
      ! half of it near the beginning, where the headers are
      a = 1 + chance%below(n)
      if (chance%below(2) == 0) a = 1 + chance%below(min(n, 300))
      b = min(n, a + chance%below(40))
      kind = chance%below(11)
      select case (kind)
      case (0, 1)
         do k = 0, chance%below(4)
            a = 1 + chance%below(n)
            file(a:a) = char(ieor(ichar(file(a:a)), 2**chance%below(8)))
         end do
      case (2)
         file(a:a) = char(chance%below(256))
      case (3)
         file = file(:a - 1)
      case (4)
         file = file(:a - 1)//trim(words(1 + chance%below(size(words))))//file(a:)
      case (5)
         ! in place of a word
         do while (b > a .and. scan(file(b:b), ' ,;<>='//achar(10)) == 0)
            b = b - 1
         end do
         file = file(:a - 1)//trim(words(1 + chance%below(size(words))))//file(b:)
      case (6)
         k = scan(file(a:), '0123456789')
         if (k > 0) file(a + k - 1:a + k - 1) = achar(48 + chance%below(10))
      case (7)
         file = file(:a - 1)//file(b + 1:)
      case (8)
         file = file(:b)//file(a:)
      case (9)
         b = 1 + chance%below(max(len(other), 1))
         if (chance%below(2) == 0) then
            file = file(:a)//other(b:)
         else
            file = file(:a)//other(b:min(len(other), b + chance%below(60)))//file(a:)
         end if
      case default
         b = 1 + chance%below(size(bytes, 2))
         do k = 1, 2**(chance%below(3) + 1)
            if (a + k - 1 <= n) file(a + k - 1:a + k - 1) = char(bytes(k, b))
         end do
      end select
   end subroutine damage

end module fuzz_mutate
