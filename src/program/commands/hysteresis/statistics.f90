!> What several tests of the same kind come to: mean, variation and 5 % fractile of each quantity.
module asperity_program_commands_hysteresis_statistics
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_characteristic_values, only: characteristic_values
   use asperity_program_commands_hysteresis_standard_tables, only: en_12512, en_26891
   use asperity_program_commands_hysteresis_tables, only: ratio_decimals, side_names
   use asperity_program_record_conditions, only: same_conditions, test_text, test_type
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, column_numbers, new_table, table_type
   implicit none
   private
   public :: statistics_table

   !> Standards whose tables are evaluated; the first is that of the summary
   character(len=*), parameter :: standards(3) = [character(len=10) :: 'ASTM E2126', 'EN 12512', &
      'EN 26891']
   !> Figures of numbers on the terminal
   integer, parameter :: figures = 5
   integer, parameter :: longest = 80

   !> Rows, which grow.
   type :: row_list
      integer :: n = 0
      character(len=longest), allocatable :: tests(:), names(:), units(:)
      integer, allocatable :: standard(:), side(:), counts(:)
      real(wp), allocatable :: values(:, :)
   contains
      procedure :: add
   end type row_list

contains

   !> One row a quantity, side and standard; none if no two tests differ in the record alone.
   pure function statistics_table(reports, tests) result(table)
      !> One report a test
      type(report_type), intent(in) :: reports(:)
      !> The tests, whose first condition is the record
      type(test_type), intent(in) :: tests(:)
      type(table_type) :: table
      type(row_list) :: rows
      integer :: i, j, standard
      logical :: repeats(size(tests))

      do i = 1, size(tests)
         repeats = [(same_conditions(tests(j), tests(i), first=2), j=1, size(tests))]
         if (count(repeats) < 2 .or. any(repeats(:i - 1))) cycle
         do standard = 1, size(standards)
            call add_standard(rows, reports, repeats, standard, test_text(tests(i), first=2))
         end do
      end do
      table = new_table(columns=9, rows=rows%n, leading=3)
      if (rows%n == 0) return
      if (any(rows%tests(:rows%n) /= '')) call table%add_texts('tests_of', rows%tests(:rows%n))
      call table%add_texts('standard', standards(rows%standard(:rows%n)))
      call table%add_texts('side', side_names(rows%side(:rows%n)))
      call table%add_texts('quantity', rows%names(:rows%n))
      call table%add_texts('unit', rows%units(:rows%n))
      call table%add_codes('tests', column_counts, rows%counts(:rows%n))
      call table%add_numbers('mean', '-', rows%values(1, :rows%n), figures=figures)
      call table%add_numbers('coefficient_of_variation', '-', rows%values(2, :rows%n), &
         ratio_decimals)
      call table%add_numbers('fractile_5_percent', '-', rows%values(3, :rows%n), figures=figures)
   end function statistics_table

   !> The table of a standard.
   pure function table_of(report, standard) result(table)
      type(report_type), intent(in) :: report
      integer, intent(in) :: standard
      type(table_type) :: table

      select case (standard)
      case (1)
         table = report%summary
      case (2)
         table = report%table_of(en_12512)
      case default
         table = report%table_of(en_26891)
      end select
   end function table_of

   !> All quantities of a standard on each side.
   pure subroutine add_standard(rows, reports, repeats, standard, words)
      type(row_list), intent(inout) :: rows
      type(report_type), intent(in) :: reports(:)
      logical, intent(in) :: repeats(:)
      integer, intent(in) :: standard
      character(len=*), intent(in) :: words
      type(table_type) :: first, table
      real(wp) :: values(size(reports))
      integer :: i, column, row, side, n

      ! every table of the standard has the same columns
      first = table_of(reports(findloc(repeats, .true., 1)), standard)
      do side = 1, size(side_names)
         do column = 1, first%set
            if (first%columns(column)%kind /= column_numbers) cycle
            n = 0
            do i = 1, size(reports)
               if (.not. repeats(i)) cycle
               table = table_of(reports(i), standard)
               do row = 1, table%rows
                  if (table%columns(1)%texts(row)%text /= side_names(side)) cycle
                  if (is_none(table%columns(column)%values(row))) cycle
                  n = n + 1
                  values(n) = table%columns(column)%values(row)
               end do
            end do
            if (n > 1) call rows%add(words, standard, side, first%columns(column)%name, &
               first%columns(column)%unit, values(:n))
         end do
      end do
   end subroutine add_standard

   !> One row.
   pure subroutine add(self, words, standard, side, name, unit, values)
      class(row_list), intent(inout) :: self
      character(len=*), intent(in) :: words, name, unit
      integer, intent(in) :: standard, side
      real(wp), intent(in) :: values(:)
      real(wp) :: found(3)

      if (.not. allocated(self%names)) then
         allocate (self%tests(0), self%names(0), self%units(0), self%standard(0), self%side(0), &
            self%counts(0), self%values(3, 0))
      end if
      call characteristic_values(values, found(1), found(2), found(3))
      self%n = self%n + 1
      self%tests = [character(len=longest) :: self%tests, words]
      self%names = [character(len=longest) :: self%names, name]
      self%units = [character(len=longest) :: self%units, unit]
      self%standard = [self%standard, standard]
      self%side = [self%side, side]
      self%counts = [self%counts, size(values)]
      self%values = reshape([self%values, found], [3, self%n])
   end subroutine add

end module asperity_program_commands_hysteresis_statistics
