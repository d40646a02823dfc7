!> A report as text for a terminal: header, table with units, remarks.
module asperity_program_report_terminal
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_law_validity, only: validity_remark
   use asperity_program_input_key, only: key_type, kind_counts, kind_integer, kind_list, &
      kind_logical, kind_paths, kind_real
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: table_type
   use asperity_program_report_text_table, only: add_table, validity_mark
   use asperity_program_system_strings, only: escaped, newline, wrapped
   implicit none
   private
   public :: terminal_text, warning_text, input_text

   !> Evenly spaced rows that are shown: of one run, and of all
   integer, parameter :: fewest_rows = 6, most_rows = 21, all_rows = 33
   !> Columns before a value, and before its source unless that is long
   integer, parameter :: value_column = 26, source_column = 50
   !> Part of a value that computing it may have added
   real(wp), parameter :: rounding = 1.0e-12_wp
   !> Most values of a list that are shown
   integer, parameter :: most_values = 6

contains

   !> The report as text.
   pure function terminal_text(report, width) result(text)
      !> The report
      type(report_type), intent(in) :: report
      !> Characters of a line
      integer, intent(in) :: width
      character(len=:), allocatable :: text
      type(growing_text) :: buffer
      integer :: i

      call buffer%line('asperity '//version//' '//trim(report%name))
      call buffer%line()
      call add_inputs(buffer, report, width)
      if (allocated(report%record_kind)) then
         call buffer%line(wrapped('Record: '//report%record_kind, width, 8))
         call buffer%line()
      end if
      if (report%summary%set > 0) then
         call add_table(buffer, report%summary, width, all_of(report%summary%rows), &
            all_of(report%summary%set))
         call buffer%line()
      end if
      if (allocated(report%more)) call add_more(buffer, report, width)
      if (report%shows_table) call add_main_table(buffer, report, width)
      if (allocated(report%paragraphs)) then
         do i = 1, size(report%paragraphs)
            call buffer%line(wrapped(report%paragraphs(i)%text, width, report%paragraph_indent))
         end do
         if (size(report%paragraphs) > 0) call buffer%line()
      end if
      if (report%table%find('validity') > 0) then
         call add_validity(buffer, report, width)
      end if
      if (allocated(report%remarks)) then
         do i = 1, size(report%remarks)
            call buffer%line(wrapped(report%remarks(i)%text, width, 2))
         end do
      end if
      if (allocated(report%verdict)) then
         do i = 1, size(report%verdict)
            call buffer%line(wrapped(merge('Verdict: ', '         ', i == 1)// &
               report%verdict(i)%text, width, 9))
         end do
      end if
      if (report%table%find('note') > 0) call add_notes(buffer, report%table, width)
      text = buffer%text()
   end function terminal_text

   !> The further tables that have a title.
   pure subroutine add_more(buffer, report, width)
      type(growing_text), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      integer, intent(in) :: width
      integer :: i

      do i = 1, size(report%more)
         if (report%more(i)%title == '') cycle
         call buffer%line(wrapped(report%more(i)%title, width, 0))
         associate (table => report%more(i)%table, shown => merge(report%more(i)%columns_shown, &
               report%more(i)%table%set, report%more(i)%columns_shown > 0))
            call add_table(buffer, table, width, all_of(table%rows), all_of(shown))
         end associate
         call buffer%line()
      end do
   end subroutine add_more

   !> 1, 2, ...
   pure function all_of(number) result(places)
      integer, intent(in) :: number
      integer :: places(number)
      integer :: i

      places = [(i, i=1, number)]
   end function all_of

   !> The main table, or its most telling rows.
   pure subroutine add_main_table(buffer, report, width)
      type(growing_text), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      integer, intent(in) :: width
      integer, allocatable :: columns(:), rows(:)
      integer :: i, runs

      allocate (columns, source=all_of(report%table%set))
      if (allocated(report%shown_columns)) columns = [(report%table%find(trim( &
         report%shown_columns(i))), i=1, size(report%shown_columns))]
      runs = size(report%first_rows) - 1
      allocate (rows, source=report%selected_rows(max(fewest_rows, min(most_rows, all_rows/runs))))
      call add_table(buffer, report%table, width, rows, columns)
      if (size(rows) < report%table%rows) call buffer%line(wrapped(to_text(size(rows))// &
         ' of '//to_text(report%table%rows)//' rows: evenly spaced ones and turning points; '// &
         'all of them with --csv FILE', width, 0))
      if (allocated(report%shown_columns)) &
         call buffer%line('More columns with --csv FILE or --json FILE')
      call buffer%line()
   end subroutine add_main_table

   !> What the validity flags of the results mean, each with the number of rows.
   pure subroutine add_validity(buffer, report, width)
      type(growing_text), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      integer, intent(in) :: width
      integer :: bit, flags

      flags = report%validity()
      if (flags == 0) then
         call buffer%line(wrapped('Validity: '//report%valid_text(), width, 2))
         return
      end if
      call buffer%line('Validity: results that pass a limit of the law are marked:')
      do bit = 0, bit_size(flags) - 2
         if (btest(flags, bit)) call buffer%line(wrapped('  '//validity_mark(bit)//'  '// &
            flag_text(report, bit), width, 5))
      end do
   end subroutine add_validity

   !> What a validity flag means, and in how many rows it is set.
   pure function flag_text(report, bit) result(text)
      type(report_type), intent(in) :: report
      integer, intent(in) :: bit
      character(len=:), allocatable :: text

      associate (codes => report%table%columns(report%table%find('validity'))%codes)
         text = validity_remark(ibset(0, bit))//' ('//to_text(count(btest(codes, bit)))//' of '// &
            to_text(report%table%rows)//' rows, the first is row '// &
            to_text(findloc(btest(codes, bit), .true., dim=1))//')'
      end associate
   end function flag_text

   !> The notes of a table with names and notes.
   pure subroutine add_notes(buffer, table, width)
      type(growing_text), intent(inout) :: buffer
      type(table_type), intent(in) :: table
      integer, intent(in) :: width
      integer :: row

      do row = 1, table%rows
         call buffer%line(wrapped(table%columns(table%find('name'))%cell(row)//': '// &
            table%columns(table%find('note'))%cell(row), width, 2))
      end do
   end subroutine add_notes

   !> The same as warnings for standard error, when the table is not shown.
   pure function warning_text(report) result(text)
      !> The report
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      character(len=*), parameter :: warning = 'asperity: warning: '
      integer :: bit, flags, i

      text = ''
      flags = report%validity()
      do bit = 0, bit_size(flags) - 2
         if (btest(flags, bit)) text = text//warning//flag_text(report, bit)//newline
      end do
      if (.not. allocated(report%remarks)) return
      do i = 1, size(report%remarks)
         text = text//warning//report%remarks(i)%text//newline
      end do
   end function warning_text

   !> Properties and settings: name, value, unit, where it comes from.
   pure subroutine add_inputs(buffer, report, width)
      type(growing_text), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      integer, intent(in) :: width
      character(len=:), allocatable :: left
      integer :: i, column

      left = ''
      column = source_column
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (key%is_input()) column = min(column, width - len(key%source))
         end associate
      end do
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input()) cycle
            left = '  '//trim(key%name)// &
               repeat(' ', max(1, value_column - 2 - len_trim(key%name)))// &
               input_text(key)//' '//trim(key%unit)
            call buffer%line(wrapped(left//repeat(' ', max(1, column - len(left)))// &
               key%source, width, value_column))
         end associate
      end do
      if (allocated(report%keys%note)) &
         call buffer%line(wrapped('  '//report%keys%note, width, 4))
      if (left /= '') call buffer%line()
   end subroutine add_inputs

   !> Value of a key: long lists are cut and numbers have six figures, unless wanted whole.
   pure function input_text(key, whole) result(text)
      !> The key
      type(key_type), intent(in) :: key
      !> Every value of a list, and every figure of a number; not when absent
      logical, intent(in), optional :: whole
      character(len=:), allocatable :: text
      logical :: cut
      integer :: i, n

      cut = .true.
      if (present(whole)) cut = .not. whole
      select case (key%kind)
      case (kind_real, kind_list, kind_counts)
         n = size(key%values)
         if (cut .and. n > most_values) then
            text = short(key%values(1), cut)//' ... '//short(key%values(n), cut)//' ('// &
               to_text(n)//' values)'
            return
         end if
         text = short(key%values(1), cut)
         do i = 2, n
            text = text//', '//short(key%values(i), cut)
         end do
      case (kind_paths)
         text = escaped(key%text, newline, ', ')
      case (kind_integer)
         text = to_text(key%whole)
      case (kind_logical)
         text = trim(merge('true ', 'false', key%switch))
      case default
         text = key%text
      end select
   end function input_text

   !> A number of six figures; all that it has, but for rounding, where it is not cut.
   pure function short(value, cut) result(text)
      real(wp), intent(in) :: value
      logical, intent(in) :: cut
      character(len=:), allocatable :: text
      real(wp) :: rounded

      text = to_text(value, 6)
      if (cut) return
      read (text, *) rounded
      if (abs(rounded - value) > rounding*abs(value)) text = to_text(value)
   end function short

end module asperity_program_report_terminal
