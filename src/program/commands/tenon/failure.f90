!> What is left behind when a step of the tenon joint cannot be solved: a case file and the
!> displacements up to that step, with which it fails again, and the contact point at which it does.
module asperity_program_commands_tenon_failure
   use asperity_base_error, only: computation_error, error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_commands_joint_loops, only: model_names, rough
   use asperity_program_commands_replay_failed_point, only: keep_failed_point
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_input_key, only: forget
   use asperity_program_input_key_list, only: key_list
   use asperity_program_input_print_case, only: case_heading, case_text
   use asperity_program_report_table, only: full_figures
   use asperity_program_system_atomic_files, only: open_target, output_file, write_files
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_run, only: failed_point, run_tenon
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   implicit none
   private
   public :: keep_failed_step, keep_point_of_step

   character(len=*), parameter :: case_name = 'failed_step.nml', path_name = 'failed_step.csv'

   !> Keys of the programme, in whose place that record is
   character(len=*), parameter :: of_programme(*) = [character(len=20) :: 'amplitudes', 'cycles', &
      'record', 'history_quantity', 'displacement_column', 'where', 'separator', 'decimal', &
      'skip_lines', 'displacement_unit']

contains

   !> Write the files into the current folder and say so in the message, if the error is one of
   !> computation. When they cannot be written, the message stays as it is.
   subroutine keep_failed_step(error, keys, path)
      !> Why the step failed
      type(error_type), intent(inout) :: error
      !> The keys
      type(key_list), intent(in) :: keys
      !> Displacements up to the step that failed, mm
      real(wp), intent(in) :: path(:)
      type(error_type), allocatable :: late_error
      type(output_file) :: files(2)
      type(key_list) :: own
      type(string_type) :: heading(2)
      type(growing_text) :: b
      integer :: i

      if (error%category /= computation_error) return
      own = keys
      do i = 1, size(of_programme)
         call forget(own%rows(own%find(trim(of_programme(i)))))
      end do
      associate (history => own%rows(own%find('history')))
         history%has_value = .true.
         history%text = path_name
      end associate
      call b%line('displacement (mm)')
      do i = 1, size(path)
         call b%line(full_figures(path(i)))
      end do
      call open_target(files(1), 'failed step', path_name, late_error)
      if (.not. allocated(late_error)) call open_target(files(2), 'failed step', case_name, &
         late_error)
      if (allocated(late_error)) return
      files(1)%text = b%text()
      heading(1)%text = error%message
      heading(2:) = case_heading('tenon')
      files(2)%text = case_text(own, heading)
      call write_files(files, late_error)
      if (.not. allocated(late_error)) error%message = error%message//'; asperity tenon '// &
         case_name//' replays it'
   end subroutine keep_failed_step

   !> Run the rough joint again, through UINTER, and keep the motion of the point at which it fails.
   subroutine keep_point_of_step(error, case)
      !> Why the step failed
      type(error_type), intent(inout) :: error
      !> The joint
      type(tenon_case), intent(in) :: case
      type(tenon_settings) :: settings
      type(tenon_step), allocatable :: steps(:)
      type(error_type), allocatable :: again
      type(failed_point) :: failed

      if (error%category /= computation_error) return
      settings = case%joint
      settings%contact = model_names(rough)
      settings%through_uinter = .true.
      call run_tenon(settings, case%properties, case%sides, steps, again, failed=failed)
      if (failed%point > 0) call keep_failed_point(error, failed%path, failed%properties, &
         'contact point '//to_text(failed%point))
   end subroutine keep_point_of_step

end module asperity_program_commands_tenon_failure
