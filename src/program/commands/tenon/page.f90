!> The page that `asperity tenon --report` writes: case, assumptions, tables and pictures in one
!> file that needs no other and prints well.
module asperity_program_commands_tenon_page
   use asperity_base_text_builder, only: growing_text
   use asperity_program_commands_joint_page, only: add_comparison, paper_note
   use asperity_program_commands_opensees_output, only: opensees_output
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_commands_tenon_page_texts, only: assumptions, cautions, origins, &
      paper_cautions
   use asperity_program_commands_tenon_paper_joint, only: is_paper_joint
   use asperity_program_commands_tenon_sketch, only: add_sketch
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_html, only: add_html_table
   use asperity_program_report_page, only: add_case, add_head, add_list, add_pictures, &
      add_remarks, end_page
   use asperity_program_report_report, only: report_type
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
      type(tenon_case) :: usual_case
      type(opensees_output) :: usual_output
      type(key_list) :: usual
      logical :: beside_paper

      allocate (parts(size(report%pictures) + 1))
      beside_paper = is_paper_joint(case)
      call add_head(b, report, 'Tenon joint: hard contact against the rough law')
      call add_comparison(b, report, beside_paper)
      call add_list(b, cautions)
      if (beside_paper) call add_list(b, paper_cautions)
      call add_html_table(b, report%table_of('totals'), 'Energies and pull-out over the whole '// &
         'programme; initial stiffness of the negative side')
      call add_html_table(b, report%table_of('faces'), 'Contact of each face, at the last turn '// &
         'of the largest loop and just after it (Figs 31 to 34); both sides together')
      call add_remarks(b, report)

      call add_pictures(b, report, parts)
      call b%line('<h2>Cycles</h2>')
      call add_html_table(b, report%table_of('cycles'), &
         'Every cycle; rotation of its peak, moment on the negative side')
      call b%line('<h2>Case</h2>')
      call b%line('<figure class="sketch">')
      call add_sketch(b, case%joint)
      call b%line('<figcaption>Sizes to scale but for the clearances and the beam. Force, '// &
         'displacement and rotation are positive upwards, pull-out u out of the mortise.'// &
         '</figcaption></figure>')
      call declare_replay_case(usual_case, usual)
      call usual_output%declare(usual)
      call add_case(b, report, usual, origins)
      call b%line('<h2>Assumptions</h2>')
      call add_list(b, assumptions)
      call end_page(b, paper_note)
      parts(size(parts))%text = b%text()
   end function joint_page

end module asperity_program_commands_tenon_page
