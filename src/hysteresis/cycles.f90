!> What one cycle of a record says: peaks, stiffness, energy, damping, pinching.
module asperity_hysteresis_cycles
   use asperity_base_constants, only: pi
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_types, only: hysteresis_cycle, negative_side, positive_side, side_sign
   implicit none
   private
   public :: find_peaks, measure_cycles

   !> A loop with so much less than no area, as a share of the rectangle of its peaks, gives energy
   !> back, which is no damping
   real(wp), parameter :: given_back = 0.02_wp
   !> A half cycle begins and ends without force if it has less than this share of its peak's
   real(wp), parameter :: unloaded_share = 0.1_wp

contains

   !> Find the peak of a cycle on each side where it comes further out than the threshold. Of
   !> samples equally far out the one with the larger force counts, and the other way round.
   pure subroutine find_peaks(displacement, force, threshold, sides, by_force, loop)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Sides on which peaks count
      logical, intent(in) :: sides(2)
      !> The peak is the largest force rather than the largest displacement
      logical, intent(in) :: by_force
      !> The cycle, whose samples are known
      type(hysteresis_cycle), intent(inout) :: loop
      integer :: i, side, best

      do side = positive_side, negative_side
         if (.not. sides(side)) cycle
         best = 0
         associate (s => side_sign(side))
            do i = loop%first, loop%last
               if (.not. s*displacement(i) > threshold) cycle
               if (best == 0) then
                  best = i
               else if (by_force) then
                  if (is_beyond(s*force(i), s*displacement(i), s*force(best), &
                     s*displacement(best))) best = i
               else
                  if (is_beyond(s*displacement(i), s*force(i), s*displacement(best), &
                     s*force(best))) best = i
               end if
            end do
         end associate
         loop%peak(side) = best
         if (best == 0) cycle
         loop%displacement(side) = displacement(best)
         loop%force(side) = force(best)
      end do
   end subroutine find_peaks

   !> Whether (a, b) is beyond (c, d): a > c, or the same and b > d.
   pure logical function is_beyond(a, b, c, d)
      real(wp), intent(in) :: a, b, c, d

      is_beyond = a > c .or. (a >= c .and. b > d)
   end function is_beyond

   !> Stiffness, energy and shape of all cycles, whose ends and peaks are known. Nothing but energy
   !> is formed of a cycle whose forces are zero.
   pure subroutine measure_cycles(displacement, force, threshold, force_floor, cycles)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Forces up to this size are zero
      real(wp), intent(in) :: force_floor
      !> The cycles
      type(hysteresis_cycle), intent(inout) :: cycles(:)
      real(wp) :: total
      logical :: loaded
      integer :: i

      total = 0.0_wp
      do i = 1, size(cycles)
         loaded = any(cycles(i)%peak > 0 .and. abs(cycles(i)%force) > force_floor)
         if (loaded) call measure_stiffness(cycles(i))
         if (.not. any(is_none(cycles([1, i])%secant_stiffness)) .and. &
            cycles(1)%secant_stiffness > 0.0_wp) &
            cycles(i)%stiffness_ratio = cycles(i)%secant_stiffness/cycles(1)%secant_stiffness
         cycles(i)%energy = work(cycles(i), displacement, force)
         total = total + cycles(i)%energy
         cycles(i)%cumulative_energy = total
         if (loaded .and. cycles(i)%closed .and. all(cycles(i)%peak > 0)) &
            call measure_shape(cycles(i), displacement, force, threshold)
         if (loaded) call measure_halves(cycles(i), displacement, force, threshold)
      end do
   end subroutine measure_cycles

   !> Secant stiffness of both peaks in either way, or of the one there is. Differences rather than
   !> absolute values: they are the same, unless the force of a small peak has the wrong sign.
   pure subroutine measure_stiffness(loop)
      type(hysteresis_cycle), intent(inout) :: loop
      logical :: there(2)

      there = loop%peak > 0
      if (.not. any(there)) return
      loop%secant_stiffness = sum(side_sign*loop%force, mask=there) &
         /sum(side_sign*loop%displacement, mask=there)
      ! the threshold lies between a peak and zero
      loop%mean_secant_stiffness = sum(loop%force/loop%displacement, mask=there)/count(there)
   end subroutine measure_stiffness

   !> Work of the force along a cycle, by the trapezoidal rule in the record's own order.
   pure real(wp) function work(loop, displacement, force)
      type(hysteresis_cycle), intent(in) :: loop
      real(wp), intent(in) :: displacement(:), force(:)
      integer :: i

      work = trapezoid(loop%start_displacement, loop%start_force, &
         displacement(loop%first), force(loop%first))
      do i = loop%first, loop%last - 1
         work = work + trapezoid(displacement(i), force(i), displacement(i + 1), force(i + 1))
      end do
      work = work + trapezoid(displacement(loop%last), force(loop%last), &
         loop%end_displacement, loop%end_force)
   end function work

   pure real(wp) function trapezoid(x1, f1, x2, f2)
      real(wp), intent(in) :: x1, f1, x2, f2

      trapezoid = 0.5_wp*(f1 + f2)*(x2 - x1)
   end function trapezoid

   !> Area, damping, pinching and fullness of a closed cycle with two peaks; the area alone if it
   !> gives energy back, or if its peaks are the wrong way round.
   pure subroutine measure_shape(loop, displacement, force, threshold)
      type(hysteresis_cycle), intent(inout) :: loop
      real(wp), intent(in) :: displacement(:), force(:), threshold
      real(wp) :: product, height, width, between, after
      logical :: crosses
      integer :: earlier, later

      associate (x => loop%displacement, f => loop%force)
         loop%loop_area = loop%energy + trapezoid(loop%end_displacement, loop%end_force, &
            loop%start_displacement, loop%start_force)
         height = f(positive_side) - f(negative_side)
         width = x(positive_side) - x(negative_side)
         if (.not. height > 0.0_wp) return
         if (loop%loop_area < -given_back*height*width) return
         product = 0.5_wp*sum(f*x)
         if (product > 0.0_wp) loop%damping = loop%loop_area/(2.0_wp*pi*product)
         loop%fullness = loop%loop_area/(height*width)

         earlier = minval(loop%peak)
         later = maxval(loop%peak)
         call force_at_zero(displacement(earlier:later), force(earlier:later), between, crosses)
         if (.not. crosses) return
         call force_at_zero(displacement(later:loop%last), force(later:loop%last), after, crosses)
         if (.not. crosses) call force_at_zero([displacement(loop%last), loop%end_displacement], &
            [force(loop%last), loop%end_force], after, crosses)
         if (.not. crosses) call force_at_zero(displacement(loop%first:earlier), &
            force(loop%first:earlier), after, crosses)
         if (.not. crosses) then
            if (abs(loop%end_displacement) > threshold) return
            after = loop%end_force
         end if
         ! from the positive peak the record comes back with the lower force
         loop%pinching = sign(1.0_wp, real(later - loop%peak(positive_side), wp) - 0.5_wp) &
            *(after - between)/height
      end associate
   end subroutine measure_shape

   !> Work and damping of both halves of a cycle, cut at zero displacement. Where a half begins or
   !> ends without force away from zero, the axis closes it.
   pure subroutine measure_halves(loop, displacement, force, threshold)
      type(hysteresis_cycle), intent(inout) :: loop
      real(wp), intent(in) :: displacement(:), force(:), threshold
      integer :: i, side
      real(wp) :: work

      do side = positive_side, negative_side
         if (loop%peak(side) == 0) cycle
         associate (s => side_sign(side), x => loop%displacement(side), f => loop%force(side))
            if (.not. x*f > 0.0_wp) cycle
            if (.not. loop%closed) then
               if (is_under_way(s*loop%start_displacement, loop%start_force, f, threshold)) cycle
               if (is_under_way(s*loop%end_displacement, loop%end_force, f, threshold)) cycle
            end if
            work = work_beyond(s, loop%start_displacement, loop%start_force, &
               displacement(loop%first), force(loop%first))
            do i = loop%first, loop%last - 1
               work = work + work_beyond(s, displacement(i), force(i), displacement(i + 1), &
                  force(i + 1))
            end do
            work = work + work_beyond(s, displacement(loop%last), force(loop%last), &
               loop%end_displacement, loop%end_force)
            if (loop%closed) work = work + work_beyond(s, loop%end_displacement, loop%end_force, &
               loop%start_displacement, loop%start_force)
            loop%half_energy(side) = work
            if (work >= -given_back*x*f) loop%half_damping(side) = work/(pi*x*f)
         end associate
      end do
   end subroutine measure_halves

   !> Whether an end of a cycle lies out on a side, and under force.
   pure logical function is_under_way(x, force, peak, threshold)
      real(wp), intent(in) :: x, force, peak, threshold

      is_under_way = x > threshold .and. abs(force) > unloaded_share*abs(peak)
   end function is_under_way

   !> Work along a straight line, of its part on one side of zero displacement.
   pure real(wp) function work_beyond(s, x1, f1, x2, f2) result(work)
      real(wp), intent(in) :: s, x1, f1, x2, f2
      real(wp) :: at_zero

      work = 0.0_wp
      if (max(s*x1, s*x2) <= 0.0_wp) return
      work = trapezoid(x1, f1, x2, f2)
      if (min(s*x1, s*x2) >= 0.0_wp) return
      at_zero = f1 + (f2 - f1)*(x1/(x1 - x2))
      if (s*x1 < 0.0_wp) work = trapezoid(0.0_wp, at_zero, x2, f2)
      if (s*x2 < 0.0_wp) work = trapezoid(x1, f1, 0.0_wp, at_zero)
   end function work_beyond

   !> Force where the displacement first comes to zero.
   pure subroutine force_at_zero(displacement, force, at_zero, crosses)
      real(wp), intent(in) :: displacement(:), force(:)
      real(wp), intent(out) :: at_zero
      logical, intent(out) :: crosses
      integer :: i

      at_zero = 0.0_wp
      crosses = .false.
      do i = 1, size(displacement) - 1
         if (min(displacement(i), displacement(i + 1)) > 0.0_wp .or. &
            max(displacement(i), displacement(i + 1)) < 0.0_wp) cycle
         crosses = .true.
         at_zero = force(i + 1)
         if (abs(displacement(i + 1)) > 0.0_wp) at_zero = force(i) &
            + (force(i + 1) - force(i))*(displacement(i)/(displacement(i) - displacement(i + 1)))
         return
      end do
   end subroutine force_at_zero

end module asperity_hysteresis_cycles
