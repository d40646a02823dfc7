!> Tables of `asperity tenon`: every step, every contact point, totals.
module asperity_program_commands_tenon_tables
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_analysis, only: negative_side
   use asperity_program_commands_joint_loops, only: model_names
   use asperity_program_commands_tenon_compare_models, only: joint_type
   use asperity_program_report_table, only: column_counts, column_status, column_validity, &
      new_table, table_type
   use asperity_program_report_units, only: joule, kilonewton_metre
   use asperity_replay_tenon_geometry, only: tenon_face_names, tenon_faces
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_step, only: tenon_step
   implicit none
   private
   public :: steps_table, points_table, totals_table

contains

   !> Every step of both models.
   function steps_table(joints, has_memory) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Whether summits of rough faces remember
      logical, intent(in) :: has_memory
      type(table_type) :: table
      type(tenon_step), allocatable :: s(:)
      character(len=5), allocatable :: model(:)
      integer :: i, n, face

      n = size(joints(1)%steps) + size(joints(2)%steps)
      allocate (s(n), model(n))
      n = 0
      do i = 1, size(joints)
         associate (steps => joints(i)%steps)
            s(n + 1:n + size(steps)) = steps
            model(n + 1:n + size(steps)) = model_names(joints(i)%model)
            n = n + size(steps)
         end associate
      end do

      table = new_table(columns=22 + 2*tenon_faces + merge(1, 0, has_memory), rows=n)
      call table%add_texts('model', model)
      ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
      call table%add_codes('step', column_counts, (s%step))
      call table%add_codes('cycle', column_counts, (s%cycle))
      call table%add_numbers('displacement', 'mm', (s%displacement))
      call table%add_numbers('rotation', 'rad', (s%rotation))
      call table%add_numbers('force', 'N', (s%force))
      call table%add_numbers('moment', 'kN m', kilonewton_metre*s%moment)
      call table%add_numbers('pull_out', 'mm', (s%pull_out))
      call table%add_numbers('vertical', 'mm', (s%vertical))
      call table%add_numbers('axial_force', 'N', (s%axial_force))
      call table%add_numbers('work', 'J', joule*s%work)
      call table%add_numbers('contact_work', 'J', joule*s%contact_work)
      call table%add_numbers('axial_work', 'J', joule*s%axial_work)
      call table%add_numbers('holding_work', 'J', joule*s%holding_work)
      call table%add_numbers('stored_energy', 'J', joule*s%stored)
      call table%add_numbers('friction_dissipation', 'J', joule*s%friction)
      call table%add_numbers('plastic_dissipation', 'J', joule*s%plastic)
      if (has_memory) &
         call table%add_numbers('plastic_dissipation_faces', 'J', joule*s%face_plastic)
      call table%add_numbers('elastic_slip_energy', 'J', joule*s%elastic_slip)
      call table%add_numbers('edge_energy', 'J', joule*s%edge)
      do face = 1, tenon_faces
         call table%add_numbers('normal_'//trim(tenon_face_names(face)), 'N', &
            (s%face_normal(face)))
      end do
      do face = 1, tenon_faces
         call table%add_numbers('friction_dissipation_'//trim(tenon_face_names(face)), 'J', &
            joule*s%face_friction_energy(face))
      end do
      call table%add_codes('iterations', column_counts, (s%iterations))
      call table%add_codes('halvings', column_counts, (s%halvings))
      call table%add_codes('validity', column_validity, (s%validity))
   end function steps_table

   !> Every contact point of both models at the steps that were kept.
   function points_table(joints) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(table_type) :: table
      type(tenon_point), allocatable :: p(:)
      character(len=5), allocatable :: model(:)
      integer :: i, n

      n = size(joints(1)%points)
      allocate (model(n + size(joints(2)%points)), source=model_names(joints(2)%model))
      model(:n) = model_names(joints(1)%model)
      allocate (p, source=[joints(1)%points, joints(2)%points])
      table = new_table(columns=15, rows=size(p))
      call table%add_texts('model', model)
      call table%add_codes('step', column_counts, (p%step))
      call table%add_numbers('displacement', 'mm', &
         [(joints(1)%steps(p(i)%step)%displacement, i=1, size(p))])
      call table%add_texts('face', tenon_face_names(p%face))
      call table%add_codes('point', column_counts, (p%point))
      call table%add_codes('status', column_status, (p%status))
      call table%add_numbers('x', 'mm', (p%x))
      call table%add_numbers('y', 'mm', (p%y))
      call table%add_numbers('area', 'mm^2', (p%area))
      call table%add_numbers('pressure', 'MPa', (p%pressure))
      call table%add_numbers('shear_1', 'MPa', (p%shear_1))
      call table%add_numbers('shear_2', 'MPa', (p%shear_2))
      call table%add_numbers('slip_1', 'mm', (p%slip_1))
      call table%add_numbers('slip_2', 'mm', (p%slip_2))
      call table%add_numbers('indentation', 'mm', (p%indentation))
   end function points_table

   !> Energies and pull-out of both models over the whole programme.
   pure function totals_table(joints, has_memory) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Whether summits of rough faces remember
      logical, intent(in) :: has_memory
      type(table_type) :: table
      type(tenon_step) :: last(size(joints))
      real(wp), dimension(size(joints)) :: stiffness, furthest
      integer :: i

      do i = 1, size(joints)
         associate (steps => joints(i)%steps)
            last(i) = steps(ubound(steps, 1))
            furthest(i) = steps(maxloc(abs(steps%pull_out), 1) - 1)%pull_out
         end associate
         stiffness(i) = joints(i)%loops%skeleton(negative_side)%initial_stiffness
      end do
      table = new_table(columns=10 + merge(1, 0, has_memory), rows=size(joints))
      call table%add_texts('model', model_names(joints%model))
      call table%add_numbers('initial_stiffness', 'kN m/rad', stiffness)
      call table%add_numbers('work_of_load', 'J', joule*last%work)
      call table%add_numbers('friction_dissipation_faces', 'J', joule*(last%friction &
         - last%face_friction_energy(3) - last%face_friction_energy(4)))
      call table%add_numbers('friction_dissipation_sides', 'J', &
         joule*(last%face_friction_energy(3) + last%face_friction_energy(4)))
      call table%add_numbers('plastic_dissipation', 'J', joule*last%plastic)
      if (has_memory) &
         call table%add_numbers('plastic_dissipation_faces', 'J', joule*last%face_plastic)
      call table%add_numbers('elastic_slip_energy', 'J', joule*last%elastic_slip)
      call table%add_numbers('stored_energy', 'J', joule*last%stored)
      call table%add_numbers('largest_pull_out', 'mm', furthest)
      call table%add_numbers('final_pull_out', 'mm', (last%pull_out))
   end function totals_table

end module asperity_program_commands_tenon_tables
