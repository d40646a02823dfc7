!> First-cycle envelope of one side of a record.
!>
!> Of every cycle that goes further out than all before it, by the amplitude tolerance, the samples
!> beyond the largest displacement so far are taken, up to the tip. Cycles of an amplitude that has
!> been reached give nothing, so later, weaker cycles do not lower it. Where the record had been
!> unloaded before, it comes back from below: until its force is that of the last point again, or,
!> if it gets no more so far, its largest beyond that point, it still reloads, and a straight line
!> takes the place of those samples. In a monotonic record what remains is the record without its
!> unloading and reloading. The way back from the tip is never part of it.
!>
!> A side that is reached from the other one may begin with force that the other has left, which is
!> no resistance of its own: if it leaves zero with more than a tenth of the largest force of its
!> first excursion, a straight line from the origin takes the place of that excursion up to the
!> outermost sample with 0.98 of its largest force, which is the tip unless the force peaks before
!> it.
module asperity_hysteresis_envelopes
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: hysteresis_cycle, side_sign
   implicit none
   private
   public :: find_envelope

   !> The record reloads if its force had been lower than this share of what it comes back with. A
   !> drop of force at a crack, with a little way back, is no unloading, and stays
   real(wp), parameter :: unloaded_share = 0.5_wp
   !> Force at zero displacement over the largest of the excursion; the opposite force before, over
   !> it, that may have left it; and what is as good as the largest
   real(wp), parameter :: left_share = 0.1_wp, opposite_share = 0.5_wp, largest_share = 0.98_wp

contains

   !> Samples of the envelope, and the cycle of each.
   pure subroutine find_envelope(displacement, force, side, threshold, tolerance, cycles, samples, &
      origin, left_force)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> One of the two sides
      integer, intent(in) :: side
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Share by which a cycle must go further than all before it
      real(wp), intent(in) :: tolerance
      !> Cycles with their peaks
      type(hysteresis_cycle), intent(in) :: cycles(:)
      !> Samples from the inside to the outside, and their cycles
      integer, allocatable, intent(out) :: samples(:), origin(:)
      !> Force at zero left by the other side, signed, if a straight line goes to the first tip
      real(wp), intent(out) :: left_force
      integer :: found(size(displacement)), of_cycle(size(displacement))
      integer :: i, k, n, first, segment
      real(wp) :: reach, lowest, left
      real(wp), allocatable :: x(:), f(:)

      n = 0
      reach = 0.0_wp
      left = 0.0_wp
      associate (s => side_sign(side))
         ! outwards is positive
         allocate (x, source=s*displacement)
         allocate (f, source=s*force)
         do i = 1, size(cycles)
            if (cycles(i)%peak(side) == 0) cycle
            first = cycles(i)%first
            if (.not. maxval(x(first:cycles(i)%last)) > reach*(1.0_wp + tolerance)) cycle
            if (n == 0) call leave_zero(x, f, threshold, first, left)
            segment = n + 1
            lowest = 0.0_wp
            do k = first, cycles(i)%last
               if (x(k) > reach) then
                  if (n >= segment .and. lowest < unloaded_share*f(k)) then
                     call drop_reloading(f, found, of_cycle, segment, n)
                     segment = n + 1
                  end if
                  n = n + 1
                  found(n) = k
                  of_cycle(n) = i
                  reach = x(k)
                  lowest = f(k)
               else if (n >= segment .and. x(k) >= reach) then
                  ! held at one displacement: the largest force
                  if (f(k) > f(found(n))) found(n) = k
               end if
               lowest = min(lowest, f(k))
            end do
            call drop_reloading(f, found, of_cycle, segment, n)
            if (of_cycle(1) == i) call drop_left(f, left, found, of_cycle, n)
         end do
      end associate
      left_force = side_sign(side)*left
      allocate (samples, source=found(:n))
      allocate (origin, source=of_cycle(:n))
   end subroutine find_envelope

   !> First sample after the record leaves zero for good to go beyond the threshold, and the force
   !> that is left at zero by an opposite one, zero if there has been none.
   pure subroutine leave_zero(x, f, threshold, first, left)
      !> The record, positive outwards
      real(wp), intent(in) :: x(:), f(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> The sample, on entry the first of its cycle, which goes beyond the threshold
      integer, intent(inout) :: first
      !> Force at zero, positive outwards
      real(wp), intent(out) :: left

      left = 0.0_wp
      do while (.not. x(first) > threshold)
         first = first + 1
      end do
      do while (first > 1)
         if (.not. x(first - 1) > 0.0_wp) exit
         first = first - 1
      end do
      if (first == 1) return
      left = f(first - 1) - (f(first) - f(first - 1))*(x(first - 1)/(x(first) - x(first - 1)))
      if (.not. minval(f(:first - 1)) < -opposite_share*left) left = 0.0_wp
   end subroutine leave_zero

   !> Take away the samples of the first excursion whose force another side may have left.
   pure subroutine drop_left(force, left, found, of_cycle, n)
      !> Force, positive outwards
      real(wp), intent(in) :: force(:)
      !> What is left of it at zero displacement; zero on return if it is little
      real(wp), intent(inout) :: left
      !> Samples and their cycles
      integer, intent(inout) :: found(:), of_cycle(:)
      !> Last sample
      integer, intent(inout) :: n
      real(wp) :: largest
      integer :: first

      largest = maxval(force(found(:n)))
      if (.not. largest > 0.0_wp .or. .not. left > left_share*largest) then
         left = 0.0_wp
         return
      end if
      first = n
      do while (force(found(first)) < largest_share*largest)
         first = first - 1
      end do
      n = n - first + 1
      found(:n) = found(first:first + n - 1)
      of_cycle(:n) = of_cycle(first:first + n - 1)
   end subroutine drop_left

   !> Take away the samples of a segment during which the record still reloads.
   pure subroutine drop_reloading(force, found, of_cycle, segment, n)
      !> Force, positive outwards
      real(wp), intent(in) :: force(:)
      !> Samples and their cycles
      integer, intent(inout) :: found(:), of_cycle(:)
      !> First sample of the segment
      integer, intent(in) :: segment
      !> Last sample
      integer, intent(inout) :: n
      real(wp) :: enough
      integer :: drop

      if (segment == 1 .or. n < segment) return
      enough = min(force(found(segment - 1)), maxval(force(found(segment:n))))
      drop = 0
      do while (force(found(segment + drop)) < enough)
         drop = drop + 1
      end do
      found(segment:n - drop) = found(segment + drop:n)
      of_cycle(segment:n - drop) = of_cycle(segment + drop:n)
      n = n - drop
   end subroutine drop_reloading

end module asperity_hysteresis_envelopes
