!> Records with exact answers for the tests of their post-processing: springs, sliders and gaps
!> driven along a path.
module hysteresis_models
   use asperity_base_kinds, only: wp
   use random_inputs, only: random_stream
   implicit none
   private
   public :: record_type, spring_type, path_through, response, random_path, add_noise, &
      repeat_samples, total_work

   !> A record.
   type :: record_type
      real(wp), allocatable :: displacement(:), force(:)
   end type record_type

   !> A spring with a slider, beside a spring, beside two bearings that take no tension and leave a
   !> gap when they yield.
   type :: spring_type
      !> Stiffness of the slider's spring; its limits, positive and negative
      real(wp) :: stiffness = 0.0_wp, limit(2) = 0.0_wp
      !> Stiffness of the spring beside
      real(wp) :: beside = 0.0_wp
      !> Stiffness and limit of the bearings
      real(wp) :: bearing_stiffness = 0.0_wp, bearing_limit = 0.0_wp
   end type spring_type

contains

   !> Straight lines from zero through turning points, in equal steps each. Ends are exact; so are
   !> all samples if the steps are powers of two.
   pure function path_through(turns, step) result(path)
      real(wp), intent(in) :: turns(:), step
      real(wp), allocatable :: path(:)
      real(wp) :: from
      integer :: i, j, n, total

      total = 1
      from = 0.0_wp
      do i = 1, size(turns)
         total = total + nint(abs(turns(i) - from)/step)
         from = turns(i)
      end do
      allocate (path(total))
      path(1) = 0.0_wp
      total = 1
      do i = 1, size(turns)
         from = path(total)
         n = nint(abs(turns(i) - from)/step)
         do j = 1, n
            path(total + j) = from + sign(j*step, turns(i) - from)
         end do
         total = total + n
         path(total) = turns(i)
      end do
   end function path_through

   !> Straight lines from zero through all multiples of a step on the way to the turning points,
   !> with random samples between them.
   subroutine random_path(stream, turns, step, path)
      type(random_stream), intent(inout) :: stream
      real(wp), intent(in) :: turns(:), step
      real(wp), allocatable, intent(out) :: path(:)
      real(wp), allocatable :: knots(:)
      real(wp) :: between(3), room(5*100000)
      integer :: i, j, k, n

      allocate (knots, source=path_through(turns, step))
      n = 1
      room(1) = knots(1)
      do i = 2, size(knots)
         k = int(stream%uniform(0.0_wp, 3.999_wp))
         do j = 1, k
            between(j) = stream%uniform(0.0_wp, 1.0_wp)
         end do
         do j = 1, k
            ! in their order on the way
            n = n + 1
            room(n) = knots(i - 1) + (knots(i) - knots(i - 1))*minval(between(:k), &
               mask=between(:k) < 2.0_wp)
            between(minloc(between(:k))) = 3.0_wp
         end do
         n = n + 1
         room(n) = knots(i)
      end do
      path = room(:n)
   end subroutine random_path

   !> Force along a path.
   pure function response(spring, path) result(record)
      type(spring_type), intent(in) :: spring
      real(wp), intent(in) :: path(:)
      type(record_type) :: record
      real(wp) :: slider, gap(2), depth, last
      integer :: i, side

      allocate (record%displacement, source=path)
      allocate (record%force(size(path)))
      slider = 0.0_wp
      last = 0.0_wp
      gap = 0.0_wp
      do i = 1, size(path)
         slider = slider + spring%stiffness*(path(i) - last)
         last = path(i)
         slider = max(-spring%limit(2), min(spring%limit(1), slider))
         record%force(i) = slider + spring%beside*path(i)
         if (.not. spring%bearing_stiffness > 0.0_wp) cycle
         do side = 1, 2
            depth = merge(path(i), -path(i), side == 1)
            gap(side) = max(gap(side), depth - spring%bearing_limit/spring%bearing_stiffness)
            record%force(i) = record%force(i) + merge(1.0_wp, -1.0_wp, side == 1) &
               *max(0.0_wp, spring%bearing_stiffness*(depth - gap(side)))
         end do
      end do
   end function response

   !> Add uniform noise of some amplitude to both.
   subroutine add_noise(stream, record, displacement, force)
      type(random_stream), intent(inout) :: stream
      type(record_type), intent(inout) :: record
      real(wp), intent(in) :: displacement, force
      integer :: i

      do i = 1, size(record%force)
         record%displacement(i) = record%displacement(i) &
            + stream%uniform(-displacement, displacement)
         record%force(i) = record%force(i) + stream%uniform(-force, force)
      end do
   end subroutine add_noise

   !> Every sample once to three times.
   subroutine repeat_samples(stream, record)
      type(random_stream), intent(inout) :: stream
      type(record_type), intent(inout) :: record
      integer :: which(3*size(record%force)), i, j, n

      n = 0
      do i = 1, size(record%force)
         do j = 1, 1 + int(stream%uniform(0.0_wp, 2.999_wp))
            n = n + 1
            which(n) = i
         end do
      end do
      record%displacement = record%displacement(which(:n))
      record%force = record%force(which(:n))
   end subroutine repeat_samples

   !> Work of the force along the whole record, by the trapezoidal rule.
   pure real(wp) function total_work(record)
      type(record_type), intent(in) :: record
      integer :: n

      n = size(record%force)
      total_work = sum(0.5_wp*(record%force(2:n) + record%force(:n - 1)) &
         *(record%displacement(2:n) - record%displacement(:n - 1)))
   end function total_work

end module hysteresis_models
