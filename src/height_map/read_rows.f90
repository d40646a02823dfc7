!> Reads the lines of a map that stand one after the other in a file, or in a member of an archive,
!> as numbers with their little end first, x fastest.
module asperity_height_map_read_rows
   use, intrinsic :: iso_c_binding, only: c_loc
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source, read_at
   use asperity_height_map_decode_heights, only: byte_buffer, bytes_of, decode, height_message, &
      scale_heights
   use asperity_height_map_file_errors, only: byte_error
   use asperity_height_map_type, only: height_map
   implicit none
   private
   public :: mask_rows, read_rows

contains

   !> Read heights.
   subroutine read_rows(source, offset, kind, factor, marker, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Bytes before them; all of them are in the file
      integer(int64), intent(in) :: offset
      !> Kind of the numbers
      integer, intent(in) :: kind
      !> mm of one, and the number of a point that is missing, `none` where NaN alone is
      real(wp), intent(in) :: factor, marker
      !> The map, whose heights have their size
      type(height_map), intent(inout) :: map
      !> Set when a height is not allowed
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      character(len=:), allocatable :: message
      integer(int64) :: at, length
      integer :: bad, j

      length = size(map%heights, 1, int64)*bytes_of(kind)
      allocate (buffer%bytes(length))
      at = offset
      do j = 1, size(map%heights, 2)
         call read_at(source, at, c_loc(buffer%bytes), length, error)
         if (allocated(error)) return
         associate (row => map%heights(:, j))
            call decode(buffer, kind, row)
            if (marker < none) then
               where (abs(row - marker) < 0.5_wp) row = none
            end if
            call scale_heights(row, factor, 0.0_wp, bad)
            if (bad > 0) then
               call height_message(row(bad), factor, message)
               call byte_error(error, source, at + (bad - 1)*bytes_of(kind), 'point '// &
                  to_text(bad)//' of line '//to_text(j)//': '//message)
               return
            end if
         end associate
         at = at + length
      end do
   end subroutine read_rows

   !> Take away the heights where numbers of the same layout are above a half.
   subroutine mask_rows(source, offset, kind, map, error)
      !> The file
      type(byte_source), intent(inout) :: source
      !> Bytes before the numbers; all of them are in the file
      integer(int64), intent(in) :: offset
      !> Their kind
      integer, intent(in) :: kind
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when the file cannot be read
      type(error_type), allocatable, intent(out) :: error
      type(byte_buffer), target :: buffer
      real(wp), allocatable :: row(:)
      integer(int64) :: at, length
      integer :: j

      length = size(map%heights, 1, int64)*bytes_of(kind)
      allocate (buffer%bytes(length), row(size(map%heights, 1)))
      at = offset
      do j = 1, size(map%heights, 2)
         call read_at(source, at, c_loc(buffer%bytes), length, error)
         if (allocated(error)) return
         call decode(buffer, kind, row)
         where (row > 0.5_wp) map%heights(:, j) = none
         at = at + length
      end do
   end subroutine mask_rows

end module asperity_height_map_read_rows
