!> Rows of what each face bears, of a replay.
module asperity_program_commands_tenon_face_rows
   use asperity_program_commands_joint_face_rows, only: face_row, new_face_row
   use asperity_program_commands_joint_loops, only: model_names
   use asperity_program_commands_tenon_compare_models, only: joint_type, last_kept_steps
   use asperity_replay_tenon_geometry, only: lower, lower_shoulder, other_side, side, &
      tenon_face_names, upper, upper_shoulder
   use asperity_replay_tenon_points, only: tenon_point
   implicit none
   private
   public :: joint_face_rows

   !> First and last of the faces that share a row: the sides are alike
   integer, parameter :: shared(2, 5) = reshape([upper, upper, lower, lower, side, other_side, &
      upper_shoulder, upper_shoulder, lower_shoulder, lower_shoulder], [2, 5])

contains

   !> Rows of a replay at the last two of the steps whose points were kept, the models next to each
   !> other.
   pure function joint_face_rows(joints) result(rows)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(face_row), allocatable :: rows(:)
      type(tenon_point), allocatable :: p(:)
      integer, allocatable :: steps(:)
      integer :: i, j, k

      allocate (steps, source=last_kept_steps(joints(1)))
      allocate (rows(0))
      do k = 1, size(steps)
         do j = 1, size(shared, 2)
            do i = 1, size(joints)
               p = pack(joints(i)%points, joints(i)%points%step == steps(k) &
                  .and. joints(i)%points%face >= shared(1, j) &
                  .and. joints(i)%points%face <= shared(2, j))
               if (size(p) == 0) cycle
               rows = [rows, new_face_row(joints(i)%steps(steps(k))%displacement, &
                  merge('sides         ', tenon_face_names(shared(1, j)), shared(1, j) == side), &
                  model_names(joints(i)%model), p%area, p%pressure, p%status)]
            end do
         end do
      end do
   end function joint_face_rows

end module asperity_program_commands_tenon_face_rows
