!> Height maps by formula, and files of them, for the tests of the readers.
module map_file_cases
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_height_map_read, only: map_hints, read_height_map_bytes
   use asperity_height_map_type, only: height_map
   use funit, only: assertEqual, assertTrue
   implicit none
   private
   public :: assert_map, assert_same, formula_map, has_text, read_text, refused

   !> End of a line
   character(len=1), parameter, public :: nl = achar(10)
   !> What says the units of a text that does not
   type(map_hints), parameter, public :: in_mm = map_hints(lateral_unit='mm', height_unit='mm')
   !> No hints, and all that a matrix of numbers needs, with steps of 0.5 and 0.25 mm
   type(map_hints), parameter, public :: no_hints = map_hints(), &
      with_steps = map_hints('', 'mm', 0.5_wp, 0.25_wp)
   !> Heights of 5 lines of 6 points that go in no equal steps, mm
   character(len=*), parameter, public :: small_rows(5) = [character(len=23) :: &
      '3.1,4.7,2.2,8.9,5.3,4.4', '2.7,3.6,4.1,7.7,6.2,5.1', '3.3,2.9,5.6,6.1,7.4,4.8', &
      '4.2,3.8,4.9,6.6,6.9,5.7', '3.9,4.5,5.2,5.8,7.1,6.3']
   real(wp), parameter, public :: small_heights(30) = [ &
      3.1_wp, 4.7_wp, 2.2_wp, 8.9_wp, 5.3_wp, 4.4_wp, &
      2.7_wp, 3.6_wp, 4.1_wp, 7.7_wp, 6.2_wp, 5.1_wp, &
      3.3_wp, 2.9_wp, 5.6_wp, 6.1_wp, 7.4_wp, 4.8_wp, &
      4.2_wp, 3.8_wp, 4.9_wp, 6.6_wp, 6.9_wp, 5.7_wp, &
      3.9_wp, 4.5_wp, 5.2_wp, 5.8_wp, 7.1_wp, 6.3_wp]

contains

   !> A map of irregular numbers of all sizes, some missing.
   subroutine formula_map(map, nx, ny)
      !> The map
      type(height_map), intent(out) :: map
      !> Its points
      integer, intent(in) :: nx, ny
      integer :: i, j

      allocate (map%heights(nx, ny))
      map%step_x = 0.0013_wp
      map%step_y = 0.001_wp/3.0_wp
      map%source = 'formula'
      do j = 1, ny
         do i = 1, nx
            map%heights(i, j) = sin(1.7_wp*i + 0.3_wp*j*j)*10.0_wp**(mod(i + 2*j, 7) - 5)
            if (mod(3*i + j, 11) == 0) map%heights(i, j) = none
         end do
      end do
   end subroutine formula_map

   !> Read a text as if it were a file.
   subroutine read_text(text, hints, map, block_length)
      !> The file
      character(len=*), intent(in) :: text
      !> What the user says
      type(map_hints), intent(in) :: hints
      !> Its map; 0 x 0 points after an error, which fails the test
      type(height_map), intent(out) :: map
      !> Bytes handled at once
      integer, intent(in), optional :: block_length
      type(error_type), allocatable :: error

      call read_height_map_bytes('file', text, hints, map, error, block_length)
      if (allocated(error)) then
         call assertEqual('', error%message)
         allocate (map%heights(0, 0))
      end if
   end subroutine read_text

   !> Assert that a map has these heights, given by rows of x; a 9 is missing.
   subroutine assert_map(map, nx, heights, tolerance)
      !> The map
      type(height_map), intent(in) :: map
      !> Points along x
      integer, intent(in) :: nx
      !> Heights, mm
      real(wp), intent(in) :: heights(:)
      !> Largest difference, mm
      real(wp), intent(in) :: tolerance
      real(wp) :: found(size(heights))

      call assertEqual([nx, size(heights)/nx], shape(map%heights))
      if (size(map%heights) /= size(heights)) return
      found = reshape(map%heights, [size(heights)])
      where (found >= none) found = 9.0_wp
      call assertEqual(heights, found, tolerance)
   end subroutine assert_map

   !> Assert that two maps have the same heights, bit by bit.
   subroutine assert_same(expected, found, message)
      !> The maps
      type(height_map), intent(in) :: expected, found
      !> For a failure
      character(len=*), intent(in) :: message

      call assertEqual(shape(expected%heights), shape(found%heights), message)
      if (any(shape(expected%heights) /= shape(found%heights))) return
      call assertTrue(all(transfer(expected%heights, [0_int64]) == &
         transfer(found%heights, [0_int64])), message)
   end subroutine assert_same

   pure logical function has_text(text, part)
      character(len=*), intent(in) :: text, part

      has_text = index(text, part) > 0
   end function has_text

   !> Assert that a file is refused with a message that begins and goes on like this.
   subroutine refused(text, start, part, hints)
      !> The file
      character(len=*), intent(in) :: text
      !> Begin of the message, file and place
      character(len=*), intent(in) :: start
      !> Something in it
      character(len=*), intent(in) :: part
      !> What the user says; millimetres when absent
      type(map_hints), intent(in), optional :: hints
      type(height_map) :: map
      type(error_type), allocatable :: error
      type(map_hints) :: used
      integer :: block_length, k

      used = in_mm
      if (present(hints)) used = hints
      ! the same in small blocks
      do k = 1, 3
         block_length = 10**(2*k)
         call read_height_map_bytes('file', text, used, map, error, block_length)
         call assertTrue(allocated(error), start//': must be refused, '//part)
         if (.not. allocated(error)) return
         call assertTrue(index(error%message, start) == 1 .and. has_text(error%message, part), &
            '"'//start//'" and "'//part//'" are not in: '//error%message)
         call assertTrue(.not. allocated(map%heights), 'no map')
      end do
   end subroutine refused

end module map_file_cases
