!> One tenon joint under hard contact or under the rough law: the replay and what follows from it.
module asperity_program_commands_tenon_compare_models
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_program_commands_joint_loops, only: analyse_loops, joint_loops, model_names, rough
   use asperity_program_commands_tenon_joint_keys, only: tenon_case
   use asperity_replay_tenon_geometry, only: bearing_faces
   use asperity_replay_tenon_points, only: tenon_point
   use asperity_replay_tenon_run, only: run_tenon, tenon_progress
   use asperity_replay_tenon_settings, only: tenon_settings
   use asperity_replay_tenon_step, only: tenon_step
   implicit none
   private
   public :: joint_type, run_joint, check_moment, steps_to_record, last_kept_steps

   !> Forces over strength times width times length up to which they are round-off: what the solver
   !> lets pass is below
   real(wp), parameter :: round_off = 1.0e-8_wp

   !> Way back after a turn over the amplitude at which the contact is looked at
   real(wp), parameter :: turned = 0.02_wp

   !> Steps whose contact is shown face by face
   integer, parameter :: most_shown = 2

   !> Replay of one model.
   type, extends(joint_loops) :: joint_type
      !> The joint at rest, then every step
      type(tenon_step), allocatable :: steps(:)
      !> Every contact point at the steps asked for
      type(tenon_point), allocatable :: points(:)
      !> Whether upper or lower face or a shoulder touches in some step
      logical :: touches = .true.
   end type joint_type

contains

   !> Replay one model and analyse it. `error` is set when a step cannot be solved.
   subroutine run_joint(case, model, joint, error, record, shown)
      !> Joint, programme and faces
      type(tenon_case), intent(in) :: case
      !> `hard` or `rough`
      integer, intent(in) :: model
      !> The replay
      type(joint_type), intent(out) :: joint
      !> Set on failure
      type(error_type), allocatable, intent(out) :: error
      !> Steps at which every point is kept
      integer, intent(in), optional :: record(:)
      !> Told after every step
      procedure(tenon_progress), optional :: shown
      type(tenon_settings) :: settings
      integer(int64) :: began, ended, rate
      real(wp) :: least
      integer :: i

      call system_clock(began, rate)
      joint%model = model
      settings = case%joint
      settings%contact = model_names(model)
      ! UINTER has no hard contact
      settings%through_uinter = settings%through_uinter .and. model == rough
      if (present(record)) then
         call run_tenon(settings, case%properties, case%sides, joint%steps, error, record, &
            joint%points, shown)
      else
         call run_tenon(settings, case%properties, case%sides, joint%steps, error, &
            progress=shown)
      end if
      if (allocated(error)) return
      call system_clock(ended)
      joint%seconds = real(ended - began, wp)/real(rate, wp)
      least = round_off*settings%wood%compression_strengths(2)*settings%width*settings%length
      joint%has_moment = any(abs(joint%steps%force) > least)
      joint%touches = .false.
      do i = 0, ubound(joint%steps, 1)
         if (joint%touches) exit
         joint%touches = any(joint%steps(i)%face_normal(bearing_faces) > least)
      end do
      call analyse_loops(joint, (joint%steps%rotation), (joint%steps%moment), &
         allocated(settings%displacement), error)
   end subroutine run_joint

   !> `error` is set when neither model has a moment in any step: there is nothing to compare.
   subroutine check_moment(joints, error)
      !> Both models
      type(joint_type), intent(in) :: joints(:)
      !> Set when there is nothing to compare
      type(error_type), allocatable, intent(out) :: error

      if (any(joints%has_moment)) return
      call fatal_error(error, 'amplitudes up to '// &
         to_text(maxval(abs(joints(1)%steps%displacement)))//' mm move the joint within its '// &
         'clearance: neither hard nor rough contact carries a moment in any step', &
         subject='amplitudes')
   end subroutine check_moment

   !> Steps that show the largest loop: its first peak, the return to zero, the other peak, and just
   !> after that turn. Those that it lacks are left out.
   pure function steps_to_record(displacement) result(steps)
      !> Displacement of every step from step 0
      real(wp), intent(in) :: displacement(0:)
      integer, allocatable :: steps(:)
      integer :: peak, zero, other, last
      real(wp) :: sign_of_peak

      peak = maxloc(abs(displacement), 1) - 1
      sign_of_peak = sign(1.0_wp, displacement(peak))
      zero = next_zero(displacement, peak, sign_of_peak)
      ! the other peak is as far out as the next turn goes
      other = zero
      do while (other < ubound(displacement, 1))
         if (sign_of_peak*displacement(other + 1) >= sign_of_peak*displacement(other)) exit
         other = other + 1
      end do
      last = other
      do while (last < ubound(displacement, 1))
         if (abs(displacement(last) - displacement(other)) >= turned*abs(displacement(peak))) exit
         last = last + 1
      end do
      steps = [peak]
      if (zero > peak) steps = [steps, zero]
      if (other > zero) steps = [steps, other]
      if (last > other) steps = [steps, last]
   end function steps_to_record

   !> Steps whose contact is shown: the last two of those whose points were kept, which are the turn
   !> of the largest loop and just after it unless others were asked for.
   pure function last_kept_steps(joint) result(steps)
      !> Replay of one model
      type(joint_type), intent(in) :: joint
      integer, allocatable :: steps(:)
      integer :: i

      allocate (steps(0))
      do i = size(joint%points), 1, -1
         if (size(steps) == most_shown) exit
         if (any(steps == joint%points(i)%step)) cycle
         steps = [joint%points(i)%step, steps]
      end do
   end function last_kept_steps

   !> First step from one on at which a displacement of some sign is back at zero or past it.
   pure integer function next_zero(displacement, from, its_sign)
      real(wp), intent(in) :: displacement(0:)
      integer, intent(in) :: from
      real(wp), intent(in) :: its_sign

      do next_zero = from, ubound(displacement, 1) - 1
         if (its_sign*displacement(next_zero) <= 1.0e-9_wp*abs(displacement(from))) return
      end do
      next_zero = ubound(displacement, 1)
   end function next_zero

end module asperity_program_commands_tenon_compare_models
