!> Decimal numbers out of a line, correctly rounded and fast.
!>
!> A whole number below 2^53 times or over a power of ten up to 10^22 takes one operation, which
!> rounds once (Clinger 1990). Others are computed to 30 digits, which settles the rounding unless
!> the number is that close to the middle of two doubles; those few are left to Fortran's own read.
module asperity_height_map_text_numbers
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_double_double, only: double_double, quotient, operator(*)
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: count_figures, read_number

   !> What `read_number` found: a number, none, one above 1e308
   integer, parameter, public :: number_found = 0, number_absent = 1, number_too_large = 2

   !> Powers of ten that are doubles
   real(wp), parameter :: powers(0:22) = [1.0e0_wp, 1.0e1_wp, 1.0e2_wp, 1.0e3_wp, 1.0e4_wp, &
      1.0e5_wp, 1.0e6_wp, 1.0e7_wp, 1.0e8_wp, 1.0e9_wp, 1.0e10_wp, 1.0e11_wp, 1.0e12_wp, &
      1.0e13_wp, 1.0e14_wp, 1.0e15_wp, 1.0e16_wp, 1.0e17_wp, 1.0e18_wp, 1.0e19_wp, 1.0e20_wp, &
      1.0e21_wp, 1.0e22_wp]
   integer, parameter :: exact_power = 22
   integer(int64), parameter :: exact_whole = 2_int64**53, half = 2_int64**31
   !> Another digit fits below this, (2^63 - 10)/10
   integer(int64), parameter :: room = 922337203685477579_int64
   integer, parameter :: largest_exponent = 99999

contains

   !> Read the number that begins at `at`. Then `at` is after it.
   pure subroutine read_number(text, at, last, value, status)
      !> Last character of the text
      integer, intent(in) :: last
      !> The text
      character(len=1), intent(in) :: text(last)
      !> First character of the number, then the one after its last
      integer, intent(inout) :: at
      !> The number, 0 if there is none
      real(wp), intent(out) :: value
      !> `number_found`, `number_absent` or `number_too_large`
      integer, intent(out) :: status
      integer(int64) :: whole
      integer :: i, digit, shift, digits, exponent
      logical :: is_negative, is_cut

      value = 0.0_wp
      status = number_absent
      i = at
      if (i > last) return
      is_negative = text(i) == '-'
      if (is_negative .or. text(i) == '+') i = i + 1
      whole = 0_int64
      shift = 0
      digits = 0
      is_cut = .false.
      do while (i <= last)
         digit = ichar(text(i)) - 48
         if (digit < 0 .or. digit > 9) exit
         if (whole < room) then
            whole = 10_int64*whole + digit
         else
            shift = shift + 1
            is_cut = is_cut .or. digit > 0
         end if
         digits = digits + 1
         i = i + 1
      end do
      if (i <= last) then
         if (text(i) == '.') then
            i = i + 1
            do while (i <= last)
               digit = ichar(text(i)) - 48
               if (digit < 0 .or. digit > 9) exit
               if (whole < room) then
                  whole = 10_int64*whole + digit
                  shift = shift - 1
               else
                  is_cut = is_cut .or. digit > 0
               end if
               digits = digits + 1
               i = i + 1
            end do
         end if
      end if
      if (digits == 0) return
      exponent = 0
      if (i < last) call read_exponent(text, i, last, exponent)
      exponent = exponent + shift
      status = number_found
      if (whole == 0_int64) then
         continue
      else if (.not. is_cut .and. whole <= exact_whole .and. abs(exponent) <= exact_power) then
         if (exponent < 0) then
            value = real(whole, wp)/powers(-exponent)
         else
            value = real(whole, wp)*powers(exponent)
         end if
         if (is_negative) value = -value
      else
         call read_slowly(text(at:i - 1), whole, exponent, is_cut, value, status)
      end if
      at = i
   end subroutine read_number

   !> Figures and decimals that a number is printed with: 0.0500 has 3 and 4, 1.5e-7 has 2 and 8.
   pure subroutine count_figures(text, at, last, figures, decimals)
      !> Last character of the text
      integer, intent(in) :: last
      !> The text
      character(len=1), intent(in) :: text(last)
      !> Before the number, with blanks and quotes between at most
      integer, intent(in) :: at
      !> From the first that is not 0
      integer, intent(out) :: figures
      !> Behind the point, with the exponent
      integer, intent(out) :: decimals
      integer :: exponent, i
      logical :: is_fraction

      figures = 0
      decimals = 0
      is_fraction = .false.
      i = at
      do while (i <= last)
         if (scan(text(i), '+-.0123456789') > 0) exit
         i = i + 1
      end do
      do while (i <= last)
         select case (text(i))
         case ('+', '-')
            continue
         case ('.')
            is_fraction = .true.
         case ('0':'9')
            if (figures > 0 .or. text(i) /= '0') figures = figures + 1
            if (is_fraction) decimals = decimals + 1
         case default
            exit
         end select
         i = i + 1
      end do
      exponent = 0
      if (i < last) call read_exponent(text, i, last, exponent)
      decimals = decimals - exponent
   end subroutine count_figures

   !> Read an exponent such as e-07, if there is one.
   pure subroutine read_exponent(text, i, last, exponent)
      integer, intent(in) :: last
      character(len=1), intent(in) :: text(last)
      integer, intent(inout) :: i
      integer, intent(inout) :: exponent
      integer :: k, digit, first
      logical :: is_negative

      select case (text(i))
      case ('e', 'E', 'd', 'D')
         continue
      case default
         return
      end select
      k = i + 1
      is_negative = text(k) == '-'
      if (is_negative .or. text(k) == '+') k = k + 1
      first = k
      do while (k <= last)
         digit = ichar(text(k)) - 48
         if (digit < 0 .or. digit > 9) exit
         exponent = min(10*exponent + digit, largest_exponent)
         k = k + 1
      end do
      if (k == first) return
      if (is_negative) exponent = -exponent
      i = k
   end subroutine read_exponent

   !> The number whose first digits are `whole`, times a power of ten.
   pure subroutine read_slowly(token, whole, exponent, is_cut, value, status)
      character(len=1), intent(in) :: token(:)
      integer(int64), intent(in) :: whole
      integer, intent(in) :: exponent
      !> Whether digits other than 0 follow the first ones
      logical, intent(in) :: is_cut
      real(wp), intent(out) :: value
      integer, intent(inout) :: status
      character(len=:), allocatable :: text
      integer :: i, magnitude, iostat
      logical :: is_sure

      value = 0.0_wp
      is_sure = .false.
      if (abs(exponent) <= 2*exact_power) call round_product(whole, exponent, is_cut, value, &
         is_sure)
      if (is_sure) then
         if (token(1) == '-') value = -value
         return
      end if
      ! whole is 10**magnitude to 10**(magnitude + 1)
      magnitude = exponent + int(log10(real(whole, wp)))
      if (magnitude < -330) then
         value = 0.0_wp
      else if (magnitude > 307) then
         status = number_too_large
      else
         allocate (character(len=size(token)) :: text)
         do i = 1, size(token)
            text(i:i) = token(i)
         end do
         read (text, *, iostat=iostat) value
         if (iostat /= 0) status = number_absent
      end if
   end subroutine read_slowly

   !> whole 10^exponent by sums of two doubles, and whether its rounding is sure.
   pure subroutine round_product(whole, exponent, is_cut, value, is_sure)
      integer(int64), intent(in) :: whole
      integer, intent(in) :: exponent
      logical, intent(in) :: is_cut
      real(wp), intent(out) :: value
      logical, intent(out) :: is_sure
      type(double_double) :: x
      real(wp) :: upper, lower, rest, unsure
      integer :: one, other

      one = min(abs(exponent), exact_power)
      other = abs(exponent) - one
      ! both halves of the whole number are doubles
      upper = real(whole/half, wp)*real(half, wp)
      lower = real(mod(whole, half), wp)
      x%high = upper + lower
      x%low = lower - (x%high - upper)
      if (exponent < 0) then
         x = ratio(ratio(x, powers(one)), powers(other))
      else
         x = (x*powers(one))*powers(other)
      end if
      value = x%high + x%low
      rest = x%low - (value - x%high)
      unsure = 1.0e-28_wp*value
      ! the digits that were cut are worth less than one of the last that was kept
      if (is_cut) unsure = unsure + value/real(whole, wp)
      is_sure = abs(rest) + unsure < 0.24_wp*spacing(value)
      if (.not. is_sure) is_sure = abs(abs(rest) - 0.5_wp*spacing(value)) > unsure &
         .and. abs(abs(rest) - 0.25_wp*spacing(value)) > unsure
   end subroutine round_product

   !> a/b to about 30 digits.
   pure type(double_double) function ratio(a, b)
      type(double_double), intent(in) :: a
      real(wp), intent(in) :: b
      type(double_double) :: low

      ratio = quotient(a%high, b)
      low = quotient(a%low, b)
      ratio%low = ratio%low + low%high
   end function ratio

end module asperity_height_map_text_numbers
