!> `asperity deck tenon`: the input deck of the tenon joint for ABAQUS and CalculiX.
module asperity_program_commands_deck_tenon
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_options, only: deck_choice, for_calculix
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: default_mesh_size, tenon_sizes
   use asperity_deck_tenon_text, only: write_tenon_deck
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_deck_parts, only: declare_deck, declare_law_table, fill_table, &
      usual_criterion
   use asperity_program_commands_tenon_bearing_keys, only: declare_column
   use asperity_program_commands_tenon_history, only: follow_history, history_type, read_history
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_commands_deck_mesh_keys, only: declare_grading, declare_joint_sizes
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_environment, only: command_text
   implicit none
   private
   public :: tenon_deck_command

   !> Writes the deck of the tenon joint.
   type, extends(command_type) :: tenon_deck_command
      private
      type(tenon_case) :: case
      type(deck_choice) :: choice
      type(tenon_sizes) :: sizes
      !> Fewest increments of a stroke
      integer :: stroke_increments = 10
      !> Path of the deck
      character(len=:), allocatable :: inp
   contains
      procedure :: describe, declare, check, run
   end type tenon_deck_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(tenon_deck_command), intent(inout) :: self

      self%name = 'deck tenon'
      self%summary = 'input deck of the tenon joint for ABAQUS or CalculiX'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'Input deck of the straight tenon joint in three dimensions, for CalculiX '// &
         'or ABAQUS (Figs 20-35): joint and programme of the case of asperity tenon.'
   end subroutine describe

   !> Faces, joint, programme and model.
   pure subroutine declare(self, keys)
      !> The command
      class(tenon_deck_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys
      integer :: mesh_size, strength

      call self%case%declare_faces(keys)
      call declare_law_table(self%choice, self%case%faces, keys)
      call self%case%declare_sizes(keys)
      call self%case%declare_hold(keys, is_replay=.false.)
      call declare_column(self%case%joint, keys)
      self%case%joint%wood%criterion = usual_criterion
      call declare_wood(self%case%joint%wood, keys, sections=self%case%sections(), &
         ageing=self%case%faces%ageing)
      strength = keys%find('compression_strength_r')
      call self%case%declare_programme(keys)
      self%choice%mesh_size = default_mesh_size(self%case%joint)
      call declare_deck(self%choice, keys, mesh_size)
      ! the pressure of CalculiX' stick slope
      if (for_calculix(self%choice) .and. self%choice%contact /= 'uinter' &
         .and. .not. allocated(self%choice%stick_pressure)) keys%rows(strength)%unused = .false.
      keys%last = mesh_size
      call keys%follows(self%case%height_key, 'a tenth of height')
      call declare_grading(self%choice, keys)
      call declare_joint_sizes(self%sizes, self%case, keys)
      call keys%whole('stroke_increments', self%stroke_increments, &
         'fewest increments of a stroke; twice as many beyond 16 mm')
      call self%case%declare_reading(keys)
      call keys%text('inp', self%inp, 'write the deck; - is standard output', kind_file)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the case.
   subroutine check(self, error)
      !> The command
      class(tenon_deck_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      call self%case%check(error, compiled=.false.)
   end subroutine check

   !> Make the deck. `error` is set when a setting is refused.
   subroutine run(self, report, error)
      !> The command
      class(tenon_deck_command), intent(inout) :: self
      !> Tables and deck are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(history_type) :: history
      type(tenon_deck) :: model

      call read_history(history, self%case, error)
      if (.not. allocated(error)) call follow_history(self%case%joint, history, error)
      if (allocated(error)) return
      call self%declare(report%keys)
      self%choice%command = command_text()
      call new_tenon_deck(model, self%choice, self%case%joint, self%sizes, self%stroke_increments, &
         self%case%properties, self%case%sides, error)
      if (allocated(error)) return
      allocate (report%decks(1))
      report%decks(1)%option = 'inp'
      call write_tenon_deck(model, report%decks(1)%text, error)
      if (allocated(error)) return
      call fill_table(report, ['column', 'beam  '], [model%column, model%beam])
      call report%add_remark('half model: forces are half of those of the joint')
      call report%add_remark(trim(merge('2 steps of load and fit', '1 step of load         ', &
         model%swelling > 0.0_wp))//', then '//to_text(size(model%turns) - 1)//' strokes')
      call report%add_remark('the meshes are '//to_text(model%sizes%gap_above, 6)// &
         ' mm apart above and '//to_text(model%sizes%gap_below, 6)//' mm below the beam')
      if (model%has_sides) call report%add_remark('interference at each side '// &
         to_text(model%sizes%side_interference, 6)//' mm')
   end subroutine run

end module asperity_program_commands_deck_tenon
