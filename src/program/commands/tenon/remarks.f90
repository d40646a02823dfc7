!> What is to be said of the replays of a tenon joint.
module asperity_program_commands_tenon_remarks
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: negative_side, positive_side
   use asperity_program_commands_hysteresis_remarks, only: excess_words
   use asperity_program_commands_joint_loops, only: legends
   use asperity_program_commands_tenon_compare_models, only: joint_type
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_run, only: tenon_warned_pull_out
   implicit none
   private
   public :: joint_remarks

contains

   !> What must be known beside the figures.
   pure function joint_remarks(length, joints, beside_paper) result(lines)
      !> Length of the tenon, mm
      real(wp), intent(in) :: length
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Whether the joint is the paper's
      logical, intent(in) :: beside_paper
      type(string_type), allocatable :: lines(:)
      type(string_type) :: line
      real(wp) :: furthest
      integer :: i, side

      line%text = 'A prediction, not a fit to a test: '
      if (beside_paper) line%text = 'A prediction from chosen sizes, not a fit to the paper: '
      line%text = line%text//'compare ratios to hard contact, not moments.'
      lines = [line]
      do i = 1, size(joints)
         if (.not. joints(i)%touches) then
            line%text = trim(legends(i))//': the faces touch in no step, '// &
               trim(merge('so that all moment is friction of the sides', &
               'and there is no moment                     ', joints(i)%has_moment))
            lines = [lines, line]
         end if
         furthest = maxval(abs(joints(i)%steps%pull_out))
         if (furthest <= tenon_warned_pull_out*length) cycle
         line%text = trim(legends(i))//': the tenon moves '//to_text(furthest, 3)// &
            ' mm along its axis, more than a quarter of its length: the overlap, not the '// &
            'contact, then governs the moment'
         lines = [lines, line]
      end do
      do i = 1, size(joints)
         do side = positive_side, negative_side
            line%text = excess_words(joints(i)%loops%skeleton(side), 'kN m')
            if (line%text == '') cycle
            line%text = trim(legends(i))//': the replay has '//line%text// &
               ' than its skeleton through the tips of first cycles'
            lines = [lines, line]
         end do
      end do
   end function joint_remarks

end module asperity_program_commands_tenon_remarks
