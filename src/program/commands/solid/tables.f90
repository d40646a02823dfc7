!> Tables of `asperity solid`: every increment, totals, and what each amplitude comes to.
module asperity_program_commands_solid_tables
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_analysis, only: hysteresis_cycle, negative_side, positive_side
   use asperity_program_commands_joint_loops, only: hard, loop_joules, model_names, rough
   use asperity_program_commands_joint_tables, only: ratio
   use asperity_program_commands_solid_outcome, only: solid_outcome
   use asperity_program_report_table, only: column_counts, column_validity, new_table, table_type
   use asperity_program_report_units, only: kilonewton_metre
   use asperity_solid_solve_record, only: increment_record
   implicit none
   private
   public :: increments_table, totals_table, amplitudes_table, sizes_table, times_table

   !> Rotations over each other that are those of one amplitude
   real(wp), parameter :: alike = 1.0e-6_wp

contains

   !> Every increment of all models.
   function increments_table(outcomes, has_memory) result(table)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      !> Whether summits of rough faces remember
      logical, intent(in) :: has_memory
      type(table_type) :: table
      type(increment_record), allocatable :: r(:)
      character(len=5), allocatable :: model(:)
      integer, allocatable :: number(:)
      integer :: i, j, n

      n = 0
      do i = 1, size(outcomes)
         n = n + size(outcomes(i)%records)
      end do
      allocate (r(n), model(n), number(n))
      n = 0
      do i = 1, size(outcomes)
         associate (records => outcomes(i)%records)
            r(n + 1:n + size(records)) = records
            model(n + 1:n + size(records)) = model_names(outcomes(i)%model)
            number(n + 1:n + size(records)) = [(j, j=1, size(records))]
            n = n + size(records)
         end associate
      end do

      associate (pairs => outcomes(1)%pairs, arm => outcomes(1)%arm)
         table = new_table(columns=20 + 5*size(pairs) + merge(1, 0, has_memory), rows=n)
         call table%add_texts('model', model)
         call table%add_codes('increment', column_counts, number)
         ! Parentheses make the copies that gfortran makes anyway, and would warn of when checking
         call table%add_codes('stroke', column_counts, (r%stroke))
         call table%add_numbers('displacement', 'mm', (r%displacement))
         call table%add_numbers('drift', 'rad', r%displacement/arm)
         call table%add_numbers('rotation', 'rad', (r%rotation))
         call table%add_numbers('force', 'N', (r%force))
         call table%add_numbers('moment', 'kN m', kilonewton_metre*arm*r%force)
         call table%add_numbers('pull_out', 'mm', (r%pull_out))
         call table%add_numbers('work', 'J', (r%work))
         call table%add_numbers('stored_energy', 'J', (r%stored))
         call table%add_numbers('friction_dissipation', 'J', (r%friction))
         call table%add_numbers('plastic_dissipation', 'J', (r%plastic))
         if (has_memory) &
            call table%add_numbers('plastic_dissipation_faces', 'J', (r%face_plastic))
         call table%add_numbers('elastic_slip_energy', 'J', (r%coupling))
         call table%add_numbers('edge_energy', 'J', (r%edge))
         call table%add_numbers('energy_balance', 'J', (r%balance))
         call table%add_codes('iterations', column_counts, (r%iterations))
         call table%add_numbers('yielding', '-', (r%yielding))
         call table%add_numbers('plastic_strain', '-', (r%plastic_strain))
         do j = 1, size(pairs)
            call table%add_numbers('normal_'//trim(pairs(j)), 'N', (r%normal_force(j)))
         end do
         do j = 1, size(pairs)
            call table%add_numbers('largest_pressure_'//trim(pairs(j)), 'MPa', &
               (r%largest_pressure(j)))
         end do
         do j = 1, size(pairs)
            call table%add_numbers('area_stick_'//trim(pairs(j)), 'mm^2', (r%stick_area(j)))
         end do
         do j = 1, size(pairs)
            call table%add_numbers('area_slip_'//trim(pairs(j)), 'mm^2', (r%slip_area(j)))
         end do
         do j = 1, size(pairs)
            call table%add_numbers('friction_dissipation_'//trim(pairs(j)), 'J', &
               (r%friction_energy(j)))
         end do
         call table%add_codes('validity', column_validity, (r%validity))
      end associate
   end function increments_table

   !> Energies, pull-out, rotation and strain of all models over the whole programme.
   pure function totals_table(outcomes, has_memory) result(table)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      !> Whether summits of rough faces remember
      logical, intent(in) :: has_memory
      type(table_type) :: table
      type(increment_record) :: last(size(outcomes))
      real(wp), dimension(size(outcomes)) :: turned, furthest, pressure, mean_pressure, &
         stiffness
      integer :: i, n

      do i = 1, size(outcomes)
         associate (records => outcomes(i)%records)
            n = size(records)
            last(i) = records(n)
            turned(i) = maxval(abs(records%rotation))
            furthest(i) = records(maxloc(abs(records%pull_out), 1))%pull_out
            pressure(i) = largest_of(records)
            mean_pressure(i) = maxval(records%largest_mean_pressure)
         end associate
         stiffness(i) = outcomes(i)%loops%skeleton(negative_side)%initial_stiffness
      end do
      table = new_table(columns=14 + merge(1, 0, has_memory), rows=size(outcomes))
      call table%add_texts('model', model_names(outcomes%model))
      call table%add_numbers('initial_stiffness', 'kN m/rad', stiffness)
      call table%add_numbers('work_of_load', 'J', (last%work))
      call table%add_numbers('friction_dissipation', 'J', (last%friction))
      call table%add_numbers('plastic_dissipation', 'J', (last%plastic))
      if (has_memory) &
         call table%add_numbers('plastic_dissipation_faces', 'J', (last%face_plastic))
      call table%add_numbers('stored_energy', 'J', (last%stored))
      call table%add_numbers('elastic_slip_energy', 'J', (last%coupling))
      call table%add_numbers('edge_energy', 'J', (last%edge))
      call table%add_numbers('energy_balance', 'J', (last%balance))
      call table%add_numbers('largest_rotation', 'rad', turned, 4)
      call table%add_numbers('largest_pull_out', 'mm', furthest)
      call table%add_numbers('largest_pressure', 'MPa', pressure, 2)
      call table%add_numbers('largest_mean_pressure', 'MPa', mean_pressure, 2)
      call table%add_numbers('plastic_strain', '-', (last%plastic_strain), 3)
   end function totals_table

   !> Largest pressure of a programme, MPa.
   pure real(wp) function largest_of(records)
      type(increment_record), intent(in) :: records(:)
      integer :: i

      largest_of = 0.0_wp
      do i = 1, size(records)
         largest_of = max(largest_of, maxval(records(i)%largest_pressure))
      end do
   end function largest_of

   !> What the analyses took.
   pure function sizes_table(outcomes) result(table)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(table_type) :: table
      integer :: i

      table = new_table(columns=8, rows=size(outcomes))
      call table%add_texts('model', model_names(outcomes%model))
      call table%add_codes('nodes', column_counts, &
         [(size(outcomes(i)%mesh%nodes, 2), i=1, size(outcomes))])
      call table%add_codes('elements', column_counts, &
         [(size(outcomes(i)%mesh%elements, 2), i=1, size(outcomes))])
      call table%add_codes('unknowns', column_counts, (outcomes%unknowns))
      call table%add_codes('increments', column_counts, (outcomes%increments))
      call table%add_codes('iterations', column_counts, (outcomes%iterations))
      call table%add_codes('cutbacks', column_counts, (outcomes%cutbacks))
      call table%add_numbers('time', 's', (outcomes%seconds), 1)
   end function sizes_table

   !> Where the time of the analyses went, since they began or were taken up again: each of the rank
   !> that it took longest; how often the matrix was factorised, vectors of GMRES, and how often
   !> multigrid did not converge.
   pure function times_table(outcomes) result(table)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(table_type) :: table

      table = new_table(columns=11, rows=size(outcomes))
      call table%add_texts('model', model_names(outcomes%model))
      call table%add_codes('ranks', column_counts, (outcomes%ranks))
      call table%add_numbers('elements_seconds', 's', (outcomes%times%elements), 3)
      call table%add_numbers('contact_seconds', 's', (outcomes%times%contact), 3)
      call table%add_numbers('exchange_seconds', 's', (outcomes%times%exchange), 3)
      call table%add_numbers('patterns_seconds', 's', (outcomes%times%patterns), 3)
      call table%add_numbers('factors_seconds', 's', (outcomes%times%factors), 3)
      call table%add_numbers('solutions_seconds', 's', (outcomes%times%solutions), 3)
      call table%add_codes('factorisations', column_counts, (outcomes%factorisations))
      call table%add_codes('vectors', column_counts, (outcomes%vectors))
      call table%add_codes('multigrid_failures', column_counts, (outcomes%multigrid_failures))
   end function times_table

   !> First cycles of each amplitude: force on both sides, secant stiffness and energy of all
   !> models, and ratios of the rough law to hard contact.
   pure function amplitudes_table(outcomes) result(table)
      !> The models
      type(solid_outcome), intent(in) :: outcomes(:)
      type(table_type) :: table
      type(hysteresis_cycle), allocatable :: cycles(:, :)
      integer :: i, n

      n = huge(n)
      do i = 1, size(outcomes)
         n = min(n, size(first_cycles(outcomes(i))))
      end do
      allocate (cycles(n, size(outcomes)))
      do i = 1, size(outcomes)
         associate (first => first_cycles(outcomes(i)))
            cycles(:, i) = outcomes(i)%loops%cycles(first(:n))
         end associate
      end do
      table = new_table(columns=1 + 5*(size(outcomes) + merge(1, 0, size(outcomes) == 2)), rows=n)
      call table%add_numbers('amplitude', 'mm', outcomes(1)%arm*reach(cycles(:, 1)), 1)
      call add(table, outcomes, 'positive_force', 'kN', &
         kilonewtons((cycles%force(positive_side)), outcomes(1)%arm), 2)
      call add(table, outcomes, 'negative_force', 'kN', &
         kilonewtons((cycles%force(negative_side)), outcomes(1)%arm), 2)
      call add(table, outcomes, 'secant_stiffness', 'kN m/rad', (cycles%secant_stiffness), 1)
      call add(table, outcomes, 'mean_secant_stiffness', 'kN m/rad', &
         (cycles%mean_secant_stiffness), 1)
      call add(table, outcomes, 'energy', 'J', loop_joules((cycles%energy)), 1)
   end function amplitudes_table

   !> One quantity of all models, and its ratio.
   pure subroutine add(table, outcomes, quantity, unit, values, decimals)
      type(table_type), intent(inout) :: table
      type(solid_outcome), intent(in) :: outcomes(:)
      character(len=*), intent(in) :: quantity, unit
      !> Of every amplitude and model
      real(wp), intent(in) :: values(:, :)
      integer, intent(in) :: decimals
      integer :: i

      do i = 1, size(outcomes)
         call table%add_numbers(quantity//'_'//trim(model_names(outcomes(i)%model)), unit, &
            values(:, i), decimals)
      end do
      if (size(outcomes) == 2) call table%add_numbers(quantity//'_to_hard', '-', &
         ratio(values(:, rough), values(:, hard)), 3)
   end subroutine add

   !> Force of the load, kN, of a moment, kN m; what is not known stays so.
   pure elemental real(wp) function kilonewtons(moment, arm)
      real(wp), intent(in) :: moment
      !> Distance of the load, mm
      real(wp), intent(in) :: arm

      kilonewtons = moment
      if (.not. is_none(moment)) kilonewtons = moment/(1.0e-3_wp*arm)
   end function kilonewtons

   !> The first cycle of each amplitude, growing.
   pure function first_cycles(outcome) result(first)
      type(solid_outcome), intent(in) :: outcome
      integer, allocatable :: first(:)
      real(wp), allocatable :: furthest(:)
      integer :: i

      associate (cycles => outcome%loops%cycles)
         allocate (furthest, source=reach(cycles))
         first = pack([(i, i=1, size(cycles))], &
            [(all(furthest(i) > (1.0_wp + alike)*furthest(:i - 1)) &
            .and. furthest(i) > 0.0_wp, i=1, size(cycles))])
      end associate
   end function first_cycles

   !> Largest rotation of a cycle, rad.
   pure elemental real(wp) function reach(cycle)
      type(hysteresis_cycle), intent(in) :: cycle

      reach = 0.0_wp
      if (any(cycle%peak > 0)) reach = maxval(abs(cycle%displacement), mask=cycle%peak > 0)
   end function reach

end module asperity_program_commands_solid_tables
