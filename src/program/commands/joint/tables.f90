!> Tables of a tenon joint that follow from its loops: beside the paper's Table 5, cycles, skeleton.
!> There may be one model or both.
module asperity_program_commands_joint_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: hysteresis_cycle, hysteresis_skeleton, negative_side
   use asperity_paper_joint, only: published, published_methods
   use asperity_program_commands_joint_loops, only: hard, joint_loops, legends, loop_joules, &
      model_names
   use asperity_program_report_table, only: column_counts, new_table, table_type
   implicit none
   private
   public :: comparison_table, cycles_table, skeleton_table, ratio

   !> Place of hard contact among the published methods
   integer, parameter :: published_hard = 2

contains

   !> What Table 5 of the paper holds, each with its ratio to hard contact of the same source.
   pure function comparison_table(joints, beside_paper) result(table)
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      !> Whether the paper's rows come first
      logical, intent(in) :: beside_paper
      type(table_type) :: table
      character(len=32), allocatable :: methods(:)
      real(wp), allocatable :: values(:, :), ratios(:, :)
      integer :: i, n, before

      before = merge(size(published_methods), 0, beside_paper)
      n = before + size(joints)
      allocate (methods(n), values(3, n), ratios(3, n))
      ratios = none
      if (beside_paper) then
         methods(:before) = published_methods
         values(:, :before) = published
         do i = 1, before
            ratios(:, i) = ratio(published(:, i), published(:, published_hard))
         end do
      end if
      do i = 1, size(joints)
         methods(before + i) = trim(legends(joints(i)%model))//', this model'
         ! not joints(i)%loops%skeleton(2): gfortran 12 checks bounds in polymorphic arrays wrongly
         associate (skeleton => joints(i)%loops%skeleton)
            values(:, before + i) = table_5_values(skeleton(negative_side))
         end associate
      end do
      do i = 1, size(joints)
         if (joints(1)%model == hard) &
            ratios(:, before + i) = ratio(values(:, before + i), values(:, before + 1))
      end do
      table = new_table(columns=7, rows=n)
      call table%add_texts('method', methods)
      call table%add_numbers('yield_moment', 'kN m', values(1, :), decimals=2)
      call table%add_numbers('yield_to_hard', '-', ratios(1, :), decimals=3)
      call table%add_numbers('ultimate_moment', 'kN m', values(2, :), decimals=2)
      call table%add_numbers('ultimate_to_hard', '-', ratios(2, :), decimals=3)
      call table%add_numbers('bending_stiffness', 'kN m/rad', values(3, :), decimals=2)
      call table%add_numbers('stiffness_to_hard', '-', ratios(3, :), decimals=3)
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
      !> The numbers, of which either may be `none`
      real(wp), intent(in) :: a, b

      ratio = none
      if (.not. (is_none(a) .or. is_none(b)) .and. abs(b) > 0.0_wp) ratio = a/b
   end function ratio

   !> Every cycle, the models side by side.
   pure function cycles_table(joints) result(table)
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      type(table_type) :: table
      type(hysteresis_cycle), allocatable :: cycles(:, :)
      real(wp), allocatable :: reach(:)
      integer :: i, j, n

      n = common_cycles(joints)
      allocate (cycles(n, size(joints)), source=hysteresis_cycle(energy=none, &
         cumulative_energy=none))
      allocate (reach(n), source=0.0_wp)
      do j = 1, size(joints)
         associate (of_model => joints(j)%loops%cycles)
            if (size(of_model) > 0) cycles(:, j) = of_model(:n)
         end associate
         do i = 1, n
            associate (c => cycles(i, j))
               if (any(c%peak > 0)) reach(i) = maxval(abs(c%displacement), mask=c%peak > 0)
            end associate
         end do
      end do
      table = new_table(columns=2 + 7*size(joints), rows=n, leading=2)
      call table%add_codes('cycle', column_counts, [(i, i=1, n)])
      call table%add_numbers(trim(joints(1)%rotation_name), 'rad', reach, 4)
      call add(table, joints, 'negative_moment', 'kN m', (cycles%force(negative_side)), 3)
      call add(table, joints, 'secant_stiffness', 'kN m/rad', (cycles%secant_stiffness), 1)
      call add(table, joints, 'mean_secant_stiffness', 'kN m/rad', &
         (cycles%mean_secant_stiffness), 1)
      call add(table, joints, 'energy', 'J', loop_joules((cycles%energy)), 1)
      call add(table, joints, 'damping', '-', (cycles%damping), 3)
      call add(table, joints, 'pinching', '-', (cycles%pinching), 3)
      call add(table, joints, 'cumulative_energy', 'J', loop_joules((cycles%cumulative_energy)), 1)
   end function cycles_table

   !> A column for each model.
   pure subroutine add(table, joints, quantity, unit, values, decimals)
      type(table_type), intent(inout) :: table
      class(joint_loops), intent(in) :: joints(:)
      character(len=*), intent(in) :: quantity, unit
      !> Of every cycle and model
      real(wp), intent(in) :: values(:, :)
      integer, intent(in) :: decimals
      integer :: i

      do i = 1, size(joints)
         call table%add_numbers(quantity//'_'//trim(model_names(joints(i)%model)), unit, &
            values(:, i), decimals)
      end do
   end subroutine add

   !> How many cycles all models have that have any: one may have no moment, and so no cycles.
   pure integer function common_cycles(joints)
      class(joint_loops), intent(in) :: joints(:)
      integer :: i

      common_cycles = huge(1)
      do i = 1, size(joints)
         if (size(joints(i)%loops%cycles) > 0) &
            common_cycles = min(common_cycles, size(joints(i)%loops%cycles))
      end do
      if (common_cycles == huge(1)) common_cycles = 0
   end function common_cycles

   !> Points of the skeletons of all models, from the negative to the positive end.
   pure function skeleton_table(joints) result(table)
      !> The models
      class(joint_loops), intent(in) :: joints(:)
      type(table_type) :: table
      character(len=5), allocatable :: model(:)
      real(wp), allocatable :: rotation(:), moment(:)
      integer :: i, n

      n = 0
      do i = 1, size(joints)
         associate (skeleton => joints(i)%loops%skeleton)
            n = n + 1 + size(skeleton(1)%force) + size(skeleton(2)%force)
         end associate
      end do
      allocate (model(n), rotation(n), moment(n))
      n = 0
      do i = 1, size(joints)
         associate (skeleton => joints(i)%loops%skeleton)
            associate (up => skeleton(1), down => skeleton(2), &
                  m => 1 + size(skeleton(1)%force) + size(skeleton(2)%force))
               model(n + 1:n + m) = model_names(joints(i)%model)
               rotation(n + 1:n + m) = [reversed(down%displacement), 0.0_wp, up%displacement]
               moment(n + 1:n + m) = [reversed(down%force), 0.0_wp, up%force]
               n = n + m
            end associate
         end associate
      end do
      table = new_table(columns=3, rows=n)
      call table%add_texts('model', model)
      call table%add_numbers(trim(joints(1)%rotation_name), 'rad', rotation)
      call table%add_numbers('moment', 'kN m', moment)
   end function skeleton_table

   !> A list from its end to its beginning.
   pure function reversed(list)
      real(wp), intent(in) :: list(:)
      real(wp) :: reversed(size(list))

      reversed = list(size(list):1:-1)
   end function reversed

end module asperity_program_commands_joint_tables
