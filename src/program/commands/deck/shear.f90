!> `asperity deck shear`: the input deck of the shear test for ABAQUS and CalculiX.
module asperity_program_commands_deck_shear
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_options, only: deck_choice
   use asperity_deck_shear_deck, only: new_shear_deck, shear_deck
   use asperity_deck_shear_text, only: write_shear_deck
   use asperity_paper_shear_test, only: disc_height, disc_mesh_size
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_deck_parts, only: declare_deck, declare_law_table, fill_table, &
      usual_criterion
   use asperity_program_commands_faces_friction_keys, only: declare_friction
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_shear_keys, only: declare_shear
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_environment, only: command_text
   use asperity_replay_shear_settings, only: shear_settings
   use asperity_wood_properties, only: wood_properties
   implicit none
   private
   public :: shear_deck_command

   !> Increment unless given, mm
   real(wp), parameter :: usual_increment = 0.05_wp

   !> Writes the deck of the shear test.
   type, extends(command_type) :: shear_deck_command
      private
      type(faces_type) :: faces
      type(deck_choice) :: choice = deck_choice(mesh_size=disc_mesh_size)
      !> Specimen and path, and normal stresses, MPa, of which a deck takes one
      type(shear_settings) :: box = shear_settings(displacement_increment=usual_increment)
      real(wp), allocatable :: normal_stress(:)
      logical :: has_stress = .false.
      real(wp) :: height = disc_height
      !> Wood of both discs
      type(wood_properties) :: wood
      character(len=6) :: upper_grain = ''
      !> Path of the deck
      character(len=:), allocatable :: inp
      !> Checked properties of the faces
      type(contact_properties) :: properties
   contains
      procedure :: describe, declare, check, run
   end type shear_deck_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(shear_deck_command), intent(inout) :: self

      self%name = 'deck shear'
      self%summary = 'input deck of the shear test for ABAQUS or CalculiX'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Input deck of the direct shear test in three dimensions, for CalculiX or '// &
         'ABAQUS (Figs 15-18): two discs of wood with the rough law, a table of it, or hard '// &
         'contact.'
   end subroutine describe

   !> Faces, specimen, path and model.
   pure subroutine declare(self, keys)
      !> The command
      class(shear_deck_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%faces%declare(keys, has_friction=.true.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call self%faces%declare_rules(keys)
      call declare_friction(self%faces%friction, keys, has_time=.true., &
         pair_key=self%faces%pair_key)
      call self%faces%declare_accept(keys)
      call declare_shear(self%box, self%normal_stress, keys, self%has_stress)
      self%wood%criterion = usual_criterion
      call declare_wood(self%wood, keys, sections=self%faces%two%sections(), &
         ageing=self%faces%ageing)
      call declare_law_table(self%choice, self%faces, keys)
      call declare_deck(self%choice, keys)
      call keys%real('disc_height', self%height, 'mm', 'height of each disc')
      call keys%choice('upper_grain', self%upper_grain, 'normal along', &
         'grain of the upper disc; unless given, normal if face 1 is or may be transverse')
      call keys%text('inp', self%inp, 'write the deck; - is standard output', kind_file)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the faces.
   subroutine check(self, error)
      !> The command
      class(shear_deck_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      call self%faces%contact(self%properties, error)
   end subroutine check

   !> Make the deck. `error` is set when a setting is refused.
   subroutine run(self, report, error)
      !> The command
      class(shear_deck_command), intent(inout) :: self
      !> Tables and deck are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(shear_deck) :: model
      logical :: on_end

      if (size(self%normal_stress) > 1 .and. self%has_stress) then
         call fatal_error(error, 'normal_stress has '//to_text(size(self%normal_stress))// &
            ' values: a deck takes one', subject='normal_stress')
         return
      end if
      on_end = self%upper_grain == 'normal'
      if (self%upper_grain == '') on_end = self%faces%is_on_end()
      self%box%normal_stress = self%normal_stress(1)
      self%choice%command = command_text()
      call new_shear_deck(model, self%choice, self%box, self%height, on_end, &
         self%wood, self%properties, error)
      if (allocated(error)) return
      allocate (report%decks(1))
      report%decks(1)%option = 'inp'
      call write_shear_deck(model, report%decks(1)%text, error)
      if (allocated(error)) return
      call fill_table(report, ['lower disc', 'upper disc'], [model%lower, model%upper])
      call report%add_remark('normal stress '//to_text(self%box%normal_stress, 6)// &
         ' MPa; the meshes overlap by '//to_text(model%overclosure, 6)// &
         ' mm, where contact carries it')
   end subroutine run

end module asperity_program_commands_deck_shear
