!> A height map: heights of one face on a regular grid, some of which may be missing. One line is a
!> profile.
module asperity_height_map_type
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory, check_room
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: add_note, allocate_heights, check_height_map, check_heights, height_map, &
      missing_points, thinned

   !> Fewest points along either side of a map, and along a profile
   integer, parameter, public :: fewest_points = 5

   !> Points of a map from which there may be too little memory for what is small beside it
   integer(int64), parameter :: worth_a_look = 2_int64**17

   !> End of a note
   character(len=1), parameter, public :: note_end = achar(10)

   !> Heights of one face, in mm throughout.
   type :: height_map
      !> Heights, mm, positive out of the material; (i, j) is at x = (i-1) step_x, y = (j-1) step_y.
      !> `none` where it was not measured
      real(wp), allocatable :: heights(:, :)
      !> Distance of neighbours, mm
      real(wp) :: step_x = 0.0_wp, step_y = 0.0_wp
      !> Where it comes from, for messages, such as the path of a file
      character(len=:), allocatable :: source
      !> Format of that file, for reports; empty for none
      character(len=:), allocatable :: format
      !> What its reader settled or left out, sentences that end with `note_end`; may be unallocated
      character(len=:), allocatable :: notes
   end type height_map

contains

   !> Allocate the heights of a map of nx x ny points, or of a profile of nx x 1, whose product is a
   !> default integer.
   pure subroutine allocate_heights(name, nx, ny, map, error)
      !> Name of the file
      character(len=*), intent(in) :: name
      !> Points along x and y
      integer(int64), intent(in) :: nx, ny
      !> The map
      type(height_map), intent(inout) :: map
      !> Set when its lines are too short, or there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      integer :: status

      if (nx < fewest_points) then
         call refuse_size(name, nx, ny, error)
         return
      end if
      allocate (map%heights(nx, ny), stat=status)
      call check_memory(status, name, 8_int64*nx*ny, error)
      ! a line of bytes is read at a time; small maps are not worth the look
      if (nx*ny > worth_a_look) call check_room(name, 8_int64*nx, error)
   end subroutine allocate_heights

   !> Add a note on where the heights come from.
   pure subroutine add_note(map, text)
      !> The map
      type(height_map), intent(inout) :: map
      !> A sentence; the name of the source is put before it
      character(len=*), intent(in) :: text

      if (.not. allocated(map%notes)) map%notes = ''
      map%notes = map%notes//map%source//': '//text//note_end
   end subroutine add_note

   !> Set `error` unless a map can be analysed as one: sound heights, and lines enough.
   pure subroutine check_height_map(map, error)
      !> The map
      type(height_map), intent(in) :: map
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error

      call check_heights(map, error)
      if (allocated(error) .or. size(map%heights, 2) >= fewest_points) return
      call refuse_size(map%source, size(map%heights, 1, int64), size(map%heights, 2, int64), error)
   end subroutine check_height_map

   !> Set `error` unless heights are sound, of a map or of profiles: points enough along a line,
   !> positive steps, finite heights, one that was measured.
   pure subroutine check_heights(map, error)
      !> The map
      type(height_map), intent(in) :: map
      !> Set otherwise
      type(error_type), allocatable, intent(out) :: error
      integer :: i, j

      if (size(map%heights, 1) < fewest_points .or. size(map%heights, 2) < 1) then
         call refuse_size(map%source, size(map%heights, 1, int64), size(map%heights, 2, int64), &
            error)
         return
      end if
      call check_step(map, 'x', map%step_x, error)
      if (.not. allocated(error)) call check_step(map, 'y', map%step_y, error)
      if (allocated(error)) return
      do j = 1, size(map%heights, 2)
         do i = 1, size(map%heights, 1)
            if (is_finite(map%heights(i, j))) cycle
            call fatal_error(error, map%source//': the height of point '//to_text(i)//', '// &
               to_text(j)//' is not a finite number')
            return
         end do
      end do
      if (missing_points(map) == size(map%heights)) call fatal_error(error, map%source// &
         ': every point is missing')
   end subroutine check_heights

   !> Say that there are too few points along a side.
   pure subroutine refuse_size(name, nx, ny, error)
      character(len=*), intent(in) :: name
      integer(int64), intent(in) :: nx, ny
      type(error_type), allocatable, intent(out) :: error

      if (ny == 1_int64 .and. nx >= fewest_points) then
         call fatal_error(error, name//': is a profile of '//to_text(nx)//' points, and no map')
      else if (ny == 1_int64) then
         call fatal_error(error, name//': '//to_text(nx)//' points in a line are no profile: '// &
            'at least '//to_text(fewest_points)//' are needed')
      else
         call fatal_error(error, name//': '//to_text(nx)//' x '//to_text(ny)//' points are no '// &
            'map: at least '//to_text(fewest_points)//' are needed either way')
      end if
   end subroutine refuse_size

   !> Set `error` unless a step is positive and finite.
   pure subroutine check_step(map, axis, step, error)
      type(height_map), intent(in) :: map
      character(len=*), intent(in) :: axis
      real(wp), intent(in) :: step
      type(error_type), allocatable, intent(out) :: error
      logical :: is_allowed

      is_allowed = is_finite(step)
      if (is_allowed) is_allowed = step > 0.0_wp
      if (.not. is_allowed) call fatal_error(error, map%source//': step '//to_text(step)// &
         ' mm in '//axis//' is not allowed: it must be above 0 and finite')
   end subroutine check_step

   !> Number of points without a height.
   pure integer function missing_points(map)
      !> The map
      type(height_map), intent(in) :: map

      missing_points = count(map%heights >= none)
   end function missing_points

   !> Every so-manieth point of a map either way, from its first on; nothing is averaged, as a
   !> coarser measurement would not.
   pure subroutine thinned(map, every, thin)
      !> The map
      type(height_map), intent(in) :: map
      !> Take each of these: 2 for every second; at least 1
      integer, intent(in) :: every
      !> The thinned map
      type(height_map), intent(out) :: thin
      integer :: i, j, stride

      stride = max(every, 1)
      allocate (thin%heights((size(map%heights, 1) - 1)/stride + 1, &
         (size(map%heights, 2) - 1)/stride + 1))
      do j = 1, size(thin%heights, 2)
         do i = 1, size(thin%heights, 1)
            thin%heights(i, j) = map%heights((i - 1)*stride + 1, (j - 1)*stride + 1)
         end do
      end do
      thin%step_x = stride*map%step_x
      thin%step_y = stride*map%step_y
      if (allocated(map%source)) thin%source = map%source
      if (allocated(map%format)) thin%format = map%format
   end subroutine thinned

end module asperity_height_map_type
