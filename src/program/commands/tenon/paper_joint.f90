!> What makes a joint the paper's.
module asperity_program_commands_tenon_paper_joint
   use asperity_base_kinds, only: wp
   use asperity_paper_joint, only: joint_amplitudes, joint_cycles
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: is_paper_joint


contains

   !> Whether a joint is that of the paper: sizes and programme at their defaults, which are those
   !> of examples/tenon_joint/base.nml. Faces, wood and how it is held may differ, to compare them.
   pure logical function is_paper_joint(case)
      !> The case
      type(tenon_case), intent(in) :: case
      type(tenon_settings) :: usual

      associate (t => case%joint)
         is_paper_joint = case%history == '' .and. .not. t%shoulders &
            .and. t%arm_datum == usual%arm_datum &
            .and. size(t%amplitudes) == size(joint_amplitudes) &
            .and. size(t%cycles) == size(joint_cycles)
         if (is_paper_joint) is_paper_joint = .not. any(abs([t%length - usual%length, &
            t%height - usual%height, t%width - usual%width, &
            t%clearance_above - usual%clearance_above, &
            t%clearance_below - usual%clearance_below, t%arm - usual%arm, &
            t%amplitudes - joint_amplitudes, real(t%cycles - joint_cycles, wp)]) > 0.0_wp)
      end associate
   end function is_paper_joint

end module asperity_program_commands_tenon_paper_joint
