!> Reads PLU files of Sensofar's microscopes, which Leica sold as DCM 3D; also named .apx.
!>
!> There is no published standard. The layout is that which the public readers of Gwyddion, in C,
!> and SurfaceTopography, in Python, agree on, little end first: 0 date as text, 128 bytes; 132
!> comment, 256 bytes; 388 lines and 392 points of a line, 404 and 408 steps of x and y, singles;
!> 428 kind of measurement; 448 settings, 40 bytes; 489 number of layers; 490 version of the
!> format; 492 number of images behind a layer; 500 the first layer: lines, points of a line,
!> singles, their least and largest. Lengths are in um, and 1000001 is a missing point. (surfalize
!> 0.19.2 takes the two numbers before the singles for the first two of them.)
module asperity_height_map_plu_read
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: byte_buffer, bytes_of, float32, is_allowed_scale, &
      number_at, uint32, uint8
   use asperity_height_map_file_errors, only: byte_error, fits_memory
   use asperity_height_map_read_rows, only: read_rows
   use asperity_height_map_type, only: add_note, allocate_heights, height_map
   use asperity_height_map_units, only: map_hints, settle_step, settle_unit
   implicit none
   private
   public :: is_plu, read_plu

   integer, parameter :: header_length = 508, date_length = 128
   !> Where fields are
   integer, parameter :: at_steps = 404, at_kind = 428, at_layers = 489, at_version = 490, &
      at_size = 500
   !> Least number of the versions but the first, which is 0
   integer, parameter :: least_version = 240
   !> Kinds of measurement, from 0 on
   integer, parameter :: topography = 3
   character(len=*), parameter :: kinds(0:8) = [character(len=30) :: 'an image', 'a profile', &
      'several profiles', 'a topography', 'profiles at several places', &
      'a thickness at one point', &
      'a custom one', 'topographies at several places', 'thicknesses at several places']
   real(wp), parameter :: missing = 1000001.0_wp

contains

   !> Whether a file begins as a PLU file, which has no code of its own: a date with its time as
   !> text, zeros behind it, and a version there is.
   pure logical function is_plu(head)
      !> Its first bytes
      character(len=*), intent(in) :: head
      integer :: i, n, version

      is_plu = .false.
      if (len(head) < header_length) return
      n = index(head(:date_length), achar(0)) - 1
      if (n < 8) return
      do i = 1, n
         if (ichar(head(i:i)) < 32) return
      end do
      version = ichar(head(at_version + 1:at_version + 1))
      is_plu = index(head(:n), ':') > 0 .and. scan(head(:n), '0123456789') > 0 .and. &
         (version == 0 .or. version >= least_version)
   end function is_plu

   !> Read a file.
   subroutine read_plu(source, hints, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      integer(int64) :: nx, ny
      real(wp) :: height_unit

      allocate (buffer%bytes(header_length))
      call read_at(source, 0_int64, c_loc(buffer%bytes), int(header_length, int64), error)
      if (allocated(error)) return
      call check_header(source, buffer, hints, map, height_unit, error)
      if (allocated(error)) return
      ny = int(number_at(buffer, at_size, uint32), int64)
      nx = int(number_at(buffer, at_size + 4, uint32), int64)
      call fits_memory(source, nx, ny, (source%size - header_length)/bytes_of(float32), &
         int(at_size, int64), error)
      if (allocated(error)) return
      call allocate_heights(source%name, nx, ny, map, error)
      if (allocated(error)) return
      call read_rows(source, int(header_length, int64), float32, height_unit, missing, map, error)
   end subroutine read_plu

   !> Set the steps of a map and the unit of its heights; `error` names what is not allowed.
   subroutine check_header(source, buffer, hints, map, height_unit, error)
      type(byte_source), intent(in) :: source
      type(byte_buffer), intent(in) :: buffer
      type(map_hints), intent(in) :: hints
      type(height_map), intent(inout) :: map
      !> mm
      real(wp), intent(out) :: height_unit
      type(error_type), allocatable, intent(out) :: error
      character(len=*), parameter :: unit = 'um', axes = 'xy'
      real(wp) :: kind, lateral_unit, layers, steps(2)
      integer :: i

      height_unit = 0.0_wp
      kind = number_at(buffer, at_kind, uint32)
      layers = number_at(buffer, at_layers, uint8)
      if (kind > real(ubound(kinds, 1), wp)) then
         call byte_error(error, source, int(at_kind, int64), 'measurement of kind '// &
            to_text(int(kind, int64))//': kinds 0 to '//to_text(ubound(kinds, 1))//' are known')
      else if (nint(kind) /= topography) then
         call byte_error(error, source, int(at_kind, int64), 'the measurement is '// &
            trim(kinds(nint(kind)))//', kind '//to_text(nint(kind))//': only topographies, '// &
            'kind '//to_text(topography)//', are read; export it as text')
      else if (nint(layers) == 0) then
         call byte_error(error, source, int(at_layers, int64), 'the file holds no layer of heights')
      end if
      if (allocated(error)) return
      if (nint(layers) > 1) call add_note(map, 'the file holds '//to_text(nint(layers))// &
         ' layers: the first is read.')
      call settle_unit(source%name, 'lengths', '--lateral-unit', unit, hints%lateral_unit, &
         lateral_unit, error)
      if (allocated(error)) return
      call settle_unit(source%name, 'heights', '--height-unit', unit, hints%height_unit, &
         height_unit, error)
      if (allocated(error)) return
      do i = 1, 2
         steps(i) = number_at(buffer, at_steps + 4*(i - 1), float32)
         if (is_finite(steps(i))) then
            if (is_allowed_scale(steps(i))) cycle
         end if
         call byte_error(error, source, int(at_steps + 4*(i - 1), int64), 'step '// &
            to_text(steps(i))//' um in '//axes(i:i)//' is not allowed: it must be above 0 and '// &
            'finite')
         return
      end do
      call settle_step(source%name, 'x', steps(1)*lateral_unit, hints%step_x, map%step_x, error)
      if (allocated(error)) return
      call settle_step(source%name, 'y', steps(2)*lateral_unit, hints%step_y, map%step_y, error)
   end subroutine check_header

end module asperity_height_map_plu_read
