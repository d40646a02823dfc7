!> Tables of `asperity tenon`: every step, every contact point, and both models side by side.
module asperity_program_commands_tenon_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: hysteresis_cycle, hysteresis_skeleton, negative_side
   use asperity_paper_joint, only: published, published_methods
   use asperity_program_commands_tenon_compare_models, only: hard, joint_type, loop_joules, &
      model_names, rough
   use asperity_program_report_table, only: column_counts, column_status, column_validity, &
      new_table, table_type
   use asperity_program_report_units, only: joule, kilonewton_metre
   use asperity_replay_tenon_geometry, only: tenon_face_names, tenon_faces
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_step, only: tenon_step
   implicit none
   private
   public :: steps_table, points_table, comparison_table, totals_table, cycles_table, &
      skeleton_table

   !> Methods of Table 5: the paper's, then ours
   character(len=*), parameter :: methods(5) = [published_methods, [character(len=32) :: &
      'hard contact, this model', 'rough law, this model']]

contains

   !> Every step of both models.
   function steps_table(joints) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
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

      table = new_table(columns=22 + 2*tenon_faces, rows=n)
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

   !> What Table 5 of the paper holds, each with its ratio to hard contact of the same source.
   pure function comparison_table(joints, beside_paper) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Whether the paper's rows come first
      logical, intent(in) :: beside_paper
      type(table_type) :: table
      real(wp) :: values(3, 5), ratios(3, 5)
      integer :: i, first

      values(:, :3) = published
      do i = 1, 2
         values(:, 3 + i) = table_5_values(joints(i)%loops%skeleton(negative_side))
      end do
      do i = 1, 5
         ratios(:, i) = ratio(values(:, i), values(:, merge(2, 4, i < 4)))
      end do
      first = merge(1, 4, beside_paper)
      table = new_table(columns=7, rows=6 - first)
      call table%add_texts('method', methods(first:))
      call table%add_numbers('yield_moment', 'kN m', values(1, first:), decimals=2)
      call table%add_numbers('yield_to_hard', '-', ratios(1, first:), decimals=3)
      call table%add_numbers('ultimate_moment', 'kN m', values(2, first:), decimals=2)
      call table%add_numbers('ultimate_to_hard', '-', ratios(2, first:), decimals=3)
      call table%add_numbers('bending_stiffness', 'kN m/rad', values(3, first:), decimals=2)
      call table%add_numbers('stiffness_to_hard', '-', ratios(3, first:), decimals=3)
   end function comparison_table

   !> Yield moment (EEEP), ultimate moment, and that over the ultimate rotation.
   pure function table_5_values(skeleton) result(values)
      type(hysteresis_skeleton), intent(in) :: skeleton
      real(wp) :: values(3)

      values = [skeleton%yield_force, skeleton%peak_force, &
         ratio(skeleton%peak_force, skeleton%ultimate_displacement)]
   end function table_5_values

   !> A number over another, where both are known.
   pure elemental real(wp) function ratio(a, b)
      real(wp), intent(in) :: a, b

      ratio = none
      if (.not. (is_none(a) .or. is_none(b)) .and. abs(b) > 0.0_wp) ratio = a/b
   end function ratio

   !> Energies and pull-out of both models over the whole programme.
   pure function totals_table(joints) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
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
      table = new_table(columns=10, rows=size(joints))
      call table%add_texts('model', model_names(joints%model))
      call table%add_numbers('initial_stiffness', 'kN m/rad', stiffness)
      call table%add_numbers('work_of_load', 'J', joule*last%work)
      call table%add_numbers('friction_dissipation_faces', 'J', joule*(last%friction &
         - last%face_friction_energy(3) - last%face_friction_energy(4)))
      call table%add_numbers('friction_dissipation_sides', 'J', &
         joule*(last%face_friction_energy(3) + last%face_friction_energy(4)))
      call table%add_numbers('plastic_dissipation', 'J', joule*last%plastic)
      call table%add_numbers('elastic_slip_energy', 'J', joule*last%elastic_slip)
      call table%add_numbers('stored_energy', 'J', joule*last%stored)
      call table%add_numbers('largest_pull_out', 'mm', furthest)
      call table%add_numbers('final_pull_out', 'mm', (last%pull_out))
   end function totals_table

   !> Every cycle, both models side by side.
   pure function cycles_table(joints) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(table_type) :: table
      type(hysteresis_cycle), allocatable :: h(:), r(:)
      real(wp), allocatable :: reach(:)
      integer :: i, n

      associate (hs => joints(hard)%loops%cycles, rs => joints(rough)%loops%cycles)
         n = min(size(hs), size(rs))
         ! one model may have no moment, and so no cycles
         if (n == 0) n = max(size(hs), size(rs))
         allocate (h(n), r(n), source=hysteresis_cycle(energy=none, &
            cumulative_energy=none))
         if (size(hs) > 0) h = hs(:n)
         if (size(rs) > 0) r = rs(:n)
      end associate
      allocate (reach(n), source=0.0_wp)
      do i = 1, n
         if (any(h(i)%peak > 0)) reach(i) = maxval(abs(h(i)%displacement), mask=h(i)%peak > 0)
         if (any(r(i)%peak > 0)) reach(i) = maxval(abs(r(i)%displacement), mask=r(i)%peak > 0)
      end do
      table = new_table(columns=14, rows=n, leading=2)
      call table%add_codes('cycle', column_counts, [(i, i=1, n)])
      call table%add_numbers('rotation', 'rad', reach, 4)
      call table%add_numbers('negative_moment_hard', 'kN m', (h%force(negative_side)), 3)
      call table%add_numbers('negative_moment_rough', 'kN m', (r%force(negative_side)), 3)
      call table%add_numbers('secant_stiffness_hard', 'kN m/rad', (h%secant_stiffness), 1)
      call table%add_numbers('secant_stiffness_rough', 'kN m/rad', (r%secant_stiffness), 1)
      call table%add_numbers('energy_hard', 'J', loop_joules((h%energy)), 1)
      call table%add_numbers('energy_rough', 'J', loop_joules((r%energy)), 1)
      call table%add_numbers('damping_hard', '-', (h%damping), 3)
      call table%add_numbers('damping_rough', '-', (r%damping), 3)
      call table%add_numbers('pinching_hard', '-', (h%pinching), 3)
      call table%add_numbers('pinching_rough', '-', (r%pinching), 3)
      call table%add_numbers('cumulative_energy_hard', 'J', loop_joules((h%cumulative_energy)), 1)
      call table%add_numbers('cumulative_energy_rough', 'J', loop_joules((r%cumulative_energy)), 1)
   end function cycles_table

   !> Points of the skeletons of both models, from the negative to the positive end.
   pure function skeleton_table(joints) result(table)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      type(table_type) :: table
      character(len=5), allocatable :: model(:)
      real(wp), allocatable :: rotation(:), moment(:)
      integer :: i, n

      n = 0
      do i = 1, size(joints)
         n = n + 1 + size(joints(i)%loops%skeleton(1)%force) &
            + size(joints(i)%loops%skeleton(2)%force)
      end do
      allocate (model(n), rotation(n), moment(n))
      n = 0
      do i = 1, size(joints)
         associate (up => joints(i)%loops%skeleton(1), down => joints(i)%loops%skeleton(2))
            associate (m => 1 + size(up%force) + size(down%force))
               model(n + 1:n + m) = model_names(joints(i)%model)
               rotation(n + 1:n + m) = [reversed(down%displacement), 0.0_wp, up%displacement]
               moment(n + 1:n + m) = [reversed(down%force), 0.0_wp, up%force]
               n = n + m
            end associate
         end associate
      end do
      table = new_table(columns=3, rows=n)
      call table%add_texts('model', model)
      call table%add_numbers('rotation', 'rad', rotation)
      call table%add_numbers('moment', 'kN m', moment)
   end function skeleton_table

   !> A list from its end to its beginning.
   pure function reversed(list)
      real(wp), intent(in) :: list(:)
      real(wp) :: reversed(size(list))

      reversed = list(size(list):1:-1)
   end function reversed

end module asperity_program_commands_tenon_tables
