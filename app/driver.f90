!> Does what a parsed command line asks for.
module app_driver
   use asperity, only: error_type
   use app_cli, only: command_line_type
   use app_config, only: config_type, effective_settings, locate, new_config
   use app_curve, only: report_curve
   use app_delivery, only: deliver, delivery_type, prepare_delivery
   use app_help, only: citation_text, help_text, version_text
   use app_keys, only: command_citation, command_curve, command_help, command_pairs, &
      command_press, command_shear, command_version
   use app_output, only: write_standard_output
   use app_pairs, only: report_pairs
   use app_press, only: report_press
   use app_print_case, only: case_text
   use app_report, only: report_type
   use app_shear, only: report_shear
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
      type(config_type) :: config
      type(delivery_type) :: delivery

      report%command = line%command
      report%settings = line%options
      if (line%command /= command_pairs) then
         call effective_settings(line, report%settings, error)
         if (.not. allocated(error)) &
            call new_config(config, report%settings, line%command, error)
         if (allocated(error)) return
         if (line%options%switch_of('print_case')) then
            call write_standard_output(case_text(report%settings, line%command), error)
            return
         end if
      end if
      call prepare_delivery(delivery, line, error)
      if (allocated(error)) return

      select case (line%command)
      case (command_curve)
         call report_curve(config, report, error)
      case (command_press)
         call report_press(config, report, error)
      case (command_shear)
         call report_shear(config, report, error)
      case default
         call report_pairs(report)
      end select
      if (allocated(error)) then
         call locate(error, report%settings)
         return
      end if
      call deliver(delivery, report, error)
   end subroutine run

end module app_driver
