!> A table as aligned text: names over units over values.
module asperity_program_report_text_table
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_report_table, only: column_counts, column_numbers, column_type, &
      column_validity, table_type
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: add_table, print_column, printed_type, validity_mark

   !> Significant figures of the largest number of a column
   integer, parameter :: figures = 5
   !> Part of the largest number of a column below which another is no number
   real(wp), parameter :: round_off = 1.0e-12_wp

   !> A column as it is printed: heading lines, unit, cells, all of one width.
   type :: printed_type
      !> Lines of the heading, and one cell per row
      type(string_type), allocatable :: heading(:), cells(:)
      !> Unit, `-` for none
      character(len=:), allocatable :: unit
      !> Characters of the widest, and of the blanks before it
      integer :: width = 0, gap = 2
      !> Aligned to the left
      logical :: left = .false.
   end type printed_type

contains

   !> Append rows and columns of a table, in blocks of columns that fit a width. Every block begins
   !> with the leading columns.
   pure subroutine add_table(buffer, table, width, rows, columns)
      !> Where to append
      type(growing_text), intent(inout) :: buffer
      !> The table
      type(table_type), intent(in) :: table
      !> Characters of a line
      integer, intent(in) :: width
      !> Rows and columns to print
      integer, intent(in) :: rows(:), columns(:)
      type(printed_type) :: printed(size(columns))
      integer :: i, first, last, leading, narrow, wide

      do i = 1, size(columns)
         call print_column(table%columns(columns(i)), rows, printed(i))
      end do
      leading = min(table%leading, size(printed))
      ! as few blocks as the width allows, if need be by narrow gaps, and these about equally wide
      wide = blocks(printed, leading, width)
      printed%gap = 1
      if (blocks(printed, leading, width) == wide) printed%gap = 2
      do narrow = width, 2, -1
         if (blocks(printed, leading, narrow - 1) > blocks(printed, leading, width)) exit
      end do
      first = leading + 1
      do
         last = last_column(printed, leading, first, narrow)
         call add_block(buffer, printed([(i, i=1, leading), (i, i=first, last)]))
         if (last == size(printed)) return
         call buffer%line()
         first = last + 1
      end do
   end subroutine add_table

   !> How many blocks of a width columns take.
   pure integer function blocks(columns, leading, width)
      type(printed_type), intent(in) :: columns(:)
      integer, intent(in) :: leading, width
      integer :: last

      blocks = 0
      last = leading
      do
         blocks = blocks + 1
         last = last_column(columns, leading, last + 1, width)
         if (last == size(columns)) return
      end do
   end function blocks

   !> The last column that fits a width behind the leading ones and a first one, which always does.
   pure integer function last_column(columns, leading, first, width) result(last)
      type(printed_type), intent(in) :: columns(:)
      integer, intent(in) :: leading, first, width
      integer :: taken

      taken = sum(columns(:leading)%gap + columns(:leading)%width)
      do last = first, size(columns)
         taken = taken + columns(last)%gap + columns(last)%width
         if (taken > width .and. last > first) exit
      end do
      last = last - 1
   end function last_column

   !> Append columns side by side.
   pure subroutine add_block(buffer, columns)
      type(growing_text), intent(inout) :: buffer
      type(printed_type), intent(in) :: columns(:)
      integer :: heading, i

      heading = maxval([(size(columns(i)%heading), i=1, size(columns))])
      do i = 1, heading
         call add_line(buffer, columns, i - heading, 1)
      end do
      call add_line(buffer, columns, 0, 2)
      do i = 1, size(columns(1)%cells)
         call add_line(buffer, columns, i, 3)
      end do
   end subroutine add_block

   !> Letter of a validity flag in tables.
   pure character(len=1) function validity_mark(bit)
      !> Its bit, from zero
      integer, intent(in) :: bit

      validity_mark = achar(iachar('a') + bit)
   end function validity_mark

   !> A column as it is printed.
   pure subroutine print_column(column, rows, printed)
      !> The column
      type(column_type), intent(in) :: column
      !> Its rows to print
      integer, intent(in) :: rows(:)
      !> Its texts
      type(printed_type), intent(out) :: printed
      character(len=16) :: form
      integer :: i

      call split_name(column%name, printed%heading)
      printed%unit = column%unit
      printed%left = column%kind /= column_numbers .and. column%kind /= column_counts
      if (column%kind == column_numbers) form = number_format(column%name, column%values(rows))
      if (column%decimals >= 0) write (form, '(a, i0, a)') '(f32.', column%decimals, ')'
      allocate (printed%cells(size(rows)))
      do i = 1, size(rows)
         if (column%kind == column_numbers) then
            printed%cells(i)%text = number_text(column%values(rows(i)), form, column%figures)
         else if (column%kind == column_validity) then
            printed%cells(i)%text = marks(column%codes(rows(i)))
         else
            printed%cells(i)%text = column%cell(rows(i))
         end if
      end do
      printed%width = max(len(printed%unit), &
         maxval([(len(printed%heading(i)%text), i=1, size(printed%heading))]), &
         maxval([0, (len(printed%cells(i)%text), i=1, size(rows))]))
   end subroutine print_column

   !> Words of a name, one per heading line.
   pure subroutine split_name(name, words)
      character(len=*), intent(in) :: name
      type(string_type), allocatable, intent(out) :: words(:)
      integer :: i, first, length

      allocate (words(1 + count([(name(i:i) == '_', i=1, len(name))])))
      first = 1
      do i = 1, size(words)
         length = index(name(first:)//'_', '_') - 1
         words(i)%text = name(first:first + length - 1)
         first = first + length + 1
      end do
   end subroutine split_name

   !> Append one line: that of the headings which is `-i` lines above their last (part 1), the units
   !> (2) or row `i` (3).
   pure subroutine add_line(buffer, printed, i, part)
      type(growing_text), intent(inout) :: buffer
      type(printed_type), intent(in) :: printed(:)
      integer, intent(in) :: i, part
      character(len=:), allocatable :: line, text
      integer :: j

      line = ''
      do j = 1, size(printed)
         associate (p => printed(j))
            select case (part)
            case (1)
               text = ''
               if (size(p%heading) + i > 0) text = p%heading(size(p%heading) + i)%text
            case (2)
               text = p%unit
            case default
               text = p%cells(i)%text
            end select
            if (p%left) then
               line = line//repeat(' ', p%gap)//text//repeat(' ', p%width - len(text))
            else
               line = line//repeat(' ', p%gap + p%width - len(text))//text
            end if
         end associate
      end do
      call buffer%line(trim(line))
   end subroutine add_line

   !> Format of a column of numbers: fixed point if the smallest keeps two figures, else
   !> scientific. What is round-off beside the largest does not count. Shares always have four
   !> decimals.
   pure function number_format(name, values) result(form)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: values(:)
      character(len=16) :: form
      real(wp) :: largest, smallest
      integer :: decimals

      largest = maxval(abs(values), mask=.not. is_none(values))
      smallest = minval(abs(values), mask=abs(values) > round_off*largest &
         .and. .not. is_none(values))
      if (.not. largest > 0.0_wp) then
         form = '(f32.1)'
      else if (index(name, '_share') > 0) then
         form = '(f32.4)'
      else if (largest >= 1.0e100_wp .or. smallest < 1.0e-99_wp) then
         form = '(es32.3e3)'
      else
         decimals = max(1, figures - 1 - floor(log10(largest)))
         if (largest < 1.0e6_wp .and. decimals <= 6 &
            .and. smallest*10.0_wp**decimals >= 10.0_wp) then
            decimals = needed_decimals(pack(values, .not. is_none(values)), decimals)
            write (form, '(a, i0, a)') '(f32.', decimals, ')'
         else if (any(abs(values) > 0.0_wp .and. abs(values) < 1.0e-99_wp)) then
            ! round-off as well must show its exponent
            form = '(es32.3e3)'
         else
            form = '(es32.3)'
         end if
      end if
   end function number_format

   !> Decimals without zeros at the end of every value, at least one.
   pure integer function needed_decimals(values, most) result(decimals)
      real(wp), intent(in) :: values(:)
      integer, intent(in) :: most
      real(wp) :: scaled(size(values))

      do decimals = most, 2, -1
         scaled = abs(values)*10.0_wp**(decimals - 1)
         if (any(abs(scaled - anint(scaled)) > 1.0e-6_wp)) return
      end do
      decimals = min(most, 1)
   end function needed_decimals

   !> A number in a format, or of so many figures unless these are zero.
   pure function number_text(value, form, number_figures) result(text)
      real(wp), intent(in) :: value
      character(len=*), intent(in) :: form
      integer, intent(in) :: number_figures
      character(len=:), allocatable :: text
      character(len=32) :: buffer

      text = '-'
      if (is_none(value)) return
      if (number_figures > 0) then
         text = to_text(value, number_figures)
         return
      end if
      write (buffer, form) value
      text = trim(adjustl(buffer))
      ! what rounds to zero has no sign
      if (text(1:1) == '-' .and. verify(text(:scan(text//'E', 'E') - 1), '-0.') == 0) &
         text = text(2:)
   end function number_text

   !> Letters of the flags that are set, or `valid`.
   pure function marks(flags) result(text)
      integer, intent(in) :: flags
      character(len=:), allocatable :: text
      integer :: bit

      text = ''
      do bit = 0, bit_size(flags) - 2
         if (btest(flags, bit)) text = text//validity_mark(bit)
      end do
      if (text == '') text = 'valid'
   end function marks

end module asperity_program_report_text_table
