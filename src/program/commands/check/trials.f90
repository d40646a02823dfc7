!> The trials of a routine, each in a child process.
module asperity_program_commands_check_trials
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_letter_case, only: upper_case
   use asperity_check_finding, only: finding_list, n_rules, rule_crash, rule_names, &
      rule_prints, rule_timeout, rule_uninitialised, rule_unset_output
   use asperity_check_settings, only: check_settings
   use asperity_check_trials, only: uinter_trials, vuinter_trials
   use asperity_program_commands_check_finding_lines, only: add_lines
   use asperity_program_commands_check_process_rules, only: judge_outcome
   use asperity_program_commands_check_subject, only: build_others, check_subject, &
      uninitialised_messages
   use asperity_program_commands_check_trial_job, only: not_loaded, trial_job
   use asperity_program_commands_check_uninitialised, only: judge_builds
   use asperity_program_commands_routine_messages, only: message_type
   use asperity_program_system_child_folder, only: temporary_folder
   use asperity_program_system_child_run, only: check_started, child_finished, child_limits, &
      child_outcome, run_child
   use asperity_program_system_progress, only: progress_type
   use asperity_program_system_strings, only: starts_with
   implicit none
   private
   public :: run_trials

   !> Bytes that fresh memory is filled with beside the variables of the two builds
   integer, parameter :: fills(2) = [0, 254]

contains

   !> Run all trials. If the first, which only drives the routine, does not come to its end, the
   !> others are left out.
   subroutine run_trials(subject, settings, limits, folder, findings, is_tried, error)
      !> The routine
      type(check_subject), intent(in) :: subject
      !> What it is driven with
      type(check_settings), intent(in) :: settings
      !> What a trial may take
      type(child_limits), intent(in) :: limits
      !> Where files go
      type(temporary_folder), intent(inout) :: folder
      !> Findings are added
      type(finding_list), intent(inout) :: findings
      !> Rules that were tried
      logical, intent(inout) :: is_tried(n_rules)
      !> Set when the routine cannot be loaded, or the program was interrupted
      type(error_type), allocatable, intent(out) :: error
      character(len=len(uinter_trials)), allocatable :: names(:)
      type(trial_job) :: job
      type(child_outcome) :: outcome
      type(progress_type) :: progress
      integer :: i, rule

      allocate (names, source=uinter_trials)
      if (subject%routine == 'vuinter') names = vuinter_trials
      job%library = subject%library
      job%utilities = subject%utilities
      job%is_explicit = subject%routine == 'vuinter'
      job%settings = settings
      is_tried([rule_crash, rule_timeout, rule_prints]) = .true.
      call progress%start('check')
      do i = 1, size(names)
         call progress%show(i - 1, size(names), 'trials: '//trim(names(i)))
         job%trial = i
         call run_job(job, trim(names(i)), outcome)
         if (allocated(error)) exit
         rule = rule_of(trim(names(i)))
         if (outcome%ending == child_finished .and. rule > 0) is_tried(rule) = .true.
         if (outcome%ending == child_finished) call add_lines(outcome%text, findings)
         if (outcome%ending /= child_finished .and. i == 1) exit
      end do
      if (.not. allocated(error) .and. i > size(names) .and. subject%source_path /= '') &
         call compare_builds()
      call progress%finish()

   contains

      !> Run one trial and judge how it ended.
      subroutine run_job(job, name, outcome)
         type(trial_job), intent(in) :: job
         character(len=*), intent(in) :: name
         type(child_outcome), intent(out) :: outcome

         call run_child(folder, job, limits, outcome)
         call check_started(outcome, error)
         if (outcome%ending == child_finished .and. starts_with(outcome%text, not_loaded)) &
            call fatal_error(error, load_failure(outcome%text(len(not_loaded) + 1:), &
            subject%path))
         if (.not. allocated(error)) call judge_outcome(outcome, folder, limits, name, &
            subject%source_path, job%is_explicit, findings)
      end subroutine run_job

      !> Compare two builds in which variables hold different numbers before they are set.
      subroutine compare_builds()
         type(child_limits) :: filled
         type(child_outcome) :: first, again, second
         type(message_type), allocatable :: messages(:)

         call progress%show(size(names), size(names), 'trials: uninitialised')
         job%trial = 0
         filled = limits
         filled%fill = fills(1)
         call run_child(folder, job, filled, first)
         call run_child(folder, job, filled, again)
         call check_started(first, error)
         if (.not. allocated(error)) call check_started(again, error)
         ! what changes by itself is no matter of variables
         if (first%ending /= child_finished .or. again%ending /= child_finished) return
         if (first%text /= again%text) return
         call build_others(subject, folder, job%library, error)
         if (allocated(error)) return
         filled%fill = fills(2)
         call run_child(folder, job, filled, second)
         call check_started(second, error)
         if (allocated(error)) return
         is_tried(rule_uninitialised) = .true.
         if (second%ending == child_finished .and. second%text == first%text) return
         call uninitialised_messages(subject, folder, messages, error)
         if (.not. allocated(error)) call judge_builds(first, second, messages, findings)
      end subroutine compare_builds

   end subroutine run_trials

   !> Why a library cannot be loaded, in words for its user.
   pure function load_failure(text, path) result(failure)
      character(len=*), intent(in) :: text, path
      character(len=:), allocatable :: failure
      character(len=*), parameter :: mark = 'undefined symbol: '
      integer :: at

      failure = text
      at = index(text, mark)
      if (at == 0) return
      failure = text(at + len(mark):)
      failure = failure(:scan(failure//' ', ' ,') - 1)
      if (failure(len(failure):) == '_') failure = upper_case(failure(:len(failure) - 1))
      failure = path//' calls '//failure//', which it does not have and which cannot be stood '// &
         'in for here; give a file of all routines, or one without the call'
   end function load_failure

   !> The rule that a trial is for, zero for none.
   pure integer function rule_of(trial)
      character(len=*), intent(in) :: trial

      rule_of = findloc(rule_names, trial, dim=1)
      if (trial == 'outputs') rule_of = rule_unset_output
   end function rule_of

end module asperity_program_commands_check_trials
