!> Turning points of a record, and the cycles between them.
module asperity_hysteresis_turning_points
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: hysteresis_cycle
   implicit none
   private
   public :: find_turning_points, cut_cycles

   !> A record that begins so far out, as a share of its first turn, begins at a peak
   real(wp), parameter :: at_peak = 0.5_wp

contains

   !> Samples at which the displacement turns by more than the threshold, alternately largest and
   !> smallest, and at last the extreme after which it has not turned any more. None if the whole
   !> record moves by no more than the threshold.
   pure subroutine find_turning_points(displacement, threshold, turns)
      !> The record
      real(wp), intent(in) :: displacement(:)
      !> Reversals up to this size are passed over
      real(wp), intent(in) :: threshold
      !> Their samples
      integer, allocatable, intent(out) :: turns(:)
      integer, allocatable :: found(:)
      integer :: i, n, direction, lowest, highest

      allocate (found(size(displacement)))
      n = 0
      direction = 0
      lowest = 1
      highest = 1
      do i = 2, size(displacement)
         associate (x => displacement(i))
            if (direction >= 0 .and. x > displacement(highest)) highest = i
            if (direction <= 0 .and. x < displacement(lowest)) lowest = i
            if (direction >= 0 .and. displacement(highest) - x > threshold) then
               if (direction > 0) call append(found, n, highest)
               direction = -1
               lowest = i
            else if (direction <= 0 .and. x - displacement(lowest) > threshold) then
               if (direction < 0) call append(found, n, lowest)
               direction = 1
               highest = i
            end if
         end associate
      end do
      if (direction > 0) call append(found, n, highest)
      if (direction < 0) call append(found, n, lowest)
      allocate (turns, source=found(:n))

   end subroutine find_turning_points

   pure subroutine append(list, n, sample)
      integer, intent(inout) :: list(:), n
      integer, intent(in) :: sample

      n = n + 1
      list(n) = sample
   end subroutine append

   !> Cut a record into cycles of two turning points each. One cycle ends and the next begins where
   !> the displacement passes zero, or comes nearest to it, between the second turning point of the
   !> one and the first of the other. A record that begins at a peak is cut at its peaks instead.
   !> A last turning point that does not lead outwards again begins no cycle. The last cycle ends
   !> with the record.
   pure subroutine cut_cycles(displacement, force, threshold, turns, cycles)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Its turning points, one at least
      integer, intent(in) :: turns(:)
      !> Samples and ends of the cycles
      type(hysteresis_cycle), allocatable, intent(out) :: cycles(:)
      real(wp) :: lead
      integer :: i, n, turn
      logical :: from_peak

      ! The first turning point is a largest displacement if the record rises to it
      lead = sign(1.0_wp, displacement(turns(1)) - displacement(1))
      from_peak = -lead*displacement(1) > at_peak*abs(displacement(turns(1))) &
         .and. -lead*displacement(1) > threshold
      if (from_peak) then
         n = (size(turns) + 1)/2
      else
         n = size(turns)/2
         if (modulo(size(turns), 2) == 1) then
            ! only one that leads outwards begins a cycle
            if (n == 0 .or. lead*displacement(turns(size(turns))) > threshold) n = n + 1
         end if
      end if

      allocate (cycles(n))
      cycles(1)%first = 1
      cycles(1)%start_displacement = displacement(1)
      cycles(1)%start_force = force(1)
      cycles(n)%last = size(displacement)
      cycles(n)%end_displacement = displacement(size(displacement))
      cycles(n)%end_force = force(size(displacement))
      do i = 1, n - 1
         turn = 2*i
         if (from_peak) then
            call cut_at_sample(cycles(i), cycles(i + 1), turns(turn), displacement, force)
         else
            call cut_near_zero(cycles(i), cycles(i + 1), turns(turn), turns(turn + 1), &
               displacement, force)
         end if
      end do
      do i = 1, n
         cycles(i)%closed = abs(cycles(i)%end_displacement - cycles(i)%start_displacement) &
            <= threshold
      end do
   end subroutine cut_cycles

   !> Cut at a sample, which then belongs to both cycles.
   pure subroutine cut_at_sample(before, after, sample, displacement, force)
      type(hysteresis_cycle), intent(inout) :: before, after
      integer, intent(in) :: sample
      real(wp), intent(in) :: displacement(:), force(:)

      before%last = sample
      before%end_displacement = displacement(sample)
      before%end_force = force(sample)
      after%first = sample
      after%start_displacement = displacement(sample)
      after%start_force = force(sample)
   end subroutine cut_at_sample

   !> Cut where the record first passes zero between two samples, or at the one nearest to zero.
   pure subroutine cut_near_zero(before, after, from, to, displacement, force)
      type(hysteresis_cycle), intent(inout) :: before, after
      integer, intent(in) :: from, to
      real(wp), intent(in) :: displacement(:), force(:)
      integer :: i, nearest

      nearest = from
      do i = from, to
         if (abs(displacement(i)) < abs(displacement(nearest))) nearest = i
         if (i == to) exit
         if (min(displacement(i), displacement(i + 1)) < 0.0_wp .and. &
            max(displacement(i), displacement(i + 1)) > 0.0_wp) then
            before%last = i
            after%first = i + 1
            before%end_displacement = 0.0_wp
            before%end_force = force(i) + (force(i + 1) - force(i)) &
               *(displacement(i)/(displacement(i) - displacement(i + 1)))
            after%start_displacement = 0.0_wp
            after%start_force = before%end_force
            return
         end if
         if (.not. abs(displacement(i)) > 0.0_wp) exit
      end do
      call cut_at_sample(before, after, nearest, displacement, force)
   end subroutine cut_near_zero

end module asperity_hysteresis_turning_points
