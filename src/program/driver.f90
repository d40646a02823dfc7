!> Does what a parsed command line asks for.
module asperity_program_driver
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_about, only: citation_text, version_text
   use asperity_program_command_line, only: asks_citation, asks_completion, asks_help, asks_man, &
      asks_run, command_line_type, standard_input
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_faces_read_faces, only: read_faces
   use asperity_program_commands_interaction, only: remark_interaction
   use asperity_program_commands_registry, only: all_keys
   use asperity_program_completion, only: bash_completion
   use asperity_program_help, only: command_help, overview, topic_help
   use asperity_program_input_case_file, only: read_case
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_heading, case_text
   use asperity_program_man_page, only: man_page
   use asperity_program_outputs, only: deliver, delivery_type, prepare_delivery
   use asperity_program_report_report, only: report_type
   use asperity_program_system_atomic_files, only: write_standard_output
   use asperity_program_system_environment, only: output_width
   use asperity_program_system_files, only: standard_error, write_text
   use asperity_program_system_launch, only: launch_type
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: drive

contains

   !> Do what a command line asks for. Ranks above 0 help a command whose work is shared, and do
   !> nothing else.
   subroutine drive(line, launch, error)
      !> The command line
      type(command_line_type), intent(inout) :: line
      !> This rank
      type(launch_type), intent(in) :: launch
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error

      if (line%action == asks_run) then
         line%command%launch = launch
         if (launch%rank == 0 .or. line%command%uses_ranks) call run(line, error)
         return
      end if
      if (launch%rank > 0) return
      select case (line%action)
      case (asks_help)
         if (allocated(line%command)) then
            call write_standard_output(command_help(line%command, output_width()), error)
         else if (line%topic /= '') then
            call write_standard_output(topic_help(line%topic, output_width()), error)
         else
            call write_standard_output(overview(output_width()), error)
         end if
      case (asks_citation)
         call write_standard_output(citation_text(), error)
      case (asks_man)
         call write_standard_output(man_page(), error)
      case (asks_completion)
         call write_standard_output(bash_completion(), error)
      case default
         call write_standard_output(version_text(), error)
      end select
   end subroutine drive

   !> Run a command, from its options to its outputs.
   subroutine run(line, error)
      type(command_line_type), intent(inout) :: line
      type(error_type), allocatable, intent(out) :: error
      type(report_type) :: report
      type(delivery_type) :: delivery
      logical :: is_first

      is_first = line%command%launch%rank == 0
      associate (command => line%command)
         call take_values(line, error)
         if (.not. allocated(error)) call command%check(error)
         if (.not. allocated(error) .and. .not. command%prints_case .and. is_first) &
            call prepare_delivery(delivery, line%keys, error)
         if (allocated(error)) then
            call line%keys%with_place(error)
            return
         end if
         if (command%prints_case) then
            if (is_first) call write_standard_output(case_text(line%keys, &
               case_heading(command%name)), error)
            return
         end if
         if (.not. command%uses_ranks) call tell_idle(command)
         report%name = command%name
         report%keys = line%keys
         call command%run(report, error)
         if (allocated(error)) then
            call report%keys%with_place(error)
            return
         end if
         if (.not. is_first) return
         call remark_interaction(report)
         call deliver(delivery, report, error)
         if (.not. allocated(error)) call command%finish(error)
      end associate
   end subroutine run

   !> Say that ranks have nothing to do.
   subroutine tell_idle(command)
      class(command_type), intent(in) :: command
      character(len=:), allocatable :: reason

      if (command%launch%size > 1) call write_text(standard_error, 'asperity: warning: '// &
         'asperity '//trim(command%name)//' runs on one rank, not on '// &
         to_text(command%launch%size)//newline, reason)
   end subroutine tell_idle

   !> Give a command the values of options and case file.
   subroutine take_values(line, error)
      type(command_line_type), intent(inout) :: line
      type(error_type), allocatable, intent(out) :: error
      type(key_list) :: known

      if (line%keys%case_path /= '') then
         call all_keys(known)
         if (line%keys%case_path == standard_input .and. line%command%uses_ranks .and. &
            line%command%launch%size /= 1) then
            call fatal_error(error, 'a case from standard input reaches rank 0 alone: name a '// &
               'file that all ranks can read')
            return
         end if
         call read_case(line%keys, known, error)
         if (allocated(error)) return
      end if
      call read_faces(line%keys, error)
      if (allocated(error)) return
      call line%command%declare(line%keys)
      if (allocated(line%keys%error)) call move_alloc(line%keys%error, error)
   end subroutine take_values

end module asperity_program_driver
