!> What comes out of the analysis of a frame under one contact model.
module asperity_program_commands_frame_outcome
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_solid_solve_joints, only: joint_record
   implicit none
   private
   public :: frame_outcome, joint_name, joint_work

   !> The whole frame, whose force is the base shear, whose load point the heads, whose arm the
   !> height of the columns and whose moment the product of both; and its joints.
   type :: frame_outcome
      !> The whole
      type(solid_outcome) :: whole
      !> Every joint in every increment
      type(joint_record), allocatable :: joints(:, :)
   end type frame_outcome

contains

   !> Name of a joint in tables, by the numbers of its beam and its column, such as `b1c2`.
   pure function joint_name(outcome, joint) result(name)
      !> The frame
      type(frame_outcome), intent(in) :: outcome
      !> Number of the joint
      integer, intent(in) :: joint
      character(len=:), allocatable :: name

      associate (of => outcome%whole%mesh%joints(joint))
         name = 'b'//to_text(of%beam)//'c'//to_text(of%column)
      end associate
   end function joint_name

   !> Work of a joint's moment on its rotation up to each increment, J: what the joint has taken.
   pure function joint_work(outcome, joint) result(work)
      !> The frame
      type(frame_outcome), intent(in) :: outcome
      !> Number of the joint
      integer, intent(in) :: joint
      real(wp) :: work(size(outcome%joints, 2))
      real(wp) :: moment, rotation, total
      integer :: i

      total = 0.0_wp
      moment = 0.0_wp
      rotation = 0.0_wp
      do i = 1, size(work)
         associate (now => outcome%joints(joint, i))
            total = total + 0.5e-3_wp*(moment + now%moment)*(now%rotation - rotation)
            work(i) = total
            moment = now%moment
            rotation = now%rotation
         end associate
      end do
   end function joint_work

end module asperity_program_commands_frame_outcome
