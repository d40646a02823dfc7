!> What each face of a tenon joint bears: one row a face, model and displacement.
module asperity_program_commands_joint_face_rows
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: none
   use asperity_contact_state, only: status_slip, status_stick
   use asperity_program_commands_joint_loops, only: hard, model_names
   use asperity_program_commands_joint_tables, only: ratio
   use asperity_program_report_table, only: new_table, table_type
   implicit none
   private
   public :: face_row, new_face_row, face_table

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

   !> Rows as a table.
   pure function face_table(rows) result(table)
      !> The rows
      type(face_row), intent(in) :: rows(:)
      type(table_type) :: table

      table = new_table(columns=10, rows=size(rows), leading=3)
      call table%add_numbers('displacement', 'mm', (rows%displacement), 1)
      call table%add_texts('face', (rows%face))
      call table%add_texts('model', (rows%model))
      call table%add_numbers('largest_pressure', 'MPa', (rows%largest_pressure), 3)
      call table%add_numbers('pressure_to_hard', '-', to_hard(rows, (rows%largest_pressure)), 3)
      call table%add_numbers('normal_force', 'N', (rows%normal_force), 1)
      call table%add_numbers('force_to_hard', '-', to_hard(rows, (rows%normal_force)), 3)
      call table%add_numbers('area_open', 'mm^2', (rows%area_open), 1)
      call table%add_numbers('area_stick', 'mm^2', (rows%area_stick), 1)
      call table%add_numbers('area_slip', 'mm^2', (rows%area_slip), 1)
   end function face_table

   !> Values over those of hard contact, which is the row before that of another model.
   pure function to_hard(rows, values) result(ratios)
      type(face_row), intent(in) :: rows(:)
      real(wp), intent(in) :: values(:)
      real(wp) :: ratios(size(rows))
      integer :: i, at_hard

      ratios = none
      at_hard = 0
      do i = 1, size(rows)
         if (rows(i)%model == model_names(hard)) at_hard = i
         if (at_hard == 0) cycle
         if (rows(i)%face == rows(at_hard)%face) ratios(i) = ratio(values(i), values(at_hard))
      end do
   end function to_hard

end module asperity_program_commands_joint_face_rows
