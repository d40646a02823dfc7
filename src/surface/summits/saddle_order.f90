!> Saddle points of a map and their order from the highest down.
module asperity_surface_summits_saddle_order
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: saddle_type, sort_saddles

   !> A point where hills meet.
   type :: saddle_type
      !> Its height
      real(wp) :: height = 0.0_wp
      !> Its place in the map's storage, from 1
      integer :: place = 0
      !> Which of its neighbours are higher, a bit each
      integer :: higher = 0
   end type saddle_type

   !> Shorter lists are sorted by insertion
   integer, parameter :: short = 24

contains

   !> Sort from the highest down; of equal heights, the later in storage comes first.
   pure subroutine sort_saddles(saddles)
      !> The saddles
      type(saddle_type), intent(inout), contiguous :: saddles(:)

      call quick_sort(saddles, 2*exponent(real(size(saddles), wp)))
   end subroutine sort_saddles

   !> Whether `a` comes before `b`.
   pure logical function is_before(a, b)
      type(saddle_type), intent(in) :: a, b

      is_before = a%height > b%height &
         .or. (.not. a%height < b%height .and. a%place > b%place)
   end function is_before

   !> Split about the median of three, in place; by a heap where that goes wrong too often.
   pure recursive subroutine quick_sort(list, depth)
      type(saddle_type), intent(inout), contiguous :: list(:)
      !> Splits before the heap takes over
      integer, intent(in) :: depth
      type(saddle_type) :: pivot
      integer :: first, last

      if (size(list) <= short) then
         call insertion_sort(list)
         return
      end if
      if (depth == 0) then
         call heap_sort(list)
         return
      end if
      pivot = middle_of(list(1), list((size(list) + 1)/2), list(size(list)))
      first = 1
      last = size(list)
      do
         do while (is_before(list(first), pivot))
            first = first + 1
         end do
         do while (is_before(pivot, list(last)))
            last = last - 1
         end do
         if (first <= last) then
            call swap(list(first), list(last))
            first = first + 1
            last = last - 1
         end if
         if (first > last) exit
      end do
      call quick_sort(list(:last), depth - 1)
      call quick_sort(list(first:), depth - 1)
   end subroutine quick_sort

   pure type(saddle_type) function middle_of(a, b, c)
      type(saddle_type), intent(in) :: a, b, c

      if (is_before(a, b) .eqv. is_before(b, c)) then
         middle_of = b
      else if (is_before(b, a) .eqv. is_before(a, c)) then
         middle_of = a
      else
         middle_of = c
      end if
   end function middle_of

   pure subroutine swap(a, b)
      type(saddle_type), intent(inout) :: a, b
      type(saddle_type) :: kept

      kept = a
      a = b
      b = kept
   end subroutine swap

   pure subroutine insertion_sort(list)
      type(saddle_type), intent(inout), contiguous :: list(:)
      type(saddle_type) :: moved
      integer :: i, j

      do i = 2, size(list)
         moved = list(i)
         j = i - 1
         do while (j >= 1)
            if (.not. is_before(moved, list(j))) exit
            list(j + 1) = list(j)
            j = j - 1
         end do
         list(j + 1) = moved
      end do
   end subroutine insertion_sort

   pure subroutine heap_sort(list)
      type(saddle_type), intent(inout), contiguous :: list(:)
      integer :: i

      do i = size(list)/2, 1, -1
         call sift_down(list, i)
      end do
      do i = size(list), 2, -1
         call swap(list(1), list(i))
         call sift_down(list(:i - 1), 1)
      end do
   end subroutine heap_sort

   !> Let an element sink below all that come after it in the order.
   pure subroutine sift_down(list, start)
      type(saddle_type), intent(inout), contiguous :: list(:)
      integer, intent(in) :: start
      integer :: parent, child

      parent = start
      do
         child = 2*parent
         if (child > size(list)) exit
         if (child < size(list)) then
            if (is_before(list(child), list(child + 1))) child = child + 1
         end if
         if (.not. is_before(list(parent), list(child))) exit
         call swap(list(parent), list(child))
         parent = child
      end do
   end subroutine sift_down

end module asperity_surface_summits_saddle_order
