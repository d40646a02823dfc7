!> Rows of what each face bears, of a solid joint.
module asperity_program_commands_solid_face_rows
   use asperity_base_kinds, only: wp
   use asperity_program_commands_joint_face_rows, only: face_row, new_face_row
   use asperity_program_commands_joint_loops, only: model_names
   use asperity_program_commands_solid_outcome, only: common_snapshots, solid_outcome
   use asperity_program_commands_solid_snapshot, only: contact_value, solid_snapshot
   use asperity_solid_mesh_joint, only: face_side
   implicit none
   private
   public :: solid_face_rows

contains

   !> Rows of the states that all models have kept, the models next to each other; areas and forces
   !> are those of the whole joint.
   pure function solid_face_rows(outcomes) result(rows)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(face_row), allocatable :: rows(:)
      integer, allocatable :: kinds(:)
      integer :: i, j, k, place

      allocate (kinds, source=common_snapshots(outcomes))
      allocate (rows(0))
      do k = 1, size(kinds)
         do j = 1, size(outcomes(1)%pairs)
            do i = 1, size(outcomes)
               place = findloc(outcomes(i)%snapshots%kind, kinds(k), 1)
               rows = [rows, row_of(outcomes(i)%snapshots(place), j, merge('sides   ', &
                  outcomes(i)%pairs(j), j == face_side), model_names(outcomes(i)%model))]
            end do
         end do
      end do
   end function solid_face_rows

   !> The row of one pair.
   pure function row_of(snapshot, pair, name, model) result(row)
      type(solid_snapshot), intent(in) :: snapshot
      integer, intent(in) :: pair
      character(len=*), intent(in) :: name, model
      type(face_row) :: row
      type(contact_value), allocatable :: cells(:)

      cells = pack(snapshot%contact, snapshot%contact%pair == pair)
      row = new_face_row(snapshot%displacement, name, model, 2.0_wp*cells%area*cells%coverage, &
         (cells%pressure), (cells%status))
   end function row_of

end module asperity_program_commands_solid_face_rows
