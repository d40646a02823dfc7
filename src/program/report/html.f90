!> Pieces of a page in HTML: escaped text, tables, pictures in SVG.
module asperity_program_report_html
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_base_text_builder, only: growing_text
   use asperity_program_report_table, only: table_type
   use asperity_program_report_text_table, only: print_column, printed_type
   use asperity_program_system_strings, only: escaped, string_type
   use asperity_program_system_utf8, only: make_utf8
   implicit none
   private
   public :: html_text, add_html_table, joined_page

   character(len=*), parameter :: closing = '</svg>'

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
      class(growing_text), intent(inout) :: b
      !> The table
      type(table_type), intent(in) :: table
      !> Its caption
      character(len=*), intent(in) :: caption
      type(printed_type) :: columns(table%set)
      integer :: i, row

      call b%line('<div class="table"><table><caption>'//html_text(caption)//'</caption>')
      call b%add('<thead><tr>')
      do i = 1, size(columns)
         call print_column(table%columns(i), [(row, row=1, table%rows)], columns(i))
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
      call b%line('</tbody></table></div>')
   end subroutine add_html_table

   !> A page with its pictures. `error` is set if there are not as many as belong there.
   subroutine joined_page(parts, pictures, page, error)
      !> Text before each picture and after the last
      type(string_type), intent(in) :: parts(:)
      !> SVG documents of gnuplot, one after the other
      character(len=*), intent(in) :: pictures
      !> The page
      character(len=:), allocatable, intent(out) :: page
      !> Set when a picture is missing
      type(error_type), allocatable, intent(out) :: error
      type(growing_text) :: b
      integer :: first, last, place, i

      place = 1
      do i = 1, size(parts) - 1
         first = index(pictures(place:), '<svg')
         last = index(pictures(place:), closing)
         if (first == 0 .or. last == 0) exit
         call b%add(parts(i)%text)
         call b%add(own_names(pictures(place + first - 1:place + last + len(closing) - 2), i))
         place = place + last + len(closing) - 1
      end do
      if (i < size(parts) .or. index(pictures(place:), closing) > 0) then
         call fatal_error(error, 'gnuplot left out a picture')
         return
      end if
      call b%add(parts(i)%text)
      call b%take(page, error)
      if (.not. allocated(error)) call make_utf8(page, error)
   end subroutine joined_page

   !> A picture with names of its own, as two elements of a page must not share one.
   pure function own_names(picture, which) result(svg)
      character(len=*), intent(in) :: picture
      integer, intent(in) :: which
      character(len=:), allocatable :: svg
      character(len=:), allocatable :: own

      own = 'p'//to_text(which)//'_'
      svg = replaced(picture, "id='gp", "id='"//own//'gp')
      svg = replaced(svg, "href='#gp", "href='#"//own//'gp')
      svg = replaced(svg, "id='textbox'", "id='"//own//"textbox'")
      svg = replaced(svg, "id='greybox'", "id='"//own//"greybox'")
      svg = replaced(svg, 'id="gnuplot_canvas"', 'class="canvas"')
   end function own_names

   !> Text with every `old` replaced by `new`.
   pure function replaced(text, old, new) result(changed)
      character(len=*), intent(in) :: text, old, new
      character(len=:), allocatable :: changed
      type(growing_text) :: b
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
