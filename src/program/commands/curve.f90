!> `asperity curve`: the normal law at a list of separations.
module asperity_program_commands_curve
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_program_commands_config, only: config_type
   use asperity_program_commands_plots, only: draw_curve
   use asperity_program_report_report, only: report_type, turning_points
   use asperity_program_report_table, only: column_validity, new_table
   use asperity_program_system_progress, only: progress_type
   implicit none
   private
   public :: report_curve

   !> Points between two looks at the clock
   integer, parameter :: chunk = 1000
   !> Bytes of a separation in results and table
   integer(int64), parameter :: bytes_of_row = 300

contains

   !> Evaluate the law. `error` is set when a result is out of the range of numbers.
   subroutine report_curve(config, report, error)
      !> Properties and separations
      type(config_type), intent(in) :: config
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(normal_response), allocatable :: r(:)
      type(progress_type) :: progress
      integer :: i, last, n

      n = size(config%separation)
      call check_work(to_text(n)//' separations', bytes_of_row*n, error)
      if (allocated(error)) return
      allocate (r(n))
      call progress%start('curve')
      do i = 1, n, chunk
         call progress%show(i - 1, n, 'separations')
         last = min(i + chunk - 1, n)
         r(i:last) = evaluate_normal_law(config%properties%normal, config%separation(i:last))
      end do
      call progress%finish()

      report%table = new_table(columns=11, rows=n)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      associate (table => report%table)
         call table%add_numbers('separation', 'mm', config%separation)
         call table%add_numbers('closure', 'mm', &
            config%properties%initial_separation - config%separation)
         call table%add_numbers('pressure', 'MPa', (r%pressure))
         call table%add_numbers('stiffness', 'MPa/mm', (r%stiffness))
         call table%add_numbers('area_fraction', '-', (r%area_fraction))
         call table%add_numbers('contact_density', '1/mm^2', (r%contact_density))
         call table%add_numbers('energy', 'N/mm', (r%energy))
         call table%add_numbers('elastic_share', '-', (r%elastic_share))
         call table%add_numbers('elastoplastic_share', '-', (r%elastoplastic_share))
         call table%add_numbers('plastic_share', '-', (r%plastic_share))
         call table%add_codes('validity', column_validity, (r%validity))
         call table%check_finite(error)
      end associate
      report%first_rows = [1, n + 1]
      report%important = turning_points(config%separation)
      if (.not. allocated(error) .and. report%is_drawn()) call draw_curve(report)
   end subroutine report_curve

end module asperity_program_commands_curve
