!> The text of the tenon joint's deck.
module asperity_deck_tenon_text
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_interaction, only: write_interaction, write_pair
   use asperity_deck_cards_load_steps, only: close_step, open_step, step_type, write_boundary
   use asperity_deck_cards_mesh_writer, only: model_writer
   use asperity_deck_cards_wood_cards, only: check_criterion, write_axes, write_wood
   use asperity_deck_options, only: element_kind, for_calculix
   use asperity_deck_tenon_comments, only: write_words
   use asperity_deck_tenon_deck, only: tenon_deck, touching_displacement
   use asperity_deck_tenon_sets, only: face_bottom, face_side, face_top, holding_stiffness
   implicit none
   private
   public :: write_tenon_deck

   !> Displacement beyond which strokes have twice the increments, mm
   real(wp), parameter :: wide = 16.0_wp
   character(len=*), parameter :: force_sets(5) = [character(len=8) :: 'TIP', 'BOTTOM', 'TOP', &
      'SYMMETRY', 'AXIAL']
   character(len=*), parameter :: gauges(2) = [character(len=8) :: 'TIP', 'AXIAL']

contains

   !> The text of the deck.
   pure subroutine write_tenon_deck(model, text, error)
      !> The model
      type(tenon_deck), intent(in) :: model
      !> The deck
      character(len=:), allocatable, intent(out) :: text
      !> Set when the solver has no card for the wood, or when there is not enough memory
      type(error_type), allocatable, intent(out) :: error
      type(model_writer) :: deck

      call check_criterion(model%choice, model%settings%wood, error)
      if (allocated(error)) return
      call write_words(deck, model)
      call write_parts(deck, model)
      call write_contact(deck, model)
      call write_supports(deck, model)
      call write_steps(deck, model)
      call deck%take(text, error)
   end subroutine write_tenon_deck

   !> Meshes and wood.
   pure subroutine write_parts(deck, model)
      type(model_writer), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      real(wp), parameter :: x(3) = [1.0_wp, 0.0_wp, 0.0_wp], y(3) = [0.0_wp, 1.0_wp, 0.0_wp], &
         z(3) = [0.0_wp, 0.0_wp, 1.0_wp]

      call deck%heading('meshes')
      call deck%nodes(model%column, 0, 'COLUMN_NODES')
      call deck%elements(model%column, 0, 0, element_kind(model%choice), 'COLUMN')
      call deck%nodes(model%beam, size(model%column%nodes, 2), 'BEAM_NODES')
      call deck%elements(model%beam, size(model%column%elements, 2), &
         size(model%column%nodes, 2), element_kind(model%choice), 'BEAM')
      call deck%heading('wood; 1 = L, 2 = R, 3 = T')
      call write_axes(deck, 'COLUMN_AXES', z, y)
      call write_axes(deck, 'BEAM_AXES', x, z)
      call write_wood(deck, model%choice, model%settings%wood, 'COLUMN_WOOD', .true.)
      call write_wood(deck, model%choice, model%settings%wood, 'BEAM_WOOD', .false.)
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
      type(model_writer), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model

      call deck%heading('contact')
      call deck%comment('The mortise is slave, the beam, which is longer, master. A node that '// &
         'passes the edge of its master has no contact. Slaves begin '// &
         to_text(model%sizes%edge_relief, 4)//' mm from the back of the mortise, and at the '// &
         'sides from its top and bottom (chosen): nearer, nodes would find and lose '// &
         'the edge of the beam in turn.')
      associate (mortise => model%sets%mortise, tenon => model%sets%tenon)
         call deck%surface('MORTISE_TOP', mortise(face_top)%faces)
         call deck%surface('MORTISE_BOTTOM', mortise(face_bottom)%faces)
         call deck%surface('BEAM_TOP', tenon(face_top)%faces)
         call deck%surface('BEAM_BOTTOM', tenon(face_bottom)%faces)
         if (model%has_sides) then
            call deck%surface('MORTISE_SIDE', mortise(face_side)%faces)
            call deck%surface('BEAM_SIDE', tenon(face_side)%faces)
         end if
      end associate
      call deck%surface('COLUMN_TOP', model%sets%loaded%faces)
      call write_interaction(deck, model%choice, model%faces)
      call write_pair(deck, model%faces, 'MORTISE_TOP', 'BEAM_TOP')
      call write_pair(deck, model%faces, 'MORTISE_BOTTOM', 'BEAM_BOTTOM')
      if (.not. model%has_sides) return
      call write_interaction(deck, model%choice, model%sides)
      call write_pair(deck, model%sides, 'MORTISE_SIDE', 'BEAM_SIDE')
   end subroutine write_contact

   !> Sets of nodes, supports and springs.
   pure subroutine write_supports(deck, model)
      type(model_writer), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      integer :: last

      last = size(model%column%elements, 2) + size(model%beam%elements, 2)
      call deck%heading('supports')
      associate (sets => model%sets)
         call deck%node_set('BOTTOM', sets%foot)
         call deck%comment('Nodes of the foot and of the top are held in y besides.')
         call deck%node_set('SYMMETRY', sets%middle)
         call deck%node_set('TIP', sets%tip)
         call deck%node_set('AXIAL', [sets%axial_node])
         call deck%node_set('TOP', sets%head)
         call deck%comment('The top of the column stays level: its nodes move in z as the first.')
         call deck%level(sets%head, sets%head(1), 3)
      end associate
      call write_boundary(deck, 'BOTTOM', 1, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 2, 0.0_wp)
      call write_boundary(deck, 'BOTTOM', 3, 0.0_wp)
      call write_boundary(deck, 'TOP', 1, 0.0_wp)
      call write_boundary(deck, 'TOP', 2, 0.0_wp)
      call write_boundary(deck, 'SYMMETRY', 2, 0.0_wp)
      call write_boundary(deck, 'TIP', 3, 0.0_wp)
      if (model%settings%axial_rule == 'spring') then
         call deck%grounded_spring('AXIAL_SPRING', last + 1, model%sets%axial_node, 1, &
            0.5_wp*model%settings%axial_stiffness)
      else
         call write_boundary(deck, 'AXIAL', 1, 0.0_wp)
      end if
      call deck%grounded_spring('HOLDING_SPRING', last + 2, model%sets%hold_node, 3, &
         holding_stiffness)
   end subroutine write_supports

   !> Load of the column and fit of the sides, then a step for each stroke.
   pure subroutine write_steps(deck, model)
      type(model_writer), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      type(step_type) :: step
      real(wp) :: area
      logical :: yields
      integer :: i

      yields = model%settings%wood%criterion /= 'none'
      area = 0.5_wp*model%settings%length*model%sizes%column_width
      call deck%heading('load of the column, '//to_text(model%settings%column_load, 6)// &
         ' N, half of it here; first contact of the sides')
      step%name = 'SEAT'
      call open_step(deck, model%choice, step)
      call write_vanishing(deck, model, 0.0_wp)
      if (abs(model%settings%column_load) > 0.0_wp) then
         call deck%line('*DSLOAD')
         call deck%line('COLUMN_TOP, P, '//to_text(0.5_wp*model%settings%column_load/area, 12))
      end if
      call close_step(deck, model%choice, yields, force_sets, gauges)
      if (model%swelling > 0.0_wp) then
         call deck%heading('the beam swells between the sides')
         step%name = 'FIT'
         step%first = 0.2_wp
         step%largest = 0.2_wp
         call open_step(deck, model%choice, step)
         call deck%line('*TEMPERATURE')
         call deck%line('BEAM_NODES, 1.0')
         call close_step(deck, model%choice, yields, force_sets, gauges)
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
            call write_vanishing(deck, model, max(abs(from), abs(to)))
            call write_boundary(deck, 'TIP', 3, to)
            call close_step(deck, model%choice, yields, force_sets, gauges)
         end associate
      end do
   end subroutine write_steps

   !> Say that an open joint may have no contact: without sides, as the tenon passes its clearance.
   pure subroutine write_vanishing(deck, model, reach)
      class(model_writer), intent(inout) :: deck
      type(tenon_deck), intent(in) :: model
      !> Largest displacement of the stroke, mm
      real(wp), intent(in) :: reach

      if (model%has_sides) return
      if (reach > 2.0_wp*touching_displacement(model)) then
         call deck%line('** springs may vanish within a step')
      else
         call deck%line('** springs may vanish')
      end if
   end subroutine write_vanishing

end module asperity_deck_tenon_text
