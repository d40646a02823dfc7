!> What is to be said of the replays of a tenon joint.
module asperity_program_commands_tenon_remarks
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_hysteresis_analysis, only: negative_side, positive_side
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: normal_properties
   use asperity_program_commands_hysteresis_remarks, only: excess_words
   use asperity_program_commands_interaction, only: interaction_remark
   use asperity_program_commands_joint_loops, only: legends, rough
   use asperity_program_commands_tenon_compare_models, only: joint_type
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_geometry, only: other_side, side
   use asperity_replay_tenon_run, only: tenon_warned_pull_out
   implicit none
   private
   public :: joint_remarks

contains

   !> What must be known beside the figures.
   pure function joint_remarks(case, joints, beside_paper) result(lines)
      !> The case
      type(tenon_case), intent(in) :: case
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
         if (furthest <= tenon_warned_pull_out*case%joint%length) cycle
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
      line%text = interaction_remark(largest_area(case, joints(rough)))
      if (line%text /= '') lines = [lines, line]
   end function joint_remarks

   !> Largest real area over nominal area of the points that were kept, at the pressure of each on
   !> first loading.
   pure real(wp) function largest_area(case, joint)
      type(tenon_case), intent(in) :: case
      type(joint_type), intent(in) :: joint
      logical :: of_sides(size(joint%points))

      of_sides = joint%points%face == side .or. joint%points%face == other_side
      largest_area = max( &
         area_at(case%properties%normal, maxval(joint%points%pressure, mask=.not. of_sides)), &
         area_at(case%sides%normal, maxval(joint%points%pressure, mask=of_sides)))
   end function largest_area

   !> Real area over nominal area at a pressure, MPa.
   pure real(wp) function area_at(law, pressure)
      type(normal_properties), intent(in) :: law
      real(wp), intent(in) :: pressure
      type(normal_response) :: response
      type(error_type), allocatable :: error
      real(wp) :: separation

      area_at = 0.0_wp
      if (.not. pressure > 0.0_wp) return
      call separation_for_pressure(law, pressure, separation, error)
      if (allocated(error)) return
      response = evaluate_normal_law(law, separation)
      area_at = response%area_fraction
   end function area_at

end module asperity_program_commands_tenon_remarks
