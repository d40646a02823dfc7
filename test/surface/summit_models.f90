!> Hills of small maps by the words of their definitions: slow, and nothing shared with the library.
module summit_models
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   implicit none
   private
   public :: reliefs_by_flooding, wolf_pruned

contains

   !> Relief of each top: its height less that of the highest sea from which an island holds it and
   !> a higher point; huge when there is none. -1 for points that are no tops.
   subroutine reliefs_by_flooding(z, relief)
      real(wp), intent(in) :: z(:, :)
      real(wp), allocatable, intent(out) :: relief(:, :)
      logical :: island(size(z, 1), size(z, 2))
      real(wp) :: sea
      integer :: i, j

      allocate (relief(size(z, 1), size(z, 2)))
      relief = -1.0_wp
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (.not. is_top(z, i, j)) cycle
            relief(i, j) = huge(1.0_wp)
            sea = z(i, j)
            do
               call flood(z, i, j, sea, island)
               if (any_higher(z, i, j, island)) then
                  relief(i, j) = z(i, j) - sea
                  exit
               end if
               if (.not. any(z < sea)) exit
               sea = maxval(z, z < sea)
            end do
         end do
      end do
   end subroutine reliefs_by_flooding

   !> Whether (k, l) is higher than (i, j): of equal heights, the later in storage.
   pure logical function is_higher(z, k, l, i, j)
      real(wp), intent(in) :: z(:, :)
      integer, intent(in) :: k, l, i, j

      is_higher = z(k, l) > z(i, j)
      if (z(k, l) < z(i, j) .or. is_higher) return
      is_higher = l > j .or. (l == j .and. k > i)
   end function is_higher

   pure logical function is_top(z, i, j)
      real(wp), intent(in) :: z(:, :)
      integer, intent(in) :: i, j
      integer :: k, l

      is_top = z(i, j) < none
      do l = max(j - 1, 1), min(j + 1, size(z, 2))
         do k = max(i - 1, 1), min(i + 1, size(z, 1))
            if (z(k, l) >= none) cycle
            if (is_higher(z, k, l, i, j)) is_top = .false.
         end do
      end do
   end function is_top

   !> Measured points not below the sea that are joined to (i, j): grow until nothing changes.
   pure subroutine flood(z, i, j, sea, island)
      real(wp), intent(in) :: z(:, :), sea
      integer, intent(in) :: i, j
      logical, intent(out) :: island(:, :)
      integer :: k, l, before

      island = .false.
      island(i, j) = .true.
      do
         before = count(island)
         do l = 1, size(z, 2)
            do k = 1, size(z, 1)
               if (z(k, l) < sea .or. z(k, l) >= none) cycle
               island(k, l) = any(island(max(k - 1, 1):min(k + 1, size(z, 1)), &
                  max(l - 1, 1):min(l + 1, size(z, 2))))
            end do
         end do
         if (count(island) == before) return
      end do
   end subroutine flood

   pure logical function any_higher(z, i, j, island)
      real(wp), intent(in) :: z(:, :)
      integer, intent(in) :: i, j
      logical, intent(in) :: island(:, :)
      integer :: k, l

      any_higher = .false.
      do l = 1, size(z, 2)
         do k = 1, size(z, 1)
            if (island(k, l)) any_higher = any_higher .or. is_higher(z, k, l, i, j)
         end do
      end do
   end function any_higher

   !> Wolf's pruning: hills by steepest ascent, the highest saddle of each pair; the hill whose top
   !> is least above its highest saddle joins the hill across, while that is below `least`. `stays`
   !> is set at the tops left.
   subroutine wolf_pruned(z, least, stays)
      real(wp), intent(in) :: z(:, :), least
      logical, allocatable, intent(out) :: stays(:, :)
      real(wp), allocatable :: saddle(:, :)
      integer, allocatable :: hill(:, :), top_i(:), top_j(:)
      logical, allocatable :: is_left(:)
      real(wp) :: difference, smallest
      integer :: i, j, k, l, a, b, lowest, across

      call assign_hills(z, hill, top_i, top_j)
      associate (n => size(top_i))
         allocate (saddle(n, n), is_left(n), stays(size(z, 1), size(z, 2)))
         saddle = -huge(1.0_wp)
         do j = 1, size(z, 2)
            do i = 1, size(z, 1)
               do l = max(j - 1, 1), min(j + 1, size(z, 2))
                  do k = max(i - 1, 1), min(i + 1, size(z, 1))
                     a = hill(i, j)
                     b = hill(k, l)
                     if (a == b .or. min(a, b) == 0) cycle
                     saddle(a, b) = max(saddle(a, b), min(z(i, j), z(k, l)))
                     saddle(b, a) = saddle(a, b)
                  end do
               end do
            end do
         end do
         is_left = .true.
         do
            smallest = huge(1.0_wp)
            lowest = 0
            do a = 1, n
               if (.not. is_left(a) .or. all(saddle(:, a) <= -huge(1.0_wp))) cycle
               difference = z(top_i(a), top_j(a)) - maxval(saddle(:, a))
               if (lowest > 0) then
                  if (difference > smallest) cycle
                  ! of equal differences the lowest top first
                  if (.not. difference < smallest) then
                     if (is_higher(z, top_i(a), top_j(a), top_i(lowest), top_j(lowest))) cycle
                  end if
               end if
               smallest = difference
               lowest = a
            end do
            if (lowest == 0 .or. smallest >= least) exit
            across = highest_across(saddle(:, lowest))
            is_left(lowest) = .false.
            do b = 1, n
               if (b == across) cycle
               saddle(b, across) = max(saddle(b, across), saddle(b, lowest))
               saddle(across, b) = saddle(b, across)
            end do
            saddle(lowest, :) = -huge(1.0_wp)
            saddle(:, lowest) = -huge(1.0_wp)
         end do
         stays = .false.
         do a = 1, n
            stays(top_i(a), top_j(a)) = is_left(a)
         end do
      end associate

   contains

      !> Of the hills across the highest saddle, the one of the highest top.
      integer function highest_across(saddles)
         real(wp), intent(in) :: saddles(:)
         integer :: c

         highest_across = maxloc(saddles, 1)
         do c = 1, size(saddles)
            if (saddles(c) < maxval(saddles)) cycle
            if (is_higher(z, top_i(c), top_j(c), top_i(highest_across), top_j(highest_across))) &
               highest_across = c
         end do
      end function highest_across

   end subroutine wolf_pruned

   !> Number of the hill of each point, 0 where missing, by climbing to the highest neighbour.
   subroutine assign_hills(z, hill, top_i, top_j)
      real(wp), intent(in) :: z(:, :)
      integer, allocatable, intent(out) :: hill(:, :), top_i(:), top_j(:)
      integer :: i, j, k, l, at_i, at_j, best_i, best_j, n, c

      allocate (hill(size(z, 1), size(z, 2)))
      hill = 0
      n = 0
      allocate (top_i(size(z)), top_j(size(z)))
      do j = 1, size(z, 2)
         do i = 1, size(z, 1)
            if (z(i, j) >= none) cycle
            at_i = i
            at_j = j
            do
               best_i = at_i
               best_j = at_j
               do l = max(at_j - 1, 1), min(at_j + 1, size(z, 2))
                  do k = max(at_i - 1, 1), min(at_i + 1, size(z, 1))
                     if (z(k, l) >= none) cycle
                     if (.not. is_higher(z, k, l, best_i, best_j)) cycle
                     best_i = k
                     best_j = l
                  end do
               end do
               if (best_i == at_i .and. best_j == at_j) exit
               at_i = best_i
               at_j = best_j
            end do
            do c = 1, n
               if (top_i(c) == at_i .and. top_j(c) == at_j) exit
            end do
            if (c > n) then
               n = c
               top_i(n) = at_i
               top_j(n) = at_j
            end if
            hill(i, j) = c
         end do
      end do
      top_i = top_i(:n)
      top_j = top_j(:n)
   end subroutine assign_hills

end module summit_models
