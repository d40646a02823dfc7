!> Planes that cut a length into cells.
module asperity_deck_mesh_cuts
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: even_cuts, graded_cuts, joined_cuts, add_cut

   !> How far a node may be beside a plane and still be on it, mm
   real(wp), parameter, public :: tolerance = 1.0e-6_wp

contains

   !> Planes that cut a length into equal cells of about a size, at least `least` of them.
   pure subroutine even_cuts(from, to, size_wanted, least, cuts)
      !> Ends of the length, mm
      real(wp), intent(in) :: from, to
      !> Size of a cell aimed at, mm
      real(wp), intent(in) :: size_wanted
      !> Fewest cells, of which the number is a multiple
      integer, intent(in) :: least
      !> Places of the planes, mm
      real(wp), allocatable, intent(out) :: cuts(:)
      integer :: n, i

      n = least*max(1, nint((to - from)/(least*size_wanted)))
      allocate (cuts(n + 1))
      cuts = [(from + (to - from)*(real(i, wp)/n), i=0, n)]
      cuts(n + 1) = to
   end subroutine even_cuts

   !> Planes that cut a length into cells which grow from its rims, the ends where cells are finest:
   !> each is `growth` times its neighbour until they are as large as they may be. All are stretched
   !> a little, so that they fill the length.
   pure subroutine graded_cuts(from, to, rims, finest, largest, growth, cuts)
      !> Ends of the length, mm
      real(wp), intent(in) :: from, to
      !> Which of the ends are rims, one at least; with both, there is a plane in the middle
      logical, intent(in) :: rims(2)
      !> Sizes of a cell aimed at, at the rims and away from them, mm
      real(wp), intent(in) :: finest, largest
      !> Ratio of neighbouring cells, above 1
      real(wp), intent(in) :: growth
      !> Places of the planes, mm
      real(wp), allocatable, intent(out) :: cuts(:)
      real(wp), allocatable :: places(:)
      real(wp) :: length, cell, filled
      integer :: n

      length = (to - from)/count(rims)
      allocate (places(0))
      filled = 0.0_wp
      cell = finest
      do
         filled = filled + cell
         places = [places, filled]
         if (.not. filled < length) exit
         cell = min(growth*cell, largest)
      end do
      ! so many cells that they are stretched by less, up or down
      n = size(places)
      if (n > 1) then
         if (length/places(n - 1) < places(n)/length) n = n - 1
      end if
      places = places(:n)/places(n)*length
      if (all(rims)) then
         cuts = [from, from + places, to - places(n - 1:1:-1), to]
      else if (rims(1)) then
         cuts = [from, from + places(:n - 1), to]
      else
         cuts = [from, to - places(n - 1:1:-1), to]
      end if
   end subroutine graded_cuts

   !> Planes of two neighbouring lengths as one list.
   pure subroutine joined_cuts(first, second, cuts)
      !> Planes of the first length, and of the second, which begins where the first ends
      real(wp), intent(in) :: first(:), second(:)
      !> All planes
      real(wp), allocatable, intent(out) :: cuts(:)

      allocate (cuts(size(first) + size(second) - 1))
      cuts = [first, second(2:)]
   end subroutine joined_cuts

   !> One plane more, unless there is one at its place.
   pure subroutine add_cut(cuts, place)
      !> Planes, rising
      real(wp), allocatable, intent(inout) :: cuts(:)
      !> The place, mm, between the first and the last
      real(wp), intent(in) :: place

      if (any(abs(cuts - place) < tolerance)) return
      cuts = [pack(cuts, cuts < place), place, pack(cuts, cuts > place)]
   end subroutine add_cut

end module asperity_deck_mesh_cuts
