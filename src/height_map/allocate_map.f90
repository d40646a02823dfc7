!> Memory for a map.
module asperity_height_map_allocate_map
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_memory, only: check_memory, check_room
   use asperity_base_number_text, only: to_text
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_file_errors, only: count_text
   use asperity_height_map_type, only: fewest_points, height_map
   implicit none
   private
   public :: allocate_heights

   !> Points of a map from which there may be too little memory for what is small beside it
   integer(int64), parameter :: worth_a_look = 2_int64**17

contains

   !> Allocate the heights of a map of nx x ny points, whose product is a default integer.
   pure subroutine allocate_heights(source, nx, ny, map, error)
      !> The file
      type(byte_source), intent(in) :: source
      !> Points along x and y
      integer(int64), intent(in) :: nx, ny
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when it is too narrow, or there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      integer :: status

      if (min(nx, ny) < fewest_points) then
         call fatal_error(error, source%name//': '//count_text(nx)//' x '//count_text(ny)// &
            ' points are no map: at least '//to_text(fewest_points)//' are needed either way')
         return
      end if
      allocate (map%heights(nx, ny), stat=status)
      call check_memory(status, source%name, 8_int64*nx*ny, error)
      ! a line of bytes is read at a time; small maps are not worth the look
      if (nx*ny > worth_a_look) call check_room(source%name, 8_int64*nx, error)
   end subroutine allocate_heights

end module asperity_height_map_allocate_map
