!> Pieces of a page on a tenon joint: what is compared, and where the figures come from.
module asperity_program_commands_joint_page
   use asperity_base_text_builder, only: growing_text
   use asperity_program_report_html, only: add_html_table
   use asperity_program_report_report, only: report_type
   implicit none
   private
   public :: add_comparison

   !> The note at the end of a page
   character(len=*), parameter, public :: paper_note = &
      'The law, and the figures called the paper''s: Xie, Zhang, Zhang, Guo, Wu, Normal '// &
      'contact performance of mortise and tenon joint, Journal of Wood Science 67 (2021), DOI '// &
      '10.1186/s10086-021-01963-x.'

contains

   !> The table that is like the paper's Table 5.
   pure subroutine add_comparison(b, report, beside_paper)
      !> Where to append
      type(growing_text), intent(inout) :: b
      !> The report
      type(report_type), intent(in) :: report
      !> Whether the paper's rows are in it
      logical, intent(in) :: beside_paper

      call add_html_table(b, report%summary, &
         trim(merge('As Table 5 of the paper: negative', 'Negative                         ', &
         beside_paper))//' loading; yield moment by equal energy (EEEP), bending stiffness = '// &
         'ultimate moment over the ultimate rotation; ratios are to hard contact of the same '// &
         'source')
   end subroutine add_comparison

end module asperity_program_commands_joint_page
