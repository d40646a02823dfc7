!> Columns and beams of a frame as meshes: one half, y across from the plane of symmetry.
module asperity_solid_frame_parts
   use asperity_base_kinds, only: wp
   use asperity_deck_mesh_cuts, only: even_cuts
   use asperity_deck_mesh_hexahedra, only: hex_mesh, new_grid_mesh
   use asperity_deck_tenon_column, only: column_place, new_mortised_column
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_deck_tenon_rims, only: cut_part
   use asperity_solid_frame_settings, only: frame_settings, shoe_height
   implicit none
   private
   public :: column_face, new_frame_column, new_frame_beam, ends_flush

contains

   !> Front face of a column, mm; its back is `length` behind.
   pure real(wp) function column_face(frame, deck, column)
      !> The frame, and its joints
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      !> Number of the column
      integer, intent(in) :: column

      column_face = frame%column_places(column) + 0.5_wp*deck%settings%length
   end function column_face

   !> Whether a beam ends at the back and at the front face of a column: contact begins a little
   !> inside there, as nodes at the edge of the beam would find and lose it in turn.
   pure function ends_flush(frame, deck, beam, column) result(flush)
      !> The frame, and its joints
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      !> Numbers of the beam and the column
      integer, intent(in) :: beam, column
      logical :: flush(2)

      flush = [frame%beam_from(beam), frame%beam_to(beam)] == column
      flush = flush .and. .not. deck%sizes%tail > 0.0_wp
   end function ends_flush

   !> A column, with a node line along its axis at foot and head.
   pure subroutine new_frame_column(mesh, frame, deck, column)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> The frame, checked, and its joints
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      !> Number of the column
      integer, intent(in) :: column
      type(column_place) :: place
      logical :: is_here(size(frame%beam_heights))
      integer :: i, lowest

      place%face = column_face(frame, deck, column)
      place%head = deck%sizes%column_height
      place%shoe = shoe_height(deck%settings)
      place%multiple = 2
      is_here = frame%beam_from <= column .and. frame%beam_to >= column
      allocate (place%beams(0))
      do while (any(is_here))
         lowest = minloc(frame%beam_heights, 1, is_here)
         place%beams = [place%beams, frame%beam_heights(lowest)]
         is_here(lowest) = .false.
      end do
      do i = 1, size(frame%beam_heights)
         place%has_relief = place%has_relief .or. ends_flush(frame, deck, i, column)
      end do
      call new_mortised_column(mesh, deck%choice, deck%settings, deck%sizes, place)
   end subroutine new_frame_column

   !> A beam, with a section at every column face and nodes at mid-height.
   pure subroutine new_frame_beam(mesh, frame, deck, beam)
      !> Result
      type(hex_mesh), intent(out) :: mesh
      !> The frame, checked, and its joints
      type(frame_settings), intent(in) :: frame
      type(tenon_deck), intent(in) :: deck
      !> Number of the beam
      integer, intent(in) :: beam
      real(wp), allocatable :: x(:), y(:), z(:)
      real(wp) :: back, front
      integer :: i

      associate (s => deck%settings, from => frame%beam_from(beam), to => frame%beam_to(beam), &
            tail => deck%sizes%tail, height => frame%beam_heights(beam))
         x = [column_face(frame, deck, from) - s%length - tail]
         do i = from, to
            front = column_face(frame, deck, i)
            back = front - s%length
            if (i > from) call add(x, deck, back, [.true., .true.])
            if (i == from .and. tail > 0.0_wp) call add(x, deck, back, [.false., .true.])
            call add(x, deck, front, [.true., .true.])
         end do
         if (tail > 0.0_wp) call add(x, deck, front + tail, [.true., .false.])
         call even_cuts(0.0_wp, 0.5_wp*s%width, deck%choice%mesh_size, 1, y)
         call cut_part(deck%choice, height - 0.5_wp*s%height, height + 0.5_wp*s%height, &
            [.true., .true.], 2, z)
      end associate
      call new_grid_mesh(mesh, x, y, z)
   end subroutine new_frame_beam

   !> Planes of the next length of a beam.
   pure subroutine add(cuts, deck, to, rims)
      real(wp), allocatable, intent(inout) :: cuts(:)
      type(tenon_deck), intent(in) :: deck
      !> Its end, mm, and which of its ends are rims
      real(wp), intent(in) :: to
      logical, intent(in) :: rims(2)
      real(wp), allocatable :: more(:)

      call cut_part(deck%choice, cuts(size(cuts)), to, rims, 1, more)
      cuts = [cuts, more(2:)]
   end subroutine add

end module asperity_solid_frame_parts
