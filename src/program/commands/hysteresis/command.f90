!> `asperity hysteresis`: cycles, skeleton, stiffness, energy and damping of a record.
module asperity_program_commands_hysteresis_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: analyse_hysteresis, check_hysteresis_settings, &
      hysteresis_result, hysteresis_settings, leave_out, negative_side, positive_side
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_hysteresis_plot, only: loops_panel, record_picture
   use asperity_program_commands_hysteresis_record_input, only: record_input
   use asperity_program_commands_hysteresis_remarks, only: record_remarks
   use asperity_program_commands_hysteresis_tables, only: cycle_table, record_labels, side_table, &
      skeleton_table
   use asperity_program_commands_hysteresis_tests, only: join_reports
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_table, only: columns_table
   use asperity_program_record_tests, only: test_text, test_type
   use asperity_program_report_report, only: named_table, report_type
   implicit none
   private
   public :: hysteresis_command

   !> Analyses a record.
   type, extends(command_type) :: hysteresis_command
      private
      type(record_input) :: input
      !> How it is analysed
      type(hysteresis_settings) :: analysis
      !> Reversals that are noise, none unless given or found
      real(wp) :: threshold = none
      character(len=:), allocatable :: threshold_source
   contains
      procedure :: describe, declare, check, run
   end type hysteresis_command

   !> Bytes of a row of a table, at most; how often a table is in memory while it is made, and while
   !> those of tests are joined
   integer(int64), parameter :: bytes_of_row = 300, copies_made = 2, copies_joined = 4

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(hysteresis_command), intent(inout) :: self

      self%name = 'hysteresis'
      self%summary = 'stiffness, energy and damping of a record of displacement and force'
      self%usage = 'FILE.csv [options]'
      self%purpose = 'What a record of displacement and force, or of rotation and moment, is '// &
         '(monotonic, with or without unloading, one-sided, cyclic), its cycles, skeleton, '// &
         'yield and ultimate point, stiffness, energy and damping.'
      self%headings(2) = 'The record'
      self%takes_case = .false.
   end subroutine describe

   !> The record and how it is analysed.
   pure subroutine declare(self, keys)
      !> The command
      class(hysteresis_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call self%input%declare(keys)
      call declare_analysis(self, keys)
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Declare how the record is analysed.
   pure subroutine declare_analysis(self, keys)
      class(hysteresis_command), intent(inout) :: self
      type(key_list), intent(inout) :: keys

      call keys%real('threshold', self%threshold, '', &
         'reversals up to this are noise; 1/400 of the range or more by noise, unless above 0')
      call keys%said_by(self%threshold_source)
      call keys%choice('peaks', self%analysis%peaks, 'envelope displacement force', &
         'skeleton: first-cycle envelope, or the tip or the largest force of each first cycle')
      call keys%choice('outliers', self%analysis%outliers, 'drop keep', &
         'single samples that leap away and back, which a remark names')
      call keys%real('amplitude_tolerance', self%analysis%amplitude_tolerance, '', &
         'share by which an amplitude must exceed all before to be a new one')
      call keys%real('elastic_fraction', self%analysis%elastic_fraction, '', &
         'share of the peak force that the elastic stiffness goes through')
      call keys%real('ultimate_fraction', self%analysis%ultimate_fraction, '', &
         'share of the peak force, past the peak, at the ultimate point')
   end subroutine declare_analysis

   !> Check how the record is read and analysed.
   subroutine check(self, error)
      !> The command
      class(hysteresis_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      if (.not. is_none(self%threshold)) self%analysis%threshold = self%threshold
      call check_hysteresis_settings(self%analysis, error)
      if (.not. allocated(error)) call self%input%check(error)
   end subroutine check

   !> Read the record and analyse it. `error` is set when either fails.
   subroutine run(self, report, error)
      !> The command
      class(hysteresis_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(record_column) :: columns(2)
      type(test_type), allocatable :: tests(:)
      type(report_type), allocatable :: reports(:)
      type(record_labels) :: labels
      integer :: i

      call self%input%read(columns, tests, error)
      if (allocated(error)) return
      call self%input%label(columns, labels)
      if (size(tests) == 1) then
         call report_test(self, columns(1)%values, columns(2)%values, labels, .true., report, error)
      else
         allocate (reports(size(tests)))
         do i = 1, size(tests)
            associate (first => tests(i)%first, last => tests(i)%last)
               reports(i)%keys = report%keys
               labels%title = test_text(tests(i))
               call report_test(self, columns(1)%values(first:last), &
                  columns(2)%values(first:last), labels, .false., reports(i), error)
            end associate
            if (.not. allocated(error)) cycle
            error%message = test_text(tests(i))//': '//error%message
            exit
         end do
         if (.not. allocated(error)) call check_reports(reports, error)
         if (.not. allocated(error)) &
            call join_reports(reports, tests, self%input%record_file, report)
      end if
      if (allocated(error)) then
         error%message = self%input%record_file//': '//error%message
         return
      end if
      report%more = [report%more, named_table('columns', '', columns_table(columns))]
      call self%declare(report%keys)
   end subroutine run

   !> Analyse one test. `error` is set when that fails.
   subroutine report_test(self, displacement, force, labels, is_only_one, report, error)
      class(hysteresis_command), intent(inout) :: self
      real(wp), intent(in) :: displacement(:), force(:)
      type(record_labels), intent(in) :: labels
      logical, intent(in) :: is_only_one
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(hysteresis_result) :: result
      real(wp), allocatable :: x(:), f(:)

      call analyse_hysteresis(displacement, force, result, error, self%analysis)
      if (allocated(error)) return
      call check_work('the tables', copies_made*bytes_of_row*(size(result%cycles) &
         + size(result%skeleton(1)%force) + size(result%skeleton(2)%force)), error)
      if (allocated(error)) return
      if (.not. self%analysis%threshold > 0.0_wp .and. is_none(self%threshold)) then
         self%threshold = result%threshold
         self%threshold_source = trim(merge('noise of displacement', '1/400 of the range   ', &
            result%noise_sets_threshold))
      end if
      report%table = cycle_table(result, labels)
      report%summary = side_table(result, labels)
      allocate (report%more(1))
      report%more(1)%name = 'skeleton'
      report%more(1)%title = ''
      report%more(1)%table = skeleton_table(result, labels)
      report%shown_columns = [character(len=24) :: 'cycle', 'closed', 'positive_'//labels%x, &
         'positive_'//labels%f, 'negative_'//labels%x, 'negative_'//labels%f, &
         'secant_stiffness', 'mean_secant_stiffness', 'stiffness_ratio', 'energy', &
         'cumulative_energy', 'damping', 'pinching', 'fullness']
      report%first_rows = [1, size(result%cycles) + 1]
      allocate (report%important, source=result%cycles%in_skeleton(positive_side) .or. &
         result%cycles%in_skeleton(negative_side))
      report%record_kind = trim(result%record_kind)
      allocate (report%remarks, source=record_remarks(self%analysis, result, labels))
      call report%table%check_finite(error)
      if (.not. allocated(error)) call report%summary%check_finite(error)
      if (allocated(error)) return
      if (.not. report%is_drawn()) return
      ! The picture is one of the samples that count; it may have all of them
      call check_work('the picture', 6_int64*storage_size(force)/8_int64*size(force), error)
      if (allocated(error)) return
      allocate (x, source=displacement)
      allocate (f, source=force)
      if (self%analysis%outliers == 'drop') call leave_out(result%outliers, x, f)
      report%picture_title = labels%title
      if (is_only_one) then
         report%pictures = [record_picture(x, f, result, labels)]
      else
         report%pictures = [figure_type('', [loops_panel(x, f, result, labels, labels%title)])]
      end if
   end subroutine report_test

   !> Set `error` unless there is memory for joining the reports of all tests.
   pure subroutine check_reports(reports, error)
      type(report_type), intent(in) :: reports(:)
      type(error_type), allocatable, intent(inout) :: error
      integer(int64) :: rows
      integer :: i

      rows = 0
      do i = 1, size(reports)
         rows = rows + reports(i)%table%rows + reports(i)%more(1)%table%rows
      end do
      call check_work('the tables of all tests', copies_joined*bytes_of_row*rows, error)
   end subroutine check_reports

end module asperity_program_commands_hysteresis_command
