!> Deck of the straight tenon joint: sizes and programme as in the replay (src/replay/tenon), in
!> three dimensions.
module asperity_deck_tenon_deck
   use asperity_base_checks, only: check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_cards_interaction, only: interaction_type, new_interaction, overclosure_for
   use asperity_deck_check_wood, only: check_wood
   use asperity_deck_mesh_cheek_interference, only: side_interference
   use asperity_deck_mesh_hexahedra, only: check_mesh_room, hex_mesh
   use asperity_deck_options, only: check_deck_choice, deck_choice, for_calculix
   use asperity_deck_tenon_column, only: new_column
   use asperity_deck_tenon_parts, only: check_tenon_sizes, new_beam, tenon_elements, tenon_sizes
   use asperity_deck_tenon_sets, only: new_tenon_sets, tenon_sets
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_load_path, only: tenon_programme
   use asperity_replay_tenon_settings, only: tenon_face_arm, tenon_settings
   implicit none
   private
   public :: tenon_deck, new_tenon_deck, touching_displacement

   !> The model, ready to be written.
   type :: tenon_deck
      !> Choices of the deck, the joint, and what a plane joint has not
      type(deck_choice) :: choice
      type(tenon_settings) :: settings
      type(tenon_sizes) :: sizes
      !> Fewest increments of a stroke; twice as many beyond 16 mm
      integer :: increments = 10
      !> Contact of upper and lower face, and of the sides
      type(interaction_type) :: faces, sides
      !> Whether the sides touch, and the strain by which the beam swells between them
      logical :: has_sides = .true.
      real(wp) :: swelling = 0.0_wp
      !> Column and beam, and sets of their nodes and faces
      type(hex_mesh) :: column, beam
      type(tenon_sets) :: sets
      !> Displacements of the load point between which the strokes lie, mm, from 0
      real(wp), allocatable :: turns(:)
   end type tenon_deck

   !> Overlap of the meshes at sides without contact, mm
   real(wp), parameter :: no_sides_overlap = 0.1_wp
   !> Most increments asked for
   integer, parameter :: most_increments = 10000

contains

   !> Prepare the model. `sizes` is from `default_tenon_sizes` or better, with the side interference
   !> when it is given (above zero). `error` is set when a value is refused.
   pure subroutine new_tenon_deck(deck, choice, settings, sizes, increments, faces, sides, error)
      !> Result
      type(tenon_deck), intent(out) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Settings of the joint
      type(tenon_settings), intent(in) :: settings
      !> What a plane joint has not
      type(tenon_sizes), intent(in) :: sizes
      !> Fewest increments of a stroke
      integer, intent(in) :: increments
      !> Contact of upper and lower face, and of the sides
      type(contact_properties), intent(in) :: faces, sides
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      deck%choice = choice
      deck%settings = settings
      deck%sizes = sizes
      deck%increments = increments
      deck%has_sides = settings%side_pressure > 0.0_wp
      call check_deck_choice(choice, settings%accept_sizes, error)
      if (.not. allocated(error)) call check_tenon_settings(settings, error)
      if (.not. allocated(error)) call check_joint(settings, error)
      if (.not. allocated(error)) call check_range(error, 'stroke_increments', &
         real(increments, wp), 1.0_wp, real(most_increments, wp), '')
      if (allocated(error)) return

      associate (s => settings)
         call check_wood(s%wood, s%accept_sizes, error)
         if (.not. allocated(error)) call new_interaction(deck%faces, choice, 'FACES', faces, &
            s%wood%compression_strengths(2), error)
         if (.not. allocated(error) .and. deck%has_sides) &
            call new_interaction(deck%sides, choice, 'SIDES', sides, s%side_pressure, error)
      end associate
      if (.not. allocated(error)) call check_tenon_sizes(choice, settings, deck%sizes, error)
      if (.not. allocated(error)) call place_faces(deck, error)
      if (.not. allocated(error)) &
         call check_mesh_room(error, tenon_elements(choice, settings, deck%sizes))
      if (allocated(error)) return
      call new_column(deck%column, choice, settings, deck%sizes)
      call new_beam(deck%beam, choice, settings, deck%sizes)
      call new_tenon_sets(deck%sets, settings, deck%sizes, deck%has_sides, deck%column, deck%beam)
      call find_turns(deck)
   end subroutine new_tenon_deck

   !> Refuse what three dimensions do not have.
   pure subroutine check_joint(settings, error)
      type(tenon_settings), intent(in) :: settings
      type(error_type), allocatable, intent(out) :: error

      if (settings%shoulders) then
         call fatal_error(error, 'shoulders = true is not in the deck: its beam has one '// &
            'section throughout', subject='shoulders')
      else if (settings%axial_rule /= 'spring' .and. settings%axial_rule /= 'fixed') then
         call fatal_error(error, 'axial_rule = '//trim(settings%axial_rule)//' leaves the beam '// &
            'without axial hold: in three dimensions it then loses all contact while it passes '// &
            'zero; take spring or fixed', subject='axial_rule')
      else if (settings%column == 'rigid') then
         call fatal_error(error, 'column = rigid is not in the deck, whose column is of wood', &
            subject='column')
      end if
   end subroutine check_joint

   !> Clearances of the meshes, and the interference at the sides.
   pure subroutine place_faces(deck, error)
      type(tenon_deck), intent(inout) :: deck
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: first_touch, overclosure

      associate (s => deck%settings, sizes => deck%sizes)
         first_touch = 0.0_wp
         if (s%gap == 'mean_plane' .and. deck%choice%contact /= 'hard') &
            first_touch = deck%faces%properties%initial_separation
         sizes%gap_above = s%clearance_above - first_touch
         sizes%gap_below = s%clearance_below - first_touch
         if (.not. deck%has_sides) then
            ! where nothing touches, so that the edges of the mortise stay above the beam
            sizes%side_overlap = no_sides_overlap
            return
         end if
         call overclosure_for(deck%sides, deck%choice, 'side_pressure', s%side_pressure, &
            overclosure, error)
         if (allocated(error)) return
         ! a datum far out in the law can make the overclosure negative
         overclosure = max(overclosure, 0.0_wp)
         if (.not. sizes%side_interference > 0.0_wp) sizes%side_interference = &
            side_interference(s%side_pressure, overclosure, s%wood, s%width, s%height, &
            sizes%column_width)
         sizes%side_overlap = min(overclosure, sizes%side_interference)
         deck%swelling = (sizes%side_interference - sizes%side_overlap)/(0.5_wp*s%width)
      end associate
   end subroutine place_faces

   !> Displacement of the load point, mm, at which a rigid tenon, turned about its middle, touches
   !> the upper and the lower face; wood gives way besides.
   pure real(wp) function touching_displacement(deck)
      !> The model
      type(tenon_deck), intent(in) :: deck

      associate (s => deck%settings, sizes => deck%sizes)
         touching_displacement = max(sizes%gap_above, sizes%gap_below) &
            *(2.0_wp*tenon_face_arm(s)/s%length + 1.0_wp)
      end associate
   end function touching_displacement

   !> Where the load point turns.
   pure subroutine find_turns(deck)
      type(tenon_deck), intent(inout) :: deck
      real(wp), allocatable :: path(:)
      integer, allocatable :: cycle_of(:)
      integer :: i, n

      call tenon_programme(deck%settings, path, cycle_of)
      n = ubound(path, 1)
      deck%turns = [0.0_wp]
      do i = 1, n
         if (i < n) then
            if ((path(i) - path(i - 1))*(path(i + 1) - path(i)) > 0.0_wp) cycle
         end if
         ! rest
         if (.not. abs(path(i) - deck%turns(size(deck%turns))) > 0.0_wp) cycle
         deck%turns = [deck%turns, path(i)]
      end do
   end subroutine find_turns

end module asperity_deck_tenon_deck
