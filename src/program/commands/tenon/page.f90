!> The page that `asperity tenon --report` writes: case, assumptions, tables and pictures in one
!> file that needs no other and prints well.
module asperity_program_commands_tenon_page
   use asperity_base_text_builder, only: growing_text
   use asperity_base_version, only: version
   use asperity_law_validity, only: validity_remark
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_commands_tenon_page_texts, only: assumptions, cautions, origin_of, &
      paper_cautions
   use asperity_program_commands_tenon_paper_joint, only: is_paper_joint
   use asperity_program_commands_tenon_sketch, only: add_sketch
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_html, only: add_html_table, html_text
   use asperity_program_report_report, only: report_type
   use asperity_program_report_terminal, only: input_text
   use asperity_program_system_environment, only: command_text, time_text
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: joint_page

contains

   !> Text of the page before each picture and after the last.
   function joint_page(report, case) result(parts)
      !> The report, with its pictures
      type(report_type), intent(in) :: report
      !> The case
      type(tenon_case), intent(in) :: case
      type(string_type), allocatable :: parts(:)
      type(growing_text) :: b
      integer :: i
      logical :: beside_paper

      allocate (parts(size(report%pictures) + 1))
      beside_paper = is_paper_joint(case)
      call add_head(b)
      call b%line('<h1>Tenon joint: hard contact against the rough law</h1>')
      call b%line('<p class="sub">Faces: '//html_text(report%faces)//'.<br>'// &
         'Made on '//time_text()//' by asperity '//version//': <code>'// &
         html_text(command_text())//'</code></p>')
      call b%line('<h2>Result</h2>')
      call add_html_table(b, report%summary, &
         trim(merge('As Table 5 of the paper: negative', 'Negative                         ', &
         beside_paper))//' loading; yield moment by equal energy (EEEP), bending stiffness = '// &
         'ultimate moment over the ultimate rotation; ratios are to hard contact of the same '// &
         'source')
      call add_list(b, cautions)
      if (beside_paper) call add_list(b, paper_cautions)
      call add_html_table(b, report%table_of('totals'), 'Energies and pull-out over the whole '// &
         'programme; initial stiffness of the negative side')
      call add_html_table(b, report%table_of('faces'), 'Contact of each face, at the last turn '// &
         'of the largest loop and just after it (Figs 31 to 34); both sides together')
      call add_remarks(b, report)

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

      call b%line('<h2>Cycles</h2>')
      call add_html_table(b, report%table_of('cycles'), &
         'Every cycle; rotation of its peak, moment on the negative side')
      call b%line('<h2>Case</h2>')
      call b%line('<figure class="sketch">')
      call add_sketch(b, case%joint)
      call b%line('<figcaption>Sizes to scale but for the clearances and the beam. Force, '// &
         'displacement and rotation are positive upwards, pull-out u out of the mortise.'// &
         '</figcaption></figure>')
      call add_case(b, report)
      call b%line('<h2>Assumptions</h2>')
      call add_list(b, assumptions)
      call b%line('<p class="sub">The law, and the figures called the paper''s: Xie, Zhang, '// &
         'Zhang, Guo, Wu, Normal contact performance of mortise and tenon joint, Journal of '// &
         'Wood Science 67 (2021), DOI 10.1186/s10086-021-01963-x.</p>')
      call b%line('</body></html>')
      parts(size(parts))%text = b%text()
   end function joint_page

   !> Everything before the first heading.
   pure subroutine add_head(b)
      type(growing_text), intent(inout) :: b

      call b%line('<!DOCTYPE html>')
      call b%line('<html lang="en"><head><meta charset="utf-8">')
      call b%line('<meta name="viewport" content="width=device-width, initial-scale=1">')
      call b%line('<title>asperity: tenon joint</title>')
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
   end subroutine add_head

   !> A list of sentences.
   pure subroutine add_list(b, items)
      type(growing_text), intent(inout) :: b
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
      type(growing_text), intent(inout) :: b
      type(report_type), intent(in) :: report
      integer :: bit, i

      call b%line('<ul>')
      if (report%validity() == 0) call b%line('<li>Validity: '// &
         html_text(report%valid_text())//'</li>')
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

   !> Every key: value, unit, meaning, and where the value comes from.
   pure subroutine add_case(b, report)
      type(growing_text), intent(inout) :: b
      type(report_type), intent(in) :: report
      character(len=:), allocatable :: origin
      type(tenon_case) :: usual_case
      type(key_list) :: usual
      integer :: i, place

      call declare_replay_case(usual_case, usual)
      call b%line('<div class="table"><table class="case"><caption>Input; asperity tenon '// &
         '--print-case writes it as a case file</caption>')
      call b%line('<thead><tr><th>key</th><th>value</th><th>what it is</th><th>where the value '// &
         'comes from</th></tr></thead><tbody>')
      do i = 1, report%keys%n
         associate (key => report%keys%rows(i))
            if (.not. key%is_input()) cycle
            origin = key%source
            place = usual%find(trim(key%name))
            ! Who writes a default into a case file has chosen it for the same reason
            if (origin_of(trim(key%name)) /= '' .and. &
                  input_text(key) == input_text(usual%rows(place))) then
               if (origin == 'default') origin = ''
               if (origin /= '') origin = origin//'; '
               origin = origin//origin_of(trim(key%name))
            end if
            call b%line('<tr>'//cell(trim(key%name))// &
               cell(trim(input_text(key, whole=.true.)//' '//trim(key%unit)))// &
               cell(trim(key%help))//cell(origin)//'</tr>')
         end associate
      end do
      call b%line('</tbody></table></div>')
   end subroutine add_case

   !> A cell of text.
   pure function cell(text) result(html)
      character(len=*), intent(in) :: text
      character(len=:), allocatable :: html

      html = '<td class="text">'//html_text(text)//'</td>'
   end function cell

end module asperity_program_commands_tenon_page
