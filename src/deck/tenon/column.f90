!> The column of the tenon joint as a mesh; the axes are those of asperity_deck_tenon_parts.
module asperity_deck_tenon_column
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_cuts, only: even_cuts, joined_cuts
   use asperity_deck_mesh_hexahedra, only: hex_mesh, new_grid_mesh
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_parts, only: tenon_sizes
   use asperity_deck_tenon_rims, only: cut_mortise, cut_part
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: new_column

contains

   !> The column with its mortise.
   pure subroutine new_column(mesh, choice, settings, sizes)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      real(wp), allocatable :: x(:), y(:), z(:), inner(:), outer(:)
      logical, allocatable :: keep(:, :, :)
      integer :: in_mortise, above, below, hollow

      associate (top => 0.5_wp*settings%height + sizes%gap_above, &
            bottom => -0.5_wp*settings%height - sizes%gap_below, &
            side => 0.5_wp*settings%width - sizes%side_overlap)
         call cut_mortise(choice, -settings%length, 0.0_wp, [sizes%edge_relief, 0.0_wp], x)
         call even_cuts(0.0_wp, side, choice%mesh_size, 1, inner)
         call even_cuts(side, 0.5_wp*sizes%column_width, choice%mesh_size, 1, outer)
         hollow = size(inner) - 1
         call joined_cuts(inner, outer, y)
         call cut_part(choice, -0.5_wp*sizes%column_height, bottom, [.false., .true.], 1, inner)
         call cut_mortise(choice, bottom, top, [sizes%edge_relief, sizes%edge_relief], outer)
         below = size(inner) - 1
         in_mortise = size(outer) - 1
         call joined_cuts(inner, outer, z)
         inner = z
         call cut_part(choice, top, 0.5_wp*sizes%column_height, [.true., .false.], 1, outer)
         above = size(outer) - 1
         call joined_cuts(inner, outer, z)
      end associate
      allocate (keep(size(x) - 1, size(y) - 1, below + in_mortise + above), source=.true.)
      keep(:, :hollow, below + 1:below + in_mortise) = .false.
      call new_grid_mesh(mesh, x, y, z, keep)
   end subroutine new_column

end module asperity_deck_tenon_column
