!> `asperity tenon --sweep`: both models for every combination of the values of some keys. What is
!> done is kept in FILE.partial beside the CSV file, line by line, so that a run that was stopped
!> goes on where it was.
module asperity_program_commands_tenon_sweep
   !$ use omp_lib, only: omp_get_max_threads
   use asperity_base_error, only: error_type
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_joint_loops, only: hard, rough
   use asperity_program_commands_tenon_compare_models, only: check_moment, joint_type, &
      run_joint
   use asperity_program_commands_tenon_history, only: follow_history, history_type
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_commands_sweep_cases, only: axis_type, combinations, new_axes, &
      set_case
   use asperity_program_commands_sweep_columns, only: hide_swept
   use asperity_program_commands_tenon_sweeps_file, only: append_case, open_partial, partial_type
   use asperity_program_commands_tenon_sweeps_table, only: case_result, evaluate, shown_columns, &
      sweep_table
   use asperity_program_input_key_list, only: key_list
   use asperity_program_report_report, only: report_type
   use asperity_program_system_progress, only: progress_type
   use asperity_program_system_strings, only: string_type
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: report_sweep

contains

   !> Run all combinations. A combination that fails says so in its row. `error` is set when the
   !> sweep itself is faulty or its partial file cannot be used.
   subroutine report_sweep(case, history, sweep, csv, report, partial, error)
      !> The joint without what is swept
      type(tenon_case), intent(in) :: case
      !> What all combinations follow
      type(history_type), intent(in) :: history
      !> The sweeps, separated by blanks, and the path of the CSV file
      character(len=*), intent(in) :: sweep, csv
      !> With the keys, of which those swept are hidden; its table is set
      type(report_type), intent(inout) :: report
      !> To be closed when the results are delivered
      type(partial_type), intent(out) :: partial
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(axis_type), allocatable :: axes(:)
      type(case_result), allocatable :: results(:)
      integer, allocatable :: todo(:)
      type(tenon_settings) :: joint
      type(key_list) :: keys
      type(progress_type) :: progress
      integer :: i, n, done, threads

      call new_axes(axes, sweep, report%keys, error)
      if (allocated(error)) return
      ! every case has an arm of its own then, and its own check
      if (all(report%keys%rows(axes%key)%name /= 'arm')) then
         joint = case%joint
         call follow_history(joint, history, error)
         if (allocated(error)) return
      end if
      keys = report%keys
      call hide_swept(report%keys, axes)
      n = combinations(axes)
      allocate (results(n))
      call open_partial(partial, sweep, csv, report%keys, history%values, axes, results, error)
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
         call run_case(keys, axes, history, todo(i), results(todo(i)))
         !$omp critical (asperity_sweep)
         done = done + 1
         if (.not. allocated(error)) call append_case(partial, keys, axes, results, &
            todo(i), error)
         call progress%show(done, n, 'cases')
         !$omp end critical (asperity_sweep)
      end do
      !$omp end parallel do
      call progress%finish()
      if (allocated(error)) return

      report%table = sweep_table(keys, axes, results, [(i, i=1, n)])
      call report%table%check_finite(error)
      call shown_columns(keys, axes, report%shown_columns)
      report%first_rows = [1, n + 1]
      allocate (report%important(n), source=.true.)
   end subroutine report_sweep

   !> Run one combination. Texts have static parts in some compilers, so that threads take turns
   !> with them.
   subroutine run_case(keys, axes, history, which, result)
      type(key_list), intent(in) :: keys
      type(axis_type), intent(in) :: axes(:)
      type(history_type), intent(in) :: history
      integer, intent(in) :: which
      type(case_result), intent(inout) :: result
      type(tenon_case) :: case
      type(joint_type) :: joints(2)
      type(error_type), allocatable :: error

      !$omp critical (asperity_sweep)
      call prepare_case(keys, axes, which, case, error)
      if (.not. allocated(error)) call follow_history(case%joint, history, error)
      !$omp end critical (asperity_sweep)
      if (.not. allocated(error)) call run_joint(case, hard, joints(hard), error)
      if (.not. allocated(error)) call run_joint(case, rough, joints(rough), error)
      if (.not. allocated(error)) call check_moment(joints, error)
      !$omp critical (asperity_sweep)
      call evaluate(joints, error, result)
      !$omp end critical (asperity_sweep)
   end subroutine run_case

   !> One combination.
   subroutine prepare_case(keys, axes, which, case, error)
      type(key_list), intent(in) :: keys
      type(axis_type), intent(in) :: axes(:)
      integer, intent(in) :: which
      type(tenon_case), intent(out) :: case
      type(error_type), allocatable, intent(out) :: error
      type(key_list) :: own

      own = keys
      call set_case(own, axes, which)
      call declare_replay_case(case, own)
      if (allocated(own%error)) then
         error = own%error
      else
         call case%check(error, compiled=.true.)
      end if
      if (allocated(error)) call own%with_place(error)
   end subroutine prepare_case

end module asperity_program_commands_tenon_sweep
