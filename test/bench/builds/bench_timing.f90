!> Time measured fairly: contenders take turns, round by round, so that a drift of the machine
!> hits all alike, and every round lasts long enough for the clock.
module bench_timing
   use, intrinsic :: iso_fortran_env, only: int64
   use asperity, only: wp
   implicit none
   private
   public :: contender, contender_box, plan_type, spread_type, elapsed_since, measure, spread_of, &
      tick

   !> Something to be timed.
   type, abstract :: contender
      !> Its name in tables
      character(len=60) :: name = ''
      !> Points that one pass handles
      integer :: points = 0
      !> Sum over results, so that none of them can be left out by a compiler
      real(wp) :: checksum = 0.0_wp
   contains
      !> Handle all points once.
      procedure(pass_interface), deferred :: pass
   end type contender

   !> One place in a list of contenders.
   type :: contender_box
      class(contender), allocatable :: item
   end type contender_box

   abstract interface
      subroutine pass_interface(this)
         import :: contender
         implicit none
         class(contender), intent(inout) :: this
      end subroutine pass_interface
   end interface

   !> How long and how often.
   type :: plan_type
      !> Rounds
      integer :: repeats = 25
      !> Least time of one contender in one round, s
      real(wp) :: least = 0.01_wp
      !> Time for all rounds together, s: beyond it there are fewer rounds, but never fewer than
      real(wp) :: most = 40.0_wp
      integer :: fewest_repeats = 5
   end type plan_type

   !> Median, and the 10 and 90 % quantiles.
   type :: spread_type
      real(wp) :: median = 0.0_wp, low = 0.0_wp, high = 0.0_wp
   end type spread_type

contains

   !> Time every contender; `times(round, contender)` are seconds a point. The first passes, which
   !> warm up and settle how many passes make a round, do not count.
   subroutine measure(list, plan, times)
      !> Contenders
      type(contender_box), intent(inout) :: list(:)
      !> How long and how often
      type(plan_type), intent(in) :: plan
      !> Seconds a point
      real(wp), allocatable, intent(out) :: times(:, :)
      integer :: passes(size(list)), repeats, i, round
      real(wp) :: duration, round_time

      round_time = 0.0_wp
      do i = 1, size(list)
         call find_passes(list(i)%item, plan%least, passes(i), duration)
         round_time = round_time + duration
      end do
      repeats = plan%repeats
      if (repeats*round_time > plan%most) &
         repeats = max(min(plan%fewest_repeats, repeats), int(plan%most/round_time))
      allocate (times(repeats, size(list)))
      do round = 1, repeats
         do i = 1, size(list)
            times(round, i) = time_of(list(i)%item, passes(i)) &
               /(real(passes(i), wp)*real(list(i)%item%points, wp))
         end do
      end do
   end subroutine measure

   !> Passes that take `least` seconds, with some to spare, and what they take.
   subroutine find_passes(item, least, passes, duration)
      class(contender), intent(inout) :: item
      real(wp), intent(in) :: least
      integer, intent(out) :: passes
      real(wp), intent(out) :: duration

      passes = 1
      duration = time_of(item, passes)
      do
         duration = time_of(item, passes)
         if (duration >= least) exit
         ! at most tenfold, as a first short time means little
         passes = ceiling(passes*min(10.0_wp, 1.2_wp*least/max(duration, 1.0e-9_wp)))
      end do
   end subroutine find_passes

   !> Wall-clock time of so many passes, s.
   function time_of(item, passes) result(duration)
      class(contender), intent(inout) :: item
      integer, intent(in) :: passes
      real(wp) :: duration
      integer(int64) :: start
      integer :: i

      start = tick()
      do i = 1, passes
         call item%pass()
      end do
      duration = elapsed_since(start)
   end function time_of

   !> Wall clock now, in its own unit.
   function tick() result(count)
      integer(int64) :: count

      call system_clock(count)
   end function tick

   !> Seconds since `start`, a `tick`.
   function elapsed_since(start) result(duration)
      integer(int64), intent(in) :: start
      real(wp) :: duration
      integer(int64) :: now, rate

      call system_clock(now, rate)
      duration = real(now - start, wp)/real(rate, wp)
   end function elapsed_since

   !> Median and quantiles of some numbers.
   pure function spread_of(numbers) result(spread)
      real(wp), intent(in) :: numbers(:)
      type(spread_type) :: spread
      real(wp) :: sorted(size(numbers)), moved
      integer :: i, j

      sorted = numbers
      do i = 2, size(sorted)
         moved = sorted(i)
         do j = i - 1, 1, -1
            if (sorted(j) <= moved) exit
            sorted(j + 1) = sorted(j)
         end do
         sorted(j + 1) = moved
      end do
      spread = spread_type(quantile(sorted, 0.5_wp), quantile(sorted, 0.1_wp), &
         quantile(sorted, 0.9_wp))
   end function spread_of

   !> Quantile of sorted numbers, linear between them.
   pure function quantile(sorted, share) result(q)
      real(wp), intent(in) :: sorted(:), share
      real(wp) :: q, place
      integer :: i

      place = 1.0_wp + share*(size(sorted) - 1)
      i = min(int(place), max(1, size(sorted) - 1))
      q = sorted(i) + (place - i)*(sorted(min(i + 1, size(sorted))) - sorted(i))
   end function quantile

end module bench_timing
