!> A replay through a user routine of another, from its file on, in a child process: whatever the
!> routine does to itself, the program says so.
module asperity_program_commands_replay_foreign
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_text_builder, only: growing_text
   use asperity_check_finding, only: finding_list, finding_type
   use asperity_program_commands_check_process_rules, only: judge_outcome
   use asperity_program_commands_check_subject, only: check_subject, prepare_subject
   use asperity_program_commands_routine_load, only: load_uinter
   use asperity_program_system_child_folder, only: create_folder, remove_folder, temporary_folder
   use asperity_program_system_child_numbers, only: add_numbers, numbers_of
   use asperity_program_system_child_run, only: check_started, child_finished, child_limits, &
      child_outcome, child_work, run_child
   use asperity_program_system_strings, only: starts_with
   use asperity_replay_abaqus_host, only: host_point, new_host_point
   use asperity_replay_abaqus_record, only: optional_outputs
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_path_replay, only: path_step, replay_path
   implicit none
   private
   public :: replay_foreign

   !> The replay as the work of a child. Its result is an error, or the numbers of all increments.
   type, extends(child_work) :: replay_job
      !> Paths of the libraries of the routine and of the utilities of ABAQUS, empty for none
      character(len=:), allocatable :: library, utilities
      !> The motion, PROPS, length of STATEV, components
      type(motion_path) :: path
      real(wp), allocatable :: props(:)
      integer :: nstatv = 0, ndir = 3
   contains
      procedure :: work
   end type replay_job

   !> First word of the result when the replay fails; then follows why
   character(len=*), parameter :: failed = 'failed: '
   !> Numbers of an increment beside STATEV
   integer, parameter :: of_step = 11
   !> A replay takes as long as it takes, and may be interrupted
   type(child_limits), parameter :: limits = child_limits(seconds=1000000, megabytes=1000000)

contains

   !> Replay a path. `error` is set when the routine cannot be called, fails, or takes its process
   !> down.
   subroutine replay_foreign(file, path, props, nstatv, ndir, steps, unset, findings, error)
      !> Source or shared library of the routine
      character(len=*), intent(in) :: file
      !> The motion
      type(motion_path), intent(in) :: path
      !> PROPS
      real(wp), intent(in) :: props(:)
      !> Length of STATEV; components, 2 or 3
      integer, intent(in) :: nstatv, ndir
      !> One a row
      type(path_step), allocatable, intent(out) :: steps(:)
      !> Which of the optional outputs it has left unset
      logical, intent(out) :: unset(size(optional_outputs))
      !> What else is to be said: that it prints
      type(finding_list), intent(out) :: findings
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(temporary_folder) :: folder
      type(check_subject) :: subject
      type(finding_list) :: found
      type(replay_job) :: job
      type(child_outcome) :: outcome

      unset = .false.
      call create_folder(folder, error)
      if (allocated(error)) return
      subject%path = file
      subject%routine = 'uinter'
      call prepare_subject(subject, folder, found, error)
      if (.not. allocated(error) .and. .not. subject%is_callable) &
         call fatal_error(error, file//': '//words_of(found%items(1)))
      if (.not. allocated(error)) then
         job%library = subject%library
         job%utilities = subject%utilities
         job%path = path
         job%props = props
         job%nstatv = nstatv
         job%ndir = ndir
         call run_child(folder, job, limits, outcome)
         call judge_outcome(outcome, folder, limits, 'replay', subject%source_path, .false., &
            findings)
         call take_outcome(outcome, file, nstatv, findings, steps, unset, error)
      end if
      call remove_folder(folder)
   end subroutine replay_foreign

   !> What came of it.
   subroutine take_outcome(outcome, file, nstatv, findings, steps, unset, error)
      type(child_outcome), intent(in) :: outcome
      character(len=*), intent(in) :: file
      integer, intent(in) :: nstatv
      type(finding_list), intent(in) :: findings
      type(path_step), allocatable, intent(out) :: steps(:)
      logical, intent(out) :: unset(:)
      type(error_type), allocatable, intent(out) :: error
      real(wp), allocatable :: values(:)
      integer :: i, n

      unset = .false.
      call check_started(outcome, error)
      if (allocated(error)) return
      if (outcome%ending /= child_finished .and. findings%n > 0) then
         call fatal_error(error, file//': '//words_of(findings%items(1)), computation_error)
      else if (outcome%ending /= child_finished) then
         call fatal_error(error, file//': ends the replay', computation_error)
      else if (starts_with(outcome%text, failed)) then
         call fatal_error(error, outcome%text(len(failed) + 1:), computation_error)
      end if
      if (allocated(error)) return
      values = numbers_of(outcome%text)
      unset = values(:size(unset)) > 0.0_wp
      n = of_step + nstatv
      allocate (steps((size(values) - size(unset))/n))
      do i = 1, size(steps)
         call set_step(steps(i), values(size(unset) + (i - 1)*n + 1:size(unset) + i*n))
      end do
   end subroutine take_outcome

   !> A finding in words.
   pure function words_of(finding) result(text)
      type(finding_type), intent(in) :: finding
      character(len=:), allocatable :: text

      text = finding%place//': '//finding%found//'; '//finding%expected//' is expected'
   end function words_of

   !> Load the routine and lead it along the path.
   subroutine work(self, text)
      !> The replay
      class(replay_job), intent(in) :: self
      !> Its result
      character(len=:), allocatable, intent(out) :: text
      procedure(uinter_interface), pointer :: routine
      type(host_point) :: point
      type(path_step), allocatable :: steps(:)
      type(growing_text) :: buffer
      type(error_type), allocatable :: error
      integer :: i

      call load_uinter(self%library, self%utilities, routine, error)
      if (.not. allocated(error)) then
         call new_host_point(point, routine, self%props, self%nstatv, self%ndir, &
            keep_history=.false.)
         call replay_path(self%path, point, steps, error)
      end if
      if (allocated(error)) then
         text = failed//error%message
         return
      end if
      call add_numbers(buffer, merge(1.0_wp, 0.0_wp, point%unset))
      do i = 1, size(steps)
         call add_numbers(buffer, numbers_of_step(steps(i)))
      end do
      text = buffer%text()
   end subroutine work

   pure function numbers_of_step(step) result(values)
      type(path_step), intent(in) :: step
      real(wp) :: values(of_step + size(step%statev))

      values = [step%traction, step%stored_energy, step%dissipation, &
         real([step%lopenclose, step%lstate, step%parts], wp), step%statev]
   end function numbers_of_step

   pure subroutine set_step(step, values)
      type(path_step), intent(out) :: step
      real(wp), intent(in) :: values(:)

      step%traction = values(1:3)
      step%stored_energy = values(4)
      step%dissipation = values(5:8)
      step%lopenclose = nint(values(9))
      step%lstate = nint(values(10))
      step%parts = nint(values(11))
      step%statev = values(of_step + 1:)
   end subroutine set_step

end module asperity_program_commands_replay_foreign
