!> From the numbers of a file to heights in mm: binary numbers, markers of missing points, scale.
module asperity_height_map_decode_heights
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_loc
   use, intrinsic :: iso_fortran_env, only: int16, int32, int64, int8, real32, real64
   use asperity_base_finite, only: is_finite, is_nan
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: byte_buffer, decode, height_message, is_allowed_scale, number_at, scale_heights

   !> Kinds of numbers, as ISO 25178-71 counts them
   integer, parameter, public :: uint8 = 0, uint16 = 1, uint32 = 2, float32 = 3, sint8 = 4, &
      sint16 = 5, sint32 = 6, float64 = 7
   !> Bytes of each kind
   integer(int64), parameter, public :: bytes_of(uint8:float64) = &
      [1_int64, 2_int64, 4_int64, 4_int64, 1_int64, 2_int64, 4_int64, 8_int64]
   !> Largest height of either sign, mm: a marker of missing points of a file that does not say so
   !> is larger
   real(wp), parameter :: largest_height = 1.0e6_wp

   !> Bytes as they are in a file, little end first.
   type :: byte_buffer
      !> The bytes
      integer(int8), allocatable :: bytes(:)
   end type byte_buffer

contains

   !> The numbers in a buffer; infinities stay, what is no number becomes `none`.
   subroutine decode(buffer, kind, values)
      !> The bytes of size(values) numbers
      type(byte_buffer), intent(in), target :: buffer
      !> One of the kinds above
      integer, intent(in) :: kind
      !> The numbers
      real(wp), intent(out) :: values(:)
      integer(int8), pointer :: bytes(:)
      integer(int16), pointer :: shorts(:)
      integer(int32), pointer :: words(:)
      real(real64), pointer :: doubles(:)
      integer :: n

      n = size(values)
      select case (kind)
      case (uint8, sint8)
         call c_f_pointer(c_loc(buffer%bytes), bytes, [n])
         values = real(bytes, wp)
         if (kind == uint8) where (values < 0.0_wp) values = values + 256.0_wp
      case (uint16, sint16)
         call c_f_pointer(c_loc(buffer%bytes), shorts, [n])
         values = real(shorts, wp)
         if (kind == uint16) where (values < 0.0_wp) values = values + 65536.0_wp
      case (uint32, sint32)
         call c_f_pointer(c_loc(buffer%bytes), words, [n])
         values = real(words, wp)
         if (kind == uint32) where (values < 0.0_wp) values = values + 4294967296.0_wp
      case (float32)
         call c_f_pointer(c_loc(buffer%bytes), words, [n])
         values = wide(words)
      case default
         call c_f_pointer(c_loc(buffer%bytes), doubles, [n])
         values = doubles
         where (is_nan(values)) values = none
      end select
   end subroutine decode

   !> One number of a buffer.
   real(wp) function number_at(buffer, offset, kind)
      !> The bytes
      type(byte_buffer), intent(in) :: buffer
      !> How many stand before it
      integer, intent(in) :: offset
      !> One of the kinds above
      integer, intent(in) :: kind
      type(byte_buffer) :: piece
      real(wp) :: value(1)

      allocate (piece%bytes(bytes_of(kind)))
      piece%bytes(:) = buffer%bytes(offset + 1:offset + size(piece%bytes))
      call decode(piece, kind, value)
      number_at = value(1)
   end function number_at

   !> A single-precision number by its bits: converting what is no number may trap.
   pure elemental real(wp) function wide(bits)
      integer(int32), intent(in) :: bits
      integer(int32), parameter :: exponent_bits = int(z'7F800000', int32)
      integer(int32), parameter :: fraction_bits = int(z'007FFFFF', int32)

      if (iand(bits, exponent_bits) /= exponent_bits) then
         wide = real(transfer(bits, 1.0_real32), wp)
      else if (iand(bits, fraction_bits) /= 0_int32) then
         wide = none
      else
         ! infinity, also of a double
         wide = transfer(int(z'7FF0000000000000', int64), 1.0_wp)
      end if
   end function wide

   !> Whether a factor from a file's numbers to mm keeps clear of overflow.
   pure logical function is_allowed_scale(factor)
      !> The factor
      real(wp), intent(in) :: factor

      is_allowed_scale = is_finite(factor)
      if (is_allowed_scale) is_allowed_scale = factor >= 1.0e-30_wp .and. factor <= 1.0e30_wp
   end function is_allowed_scale

   !> Heights in mm: values factor + offset. `bad` is the first that is infinite or beyond 1 km.
   pure subroutine scale_heights(values, factor, offset, bad)
      !> Numbers of the file, then heights; those from `none` on stay
      real(wp), intent(inout) :: values(:)
      !> An allowed scale, and its zero, mm
      real(wp), intent(in) :: factor, offset
      !> 0 if all are allowed
      integer, intent(out) :: bad
      real(wp) :: largest
      integer :: i

      largest = largest_height/factor
      bad = 0
      do i = 1, size(values)
         if (abs(values(i)) <= largest) then
            values(i) = values(i)*factor + offset
         else if (.not. is_finite(values(i)) .or. values(i) < none) then
            bad = i
            return
         end if
      end do
   end subroutine scale_heights

   !> What is wrong with a number that `scale_heights` refused.
   pure subroutine height_message(value, factor, message)
      !> The number as it stands in the file
      real(wp), intent(in) :: value
      !> mm of one
      real(wp), intent(in) :: factor
      !> For an error
      character(len=:), allocatable, intent(out) :: message

      message = 'height '//to_text(value, 6)//' is not allowed: '
      if (is_finite(value)) then
         message = message//'in units of '//to_text(factor, 6)//' mm it is beyond 1 km: check '// &
            'the unit, or mark missing points as such'
      else
         message = message//'it must be a finite number, or NaN where it is missing'
      end if
   end subroutine height_message

end module asperity_height_map_decode_heights
