!> A report as text for a terminal: header, table with units, remarks.
module asperity_program_report_terminal
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_base_version, only: version
   use asperity_law_validity, only: validity_remark
   use asperity_paper_pairs, only: find_pair, pair_preset
   use asperity_program_input_keys, only: belongs, command_names, command_pairs, command_surface, &
      keys, kind_file, kind_integer, kind_list, kind_logical, kind_real, n_keys
   use asperity_program_input_settings, only: settings_type
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: table_type
   use asperity_program_report_text_table, only: add_table, validity_mark
   use asperity_program_system_strings, only: newline
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: terminal_text, warning_text, input_text

   !> Evenly spaced rows that are shown: of one run, and of all
   integer, parameter :: fewest_rows = 6, most_rows = 21, all_rows = 33
   !> Column at which the source of a value starts
   integer, parameter :: source_column = 50
   !> Most columns of a further table that are shown
   integer, parameter :: most_columns = 20
   !> Most values of a list that are shown
   integer, parameter :: most_values = 6

contains

   !> The report as text.
   pure function terminal_text(report) result(text)
      !> The report
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      type(text_buffer) :: buffer
      integer :: i

      call buffer%line('asperity '//version//' '//command_names(report%command))
      call buffer%line()
      if (report%command /= command_pairs) then
         call add_inputs(buffer, report)
         call buffer%line()
      end if
      if (allocated(report%record_kind)) then
         call buffer%line('Record: '//report%record_kind)
         call buffer%line()
      end if
      if (report%summary%set > 0) then
         call add_table(buffer, report%summary)
         call buffer%line()
      end if
      if (allocated(report%more)) call add_more(buffer, report)
      if (report%shows_table) call add_main_table(buffer, report)
      if (report%table%find('validity') > 0) then
         call buffer%add(remark_lines(report))
      else
         call buffer%add(own_remarks(report, ''))
      end if
      if (allocated(report%verdict)) then
         do i = 1, size(report%verdict)
            call buffer%line(merge('Verdict: ', '         ', i == 1)//report%verdict(i)%text)
         end do
      end if
      if (report%table%find('note') > 0) call buffer%add(note_lines(report%table))
      text = buffer%text()
   end function terminal_text

   !> The further tables that have a title.
   pure subroutine add_more(buffer, report)
      type(text_buffer), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      character(len=32) :: names(most_columns)
      integer :: i, j

      do i = 1, size(report%more)
         if (report%more(i)%title == '') cycle
         call buffer%line(report%more(i)%title)
         associate (table => report%more(i)%table, &
               shown => min(report%more(i)%columns_shown, most_columns))
            if (shown == 0) then
               call add_table(buffer, table)
            else
               do j = 1, shown
                  names(j) = table%columns(j)%name
               end do
               call add_table(buffer, table, columns=names(:shown))
            end if
         end associate
         call buffer%line()
      end do
   end subroutine add_more

   !> The main table, or its most telling rows.
   pure subroutine add_main_table(buffer, report)
      type(text_buffer), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      integer, allocatable :: rows(:)
      integer :: runs

      runs = size(report%first_rows) - 1
      allocate (rows, source=report%selected_rows(max(fewest_rows, min(most_rows, all_rows/runs))))
      call add_table(buffer, report%table, rows, report%shown_columns)
      if (size(rows) < report%table%rows) call buffer%line(to_text(size(rows))//' of '// &
         to_text(report%table%rows)//' rows: evenly spaced ones and turning points; '// &
         'all of them with --csv FILE')
      if (allocated(report%shown_columns)) &
         call buffer%line('More columns with --csv FILE or --json FILE')
      call buffer%line()
   end subroutine add_main_table

   !> What the validity flags of the results mean, one line each, with the number of rows.
   pure function remark_lines(report) result(text)
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      integer :: bit, flags

      flags = report%validity()
      if (flags == 0) then
         text = 'Validity: '//report%valid_text()//newline//own_remarks(report, '')
         return
      end if
      text = 'Validity: results that pass a limit of the law are marked:'//newline
      do bit = 0, bit_size(flags) - 2
         if (btest(flags, bit)) text = text//'  '//validity_mark(bit)//'  '// &
            flag_text(report, bit)//newline
      end do
      text = text//own_remarks(report, '')
   end function remark_lines

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

   !> What else is to be said of the results, each line after some words.
   pure function own_remarks(report, before) result(text)
      type(report_type), intent(in) :: report
      character(len=*), intent(in) :: before
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      if (.not. allocated(report%remarks)) return
      do i = 1, size(report%remarks)
         text = text//before//report%remarks(i)%text//newline
      end do
   end function own_remarks

   !> The notes of a table with names and notes.
   pure function note_lines(table) result(text)
      type(table_type), intent(in) :: table
      character(len=:), allocatable :: text
      integer :: row

      text = ''
      do row = 1, table%rows
         text = text//table%columns(table%find('name'))%cell(row)//': '// &
            table%columns(table%find('note'))%cell(row)//newline
      end do
   end function note_lines

   !> The same as warnings for standard error, when the table is not shown.
   pure function warning_text(report) result(text)
      !> The report
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      integer :: bit, flags

      text = ''
      flags = report%validity()
      do bit = 0, bit_size(flags) - 2
         if (btest(flags, bit)) text = text//'asperity: warning: '// &
            flag_text(report, bit)//newline
      end do
      text = text//own_remarks(report, 'asperity: warning: ')
   end function warning_text

   !> Properties and settings: name, value, unit, where it comes from.
   pure subroutine add_inputs(buffer, report)
      type(text_buffer), intent(inout) :: buffer
      type(report_type), intent(in) :: report
      type(pair_preset) :: pair
      type(error_type), allocatable :: error
      character(len=:), allocatable :: left
      integer :: key

      left = ''
      associate (s => report%settings)
         do key = 1, n_keys
            if (.not. belongs(key, report%command) .or. keys(key)%kind >= kind_file) cycle
            if (.not. s%of(key)%has_value .or. s%of(key)%unused) cycle
            left = '  '//keys(key)%name//input_text(s, key)//' '//s%unit_of(key)
            call buffer%line(left//repeat(' ', max(1, source_column - len(left)))// &
               s%of(key)%source)
         end do
         ! a map replaces what the note is about
         if (s%text_of('pair') == '' .or. report%command == command_surface) return
         call find_pair(s%text_of('pair'), pair, error)
         if (.not. allocated(error)) call buffer%line('  Pair: '//trim(pair%note))
      end associate
   end subroutine add_inputs

   !> Value of a setting, long lists cut.
   pure function input_text(settings, key) result(text)
      !> Settings in effect
      type(settings_type), intent(in) :: settings
      !> Place of the key in the table
      integer, intent(in) :: key
      character(len=:), allocatable :: text
      integer :: i

      associate (setting => settings%of(key))
         select case (keys(key)%kind)
         case (kind_real, kind_list)
            if (size(setting%values) > most_values) then
               text = short(setting%values(1))//' ... '//short(setting%values(size( &
                  setting%values)))//' ('//to_text(size(setting%values))//' values)'
               return
            end if
            text = short(setting%values(1))
            do i = 2, size(setting%values)
               text = text//', '//short(setting%values(i))
            end do
         case (kind_integer)
            text = to_text(setting%whole)
         case (kind_logical)
            text = trim(merge('true ', 'false', setting%switch))
         case default
            text = setting%text
         end select
      end associate
   end function input_text

   pure function short(value) result(text)
      real(wp), intent(in) :: value
      character(len=:), allocatable :: text

      text = to_text(value, 6)
   end function short

end module asperity_program_report_terminal
