!> Keys of the wood of a tenon joint, and of the points at which its replay knows it.
module asperity_program_commands_tenon_replay_keys
   use asperity_base_kinds, only: wp
   use asperity_program_input_key_list, only: key_list
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   implicit none
   private
   public :: declare_wood, declare_points

contains

   !> Declare the wood.
   pure subroutine declare_wood(joint, height, keys, is_replay)
      !> The joint
      type(tenon_settings), intent(inout) :: joint
      !> Place of the key of its height
      integer, intent(in) :: height
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether it is for the replay, which takes depths
      logical, intent(in) :: is_replay
      type(tenon_settings) :: usual

      usual%height = joint%height
      call complete_tenon_settings(usual)
      associate (t => joint)
         call keys%real('bearing_modulus', t%bearing_modulus, 'MPa', &
            'modulus of the wood perpendicular to the grain')
         if (is_replay) then
            t%bearing_depth = usual%bearing_depth
            call keys%real('bearing_depth', t%bearing_depth, 'mm', &
               'depth of wood that the bearing compresses; half of height unless given')
            call keys%follows(height, 'half of height')
         end if
         call keys%real('bearing_strength', t%bearing_strength, 'MPa', &
            'strength fc90 perpendicular to the grain')
         call keys%real('hardening', t%hardening, '', &
            'stiffness after yield over bearing_modulus/bearing_depth')
         call keys%real('column_modulus', t%column_modulus, 'MPa', &
            'modulus of the column parallel to the grain, 0 for rigid')
         if (is_replay) then
            t%column_depth = usual%column_depth
            call keys%real('column_depth', t%column_depth, 'mm', &
               'depth of the column that the bearing compresses; half of height unless given')
            call keys%follows(height, 'half of height')
            call keys%unused(.not. t%column_modulus > 0.0_wp)
         end if
         call keys%real('column_strength', t%column_strength, 'MPa', &
            'strength fc0 of the column parallel to the grain')
         call keys%unused(.not. t%column_modulus > 0.0_wp)
         call keys%real('column_hardening', t%column_hardening, '', &
            'stiffness after yield over column_modulus/column_depth')
         call keys%unused(.not. t%column_modulus > 0.0_wp)
      end associate
   end subroutine declare_wood

   !> Declare the contact points of the replay.
   pure subroutine declare_points(joint, keys)
      !> The joint
      type(tenon_settings), intent(inout) :: joint
      !> The keys
      type(key_list), intent(inout) :: keys

      associate (t => joint)
         call keys%whole('face_points', t%points, &
            'contact points along the upper, and along the lower face')
         call keys%whole('side_points', t%side_points, &
            'contact points along either direction of a side face')
         call keys%unused(.not. t%side_pressure > 0.0_wp)
         call keys%whole('shoulder_points', t%shoulder_points, &
            'contact points over the height of each shoulder')
         call keys%unused(.not. t%shoulders)
      end associate
   end subroutine declare_points

end module asperity_program_commands_tenon_replay_keys
