!> Which neighbours of a point are higher, and which of those touch one another.
module asperity_surface_summits_higher_neighbours
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   implicit none
   private
   public :: first_rows, group_table, higher_in_row, new_group_table, next_rows

   !> Neighbours in turn from that along x: steps along x and y. The first four come later in
   !> storage, so that they are higher at equal height
   integer, parameter, public :: turn_x(0:7) = [1, 1, 0, -1, -1, -1, 0, 1]
   integer, parameter, public :: turn_y(0:7) = [0, 1, 1, 1, 0, -1, -1, -1]
   !> Below every height
   real(wp), parameter, public :: nothing = -huge(1.0_wp)

   !> Of each set of higher neighbours, a bit each, one of every group that touch one another.
   type :: group_table
      !> Number of groups
      integer :: groups(0:255) = 0
      !> The turn of one neighbour of each
      integer :: one_of(4, 0:255) = 0
   end type group_table

contains

   !> Before the first row: `nothing`, and the first row as the next.
   pure subroutine first_rows(z, rows)
      !> The map
      real(wp), intent(in), contiguous :: z(:, :)
      !> Three rows, a point longer either side
      real(wp), intent(inout) :: rows(0:, 0:)

      rows = nothing
      call read_row(z, 1, rows(:, 2))
   end subroutine first_rows

   !> Move on to a row: the one before it, itself and the one after, with `nothing` around the map
   !> and where points are missing.
   pure subroutine next_rows(z, j, rows)
      !> The map
      real(wp), intent(in), contiguous :: z(:, :)
      !> The row
      integer, intent(in) :: j
      !> Those of the row before
      real(wp), intent(inout) :: rows(0:, 0:)
      integer :: i

      do i = 0, size(z, 1) + 1
         rows(i, 0) = rows(i, 1)
         rows(i, 1) = rows(i, 2)
         rows(i, 2) = nothing
      end do
      if (j < size(z, 2)) call read_row(z, j + 1, rows(:, 2))
   end subroutine next_rows

   !> The measured heights of a row.
   pure subroutine read_row(z, j, row)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: j
      real(wp), intent(inout) :: row(0:)
      integer :: i

      do i = 1, size(z, 1)
         if (z(i, j) < none) row(i) = z(i, j)
      end do
   end subroutine read_row

   !> Of each point of the middle row, which neighbours are higher, a bit each in turn.
   pure subroutine higher_in_row(rows, higher)
      !> Rows as `next_rows` leaves them
      real(wp), intent(in), contiguous :: rows(0:, 0:)
      !> By point
      integer, intent(out), contiguous :: higher(:)
      integer :: i

      do i = 1, size(higher)
         associate (z => rows(i, 1))
            higher(i) = merge(1, 0, rows(i + 1, 1) >= z) + merge(2, 0, rows(i + 1, 2) >= z) &
               + merge(4, 0, rows(i, 2) >= z) + merge(8, 0, rows(i - 1, 2) >= z) &
               + merge(16, 0, rows(i - 1, 1) > z) + merge(32, 0, rows(i - 1, 0) > z) &
               + merge(64, 0, rows(i, 0) > z) + merge(128, 0, rows(i + 1, 0) > z)
         end associate
      end do
   end subroutine higher_in_row

   !> Groups of each set of higher neighbours. Those next in turn touch, and so do two beside the
   !> point with a corner between them, whether that is higher or not.
   pure subroutine new_group_table(table)
      !> The table
      type(group_table), intent(out) :: table
      integer :: set, turn, group(0:7), step, pass

      do set = 0, 255
         group = [(merge(turn, -1, btest(set, turn)), turn=0, 7)]
         ! Each takes the smallest number of those it touches, until none changes
         do pass = 1, 8
            do turn = 0, 7
               do step = 1, merge(2, 1, modulo(turn, 2) == 0)
                  associate (a => group(turn), b => group(modulo(turn + step, 8)))
                     if (a < 0 .or. b < 0) cycle
                     a = min(a, b)
                     b = a
                  end associate
               end do
            end do
         end do
         do turn = 0, 7
            if (group(turn) /= turn) cycle
            table%groups(set) = table%groups(set) + 1
            table%one_of(table%groups(set), set) = turn
         end do
      end do
   end subroutine new_group_table

end module asperity_surface_summits_higher_neighbours
