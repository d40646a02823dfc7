!> Which columns of a record were taken, as a table.
module asperity_program_record_table
   use asperity_program_record_columns, only: record_column
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: columns_table

   integer, parameter :: longest = 80

contains

   !> One row a column: what it holds, its number, name and unit, and why it was taken.
   pure function columns_table(columns) result(table)
      !> The columns
      type(record_column), intent(in) :: columns(:)
      type(table_type) :: table
      character(len=longest), dimension(size(columns)) :: quantity, name, unit, chosen_by
      integer :: i

      do i = 1, size(columns)
         quantity(i) = columns(i)%name
         name(i) = shown(columns(i)%heading)
         unit(i) = shown(columns(i)%unit)
         chosen_by(i) = columns(i)%chosen_by
      end do
      table = new_table(columns=5, rows=size(columns))
      call table%add_texts('quantity', quantity)
      call table%add_codes('column', column_counts, (columns%place))
      call table%add_texts('heading', name)
      call table%add_texts('unit', unit)
      call table%add_texts('chosen_by', chosen_by)
   end function columns_table

   !> A text, `-` for none.
   pure function shown(text)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: shown

      shown = text
      if (text == '') shown = '-'
   end function shown

end module asperity_program_record_table
