!> Keys of what a tenon joint bears on: its column, and the wood and points of a replay.
module asperity_program_commands_tenon_bearing_keys
   use asperity_base_kinds, only: wp
   use asperity_program_commands_wood_keys, only: declare_wood
   use asperity_program_input_key_list, only: key_list
   use asperity_replay_tenon_settings, only: complete_tenon_settings, tenon_settings
   use asperity_wood_ageing, only: ageing_factors
   implicit none
   private
   public :: declare_column, declare_bearing, declare_points

contains

   !> Declare whether the column gives way.
   pure subroutine declare_column(joint, keys)
      !> The joint
      type(tenon_settings), intent(inout) :: joint
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%choice('column', joint%column, 'elastic rigid', &
         'whether the column gives way under the tenon')
   end subroutine declare_column

   !> Declare column, wood and its depths, for a replay.
   pure subroutine declare_bearing(joint, ageing, sections, height, keys)
      !> The joint
      type(tenon_settings), intent(inout) :: joint
      !> Old over new wood, as the faces have it
      type(ageing_factors), intent(inout) :: ageing
      !> Sections of the wood whose constants faces take
      logical, intent(in) :: sections(3)
      !> Place of the key of its height
      integer, intent(in) :: height
      !> The keys
      type(key_list), intent(inout) :: keys
      type(tenon_settings) :: usual

      usual%height = joint%height
      call complete_tenon_settings(usual)
      associate (t => joint)
         call declare_column(t, keys)
         call declare_wood(t%wood, keys, pressed=[t%column /= 'rigid', .true.], &
            sections=sections, ageing=ageing)
         t%bearing_depth = usual%bearing_depth
         call keys%real('bearing_depth', t%bearing_depth, 'mm', &
            'depth of wood that the bearing compresses; half of height unless given')
         call keys%follows(height, 'half of height')
         t%column_depth = usual%column_depth
         call keys%real('column_depth', t%column_depth, 'mm', &
            'depth of the column that the bearing compresses; half of height unless given')
         call keys%follows(height, 'half of height')
         call keys%unused(t%column == 'rigid')
      end associate
   end subroutine declare_bearing

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

end module asperity_program_commands_tenon_bearing_keys
