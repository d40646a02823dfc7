!> The page that `asperity solid --report` writes: case, assumptions, tables and pictures in one
!> file that needs no other and prints well.
module asperity_program_commands_solid_page
   use asperity_base_text_builder, only: growing_text
   use asperity_program_commands_joint_page, only: add_comparison, paper_note
   use asperity_program_commands_solid_page_texts, only: assumptions, cautions, origins, &
      paper_cautions
   use asperity_program_commands_tenon_page_texts, only: tenon_origins => origins
   use asperity_program_commands_tenon_sketch, only: add_sketch
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_html, only: add_html_table
   use asperity_program_report_page, only: add_case, add_head, add_list, add_pictures, &
      add_remarks, end_page
   use asperity_program_report_report, only: report_type
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: solid_page

contains

   !> Text of the page before each picture and after the last.
   function solid_page(report, joint, usual, beside_paper) result(parts)
      !> The report, with its tables and pictures
      type(report_type), intent(in) :: report
      !> The joint, all sizes given
      type(tenon_settings), intent(in) :: joint
      !> The keys of a case that is given nothing
      type(key_list), intent(in) :: usual
      !> Whether the joint is the paper's
      logical, intent(in) :: beside_paper
      type(string_type), allocatable :: parts(:)
      type(growing_text) :: b

      allocate (parts(size(report%pictures) + 1))
      call add_head(b, report, 'Tenon joint as a solid: hard contact against the rough law')
      call add_comparison(b, report, beside_paper)
      call add_list(b, cautions)
      if (beside_paper) call add_list(b, paper_cautions)
      call add_html_table(b, report%table_of('by_amplitude'), 'First cycle of each amplitude: '// &
         'force of the load at both peaks, secant stiffness and energy of the loop')
      call add_html_table(b, report%table_of('totals'), 'Energies of the whole joint over the '// &
         'whole programme, and largest values in it; initial stiffness of the negative side')
      call add_html_table(b, report%table_of('faces'), 'Contact of each face at the peaks of '// &
         'the first cycle of the largest amplitude and a little unloaded from there (Figs 31 '// &
         'to 34); both sides together')
      call add_html_table(b, report%table_of('analysis'), 'What the analysis took')
      call add_remarks(b, report)
      call add_pictures(b, report, parts)
      call b%line('<h2>Cycles</h2>')
      call add_html_table(b, report%table_of('cycles'), &
         'Every cycle; drift of its peak, moment on the negative side')
      call b%line('<h2>Case</h2>')
      call b%line('<figure class="sketch">')
      call add_sketch(b, joint)
      call b%line('<figcaption>Sizes to scale but for the clearances, the column and the beam. '// &
         'Force, displacement and rotation are positive upwards, pull-out u out of the mortise.'// &
         '</figcaption></figure>')
      call add_case(b, report, usual, [tenon_origins, origins])
      call b%line('<h2>Assumptions</h2>')
      call add_list(b, assumptions)
      call end_page(b, paper_note)
      parts(size(parts))%text = b%text()
   end function solid_page

end module asperity_program_commands_solid_page
