!> `asperity table`: the law as rows of pressure and overclosure, for programs that interpolate.
module asperity_program_commands_table_command
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_law_rows, only: law_table, new_law_table, stick_slope
   use asperity_deck_law_rows_text, only: host_abaqus, host_calculix, table_interaction
   use asperity_deck_options, only: deck_choice
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_paper_wood, only: wood_strength_across
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_friction_keys, only: declare_friction
   use asperity_program_commands_faces_type, only: faces_type
   use asperity_program_commands_table_keys, only: declare_table
   use asperity_program_commands_table_plot, only: law_table_picture
   use asperity_program_input_key, only: kind_file
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_counts, column_validity, new_table
   implicit none
   private
   public :: table_command

   !> Tabulates the law.
   type, extends(command_type) :: table_command
      private
      type(faces_type) :: faces
      !> Pressures, relative error and number of rows
      type(deck_choice) :: limits
      real(wp) :: largest_pressure = wood_strength_across, stick_pressure = wood_strength_across
      !> Paths of the interactions
      character(len=:), allocatable :: abaqus, calculix
      !> Checked properties of the faces
      type(contact_properties) :: properties
   contains
      procedure :: describe, declare, check, run
   end type table_command

   !> Name of the interaction in decks
   character(len=*), parameter :: interaction = 'WOOD'
   character(len=8), parameter :: options(2) = [character(len=8) :: 'abaqus', 'calculix']

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(table_command), intent(inout) :: self

      self%name = 'table'
      self%summary = 'the law as a table for ABAQUS and CalculiX decks'
      self%usage = '[CASE.nml] [options]'
      self%purpose = 'The law as rows of pressure and overclosure, for programs that '// &
         'interpolate between them: *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR of ABAQUS '// &
         'and CalculiX, with friction.'
   end subroutine describe

   !> Faces and rows.
   pure subroutine declare(self, keys)
      !> The command
      class(table_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys
      integer :: largest

      call self%faces%declare(keys, has_friction=.true.)
      call self%faces%declare_separation(keys)
      call self%faces%declare_unloading(keys)
      call self%faces%heights%declare(keys)
      call declare_friction(self%faces%friction, keys, has_time=.true., &
         pair_key=self%faces%pair_key)
      call self%faces%declare_accept(keys)
      call keys%real('largest_pressure', self%largest_pressure, 'MPa', &
         'pressure up to which the tolerance holds')
      largest = keys%last
      call declare_table(self%limits, keys)
      self%stick_pressure = self%largest_pressure
      call keys%real('stick_pressure', self%stick_pressure, 'MPa', &
         'pressure of CalculiX'' stick slope; largest_pressure unless given')
      call keys%follows(largest)
      call self%declare_outputs(keys, has_picture=.true.)
      call keys%text('abaqus', self%abaqus, &
         'write the interaction for an ABAQUS deck; - is standard output', kind_file)
      call keys%text('calculix', self%calculix, &
         'write the interaction for a CalculiX deck; - is standard output', kind_file)
      call self%declare_requests(keys)
   end subroutine declare

   !> Check the faces.
   subroutine check(self, error)
      !> The command
      class(table_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      call self%faces%contact(self%properties, error)
   end subroutine check

   !> Make the table, and the decks asked for. `error` is set when a setting is refused or more rows
   !> were needed than allowed.
   subroutine run(self, report, error)
      !> The command
      class(table_command), intent(inout) :: self
      !> Tables and decks are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(law_table) :: table

      ! an argument that is not allocated is absent
      call new_law_table(table, self%properties, self%largest_pressure, error, &
         self%limits%tolerance, self%limits%rows, self%limits%smallest_pressure)
      if (.not. allocated(error)) call check_positive(error, 'stick_pressure', &
         self%stick_pressure, 'MPa')
      if (.not. allocated(error)) call make_decks(self, report, table, error)
      if (allocated(error)) return
      call fill_tables(self, report, table)
      if (report%is_drawn()) then
         report%picture_title = 'Law and table: '//self%faces%words()
         report%pictures = [law_table_picture(table, self%properties)]
      end if
      call report%table%check_finite(error)
   end subroutine run

   !> The interaction for each program that is asked for.
   pure subroutine make_decks(self, report, table, error)
      type(table_command), intent(in) :: self
      type(report_type), intent(inout) :: report
      type(law_table), intent(in) :: table
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (report%decks(size(options)))
      do i = 1, size(options)
         report%decks(i)%option = options(i)
         report%decks(i)%text = ''
      end do
      if (self%abaqus /= '') call table_interaction(report%decks(1)%text, table, &
         self%properties, host_abaqus, interaction, self%stick_pressure, error)
      if (self%calculix /= '' .and. .not. allocated(error)) &
         call table_interaction(report%decks(2)%text, table, self%properties, host_calculix, &
         interaction, self%stick_pressure, error)
   end subroutine make_decks

   !> The rows beside the law, and how good they are.
   pure subroutine fill_tables(self, report, table)
      type(table_command), intent(in) :: self
      type(report_type), intent(inout) :: report
      type(law_table), intent(in) :: table
      type(normal_response) :: law(size(table%pressure))
      real(wp) :: separation(size(table%pressure))
      integer :: n

      n = size(table%pressure)
      separation = self%properties%initial_separation - table%overclosure
      law = evaluate_normal_law(self%properties%normal, separation)
      ! past the largest pressure the last row follows no law
      law(n)%pressure = none
      law(n)%validity = law(n - 1)%validity
      report%table = new_table(columns=5, rows=n)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call report%table%add_numbers('pressure', 'MPa', (table%pressure))
      call report%table%add_numbers('overclosure', 'mm', (table%overclosure))
      call report%table%add_numbers('separation', 'mm', separation)
      call report%table%add_numbers('law_pressure', 'MPa', (law%pressure))
      call report%table%add_codes('validity', column_validity, (law%validity))
      report%first_rows = [1, n + 1]
      report%important = turning_points((table%overclosure))

      report%summary = new_table(columns=5, rows=1)
      call report%summary%add_codes('rows_used', column_counts, [n])
      call report%summary%add_numbers('from_pressure', 'MPa', [table%smallest_pressure])
      call report%summary%add_numbers('relative_error', '-', [table%error])
      call report%summary%add_numbers('error_below', 'MPa', [table%low_error])
      call report%summary%add_numbers('stick_slope', 'MPa/mm', &
         [stick_slope(self%properties, self%stick_pressure)])
      if (self%calculix /= '') call add_remark(report, self%properties)
   end subroutine fill_tables

   !> What CalculiX cannot do, in short; the deck says more.
   pure subroutine add_remark(report, properties)
      type(report_type), intent(inout) :: report
      type(contact_properties), intent(in) :: properties
      type(normal_response) :: at_rest

      at_rest = evaluate_normal_law(properties%normal, properties%initial_separation)
      allocate (report%remarks(1))
      report%remarks(1)%text = 'CalculiX: TYPE=NODE TO SURFACE only; faces meet and part with '// &
         'a jump of about '//to_text(at_rest%pressure, 3)//' MPa; constant stick slope. '// &
         'The deck says more.'
   end subroutine add_remark

end module asperity_program_commands_table_command
