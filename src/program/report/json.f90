!> A report as JSON: input, units, one list per column. Never holds NaN or infinity: what has no
!> value is null.
module asperity_program_report_json
   use asperity_base_error, only: error_type
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_law_validity, only: validity_remark
   use asperity_program_input_key, only: key_type, kind_counts, kind_integer, kind_list, &
      kind_logical, kind_paths, kind_real
   use asperity_program_report_report, only: report_type
   use asperity_program_report_table, only: column_counts, column_numbers, column_type, &
      full_figures, new_table, table_type
   use asperity_program_system_strings, only: backslash, split_lines, string_type
   implicit none
   private
   public :: write_json

contains

   !> The report as JSON.
   pure subroutine write_json(report, text, error)
      !> The report
      type(report_type), intent(in) :: report
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: buffer
      integer :: i

      call buffer%line('{')
      call buffer%line('"asperity": '//json_string(version)//',')
      call buffer%line('"command": '//json_string(trim(report%name))//',')
      call buffer%line('"properties": {'//inputs(report, .true.)//'},')
      call buffer%line('"settings": {'//inputs(report, .false.)//'},')
      call buffer%line('"sources": {'//sources(report)//'},')
      if (allocated(report%record_kind)) &
         call buffer%line('"record_kind": '//json_string(report%record_kind)//',')
      call buffer%line('"units": {'//units(report)//'},')
      call buffer%line('"remarks": ['//remarks(report)//'],')
      if (allocated(report%verdict)) &
         call buffer%line('"verdict": '//json_string(joined(report%verdict))//',')
      if (report%summary%set > 0) then
         call buffer%line('"summary": {')
         call add_columns(buffer, report%summary)
         call buffer%line('},')
      end if
      if (allocated(report%more)) then
         do i = 1, size(report%more)
            if (report%more(i)%name == '') cycle
            call buffer%line(json_string(report%more(i)%name)//': {')
            call add_columns(buffer, report%more(i)%table)
            call buffer%line('},')
         end do
      end if
      call buffer%line('"data": {')
      call add_columns(buffer, report%table)
      call buffer%line('}')
      call buffer%line('}')
      call buffer%take(text, error)
   end subroutine write_json

   !> Lines as one text.
   pure function joined(lines) result(text)
      type(string_type), intent(in) :: lines(:)
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, size(lines)
         if (i > 1) text = text//' '
         text = text//lines(i)%text
      end do
   end function joined

   !> Members of the input object: properties, or settings of the test.
   pure function inputs(report, properties) result(text)
      type(report_type), intent(in) :: report
      logical, intent(in) :: properties
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input() .or. (key%is_property .neqv. properties)) cycle
            if (text /= '') text = text//', '
            text = text//json_string(trim(key%name))//': '//json_value(key)
         end associate
      end do
   end function inputs

   !> Where each value of the input comes from, such as `case.nml:4`, `--sigma` or `default`.
   pure function sources(report) result(text)
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input()) cycle
            if (text /= '') text = text//', '
            text = text//json_string(trim(key%name))//': '//json_string(key%source)
         end associate
      end do
   end function sources

   !> Units of columns and of input; one of the same name has the same unit.
   pure function units(report) result(text)
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      integer :: i

      text = ''
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input() .or. key%unit == '') cycle
            if (report%table%find(trim(key%name)) == 0) &
               call add_unit(text, trim(key%name), trim(key%unit))
         end associate
      end do
      call add_units(text, report%summary, report%table, .true.)
      if (allocated(report%more)) then
         do i = 1, size(report%more)
            if (report%more(i)%name /= '') &
               call add_units(text, report%more(i)%table, report%table, .false.)
         end do
      end if
      call add_units(text, report%table, new_table(0, 0), .false.)
   end function units

   !> Append the units of a table's numbers, or of all its columns, but of those that a later table
   !> or an earlier one has.
   pure subroutine add_units(text, table, later, all_kinds)
      character(len=:), allocatable, intent(inout) :: text
      type(table_type), intent(in) :: table, later
      logical, intent(in) :: all_kinds
      integer :: i

      do i = 1, table%set
         associate (column => table%columns(i))
            if (column%kind /= column_numbers .and. .not. all_kinds) cycle
            if (later%find(column%name) > 0) cycle
            if (index(text, json_string(column%name)//': ') == 0) &
               call add_unit(text, column%name, column%unit)
         end associate
      end do
   end subroutine add_units

   !> Append one member `"name": "unit"`.
   pure subroutine add_unit(text, name, unit)
      character(len=:), allocatable, intent(inout) :: text
      character(len=*), intent(in) :: name, unit

      if (text /= '') text = text//', '
      text = text//json_string(name)//': '//json_string(unit)
   end subroutine add_unit

   !> What the validity flags mean, and what else is to be said, one text each.
   pure function remarks(report) result(text)
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: text
      integer :: bit, flags, i

      text = ''
      flags = report%validity()
      do bit = 0, bit_size(flags) - 2
         if (.not. btest(flags, bit)) cycle
         if (text /= '') text = text//', '
         text = text//json_string(validity_remark(ibset(0, bit)))
      end do
      if (.not. allocated(report%remarks)) return
      do i = 1, size(report%remarks)
         if (text /= '') text = text//', '
         text = text//json_string(report%remarks(i)%text)
      end do
   end function remarks

   !> One line `"name": [...]` per column.
   pure subroutine add_columns(buffer, table)
      type(growing_text), intent(inout) :: buffer
      type(table_type), intent(in) :: table
      integer :: i, row

      do i = 1, table%set
         call buffer%add(json_string(table%columns(i)%name)//': [')
         do row = 1, table%rows
            if (row > 1) call buffer%add(', ')
            call buffer%add(json_cell(table%columns(i), row))
         end do
         call buffer%add(']')
         if (i < table%set) call buffer%add(',')
         call buffer%line()
      end do
   end subroutine add_columns

   !> One cell.
   pure function json_cell(column, row) result(text)
      type(column_type), intent(in) :: column
      integer, intent(in) :: row
      character(len=:), allocatable :: text

      text = column%cell(row)
      if (column%kind /= column_numbers .and. column%kind /= column_counts) text = json_string(text)
      if (text == '') text = 'null'
   end function json_cell

   !> Value of a key.
   pure function json_value(key) result(text)
      type(key_type), intent(in) :: key
      character(len=:), allocatable :: text
      type(growing_text) :: buffer
      type(string_type), allocatable :: paths(:)
      integer :: i

      select case (key%kind)
      case (kind_real)
         text = full_figures(key%values(1))
      case (kind_list, kind_counts)
         do i = 1, size(key%values)
            if (i > 1) call buffer%add(', ')
            call buffer%add(full_figures(key%values(i)))
         end do
         text = '['//buffer%text()//']'
      case (kind_paths)
         call split_lines(key%text, paths)
         do i = 1, size(paths)
            if (i > 1) call buffer%add(', ')
            call buffer%add(json_string(paths(i)%text))
         end do
         text = '['//buffer%text()//']'
      case (kind_integer)
         text = to_text(key%whole)
      case (kind_logical)
         text = trim(merge('true ', 'false', key%switch))
      case default
         text = json_string(key%text)
      end select
   end function json_value

   !> A text in quotes, marks and control characters escaped.
   pure function json_string(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: quoted
      character(len=2) :: code
      integer :: i

      quoted = '"'
      do i = 1, len(text)
         if (text(i:i) == '"' .or. text(i:i) == backslash) then
            quoted = quoted//backslash//text(i:i)
         else if (iachar(text(i:i)) < 32) then
            write (code, '(z2.2)') iachar(text(i:i))
            quoted = quoted//backslash//'u00'//code
         else
            quoted = quoted//text(i:i)
         end if
      end do
      quoted = quoted//'"'
   end function json_string

end module asperity_program_report_json
