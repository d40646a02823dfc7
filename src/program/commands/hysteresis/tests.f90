!> Several tests in one report: their tables below each other, with what tells the tests apart in
!> front.
module asperity_program_commands_hysteresis_tests
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_commands_hysteresis_plot, only: skeleton_series
   use asperity_program_plot_figure, only: figure_type, panel_type
   use asperity_program_record_numbers, only: looks_like_number, read_number
   use asperity_program_record_conditions, only: test_text, test_type
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_numbers, column_texts, column_type, table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: join_reports, stacked

   !> Rows of a further table that the terminal shows, and tests whose envelopes have a legend
   integer, parameter :: most_rows = 60, most_named = 12

contains

   !> Make one report of those of several tests, two at least. The picture has the envelopes of all
   !> and the loops of each.
   pure subroutine join_reports(reports, tests, title, report)
      !> One report a test, of the same tables
      type(report_type), intent(inout) :: reports(:)
      !> The tests
      type(test_type), intent(in) :: tests(:)
      !> Title of the picture
      character(len=*), intent(in) :: title
      !> The joint report; its name and keys stay
      type(report_type), intent(inout) :: report
      type(string_type) :: line
      integer :: i, j

      reports(1)%name = report%name
      report = reports(1)
      report%table = stacked([(reports(i)%table, i=1, size(tests))], tests)
      report%summary = stacked([(reports(i)%summary, i=1, size(tests))], tests)
      do j = 1, size(report%more)
         report%more(j)%table = stacked([(reports(i)%more(j)%table, i=1, size(tests))], tests)
         do i = 2, size(tests)
            if (report%more(j)%title == '') report%more(j)%title = reports(i)%more(j)%title
         end do
         if (report%more(j)%table%rows > most_rows) report%more(j)%title = ''
      end do
      report%shown_columns = [character(len=len(report%shown_columns)) :: &
         (tests(1)%conditions(i)%name, i=1, size(tests(1)%conditions)), report%shown_columns]
      deallocate (report%first_rows, report%important)
      allocate (report%first_rows(size(tests) + 1), source=1)
      do i = 1, size(tests)
         report%first_rows(i + 1) = report%first_rows(i) + reports(i)%table%rows
      end do
      allocate (report%important, source=[(reports(i)%important, i=1, size(tests))])
      ! one kind if all are of it, else a list
      if (any([(reports(i)%record_kind /= report%record_kind, i=1, size(tests))])) then
         do i = 2, size(tests)
            report%record_kind = report%record_kind//', '//reports(i)%record_kind
         end do
      end if
      if (report%is_drawn()) then
         report%picture_title = title
         deallocate (report%pictures)
         allocate (report%pictures(size(tests) + 1))
         report%pictures(1) = figure_type('Envelopes of all tests', &
            [envelopes_panel(reports, tests)])
         do i = 1, size(tests)
            report%pictures(i + 1)%caption = test_text(tests(i))
            call move_alloc(reports(i)%pictures(1)%panels, report%pictures(i + 1)%panels)
         end do
      end if
      if (allocated(report%remarks)) deallocate (report%remarks)
      allocate (report%remarks(0))
      do i = 1, size(tests)
         if (.not. allocated(reports(i)%remarks)) cycle
         do j = 1, size(reports(i)%remarks)
            line%text = test_text(tests(i))//': '//reports(i)%remarks(j)%text
            report%remarks = [report%remarks, line]
         end do
      end do
   end subroutine join_reports

   !> The skeletons of all tests.
   pure function envelopes_panel(reports, tests) result(panel)
      type(report_type), intent(in) :: reports(:)
      type(test_type), intent(in) :: tests(:)
      type(panel_type) :: panel
      character(len=:), allocatable :: legend
      integer :: i

      associate (first => reports(1)%pictures(1)%panels(1))
         panel = panel_type(first%x%label, first%y%label, 'envelopes')
      end associate
      do i = 1, size(tests)
         legend = ''
         if (size(tests) <= most_named) legend = test_text(tests(i))
         associate (skeleton => reports(i)%pictures(1)%panels(1)%series(skeleton_series))
            call panel%add(skeleton%x, skeleton%y, legend, i)
         end associate
      end do
   end function envelopes_panel

   !> Tables of the same columns below each other, the tests' conditions in front.
   pure function stacked(tables, tests) result(table)
      !> The tables
      type(table_type), intent(in) :: tables(:)
      !> The tests
      type(test_type), intent(in) :: tests(:)
      type(table_type) :: table
      integer :: i, j, n

      n = size(tests(1)%conditions)
      table%rows = sum(tables%rows)
      table%set = n + tables(1)%set
      table%leading = n + tables(1)%leading
      allocate (table%columns(table%set))
      do i = 1, n
         table%columns(i) = condition_column(i, tests, tables%rows)
      end do
      do i = 1, tables(1)%set
         associate (column => table%columns(n + i))
            column = tables(1)%columns(i)
            do j = 2, size(tables)
               call append(column, tables(j)%columns(i))
            end do
         end associate
      end do
   end function stacked

   !> Append the cells of a column to another of its kind.
   pure subroutine append(column, other)
      type(column_type), intent(inout) :: column
      type(column_type), intent(in) :: other

      if (allocated(column%values)) column%values = [column%values, other%values]
      if (allocated(column%codes)) column%codes = [column%codes, other%codes]
      if (allocated(column%texts)) column%texts = [column%texts, other%texts]
   end subroutine append

   !> What all rows of each test have in a column of the file.
   pure function condition_column(which, tests, rows) result(column)
      integer, intent(in) :: which, rows(:)
      type(test_type), intent(in) :: tests(:)
      type(column_type) :: column
      type(error_type), allocatable :: error
      real(wp) :: values(size(tests))
      integer :: i, j

      associate (first => tests(1)%conditions(which))
         column%name = first%name
         column%unit = '-'
         if (first%unit /= '') column%unit = first%unit
         column%kind = column_numbers
         do i = 1, size(tests)
            associate (value => tests(i)%conditions(which)%value)
               values(i) = 0.0_wp
               if (.not. looks_like_number(value)) column%kind = column_texts
               if (column%kind == column_texts) exit
               call read_number(value, 'comma', values(i), error)
               if (allocated(error)) column%kind = column_texts
               if (allocated(error)) exit
            end associate
         end do
      end associate
      if (column%kind == column_numbers) then
         allocate (column%values, source=[((values(i), j=1, rows(i)), i=1, size(tests))])
      else
         allocate (column%texts(sum(rows)))
         do i = 1, size(tests)
            do j = sum(rows(:i - 1)) + 1, sum(rows(:i))
               column%texts(j)%text = tests(i)%conditions(which)%value
            end do
         end do
      end if
   end function condition_column

end module asperity_program_commands_hysteresis_tests
