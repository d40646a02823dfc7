!> Skeleton of one side of a record, and its stiffness, yield and ultimate point.
module asperity_hysteresis_skeletons
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_curves, only: displacement_at, find_ultimate, outward, peak_of, &
      rises_from_zero
   use asperity_hysteresis_envelopes, only: find_envelope
   use asperity_hysteresis_types, only: hysteresis_cycle, hysteresis_settings, &
      hysteresis_skeleton, initial_fraction, side_sign
   implicit none
   private
   public :: new_skeleton, evaluate_skeleton

   !> Round-off of the equal-energy equation
   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Yield force over peak force where that equation has no solution (ASTM E2126)
   real(wp), parameter :: assumed_yield = 0.85_wp

contains

   !> The first-cycle envelope, or the peaks of the first cycle at each amplitude. A record with a
   !> single peak, such as a monotonic test, is its own skeleton whatever the definition.
   pure subroutine new_skeleton(displacement, force, side, threshold, settings, cycles, skeleton)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> One of the two sides
      integer, intent(in) :: side
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Definition of the peaks; a peak has a new amplitude if it is larger than all before it by a
      !> share
      type(hysteresis_settings), intent(in) :: settings
      !> Cycles with their peaks; those in the skeleton are marked
      type(hysteresis_cycle), intent(inout) :: cycles(:)
      !> Its points are set
      type(hysteresis_skeleton), intent(out) :: skeleton
      integer, allocatable :: samples(:), origin(:)
      logical :: own
      integer :: i

      own = size(cycles) == 1 .and. count(cycles(1)%peak > 0) == 1
      if (own .or. settings%peaks == 'envelope') then
         call find_envelope(displacement, force, side, threshold, settings%amplitude_tolerance, &
            cycles, samples, origin, skeleton%left_force)
      else
         call find_first_peaks(side, settings%amplitude_tolerance, cycles, samples, origin)
      end if
      do i = 1, size(origin)
         cycles(origin(i))%in_skeleton(side) = .true.
      end do
      if (own) origin = 0
      allocate (skeleton%displacement(size(samples)), skeleton%force(size(samples)))
      skeleton%displacement(:) = displacement(samples)
      skeleton%force(:) = force(samples)
      call move_alloc(origin, skeleton%cycle)
      call find_largest(displacement, force, side, threshold, skeleton)
   end subroutine new_skeleton

   !> Peaks of the first cycle at each amplitude.
   pure subroutine find_first_peaks(side, tolerance, cycles, samples, origin)
      integer, intent(in) :: side
      real(wp), intent(in) :: tolerance
      type(hysteresis_cycle), intent(in) :: cycles(:)
      integer, allocatable, intent(out) :: samples(:), origin(:)
      logical :: is_first(size(cycles))
      real(wp) :: largest
      integer :: i

      is_first = .false.
      largest = 0.0_wp
      do i = 1, size(cycles)
         if (cycles(i)%peak(side) == 0) cycle
         associate (x => side_sign(side)*cycles(i)%displacement(side))
            is_first(i) = x > largest*(1.0_wp + tolerance)
            if (is_first(i)) largest = x
         end associate
      end do
      origin = pack([(i, i=1, size(cycles))], is_first)
      samples = [(cycles(origin(i))%peak(side), i=1, size(origin))]
   end subroutine find_first_peaks

   !> The record's largest force on a side.
   pure subroutine find_largest(displacement, force, side, threshold, skeleton)
      real(wp), intent(in) :: displacement(:), force(:), threshold
      integer, intent(in) :: side
      type(hysteresis_skeleton), intent(inout) :: skeleton
      real(wp) :: largest
      integer :: i

      largest = 0.0_wp
      associate (s => side_sign(side))
         do i = 1, size(force)
            if (.not. s*force(i) > largest) cycle
            if (.not. s*displacement(i) > threshold) cycle
            largest = s*force(i)
            skeleton%record_sample = i
         end do
      end associate
      if (skeleton%record_sample == 0) return
      skeleton%record_displacement = displacement(skeleton%record_sample)
      skeleton%record_force = force(skeleton%record_sample)
   end subroutine find_largest

   !> Stiffness, peak, ultimate point and yield point of a skeleton whose points are set.
   pure subroutine evaluate_skeleton(side, settings, threshold, force_floor, skeleton)
      !> One of the two sides
      integer, intent(in) :: side
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Forces up to this size are zero
      real(wp), intent(in) :: force_floor
      !> Shares of the peak force
      type(hysteresis_settings), intent(in) :: settings
      !> Skeleton; it keeps its numbers unknown if the force never has the sign of displacement.
      !> Where its first point has the force of the elastic stiffness already, at all but zero
      !> displacement, the record has no sample of the rise: there is no stiffness, and no yield
      !> point
      type(hysteresis_skeleton), intent(inout) :: skeleton
      real(wp), allocatable :: x(:), f(:)
      real(wp) :: elastic, initial, last_x, last_f
      integer :: peak

      if (size(skeleton%force) == 0) return
      associate (s => side_sign(side), share => settings%elastic_fraction)
         call outward(s, skeleton, x, f)
         if (.not. maxval(f) > force_floor) return
         peak = peak_of(f)
         skeleton%peak_displacement = s*x(peak)
         skeleton%peak_force = s*f(peak)

         if (rises_from_zero(x, f, peak, share, threshold)) then
            elastic = displacement_at(x, f, share*f(peak))
            initial = displacement_at(x, f, initial_fraction*f(peak))
            skeleton%elastic_stiffness = share*f(peak)/elastic
            ! the two points of a jump may be one
            if (elastic > initial) &
               skeleton%initial_stiffness = (share - initial_fraction)*f(peak)/(elastic - initial)
         end if

         call find_ultimate(x, f, peak, settings%ultimate_fraction, last_x, last_f, &
            skeleton%area, skeleton%ultimate_reached)
         skeleton%ultimate_displacement = s*last_x
         skeleton%ultimate_force = s*last_f
         if (.not. is_none(skeleton%elastic_stiffness)) call find_yield(s, last_x, skeleton)
      end associate
   end subroutine evaluate_skeleton

   !> Yield point of the elastic and perfectly plastic curve with the same elastic stiffness,
   !> ultimate displacement and area.
   pure subroutine find_yield(s, last_x, skeleton)
      real(wp), intent(in) :: s, last_x
      type(hysteresis_skeleton), intent(inout) :: skeleton
      real(wp) :: under_root, yield

      under_root = last_x**2 - 2.0_wp*skeleton%area/skeleton%elastic_stiffness
      skeleton%yield_assumed = under_root < -round_off*last_x**2
      if (skeleton%yield_assumed) then
         yield = assumed_yield*s*skeleton%peak_force
      else
         yield = skeleton%elastic_stiffness*(last_x - sqrt(max(under_root, 0.0_wp)))
      end if
      ! an area that is not positive has no yield point
      if (.not. yield > 0.0_wp) return
      skeleton%yield_force = s*yield
      skeleton%yield_displacement = s*yield/skeleton%elastic_stiffness
      skeleton%ductility = last_x*skeleton%elastic_stiffness/yield
   end subroutine find_yield

end module asperity_hysteresis_skeletons
