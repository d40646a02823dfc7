!> Maps of a solid joint at the states that were kept: contact of the mortise's faces, unfolded (the
!> paper's Figs 31 to 33), and plastic strain of the wood (Fig. 23).
module asperity_program_commands_solid_maps
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_state, only: status_open, status_slip, status_stick, status_unset
   use asperity_program_commands_joint_loops, only: legends
   use asperity_program_commands_solid_outcome, only: common_snapshots, solid_outcome
   use asperity_program_commands_solid_snapshot, only: contact_value, lower_peak, &
      solid_snapshot, upper_peak
   use asperity_program_plot_figure, only: as_boxes, figure_type, panel_type
   use asperity_program_plot_palette, only: black, blue, red, sky
   use asperity_solid_mesh_joint, only: face_bottom, face_side
   implicit none
   private
   public :: map_pictures

   !> What is shown
   integer, parameter :: states = 1, pressures = 2, strains = 3
   !> States in which contact is shown, the last of those kept; those in which the wood is
   integer, parameter :: most_shown = 2, peaks(2) = [upper_peak, lower_peak]
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
      integer, allocatable :: kinds(:), shown(:)
      integer :: i

      allocate (kinds, source=common_snapshots(outcomes))
      allocate (pictures(0))
      if (size(kinds) == 0) return
      shown = kinds(max(1, size(kinds) - most_shown + 1):)
      pictures = [ &
         figure_type('Open, sticking and slipping cells of the mortise, unfolded about the '// &
         'edges of its side: the upper face is above the side, the lower one below it, the '// &
         'plane of symmetry at the top and at the bottom, the column face on the right (Figs '// &
         '31 and 32), at two displacements of the load point.', &
         panels_of(outcomes, shown, states)), &
         figure_type('Contact pressure of the same faces (Fig. 33).', &
         panels_of(outcomes, shown, pressures))]
      shown = pack(kinds, [(any(kinds(i) == peaks), i=1, size(kinds))])
      if (size(shown) == 0) return
      pictures = [pictures, figure_type('Equivalent plastic strain in the plane of symmetry, '// &
         'the largest of each element, drawn undeformed (Fig. 23).', &
         panels_of(outcomes, shown, strains))]
   end function map_pictures

   !> A panel for each model at each state, the models side by side.
   pure function panels_of(outcomes, kinds, what) result(panels)
      type(solid_outcome), intent(in) :: outcomes(:)
      integer, intent(in) :: kinds(:)
      !> `states`, `pressures` or `strains`
      integer, intent(in) :: what
      type(panel_type), allocatable :: panels(:)
      integer :: i, j, n

      allocate (panels(size(kinds)*size(outcomes)))
      n = 0
      do j = 1, size(kinds)
         do i = 1, size(outcomes)
            n = n + 1
            associate (snapshot => outcomes(i)%snapshots(findloc(outcomes(i)%snapshots%kind, &
                  kinds(j), 1)))
               panels(n) = panel_type('x (mm)', 'unfolded (mm)', &
                  trim(legends(outcomes(i)%model))//', '//to_text(snapshot%displacement, 3)//' mm')
               panels(n)%empty = 'nothing is opposite'
               select case (what)
               case (states)
                  call draw_states(panels(n), snapshot)
               case (pressures)
                  call draw_pressure(panels(n), snapshot)
               case default
                  call draw_strain(panels(n), outcomes(i), snapshot)
               end select
            end associate
         end do
      end do
      if (what == states) return
      ! one scale for all, also where nothing is above zero
      panels%colours%high = maxval(panels%colours%high)
      if (.not. panels(1)%colours%high > 0.0_wp) panels%colours%high = 1.0_wp
   end function panels_of

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
   pure subroutine draw_pressure(panel, snapshot)
      type(panel_type), intent(inout) :: panel
      type(solid_snapshot), intent(in) :: snapshot
      type(contact_value), allocatable :: cells(:)

      cells = pack(snapshot%contact, snapshot%contact%coverage > 0.0_wp)
      call set_colours(panel, 'pressure (MPa)', (cells%pressure))
      call add_cells(panel, cells, snapshot%contact, '', blue, (cells%pressure))
   end subroutine draw_pressure

   !> Colours from zero to the largest value.
   pure subroutine set_colours(panel, label, values)
      type(panel_type), intent(inout) :: panel
      character(len=*), intent(in) :: label
      real(wp), intent(in) :: values(:)

      panel%colours%label = label
      panel%colours%low = 0.0_wp
      panel%colours%high = max(0.0_wp, maxval(values))
   end subroutine set_colours

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
      call panel%add((cells%position(1)), place, legend, colour, as_boxes, z=z, sizes=sizes)
   end subroutine add_cells

   !> Elements in the plane of symmetry about the mortise, coloured by their plastic strain.
   pure subroutine draw_strain(panel, outcome, snapshot)
      type(panel_type), intent(inout) :: panel
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
      panel%y%label = 'z (mm)'
      call set_colours(panel, 'plastic strain', strain(:n))
      call panel%add(x(:n), z(:n), '', blue, as_boxes, z=strain(:n), sizes=sizes(:, :n))
   end subroutine draw_strain

end module asperity_program_commands_solid_maps
