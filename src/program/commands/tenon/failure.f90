!> What is left behind when a step of the tenon joint cannot be solved: a case file and the
!> displacements up to that step, with which it fails again.
module asperity_program_commands_tenon_failure
   use asperity_base_error, only: computation_error, error_type
   use asperity_base_kinds, only: wp
   use asperity_base_text_builder, only: growing_text
   use asperity_program_input_keys, only: command_hysteresis, command_tenon, find_key, keys, n_keys
   use asperity_program_input_print_case, only: case_text
   use asperity_program_input_resolve, only: mark_unused
   use asperity_program_input_settings, only: forget, settings_type
   use asperity_program_report_table, only: full_figures
   use asperity_program_system_atomic_files, only: open_target, output_file, write_files
   use asperity_program_system_strings, only: newline
   implicit none
   private
   public :: keep_failed_step

   character(len=*), parameter :: case_name = 'failed_step.nml', path_name = 'failed_step.csv'

contains

   !> Write the files into the current folder and say so in the message, if the error is one of
   !> computation. When they cannot be written, the message stays as it is.
   subroutine keep_failed_step(error, settings, path)
      !> Why the step failed
      type(error_type), intent(inout) :: error
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Displacements up to the step that failed, mm
      real(wp), intent(in) :: path(:)
      type(error_type), allocatable :: late_error
      type(output_file) :: files(2)
      type(settings_type) :: own
      type(growing_text) :: b
      integer :: i

      if (error%category /= computation_error) return
      own = settings
      call forget(own%of(find_key('record')))
      do i = 1, n_keys
         if (iand(keys(i)%commands, command_hysteresis) /= 0) call forget(own%of(i))
      end do
      call forget(own%of(find_key('history_quantity')))
      associate (history => own%of(find_key('history')))
         history%has_value = .true.
         history%text = path_name
      end associate
      call mark_unused(own, command_tenon)
      call b%line('displacement (mm)')
      do i = 1, size(path)
         call b%line(full_figures(path(i)))
      end do
      call open_target(files(1), 'failed step', path_name, late_error)
      if (.not. allocated(late_error)) call open_target(files(2), 'failed step', case_name, &
         late_error)
      if (allocated(late_error)) return
      files(1)%text = b%text()
      files(2)%text = '! '//error%message//newline//case_text(own, command_tenon)
      call write_files(files, late_error)
      if (.not. allocated(late_error)) error%message = error%message//'; asperity tenon '// &
         case_name//' replays it'
   end subroutine keep_failed_step

end module asperity_program_commands_tenon_failure
