!> Keys of a joint in three dimensions that a plane one has not: sizes, and the mesh of it.
module asperity_program_commands_deck_mesh_keys
   use asperity_base_kinds, only: wp
   use asperity_deck_options, only: deck_choice
   use asperity_deck_tenon_parts, only: default_tenon_sizes, tenon_sizes
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: declare_joint_sizes, declare_mortise_sizes, declare_grading

contains

   !> Declare the sizes.
   pure subroutine declare_joint_sizes(sizes, case, keys)
      !> The sizes
      type(tenon_sizes), intent(inout) :: sizes
      !> The joint, declared
      type(tenon_case), intent(in) :: case
      !> The keys
      type(key_list), intent(inout) :: keys
      type(tenon_sizes) :: usual

      usual = default_tenon_sizes(case%joint)
      sizes%column_height = usual%column_height
      call keys%real('column_height', sizes%column_height, 'mm', &
         'height of the column; 10/3 of height unless given')
      call keys%follows(case%height_key, '10/3 of height')
      call declare_mortise_sizes(sizes, case, keys)
   end subroutine declare_joint_sizes

   !> Declare all of them but the height of the column.
   pure subroutine declare_mortise_sizes(sizes, case, keys)
      !> The sizes
      type(tenon_sizes), intent(inout) :: sizes
      !> The joint, declared
      type(tenon_case), intent(in) :: case
      !> The keys
      type(key_list), intent(inout) :: keys
      type(tenon_sizes) :: usual
      real(wp), allocatable :: side_interference

      usual = default_tenon_sizes(case%joint)
      sizes%column_width = usual%column_width
      call keys%real('column_width', sizes%column_width, 'mm', &
         'width of the column across the beam; length unless given')
      call keys%follows(case%length_key)
      call keys%real('tail', sizes%tail, 'mm', 'length of the beam behind the column')
      sizes%edge_relief = usual%edge_relief
      call keys%real('edge_relief', sizes%edge_relief, 'mm', &
         'no contact so near the edges of the mortise; a hundredth of height unless given')
      call keys%follows(case%height_key, 'a hundredth of height')
      call keys%optional_real('side_interference', side_interference, 'mm', &
         'interference at each side; made for side_pressure unless given')
      if (allocated(side_interference)) sizes%side_interference = side_interference
   end subroutine declare_mortise_sizes

   !> Declare what makes the mesh of the joint finer at its rims.
   pure subroutine declare_grading(choice, keys)
      !> Choices of the mesh
      type(deck_choice), intent(inout) :: choice
      !> The keys
      type(key_list), intent(inout) :: keys

      call keys%optional_real('rim_mesh_size', choice%rim_mesh_size, 'mm', &
         'edge aimed at by the rims of mortise and tenon; mesh_size unless given')
      call keys%real('mesh_growth', choice%mesh_growth, '', &
         'ratio of neighbouring edges from rim_mesh_size to mesh_size')
   end subroutine declare_grading

end module asperity_program_commands_deck_mesh_keys
