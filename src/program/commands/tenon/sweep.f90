!> `asperity tenon --sweep`: both models for every combination of the values of some keys. What is
!> done is kept in FILE.partial beside the CSV file, line by line, so that a run that was stopped
!> goes on where it was.
module asperity_program_commands_tenon_sweep
   !$ use omp_lib, only: omp_get_max_threads
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_config, only: config_type, new_config
   use asperity_program_commands_tenon_compare_models, only: check_moment, hard, joint_type, &
      rough, run_joint
   use asperity_program_commands_tenon_history, only: follow_history, history_type
   use asperity_program_commands_tenon_sweeps_cases, only: axis_type, combinations, new_axes, &
      set_case
   use asperity_program_commands_tenon_sweeps_file, only: append_case, open_partial, partial_type
   use asperity_program_commands_tenon_sweeps_table, only: case_result, evaluate, shown_columns, &
      sweep_table
   use asperity_program_input_command_line, only: command_line_type
   use asperity_program_input_keys, only: keys, n_keys
   use asperity_program_input_resolve, only: leader_of, locate, settled
   use asperity_program_input_settings, only: settings_type
   use asperity_program_report_report, only: report_type
   use asperity_program_system_progress, only: progress_type
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: report_sweep, check_sweep

   !> Outputs of a single run only
   character(len=*), parameter :: single(*) = [character(len=6) :: 'plot', 'report', 'points']

contains

   !> Refuse outputs that a sweep has not.
   subroutine check_sweep(line, error)
      !> The command line
      type(command_line_type), intent(in) :: line
      !> Set when there is one
      type(error_type), allocatable, intent(out) :: error
      integer :: i

      do i = 1, size(single)
         if (.not. line%options%given(trim(single(i)))) cycle
         call fatal_error(error, '--'//trim(single(i))//': is for one run, not for --sweep')
         return
      end do
   end subroutine check_sweep

   !> Run all combinations. A combination that fails says so in its row. `error` is set when the
   !> sweep itself is faulty or its partial file cannot be used.
   subroutine report_sweep(line, base, config, history, report, partial, error)
      !> Command line
      type(command_line_type), intent(in) :: line
      !> Defaults and case file
      type(settings_type), intent(in) :: base
      !> The joint without what is swept
      type(config_type), intent(in) :: config
      !> What all combinations follow
      type(history_type), intent(in) :: history
      !> Its table is set
      type(report_type), intent(inout) :: report
      !> To be closed when the results are delivered
      type(partial_type), intent(out) :: partial
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(axis_type), allocatable :: axes(:)
      type(case_result), allocatable :: results(:)
      integer, allocatable :: todo(:)
      type(tenon_settings) :: joint
      type(progress_type) :: progress
      integer :: i, n, done, threads

      call new_axes(axes, line%options%text_of('sweep'), line%command, error)
      if (allocated(error)) return
      ! every case has an arm of its own then, and its own check
      if (all(keys(axes%key)%name /= 'arm')) then
         joint = config%tenon
         call follow_history(joint, history, error)
         if (allocated(error)) return
      end if
      call hide_swept(report%settings, axes)
      n = combinations(axes)
      allocate (results(n))
      call open_partial(partial, line, report%settings, history%values, axes, results, error)
      if (allocated(error)) return
      todo = pack([(i, i=1, n)], .not. results%done)
      if (size(todo) < n) report%remarks = [string_type(to_text(n - size(todo))//' of '// &
         to_text(n)//' cases were taken from '//partial%path)]

      call progress%start('tenon --sweep')
      done = n - size(todo)
      threads = 1
      !$ threads = max(1, min(omp_get_max_threads(), size(todo)))
      !$omp parallel do schedule(dynamic) default(shared) private(i) num_threads(threads)
      do i = 1, size(todo)
         call run_case(line, base, axes, history, todo(i), results(todo(i)))
         !$omp critical (asperity_sweep)
         done = done + 1
         if (.not. allocated(error)) call append_case(partial, axes, results, todo(i), error)
         call progress%show(done, n, 'cases')
         !$omp end critical (asperity_sweep)
      end do
      !$omp end parallel do
      call progress%finish()
      if (allocated(error)) return

      report%table = sweep_table(axes, results, [(i, i=1, n)])
      call report%table%check_finite(error)
      call shown_columns(axes, report%shown_columns)
      report%first_rows = [1, n + 1]
      allocate (report%important(n), source=.true.)
   end subroutine report_sweep

   !> Keys that are swept, and what follows from them, have no value of their own to show.
   pure subroutine hide_swept(settings, axes)
      type(settings_type), intent(inout) :: settings
      type(axis_type), intent(in) :: axes(:)
      integer :: key, leader, pass

      settings%of(axes%key)%unused = .true.
      do key = 1, n_keys
         ! what a pair or a surface gives, whose name is before that of the pair
         associate (source => settings%of(key)%source)
            if (any(keys(axes%key)%name == source(:max(1, index(source, ' ') - 1)))) &
               settings%of(key)%unused = .true.
         end associate
      end do
      ! what follows from what follows
      do pass = 1, 2
         do key = 1, n_keys
            leader = leader_of(key, settings)
            if (settings%of(leader)%unused .and. leader /= key) settings%of(key)%unused = .true.
         end do
      end do
   end subroutine hide_swept

   !> Run one combination. Texts have static parts in some compilers, so that threads take turns
   !> with them.
   subroutine run_case(line, base, axes, history, which, result)
      type(command_line_type), intent(in) :: line
      type(settings_type), intent(in) :: base
      type(axis_type), intent(in) :: axes(:)
      type(history_type), intent(in) :: history
      integer, intent(in) :: which
      type(case_result), intent(inout) :: result
      type(config_type) :: config
      type(joint_type) :: joints(2)
      type(error_type), allocatable :: error

      !$omp critical (asperity_sweep)
      call prepare_case(line, base, axes, which, config, error)
      if (.not. allocated(error)) call follow_history(config%tenon, history, error)
      !$omp end critical (asperity_sweep)
      if (.not. allocated(error)) call run_joint(config, hard, joints(hard), error)
      if (.not. allocated(error)) call run_joint(config, rough, joints(rough), error)
      if (.not. allocated(error)) call check_moment(joints, error)
      !$omp critical (asperity_sweep)
      call evaluate(joints, error, result)
      !$omp end critical (asperity_sweep)
   end subroutine run_case

   !> Settings of one combination.
   subroutine prepare_case(line, base, axes, which, config, error)
      type(command_line_type), intent(in) :: line
      type(settings_type), intent(in) :: base
      type(axis_type), intent(in) :: axes(:)
      integer, intent(in) :: which
      type(config_type), intent(out) :: config
      type(error_type), allocatable, intent(out) :: error
      type(command_line_type) :: own
      type(settings_type) :: settings
      integer :: chosen(size(axes))

      own = line
      call set_case(own%options, axes, which, chosen)
      call settled(base, own, settings, error)
      if (.not. allocated(error)) call new_config(config, settings, line%command, error)
      if (allocated(error)) call locate(error, settings)
   end subroutine prepare_case

end module asperity_program_commands_tenon_sweep
