!> Reads Gwyddion Simple Field files (GSF): lines of a header, `key = value`, zeros up to the next
!> multiple of 4 bytes, singles, their little end first, the first line first. The layout is that
!> of the format's documentation in Gwyddion's user guide, which Gwyddion and the package gsffile
!> follow.
module asperity_height_map_gwyddion_gsf
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: bytes_of, float32
   use asperity_height_map_file_errors, only: byte_error, fits_memory, plain_excerpt
   use asperity_height_map_read_rows, only: read_rows
   use asperity_height_map_text_header_fields, only: number_in
   use asperity_height_map_type, only: allocate_heights, height_map
   use asperity_height_map_units, only: map_hints, plain_unit, settle_step, settle_unit
   implicit none
   private
   public :: read_gsf

   !> How a file begins
   character(len=*), parameter, public :: gsf_magic = 'Gwyddion Simple Field 1.0'//achar(10)
   !> Most bytes of a header
   integer, parameter :: longest_header = 65536

   !> What the header says.
   type :: gsf_header
      !> Points of a line and lines; lengths of both sides in their unit, 0 where it does not say it
      real(wp) :: nx = 0.0_wp, ny = 0.0_wp, length_x = 0.0_wp, length_y = 0.0_wp
      !> Units of the sides and of the heights, as they stand in the file
      character(len=:), allocatable :: lateral_unit, unit
      !> Bytes before the heights
      integer(int64) :: data_offset = 0_int64
   end type gsf_header

contains

   !> Read a file.
   subroutine read_gsf(source, hints, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(gsf_header) :: header
      real(wp) :: factor, unit
      integer(int64) :: nx, ny, room

      call read_header(source, header, error)
      if (allocated(error)) return
      nx = int(header%nx, int64)
      ny = int(header%ny, int64)
      room = (source%size - header%data_offset)/bytes_of(float32)
      call fits_memory(source, nx, ny, room, 0_int64, error)
      if (allocated(error)) return
      if (source%size - header%data_offset /= nx*ny*bytes_of(float32)) then
         call byte_error(error, source, header%data_offset + nx*ny*bytes_of(float32), &
            'bytes follow the '//to_text(nx)//' x '//to_text(ny)//' points that the header '// &
            'promises')
         return
      end if
      call settle_one('lengths', '--lateral-unit', header%lateral_unit, hints%lateral_unit, unit)
      if (allocated(error)) return
      call settle_one('heights', '--height-unit', header%unit, hints%height_unit, factor)
      if (allocated(error)) return
      call settle_step(source%name, 'x', header%length_x/header%nx*unit, hints%step_x, &
         map%step_x, error)
      if (allocated(error)) return
      call settle_step(source%name, 'y', header%length_y/header%ny*unit, hints%step_y, &
         map%step_y, error)
      if (allocated(error)) return
      call allocate_heights(source%name, nx, ny, map, error)
      if (allocated(error)) return
      call read_rows(source, header%data_offset, float32, factor, none, map, error)

   contains

      !> The length of a unit, which must be one if the file says any.
      subroutine settle_one(what, option, said, hint, length)
         character(len=*), intent(in) :: what, option, said, hint
         real(wp), intent(out) :: length

         length = 0.0_wp
         if (said /= '' .and. plain_unit(said) == '') then
            call byte_error(error, source, 0_int64, 'its '//what//' are in '// &
               plain_excerpt(said, 16)//', which is no length that is known (m, cm, mm, um and '// &
               'nm are): export heights')
         else
            call settle_unit(source%name, what, option, plain_unit(said), hint, length, error)
         end if
      end subroutine settle_one

   end subroutine read_gsf

   subroutine read_header(source, header, error)
      type(byte_source), intent(inout) :: source
      type(gsf_header), intent(out) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=1), allocatable, target :: block(:)
      character(len=:), allocatable :: text
      integer :: at, finish, i, length

      header%lateral_unit = ''
      header%unit = ''
      length = int(min(source%size, int(longest_header, int64)))
      allocate (block(length))
      call read_at(source, 0_int64, c_loc(block), int(length, int64), error)
      if (allocated(error)) return
      do i = 1, length
         if (block(i) == achar(0)) exit
      end do
      if (i > length) then
         call byte_error(error, source, int(length, int64), 'the header ends with no zero byte '// &
            'within '//to_text(longest_header)//' bytes: the file was cut off or damaged')
         return
      end if
      header%data_offset = 4_int64*((i - 1)/4 + 1)
      allocate (character(len=i - 1) :: text)
      do i = 1, len(text)
         text(i:i) = block(i)
      end do
      at = len(gsf_magic) + 1
      do while (at <= len(text))
         finish = index(text(at:), achar(10)) + at - 2
         if (finish < at - 1) finish = len(text)
         call read_line(source, text(at:finish), at - 1, header, error)
         if (allocated(error)) return
         at = finish + 2
      end do
      if (header%nx < 1.0_wp .or. header%ny < 1.0_wp) call byte_error(error, source, 0_int64, &
         'the header has no XRes or no YRes, the numbers of points')
   end subroutine read_header

   !> Read a line of the header; other keys are left out.
   subroutine read_line(source, line, offset, header, error)
      type(byte_source), intent(in) :: source
      character(len=*), intent(in) :: line
      !> Bytes before it
      integer, intent(in) :: offset
      type(gsf_header), intent(inout) :: header
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: value
      integer :: mark

      mark = index(line, '=')
      if (mark == 0) return
      value = trim(adjustl(line(mark + 1:)))
      if (len(value) > 0) then
         ! lines of MS-DOS
         if (value(len(value):) == achar(13)) value = trim(value(:len(value) - 1))
      end if
      select case (adjustl(line(:mark - 1)))
      case ('XRes')
         call take(1.0_wp, 1.0e15_wp, 'a whole number above 0', header%nx)
         header%nx = aint(header%nx)
      case ('YRes')
         call take(1.0_wp, 1.0e15_wp, 'a whole number above 0', header%ny)
         header%ny = aint(header%ny)
      case ('XReal')
         call take(1.0e-30_wp, 1.0e30_wp, 'a number above 0', header%length_x)
      case ('YReal')
         call take(1.0e-30_wp, 1.0e30_wp, 'a number above 0', header%length_y)
      case ('XYUnits')
         header%lateral_unit = value
      case ('ZUnits')
         header%unit = value
      case default
         return
      end select

   contains

      !> Take a number within limits.
      subroutine take(least, largest, allowed, number)
         real(wp), intent(in) :: least, largest
         character(len=*), intent(in) :: allowed
         real(wp), intent(inout) :: number
         character(len=:), allocatable :: rest
         real(wp) :: new
         logical :: is_right

         call number_in(value, new, is_right, rest)
         if (is_right) is_right = rest == '' .and. new >= least .and. new <= largest
         if (is_right) then
            number = new
         else
            call byte_error(error, source, int(offset, int64), &
               trim(adjustl(line(:mark - 1)))//' = '//plain_excerpt(value, 20)//' is not '// &
               'allowed: it must be '//allowed)
         end if
      end subroutine take

   end subroutine read_line

end module asperity_height_map_gwyddion_gsf
