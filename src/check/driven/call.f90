!> A user routine made ready, and called for one point, whichever of the two it is.
module asperity_check_driven_call
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_kinds, only: wp
   use asperity_check_driven_call_uinter, only: call_uinter, new_uinter_layout
   use asperity_check_driven_call_vuinter, only: call_vuinter, new_vuinter_layout
   use asperity_check_driven_point, only: point_answer, point_motion, point_start, same_answer
   use asperity_check_driven_routine, only: driven_routine
   use asperity_check_settings, only: check_settings
   implicit none
   private
   public :: new_uinter, new_vuinter, call_routine, usual_ndir, repeats

contains

   !> A UINTER.
   subroutine new_uinter(routine, uinter, settings, ndir)
      !> Result
      type(driven_routine), intent(out) :: routine
      !> The user's
      procedure(uinter_interface) :: uinter
      !> Its properties and state
      type(check_settings), intent(in) :: settings
      !> Components
      integer, intent(in) :: ndir

      routine%uinter => uinter
      routine%props = settings%properties
      routine%nstatv = settings%nstatv
      routine%ndir = ndir
      call new_uinter_layout(routine%layout, ndir, settings%nstatv, size(settings%properties))
   end subroutine new_uinter

   !> A VUINTER, for one node or for several.
   subroutine new_vuinter(routine, vuinter, settings, ndir, nodes)
      !> Result
      type(driven_routine), intent(out) :: routine
      !> The user's
      procedure(vuinter_interface) :: vuinter
      !> Its properties, state and precision
      type(check_settings), intent(in) :: settings
      !> Components, slave nodes
      integer, intent(in) :: ndir, nodes

      routine%vuinter => vuinter
      routine%props = settings%properties
      routine%nstatv = settings%nstatv
      routine%ndir = ndir
      call new_vuinter_layout(routine%layout, ndir, settings%nstatv, size(settings%properties), &
         nodes, settings%single_precision)
   end subroutine new_vuinter

   !> Components that a routine is tried with first.
   pure integer function usual_ndir(settings)
      !> The settings
      type(check_settings), intent(in) :: settings

      usual_ndir = settings%ndir
      if (settings%ndir == 0) usual_ndir = 3
   end function usual_ndir

   !> Whether a routine repeats itself, as else a difference is another rule's.
   logical function repeats(routine, start, motion)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> The point at the start of the increment, and its motion
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      ! chance is not the same so often
      integer, parameter :: times = 4
      type(point_answer) :: first, again
      integer :: i

      repeats = .true.
      call call_routine(routine, start, motion, first)
      do i = 1, times
         call call_routine(routine, start, motion, again)
         repeats = repeats .and. same_answer(first, again)
      end do
   end function repeats

   !> Call a routine for one point.
   subroutine call_routine(routine, start, motion, answer)
      !> The routine; a VUINTER for one node
      type(driven_routine), intent(in) :: routine
      !> The point at the start of the increment, and its motion
      type(point_start), intent(in) :: start
      type(point_motion), intent(in) :: motion
      !> Result
      type(point_answer), intent(out) :: answer
      type(point_start), allocatable :: starts(:)
      type(point_motion) :: motions(1)
      type(point_answer), allocatable :: answers(:)

      if (associated(routine%uinter)) then
         call call_uinter(routine, start, motion, answer)
         return
      end if
      allocate (starts(1), answers(1))
      starts(1) = start
      motions(1) = motion
      call call_vuinter(routine, starts, motions, answers)
      answer = answers(1)
   end subroutine call_routine

end module asperity_check_driven_call
