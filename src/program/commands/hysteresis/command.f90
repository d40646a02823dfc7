!> `asperity hysteresis`: cycles, skeleton, stiffness, energy and damping of a record.
module asperity_program_commands_hysteresis_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: analyse_hysteresis, check_hysteresis_settings, &
      hysteresis_result, hysteresis_settings, leave_out, negative_side, positive_side
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_hysteresis_plot, only: loops_panel, record_picture
   use asperity_program_commands_hysteresis_remarks, only: record_remarks
   use asperity_program_commands_hysteresis_tables, only: cycle_table, record_labels, side_table, &
      skeleton_table
   use asperity_program_commands_hysteresis_tests, only: join_reports
   use asperity_program_input_key_list, only: key_list
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_file, only: read_record
   use asperity_program_record_keys, only: column_keys, format_keys
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_moment, &
      holds_rotation
   use asperity_program_record_table, only: columns_table
   use asperity_program_record_tests, only: test_text, test_type
   use asperity_program_report_report, only: named_table, report_type
   implicit none
   private
   public :: hysteresis_command

   !> Analyses a record.
   type, extends(command_type) :: hysteresis_command
      private
      !> Path of the record, and what is taken of it
      character(len=:), allocatable :: record_file
      character(len=6) :: quantity = ''
      character(len=:), allocatable :: quantity_source
      logical :: has_quantity = .false.
      !> How it is written, and its columns of displacement and force
      type(format_keys) :: format
      type(column_keys) :: columns(2)
      !> What is subtracted from the columns, and what they are then multiplied by
      real(wp) :: zero(2) = 0.0_wp, factor(2) = 1.0_wp
      !> How it is analysed
      type(hysteresis_settings) :: analysis
      !> Reversals that are noise, none unless given or found
      real(wp) :: threshold = none
      character(len=:), allocatable :: threshold_source
   contains
      procedure :: describe, declare, check, run
   end type hysteresis_command

   !> Beginnings of the keys of both columns
   character(len=*), parameter :: axes(2) = [character(len=12) :: 'displacement', 'force']
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

      self%columns%name = axes
      call keys%text('record_file', self%record_file, 'the record, as FILE.csv without an option')
      call keys%reads('record', is_argument=.true.)
      call keys%choice('quantity', self%quantity, 'force moment', &
         'what is taken of the record: displacement and force, or rotation and moment')
      self%has_quantity = keys%given()
      call keys%said_by(self%quantity_source)
      call self%columns(1)%declare_column(keys, &
         'name or number of the column of displacement or rotation; found by name and unit')
      call self%columns(2)%declare_column(keys, &
         'name or number of the column of force or moment; found by name and unit')
      call self%format%declare(keys, unused=.false.)
      call keys%real('displacement_zero', self%zero(1), '', &
         'reading at rest, subtracted from the column of displacement')
      call keys%real('displacement_factor', self%factor(1), '', &
         'then multiplied by; -1 turns the sign, 1/arm makes a rotation')
      call keys%real('force_zero', self%zero(2), '', &
         'reading at rest, subtracted from the column of force')
      call keys%real('force_factor', self%factor(2), '', 'then multiplied by')
      call self%columns(1)%declare_unit(keys, &
         'unit after zero and factor; that of the file, else mm or rad')
      call self%columns(2)%declare_unit(keys, &
         'label, after zero and factor; that of the file, else N or kN m')
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
      integer :: i

      if (.not. is_none(self%threshold)) self%analysis%threshold = self%threshold
      call check_hysteresis_settings(self%analysis, error)
      do i = 1, size(axes)
         if (.not. allocated(error) .and. .not. abs(self%factor(i)) > 0.0_wp) &
            call fatal_error(error, trim(axes(i))//'_factor = 0.0 is not allowed: nothing '// &
            'would be left of the record', subject=trim(axes(i))//'_factor')
      end do
      if (.not. allocated(error) .and. self%record_file == '') &
         call fatal_error(error, 'no record is given: asperity hysteresis FILE.csv')
      if (.not. allocated(error)) call self%format%check(error)
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

      call get_record(self, columns, tests, error)
      if (allocated(error)) return
      call set_labels(self, columns, labels)
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
         if (.not. allocated(error)) call join_reports(reports, tests, self%record_file, report)
      end if
      if (allocated(error)) then
         error%message = self%record_file//': '//error%message
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
         'secant_stiffness', 'stiffness_ratio', 'energy', 'cumulative_energy', 'damping', &
         'pinching', 'fullness']
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

   !> Read both columns and bring them to zero and scale.
   subroutine get_record(self, columns, tests, error)
      class(hysteresis_command), intent(inout) :: self
      type(record_column), intent(out) :: columns(2)
      type(test_type), allocatable, intent(out) :: tests(:)
      type(error_type), allocatable, intent(out) :: error
      character(len=12) :: decimal
      integer :: i

      do i = 1, size(axes)
         call self%columns(i)%ask(columns(i))
      end do
      decimal = self%format%decimal
      call read_record(self%record_file, self%format%record_format, quantities_of(self%quantity), &
         columns, tests, error)
      if (allocated(error)) return
      if (columns(1)%place == columns(2)%place) then
         call fatal_error(error, self%record_file//': '//columns(1)%name//' and '// &
            columns(2)%name//' are both column '//to_text(columns(1)%place))
         return
      end if
      if (self%format%decimal /= decimal) self%format%decimal_source = 'the numbers of the file'
      do i = 1, size(axes)
         call self%columns(i)%tell(columns(i))
         columns(i)%values(:) = self%factor(i)*(columns(i)%values - self%zero(i))
      end do
   end subroutine get_record

   !> What the columns may hold together.
   pure function quantities_of(quantity) result(quantities)
      character(len=*), intent(in) :: quantity
      integer, allocatable :: quantities(:, :)
      integer, parameter :: forces(4) = [holds_displacement, holds_force, holds_rotation, &
         holds_force], moments(2) = [holds_rotation, holds_moment]

      select case (quantity)
      case ('force')
         quantities = reshape(forces, [2, 2])
      case ('moment')
         quantities = reshape(moments, [2, 1])
      case default
         quantities = reshape([forces(:2), moments, forces(3:)], [2, 3])
      end select
   end function quantities_of

   !> Names and units of what the record holds. Units of the file count unless others were given.
   pure subroutine set_labels(self, columns, labels)
      class(hysteresis_command), intent(inout) :: self
      type(record_column), intent(in) :: columns(2)
      type(record_labels), intent(out) :: labels

      labels%x = trim(axes(1))
      labels%f = trim(axes(2))
      if (.not. self%has_quantity) then
         self%quantity = merge('moment', 'force ', columns(2)%holds == holds_moment)
         self%quantity_source = 'its columns'
      end if
      if (self%quantity == 'moment') then
         labels%x = 'rotation'
         labels%f = 'moment'
         call self%columns(1)%tell_unit(columns(1), 'rad')
         call self%columns(2)%tell_unit(columns(2), 'kN m')
      else
         call self%columns(1)%tell_unit(columns(1), 'mm')
         call self%columns(2)%tell_unit(columns(2), 'N')
      end if
      labels%x_unit = self%columns(1)%unit
      labels%f_unit = self%columns(2)%unit
      labels%title = self%record_file
   end subroutine set_labels

end module asperity_program_commands_hysteresis_command
