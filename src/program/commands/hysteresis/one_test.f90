!> Report of one test.
module asperity_program_commands_hysteresis_one_test
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_analysis, only: analyse_hysteresis, hysteresis_result, &
      hysteresis_settings, leave_out, negative_side, positive_side
   use asperity_program_commands_hysteresis_plot, only: loops_panel, record_picture
   use asperity_program_commands_hysteresis_remarks, only: record_remarks
   use asperity_program_commands_hysteresis_standard_tables, only: standard_tables
   use asperity_program_commands_hysteresis_tables, only: cycle_table, record_labels, side_table, &
      skeleton_table
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_report_report, only: named_table, report_type
   implicit none
   private
   public :: bytes_of_row, report_test

   !> Bytes of a row of a table, at most; how often a table is in memory while it is made
   integer(int64), parameter :: bytes_of_row = 360, copies_made = 2

contains

   !> Analyse one test. `error` is set when that fails.
   subroutine report_test(settings, displacement, force, labels, is_only_one, report, result, error)
      !> How it is analysed
      type(hysteresis_settings), intent(in) :: settings
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> Names and units
      type(record_labels), intent(in) :: labels
      !> Whether there is no other test
      logical, intent(in) :: is_only_one
      !> Its tables, pictures and remarks are set
      type(report_type), intent(inout) :: report
      !> What was found
      type(hysteresis_result), intent(out) :: result
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(hysteresis_settings) :: own
      type(named_table), allocatable :: standards(:)

      own = settings
      own%millimetre = labels%millimetre
      call analyse_hysteresis(displacement, force, result, error, own)
      if (allocated(error)) return
      call check_work('the tables', copies_made*bytes_of_row*(size(result%cycles) &
         + size(result%skeleton(1)%force) + size(result%skeleton(2)%force) &
         + size(result%mean_skeleton%force)), error)
      if (allocated(error)) return
      report%table = cycle_table(result, labels)
      report%summary = side_table(result, labels)
      call standard_tables(result, labels, standards)
      report%more = [standards, named_table('skeleton', '', skeleton_table(result, labels))]
      report%shown_columns = [character(len=24) :: 'cycle', 'closed', 'positive_'//labels%x, &
         'positive_'//labels%f, 'negative_'//labels%x, 'negative_'//labels%f, &
         'secant_stiffness', 'mean_secant_stiffness', 'stiffness_ratio', 'energy', &
         'cumulative_energy', 'damping', 'positive_damping', 'negative_damping', 'pinching', &
         'fullness']
      report%first_rows = [1, size(result%cycles) + 1]
      allocate (report%important, source=result%cycles%in_skeleton(positive_side) .or. &
         result%cycles%in_skeleton(negative_side))
      report%record_kind = trim(result%record_kind)
      allocate (report%remarks, source=record_remarks(own, result, labels))
      call report%table%check_finite(error)
      if (.not. allocated(error)) call report%summary%check_finite(error)
      if (allocated(error) .or. .not. report%is_drawn()) return
      call draw_test(own, displacement, force, result, labels, is_only_one, report, error)
   end subroutine report_test

   !> Pictures of the samples that count.
   subroutine draw_test(settings, displacement, force, result, labels, is_only_one, report, error)
      type(hysteresis_settings), intent(in) :: settings
      real(wp), intent(in) :: displacement(:), force(:)
      type(hysteresis_result), intent(in) :: result
      type(record_labels), intent(in) :: labels
      logical, intent(in) :: is_only_one
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: x(:), f(:)

      ! it may have all of them
      call check_work('the picture', 6_int64*storage_size(force)/8_int64*size(force), error)
      if (allocated(error)) return
      allocate (x, source=displacement)
      allocate (f, source=force)
      if (settings%outliers == 'drop') call leave_out(result%outliers, x, f)
      report%picture_title = labels%title
      if (is_only_one) then
         report%pictures = [record_picture(x, f, result, labels)]
      else
         report%pictures = [figure_type('', [loops_panel(x, f, result, labels, labels%title)])]
      end if
   end subroutine draw_test

end module asperity_program_commands_hysteresis_one_test
