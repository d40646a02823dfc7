!> Planes that cut a length into cells.
module asperity_deck_mesh_cuts
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: even_cuts, joined_cuts, add_cut

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
