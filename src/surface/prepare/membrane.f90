!> A membrane over the holes of a map: each height in a hole is the mean of its neighbours, of four
!> or of those the border leaves. Solved by sweeps, which even out short waves, and on grids of
!> every second point, which do the same with longer ones (multigrid). The coarser grid moves a hole
!> no nearer to its edge than where the correction, linear between its points, ends at the edge:
!> it cannot do harm then, however holes and measured points are mixed.
module asperity_surface_prepare_membrane
   use, intrinsic :: iso_fortran_env, only: int8
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: mean_around, relax

   !> Sweeps before and after the coarser grid's turn, and without one
   integer, parameter :: few_sweeps = 2, many_sweeps = 20

contains

   !> One round over all grids: bring heights closer to n z - (sum of n neighbours) = load.
   pure recursive subroutine relax(z, is_hole, holes, load)
      !> Heights; those outside of holes are kept
      real(wp), intent(inout), contiguous :: z(:, :)
      !> 1 in holes, 0 elsewhere
      integer(int8), intent(in), contiguous :: is_hole(:, :)
      !> Points of the holes, two numbers each
      integer, intent(in), contiguous :: holes(:, :)
      !> Load of each
      real(wp), intent(in), contiguous :: load(:)
      real(wp), allocatable :: coarse(:, :), coarse_load(:)
      integer, allocatable :: coarse_holes(:, :)
      integer(int8), allocatable :: is_coarse_hole(:, :)
      integer :: n, i

      call sweep(z, holes, load, few_sweeps)
      allocate (is_coarse_hole((size(z, 1) + 1)/2, (size(z, 2) + 1)/2))
      call coarsen_holes(is_hole, holes, is_coarse_hole, n)
      if (n == 0 .or. minval(shape(z)) < 3) then
         call sweep(z, holes, load, many_sweeps)
         return
      end if
      allocate (coarse((size(z, 1) + 1)/2, (size(z, 2) + 1)/2), coarse_holes(2, n), coarse_load(n))
      call restrict(z, holes, load, is_coarse_hole, coarse_holes, coarse_load)
      coarse = 0.0_wp
      call relax(coarse, is_coarse_hole, coarse_holes, coarse_load)
      do i = 1, size(holes, 2)
         call add_correction(coarse, holes(1, i), holes(2, i), z(holes(1, i), holes(2, i)))
      end do
      call sweep(z, holes, load, few_sweeps)
   end subroutine relax

   !> Points of the coarser grid, those of odd numbers, with none but holes around.
   pure subroutine coarsen_holes(is_hole, holes, is_coarse_hole, n)
      integer(int8), intent(in), contiguous :: is_hole(:, :)
      integer, intent(in), contiguous :: holes(:, :)
      integer(int8), intent(out) :: is_coarse_hole(:, :)
      !> Their number
      integer, intent(out) :: n
      integer :: i

      is_coarse_hole = 0_int8
      n = 0
      do i = 1, size(holes, 2)
         if (any(modulo(holes(:, i), 2) == 0)) cycle
         associate (low => max(holes(:, i) - 1, 1), high => min(holes(:, i) + 1, shape(is_hole)))
            if (any(is_hole(low(1):high(1), low(2):high(2)) == 0_int8)) cycle
         end associate
         n = n + 1
         is_coarse_hole((holes(1, i) + 1)/2, (holes(2, i) + 1)/2) = 1_int8
      end do
   end subroutine coarsen_holes

   !> What of the load is not met yet goes to the coarser grid's points around in equal parts, the
   !> reverse of `add_correction`.
   pure subroutine restrict(z, holes, load, is_coarse_hole, coarse_holes, coarse_load)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in), contiguous :: holes(:, :)
      real(wp), intent(in), contiguous :: load(:)
      integer(int8), intent(in), contiguous :: is_coarse_hole(:, :)
      integer, intent(out) :: coarse_holes(:, :)
      real(wp), intent(out) :: coarse_load(:)
      !> Which coarse hole a coarse point is; 0 for none
      integer, allocatable :: number(:, :)
      real(wp) :: missing
      integer :: i, k, l, n, first(2), last(2)

      allocate (number(size(is_coarse_hole, 1), size(is_coarse_hole, 2)))
      number = 0
      n = 0
      do i = 1, size(holes, 2)
         if (any(modulo(holes(:, i), 2) == 0)) cycle
         if (is_coarse_hole((holes(1, i) + 1)/2, (holes(2, i) + 1)/2) == 0_int8) cycle
         n = n + 1
         coarse_holes(:, n) = (holes(:, i) + 1)/2
         number(coarse_holes(1, n), coarse_holes(2, n)) = n
      end do
      coarse_load = 0.0_wp
      do i = 1, size(holes, 2)
         first = (holes(:, i) + 1)/2
         last = min(holes(:, i)/2 + 1, shape(number))
         missing = around(z, holes(1, i), holes(2, i), load(i)) - z(holes(1, i), holes(2, i))
         missing = missing*neighbours(z, holes(1, i), holes(2, i)) &
            /real(product(last - first + 1), wp)
         do l = first(2), last(2)
            do k = first(1), last(1)
               if (number(k, l) > 0) coarse_load(number(k, l)) = coarse_load(number(k, l)) + missing
            end do
         end do
      end do
   end subroutine restrict

   !> Add to a height the mean of the coarser grid's points at or around it.
   pure subroutine add_correction(coarse, i, j, height)
      real(wp), intent(in), contiguous :: coarse(:, :)
      integer, intent(in) :: i, j
      real(wp), intent(inout) :: height

      associate (k => (i + 1)/2, l => (j + 1)/2, k2 => min(i/2 + 1, size(coarse, 1)), &
         l2 => min(j/2 + 1, size(coarse, 2)))
         height = height + 0.25_wp*(coarse(k, l) + coarse(k2, l) + coarse(k, l2) + coarse(k2, l2))
      end associate
   end subroutine add_correction

   !> Set each height in turn to what its neighbours ask for.
   pure subroutine sweep(z, holes, load, sweeps)
      !> Heights
      real(wp), intent(inout), contiguous :: z(:, :)
      !> Points of the holes
      integer, intent(in), contiguous :: holes(:, :)
      !> Load of each
      real(wp), intent(in), contiguous :: load(:)
      !> How often
      integer, intent(in) :: sweeps
      integer :: i, n

      do n = 1, sweeps
         do i = 1, size(holes, 2)
            z(holes(1, i), holes(2, i)) = around(z, holes(1, i), holes(2, i), load(i))
         end do
      end do
   end subroutine sweep

   !> Mean of the neighbours.
   pure real(wp) function mean_around(z, i, j)
      !> Heights
      real(wp), intent(in), contiguous :: z(:, :)
      !> The point
      integer, intent(in) :: i, j

      mean_around = around(z, i, j, 0.0_wp)
   end function mean_around

   !> Height with which a point carries its load.
   pure real(wp) function around(z, i, j, load)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: i, j
      real(wp), intent(in) :: load

      if (i > 1 .and. i < size(z, 1) .and. j > 1 .and. j < size(z, 2)) then
         around = 0.25_wp*(load + (z(i - 1, j) + z(i + 1, j)) + (z(i, j - 1) + z(i, j + 1)))
         return
      end if
      around = load
      if (i > 1) around = around + z(i - 1, j)
      if (i < size(z, 1)) around = around + z(i + 1, j)
      if (j > 1) around = around + z(i, j - 1)
      if (j < size(z, 2)) around = around + z(i, j + 1)
      around = around/real(neighbours(z, i, j), wp)
   end function around

   !> Number of neighbours inside the map.
   pure integer function neighbours(z, i, j)
      real(wp), intent(in), contiguous :: z(:, :)
      integer, intent(in) :: i, j

      neighbours = merge(1, 0, i > 1) + merge(1, 0, i < size(z, 1)) + merge(1, 0, j > 1) &
         + merge(1, 0, j < size(z, 2))
   end function neighbours

end module asperity_surface_prepare_membrane
