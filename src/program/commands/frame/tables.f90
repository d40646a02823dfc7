!> Tables of `asperity frame`: every increment, and what each joint comes to.
module asperity_program_commands_frame_tables
   use asperity_base_kinds, only: wp
   use asperity_program_commands_frame_outcome, only: frame_outcome, joint_name, joint_work
   use asperity_program_commands_joint_loops, only: model_names
   use asperity_program_report_table, only: column_counts, column_validity, new_table, table_type
   use asperity_program_report_units, only: kilonewton_metre
   use asperity_solid_solve_joints, only: joint_record
   use asperity_solid_solve_record, only: increment_record
   implicit none
   private
   public :: frame_increments_table, joints_table

contains

   !> Every increment of all models.
   pure function frame_increments_table(outcomes, has_memory) result(table)
      !> The models
      type(frame_outcome), intent(in) :: outcomes(:)
      !> Whether summits of rough faces remember
      logical, intent(in) :: has_memory
      type(table_type) :: table
      type(increment_record), allocatable :: r(:)
      type(joint_record), allocatable :: joints(:, :)
      character(len=5), allocatable :: model(:)
      character(len=:), allocatable :: name
      real(wp), allocatable :: work(:, :)
      integer, allocatable :: number(:)
      integer :: i, j, n

      n = 0
      do i = 1, size(outcomes)
         n = n + size(outcomes(i)%whole%records)
      end do
      allocate (r(n), model(n), number(n), joints(size(outcomes(1)%joints, 1), n), &
         work(n, size(outcomes(1)%joints, 1)))
      n = 0
      do i = 1, size(outcomes)
         associate (m => size(outcomes(i)%whole%records))
            r(n + 1:n + m) = outcomes(i)%whole%records
            joints(:, n + 1:n + m) = outcomes(i)%joints
            model(n + 1:n + m) = model_names(outcomes(i)%whole%model)
            number(n + 1:n + m) = [(j, j=1, m)]
            do j = 1, size(work, 2)
               work(n + 1:n + m, j) = joint_work(outcomes(i), j)
            end do
            n = n + m
         end associate
      end do

      table = new_table(columns=17 + 7*size(work, 2) + merge(1, 0, has_memory), rows=n)
      call table%add_texts('model', model)
      call table%add_codes('increment', column_counts, number)
      call table%add_codes('stroke', column_counts, (r%stroke))
      call table%add_numbers('sway', 'mm', (r%displacement))
      call table%add_numbers('drift', 'rad', r%displacement/outcomes(1)%whole%arm)
      call table%add_numbers('base_shear', 'N', (r%force))
      call table%add_numbers('work', 'J', (r%work))
      call table%add_numbers('stored_energy', 'J', (r%stored))
      call table%add_numbers('friction_dissipation', 'J', (r%friction))
      call table%add_numbers('plastic_dissipation', 'J', (r%plastic))
      if (has_memory) call table%add_numbers('plastic_dissipation_faces', 'J', (r%face_plastic))
      call table%add_numbers('elastic_slip_energy', 'J', (r%coupling))
      call table%add_numbers('edge_energy', 'J', (r%edge))
      call table%add_numbers('energy_balance', 'J', (r%balance))
      call table%add_codes('iterations', column_counts, (r%iterations))
      call table%add_numbers('yielding', '-', (r%yielding))
      call table%add_numbers('plastic_strain', '-', (r%plastic_strain))
      do j = 1, size(work, 2)
         name = '_'//joint_name(outcomes(1), j)
         associate (joint => joints(j, :))
            call table%add_numbers('rotation'//name, 'rad', (joint%rotation))
            call table%add_numbers('moment'//name, 'kN m', kilonewton_metre*joint%moment)
            call table%add_numbers('horizontal_force'//name, 'N', (joint%force(1)))
            call table%add_numbers('vertical_force'//name, 'N', (joint%force(2)))
            call table%add_numbers('largest_pressure'//name, 'MPa', (joint%largest_pressure))
            call table%add_numbers('friction_dissipation'//name, 'J', (joint%friction_energy))
            call table%add_numbers('work'//name, 'J', (work(:, j)))
         end associate
      end do
      call table%add_codes('validity', column_validity, (r%validity))
   end function frame_increments_table

   !> What each joint comes to over the whole programme, the models next to each other.
   pure function joints_table(outcomes) result(table)
      !> The models
      type(frame_outcome), intent(in) :: outcomes(:)
      type(table_type) :: table
      character(len=5), allocatable :: models(:)
      real(wp), allocatable :: values(:, :)
      character(len=12), allocatable :: joints(:)
      integer :: i, j, n

      n = size(outcomes)*size(outcomes(1)%joints, 1)
      allocate (models(n), joints(n), values(n, 6))
      n = 0
      do j = 1, size(outcomes(1)%joints, 1)
         do i = 1, size(outcomes)
            n = n + 1
            joints(n) = joint_name(outcomes(i), j)
            models(n) = model_names(outcomes(i)%whole%model)
            associate (r => outcomes(i)%joints(j, :), work => joint_work(outcomes(i), j))
               values(n, :) = [maxval(abs(r%rotation)), kilonewton_metre*maxval(r%moment), &
                  kilonewton_metre*minval(r%moment), maxval(r%largest_pressure), &
                  r(size(r))%friction_energy, work(size(work))]
            end associate
         end do
      end do
      table = new_table(columns=8, rows=n)
      call table%add_texts('joint', joints)
      call table%add_texts('model', models)
      call table%add_numbers('largest_rotation', 'rad', values(:, 1), 4)
      call table%add_numbers('positive_moment', 'kN m', values(:, 2), 2)
      call table%add_numbers('negative_moment', 'kN m', values(:, 3), 2)
      call table%add_numbers('largest_pressure', 'MPa', values(:, 4), 1)
      call table%add_numbers('friction_dissipation', 'J', values(:, 5), 1)
      call table%add_numbers('work', 'J', values(:, 6), 1)
   end function joints_table

end module asperity_program_commands_frame_tables
