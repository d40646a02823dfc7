!> Columns with mortises as meshes; the axes are those of asperity_deck_tenon_parts.
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
   public :: column_place, new_column, new_mortised_column

   !> Where a column stands, and what passes through it.
   type :: column_place
      !> Its front face, and from foot to head, mm
      real(wp) :: face = 0.0_wp, foot = 0.0_wp, head = 0.0_wp
      !> Height of its shoes, layers of elements at both ends, mm; none when zero
      real(wp) :: shoe = 0.0_wp
      !> Heights of the axes of its beams, one at least, rising, mm
      real(wp), allocatable :: beams(:)
      !> Whether contact of some mortise begins at a distance from the back and the front face
      logical :: has_relief(2) = .false.
      !> The number of elements from face to face is a multiple of this, 1 or 2
      integer :: multiple = 1
   end type column_place

contains

   !> The column of the joint, with its mortise.
   pure subroutine new_column(mesh, choice, settings, sizes)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      type(column_place) :: place

      place%foot = -0.5_wp*sizes%column_height
      place%head = 0.5_wp*sizes%column_height
      place%beams = [0.0_wp]
      place%has_relief(1) = .true.
      call new_mortised_column(mesh, choice, settings, sizes, place)
   end subroutine new_column

   !> A column with a mortise for each of its beams.
   pure subroutine new_mortised_column(mesh, choice, settings, sizes, place)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Checked settings of the joints
      type(tenon_settings), intent(in) :: settings
      !> Further sizes
      type(tenon_sizes), intent(in) :: sizes
      !> Where it stands
      type(column_place), intent(in) :: place
      real(wp), allocatable :: x(:), y(:), z(:), inner(:), outer(:)
      logical, allocatable :: keep(:, :, :), in_mortise(:)
      integer :: i, hollow
      logical :: is_between

      call cut_mortise(choice, place%face - settings%length, place%face, &
         merge(sizes%edge_relief, 0.0_wp, place%has_relief), place%multiple, x)
      associate (side => 0.5_wp*settings%width - sizes%side_overlap)
         call even_cuts(0.0_wp, side, choice%mesh_size, 1, inner)
         call even_cuts(side, 0.5_wp*sizes%column_width, choice%mesh_size, 1, outer)
      end associate
      hollow = size(inner) - 1
      call joined_cuts(inner, outer, y)

      z = [place%foot]
      allocate (in_mortise(0))
      if (place%shoe > 0.0_wp) then
         call even_cuts(place%foot, place%foot + place%shoe, choice%mesh_size, 1, outer)
         call add(z, in_mortise, outer, .false.)
      end if
      do i = 1, size(place%beams)
         associate (bottom => place%beams(i) - 0.5_wp*settings%height - sizes%gap_below, &
               top => place%beams(i) + 0.5_wp*settings%height + sizes%gap_above)
            is_between = i > 1
            call cut_part(choice, z(size(z)), bottom, [is_between, .true.], 1, outer)
            call add(z, in_mortise, outer, .false.)
            call cut_mortise(choice, bottom, top, [sizes%edge_relief, sizes%edge_relief], 1, outer)
            call add(z, in_mortise, outer, .true.)
         end associate
      end do
      call cut_part(choice, z(size(z)), place%head - place%shoe, [.true., .false.], 1, outer)
      call add(z, in_mortise, outer, .false.)
      if (place%shoe > 0.0_wp) then
         call even_cuts(place%head - place%shoe, place%head, choice%mesh_size, 1, outer)
         call add(z, in_mortise, outer, .false.)
      end if

      allocate (keep(size(x) - 1, size(y) - 1, size(z) - 1), source=.true.)
      do i = 1, size(in_mortise)
         keep(:, :hollow, i) = .not. in_mortise(i)
      end do
      call new_grid_mesh(mesh, x, y, z, keep)

   end subroutine new_mortised_column

   !> Planes after those that there are, and whether what is between them is mortise.
   pure subroutine add(cuts, in_mortise, more, is_mortise)
      real(wp), allocatable, intent(inout) :: cuts(:)
      logical, allocatable, intent(inout) :: in_mortise(:)
      real(wp), intent(in) :: more(:)
      logical, intent(in) :: is_mortise
      integer :: i

      in_mortise = [in_mortise, (is_mortise, i=2, size(more))]
      cuts = [cuts, more(2:)]
   end subroutine add

end module asperity_deck_tenon_column
