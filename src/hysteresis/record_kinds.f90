!> What a record is, by the way its displacement goes: monotonic, monotonic with unloading, cyclic
!> or one-sided; and which of its reversals make cycles.
!>
!> A reversal on one side makes two peaks of one if the record *returns* between them: more than
!> half way to zero, or until a tenth of the force is left, over at least 5 % of the record's range.
!> All other reversals, such as pauses, back-slips, noise and steps of hand-digitised curves, do
!> not. What is left is
!>
!> - cyclic if it goes to both sides: to the lesser one by 2 % at least of the whole way, less is
!>   noise or slip, by 5 % of the larger peak beside, less is overshoot, and with force in that
!>   direction;
!> - one-sided if it returns twice at least, and loads again after one return from further out than
!>   a fifth of the way: a test that is unloaded once or early (EN 26891, ISO 6891) is no such one;
!> - monotonic otherwise, and one cycle; with unloading if there is any reversal above the
!>   threshold.
module asperity_hysteresis_record_kinds
   use asperity_base_kinds, only: wp
   use asperity_hysteresis_types, only: name_length, negative_side, positive_side, side_sign
   implicit none
   private
   public :: classify

   !> A return leaves this share of the displacement of both peaks
   real(wp), parameter :: return_share = 0.5_wp
   !> ... or this share of their force
   real(wp), parameter :: unloaded_share = 0.1_wp
   !> ... and then goes back by this share of the record's range, more than a back-slip
   real(wp), parameter :: unloaded_way = 0.05_wp
   !> A peak on the other side is less than this share of those beside it: overshoot
   real(wp), parameter :: overshoot_share = 0.05_wp
   !> ... or than this share of the whole way: noise or slip about zero
   real(wp), parameter :: slip_share = 0.02_wp
   !> Returns from within this share of the way are those of a loading procedure before the test
   real(wp), parameter :: early_share = 0.2_wp

contains

   !> Kind of a record, and its turning points between cycles.
   pure subroutine classify(displacement, force, threshold, turns, kind, sides)
      !> The record, zero of displacement where the test began
      real(wp), intent(in) :: displacement(:), force(:)
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> All turning points on entry, those that make cycles on return
      integer, allocatable, intent(inout) :: turns(:)
      !> `monotonic`, `monotonic_with_unloading`, `cyclic` or `one_sided`
      character(len=name_length), intent(out) :: kind
      !> Sides on which peaks count
      logical, intent(out) :: sides(2)
      integer :: all_turns, main, furthest

      all_turns = size(turns)
      call merge_peaks(displacement, force, maxval(displacement) - minval(displacement), turns)
      furthest = turns(maxloc(abs(displacement(turns)), 1))
      main = merge(positive_side, negative_side, displacement(furthest) > 0.0_wp)
      sides = .true.
      if (goes_both_ways(displacement([1, turns]), force([1, turns]), side_sign(main), &
         threshold)) then
         kind = 'cyclic'
         return
      end if
      sides(3 - main) = .false.
      if (returns_often(displacement, force, side_sign(main), turns)) then
         kind = 'one_sided'
      else
         kind = merge('monotonic_with_unloading', 'monotonic               ', all_turns > 1)
         turns = [furthest]
      end if
   end subroutine classify

   !> Take away the valleys between peaks of one side to which the record does not return, each with
   !> the nearer of its peaks.
   pure subroutine merge_peaks(displacement, force, range, turns)
      real(wp), intent(in) :: displacement(:), force(:), range
      integer, allocatable, intent(inout) :: turns(:)
      integer :: kept(size(turns)), i, n
      real(wp) :: s

      n = 0
      do i = 1, size(turns)
         n = n + 1
         kept(n) = turns(i)
         do while (n > 2)
            s = sign(1.0_wp, displacement(kept(n - 1)))
            ! only what is nearer to zero than the peaks beside it is a valley
            if (.not. s*displacement(kept(n)) > s*displacement(kept(n - 1))) exit
            if (is_return(displacement, force, s, kept(n - 1), kept(n - 2), range) .and. &
               is_return(displacement, force, s, kept(n - 1), kept(n), range)) exit
            if (s*displacement(kept(n)) > s*displacement(kept(n - 2))) kept(n - 2) = kept(n)
            n = n - 2
         end do
      end do
      turns = kept(:n)
   end subroutine merge_peaks

   !> Whether the record returns from a peak at a valley, or goes out from it to one.
   pure logical function is_return(displacement, force, s, valley, peak, range)
      real(wp), intent(in) :: displacement(:), force(:), s, range
      integer, intent(in) :: valley, peak

      is_return = s*displacement(valley) <= return_share*s*displacement(peak)
      if (is_return) return
      if (s*(displacement(peak) - displacement(valley)) < unloaded_way*range) return
      is_return = s*force(valley) <= unloaded_share*s*force(peak)
   end function is_return

   !> Whether peaks lie on both sides. `x` and `f` are those of the start and the turning points.
   pure logical function goes_both_ways(x, f, s, threshold)
      real(wp), intent(in) :: x(:), f(:), s, threshold
      integer :: i
      real(wp) :: beside

      goes_both_ways = .false.
      do i = 1, size(x)
         if (.not. -s*x(i) > max(threshold, slip_share*maxval(s*x))) cycle
         beside = maxval(s*x(max(1, i - 1):min(size(x), i + 1)))
         goes_both_ways = beside > threshold .and. -s*x(i) >= overshoot_share*beside &
            .and. s*f(i) < 0.0_wp
         if (goes_both_ways) return
      end do
   end function goes_both_ways

   !> Whether a record of one side returns twice at least, and loads again after a return from far
   !> out.
   pure logical function returns_often(displacement, force, s, turns)
      real(wp), intent(in) :: displacement(:), force(:), s
      integer, intent(in) :: turns(:)
      real(wp) :: way
      integer :: i, n, returns
      logical :: loads_again

      way = maxval(s*displacement)
      n = size(turns)
      returns = 0
      loads_again = .false.
      do i = 2, n
         associate (valley => turns(i), peak => turns(i - 1))
            if (.not. s*displacement(valley) < s*displacement(peak)) cycle
            if (.not. is_return(displacement, force, s, valley, peak, way)) cycle
            returns = returns + 1
            if (i < n) loads_again = loads_again .or. s*displacement(peak) > early_share*way
         end associate
      end do
      returns_often = loads_again .and. returns > 1
   end function returns_often

end module asperity_hysteresis_record_kinds
