!> `asperity hysteresis`: cycles, skeleton, stiffness, energy and damping of records, and what the
!> standards make of them.
module asperity_program_commands_hysteresis_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: check_hysteresis_settings, hysteresis_result, &
      hysteresis_settings, leave_out
   use asperity_hysteresis_characteristic_values, only: fewest_tests
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_hysteresis_one_test, only: bytes_of_row, report_test
   use asperity_program_commands_hysteresis_page, only: record_page
   use asperity_program_commands_hysteresis_record_input, only: record_input
   use asperity_program_commands_hysteresis_records, only: list_tests, number_of_tests, &
      read_records, record_type, remark_columns
   use asperity_program_commands_hysteresis_statistics, only: statistics_table
   use asperity_program_commands_hysteresis_tables, only: record_labels
   use asperity_program_commands_hysteresis_tests, only: join_reports, stacked
   use asperity_program_commands_opensees_output, only: opensees_output
   use asperity_program_input_key, only: kind_picture
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_conditions, only: name_records, test_text, test_type
   use asperity_program_record_table, only: columns_table
   use asperity_program_report_report, only: named_table, report_type
   use asperity_program_report_table, only: table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: hysteresis_command

   !> Analyses records.
   type, extends(command_type) :: hysteresis_command
      private
      type(record_input) :: input
      !> How it is analysed
      type(hysteresis_settings) :: analysis
      !> Reversals that are noise, none unless given or found
      real(wp) :: threshold = none
      character(len=:), allocatable :: threshold_source
      !> Path of the page
      character(len=:), allocatable :: page
      !> Material for a frame program
      type(opensees_output) :: opensees
   contains
      procedure :: describe, declare, check, run
   end type hysteresis_command

   !> How often a table is in memory while those of tests are joined
   integer(int64), parameter :: copies_joined = 4

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(hysteresis_command), intent(inout) :: self

      self%name = 'hysteresis'
      self%summary = 'stiffness, energy and damping of a record of displacement and force'
      self%usage = 'FILE.csv [FILE.csv ...] [options]'
      self%purpose = 'What a record of displacement and force, or of rotation and moment, is '// &
         '(monotonic, with or without unloading, one-sided, cyclic), its cycles, skeleton, '// &
         'yield and ultimate point, stiffness, energy and damping, and what EN 12512, EN 26891 '// &
         'and ASTM E2126 make of it. Of several records also mean, variation and 5 % fractile.'
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
      call keys%text('report', self%page, &
         'write a page of result, pictures and input, .html (needs gnuplot)', kind_picture)
      call self%opensees%declare(keys)
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
      call keys%real('estimated_force', self%analysis%estimated_force, '', &
         'EN 26891: estimated largest force; found by its unloading, else the largest force')
   end subroutine declare_analysis

   !> Check how the record is read and analysed.
   subroutine check(self, error)
      !> The command
      class(hysteresis_command), intent(inout) :: self
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error

      if (.not. is_none(self%threshold)) self%analysis%threshold = self%threshold
      call check_hysteresis_settings(self%analysis, error)
      if (.not. allocated(error)) call self%input%check('hysteresis', error)
      if (.not. allocated(error)) call self%opensees%check(error)
   end subroutine check

   !> Read the records and analyse them. `error` is set when that fails.
   subroutine run(self, report, error)
      !> The command
      class(hysteresis_command), intent(inout) :: self
      !> Its tables are set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(record_type), allocatable :: records(:)
      type(hysteresis_result) :: result
      type(table_type) :: columns

      call read_records(self%input, records, error)
      if (allocated(error)) return
      self%input = records(1)%input
      columns = columns_of(self%input%files, records)
      if (sum(number_of_tests(records)) == 1) then
         associate (first => records(1))
            call report_test(self%analysis, first%columns(1)%values, first%columns(2)%values, &
               first%labels, .true., report, result, error)
            if (.not. allocated(error) .and. self%opensees%is_asked()) &
               call add_material(self, first, result, report, error)
            if (allocated(error)) then
               error%message = first%labels%title//': '//error%message
               return
            end if
         end associate
         call tell_threshold(self, result)
      else
         call self%opensees%refuse(error)
         if (.not. allocated(error)) call report_tests(self, records, report, error)
         if (allocated(error)) return
      end if
      report%more = [report%more, named_table('columns', '', columns)]
      call self%declare(report%keys)
      if (self%page /= '') report%page = record_page(report)
   end subroutine run

   !> A material for a frame program that follows the loops.
   subroutine add_material(self, record, result, report, error)
      type(hysteresis_command), intent(inout) :: self
      type(record_type), intent(in) :: record
      type(hysteresis_result), intent(in) :: result
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: x(:), f(:)

      allocate (x, source=record%columns(1)%values)
      allocate (f, source=record%columns(2)%values)
      if (self%analysis%outliers == 'drop') call leave_out(result%outliers, x, f)
      call self%opensees%add_to(report, x, f, result, record%labels, record%labels%title, error)
      if (.not. allocated(error) .and. report%is_drawn()) &
         call self%opensees%draw(report%pictures(1)%panels(1))
   end subroutine add_material

   !> Which columns were taken of each record.
   pure function columns_of(paths, records) result(table)
      type(string_type), intent(in) :: paths(:)
      type(record_type), intent(in) :: records(:)
      type(table_type) :: table
      type(table_type) :: tables(size(records))
      type(test_type) :: names(size(records))
      integer :: i

      do i = 1, size(records)
         tables(i) = columns_table(records(i)%columns)
         allocate (names(i)%conditions(0))
      end do
      call name_records(paths, [(i, i=1, size(records))], names)
      table = tables(1)
      if (size(records) > 1) table = stacked(tables, names)
   end function columns_of

   !> Analyse several tests, of one record or of several. `error` is set when that fails.
   subroutine report_tests(self, records, report, error)
      type(hysteresis_command), intent(inout) :: self
      type(record_type), intent(in) :: records(:)
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(report_type), allocatable :: reports(:)
      type(test_type), allocatable :: tests(:)
      integer, allocatable :: numbers(:)
      character(len=:), allocatable :: title
      type(table_type) :: statistics
      type(record_labels) :: labels
      type(hysteresis_result) :: result
      integer :: i

      call list_tests(self%input%files, records, tests, numbers)
      allocate (reports(size(tests)))
      do i = 1, size(tests)
         associate (first => tests(i)%first, last => tests(i)%last, of => records(numbers(i)))
            reports(i)%keys = report%keys
            labels = of%labels
            labels%title = test_text(tests(i))
            call report_test(self%analysis, of%columns(1)%values(first:last), &
               of%columns(2)%values(first:last), labels, .false., reports(i), result, error)
            if (allocated(error)) then
               error%message = of%labels%title//': '//error%message
               if (size(of%tests) > 1) error%message = of%labels%title//': '// &
                  test_text(of%tests(i - findloc(numbers, numbers(i), 1) + 1))// &
                  error%message(len(of%labels%title) + 1:)
               return
            end if
         end associate
         call tell_threshold(self, result)
      end do
      call check_reports(reports, error)
      if (allocated(error)) return
      if (size(records) > 1) then
         call join_reports(reports, tests, to_text(size(records))//' records', report)
         statistics = statistics_table(reports, tests)
         title = 'Mean, coefficient of variation and 5 % fractile (EN 14358, lognormal, of '// &
            to_text(fewest_tests)//' tests at least)'
         if (statistics%rows == 0) title = ''
         report%more = [report%more, named_table('statistics', title, statistics)]
         call remark_columns(records, report)
      else
         call join_reports(reports, tests, records(1)%labels%title, report)
      end if
   end subroutine report_tests

   !> Say which threshold was found, that of the first test.
   pure subroutine tell_threshold(self, result)
      type(hysteresis_command), intent(inout) :: self
      type(hysteresis_result), intent(in) :: result

      if (self%analysis%threshold > 0.0_wp .or. .not. is_none(self%threshold)) return
      self%threshold = result%threshold
      self%threshold_source = trim(merge('noise of displacement', '1/400 of the range   ', &
         result%noise_sets_threshold))
   end subroutine tell_threshold

   !> Set `error` unless there is memory for joining the reports of all tests.
   pure subroutine check_reports(reports, error)
      type(report_type), intent(in) :: reports(:)
      type(error_type), allocatable, intent(out) :: error
      integer(int64) :: rows
      integer :: i

      rows = 0
      do i = 1, size(reports)
         rows = rows + reports(i)%table%rows + reports(i)%table_rows('skeleton')
      end do
      call check_work('the tables of all tests', copies_joined*bytes_of_row*rows, error)
   end subroutine check_reports

end module asperity_program_commands_hysteresis_command
