!> Results of a sweep of the tenon joint: one row per combination.
module asperity_program_commands_tenon_sweeps_table
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_hysteresis_analysis, only: negative_side
   use asperity_program_commands_joint_loops, only: loop_joules, model_names
   use asperity_program_commands_tenon_compare_models, only: joint_type
   use asperity_program_commands_sweep_cases, only: axis_type
   use asperity_program_commands_sweep_columns, only: add_axes
   use asperity_program_input_key, only: name_length
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_table, only: column_counts, column_validity, new_table, table_type
   use asperity_program_report_units, only: joule
   implicit none
   private
   public :: case_result, evaluate, shown_columns, sweep_table

   !> Figures of one model, then ratios rough:hard
   character(len=*), parameter :: names(7) = [character(len=20) :: 'yield_moment', &
      'ultimate_moment', 'bending_stiffness', 'loop_energy', 'work_of_load', &
      'friction_dissipation', 'largest_pull_out']
   character(len=*), parameter :: units(7) = [character(len=8) :: 'kN m', 'kN m', 'kN m/rad', &
      'J', 'J', 'J', 'mm']
   !> Which of them are also given as ratios
   integer, parameter :: n_ratios = 4, n_names = size(names)
   integer, parameter, public :: n_figures = 2*n_names + n_ratios
   !> Outcome of a combination that was run
   character(len=*), parameter, public :: well = 'done'
   integer, parameter :: longest_outcome = 400

   !> One combination.
   type :: case_result
      !> It was run
      logical :: done = .false.
      !> Figures of hard contact, of the rough law, and ratios
      real(wp) :: figures(n_figures) = none
      !> Validity flags
      integer :: validity = 0
      !> `done`, or why there are no figures
      character(len=longest_outcome) :: outcome = ''
   end type case_result

contains

   !> Figures of two replays, or why there are none.
   subroutine evaluate(joints, error, result)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Why there are no replays
      type(error_type), allocatable, intent(in) :: error
      !> The result
      type(case_result), intent(inout) :: result
      integer :: i

      result%done = .true.
      result%figures = none
      if (allocated(error)) then
         result%outcome = error%message
         return
      end if
      result%outcome = well
      if (.not. all(joints%touches)) then
         i = findloc(joints%touches, .false., 1)
         result%outcome = well//': the faces of '//trim(model_names(i))//' contact touch in no step'
         if (.not. any(joints%touches)) result%outcome = well//': the faces touch in no step'
      end if
      associate (f => result%figures)
         do i = 1, 2
            f((i - 1)*n_names + 1:i*n_names) = figures_of(joints(i))
            result%validity = ior(result%validity, &
               joints(i)%steps(ubound(joints(i)%steps, 1))%validity)
         end do
         do i = 1, n_ratios
            if (.not. any(is_none(f([i, n_names + i]))) .and. abs(f(i)) > 0.0_wp) &
               f(2*n_names + i) = f(n_names + i)/f(i)
         end do
      end associate
   end subroutine evaluate

   !> Figures of one replay.
   pure function figures_of(joint) result(figures)
      type(joint_type), intent(in) :: joint
      real(wp) :: figures(n_names)

      associate (s => joint%loops%skeleton(negative_side), cycles => joint%loops%cycles, &
            last => joint%steps(ubound(joint%steps, 1)))
         figures = [s%yield_force, s%peak_force, none, none, joule*last%work, &
            joule*last%friction, maxval(abs(joint%steps%pull_out))]
         if (.not. is_none(s%peak_force) .and. abs(s%ultimate_displacement) > 0.0_wp) &
            figures(3) = s%peak_force/s%ultimate_displacement
         if (size(cycles) > 0) figures(4) = loop_joules(cycles(size(cycles))%cumulative_energy)
      end associate
   end function figures_of

   !> The table of some combinations.
   function sweep_table(keys, axes, results, which) result(table)
      !> The keys
      type(key_list), intent(in) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> All results
      type(case_result), intent(in) :: results(:)
      !> Combinations to show
      integer, intent(in) :: which(:)
      type(table_type) :: table
      integer :: i, j

      table = new_table(columns=3 + size(axes) + n_figures, rows=size(which))
      call table%add_codes('case', column_counts, which)
      call add_axes(table, keys, axes, which)
      do i = 1, 2
         do j = 1, n_names
            call table%add_numbers(trim(names(j))//'_'//trim(model_names(i)), trim(units(j)), &
               results(which)%figures((i - 1)*n_names + j))
         end do
      end do
      do j = 1, n_ratios
         call table%add_numbers(trim(names(j))//'_ratio', '-', &
            results(which)%figures(2*n_names + j), decimals=4)
      end do
      call table%add_codes('validity', column_validity, results(which)%validity)
      call table%add_texts('outcome', results(which)%outcome)
   end function sweep_table

   !> Columns that the terminal shows: the keys, and what compares the models.
   subroutine shown_columns(keys, axes, columns)
      !> The keys
      type(key_list), intent(in) :: keys
      !> The axes
      type(axis_type), intent(in) :: axes(:)
      !> Names of the columns
      character(len=name_length), allocatable, intent(out) :: columns(:)

      columns = [character(len=name_length) :: 'case', keys%rows(axes%key)%name, &
         'ultimate_moment_hard', 'ultimate_moment_rough', 'loop_energy_hard', 'loop_energy_rough', &
         'yield_moment_ratio', 'ultimate_moment_ratio', 'loop_energy_ratio', &
         'largest_pull_out_rough', 'outcome']
   end subroutine shown_columns

end module asperity_program_commands_tenon_sweeps_table
