!> `asperity compare`: a result against expected values, such as a first run of ABAQUS.
module asperity_program_commands_compare_command
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_command, only: command_type
   use asperity_program_commands_compare_columns_file, only: read_columns
   use asperity_program_commands_compare_departures, only: aligned, departure_of, &
      departure_type, matching_rows
   use asperity_program_commands_compare_history, only: history_type
   use asperity_program_commands_compare_plot, only: draw_comparison
   use asperity_program_commands_compare_printed_forces, only: is_printed, read_printed_forces
   use asperity_program_commands_compare_words, only: departures_table, remark_departures, &
      remark_rows
   use asperity_program_input_key_list, only: key_list
   use asperity_program_record_file, only: read_text
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: compare_command

   !> Holds a result against expected values.
   type, extends(command_type) :: compare_command
      private
      !> What is expected, and the result
      type(string_type), allocatable :: files(:)
      !> What a value may be off, as a part of the largest of its column. ABAQUS prints four
      !> figures, half a unit of the last of which is up to half of this
      real(wp) :: tolerance = 1.0e-3_wp
      !> What is said of a result that departs, empty when it does not
      character(len=:), allocatable :: departs
   contains
      procedure :: describe, declare, check, run, finish
   end type compare_command

contains

   !> What the command is.
   pure subroutine describe(self)
      !> The command
      class(compare_command), intent(inout) :: self

      self%name = 'compare'
      self%summary = 'a result of ABAQUS or CalculiX against expected values'
      self%usage = 'EXPECTED.csv RESULT.csv|RESULT.dat|RESULT.rpt [options]'
      self%purpose = 'Hold a result against expected values: columns of one name at equal '// &
         'times. A .dat of ABAQUS or CalculiX gives the totals of reaction forces that '// &
         '*NODE PRINT, TOTALS=YES prints for one node set, as reaction_1 to reaction_3; any '// &
         'other file has columns under headings, time (or X) among them. It says pass or where '// &
         'the result departs, and ends with status 1 if it does.'
      self%headings(2) = 'The comparison'
      self%takes_case = .false.
   end subroutine describe

   !> Two files, and what may be off.
   pure subroutine declare(self, keys)
      !> The command
      class(compare_command), intent(inout) :: self
      !> Its keys
      type(key_list), intent(inout) :: keys

      call keys%paths('compared_file', self%files, &
         'expected values, then the result, as two files without an option')
      call keys%reads('result', is_argument=.true.)
      call keys%real('tolerance', self%tolerance, '', &
         'what a value may be off, as a part of the largest of its column')
      call self%declare_outputs(keys, has_picture=.true.)
      call self%declare_requests(keys)
   end subroutine declare

   !> Two files, and a tolerance that is one.
   subroutine check(self, error)
      !> The command
      class(compare_command), intent(inout) :: self
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error

      self%departs = ''
      if (size(self%files) /= 2) then
         call fatal_error(error, to_text(size(self%files))//' files are given; two are '// &
            'compared: asperity compare EXPECTED.csv RESULT')
      else if (.not. (self%tolerance > 0.0_wp .and. self%tolerance < 1.0_wp)) then
         call fatal_error(error, 'tolerance = '//to_text(self%tolerance)// &
            ' is not allowed: above 0 and below 1', subject='tolerance')
      end if
   end subroutine check

   !> Read both and compare. `error` is set when a file cannot be read or they have no column in
   !> common.
   subroutine run(self, report, error)
      !> The command
      class(compare_command), intent(inout) :: self
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(history_type) :: expected, result
      type(departure_type), allocatable :: departures(:)
      real(wp), allocatable :: found(:, :)
      integer, allocatable :: rows(:)
      integer :: i, n

      call read_history(self%files(1)%text, expected, error)
      if (.not. allocated(error)) call read_history(self%files(2)%text, result, error)
      if (allocated(error)) return
      allocate (rows, source=matching_rows(expected, result))
      allocate (found, source=aligned(expected, result, rows))
      allocate (departures(size(expected%names)))
      n = 0
      do i = 1, size(expected%names)
         if (all(result%names /= expected%names(i))) cycle
         n = n + 1
         departures(n) = departure_of(expected, i, found(:, i), rows > 0, self%tolerance)
      end do
      if (n == 0) then
         call fatal_error(error, result%path//': has none of the columns of '//expected%path// &
            ': '//listed(expected%names)//'; it has '//listed(result%names))
         return
      else if (all(rows == 0)) then
         call fatal_error(error, result%path//': has no row at any time of '//expected%path// &
            ', which goes from '//to_text(expected%time(1))//' to '// &
            to_text(expected%time(size(expected%time)))//' s')
         return
      end if
      report%table = departures_table(departures(:n))
      report%first_rows = [1, n + 1]
      allocate (report%important(n), source=.true.)
      call remark_rows(report, expected, result, rows)
      call remark_departures(report, departures(:n), expected, found)
      call judge(self, report, departures(:n), rows)
      if (report%is_drawn()) call draw_comparison(report, departures(:n), expected, found)
   end subroutine run

   !> Pass, or the columns that depart.
   subroutine judge(self, report, departures, rows)
      type(compare_command), intent(inout) :: self
      type(report_type), intent(inout) :: report
      type(departure_type), intent(in) :: departures(:)
      integer, intent(in) :: rows(:)
      type(string_type) :: line

      if (any(departures%first > 0)) self%departs = 'departs from '//self%files(1)%text// &
         ' in '//listed(pack(departures%name, departures%first > 0))
      if (any(rows == 0) .and. self%departs /= '') self%departs = self%departs//', and'
      if (any(rows == 0)) self%departs = trim(self%departs//' has no row at '// &
         to_text(count(rows == 0))//' of '//to_text(size(rows))//' times')
      line%text = 'pass: '//to_text(size(departures))//' columns at '//to_text(size(rows))// &
         ' times within '//to_text(self%tolerance)//' of the largest value of each.'
      if (self%departs /= '') line%text = self%files(2)%text//' '//trim(adjustl(self%departs))//'.'
      allocate (report%verdict(1))
      report%verdict(1) = line
   end subroutine judge

   !> Fail when the result departs.
   subroutine finish(self, error)
      !> The command
      class(compare_command), intent(inout) :: self
      !> Set when the result departs
      type(error_type), allocatable, intent(out) :: error

      if (self%departs /= '') call fatal_error(error, self%files(2)%text//' '// &
         trim(adjustl(self%departs)), computation_error)
   end subroutine finish

   !> Read a file of either kind.
   subroutine read_history(path, history, error)
      character(len=*), intent(in) :: path
      type(history_type), intent(out) :: history
      type(error_type), allocatable, intent(out) :: error
      character(len=:), allocatable :: text

      call read_text(path, text, error)
      if (allocated(error)) return
      if (is_printed(text) .or. index(path, '.dat', back=.true.) == len(path) - 3) then
         call read_printed_forces(text, path, history, error)
      else
         call read_columns(text, path, history, error)
      end if
   end subroutine read_history

   !> Names with commas between them.
   pure function listed(names) result(text)
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(names)
         if (i > 1) text = text//', '
         text = text//trim(names(i))
      end do
   end function listed

end module asperity_program_commands_compare_command
