!> `asperity table`: the law as rows of pressure and overclosure, for programs that interpolate.
module asperity_program_commands_table
   use asperity_base_checks, only: check_positive
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_deck_law_rows, only: law_table, new_law_table, stick_slope
   use asperity_deck_law_rows_text, only: host_abaqus, host_calculix, table_interaction
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_program_commands_config, only: config_type
   use asperity_program_commands_table_plot, only: law_table_picture
   use asperity_program_input_presets, only: faces_text
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_counts, column_validity, new_table
   implicit none
   private
   public :: report_law_table

   !> Name of the interaction in decks
   character(len=*), parameter :: interaction = 'WOOD'
   character(len=8), parameter :: options(2) = [character(len=8) :: 'abaqus', 'calculix']
   integer, parameter :: hosts(2) = [host_abaqus, host_calculix]

contains

   !> Make the table, and the decks asked for. `error` is set when a setting is refused or more rows
   !> were needed than allowed.
   pure subroutine report_law_table(config, report, error)
      !> Properties
      type(config_type), intent(in) :: config
      !> With its settings; tables and decks are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(law_table) :: table

      associate (s => report%settings)
         if (s%given('smallest_pressure')) then
            call new_law_table(table, config%properties, s%real_of('largest_pressure'), error, &
               s%real_of('tolerance'), s%whole_of('rows'), s%real_of('smallest_pressure'))
         else
            call new_law_table(table, config%properties, s%real_of('largest_pressure'), error, &
               s%real_of('tolerance'), s%whole_of('rows'))
         end if
         if (.not. allocated(error)) call check_positive(error, 'stick_pressure', &
            s%real_of('stick_pressure'), 'MPa')
      end associate
      if (.not. allocated(error)) call make_decks(report, table, config%properties, error)
      if (allocated(error)) return
      call fill_tables(report, table, config%properties)
      if (report%is_drawn()) then
         report%picture_title = 'Law and table: '//faces_text(report%settings)
         report%pictures = [law_table_picture(table, config%properties)]
      end if
      call report%table%check_finite(error)
   end subroutine report_law_table

   !> The interaction for each program that is asked for.
   pure subroutine make_decks(report, table, properties, error)
      type(report_type), intent(inout) :: report
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      allocate (report%decks(size(options)))
      do i = 1, size(options)
         report%decks(i)%option = options(i)
         report%decks(i)%text = ''
         if (.not. report%settings%given(trim(options(i)))) cycle
         call table_interaction(report%decks(i)%text, table, properties, hosts(i), interaction, &
            report%settings%real_of('stick_pressure'), error)
         if (allocated(error)) return
      end do
   end subroutine make_decks

   !> The rows beside the law, and how good they are.
   pure subroutine fill_tables(report, table, properties)
      type(report_type), intent(inout) :: report
      type(law_table), intent(in) :: table
      type(contact_properties), intent(in) :: properties
      type(normal_response) :: law(size(table%pressure))
      real(wp) :: separation(size(table%pressure))
      integer :: n

      n = size(table%pressure)
      separation = properties%initial_separation - table%overclosure
      law = evaluate_normal_law(properties%normal, separation)
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
         [stick_slope(properties, report%settings%real_of('stick_pressure'))])
      if (report%settings%given('calculix')) call add_remark(report, properties)
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

end module asperity_program_commands_table
