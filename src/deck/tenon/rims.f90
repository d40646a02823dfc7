!> Planes that cut parts which have rims of the mortise or the tenon.
module asperity_deck_tenon_rims
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_cuts, only: add_cut, even_cuts, graded_cuts
   use asperity_deck_options, only: deck_choice
   implicit none
   private
   public :: cut_part, cut_mortise

contains

   !> Planes of a length of a part, which has rims of the mortise or the tenon at its ends.
   pure subroutine cut_part(choice, from, to, rims, least, cuts)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Ends of the length, mm, and which of them are rims
      real(wp), intent(in) :: from, to
      logical, intent(in) :: rims(2)
      !> Fewest cells, of which the number is a multiple, 2 with two rims only
      integer, intent(in) :: least
      !> Places of the planes, mm
      real(wp), allocatable, intent(out) :: cuts(:)

      if (allocated(choice%rim_mesh_size)) then
         call graded_cuts(from, to, rims, choice%rim_mesh_size, choice%mesh_size, &
            choice%mesh_growth, cuts)
      else
         call even_cuts(from, to, choice%mesh_size, least, cuts)
      end if
   end subroutine cut_part

   !> Planes of a length of the mortise, with planes where contact begins.
   pure subroutine cut_mortise(choice, from, to, relief, least, cuts)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Ends of the length, which are rims, and how far from them contact begins, mm
      real(wp), intent(in) :: from, to, relief(2)
      !> Fewest cells, of which the number is a multiple, but for those where contact begins
      integer, intent(in) :: least
      !> Places of the planes, mm
      real(wp), allocatable, intent(out) :: cuts(:)

      if (allocated(choice%rim_mesh_size)) then
         ! cells grow from where contact begins, so that none is a sliver
         call cut_part(choice, from + relief(1), to - relief(2), [.true., .true.], least, cuts)
         if (relief(1) > 0.0_wp) cuts = [from, cuts]
         if (relief(2) > 0.0_wp) cuts = [cuts, to]
      else
         call cut_part(choice, from, to, [.true., .true.], least, cuts)
         call add_cut(cuts, from + relief(1))
         call add_cut(cuts, to - relief(2))
      end if
   end subroutine cut_mortise

end module asperity_deck_tenon_rims
