!> A user routine with what it is called with at every point, and what the memory around its
!> arguments holds.
module asperity_check_driven_routine
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_abaqus_vuinter_signature, only: vuinter_interface
   use asperity_base_kinds, only: wp
   use asperity_check_driven_layout, only: argument_layout, is_output
   use asperity_check_driven_point, only: point_start
   implicit none
   private
   public :: driven_routine, new_start, fills_of, poison

   !> A UINTER or a VUINTER, one of which is associated.
   type :: driven_routine
      procedure(uinter_interface), pointer, nopass :: uinter => null()
      procedure(vuinter_interface), pointer, nopass :: vuinter => null()
      !> Components of the motion
      integer :: ndir = 3
      !> PROPS; length of STATEV
      real(wp), allocatable :: props(:)
      integer :: nstatv = 0
      !> Where its arguments stand
      type(argument_layout) :: layout
      !> Which of two poisons its outputs hold before a call
      integer :: poison = 1
      !> Argument after which the guard cells are filled otherwise; -1 for none
      integer :: odd_guard = -1
   end type driven_routine

   ! Finite, so that they trap nothing, far from each other and from what a law gives
   real(wp), parameter :: poisons(2) = [0.73914826_wp, -1.28371945_wp]
   real(wp), parameter :: guard_fills(2) = [8191.53718_wp, -0.03718193_wp]

contains

   !> The start of all: nothing has happened.
   pure subroutine new_start(routine, rdisp, start)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> Position, mm
      real(wp), intent(in) :: rdisp(3)
      !> Result
      type(point_start), intent(out) :: start

      allocate (start%statev(routine%nstatv), source=0.0_wp)
      start%rdisp = rdisp
   end subroutine new_start

   !> What the guards hold, from the one before the first argument on.
   pure subroutine fills_of(routine, fills)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> Result, from 0 on
      real(wp), allocatable, intent(out) :: fills(:)

      allocate (fills(0:size(routine%layout%slots)), source=guard_fills(1))
      if (routine%odd_guard >= 0) fills(routine%odd_guard) = guard_fills(2)
   end subroutine fills_of

   !> Poison the outputs; no two entries are alike.
   pure subroutine poison(routine, numbers)
      !> The routine
      type(driven_routine), intent(in) :: routine
      !> All numbers before a call
      real(wp), intent(inout) :: numbers(:)
      integer :: i, k

      do i = 1, size(routine%layout%slots)
         associate (slot => routine%layout%slots(i))
            if (slot%role /= is_output) cycle
            do k = slot%number, slot%number + slot%length - 1
               numbers(k) = poisons(routine%poison) + 1.0e-3_wp*k
            end do
         end associate
      end do
   end subroutine poison

end module asperity_check_driven_routine
