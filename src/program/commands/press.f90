!> `asperity press`: press and release, replayed through UINTER.
module asperity_program_commands_press
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_config, only: config_type
   use asperity_program_commands_plots, only: draw_press
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_status, column_validity, new_table
   use asperity_program_system_progress, only: progress_type
   use asperity_replay_press, only: press_step, run_press
   implicit none
   private
   public :: report_press

   !> Bytes of an increment in results and table
   integer(int64), parameter :: bytes_of_row = 300

contains

   !> Run the replay. `error` is set when a setting is refused or the replay fails.
   subroutine report_press(config, report, error)
      !> Properties and load path
      type(config_type), intent(in) :: config
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(press_step), allocatable :: s(:)
      type(progress_type) :: progress

      call check_work('twice '//to_text(config%press%increments)//' increments', &
         bytes_of_row*(2*config%press%increments + 1), error)
      if (allocated(error)) return
      call progress%start('press')
      call progress%announce(config%press%increments, 'increments up and down')
      call run_press(config%press, config%properties, s, error)
      call progress%finish()
      if (allocated(error)) return

      report%table = new_table(columns=13, rows=size(s))
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      associate (table => report%table)
         call table%add_numbers('time', 's', (s%time))
         call table%add_numbers('overclosure', 'mm', (s%overclosure))
         call table%add_numbers('separation', 'mm', (s%separation))
         call table%add_numbers('pressure', 'MPa', (s%pressure))
         call table%add_numbers('stiffness', 'MPa/mm', (s%stiffness))
         call table%add_numbers('area_fraction', '-', (s%area_fraction))
         call table%add_numbers('contact_density', '1/mm^2', (s%contact_density))
         call table%add_numbers('energy', 'N/mm', (s%energy))
         call table%add_numbers('elastic_share', '-', (s%elastic_share))
         call table%add_numbers('elastoplastic_share', '-', (s%elastoplastic_share))
         call table%add_numbers('plastic_share', '-', (s%plastic_share))
         call table%add_codes('status', column_status, (s%status))
         call table%add_codes('validity', column_validity, (s%validity))
         call table%check_finite(error)
      end associate
      report%shown_columns = [character(len=24) :: 'time', 'overclosure', 'separation', &
         'pressure', 'stiffness', 'area_fraction', 'energy', 'elastic_share', &
         'elastoplastic_share', 'plastic_share', 'status', 'validity']
      report%first_rows = [1, size(s) + 1]
      report%important = turning_points((s%overclosure))
      if (.not. allocated(error) .and. report%is_drawn()) call draw_press(report)
   end subroutine report_press

end module asperity_program_commands_press
