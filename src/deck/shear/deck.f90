!> Deck of the direct shear test: two discs, one upon the other; the lower one moves, the upper one
!> is loaded by a cap that cannot tilt.
module asperity_deck_shear_deck
   use asperity_base_checks, only: check_positive
   use asperity_base_constants, only: pi
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_cards_interaction, only: interaction_type, new_interaction, overclosure_for
   use asperity_deck_check_wood, only: check_wood
   use asperity_deck_mesh_disc, only: new_disc_mesh
   use asperity_deck_mesh_hexahedra, only: check_mesh_room, hex_mesh
   use asperity_deck_options, only: check_deck_choice, check_mesh_size, deck_choice, for_calculix
   use asperity_replay_shear_settings, only: check_shear_settings, shear_settings
   use asperity_replay_sizes, only: check_size
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: shear_deck, new_shear_deck

   !> The model, ready to be written.
   type :: shear_deck
      !> Choices of the deck, specimen and path
      type(deck_choice) :: choice
      type(shear_settings) :: settings
      !> Whether the grain of the upper disc is normal to the faces in contact
      logical :: upper_on_end = .true.
      !> Wood and contact
      type(wood_properties) :: wood
      type(interaction_type) :: contact
      !> Overclosure of the faces as they are meshed, mm
      real(wp) :: overclosure = 0.0_wp
      !> The discs
      type(hex_mesh) :: lower, upper
   end type shear_deck

contains

   !> Prepare the model. `error` is set when a value is refused.
   pure subroutine new_shear_deck(deck, choice, settings, disc_height, upper_on_end, wood, &
         properties, error)
      !> Result
      type(shear_deck), intent(out) :: deck
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Specimen, normal stress, path
      type(shear_settings), intent(in) :: settings
      !> Height of each disc, mm
      real(wp), intent(in) :: disc_height
      !> Whether the grain of the upper disc is normal to the faces in contact
      logical, intent(in) :: upper_on_end
      !> Wood of both discs
      type(wood_properties), intent(in) :: wood
      !> Contact of the faces
      type(contact_properties), intent(in) :: properties
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      deck%choice = choice
      deck%settings = settings
      deck%upper_on_end = upper_on_end
      deck%wood = wood
      call check_deck_choice(choice, settings%accept_sizes, error)
      if (.not. allocated(error)) call check_shear_settings(settings, settings%displacement, error)
      if (.not. allocated(error)) call check_positive(error, 'disc_height', disc_height, 'mm')
      call check_size(error, 'disc_height', disc_height, settings%accept_sizes)
      call check_mesh_size(error, choice, 'disc_height', disc_height)
      call check_mesh_size(error, choice, 'diameter', settings%diameter)
      if (.not. allocated(error)) call check_wood(wood, settings%accept_sizes, error)
      if (.not. allocated(error)) call new_interaction(deck%contact, choice, 'WOOD', properties, &
         settings%normal_stress, error)
      if (.not. allocated(error)) call overclosure_for(deck%contact, choice, &
         'normal_stress', settings%normal_stress, deck%overclosure, error)
      if (allocated(error)) return
      if (for_calculix(choice) .and. choice%contact == 'table' .and. deck%overclosure < 0.0_wp) &
         then
         call fatal_error(error, 'initial_separation = '// &
            to_text(properties%initial_separation)//' mm leaves the meshes apart by '// &
            to_text(-deck%overclosure, 3)//' mm under the normal stress, where CalculiX makes '// &
            'no springs for a table; raise it', subject='initial_separation')
         return
      end if
      call check_mesh_room(error, 0.5_wp*pi*settings%diameter**2*disc_height &
         /choice%mesh_size/choice%mesh_size/choice%mesh_size)
      if (allocated(error)) return
      call new_disc_mesh(deck%lower, settings%diameter, -disc_height, 0.0_wp, choice%mesh_size)
      call new_disc_mesh(deck%upper, settings%diameter, -deck%overclosure, &
         disc_height - deck%overclosure, choice%mesh_size)
   end subroutine new_shear_deck

end module asperity_deck_shear_deck
