!> `asperity deck`: input decks of the shear test and of the tenon joint for ABAQUS and CalculiX.
module asperity_program_commands_deck
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_mesh_hexahedra, only: hex_mesh, mesh_volume
   use asperity_deck_options, only: deck_choice
   use asperity_deck_shear_deck, only: new_shear_deck, shear_deck
   use asperity_deck_shear_text, only: write_shear_deck
   use asperity_deck_tenon_deck, only: new_tenon_deck, tenon_deck
   use asperity_deck_tenon_parts, only: tenon_sizes
   use asperity_deck_tenon_text, only: write_tenon_deck
   use asperity_program_commands_config, only: config_type
   use asperity_program_input_settings, only: settings_type
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, new_table
   use asperity_program_system_strings, only: string_type
   use asperity_replay_shear_settings, only: shear_settings
   implicit none
   private
   public :: report_shear_deck, report_tenon_deck

contains

   !> The deck of the shear test. `error` is set when a setting is refused.
   subroutine report_shear_deck(config, report, error)
      !> Faces, specimen, path
      type(config_type), intent(in) :: config
      !> With its settings; tables and deck are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(shear_deck) :: model
      type(shear_settings) :: settings
      type(deck_choice) :: choice
      logical :: on_end

      associate (s => report%settings)
         if (size(config%normal_stress) > 1 .and. s%given('normal_stress')) then
            call fatal_error(error, 'normal_stress has '//to_text(size(config%normal_stress))// &
               ' values: a deck takes one')
            return
         end if
         on_end = s%text_of('upper_grain') == 'normal'
         if (s%text_of('upper_grain') == '') on_end = s%text_of('pair') /= 'tangential-tangential'
         settings = config%shear
         settings%normal_stress = config%normal_stress(1)
         choice = choice_of(s)
         call new_shear_deck(model, choice, settings, s%real_of('disc_height'), on_end, &
            config%properties, error)
      end associate
      if (allocated(error)) return
      allocate (report%decks(1))
      report%decks(1)%option = 'inp'
      call write_shear_deck(model, report%decks(1)%text, error)
      if (allocated(error)) return
      call fill_table(report, ['lower disc', 'upper disc'], [model%lower, model%upper])
      call remark(report, 'normal stress '//to_text(settings%normal_stress, 6)// &
         ' MPa; the meshes overlap by '//to_text(model%overclosure, 6)// &
         ' mm, where contact carries it')
   end subroutine report_shear_deck

   !> The deck of the tenon joint. `error` is set when a setting is refused.
   subroutine report_tenon_deck(config, report, error)
      !> Faces, joint and programme
      type(config_type), intent(in) :: config
      !> With its settings; tables and deck are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(tenon_deck) :: model
      type(tenon_sizes) :: sizes
      type(deck_choice) :: choice

      associate (s => report%settings)
         sizes%column_height = s%real_of('column_height')
         sizes%column_width = s%real_of('column_width')
         sizes%tail = s%real_of('tail')
         sizes%edge_relief = s%real_of('edge_relief')
         if (s%given('side_interference')) sizes%side_interference = s%real_of('side_interference')
         choice = choice_of(s)
         call new_tenon_deck(model, choice, config%tenon, sizes, s%whole_of('stroke_increments'), &
            config%properties, config%sides, error)
      end associate
      if (allocated(error)) return
      allocate (report%decks(1))
      report%decks(1)%option = 'inp'
      call write_tenon_deck(model, report%decks(1)%text, error)
      if (allocated(error)) return
      call fill_table(report, ['column', 'beam  '], [model%column, model%beam])
      call remark(report, 'half model: forces are half of those of the joint')
      call remark(report, trim(merge('2 steps of load and fit', '1 step of load         ', &
         model%swelling > 0.0_wp))//', then '//to_text(size(model%turns) - 1)//' strokes')
      call remark(report, 'the meshes are '//to_text(model%sizes%gap_above, 6)// &
         ' mm apart above and '//to_text(model%sizes%gap_below, 6)//' mm below the beam')
      if (model%has_sides) call remark(report, 'interference at each side '// &
         to_text(model%sizes%side_interference, 6)//' mm')
   end subroutine report_tenon_deck

   !> What both decks are told.
   function choice_of(settings) result(choice)
      type(settings_type), intent(in) :: settings
      type(deck_choice) :: choice

      associate (s => settings)
         choice%solver = s%text_of('solver')
         choice%contact = s%text_of('contact')
         choice%element = s%text_of('element')
         choice%plasticity = s%text_of('plasticity')
         choice%field = s%text_of('field')
         choice%mesh_size = s%real_of('mesh_size')
         choice%penalty = s%real_of('penalty')
         choice%search_distance = s%real_of('search_distance')
         choice%tolerance = s%real_of('tolerance')
         choice%rows = s%whole_of('rows')
         if (s%given('largest_pressure')) choice%largest_pressure = s%real_of('largest_pressure')
         if (s%given('smallest_pressure')) choice%smallest_pressure = s%real_of('smallest_pressure')
         if (s%given('stick_pressure')) choice%stick_pressure = s%real_of('stick_pressure')
      end associate
      choice%command = command_text()
   end function choice_of

   !> The command as it was given.
   function command_text() result(text)
      character(len=:), allocatable :: text
      character(len=:), allocatable :: argument
      integer :: i, length

      text = 'asperity'
      do i = 1, command_argument_count()
         call get_command_argument(i, length=length)
         argument = repeat(' ', length)
         if (length > 0) call get_command_argument(i, argument)
         if (scan(argument, ' *?$') > 0 .or. length == 0) argument = "'"//argument//"'"
         text = text//' '//argument
      end do
   end function command_text

   !> One row for each part.
   pure subroutine fill_table(report, names, parts)
      type(report_type), intent(inout) :: report
      character(len=*), intent(in) :: names(:)
      type(hex_mesh), intent(in) :: parts(:)
      integer :: i

      report%table = new_table(columns=4, rows=size(parts))
      associate (table => report%table)
         call table%add_texts('part', names)
         call table%add_codes('nodes', column_counts, [(size(parts(i)%nodes, 2), i=1, size(parts))])
         call table%add_codes('elements', column_counts, &
            [(size(parts(i)%elements, 2), i=1, size(parts))])
         call table%add_numbers('volume', 'mm^3', [(mesh_volume(parts(i)), i=1, size(parts))])
      end associate
      report%first_rows = [1, size(parts) + 1]
      allocate (report%important(size(parts)), source=.true.)
   end subroutine fill_table

   !> Add a remark.
   pure subroutine remark(report, text)
      type(report_type), intent(inout) :: report
      character(len=*), intent(in) :: text
      type(string_type) :: line

      line%text = text
      if (allocated(report%remarks)) then
         report%remarks = [report%remarks, line]
      else
         report%remarks = [line]
      end if
   end subroutine remark

end module asperity_program_commands_deck
