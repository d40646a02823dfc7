!> Maps of a solid joint at the states that were kept: contact of the mortise's faces, unfolded (the
!> paper's Figs 31 to 33), and plastic strain of the wood (Fig. 23).
module asperity_program_commands_solid_maps
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_open, status_slip, status_stick, status_unset
   use asperity_program_commands_joint_loops, only: legends
   use asperity_program_commands_solid_outcome, only: common_snapshots, solid_outcome
   use asperity_program_commands_solid_snapshot, only: contact_value, solid_snapshot
   use asperity_program_plot_figure, only: as_boxes, figure_type, panel_type
   use asperity_program_plot_palette, only: black, blue, red, sky
   use asperity_solid_mesh_joint, only: face_bottom, face_side
   implicit none
   private
   public :: map_pictures

   !> States that are shown, the last of those kept
   integer, parameter :: most_shown = 2
   !> Between the faces, over the height of the mortise
   real(wp), parameter :: gap = 0.05_wp
   !> What is seen of the wood about the mortise, over its height
   real(wp), parameter :: surroundings = 0.5_wp
   !> Nodes this near to the plane of symmetry are in it, over the size of the elements
   real(wp), parameter :: in_plane = 1.0e-6_wp

contains

   !> States, pressure, plastic strain; none when no state was kept.
   pure function map_pictures(outcomes) result(pictures)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(figure_type), allocatable :: pictures(:)
      type(panel_type), allocatable :: states(:), pressures(:), strains(:)
      integer, allocatable :: kinds(:)
      integer :: i, j, n

      allocate (kinds, source=common_snapshots(outcomes))
      kinds = kinds(max(1, size(kinds) - most_shown + 1):)
      allocate (pictures(0))
      if (size(kinds) == 0) return
      n = size(kinds)*size(outcomes)
      allocate (states(n), pressures(n), strains(size(outcomes)))
      n = 0
      do j = 1, size(kinds)
         do i = 1, size(outcomes)
            n = n + 1
            associate (snapshot => outcomes(i)%snapshots(findloc(outcomes(i)%snapshots%kind, &
                  kinds(j), 1)))
               associate (title => trim(legends(outcomes(i)%model))//', load point at '// &
                     to_text(snapshot%displacement, 4)//' mm')
                  states(n) = face_panel(title)
                  call draw_states(states(n), snapshot)
                  pressures(n) = face_panel(title)
                  call draw_pressure(pressures(n), snapshot, largest_pressure(outcomes, kinds))
                  if (j == 1) call draw_strain(strains(i), title, outcomes(i), snapshot)
               end associate
            end associate
         end do
      end do
      strains%colours%high = maxval(strains%colours%high)
      pictures = [ &
         figure_type('Open, sticking and slipping cells of the mortise''s faces, unfolded about '// &
         'the upper and the lower edge of its side; the plane of symmetry is at the top and at '// &
         'the bottom, the column face on the right (Figs 31 and 32).', states), &
         figure_type('Contact pressure of the same faces (Fig. 33).', pressures), &
         figure_type('Equivalent plastic strain in the plane of symmetry, the largest of each '// &
         'element, drawn undeformed (Fig. 23).', strains)]
   end function map_pictures

   !> A panel of the unfolded faces.
   pure function face_panel(title) result(panel)
      character(len=*), intent(in) :: title
      type(panel_type) :: panel

      panel = panel_type('x (mm)', 'lower | side | upper face (mm)', title)
      panel%empty = 'nothing is opposite'
   end function face_panel

   !> Cells by their status.
   pure subroutine draw_states(panel, snapshot)
      type(panel_type), intent(inout) :: panel
      type(solid_snapshot), intent(in) :: snapshot

      call add_status(panel, snapshot%contact, [status_unset, status_open], 'open', sky)
      call add_status(panel, snapshot%contact, [status_stick], 'stick', black)
      call add_status(panel, snapshot%contact, [status_slip], 'slip', red)
   end subroutine draw_states

   !> Cells of some states.
   pure subroutine add_status(panel, cells, states, legend, colour)
      type(panel_type), intent(inout) :: panel
      type(contact_value), intent(in) :: cells(:)
      integer, intent(in) :: states(:), colour
      character(len=*), intent(in) :: legend
      integer :: i

      call add_cells(panel, pack(cells, cells%coverage > 0.0_wp .and. &
         [(any(cells(i)%status == states), i=1, size(cells))]), cells, legend, colour)
   end subroutine add_status

   !> Cells coloured by their pressure.
   pure subroutine draw_pressure(panel, snapshot, largest)
      type(panel_type), intent(inout) :: panel
      type(solid_snapshot), intent(in) :: snapshot
      real(wp), intent(in) :: largest
      type(contact_value), allocatable :: cells(:)

      cells = pack(snapshot%contact, snapshot%contact%coverage > 0.0_wp)
      panel%colours%label = 'pressure (MPa)'
      panel%colours%low = 0.0_wp
      panel%colours%high = largest
      call add_cells(panel, cells, snapshot%contact, '', blue, cells%pressure)
   end subroutine draw_pressure

   !> Largest pressure of the states that are shown, MPa; something where there is none.
   pure real(wp) function largest_pressure(outcomes, kinds)
      type(solid_outcome), intent(in) :: outcomes(:)
      integer, intent(in) :: kinds(:)
      integer :: i, j

      largest_pressure = 0.0_wp
      do i = 1, size(outcomes)
         do j = 1, size(outcomes(i)%snapshots)
            associate (snapshot => outcomes(i)%snapshots(j))
               if (any(kinds == snapshot%kind)) largest_pressure = max(largest_pressure, &
                  maxval(snapshot%contact%pressure, mask=snapshot%contact%coverage > 0.0_wp))
            end associate
         end do
      end do
      if (.not. largest_pressure > 0.0_wp) largest_pressure = 1.0_wp
   end function largest_pressure

   !> Cells as boxes where they are when the faces are unfolded: the side as it is, the upper face
   !> above it, the lower one below.
   pure subroutine add_cells(panel, cells, all_cells, legend, colour, z)
      type(panel_type), intent(inout) :: panel
      type(contact_value), intent(in) :: cells(:), all_cells(:)
      character(len=*), intent(in) :: legend
      integer, intent(in) :: colour
      real(wp), intent(in), optional :: z(:)
      real(wp) :: place(size(cells)), sizes(2, size(cells)), low, high, depth
      integer :: i

      high = maxval(all_cells%position(3))
      low = minval(all_cells%position(3))
      depth = maxval(all_cells%position(2) + 0.5_wp*all_cells%extent(2))
      do i = 1, size(cells)
         associate (cell => cells(i))
            sizes(:, i) = cell%extent([1, 2])
            if (cell%pair == face_side) then
               place(i) = cell%position(3)
               sizes(2, i) = cell%extent(3)
            else if (cell%pair == face_bottom) then
               place(i) = low - gap*(high - low) - (depth - cell%position(2))
            else
               place(i) = high + gap*(high - low) + (depth - cell%position(2))
            end if
         end associate
      end do
      call panel%add(cells%position(1), place, legend, colour, as_boxes, z=z, sizes=sizes)
   end subroutine add_cells

   !> Elements in the plane of symmetry about the mortise, coloured by their plastic strain.
   pure subroutine draw_strain(panel, title, outcome, snapshot)
      type(panel_type), intent(out) :: panel
      character(len=*), intent(in) :: title
      type(solid_outcome), intent(in) :: outcome
      type(solid_snapshot), intent(in) :: snapshot
      real(wp), dimension(size(snapshot%plastic_strain)) :: x, z, strain
      real(wp) :: sizes(2, size(snapshot%plastic_strain)), low(2), high(2), from(2), to(2), room
      integer :: i, n

      low = [minval(snapshot%contact%position(1)), minval(snapshot%contact%position(3))]
      high = [maxval(snapshot%contact%position(1)), maxval(snapshot%contact%position(3))]
      room = surroundings*(high(2) - low(2))
      low = low - room
      high = high + room
      n = 0
      do i = 1, size(strain)
         associate (nodes => outcome%mesh%nodes(:, outcome%mesh%elements(:, i)))
            if (minval(abs(nodes(2, :))) > in_plane*maxval(abs(nodes(2, :)))) cycle
            from = max(low, minval(nodes([1, 3], :), 2))
            to = min(high, maxval(nodes([1, 3], :), 2))
         end associate
         if (any(to <= from)) cycle
         n = n + 1
         x(n) = 0.5_wp*(from(1) + to(1))
         z(n) = 0.5_wp*(from(2) + to(2))
         sizes(:, n) = to - from
         strain(n) = snapshot%plastic_strain(i)
      end do
      panel = panel_type('x (mm)', 'z (mm)', title)
      panel%colours%label = 'plastic strain'
      panel%colours%low = 0.0_wp
      panel%colours%high = 1.0_wp
      if (any(strain(:n) > 0.0_wp)) panel%colours%high = maxval(strain(:n))
      call panel%add(x(:n), z(:n), '', blue, as_boxes, z=strain(:n), sizes=sizes(:, :n))
   end subroutine draw_strain

end module asperity_program_commands_solid_maps
