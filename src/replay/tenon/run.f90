!> Cyclic replay of a straight tenon joint: the load programme step by step.
module asperity_replay_tenon_run
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_memory, only: check_work
   use asperity_base_number_text, only: to_text
   use asperity_contact_properties, only: contact_properties
   use asperity_replay_motion_path, only: motion_path
   use asperity_replay_tenon_check_settings, only: check_tenon_settings
   use asperity_replay_tenon_geometry, only: new_tenon_model
   use asperity_replay_tenon_joint, only: joint_state, rest_joint, turn_joint
   use asperity_replay_tenon_load_path, only: tenon_programme
   use asperity_replay_tenon_motions, only: add_motions, failed_motion
   use asperity_replay_tenon_points, only: record_points, tenon_point
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: step_of, tenon_step
   implicit none
   private
   public :: run_tenon, failed_point, tenon_progress

   !> A contact point at which a step failed.
   type :: failed_point
      !> Its number, zero when no step failed at a point
      integer :: point = 0
      !> Its motion up to what was tried last, an increment a second
      type(motion_path) :: path
      !> Its properties
      type(contact_properties) :: properties
   end type failed_point

   !> Pull-out over length above which a warning is due, and above which a run stops
   real(wp), parameter, public :: tenon_warned_pull_out = 0.25_wp, tenon_largest_pull_out = 0.5_wp

   abstract interface
      !> Told after every step.
      subroutine tenon_progress(done, amount)
         implicit none
         !> Steps done, and in all
         integer, intent(in) :: done, amount
      end subroutine tenon_progress
   end interface

contains

   !> Replay the joint. `steps` is allocated from 0; after a failure it ends with the last good
   !> step, so that the displacements up to the next one replay the failure.
   subroutine run_tenon(settings, faces, sides, steps, error, record_at, points, progress, failed)
      !> Joint and programme
      type(tenon_settings), intent(in) :: settings
      !> Contact of the upper and lower face and the shoulders, and of the two sides
      type(contact_properties), intent(in) :: faces, sides
      !> The joint at rest, then every step
      type(tenon_step), allocatable, intent(out) :: steps(:)
      !> Set when a setting is refused or a step cannot be solved
      type(error_type), allocatable, intent(out) :: error
      !> Steps at which every point is recorded
      integer, intent(in), optional :: record_at(:)
      !> What was recorded, step after step
      type(tenon_point), allocatable, intent(out), optional :: points(:)
      !> Told after every step
      procedure(tenon_progress), optional :: progress
      !> Where a step of a joint through UINTER failed; memory is taken for it
      type(failed_point), intent(out), optional :: failed
      type(joint_state) :: joint
      type(tenon_step), allocatable :: done(:)
      real(wp), allocatable :: path(:)
      integer, allocatable :: cycle_of(:)
      integer :: i

      if (present(points)) allocate (points(0))
      allocate (steps(0))
      call check_tenon_settings(settings, error)
      if (allocated(error)) return
      call new_tenon_model(joint%at%model, settings, faces, sides, error)
      if (allocated(error)) return
      call tenon_programme(settings, path, cycle_of)
      call check_work(to_text(size(path))//' steps', &
         2_int64*int(storage_size(steps)/8, int64)*size(path), error)
      if (present(failed)) allocate (joint%motions)
      if (.not. allocated(error)) call rest_joint(joint, error)
      if (.not. allocated(error)) deallocate (steps)
      allocate (done(0:ubound(path, 1)))
      do i = 0, ubound(path, 1)
         if (allocated(error)) exit
         if (i > 0) call turn_joint(joint, path(i)/settings%arm, error)
         if (allocated(error)) then
            error%message = 'step '//to_text(i)//', displacement '//to_text(path(i), 6)//' mm: '// &
               error%message
            if (present(failed)) call find_failed(joint, failed)
            exit
         end if
         done(i) = step_of(joint, i, cycle_of(i), path(i))
         if (i > 0) done(i)%validity = ior(done(i)%validity, done(i - 1)%validity)
         if (present(points) .and. present(record_at)) then
            if (any(record_at == i)) call record_points(joint%at, i, points)
         end if
         if (present(progress)) call progress(i, ubound(path, 1))
         call check_pull_out(joint, i, path(i), error)
      end do
      if (.not. allocated(steps)) then
         allocate (steps(0:i - 1))
         steps(:) = done(:i - 1)
      end if
   end subroutine run_tenon

   !> The point at which an increment failed.
   subroutine find_failed(joint, failed)
      type(joint_state), intent(inout) :: joint
      type(failed_point), intent(inout) :: failed
      type(error_type), allocatable :: no_memory

      if (.not. allocated(joint%motions%values)) return
      call add_motions(joint%motions, joint%at, no_memory)
      if (.not. allocated(no_memory)) call failed_motion(joint%motions, joint%at, failed%path, &
         failed%properties, failed%point)
   end subroutine find_failed

   !> `error` is set when the tenon is half out.
   pure subroutine check_pull_out(joint, number, displacement, error)
      type(joint_state), intent(in) :: joint
      integer, intent(in) :: number
      real(wp), intent(in) :: displacement
      type(error_type), allocatable, intent(out) :: error

      associate (length => joint%at%model%settings%length)
         if (abs(joint%at%position(1)) > tenon_largest_pull_out*length) call fatal_error(error, &
            'step '//to_text(number)//', displacement '//to_text(displacement, 6)// &
            ' mm: the tenon has moved '//to_text(joint%at%position(1), 4)//' mm along its '// &
            'axis, more than half its length: the overlap, not the contact, governs; hold it '// &
            'by axial_rule or side_pressure', computation_error)
      end associate
   end subroutine check_pull_out

end module asperity_replay_tenon_run
