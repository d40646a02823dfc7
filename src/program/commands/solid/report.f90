!> The report of `asperity solid`: its tables, pictures and remarks.
module asperity_program_commands_solid_report
   use asperity_base_error, only: error_type
   use asperity_program_commands_joint_face_rows, only: face_table
   use asperity_program_commands_joint_remarks, only: analysis_remarks
   use asperity_program_commands_joint_tables, only: comparison_table, cycles_table, skeleton_table
   use asperity_program_commands_plots, only: picture_title
   use asperity_program_commands_solid_face_rows, only: solid_face_rows
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_commands_solid_plots, only: solid_pictures
   use asperity_program_commands_solid_tables, only: amplitudes_table, increments_table, &
      sizes_table, times_table, totals_table
   use asperity_program_report_report, only: named_table, report_type, turning_points
   use asperity_program_system_strings, only: string_type
   implicit none
   private
   public :: fill_report

contains

   !> Set everything but the page. `error` is set when a number is not finite.
   subroutine fill_report(report, outcomes, has_memory, beside_paper, error)
      !> The report, with its keys and the words on its faces
      type(report_type), intent(inout) :: report
      !> The models, hard contact first
      type(solid_outcome), intent(in) :: outcomes(:)
      !> Whether summits of rough faces remember, and whether the joint is the paper's
      logical, intent(in) :: has_memory, beside_paper
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      report%table = increments_table(outcomes, has_memory)
      call report%table%check_finite(error)
      if (allocated(error)) return
      report%summary = comparison_table(outcomes, beside_paper)
      report%more = [ &
         named_table('by_amplitude', 'First cycle of each amplitude', amplitudes_table(outcomes)), &
         named_table('totals', 'Whole programme', totals_table(outcomes, has_memory)), &
         named_table('faces', 'Faces', face_table(solid_face_rows(outcomes))), &
         named_table('cycles', 'Cycles', cycles_table(outcomes), 2 + 5*size(outcomes)), &
         named_table('skeleton', '', skeleton_table(outcomes)), &
         named_table('analysis', 'Analysis', sizes_table(outcomes)), &
         named_table('times', '', times_table(outcomes))]
      report%remarks = solid_remarks(outcomes, beside_paper)
      report%has_contact = .false.
      report%shows_table = .false.
      report%first_rows = [1]
      allocate (report%important(0))
      do i = 1, size(outcomes)
         associate (records => outcomes(i)%records)
            report%first_rows = [report%first_rows, report%first_rows(i) + size(records)]
            report%important = [report%important, turning_points((records%displacement))]
            report%has_contact = report%has_contact .or. touches(outcomes(i))
         end associate
      end do
      if (.not. report%is_drawn()) return
      report%pictures = solid_pictures(outcomes)
      report%picture_title = picture_title(report, 'Tenon joint as a solid')
   end subroutine fill_report

   !> Whether some face touches in some increment.
   pure logical function touches(outcome)
      type(solid_outcome), intent(in) :: outcome
      integer :: i

      touches = any([(any(outcome%records(i)%normal_force > outcome%small_force), &
         i=1, size(outcome%records))])
   end function touches

   !> What must be known beside the figures.
   pure function solid_remarks(outcomes, beside_paper) result(lines)
      type(solid_outcome), intent(in) :: outcomes(:)
      logical, intent(in) :: beside_paper
      type(string_type), allocatable :: lines(:)

      allocate (lines(1))
      lines(1)%text = 'A prediction, not a fit to a test: '
      if (beside_paper) lines(1)%text = 'A prediction from chosen sizes, not a fit to the paper: '
      lines(1)%text = lines(1)%text//'compare ratios to hard contact, not moments.'
      lines = [lines, analysis_remarks(outcomes)]
   end function solid_remarks

end module asperity_program_commands_solid_report
