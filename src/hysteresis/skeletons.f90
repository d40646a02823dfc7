!> Skeleton of one side of a record, and its stiffness, yield and ultimate point.
module hysteresis_skeletons
   use asperity_kinds, only: wp
   use hysteresis_types, only: hysteresis_cycle, hysteresis_settings, hysteresis_skeleton, &
      initial_fraction, side_sign
   implicit none
   private
   public :: new_skeleton, evaluate_skeleton

   !> Forces that differ by less than this share are equally large
   real(wp), parameter :: same_force = 1.0e-9_wp
   !> Round-off of the equal-energy equation
   real(wp), parameter :: round_off = 1.0e-12_wp
   !> Yield force over peak force where that equation has no solution (ASTM E2126)
   real(wp), parameter :: assumed_yield = 0.85_wp

contains

   !> Peaks of the first cycle at each amplitude. A record with a single peak, such as a
   !> monotonic test, is its own skeleton: all samples further out than those before them.
   pure subroutine new_skeleton(displacement, force, side, tolerance, cycles, skeleton)
      !> The record
      real(wp), intent(in) :: displacement(:), force(:)
      !> One of the two sides
      integer, intent(in) :: side
      !> A peak has a new amplitude if it is larger than all before it by this share
      real(wp), intent(in) :: tolerance
      !> Cycles with their peaks; those in the skeleton are marked
      type(hysteresis_cycle), intent(inout) :: cycles(:)
      !> Its points are set
      type(hysteresis_skeleton), intent(out) :: skeleton
      real(wp) :: largest
      integer, allocatable :: samples(:), origin(:)
      integer :: i, n

      allocate (samples(size(displacement)), origin(size(displacement)))
      n = 0
      largest = 0.0_wp
      associate (s => side_sign(side))
         do i = 1, size(cycles)
            if (cycles(i)%peak(side) == 0) cycle
            if (.not. s*cycles(i)%displacement(side) > largest*(1.0_wp + tolerance)) cycle
            largest = s*cycles(i)%displacement(side)
            cycles(i)%in_skeleton(side) = .true.
            n = n + 1
            samples(n) = cycles(i)%peak(side)
            origin(n) = i
         end do
         if (n == 1 .and. size(cycles) == 1 .and. count(cycles(1)%peak > 0) == 1) then
            n = 0
            largest = 0.0_wp
            do i = 1, size(displacement)
               if (.not. s*displacement(i) > largest) cycle
               largest = s*displacement(i)
               n = n + 1
               samples(n) = i
               origin(n) = 0
            end do
         end if
      end associate
      allocate (skeleton%displacement(n), skeleton%force(n))
      do i = 1, n
         skeleton%displacement(i) = displacement(samples(i))
         skeleton%force(i) = force(samples(i))
      end do
      allocate (skeleton%cycle, source=origin(:n))
   end subroutine new_skeleton

   !> Stiffness, peak, ultimate point and yield point of a skeleton whose points are set.
   pure subroutine evaluate_skeleton(side, settings, skeleton)
      !> One of the two sides
      integer, intent(in) :: side
      !> Shares of the peak force
      type(hysteresis_settings), intent(in) :: settings
      !> Skeleton; it keeps its numbers unknown if the force never has the sign of displacement
      type(hysteresis_skeleton), intent(inout) :: skeleton
      real(wp), allocatable :: x(:), f(:)
      real(wp) :: largest, elastic, initial, last_x, last_f
      integer :: i, peak

      if (size(skeleton%force) == 0) return
      associate (s => side_sign(side), share => settings%elastic_fraction)
         ! outwards from the origin
         allocate (x(0:size(skeleton%force)), f(0:size(skeleton%force)))
         x(0) = 0.0_wp
         f(0) = 0.0_wp
         do i = 1, size(skeleton%force)
            x(i) = s*skeleton%displacement(i)
            f(i) = s*skeleton%force(i)
         end do
         largest = maxval(f)
         if (.not. largest > 0.0_wp) return
         do peak = ubound(f, 1), 1, -1
            if (f(peak) >= (1.0_wp - same_force)*largest) exit
         end do
         skeleton%peak_displacement = s*x(peak)
         skeleton%peak_force = s*f(peak)

         elastic = displacement_at(x, f, share*f(peak))
         initial = displacement_at(x, f, initial_fraction*f(peak))
         skeleton%elastic_stiffness = share*f(peak)/elastic
         ! the two points of a jump may be one
         if (elastic > initial) &
            skeleton%initial_stiffness = (share - initial_fraction)*f(peak)/(elastic - initial)

         call find_ultimate(x, f, peak, settings%ultimate_fraction, last_x, last_f, &
            skeleton%area, skeleton%ultimate_reached)
         skeleton%ultimate_displacement = s*last_x
         skeleton%ultimate_force = s*last_f
         call find_yield(s, last_x, skeleton)
      end associate
   end subroutine evaluate_skeleton

   !> Displacement at which the skeleton first has a force between zero and its peak.
   pure real(wp) function displacement_at(x, f, force)
      real(wp), intent(in) :: x(0:), f(0:), force
      integer :: i

      displacement_at = x(ubound(x, 1))
      do i = 1, ubound(x, 1)
         if (f(i) < force) cycle
         displacement_at = x(i - 1) + (x(i) - x(i - 1))*((force - f(i - 1))/(f(i) - f(i - 1)))
         return
      end do
   end function displacement_at

   !> Point past the peak where the force has fallen to a share of it, or the last point, and the
   !> area up to there.
   pure subroutine find_ultimate(x, f, peak, share, last_x, last_f, area, reached)
      real(wp), intent(in) :: x(0:), f(0:), share
      integer, intent(in) :: peak
      real(wp), intent(out) :: last_x, last_f, area
      logical, intent(out) :: reached
      integer :: i

      area = 0.0_wp
      reached = .false.
      do i = 1, ubound(x, 1)
         last_x = x(i)
         last_f = f(i)
         reached = i > peak .and. f(i) <= share*f(peak)
         if (reached) then
            last_f = share*f(peak)
            last_x = x(i - 1) + (x(i) - x(i - 1))*((last_f - f(i - 1))/(f(i) - f(i - 1)))
         end if
         area = area + 0.5_wp*(f(i - 1) + last_f)*(last_x - x(i - 1))
         if (reached) return
      end do
   end subroutine find_ultimate

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

end module hysteresis_skeletons
