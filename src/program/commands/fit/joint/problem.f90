!> The tenon joint beside records of it: a problem for `fit_least_squares`. Free are keys of
!> `asperity tenon`, set as a sweep sets them; the model is the replay with the rough law along the
!> displacements of each record.
module asperity_program_commands_fit_joint_problem
   !$ use omp_lib, only: omp_get_max_threads
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_fit_problem, only: fit_problem
   use asperity_program_commands_fit_joint_record, only: joint_record
   use asperity_program_commands_joint_loops, only: model_names, rough
   use asperity_program_commands_tenon_joint_keys, only: declare_replay_case, tenon_case
   use asperity_program_input_key, only: given_as_option
   use asperity_program_input_key_list, only: key_list
   use asperity_program_system_progress, only: clear_steps, show_stage
   use asperity_replay_steps, only: steps_to_turn
   use asperity_replay_tenon_run, only: run_tenon
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   implicit none
   private
   public :: joint_problem, new_joint_problem, prepare_joint, joint_force

   !> Records of one joint beside its replay. Residuals are differences of force over a scale.
   type, extends(fit_problem) :: joint_problem
      !> Keys of the joint, those fixed with their values
      type(key_list) :: keys
      !> Places of the free keys, in the order of the parameters
      integer, allocatable :: free(:)
      !> The records
      type(joint_record), allocatable :: records(:)
      !> What the differences are divided by, N, one for each sample of all records
      real(wp), allocatable :: scale(:)
   contains
      procedure :: residuals => find_residuals
      procedure :: several_residuals
   end type joint_problem

contains

   !> A problem of records.
   pure subroutine new_joint_problem(problem, keys, free, records, scale)
      !> The problem
      type(joint_problem), intent(out) :: problem
      !> Keys of the joint
      type(key_list), intent(in) :: keys
      !> Places of those that are free
      integer, intent(in) :: free(:)
      !> The records, with force
      type(joint_record), intent(in) :: records(:)
      !> What differences are divided by, N, one for each sample of all records
      real(wp), intent(in) :: scale(:)

      problem%keys = keys
      problem%free = free
      problem%records = records
      problem%scale = scale
   end subroutine new_joint_problem

   !> The joint of one set of values. `error` is set when a value is refused.
   subroutine prepare_joint(keys, free, values, case, error)
      !> Keys of the joint, and places of those that are free
      type(key_list), intent(in) :: keys
      integer, intent(in) :: free(:)
      !> Their values
      real(wp), intent(in) :: values(:)
      !> The joint
      type(tenon_case), intent(out) :: case
      !> Set when a value is refused
      type(error_type), allocatable, intent(out) :: error
      type(key_list) :: own
      integer :: i

      own = keys
      do i = 1, size(free)
         associate (key => own%rows(free(i)))
            key%values = values(i:i)
            key%given = given_as_option
            key%has_value = .true.
            key%source = '--free'
         end associate
      end do
      call declare_replay_case(case, own)
      ! records take the place of a programme
      case%history = 'record'
      if (allocated(own%error)) then
         error = own%error
      else
         call case%check(error, compiled=.true.)
      end if
      if (allocated(error)) call own%with_place(error)
   end subroutine prepare_joint

   !> Force of the joint at the samples of a record, N. `error` is set when a step cannot be solved.
   subroutine joint_force(case, record, force, error)
      !> The joint
      type(tenon_case), intent(in) :: case
      !> The record
      type(joint_record), intent(in) :: record
      !> One for each of its samples
      real(wp), intent(out) :: force(:)
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      type(tenon_settings) :: settings
      type(tenon_step), allocatable :: steps(:)
      integer :: i, last

      settings = case%joint
      settings%contact = model_names(rough)
      settings%displacement = record%displacement
      call run_tenon(settings, case%properties, case%sides, steps, error)
      if (allocated(error)) return
      last = 0
      do i = 1, size(force)
         ! as the replay divides the way to a sample
         last = last + max(1, steps_to_turn(record%displacement, i, &
            settings%displacement_increment))
         force(i) = steps(last)%force
      end do
   end subroutine joint_force

   !> Model less record, over the scale.
   recursive subroutine find_residuals(self, values, residuals, error)
      !> The problem
      class(joint_problem), intent(in) :: self
      !> Values of the free keys
      real(wp), intent(in) :: values(:)
      !> One for each sample, record after record
      real(wp), intent(out) :: residuals(:)
      !> Set when a value is refused or a replay fails
      type(error_type), allocatable, intent(out) :: error
      type(tenon_case) :: case
      integer :: i, first, last

      ! texts have static parts in some compilers, so that threads take turns with them
      !$omp critical (asperity_fit)
      call prepare_joint(self%keys, self%free, values, case, error)
      !$omp end critical (asperity_fit)
      last = 0
      do i = 1, size(self%records)
         if (allocated(error)) return
         first = last + 1
         last = last + size(self%records(i)%force)
         associate (record => self%records(i))
            call joint_force(case, record, residuals(first:last), error)
            if (allocated(error)) return
            residuals(first:last) = (residuals(first:last) - record%force)/self%scale(first:last)
         end associate
      end do
   end subroutine find_residuals

   !> Residuals of several sets of values, which threads share.
   recursive subroutine several_residuals(self, values, residuals, failed)
      !> The problem
      class(joint_problem), intent(in) :: self
      !> A column for each set
      real(wp), intent(in) :: values(:, :)
      !> A column for each set
      real(wp), intent(out) :: residuals(:, :)
      !> Whether a set could not be evaluated
      logical, intent(out) :: failed(:)
      integer :: done, i, threads

      done = 0
      threads = 1
      !$ threads = max(1, min(omp_get_max_threads(), size(values, 2)))
      !$omp parallel do schedule(dynamic) default(shared) private(i) num_threads(threads)
      do i = 1, size(values, 2)
         call find_one(self, values(:, i), residuals(:, i), failed(i))
         !$omp critical (asperity_fit)
         done = done + 1
         call tell(done, size(failed), residuals(:, i), failed(i))
         !$omp end critical (asperity_fit)
      end do
      !$omp end parallel do
      call clear_steps()
   end subroutine several_residuals

   !> One set, with an error of its own.
   recursive subroutine find_one(self, values, residuals, failed)
      class(joint_problem), intent(in) :: self
      real(wp), intent(in) :: values(:)
      real(wp), intent(out) :: residuals(:)
      logical, intent(out) :: failed
      type(error_type), allocatable :: error

      call self%residuals(values, residuals, error)
      failed = allocated(error)
      if (failed) residuals = 0.0_wp
   end subroutine find_one

   !> Tell a terminal how far it is.
   subroutine tell(done, n, residuals, failed)
      integer, intent(in) :: done, n
      real(wp), intent(in) :: residuals(:)
      logical, intent(in) :: failed

      if (.not. failed) call show_stage('fit: '//to_text(done)//' of '//to_text(n)// &
         ' replays, off by '//to_text(100.0_wp*norm2(residuals)/sqrt(real(size(residuals), wp)), &
         2)//' %')
   end subroutine tell

end module asperity_program_commands_fit_joint_problem
