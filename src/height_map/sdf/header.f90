!> The header of a surface data file (ISO 25178-71, and the BCR proposal before it), in both of its
!> forms, and the values that mark missing points.
!>
!> The binary form: version, 8 bytes; maker, 10; dates of creation and change, 12 each; points and
!> profiles, 2 bytes each, 4 in version 2.0; scales of x, y and z and the resolution of z, doubles;
!> compression, type of the data and kind of check, 1 byte each. Lengths are in metres. A missing
!> point is the least number of a type, in the proposal the largest.
module asperity_height_map_sdf_header
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: byte_buffer, decode, float32, float64, &
      is_allowed_scale, sint16, sint32, sint8, uint16, uint32, uint8
   use asperity_height_map_file_errors, only: byte_error, map_error
   use asperity_height_map_type, only: height_map
   use asperity_height_map_units, only: map_hints, settle_step, settle_unit
   implicit none
   private
   public :: check_sdf_header, drop_markers, read_binary_header, sdf_header

   !> mm of a metre
   real(wp), parameter, public :: metre = 1.0e3_wp
   integer(int64), parameter :: scales_length = 35_int64

   !> What the header says.
   type :: sdf_header
      !> Points of a profile, and profiles
      integer(int64) :: nx = 0_int64, ny = 0_int64
      !> Scales, m
      real(wp) :: x_scale = 0.0_wp, y_scale = 0.0_wp, z_scale = 0.0_wp
      !> Type of the data, 0 to 7
      integer :: kind = float64
      integer :: compression = 0, check = 0
      !> Whether it follows the BCR proposal
      logical :: is_bcr = .false.
      !> Bytes before the sizes, and before the points
      integer(int64) :: sizes_offset = 0_int64, data_offset = 0_int64
   end type sdf_header

contains

   !> Read the header of the binary form.
   subroutine read_binary_header(source, is_bcr, is_second, header, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Whether it follows the BCR proposal, or version 2.0
      logical, intent(in) :: is_bcr, is_second
      !> What it says
      type(sdf_header), intent(out) :: header
      !> Set when the file ends within it
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: sizes(2), scales(4), types(3)
      integer :: kind

      header%is_bcr = is_bcr
      header%sizes_offset = 42_int64
      kind = merge(uint32, uint16, is_second)
      header%data_offset = header%sizes_offset + merge(8_int64, 4_int64, is_second) + scales_length
      if (source%size < header%data_offset) then
         call byte_error(error, source, source%size, 'the file ends within its header of '// &
            to_text(header%data_offset)//' bytes: it was cut off')
         return
      end if
      call read_numbers(source, header%sizes_offset, kind, sizes, error)
      if (allocated(error)) return
      header%nx = int(sizes(1), int64)
      header%ny = int(sizes(2), int64)
      call read_numbers(source, header%data_offset - scales_length, float64, scales, error)
      if (allocated(error)) return
      header%x_scale = scales(1)
      header%y_scale = scales(2)
      header%z_scale = scales(3)
      call read_numbers(source, header%data_offset - 3_int64, uint8, types, error)
      if (allocated(error)) return
      header%compression = int(types(1))
      header%kind = int(types(2))
      header%check = int(types(3))
   end subroutine read_binary_header

   subroutine read_numbers(source, offset, kind, values, error)
      type(byte_source), intent(inout) :: source
      integer(int64), intent(in) :: offset
      integer, intent(in) :: kind
      real(wp), intent(out) :: values(:)
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      integer(int64) :: n

      n = size(values)*8_int64
      allocate (buffer%bytes(n))
      buffer%bytes = 0
      n = min(n, source%size - offset)
      call read_at(source, offset, c_loc(buffer%bytes), n, error)
      if (.not. allocated(error)) call decode(buffer, kind, values)
   end subroutine read_numbers

   !> Set the steps of a map, and the factor from numbers to mm; `error` names what is not allowed.
   pure subroutine check_sdf_header(source, header, hints, map, factor, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> What its header says
      type(sdf_header), intent(in) :: header
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Its steps are set
      type(height_map), intent(inout) :: map
      !> mm of one
      real(wp), intent(out) :: factor
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: unit

      factor = 0.0_wp
      if (header%compression /= 0 .or. header%check /= 0) then
         call map_error(error, source, 'compression '//to_text(header%compression)//', check '// &
            to_text(header%check)//': only 0 and 0 are read: save it without compression and '// &
            'without check')
         return
      else if (header%kind < uint8 .or. header%kind > float64) then
         call map_error(error, source, &
            'data type '//to_text(header%kind)//' is unknown: allowed '// &
            'are '//to_text(uint8)//' to '//to_text(float64)//'; the header is wrong')
         return
      end if
      call settle_unit(source%name, 'lengths', '--lateral-unit', 'm', hints%lateral_unit, unit, &
         error)
      if (allocated(error)) return
      call settle_unit(source%name, 'heights', '--height-unit', 'm', hints%height_unit, unit, error)
      if (allocated(error)) return
      call set_step(source, 'Xscale', header%x_scale, 'x', hints%step_x, map%step_x, error)
      if (allocated(error)) return
      ! a profile has no other line
      map%step_y = map%step_x
      if (header%ny > 1_int64) call set_step(source, 'Yscale', header%y_scale, 'y', hints%step_y, &
         map%step_y, error)
      if (allocated(error)) return
      if (is_allowed_scale(header%z_scale)) factor = header%z_scale*metre
      if (.not. is_allowed_scale(factor)) call map_error(error, source, 'Zscale '// &
         to_text(header%z_scale)//' is not allowed: it must be above 0 and finite')
   end subroutine check_sdf_header

   pure subroutine set_step(source, name, scale, axis, hint, step, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: name, axis
      real(wp), intent(in) :: scale, hint
      real(wp), intent(out) :: step
      type(error_type), allocatable, intent(out) :: error
      logical :: is_allowed

      step = 0.0_wp
      is_allowed = is_finite(scale)
      if (is_allowed) is_allowed = scale > 0.0_wp .and. scale < 1.0e10_wp
      if (is_allowed) then
         call settle_step(source%name, axis, scale*metre, hint, step, error)
      else
         call map_error(error, source, name//' '//to_text(scale)//' m is not allowed: the '// &
            'distance of points must be above 0 and finite; correct the header')
      end if
   end subroutine set_step

   !> Turn the values that mark missing points into `none`. Of the proposal's signed
   !> numbers both ends do, as programs differ.
   pure subroutine drop_markers(values, kind, is_bcr)
      !> Numbers of the file
      real(wp), intent(inout) :: values(:)
      !> Their type
      integer, intent(in) :: kind
      !> Whether the file follows the BCR proposal
      logical, intent(in) :: is_bcr
      real(wp) :: low, high

      low = -huge(1.0_wp)
      high = huge(1.0_wp)
      select case (kind)
      case (uint8)
         high = 255.0_wp
      case (uint16)
         high = 65535.0_wp
      case (uint32)
         high = 4294967295.0_wp
      case (sint8)
         low = -128.0_wp
         if (is_bcr) high = 127.0_wp
      case (sint16)
         low = -32768.0_wp
         if (is_bcr) high = 32767.0_wp
      case (sint32)
         low = -2147483648.0_wp
         if (is_bcr) high = 2147483647.0_wp
      case (float32)
         low = -3.4e38_wp
         high = 3.4e38_wp
      case default
         low = -1.7e308_wp
         high = 1.7e308_wp
      end select
      where ((values <= low .or. values >= high) .and. is_finite(values)) values = none
   end subroutine drop_markers

end module asperity_height_map_sdf_header
