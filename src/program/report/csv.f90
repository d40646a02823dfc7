!> A table as CSV: one line of column names with units, one line per row, numbers with 17 figures.
module asperity_program_report_csv
   use asperity_base_error, only: error_type
   use asperity_base_text_builder, only: growing_text
   use asperity_program_report_table, only: column_texts, column_type, table_type
   use asperity_program_system_strings, only: escaped, newline
   implicit none
   private
   public :: write_csv

contains

   !> The table as CSV.
   pure subroutine write_csv(table, text, error)
      !> The table
      type(table_type), intent(in) :: table
      !> The text
      character(len=:), allocatable, intent(out) :: text
      !> Set when there is not enough memory for it
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: buffer
      integer :: i, row

      do i = 1, table%set
         if (i > 1) call buffer%add(',')
         call buffer%add(in_quotes(heading(table%columns(i))))
      end do
      call buffer%line()
      do row = 1, table%rows
         do i = 1, table%set
            if (i > 1) call buffer%add(',')
            if (table%columns(i)%kind == column_texts) then
               call buffer%add(in_quotes(table%columns(i)%cell(row)))
            else
               call buffer%add(table%columns(i)%cell(row))
            end if
         end do
         call buffer%line()
      end do
      call buffer%take(text, error)
   end subroutine write_csv

   !> `name (unit)`, the name alone where there is no unit.
   pure function heading(column) result(text)
      type(column_type), intent(in) :: column
      character(len=:), allocatable :: text

      text = column%name
      if (column%unit /= '-') text = text//' ('//column%unit//')'
   end function heading

   !> A text in quotes if it needs them.
   pure function in_quotes(text) result(quoted)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: quoted

      quoted = text
      if (scan(text, ',"'//newline) > 0) quoted = '"'//escaped(text, '"', '""')//'"'
   end function in_quotes

end module asperity_program_report_csv
