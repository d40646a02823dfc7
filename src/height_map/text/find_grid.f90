!> Finds the regular grid that coordinates are on, in any order and with rounded figures.
module asperity_height_map_text_find_grid
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: find_grid

   !> Coordinates closer than this share of the largest gap are one, as rounding leaves them
   real(wp), parameter :: same = 1.0e-4_wp
   !> Largest distance from a grid line, in steps, and rounding that may add to it
   real(wp), parameter :: tolerance = 0.05_wp, coarsest = 0.12_wp
   !> Grid lines in all, for one that has points
   integer, parameter :: most_lines = 2

contains

   !> Find the grid. `reason` is set when there is none.
   pure subroutine find_grid(values, rounding, places, points, step, is_rounded, reason)
      !> Coordinates, each once
      real(wp), intent(in) :: values(:)
      !> How far their figures let them be from where they were
      real(wp), intent(in) :: rounding
      !> Number of the grid line of each, from one
      integer, intent(out) :: places(:)
      !> Number of grid lines, and their distance
      integer, intent(out) :: points
      real(wp), intent(out) :: step
      !> Whether they are on it only as their figures are so few
      logical, intent(out) :: is_rounded
      !> Why there is none
      character(len=:), allocatable, intent(out) :: reason
      integer, allocatable :: order(:)
      real(wp), allocatable :: lines(:)
      integer :: i, n
      real(wp) :: largest, smallest, place, steps, off

      points = 0
      step = 0.0_wp
      is_rounded = .false.
      places = 0
      allocate (order(size(values)))
      call sort(values, order)
      largest = 0.0_wp
      do i = 2, size(order)
         largest = max(largest, values(order(i)) - values(order(i - 1)))
      end do
      allocate (lines(size(values)))
      n = 0
      do i = 1, size(order)
         if (n > 0) then
            if (values(order(i)) - lines(max(n, 1)) <= same*largest) cycle
         end if
         n = n + 1
         lines(n) = values(order(i))
      end do
      if (n < 2) then
         reason = 'all are the same'
         return
      end if
      associate (gaps => lines(2:n) - lines(:n - 1))
         smallest = minval(gaps)
         ! whole numbers, and few decimals, are mostly not rounded at all
         off = 0.0_wp
         if (rounding <= coarsest*(smallest + 2.0_wp*rounding)) off = rounding
         ! gaps of one step, the smallest too, are off by twice that; those of two are larger
         step = sum(gaps, gaps <= smallest + 4.0_wp*off)/count(gaps <= smallest + 4.0_wp*off)
         steps = sum(anint(gaps/step))
      end associate
      if (steps + 1.0_wp > real(most_lines, wp)*n) then
         reason = 'distances of neighbours from '//to_text(smallest, 5)//' to '// &
            to_text(largest, 5)//' are on no grid'
         return
      end if
      points = nint(steps) + 1
      step = (lines(n) - lines(1))/steps
      do i = 1, size(values)
         place = (values(i) - lines(1))/step
         places(i) = nint(place) + 1
         if (abs(place - anint(place)) <= tolerance) cycle
         is_rounded = .true.
         if (abs(place - anint(place))*step <= 2.0_wp*off) cycle
         reason = to_text(values(i), 9)//' is not on a grid with the step '//to_text(step, 9)
         return
      end do
   end subroutine find_grid

   !> Numbers of values in their order, by heap sort.
   pure subroutine sort(values, order)
      real(wp), intent(in) :: values(:)
      integer, intent(out) :: order(:)
      integer :: i, last, moved

      do i = 1, size(values)
         order(i) = i
      end do
      do i = size(values)/2, 1, -1
         call sift(values, order, i, size(values))
      end do
      do last = size(values), 2, -1
         moved = order(last)
         order(last) = order(1)
         order(1) = moved
         call sift(values, order, 1, last - 1)
      end do
   end subroutine sort

   pure subroutine sift(values, order, first, last)
      real(wp), intent(in) :: values(:)
      integer, intent(inout) :: order(:)
      integer, intent(in) :: first, last
      integer :: root, child, moved

      root = first
      moved = order(root)
      do
         child = 2*root
         if (child > last) exit
         if (child < last) then
            if (values(order(child)) < values(order(child + 1))) child = child + 1
         end if
         if (.not. values(moved) < values(order(child))) exit
         order(root) = order(child)
         root = child
      end do
      order(root) = moved
   end subroutine sift

end module asperity_height_map_text_find_grid
