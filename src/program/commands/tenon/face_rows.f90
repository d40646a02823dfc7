!> What each face of the tenon joint bears: one row a face, model and displacement.
module asperity_program_commands_tenon_face_rows
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: status_slip, status_stick
   use asperity_program_commands_joint_loops, only: model_names
   use asperity_program_commands_tenon_compare_models, only: joint_type, last_kept_steps
   use asperity_program_report_table, only: new_table, table_type
   use asperity_replay_tenon_geometry, only: lower, lower_shoulder, other_side, side, &
      tenon_face_names, upper, upper_shoulder
   use asperity_replay_tenon_points, only: tenon_point
   implicit none
   private
   public :: face_row, new_face_row, joint_face_rows, face_table

   !> A face of the joint at one time.
   type :: face_row
      !> Displacement of the load point, mm
      real(wp) :: displacement = 0.0_wp
      !> Name of the face, and of the contact model
      character(len=14) :: face = ''
      character(len=5) :: model = ''
      !> Largest pressure, MPa, and normal force, N
      real(wp) :: largest_pressure = 0.0_wp, normal_force = 0.0_wp
      !> Areas that are open, stick and slip, mm^2
      real(wp) :: area_open = 0.0_wp, area_stick = 0.0_wp, area_slip = 0.0_wp
   end type face_row

   !> First and last of the faces that share a row: the sides are alike
   integer, parameter :: shared(2, 5) = reshape([upper, upper, lower, lower, side, other_side, &
      upper_shoulder, upper_shoulder, lower_shoulder, lower_shoulder], [2, 5])

contains

   !> The row of contact points.
   pure function new_face_row(displacement, face, model, area, pressure, status) result(row)
      !> Displacement of the load point, mm
      real(wp), intent(in) :: displacement
      !> Names of face and contact model
      character(len=*), intent(in) :: face, model
      !> Of each point: its area, mm^2, and pressure, MPa
      real(wp), intent(in) :: area(:), pressure(:)
      !> Its contact status, `status_open` and its like
      integer, intent(in) :: status(:)
      type(face_row) :: row

      row = face_row(displacement, face, model)
      ! of a point that has left the mortise nothing counts
      row%largest_pressure = max(0.0_wp, maxval(pressure, mask=area > 0.0_wp))
      row%normal_force = sum(pressure*area)
      row%area_stick = sum(area, mask=status == status_stick)
      row%area_slip = sum(area, mask=status == status_slip)
      row%area_open = sum(area, mask=status /= status_stick .and. status /= status_slip)
   end function new_face_row

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

   !> Rows as a table.
   pure function face_table(rows) result(table)
      !> The rows
      type(face_row), intent(in) :: rows(:)
      type(table_type) :: table

      table = new_table(columns=8, rows=size(rows), leading=3)
      call table%add_numbers('displacement', 'mm', (rows%displacement), 1)
      call table%add_texts('face', rows%face)
      call table%add_texts('model', rows%model)
      call table%add_numbers('largest_pressure', 'MPa', (rows%largest_pressure), 3)
      call table%add_numbers('normal_force', 'N', (rows%normal_force), 1)
      call table%add_numbers('area_open', 'mm^2', (rows%area_open), 1)
      call table%add_numbers('area_stick', 'mm^2', (rows%area_stick), 1)
      call table%add_numbers('area_slip', 'mm^2', (rows%area_slip), 1)
   end function face_table

end module asperity_program_commands_tenon_face_rows
