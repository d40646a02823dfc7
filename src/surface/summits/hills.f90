!> Hills of a map, and their relief, by which Wolf pruning leaves them or not.
!>
!> Points are ordered by height, equal ones by place in storage; neighbours are the eight around,
!> missing points are none. A hill is what ascent leads to one top. Let the map sink into the sea
!> backwards, the water falling from above the highest point: tops become islands, and at a saddle
!> two islands become one. The lower top ends there; its relief is its height less the saddle's.
!> The highest top of a connected part of the map never ends. A hill stays when its relief is at
!> least the least one asked for.
!>
!> This is Wolf pruning, which takes the hill of the smallest difference between its top and its
!> highest saddle, joins it to the hill across that saddle, and repeats while that difference is
!> below the least. For let top p be the one of the smallest difference, s its highest saddle and q
!> a top across s. (1) p is the lower: were q lower, its highest saddle would be no lower than s,
!> so that its difference would be smaller than that of p. Down to s the island of p holds p alone,
!> as s is its first saddle; so p ends at s, and its relief is the difference. (2) Joining p to q
!> changes the relief of no other hill: below s the islands are the same, p was not the highest of
!> its island and no other ends at it. So hills leave in the order of their relief, until all left
!> have at least the least one. The order in which equal ones leave does not matter for the same
!> reason, nor does which higher neighbour an ascent takes: a path between two tops above a level
!> crosses hills by points above that level, and ascents only rise.
!>
!> A saddle is a point whose higher neighbours fall into several groups that do not touch one
!> another; elsewhere they are joined already when the water reaches the point.
module asperity_surface_summits_hills
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_memory, check_room
   use asperity_surface_summits_higher_neighbours, only: first_rows, group_table, higher_in_row, &
      new_group_table, next_rows, nothing, turn_x, turn_y
   use asperity_surface_summits_saddle_order, only: saddle_type, sort_saddles
   implicit none
   private
   public :: find_hills

contains

   !> Find all hills.
   pure subroutine find_hills(z, name, tops, relief, error)
      !> Heights, `none` where there is none
      real(wp), intent(in), contiguous :: z(:, :)
      !> Name of the map
      character(len=*), intent(in) :: name
      !> Places of their tops in storage from 1, in that order
      integer, allocatable, intent(out) :: tops(:)
      !> Relief of each, in the unit of the heights; `huge` of one that never ends
      real(wp), allocatable, intent(out) :: relief(:)
      !> Set when there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: hill(:, :)
      type(saddle_type), allocatable :: saddles(:)
      type(group_table) :: table
      integer :: n

      call new_group_table(table)
      call climb(z, name, table, hill, tops, saddles, error)
      if (allocated(error)) return
      call collect_saddles(z, table, hill, saddles, n)
      call sort_saddles(saddles(:n))
      ! heights, reliefs and numbers of hills besides
      call check_room(name, 24_int64*size(tops, kind=int64), error)
      if (allocated(error)) return
      call join_hills(z, table, hill, saddles(:n), tops, relief)
   end subroutine find_hills

   !> Give each point the number of its hill. Points first hold minus the place of a higher
   !> neighbour, tops their number.
   pure subroutine climb(z, name, table, hill, tops, saddles, error)
      real(wp), intent(in), contiguous :: z(:, :)
      character(len=*), intent(in) :: name
      type(group_table), intent(in) :: table
      integer, allocatable, intent(out) :: hill(:, :), tops(:)
      !> With room for all saddles
      type(saddle_type), allocatable, intent(out) :: saddles(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: rows(:, :)
      integer, allocatable :: higher(:)
      integer :: i, j, n_tops, n_saddles, status

      allocate (hill(size(z, 1), size(z, 2)), stat=status)
      call check_memory(status, name, 4_int64*size(z, kind=int64), error)
      call check_room(name, 0_int64, error)
      if (allocated(error)) return
      n_tops = 0
      n_saddles = 0
      allocate (rows(0:size(z, 1) + 1, 0:2), higher(size(z, 1)))
      call first_rows(z, rows)
      do j = 1, size(z, 2)
         call next_rows(z, j, rows)
         call higher_in_row(rows, higher)
         do i = 1, size(z, 1)
            hill(i, j) = 0
            if (rows(i, 1) <= nothing) cycle
            if (higher(i) == 0) then
               n_tops = n_tops + 1
               hill(i, j) = n_tops
            else
               associate (turn => table%one_of(1, higher(i)))
                  hill(i, j) = -(i + turn_x(turn) + (j + turn_y(turn) - 1)*size(z, 1))
               end associate
               if (table%groups(higher(i)) > 1) n_saddles = n_saddles + 1
            end if
         end do
      end do
      allocate (tops(n_tops), stat=status)
      if (status == 0) allocate (saddles(n_saddles), stat=status)
      call check_memory(status, name, &
         4_int64*n_tops + storage_size(saddles)/8_int64*n_saddles, error)
      if (.not. allocated(error)) call follow(hill, size(hill), tops)
   end subroutine climb

   !> Follow each ascent to its top, and mark all points on it with the number there.
   pure subroutine follow(hill, points, tops)
      integer, intent(in) :: points
      integer, intent(inout) :: hill(points)
      integer, intent(out) :: tops(:)
      integer :: n, place, number, next

      do n = 1, points
         if (hill(n) > 0) tops(hill(n)) = n
      end do
      do n = 1, points
         if (hill(n) >= 0) cycle
         place = n
         do while (hill(place) < 0)
            place = -hill(place)
         end do
         number = hill(place)
         place = n
         do while (hill(place) < 0)
            next = -hill(place)
            hill(place) = number
            place = next
         end do
      end do
   end subroutine follow

   !> Collect the saddles between different hills.
   pure subroutine collect_saddles(z, table, hill, saddles, n)
      real(wp), intent(in), contiguous :: z(:, :)
      type(group_table), intent(in) :: table
      integer, intent(in), contiguous :: hill(:, :)
      type(saddle_type), intent(inout) :: saddles(:)
      !> Their number
      integer, intent(out) :: n
      real(wp), allocatable :: rows(:, :)
      integer, allocatable :: higher(:)
      integer :: i, j, k, first

      n = 0
      allocate (rows(0:size(z, 1) + 1, 0:2), higher(size(z, 1)))
      call first_rows(z, rows)
      do j = 1, size(z, 2)
         call next_rows(z, j, rows)
         call higher_in_row(rows, higher)
         do i = 1, size(z, 1)
            if (rows(i, 1) <= nothing) cycle
            if (table%groups(higher(i)) < 2) cycle
            first = hill_beside(1)
            do k = 2, table%groups(higher(i))
               if (hill_beside(k) == first) cycle
               n = n + 1
               saddles(n) = saddle_type(z(i, j), i + (j - 1)*size(z, 1), higher(i))
               exit
            end do
         end do
      end do

   contains

      pure integer function hill_beside(group)
         integer, intent(in) :: group

         associate (turn => table%one_of(group, higher(i)))
            hill_beside = hill(i + turn_x(turn), j + turn_y(turn))
         end associate
      end function hill_beside

   end subroutine collect_saddles

   !> Join hills from the highest saddle down. A hill points to the one it was joined to, the
   !> highest of an island to itself.
   pure subroutine join_hills(z, table, hill, saddles, tops, relief)
      real(wp), intent(in), contiguous :: z(:, :)
      type(group_table), intent(in) :: table
      integer, intent(in), contiguous :: hill(:, :)
      type(saddle_type), intent(in) :: saddles(:)
      integer, intent(in) :: tops(:)
      real(wp), allocatable, intent(out) :: relief(:)
      real(wp), allocatable :: heights(:)
      integer, allocatable :: joined_to(:)
      integer :: n, k, i, j, a, b, lower

      allocate (relief(size(tops)), joined_to(size(tops)), heights(size(tops)))
      relief = huge(1.0_wp)
      do n = 1, size(tops)
         joined_to(n) = n
         heights(n) = z(column(tops(n)), row(tops(n)))
      end do
      do n = 1, size(saddles)
         do k = 1, table%groups(saddles(n)%higher)
            associate (turn => table%one_of(k, saddles(n)%higher))
               i = column(saddles(n)%place) + turn_x(turn)
               j = row(saddles(n)%place) + turn_y(turn)
            end associate
            call find_highest(joined_to, hill(i, j), b)
            if (k == 1) a = b
            if (a == b) cycle
            lower = b
            if (heights(a) < heights(b) .or. (.not. heights(a) > heights(b) .and. a < b)) lower = a
            a = a + b - lower
            joined_to(lower) = a
            relief(lower) = heights(lower) - saddles(n)%height
         end do
      end do

   contains

      pure integer function column(place)
         integer, intent(in) :: place

         column = modulo(place - 1, size(z, 1)) + 1
      end function column

      pure integer function row(place)
         integer, intent(in) :: place

         row = (place - 1)/size(z, 1) + 1
      end function row

   end subroutine join_hills

   !> The highest hill of an island, halving the way there for the next time.
   pure subroutine find_highest(joined_to, start, highest)
      integer, intent(inout) :: joined_to(:)
      integer, intent(in) :: start
      integer, intent(out) :: highest

      highest = start
      do while (joined_to(highest) /= highest)
         joined_to(highest) = joined_to(joined_to(highest))
         highest = joined_to(highest)
      end do
   end subroutine find_highest

end module asperity_surface_summits_hills
