!> A given motion, increment by increment through a UINTER.
module asperity_replay_path_replay
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_abaqus_host, only: host_point, run_increment
   use asperity_replay_motion_path, only: motion_path
   implicit none
   private
   public :: path_step, replay_path

   !> The end of an increment.
   type :: path_step
      !> Pressure and both shear stresses, MPa
      real(wp) :: traction(3) = 0.0_wp
      !> Stored energy, N/mm
      real(wp) :: stored_energy = 0.0_wp
      !> Frictional, plastic, viscous and creep dissipation since the start, N/mm
      real(wp) :: dissipation(4) = 0.0_wp
      !> LOPENCLOSE and LSTATE
      integer :: lopenclose = -1, lstate = -1
      !> In how many parts it was computed, as UINTER asks for shorter ones
      integer :: parts = 0
      !> STATEV
      real(wp), allocatable :: statev(:)
   end type path_step

contains

   !> Lead a fresh point along a path. `error` names the row that could not be finished.
   subroutine replay_path(path, point, steps, error)
      !> The motion
      type(motion_path), intent(in) :: path
      !> The point, with its UINTER
      type(host_point), intent(inout) :: point
      !> One a row
      type(path_step), allocatable, intent(out) :: steps(:)
      !> Set when UINTER broke its contract or asks for ever shorter increments
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: lengths(size(path%time)), slip(2)
      integer :: i, before

      lengths = path%lengths()
      point%start%time = path%time(1) - lengths(1)
      slip = 0.0_wp
      allocate (steps(size(path%time)))
      do i = 1, size(steps)
         before = point%increments
         slip = path%slip(:, i) - slip
         call run_increment(point, path%overclosure(i), slip(:point%ndir - 1), lengths(i), error)
         if (allocated(error)) then
            error%message = 'row '//to_text(i)//', time = '//to_text(path%time(i))//' s: '// &
               error%message
            return
         end if
         slip = path%slip(:, i)
         associate (step => steps(i), start => point%start)
            step%traction(:point%ndir) = start%stress
            step%stored_energy = start%sed
            step%dissipation = point%dissipation
            step%lopenclose = start%lopenclose
            step%lstate = start%lstate
            step%parts = point%increments - before
            step%statev = start%statev
         end associate
      end do
   end subroutine replay_path

end module asperity_replay_path_replay
