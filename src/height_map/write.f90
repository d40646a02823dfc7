!> Height maps as the bytes of a file: SDF, or text with 17 figures.
!>
!> SDF has every bit in doubles. Where points are missing it has integers of 32 bits, as all readers
!> know their code of a missing point, and not that of doubles: heights are then rounded to
!> 1/(2^31 - 1) of the largest of either sign.
module asperity_height_map_write
   use, intrinsic :: iso_fortran_env, only: int16, int32, int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory, check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_decode_heights, only: bytes_of, float64, sint32
   use asperity_height_map_type, only: check_height_map, height_map, missing_points
   implicit none
   private
   public :: height_map_bytes

   !> mm of a metre, and the scale that makes numbers of it mm
   real(wp), parameter :: metre = 1.0e3_wp, millimetre = 1.0e-3_wp
   character(len=*), parameter :: line_end = achar(10)
   !> Largest integer, the code of a missing point, and the least height that heights may have
   real(wp), parameter :: largest_whole = real(huge(1_int32), wp), tiny_height = 1.0e-12_wp
   integer(int32), parameter :: hole = -huge(1_int32) - 1_int32
   integer(int64), parameter :: number_width = 24_int64

contains

   !> The bytes of a file of a map.
   subroutine height_map_bytes(map, ending, bytes, error)
      !> The map
      type(height_map), intent(in) :: map
      !> `sdf`: binary, ISO 25178-71, m; `xyz`: lines x y z, mm; `csv`: a matrix with a header, mm
      character(len=*), intent(in) :: ending
      !> The file
      character(len=:), allocatable, intent(out) :: bytes
      !> Set when the map is not sound, or the ending is unknown
      type(error_type), allocatable, intent(out) :: error

      bytes = ''
      call check_height_map(map, error)
      if (allocated(error)) return
      select case (ending)
      case ('sdf')
         call write_sdf(map, bytes, error)
      case ('xyz')
         call write_xyz(map, bytes, error)
      case ('csv')
         call write_csv(map, bytes, error)
      case default
         call fatal_error(error, &
            'height maps are not written as '//ending//': allowed are sdf, '// &
            'xyz and csv')
      end select
   end subroutine height_map_bytes

   subroutine write_sdf(map, bytes, error)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      type(error_type), allocatable, intent(inout) :: error
      character(len=:), allocatable :: head
      integer(int64) :: at, length, width
      integer :: i, j, status
      logical :: has_holes, is_small
      real(wp) :: scale

      has_holes = missing_points(map) > 0
      scale = millimetre
      if (has_holes) scale = millimetre*max(maxval(abs(map%heights), &
         mask=map%heights < none), tiny_height)/largest_whole
      associate (nx => size(map%heights, 1), ny => size(map%heights, 2))
         is_small = max(nx, ny) < 65536
         head = 'bISO-1.0asperity  '//repeat('0', 24)
         if (is_small) then
            head = head//short(nx)//short(ny)
         else
            head(6:6) = '2'
            head = head//transfer(int(nx, int32), '1234')//transfer(int(ny, int32), '1234')
         end if
      end associate
      ! neither compressed nor checked
      head = head//double(scale_of(map%step_x))//double(scale_of(map%step_y))// &
         double(scale)// &
         double(-1.0_wp)//achar(0)//achar(merge(sint32, float64, has_holes))//achar(0)
      width = bytes_of(merge(sint32, float64, has_holes))
      deallocate (bytes)
      length = len(head) + width*size(map%heights, kind=int64)
      allocate (character(len=length) :: bytes, stat=status)
      call check_memory(status, map%source, length, error)
      ! for what is written beside it
      call check_room(map%source, 0_int64, error)
      if (allocated(error)) return
      bytes(:len(head)) = head
      at = len(head)
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (.not. has_holes) then
               bytes(at + 1:at + width) = double(map%heights(i, j))
            else if (map%heights(i, j) >= none) then
               bytes(at + 1:at + width) = transfer(hole, '1234')
            else
               bytes(at + 1:at + width) = transfer(nint(map%heights(i, j)/(scale*metre), int32), &
                  '1234')
            end if
            at = at + width
         end do
      end do
   end subroutine write_sdf

   pure function double(value) result(bytes)
      real(wp), intent(in) :: value
      character(len=8) :: bytes

      bytes = transfer(value, bytes)
   end function double

   pure function short(value) result(bytes)
      integer, intent(in) :: value
      character(len=2) :: bytes

      bytes = transfer(int(merge(value, value - 65536, value < 32768), int16), bytes)
   end function short

   !> The length in m that comes back as the step, or as close to it as can be.
   pure real(wp) function scale_of(step)
      real(wp), intent(in) :: step
      real(wp) :: tried
      integer :: i

      scale_of = step/metre
      do i = -1, 1
         tried = step/metre + i*spacing(step/metre)
         if (abs(tried*metre - step) < abs(scale_of*metre - step)) scale_of = tried
      end do
   end function scale_of

   subroutine write_xyz(map, bytes, error)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      type(error_type), allocatable, intent(inout) :: error
      character(len=40), allocatable :: x(:)
      character(len=:), allocatable :: y
      integer(int64) :: used
      integer :: i, j

      allocate (x(size(map%heights, 1)))
      do i = 1, size(x)
         x(i) = to_text((i - 1)*map%step_x)
      end do
      used = 0_int64
      call add(map, bytes, used, error, '# x [mm] y [mm] z [mm]'//line_end)
      do j = 1, size(map%heights, 2)
         y = ' '//to_text((j - 1)*map%step_y)//' '
         do i = 1, size(map%heights, 1)
            call add(map, bytes, used, error, trim(x(i)))
            call add(map, bytes, used, error, y)
            call add_height(map, bytes, used, error, map%heights(i, j))
            if (allocated(error)) return
            call add(map, bytes, used, error, line_end)
         end do
      end do
      call finish(map, bytes, used, error)
   end subroutine write_xyz

   subroutine write_csv(map, bytes, error)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      type(error_type), allocatable, intent(inout) :: error
      integer(int64) :: used
      integer :: i, j

      used = 0_int64
      call add(map, bytes, used, error, &
         '# Heights, a line for each y, the first at y = 0'//line_end// &
         '# step_x: '//to_text(map%step_x)//' mm'//line_end// &
         '# step_y: '//to_text(map%step_y)//' mm'//line_end// &
         '# height unit: mm'//line_end)
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (i > 1) call add(map, bytes, used, error, ',')
            call add_height(map, bytes, used, error, map%heights(i, j))
            if (allocated(error)) return
         end do
         call add(map, bytes, used, error, line_end)
      end do
      call finish(map, bytes, used, error)
   end subroutine write_csv

   !> Append a height with 17 figures.
   subroutine add_height(map, bytes, used, error, height)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      integer(int64), intent(inout) :: used
      type(error_type), allocatable, intent(inout) :: error
      real(wp), intent(in) :: height
      character(len=number_width) :: text

      if (height >= none) then
         call add(map, bytes, used, error, 'NaN')
      else
         write (text, '(es24.16e3)') height
         call add(map, bytes, used, error, trim(adjustl(text)))
      end if
   end subroutine add_height

   !> Append text, whose room doubles when it is used up.
   subroutine add(map, bytes, used, error, text)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      integer(int64), intent(inout) :: used
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: text

      if (used + len(text) > len(bytes, kind=int64)) &
         call resize(map, bytes, used, max(4096_int64, 2_int64*(used + len(text))), error)
      if (allocated(error)) return
      bytes(used + 1:used + len(text)) = text
      used = used + len(text)
   end subroutine add

   !> Give back the room that is not used.
   subroutine finish(map, bytes, used, error)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      integer(int64), intent(in) :: used
      type(error_type), allocatable, intent(inout) :: error

      if (.not. allocated(error)) call resize(map, bytes, used, used, error)
      ! for what is written beside it
      call check_room(map%source, 0_int64, error)
   end subroutine finish

   !> Move the used part to another room.
   subroutine resize(map, bytes, used, length, error)
      type(height_map), intent(in) :: map
      character(len=:), allocatable, intent(inout) :: bytes
      integer(int64), intent(in) :: used, length
      type(error_type), allocatable, intent(inout) :: error
      character(len=:), allocatable :: other
      integer :: status

      allocate (character(len=length) :: other, stat=status)
      if (status == 0) then
         other(:used) = bytes(:used)
         call move_alloc(other, bytes)
      else
         call check_memory(status, map%source, length, error)
      end if
   end subroutine resize

end module asperity_height_map_write
