!> Pieces of a page: head, pictures, input, remarks.
module asperity_program_report_page
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_law_validity, only: validity_remark
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_html, only: add_html_table, html_text
   use asperity_program_report_report, only: report_type
   use asperity_program_report_terminal, only: input_text
   use asperity_program_system_environment, only: command_text, time_text
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: origin_type, add_head, add_list, add_remarks, add_pictures, add_case, end_page

   !> Where the default of a key comes from.
   type :: origin_type
      !> Name of the key
      character(len=24) :: key
      !> What its source says, or why the value was chosen
      character(len=150) :: words
   end type origin_type

contains

   !> Everything before the first table.
   subroutine add_head(b, report, title)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The report
      type(report_type), intent(in) :: report
      !> What the page is about
      character(len=*), intent(in) :: title

      call b%line('<!DOCTYPE html>')
      call b%line('<html lang="en"><head><meta charset="utf-8">')
      call b%line('<meta name="viewport" content="width=device-width, initial-scale=1">')
      call b%line('<title>asperity: '//html_text(trim(report%name))//'</title>')
      call b%line('<style>')
      call b%line('body { font: 15px/1.45 sans-serif; color: #1a1a1a; background: #fff; '// &
         'max-width: 1060px; margin: 2em auto; padding: 0 1em }')
      call b%line('h1 { font-size: 1.6em; margin: 0 } '// &
         'h2 { font-size: 1.2em; margin: 1.6em 0 .5em; border-bottom: 1px solid #bbb }')
      call b%line('.sub { color: #555 } .unit { color: #555; font-weight: normal }')
      call b%line('code { overflow-wrap: anywhere } .table { overflow-x: auto }')
      call b%line('table { border-collapse: collapse; margin: .8em 0 1.2em; font-size: .9em; '// &
         'font-variant-numeric: tabular-nums }')
      call b%line('caption { text-align: left; color: #555; padding-bottom: .3em }')
      call b%line('th, td { padding: .15em .7em .15em 0; text-align: right; vertical-align: top }')
      call b%line('th { border-bottom: 1px solid #555; vertical-align: bottom } '// &
         'tbody tr:nth-child(even) { background: #f4f4f4 }')
      call b%line('td.text, th:first-child { text-align: left }')
      call b%line('.case th { text-align: left } '// &
         '.case td:nth-child(-n+2) { white-space: nowrap } li { margin: .3em 0 }')
      call b%line('.pictures { display: grid; grid-template-columns: 1fr 1fr; gap: 1em }')
      call b%line('figure { margin: 0; break-inside: avoid } figure.wide { grid-column: 1 / 3 }')
      call b%line('figure svg { width: 100%; height: auto } '// &
         'figcaption { font-size: .9em; color: #333 }')
      call b%line('.sketch svg { max-width: 800px }')
      call b%line('@media (max-width: 700px) { .pictures { display: block } }')
      call b%line('@page { margin: 15mm }')
      call b%line('@media print { body { font-size: 9.5pt; max-width: none; margin: 0; '// &
         'padding: 0 } .table { overflow: visible } h2 { break-after: avoid } '// &
         'tr, li { break-inside: avoid } thead { display: table-header-group } }')
      call b%line('</style></head><body>')
      call b%line('<h1>'//html_text(title)//'</h1>')
      call b%line('<p class="sub">')
      if (allocated(report%faces)) &
         call b%line('Faces: '//html_text(report%faces)//'.<br>')
      if (allocated(report%record_kind)) &
         call b%line('Record: '//html_text(report%record_kind)//'.<br>')
      call b%line('Made on '//time_text()//' by asperity '//version//': <code>'// &
         html_text(command_text())//'</code></p>')
      call b%line('<h2>Result</h2>')
   end subroutine add_head

   !> A list of sentences.
   pure subroutine add_list(b, items)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The sentences
      character(len=*), intent(in) :: items(:)
      integer :: i

      call b%line('<ul>')
      do i = 1, size(items)
         call b%line('<li>'//html_text(trim(items(i)))//'</li>')
      end do
      call b%line('</ul>')
   end subroutine add_list

   !> Limits of the law that are passed, and other warnings.
   pure subroutine add_remarks(b, report)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The report
      type(report_type), intent(in) :: report
      integer :: bit, i

      call b%line('<ul>')
      if (report%table%find('validity') > 0 .and. report%validity() == 0) &
         call b%line('<li>Validity: '//html_text(report%valid_text())//'</li>')
      do bit = 0, bit_size(bit) - 2
         if (btest(report%validity(), bit)) call b%line('<li>Past a limit of the law: '// &
            html_text(validity_remark(ibset(0, bit)))//'</li>')
      end do
      if (allocated(report%remarks)) then
         do i = 1, size(report%remarks)
            call b%line('<li>'//html_text(report%remarks(i)%text)//'</li>')
         end do
      end if
      call b%line('</ul>')
   end subroutine add_remarks

   !> Pictures with their captions: a page is cut where they go.
   pure subroutine add_pictures(b, report, parts)
      !> Where to append; what is there becomes the first part
      type(growing_text), intent(inout) :: b
      !> The report
      type(report_type), intent(in) :: report
      !> Text before each picture; the one after the last is not set
      type(string_type), intent(inout) :: parts(:)
      integer :: i

      call b%line('<h2>Pictures</h2>')
      call b%line('<div class="pictures">')
      do i = 1, size(report%pictures)
         call b%add('<figure')
         if (size(report%pictures(i)%panels) > 1) call b%add(' class="wide"')
         call b%add('>')
         parts(i)%text = b%text()
         b = growing_text()
         call b%line('<figcaption>'//html_text(report%pictures(i)%caption)// &
            '</figcaption></figure>')
      end do
      call b%line('</div>')
   end subroutine add_pictures

   !> Every key: value, unit, meaning, and where the value comes from.
   pure subroutine add_case(b, report, usual, origins)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The report, whose keys they are
      type(report_type), intent(in) :: report
      !> The same keys of a case that is given nothing
      type(key_list), intent(in) :: usual
      !> Where the defaults come from
      type(origin_type), intent(in) :: origins(:)
      character(len=:), allocatable :: origin, usual_origin
      integer :: i, place

      call b%add('<div class="table"><table class="case"><caption>Input')
      if (report%keys%find('print_case') > 0) call b%add('; asperity '//trim(report%name)// &
         ' --print-case writes it as a case file')
      call b%line('</caption>')
      call b%line('<thead><tr><th>key</th><th>value</th><th>what it is</th><th>where the value '// &
         'comes from</th></tr></thead><tbody>')
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input()) cycle
            origin = key%source
            place = usual%find(trim(key%name))
            ! Who writes a default into a case file has chosen it for the same reason
            usual_origin = origin_of(origins, trim(key%name))
            if (usual_origin /= '' .and. input_text(key) == input_text(usual%rows(place))) then
               if (origin == 'default') origin = ''
               if (origin /= '') origin = origin//'; '
               origin = origin//usual_origin
            end if
            call b%line('<tr>'//cell(trim(key%name))// &
               cell(trim(input_text(key, whole=.true.)//' '//trim(key%unit)))// &
               cell(trim(key%help))//cell(origin)//'</tr>')
         end associate
      end do
      call b%line('</tbody></table></div>')
   end subroutine add_case

   !> Where the default of a key comes from, empty when there is nothing to say.
   pure function origin_of(origins, key) result(words)
      type(origin_type), intent(in) :: origins(:)
      character(len=*), intent(in) :: key
      character(len=:), allocatable :: words
      integer :: i

      words = ''
      do i = 1, size(origins)
         if (origins(i)%key == key) words = trim(origins(i)%words)
      end do
   end function origin_of

   !> A note, and the end.
   pure subroutine end_page(b, note)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The note
      character(len=*), intent(in) :: note

      call b%line('<p class="sub">'//html_text(note)//'</p>')
      call b%line('</body></html>')
   end subroutine end_page

   !> A cell of text.
   pure function cell(text) result(html)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: html

      html = '<td class="text">'//html_text(text)//'</td>'
   end function cell

end module asperity_program_report_page
