!> Tells whether the first line and the first column of a matrix are heights, or the numbers or the
!> axes of its columns and rows, as pandas, R and spreadsheets write them.
!>
!> An axis goes in equal steps, other than 0, where its neighbour, heights, does not: on a plane
!> both do. With an empty corner, or a word in it, that is enough of both together. With a number or
!> NaN in the corner they must stand off the heights behind them as well, as heights do not; and one
!> of them alone must count from 0 or 1. What looks like an axis and is not taken for one is in
!> doubt.
module asperity_height_map_text_frame
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory
   use asperity_base_no_value, only: none
   use asperity_height_map_bytes_byte_source, only: byte_source
   use asperity_height_map_type, only: fewest_points
   implicit none
   private
   public :: border_type, find_frame, frame_type

   !> Deviation from equal steps, in steps: of axes with rounded figures, and of exact ones
   real(wp), parameter :: rounded = 0.05_wp, exact = 1.0e-6_wp
   !> Mean distance to the next line over that of the two behind, from which a line stands off
   real(wp), parameter :: off = 3.0_wp

   !> The first three lines and columns of a matrix, in its own numbers.
   type :: border_type
      !> (place, number of the line or of the column), `none` without a number
      real(wp), allocatable :: x(:, :), y(:, :)
   contains
      !> Keep a number
      procedure :: keep
   end type border_type

   !> What was found.
   type :: frame_type
      !> Whether the first line holds x, the first column y
      logical :: is_axis(2) = .false.
      !> Whether they count from 0 or 1
      logical :: counts(2) = .false.
      !> Whether one of them looks like an axis, and was left
      logical :: is_doubtful = .false.
      !> First number and step of each
      real(wp) :: first(2) = 0.0_wp, step(2) = 0.0_wp
   end type frame_type

   !> What a line is like that may be an axis.
   type :: look_type
      !> Whether it goes in equal steps, exactly or with rounded figures, and its neighbour does
      logical :: is_exact = .false., is_even = .false., heights_are_even = .false.
      !> Whether it counts from 0 or 1, and stands off its neighbours
      logical :: counts = .false., stands_off = .false.
      real(wp) :: first = 0.0_wp, step = 0.0_wp
   end type look_type

contains

   !> Keep a number of the first three lines or columns.
   subroutine keep(self, source, column, row, columns, value, error)
      !> The border
      class(border_type), intent(inout) :: self
      !> The file
      type(byte_source), intent(in) :: source
      !> Place of the number, and how many there are in a line
      integer(int64), intent(in) :: column, row, columns
      !> The number as it stands in the file
      real(wp), intent(in) :: value
      !> Set when there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: longer(:, :)
      integer :: status

      status = 0
      if (.not. allocated(self%x)) then
         allocate (self%x(columns, 3), stat=status)
         if (status == 0) allocate (self%y(64, 3), stat=status)
      end if
      if (status == 0 .and. row > size(self%y, 1)) then
         allocate (longer(2*size(self%y, 1), 3), stat=status)
         if (status == 0) then
            longer(:size(self%y, 1), :) = self%y
            call move_alloc(longer, self%y)
         end if
      end if
      call check_memory(status, source%name, 8_int64*3_int64*(columns + row), error)
      if (allocated(error)) return
      if (row <= 3_int64 .and. column <= columns) self%x(column, row) = value
      if (column <= 3_int64) self%y(row, column) = value
   end subroutine keep

   !> Find out.
   pure subroutine find_frame(border, columns, rows, is_open, is_named, frame)
      !> The first lines and columns
      type(border_type), intent(in) :: border
      !> Numbers in a line, and lines
      integer, intent(in) :: columns, rows
      !> Whether the corner is empty or a word, which no height is
      logical, intent(in) :: is_open
      !> Whether a line of names says that the first column has none
      logical, intent(in) :: is_named
      !> What was found
      type(frame_type), intent(out) :: frame
      type(look_type) :: looks(2)
      integer :: i

      if (min(columns, rows) <= 3) return
      looks = [look_at(border%x(2:columns, :)), look_at(border%y(2:rows, :))]
      frame%is_doubtful = any(looks%is_exact .and. .not. looks%heights_are_even)
      if (is_open) then
         frame%is_axis = all(looks%is_even) .and. .not. all(looks%heights_are_even)
      else
         frame%is_axis = all(looks%is_exact .and. looks%stands_off .and. &
            .not. looks%heights_are_even)
      end if
      if (.not. any(frame%is_axis)) then
         ! alone, an axis has a number in the corner as everywhere
         looks = [look_at(border%x(:columns, :)), look_at(border%y(:rows, :))]
         do i = 1, 2
            frame%is_axis(i) = looks(i)%is_exact .and. looks(i)%counts .and. &
               .not. looks(i)%heights_are_even .and. (looks(i)%stands_off .or. &
               (is_named .and. i == 2))
         end do
         frame%is_doubtful = frame%is_doubtful .or. &
            any(looks%is_exact .and. .not. looks%heights_are_even)
      end if
      if (any(frame%is_axis)) frame%is_doubtful = .false.
      frame%counts = looks%counts
      frame%first = looks%first
      frame%step = looks%step
   end subroutine find_frame

   !> What the first of three lines is like beside the other two.
   pure type(look_type) function look_at(lines)
      real(wp), intent(in) :: lines(:, :)
      real(wp) :: behind, first, near, step
      integer :: i, known

      call equal_steps(lines(:, 2), rounded, first, step, look_at%heights_are_even)
      call equal_steps(lines(:, 1), exact, first, step, look_at%is_exact)
      call equal_steps(lines(:, 1), rounded, look_at%first, look_at%step, look_at%is_even)
      look_at%counts = abs(step - 1.0_wp) <= exact .and. &
         (abs(first) <= exact .or. abs(first - 1.0_wp) <= exact)
      known = 0
      near = 0.0_wp
      behind = 0.0_wp
      do i = 1, size(lines, 1)
         if (maxval(lines(i, :)) >= none) cycle
         known = known + 1
         near = near + abs(lines(i, 2) - lines(i, 1))
         behind = behind + abs(lines(i, 3) - lines(i, 2))
      end do
      look_at%stands_off = known >= fewest_points - 1 .and. near > off*behind
   end function look_at

   !> Whether numbers go in equal steps other than 0.
   pure subroutine equal_steps(values, tolerance, first, step, are_equal)
      !> The numbers
      real(wp), intent(in) :: values(:)
      !> Deviation allowed, in steps
      real(wp), intent(in) :: tolerance
      real(wp), intent(out) :: first, step
      logical, intent(out) :: are_equal
      integer :: i, n

      n = size(values)
      first = values(1)
      step = 0.0_wp
      are_equal = n >= fewest_points - 1 .and. all(values < none)
      if (.not. are_equal) return
      step = (values(n) - first)/real(n - 1, wp)
      are_equal = abs(step) > 0.0_wp
      do i = 2, n
         are_equal = are_equal .and. abs(values(i) - first - (i - 1)*step) <= tolerance*abs(step)
      end do
   end subroutine equal_steps

end module asperity_height_map_text_frame
