!> Does what a parsed command line asks for.
module asperity_program_driver
   use asperity_base_error, only: error_type
   use asperity_program_commands_config, only: config_type, new_config
   use asperity_program_commands_curve, only: report_curve
   use asperity_program_commands_deck, only: report_shear_deck, report_tenon_deck
   use asperity_program_commands_hysteresis_command, only: report_hysteresis
   use asperity_program_commands_pairs, only: report_pairs
   use asperity_program_commands_press, only: report_press
   use asperity_program_commands_shear, only: report_shear
   use asperity_program_commands_surface_command, only: report_surface
   use asperity_program_commands_table, only: report_law_table
   use asperity_program_commands_tenon_command, only: report_tenon
   use asperity_program_commands_tenon_history, only: follow_history, forget_reading, &
      history_type, read_history
   use asperity_program_commands_tenon_sweep, only: check_sweep, report_sweep
   use asperity_program_commands_tenon_sweeps_file, only: close_partial, partial_type
   use asperity_program_input_command_line, only: command_line_type
   use asperity_program_input_help, only: citation_text, help_text, version_text
   use asperity_program_input_keys, only: belongs, command_citation, command_curve, &
      command_deck_shear, command_deck_tenon, command_help, command_hysteresis, command_pairs, &
      command_press, command_shear, command_surface, command_table, command_tenon, &
      command_version, find_key
   use asperity_program_input_print_case, only: case_text
   use asperity_program_input_resolve, only: case_settings, locate, settled
   use asperity_program_input_settings, only: settings_type, take_defaults
   use asperity_program_outputs, only: deliver, delivery_type, prepare_delivery
   use asperity_program_report_report, only: report_type
   use asperity_program_system_atomic_files, only: write_standard_output
   implicit none
   private
   public :: drive

contains

   !> Do what a command line asks for.
   subroutine drive(line, error)
      !> The command line
      type(command_line_type), intent(in) :: line
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      select case (line%command)
      case (command_help)
         call write_standard_output(help_text(line%topic), error)
      case (command_version)
         call write_standard_output(version_text(), error)
      case (command_citation)
         call write_standard_output(citation_text(), error)
      case default
         call run(line, error)
      end select
   end subroutine drive

   !> Run a command that has results.
   subroutine run(line, error)
      type(command_line_type), intent(in) :: line
      type(error_type), allocatable, intent(out) :: error
      type(report_type) :: report
      type(settings_type) :: base
      type(config_type) :: config
      type(partial_type) :: partial
      type(history_type) :: history
      type(delivery_type) :: delivery

      report%command = line%command
      report%settings = line%options
      if (line%command == command_hysteresis .or. line%command == command_surface) then
         call take_defaults(report%settings)
      else if (line%command /= command_pairs) then
         call case_settings(line%case_path, base, error)
         if (.not. allocated(error)) call settled(base, line, report%settings, error)
         if (.not. allocated(error)) &
            call new_config(config, report%settings, line%command, error)
         if (allocated(error)) return
         call forget_reading(report%settings)
         if (line%options%switch_of('print_case')) then
            call write_standard_output(case_text(report%settings, line%command), error)
            return
         end if
      end if
      if (belongs(find_key('history'), line%command)) then
         call read_history(history, report%settings, error)
         ! The cases of a sweep may have arms of their own
         if (.not. allocated(error) .and. .not. line%options%given('sweep')) &
            call follow_history(config%tenon, history, error)
         if (allocated(error)) then
            call locate(error, report%settings)
            return
         end if
      end if
      if (line%options%given('sweep')) call check_sweep(line, error)
      if (.not. allocated(error)) call prepare_delivery(delivery, line, error)
      if (allocated(error)) return

      select case (line%command)
      case (command_curve)
         call report_curve(config, report, error)
      case (command_press)
         call report_press(config, report, error)
      case (command_shear)
         call report_shear(config, report, error)
      case (command_tenon)
         if (line%options%given('sweep')) then
            call report_sweep(line, base, config, history, report, partial, error)
         else
            call report_tenon(config, report, error)
            if (.not. allocated(error)) report%more = [report%more, history%columns]
         end if
      case (command_table)
         call report_law_table(config, report, error)
      case (command_deck_shear)
         call report_shear_deck(config, report, error)
      case (command_deck_tenon)
         call report_tenon_deck(config, report, error)
      case (command_hysteresis)
         call report_hysteresis(report, error)
      case (command_surface)
         call report_surface(report, error)
      case default
         call report_pairs(report)
      end select
      if (allocated(error)) then
         call locate(error, report%settings)
         return
      end if
      call deliver(delivery, report, error)
      if (allocated(partial%path) .and. .not. allocated(error)) call close_partial(partial)
   end subroutine run

end module asperity_program_driver
