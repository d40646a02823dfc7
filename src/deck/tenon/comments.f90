!> The first lines of the tenon joint's deck: what the model is, and what of it is chosen.
module asperity_deck_tenon_comments
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_banner, only: write_head
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_tenon_deck, only: tenon_deck
   use asperity_deck_tenon_sets, only: holding_stiffness
   use asperity_replay_tenon_settings, only: tenon_face_arm
   implicit none
   private
   public :: write_words

contains

   !> What the model is, and what of it is chosen.
   pure subroutine write_words(deck, model)
      !> The deck
      class(writer_type), intent(inout) :: deck
      !> The model
      type(tenon_deck), intent(in) :: model

      call write_head(deck, model%choice, 'Straight tenon joint under cyclic load')
      associate (s => model%settings, sizes => model%sizes)
         call deck%comment('HALF MODEL: one side of the plane through the middle of the beam, '// &
            'y = 0. Forces and moments of the joint are twice those of this deck. x runs along '// &
            'the beam, 0 at the column face; z up, 0 at the middle of the beam.')
         call deck%comment('Load: set TIP, '//to_text(tenon_face_arm(s), 6)//' mm from the '// &
            'column face, moves in z; each step is one stroke between two turning points and '// &
            'takes one unit of time. The sum of the forces of TIP is the (half) force.')
         call deck%comment('Chosen, as the paper''s text does not say it, besides what the '// &
            'case marks so:')
         call deck%comment('- Column '//to_text(sizes%column_height, 6)//' mm high and '// &
            to_text(sizes%column_width, 6)//' mm wide; foot held, top free in z only and level '// &
            '(*EQUATION); beam '//to_text(sizes%tail, 4)//' mm longer than the column is deep.')
         call deck%comment('- Grain: of the column along z, R along y; of the beam along x, R '// &
            'along z. Table 1 has one modulus for R and T.')
         call deck%comment('- Gap: the meshes are '//to_text(sizes%gap_above, 6)//' mm apart '// &
            'above and '//to_text(sizes%gap_below, 6)//' mm below the beam; negative is an '// &
            'overlap. '//gap_words(model))
         if (allocated(model%choice%rim_mesh_size)) call deck%comment('- Elements: edges of '// &
            to_text(model%choice%rim_mesh_size, 4)//' mm at the rims of mortise and tenon, '// &
            'each '//to_text(model%choice%mesh_growth, 4)//' times its neighbour up to '// &
            to_text(model%choice%mesh_size, 4)//' mm, along x and z; even across the beam, as '// &
            'the joint turns in the plane of x and z.')
         if (model%has_sides) then
            call deck%comment('- Sides: an interference of '//to_text(sizes%side_interference, 6) &
               //' mm for about '//to_text(s%side_pressure, 4)//' MPa: the overclosure of '// &
               'contact at that pressure, by which the meshes overlap ('// &
               to_text(sizes%side_overlap, 6)//' mm), and what the wood gives way under it '// &
               '(half the beam squeezed, the cheek of the column bent and sheared), by which '// &
               'the beam swells in a step of its '// &
               'own, as solvers do not find the way out of a large overlap. An estimate of the '// &
               'mean; what pressure comes of it is in the results.')
         else
            call deck%comment('- Sides: no pressure, no contact.')
         end if
         if (s%axial_rule == 'spring') then
            call deck%comment('- Axial hold: a spring of half of '// &
               to_text(s%axial_stiffness, 6)//' N/mm to ground, at the node nearest to the '// &
               'middle of the tenon at the column face.')
         else
            call deck%comment('- Axial hold: the node nearest to the middle of the tenon at '// &
               'the column face is held in x.')
         end if
         call deck%comment('- A spring of '//to_text(holding_stiffness, 3)//' N/mm in z at the '// &
            'end of the tenon holds the joint while it is open.')
         call deck%comment('For interface/calculix/run:')
         call deck%line('** half model')
         call deck%line('** load: set TIP, direction 3')
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

end module asperity_deck_tenon_comments
