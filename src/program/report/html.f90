!> Pieces of a page in HTML: escaped text, tables, pictures in SVG.
module asperity_program_report_html
   use asperity_program_report_table, only: table_type
   use asperity_program_report_text_table, only: printed_type, printed_columns
   use asperity_program_system_strings, only: escaped
   use asperity_program_system_text_buffer, only: text_buffer
   implicit none
   private
   public :: html_text, add_html_table, split_svg, count_svg

   character(len=*), parameter :: opening = '<svg', closing = '</svg>'

contains

   !> A text with the marks of HTML escaped.
   pure function html_text(text) result(html)
      !> Any text
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: html

      html = escaped(escaped(escaped(escaped(text, '&', '&amp;'), '<', '&lt;'), '>', '&gt;'), &
         '"', '&quot;')
   end function html_text

   !> Append a table: names over units over values, as on the terminal.
   pure subroutine add_html_table(b, table, caption)
      !> Where to append
      type(text_buffer), intent(inout) :: b
      !> The table
      type(table_type), intent(in) :: table
      !> Its caption
      character(len=*), intent(in) :: caption
      type(printed_type) :: columns(table%set)
      integer :: i, row

      call printed_columns(table, columns)
      call b%line('<table><caption>'//html_text(caption)//'</caption>')
      call b%add('<thead><tr>')
      do i = 1, size(columns)
         call b%add('<th>'//html_text(escaped(table%columns(i)%name, '_', ' ')))
         if (columns(i)%unit /= '-') &
            call b%add('<br><span class="unit">'//html_text(columns(i)%unit)//'</span>')
         call b%add('</th>')
      end do
      call b%line('</tr></thead><tbody>')
      do row = 1, table%rows
         call b%add('<tr>')
         do i = 1, size(columns)
            call b%add(trim(merge('<td class="text">', '<td>             ', columns(i)%left))// &
               html_text(columns(i)%cells(row)%text)//'</td>')
         end do
         call b%line('</tr>')
      end do
      call b%line('</tbody></table>')
   end subroutine add_html_table

   !> How many pictures stand one after the other in a text.
   pure integer function count_svg(text)
      !> SVG documents
      character(len=*), intent(in) :: text
      integer :: place, found

      count_svg = 0
      place = 1
      do
         found = index(text(place:), closing)
         if (found == 0) return
         count_svg = count_svg + 1
         place = place + found
      end do
   end function count_svg

   !> One of the pictures of a text as an element of a page: without the head of a document, and
   !> with names of its own, as two elements of a page must not share one.
   pure function split_svg(text, which) result(svg)
      !> SVG documents of gnuplot
      character(len=*), intent(in) :: text
      !> Which of them, from 1
      integer, intent(in) :: which
      character(len=:), allocatable :: svg
      character(len=:), allocatable :: own
      integer :: place, first, last, i

      svg = ''
      first = 1
      last = 0
      place = 1
      do i = 1, which
         first = index(text(place:), opening)
         last = index(text(place:), closing)
         if (first == 0 .or. last == 0) return
         first = place + first - 1
         last = place + last - 1 + len(closing) - 1
         place = last + 1
      end do
      own = 'p'//achar(iachar('0') + which)//'_'
      svg = replaced(text(first:last), "id='gp", "id='"//own//'gp')
      svg = replaced(svg, "href='#gp", "href='#"//own//'gp')
      svg = replaced(svg, "id='textbox'", "id='"//own//"textbox'")
      svg = replaced(svg, "id='greybox'", "id='"//own//"greybox'")
      svg = replaced(svg, 'id="gnuplot_canvas"', 'class="canvas"')
   end function split_svg

   !> Text with every `old` replaced by `new`.
   pure function replaced(text, old, new) result(changed)
      character(len=*), intent(in) :: text, old, new
      character(len=:), allocatable :: changed
      type(text_buffer) :: b
      integer :: place, found

      place = 1
      do
         found = index(text(place:), old)
         if (found == 0) exit
         call b%add(text(place:place + found - 2)//new)
         place = place + found - 1 + len(old)
      end do
      call b%add(text(place:))
      changed = b%text()
   end function replaced

end module asperity_program_report_html
