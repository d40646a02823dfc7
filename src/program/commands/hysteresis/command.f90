!> `asperity hysteresis`: cycles, skeleton, stiffness, energy and damping of a record.
module asperity_program_commands_hysteresis_command
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: analyse_hysteresis, check_hysteresis_settings, &
      hysteresis_result, hysteresis_settings, leave_out, negative_side, positive_side
   use asperity_program_commands_hysteresis_plot, only: loops_panel, record_picture
   use asperity_program_commands_hysteresis_remarks, only: record_remarks
   use asperity_program_commands_hysteresis_tables, only: cycle_table, record_labels, side_table, &
      skeleton_table
   use asperity_program_commands_hysteresis_tests, only: join_reports
   use asperity_program_input_keys, only: find_key
   use asperity_program_input_settings, only: assign_values, setting_type, settings_type
   use asperity_program_plot_figure, only: figure_type
   use asperity_program_record_columns, only: record_column
   use asperity_program_record_file, only: read_record, record_format
   use asperity_program_record_names, only: holds_displacement, holds_force, holds_moment, &
      holds_rotation
   use asperity_program_record_settings, only: ask_for_column, get_format, tell_column, tell_decimal
   use asperity_program_record_table, only: columns_table
   use asperity_program_record_tests, only: test_text, test_type
   use asperity_program_report_report, only: named_table, report_type
   implicit none
   private
   public :: report_hysteresis

   !> Beginnings of the options of both columns
   character(len=*), parameter :: axes(2) = [character(len=12) :: 'displacement', 'force']
   !> Bytes of a row of a table, at most; how often a table is in memory while it is made, and while
   !> those of tests are joined
   integer(int64), parameter :: bytes_of_row = 300, copies_made = 2, copies_joined = 4

contains

   !> Read the record and analyse it. `error` is set when either fails.
   subroutine report_hysteresis(report, error)
      !> Its settings on entry, its tables on return
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(record_column) :: columns(2)
      type(test_type), allocatable :: tests(:)
      type(report_type), allocatable :: reports(:)
      type(hysteresis_settings) :: settings
      type(record_labels) :: labels
      integer :: i

      call get_settings(report%settings, settings, error)
      if (.not. allocated(error)) call get_record(report%settings, columns, tests, error)
      if (allocated(error)) return
      call set_labels(report%settings, columns, labels)
      if (size(tests) == 1) then
         call report_test(columns(1)%values, columns(2)%values, settings, labels, .true., report, &
            error)
      else
         allocate (reports(size(tests)))
         do i = 1, size(tests)
            associate (first => tests(i)%first, last => tests(i)%last)
               reports(i)%settings = report%settings
               labels%title = test_text(tests(i))
               call report_test(columns(1)%values(first:last), columns(2)%values(first:last), &
                  settings, labels, .false., reports(i), error)
            end associate
            if (.not. allocated(error)) cycle
            error%message = test_text(tests(i))//': '//error%message
            exit
         end do
         if (.not. allocated(error)) call check_reports(reports, error)
         if (.not. allocated(error)) call join_reports(reports, tests, report)
      end if
      if (allocated(error)) then
         error%message = report%settings%text_of('record_file')//': '//error%message
         return
      end if
      report%more = [report%more, named_table('columns', '', columns_table(columns))]
   end subroutine report_hysteresis

   !> Analyse one test. `error` is set when that fails.
   subroutine report_test(displacement, force, settings, labels, is_only_one, report, error)
      real(wp), intent(in) :: displacement(:), force(:)
      type(hysteresis_settings), intent(in) :: settings
      type(record_labels), intent(in) :: labels
      logical, intent(in) :: is_only_one
      type(report_type), intent(inout) :: report
      type(error_type), allocatable, intent(out) :: error
      type(hysteresis_result) :: result
      real(wp), allocatable :: x(:), f(:)

      call analyse_hysteresis(displacement, force, result, error, settings)
      if (allocated(error)) return
      call check_work('the tables', copies_made*bytes_of_row*(size(result%cycles) &
         + size(result%skeleton(1)%force) + size(result%skeleton(2)%force)), error)
      if (allocated(error)) return
      if (.not. settings%threshold > 0.0_wp) call assign_values( &
         report%settings%of(find_key('threshold')), [result%threshold], trim(merge( &
         'noise of displacement', '1/400 of the range   ', result%noise_sets_threshold)))
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
      allocate (report%remarks, source=record_remarks(settings, result, labels))
      call report%table%check_finite(error)
      if (.not. allocated(error)) call report%summary%check_finite(error)
      if (allocated(error)) return
      if (.not. report%is_drawn()) return
      ! The picture is one of the samples that count; it may have all of them
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

   !> How to read the record. `error` names the option.
   pure subroutine get_settings(values, settings, error)
      type(settings_type), intent(in) :: values
      type(hysteresis_settings), intent(out) :: settings
      type(error_type), allocatable, intent(out) :: error

      if (values%given('threshold')) settings%threshold = values%real_of('threshold')
      settings%amplitude_tolerance = values%real_of('amplitude_tolerance')
      settings%elastic_fraction = values%real_of('elastic_fraction')
      settings%ultimate_fraction = values%real_of('ultimate_fraction')
      settings%peaks = values%text_of('peaks')
      settings%outliers = values%text_of('outliers')
      call check_hysteresis_settings(settings, error)
      if (allocated(error)) return
      call check_factor(values, 'displacement_factor', error)
      if (.not. allocated(error)) call check_factor(values, 'force_factor', error)
   end subroutine get_settings

   pure subroutine check_factor(values, name, error)
      type(settings_type), intent(in) :: values
      character(len=*), intent(in) :: name
      type(error_type), allocatable, intent(out) :: error

      if (.not. abs(values%real_of(name)) > 0.0_wp) call fatal_error(error, name// &
         ' = 0.0 is not allowed: nothing would be left of the record')
   end subroutine check_factor

   !> Read both columns and bring them to zero and scale.
   subroutine get_record(settings, columns, tests, error)
      type(settings_type), intent(inout) :: settings
      type(record_column), intent(out) :: columns(2)
      type(test_type), allocatable, intent(out) :: tests(:)
      type(error_type), allocatable, intent(out) :: error
      type(record_format) :: format
      integer :: i

      if (settings%text_of('record_file') == '') then
         call fatal_error(error, 'no record is given: asperity hysteresis FILE.csv')
         return
      end if
      call get_format(settings, format, error)
      if (allocated(error)) return
      do i = 1, 2
         call ask_for_column(settings, trim(axes(i)), columns(i))
      end do
      call read_record(settings%text_of('record_file'), format, &
         quantities_of(settings%text_of('quantity')), columns, tests, error)
      if (allocated(error)) return
      if (columns(1)%place == columns(2)%place) then
         call fatal_error(error, settings%text_of('record_file')//': '//columns(1)%name// &
            ' and '//columns(2)%name//' are both column '//to_text(columns(1)%place))
         return
      end if
      call tell_decimal(settings, format)
      do i = 1, 2
         call tell_column(settings, trim(axes(i)), columns(i))
         columns(i)%values(:) = settings%real_of(trim(axes(i))//'_factor') &
            *(columns(i)%values - settings%real_of(trim(axes(i))//'_zero'))
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
   pure subroutine set_labels(settings, columns, labels)
      type(settings_type), intent(inout) :: settings
      type(record_column), intent(in) :: columns(2)
      type(record_labels), intent(out) :: labels

      labels%x = 'displacement'
      labels%f = 'force'
      associate (quantity => settings%of(find_key('quantity')))
         if (.not. quantity%given) then
            quantity%has_value = .true.
            quantity%text = trim(merge('moment', 'force ', columns(2)%holds == holds_moment))
            quantity%source = 'its columns'
         end if
      end associate
      if (settings%text_of('quantity') == 'moment') then
         labels%x = 'rotation'
         labels%f = 'moment'
         call set_unit(settings%of(find_key('displacement_unit')), columns(1), 'rad')
         call set_unit(settings%of(find_key('force_unit')), columns(2), 'kN m')
      else
         call set_unit(settings%of(find_key('displacement_unit')), columns(1), 'mm')
         call set_unit(settings%of(find_key('force_unit')), columns(2), 'N')
      end if
      labels%x_unit = settings%text_of('displacement_unit')
      labels%f_unit = settings%text_of('force_unit')
      labels%title = settings%text_of('record_file')
   end subroutine set_labels

   !> The unit of a column.
   pure subroutine set_unit(setting, column, default)
      type(setting_type), intent(inout) :: setting
      type(record_column), intent(in) :: column
      character(len=*), intent(in) :: default

      if (setting%given) return
      setting%has_value = .true.
      setting%text = default
      if (column%unit == '') return
      setting%text = column%unit
      setting%source = 'column '//to_text(column%place)
   end subroutine set_unit

end module asperity_program_commands_hysteresis_command
