!> What ABAQUS tells user subroutines of the course of a job: UEXTERNALDB at the beginning and end
!> of job, step and increment, URDFIL after every increment. They are called if UINTER's file has
!> them.
module asperity_calculix_events
   use asperity_base_kinds, only: wp
   use asperity_calculix_ccx_state, only: host
   use asperity_calculix_interactions, only: has_interactions
   use asperity_calculix_refusal, only: refuse
   implicit none
   private
   public :: begin_attempt, end_increment, end_job

   enum, bind(c)
      !> LOP of UEXTERNALDB
      enumerator :: start_of_job = 0, start_of_increment, end_of_increment, end_of_job, &
         start_of_restart, start_of_step, end_of_step
   end enum

   !> Where the job is; CalculiX' routines have no argument that could carry it
   type :: progress_type
      !> Step and increment, step time and total time at the end of the last increment, its length
      integer :: step = 0, increment = 0
      real(wp) :: time(2) = 0.0_wp, length = 0.0_wp
      !> An increment has begun and has not converged
      logical :: under_way = .false.
      !> URDFIL asked for the end
      logical :: stopped = .false.
   end type progress_type
   type(progress_type) :: progress

contains

   !> An evaluation of forces begins: is it the first of an attempt at an increment?
   subroutine begin_attempt() bind(c)

      if (.not. has_interactions()) return
      if (.not. host%new_attempt .or. .not. host%time > 0.0_wp) return
      if (progress%stopped) call refuse('URDFIL ended the analysis, by LSTOP = 1')
      if (progress%step == 0) then
         call tell(merge(start_of_restart, start_of_job, host%resumed), [0.0_wp, host%total], &
            0.0_wp, host%step - 1, 0)
      end if
      if (host%step /= progress%step) then
         call finish_step()
         progress%step = host%step
         progress%time = [0.0_wp, host%total]
         call tell(start_of_step, progress%time, 0.0_wp, host%step, 0)
      end if
      progress%increment = host%number
      progress%under_way = .true.
      call tell(start_of_increment, progress%time, host%increment, host%step, host%number)
   end subroutine begin_attempt

   !> An increment has converged.
   subroutine end_increment(step, increment, step_time, total_time, length)
      !> Where it was, and how long
      integer, intent(in) :: step, increment
      real(wp), intent(in) :: step_time, total_time, length
      external :: urdfil
      integer :: stopping, overwriting
      real(wp) :: changed

      progress%under_way = .false.
      progress%time = [step_time, total_time]
      progress%length = length
      call tell(end_of_increment, progress%time, length, step, increment)
      stopping = 0
      overwriting = 0
      changed = length
      call urdfil(stopping, overwriting, step, increment, changed, progress%time)
      progress%stopped = stopping == 1
   end subroutine end_increment

   !> The job ends, whatever the reason.
   subroutine end_job() bind(c)

      if (progress%step == 0) return
      call finish_step()
      call tell(end_of_job, progress%time, progress%length, progress%step, progress%increment)
   end subroutine end_job

   !> The step that was last has come to its end, unless an increment did not converge.
   subroutine finish_step()

      if (progress%step > 0 .and. .not. progress%under_way) call tell(end_of_step, &
         progress%time, progress%length, progress%step, progress%increment)
   end subroutine finish_step

   subroutine tell(lop, time, length, step, increment)
      integer, intent(in) :: lop, step, increment
      real(wp), intent(in) :: time(2), length
      external :: uexternaldb

      call uexternaldb(lop, 0, time, length, step, increment)
   end subroutine tell

end module asperity_calculix_events
