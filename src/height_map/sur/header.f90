!> The header of a SUR file of Digital Surf: 512 bytes, little end first.
!>
!> There is no published standard. The layout is that of the documentation of MountainsMap as its
!> public readers have it (surfalize, SurfaceTopography and RosettaSciIO in Python agree on every
!> place used here): 0 code, 12 bytes; 12 format; 14 number of objects; 18 kind of object; 86
!> whether points are missing; 98 bits of a point; 100 least point; 108 points of a line; 112
!> lines; 116 points, 120 to 131 spacings of x, y and z, singles; 180, 196 and 212 their units,
!> 16 bytes each; 290 inversion; 324 bytes of compressed data; 334 and 336 lengths of comment and
!> private zone, which follow the header; 474 offset of z, a single.
module asperity_height_map_sur_header
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: byte_buffer, float32, is_allowed_scale, &
      number_at, sint16, sint32, uint16, uint32
   use asperity_height_map_file_errors, only: byte_error, plain_excerpt
   use asperity_height_map_type, only: height_map
   use asperity_height_map_units, only: map_hints, plain_unit, settle_step, settle_unit
   implicit none
   private
   public :: check_sur_header, read_sur_header, sur_header

   integer(int64), parameter :: header_length = 512_int64
   !> Kinds of objects that are surfaces: of Gwyddion, of others, with an image behind
   integer, parameter :: surfaces(3) = [1, 2, 11]

   !> What the header says.
   type :: sur_header
      !> Points of a line, lines and their product
      integer(int64) :: nx = 0_int64, ny = 0_int64, points = 0_int64
      !> Number of objects, kind of object, inversion, format, bits of a point
      integer :: objects = 0, object = 0, inversion = 0, format = 0, bits = 0
      !> Whether points are missing, and the number they have
      logical :: has_missing = .false.
      !> That number
      real(wp) :: marker = 0.0_wp
      !> Spacings and offset of z, in their units
      real(wp) :: spacing(3) = 0.0_wp, offset = 0.0_wp
      !> Units of x, y and z, as used here, and as they stand in the file
      character(len=8) :: units(3) = ''
      character(len=16) :: units_said(3) = ''
      !> Bytes before the data, and of compressed data
      integer(int64) :: data_offset = 0_int64, compressed = 0_int64
   end type sur_header

contains

   !> Read the header.
   subroutine read_sur_header(source, header, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What it says
      type(sur_header), intent(out) :: header
      !> Set when the file ends within it
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      character(len=16) :: text
      integer :: i, k

      if (source%size < header_length) then
         call byte_error(error, source, source%size, 'the file ends within its header of 512 '// &
            'bytes: it was cut off')
         return
      end if
      allocate (buffer%bytes(header_length))
      call read_at(source, 0_int64, c_loc(buffer%bytes), header_length, error)
      if (allocated(error)) return
      header%format = nint(number_at(buffer, 12, sint16))
      header%objects = nint(number_at(buffer, 14, sint16))
      header%object = nint(number_at(buffer, 18, sint16))
      header%has_missing = nint(number_at(buffer, 86, sint16)) /= 0
      header%bits = nint(number_at(buffer, 98, sint16))
      ! a missing point is two below the least measured one
      header%marker = number_at(buffer, 100, sint32) - 2.0_wp
      header%nx = int(number_at(buffer, 108, sint32), int64)
      header%ny = int(number_at(buffer, 112, sint32), int64)
      header%points = int(number_at(buffer, 116, sint32), int64)
      header%inversion = nint(number_at(buffer, 290, sint16))
      header%compressed = int(number_at(buffer, 324, uint32), int64)
      header%data_offset = header_length + int(number_at(buffer, 334, uint16), int64) &
         + int(number_at(buffer, 336, uint16), int64)
      header%offset = number_at(buffer, 474, float32)
      do i = 1, 3
         header%spacing(i) = number_at(buffer, 116 + 4*i, float32)
         do k = 1, 16
            text(k:k) = char(modulo(int(buffer%bytes(164 + 16*i + k)), 256))
         end do
         header%units(i) = plain_unit(text)
         k = index(text, achar(0))
         if (k > 0) text(k:) = ''
         header%units_said(i) = text
      end do
   end subroutine read_sur_header

   !> Set the steps of a map, factor and offset of its heights; `error` names what is not allowed.
   subroutine check_sur_header(source, header, hints, map, factor, offset, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> What its header says
      type(sur_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Its steps are set
      type(height_map), intent(inout) :: map
      !> mm of one, and height of the number 0, mm
      real(wp), intent(out) :: factor, offset
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: unit(3)

      factor = 0.0_wp
      offset = 0.0_wp
      if (header%format /= 0) then
         call byte_error(error, source, 12_int64, 'format '//to_text(header%format)//' is not '// &
            'read, only 0, numbers with their little end first: save it as SDF or X3P')
      else if (all(header%object /= surfaces)) then
         call byte_error(error, source, 18_int64, 'the object is of kind '// &
            to_text(header%object)//': only surfaces, kinds 1, 2 and 11, are read')
      else if (header%bits /= 16 .and. header%bits /= 32) then
         call byte_error(error, source, 98_int64, to_text(header%bits)//' bits of a point: '// &
            'allowed are 16 and 32')
      else if (header%inversion /= 0) then
         call byte_error(error, source, 290_int64, 'heights are marked as inverted ('// &
            to_text(header%inversion)//'): whether the stored ones are, programs do not agree; '// &
            'save it as SDF or X3P')
      else if (header%nx < 1_int64 .or. header%ny < 1_int64 .or. &
         header%nx*header%ny /= header%points) then
         call byte_error(error, source, 108_int64, 'the header promises '//to_text(header%nx)// &
            ' x '//to_text(header%ny)//' points, and '//to_text(header%points)//' in all')
      end if
      if (allocated(error)) return
      call check_lengths(source, header, hints, unit, error)
      if (allocated(error)) return
      call settle_step(source%name, 'x', header%spacing(1)*unit(1), hints%step_x, map%step_x, error)
      if (allocated(error)) return
      ! a profile has no other line
      map%step_y = map%step_x
      if (header%ny > 1_int64) call settle_step(source%name, 'y', header%spacing(2)*unit(2), &
         hints%step_y, map%step_y, error)
      if (allocated(error)) return
      factor = header%spacing(3)*unit(3)
      ! the zero of heights matters little: where the field holds rubbish it is left out
      if (is_finite(header%offset)) then
         if (abs(header%offset) <= 1.0e6_wp/unit(3)) offset = header%offset*unit(3)
      end if
   end subroutine check_sur_header

   !> Check spacings and units, and set the units' lengths.
   subroutine check_lengths(source, header, hints, unit, error)
      type(byte_source), intent(in) :: source
      type(sur_header), intent(in) :: header
      type(map_hints), intent(in) :: hints
      real(wp), intent(out) :: unit(3)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: axes = 'xyz'
      character(len=8) :: hint
      integer :: i

      unit = 0.0_wp
      do i = 1, 3
         if (i == 2 .and. header%ny == 1_int64) cycle
         hint = hints%lateral_unit
         if (i == 3) hint = hints%height_unit
         if (header%units(i) == '' .and. header%units_said(i) /= '') then
            call byte_error(error, source, 164_int64 + 16_int64*i, 'the unit of '//axes(i:i)// &
               ' is '//plain_excerpt(trim(header%units_said(i)), 16)// &
               ', which is no length that is known (m, cm, mm, um and nm are): '// &
               'export heights, with all lengths in one of them')
            return
         end if
         if (i == 3) then
            call settle_unit(source%name, 'heights', '--height-unit', header%units(i), hint, &
               unit(i), error)
         else
            call settle_unit(source%name, 'lengths', '--lateral-unit', header%units(i), hint, &
               unit(i), error)
         end if
         if (allocated(error)) return
         ! a single that is no number is huge here
         if (is_finite(header%spacing(i))) then
            if (header%spacing(i) > 0.0_wp .and. header%spacing(i) < 1.0e38_wp) then
               if (is_allowed_scale(header%spacing(i)*unit(i))) cycle
            end if
         end if
         call byte_error(error, source, 116_int64 + 4_int64*i, 'spacing '// &
            to_text(header%spacing(i))//' in '//axes(i:i)// &
            ' is not allowed: it must be above 0 '// &
            'and finite')
         return
      end do
   end subroutine check_lengths

end module asperity_height_map_sur_header
