!> The text of the tenon joint's deck.
module deck_tenon_text
   use asperity, only: wp
   use asperity_text, only: to_text
   use deck_choices, only: element_kind, for_calculix
   use deck_head, only: write_head
   use deck_hex_mesh, only: nodes_in_box
   use deck_interaction, only: write_interaction, write_pair
   use deck_steps, only: close_step, open_step, step_type, write_boundary
   use deck_tenon_deck, only: tenon_deck
   use deck_tenon_parts, only: node_near
   use deck_wood, only: write_axes, write_wood
   use deck_writer, only: writer_type
   use replay_tenon_settings, only: tenon_face_arm
   implicit none
   private
   public :: write_tenon_deck

   real(wp), parameter :: far = huge(1.0_wp)
   !> Stiffness of the spring that holds the open joint, N/mm: nothing beside wood
   real(wp), parameter :: holding_stiffness = 0.1_wp
   !> Displacement beyond which strokes have twice the increments, mm
   real(wp), parameter :: wide = 16.0_wp
   character(len=*), parameter :: force_sets(5) = [character(len=8) :: 'TIP', 'BOTTOM', 'TOP', &
      'SYMMETRY', 'AXIAL']
   character(len=*), parameter :: gauges(2) = [character(len=8) :: 'TIP', 'AXIAL']

contains

   !> The text of the deck.
   pure subroutine write_tenon_deck(model, text)
      !> The model
      type(tenon_deck), intent(in) :: model
      !> The deck
      character(len=:), allocatable, intent(out) :: text
      type(writer_type) :: deck

      call write_words(deck, model)
      call write_parts(deck, model)
      call write_contact(deck, model)
      call write_supports(deck, model)
      call write_steps(deck, model)
      text = deck%text()
   end subroutine write_tenon_deck

   !> What the model is, and what of it is chosen.
   pure subroutine write_words(deck, model)
      type(writer_type), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model

      call write_head(deck, model%choice, 'Straight tenon joint under cyclic load')
      associate (s => model%settings, sizes => model%sizes)
         call deck%comment('HALF MODEL: one side of the plane through the middle of the beam, '// &
            'y = 0. Forces and moments of the joint are twice those of this deck. x runs along '// &
            'the beam, 0 at the column face; z up, 0 at the middle of the beam.')
         call deck%comment('Load: set TIP, '//to_text(tenon_face_arm(s), 6)//' mm from the '// &
            'column face, moves in z; each step is one stroke between two turning points and '// &
            'takes one unit of time. The sum of the forces of TIP is the (half) force.')
         call deck%comment('Chosen, as the paper''s text does not say it, besides what the case '// &
            'marks so:')
         call deck%comment('- Column '//to_text(sizes%column_height, 6)//' mm high and '// &
            to_text(sizes%column_width, 6)//' mm wide; foot held, top free in z only and level '// &
            '(*EQUATION); beam '//to_text(sizes%tail, 4)//' mm longer than the column is deep.')
         call deck%comment('- Grain: of the column along z, R along y; of the beam along x, R '// &
            'along z. Table 1 has one modulus for R and T.')
         call deck%comment('- Gap: the meshes are '//to_text(sizes%gap_above, 6)//' mm apart above '// &
            'and '//to_text(sizes%gap_below, 6)//' mm below the beam; negative is an overlap. '// &
            gap_words(model))
         if (model%has_sides) then
            call deck%comment('- Sides: an interference of '//to_text(sizes%side_interference, 6) &
               //' mm for about '//to_text(s%side_pressure, 4)//' MPa: the overclosure of contact '// &
               'at that pressure, by which the meshes overlap ('//to_text(sizes%side_overlap, 6)// &
               ' mm), and what the wood gives way under it (half the beam squeezed, the cheek of '// &
               'the column bent and sheared), by which the beam swells in a step of its own, as '// &
               'solvers do not find the way out of a large overlap. An estimate of the mean; '// &
               'what pressure comes of it is in the results.')
         else
            call deck%comment('- Sides: no pressure, no contact.')
         end if
         if (s%axial_rule == 'spring') then
            call deck%comment('- Axial hold: a spring of half of '// &
               to_text(s%axial_stiffness, 6)//' N/mm to ground, at the node nearest to the '// &
               'middle of the tenon at the column face.')
         else
            call deck%comment('- Axial hold: the node nearest to the middle of the tenon at the '// &
               'column face is held in x.')
         end if
         call deck%comment('- A spring of '//to_text(holding_stiffness, 3)//' N/mm in z at the '// &
            'end of the tenon holds the joint while it is open.')
      end associate
   end subroutine write_words

   !> Where the gap comes from.
   pure function gap_words(model) result(words)
      type(tenon_deck), intent(in) :: model
      character(len=:), allocatable :: words

      if (model%choice%contact == 'hard') then
         words = 'For hard contact, the clearance.'
      else if (model%settings%gap == 'mean_plane') then
         words = 'The clearance is between mean planes, so it is the gap of the meshes and d0.'
      else
         words = 'The clearance is the way to first touch.'
      end if
   end function gap_words

   !> Meshes and wood.
   pure subroutine write_parts(deck, model)
      type(writer_type), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      real(wp), parameter :: x(3) = [1.0_wp, 0.0_wp, 0.0_wp], y(3) = [0.0_wp, 1.0_wp, 0.0_wp], &
         z(3) = [0.0_wp, 0.0_wp, 1.0_wp]

      call deck%heading('meshes')
      call deck%nodes(model%column, 0, 'COLUMN_NODES')
      call deck%elements(model%column, 0, 0, element_kind(model%choice), 'COLUMN')
      call deck%nodes(model%beam, size(model%column%nodes, 2), 'BEAM_NODES')
      call deck%elements(model%beam, size(model%column%elements, 2), &
         size(model%column%nodes, 2), element_kind(model%choice), 'BEAM')
      call deck%heading('wood: Table 1 of the paper; 1 = L, 2 = R, 3 = T')
      call write_axes(deck, 'COLUMN_AXES', z, y)
      call write_axes(deck, 'BEAM_AXES', x, z)
      call write_wood(deck, model%choice, model%wood, 'COLUMN_WOOD', .true.)
      call write_wood(deck, model%choice, model%wood, 'BEAM_WOOD', .false.)
      if (model%swelling > 0.0_wp) then
         call deck%comment('Swelling in T, which is y, at a temperature of 1.')
         call deck%line('*EXPANSION, TYPE=ORTHO')
         call deck%reals([0.0_wp, 0.0_wp, model%swelling])
         call deck%line('*INITIAL CONDITIONS, TYPE=TEMPERATURE')
         call deck%line('BEAM_NODES, 0.0')
         call deck%line('COLUMN_NODES, 0.0')
      end if
      call deck%section('COLUMN', 'COLUMN_WOOD', 'COLUMN_AXES')
      call deck%section('BEAM', 'BEAM_WOOD', 'BEAM_AXES')
   end subroutine write_parts

   !> Surfaces, interactions and pairs.
   pure subroutine write_contact(deck, model)
      type(writer_type), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      real(wp) :: top, bottom, side, half
      integer :: beam

      beam = size(model%column%elements, 2)
      half = 0.5_wp*model%settings%height
      top = half + model%sizes%gap_above
      bottom = -half - model%sizes%gap_below
      side = 0.5_wp*model%settings%width - model%sizes%side_overlap
      call deck%heading('contact')
      call deck%comment('Slave above and below is the mortise, as the beam is longer than it; at the '// &
         'sides the beam, as the mortise is higher. A node that passes the edge of its master has '// &
         'no contact.')
      call deck%surface('MORTISE_TOP', model%column, [-far, 0.0_wp, top], [far, side, top], 0)
      call deck%surface('MORTISE_BOTTOM', model%column, [-far, 0.0_wp, bottom], &
         [far, side, bottom], 0)
      call deck%surface('BEAM_TOP', model%beam, [-far, -far, half], [far, far, half], beam)
      call deck%surface('BEAM_BOTTOM', model%beam, [-far, -far, -half], [far, far, -half], beam)
      if (model%has_sides) then
         call deck%surface('MORTISE_SIDE', model%column, [-far, side, bottom], [far, side, top], 0)
         side = 0.5_wp*model%settings%width
         call deck%surface('BEAM_SIDE', model%beam, [-far, side, -far], [far, side, far], beam)
      end if
      call deck%surface('COLUMN_TOP', model%column, [-far, -far, 0.5_wp*model%sizes%column_height], &
         [far, far, far], 0)
      call write_interaction(deck, model%choice, model%faces)
      call write_pair(deck, model%faces, 'MORTISE_TOP', 'BEAM_TOP')
      call write_pair(deck, model%faces, 'MORTISE_BOTTOM', 'BEAM_BOTTOM')
      if (.not. model%has_sides) return
      call write_interaction(deck, model%choice, model%sides)
      call write_pair(deck, model%sides, 'BEAM_SIDE', 'MORTISE_SIDE')
   end subroutine write_contact

   !> Sets of nodes, supports and springs.
   pure subroutine write_supports(deck, model)
      type(writer_type), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      integer, allocatable :: column(:), beam(:)
      integer :: nodes, last
      real(wp) :: z, tip

      nodes = size(model%column%nodes, 2)
      last = size(model%column%elements, 2) + size(model%beam%elements, 2)
      z = 0.5_wp*model%sizes%column_height
      tip = tenon_face_arm(model%settings)
      call deck%heading('supports')
      call nodes_in_box(model%column, [-far, -far, -z], [far, far, -z], column)
      call deck%node_set('BOTTOM', column)
      call nodes_in_box(model%beam, [-far, 0.0_wp, -far], [far, 0.0_wp, far], beam)
      call nodes_in_box(model%column, [-far, 0.0_wp, -far], [far, 0.0_wp, far], column)
      column = pack(column, abs(model%column%nodes(3, column)) < z*(1.0_wp - 1.0e-9_wp))
      call deck%comment('Nodes of the foot and of the top are held in y besides.')
      call deck%node_set('SYMMETRY', [column, nodes + beam])
      call nodes_in_box(model%beam, [tip, -far, 0.0_wp], [tip, far, 0.0_wp], beam)
      call deck%node_set('TIP', nodes + beam)
      call deck%node_set('AXIAL', [nodes + node_near(model%beam, [0.0_wp, 0.0_wp, 0.0_wp])])
      call nodes_in_box(model%column, [-far, -far, z], [far, far, z], column)
      call deck%node_set('TOP', column)
      call deck%comment('The top of the column stays level: its nodes move in z as the first.')
      call deck%level(column, column(1), 3)
      call write_boundary(deck, 'BOTTOM', 1, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 2, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 3, 0.0_wp)
      call write_boundary(deck, 'TOP', 1, 0.0_wp)
      call write_boundary(deck, 'TOP', 2, 0.0_wp)
      call write_boundary(deck, 'SYMMETRY', 2, 0.0_wp)
      call write_boundary(deck, 'TIP', 3, 0.0_wp)
      if (model%settings%axial_rule == 'spring') then
         call deck%grounded_spring('AXIAL_SPRING', last + 1, &
            nodes + node_near(model%beam, [0.0_wp, 0.0_wp, 0.0_wp]), 1, &
            0.5_wp*model%settings%axial_stiffness)
      else
         call write_boundary(deck, 'AXIAL', 1, 0.0_wp)
      end if
      call deck%grounded_spring('HOLDING_SPRING', last + 2, nodes + node_near(model%beam, &
         [-model%settings%length - model%sizes%tail, 0.0_wp, 0.0_wp]), 3, holding_stiffness)
   end subroutine write_supports

   !> Load of the column and fit of the sides, then a step for each stroke.
   pure subroutine write_steps(deck, model)
      type(writer_type), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      type(step_type) :: step
      real(wp) :: area
      integer :: i

      area = 0.5_wp*model%settings%length*model%sizes%column_width
      call deck%heading('load of the column, '//to_text(model%settings%column_load, 6)// &
         ' N, half of it here; first contact of the sides')
      step%name = 'SEAT'
      call open_step(deck, model%choice, step)
      if (abs(model%settings%column_load) > 0.0_wp) then
         call deck%line('*DSLOAD')
         call deck%line('COLUMN_TOP, P, '//to_text(0.5_wp*model%settings%column_load/area, 12))
      end if
      call close_step(deck, model%choice, force_sets, gauges)
      if (model%swelling > 0.0_wp) then
         call deck%heading('the beam swells between the sides')
         step%name = 'FIT'
         step%first = 0.2_wp
         step%largest = 0.2_wp
         call open_step(deck, model%choice, step)
         call deck%line('*TEMPERATURE')
         call deck%line('BEAM_NODES, 1.0')
         call close_step(deck, model%choice, force_sets, gauges)
      end if
      do i = 2, size(model%turns)
         associate (from => model%turns(i - 1), to => model%turns(i))
            call deck%heading('stroke '//to_text(i - 1)//' of '//to_text(size(model%turns) - 1)// &
               ', from '//to_text(from, 6)//' to '//to_text(to, 6)//' mm')
            step%name = 'STROKE_'//to_text(i - 1)
            step%largest = 1.0_wp/model%increments
            if (max(abs(from), abs(to)) > wide) step%largest = 0.5_wp*step%largest
            step%first = step%largest
            call open_step(deck, model%choice, step)
            call write_boundary(deck, 'TIP', 3, to)
            call close_step(deck, model%choice, force_sets, gauges)
         end associate
      end do
   end subroutine write_steps

end module deck_tenon_text
