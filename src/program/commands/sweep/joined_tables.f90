!> Tables of the cases of a sweep as one, each row led by the values of its case.
module asperity_program_commands_sweep_joined_tables
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_program_commands_sweep_cases, only: axis_type
   use asperity_program_commands_sweep_columns, only: add_axes
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_table, only: column_numbers, column_texts, column_type, new_table, &
      table_type
   implicit none
   private
   public :: join_tables

contains

   !> Join tables; one that lacks a column of another has no values there. `error` is set when a
   !> column has several units.
   subroutine join_tables(table, keys, axes, parts, error)
      !> All rows
      type(table_type), intent(out) :: table
      !> The keys
      type(key_list), intent(in) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> The table of each case
      type(table_type), intent(in) :: parts(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer, allocatable :: which(:)
      integer :: i, j, place

      allocate (which(sum(parts%rows)))
      j = 0
      do i = 1, size(parts)
         which(j + 1:j + parts(i)%rows) = i
         j = j + parts(i)%rows
      end do
      associate (widest => parts(maxloc(parts%set, 1)))
         table = new_table(columns=size(axes) + widest%set, rows=size(which), &
            leading=size(axes) + widest%leading)
         call add_axes(table, keys, axes, which)
         do j = 1, widest%set
            do i = 1, size(parts)
               place = parts(i)%find(widest%columns(j)%name)
               if (place == 0) cycle
               if (parts(i)%columns(place)%unit == widest%columns(j)%unit) cycle
               call fatal_error(error, '--sweep: '//widest%columns(j)%name//' is in '// &
                  parts(i)%columns(place)%unit//' in some cases and in '// &
                  widest%columns(j)%unit//' in others; sweep them one by one')
               return
            end do
            call add_column(table, parts, widest%columns(j))
         end do
      end associate
   end subroutine join_tables

   !> One column of all tables.
   pure subroutine add_column(table, parts, like)
      type(table_type), intent(inout) :: table
      type(table_type), intent(in) :: parts(:)
      type(column_type), intent(in) :: like
      real(wp) :: values(table%rows)
      integer :: codes(table%rows), first, i, place, row
      character(len=80) :: texts(table%rows)

      values = none
      codes = 0
      texts = ''
      first = 0
      do i = 1, size(parts)
         place = parts(i)%find(like%name)
         if (place > 0) then
            associate (column => parts(i)%columns(place), last => first + parts(i)%rows)
               select case (like%kind)
               case (column_numbers)
                  values(first + 1:last) = column%values
               case (column_texts)
                  do row = 1, parts(i)%rows
                     texts(first + row) = column%texts(row)%text
                  end do
               case default
                  codes(first + 1:last) = column%codes
               end select
            end associate
         end if
         first = first + parts(i)%rows
      end do
      select case (like%kind)
      case (column_numbers)
         call table%add_numbers(like%name, like%unit, values, like%decimals, like%figures)
      case (column_texts)
         call table%add_texts(like%name, texts)
      case default
         call table%add_codes(like%name, like%kind, codes)
      end select
   end subroutine add_column

end module asperity_program_commands_sweep_joined_tables
