!> Yield point, ultimate point and ductility of EN 12512, as the standard is commonly cited.
module asperity_hysteresis_en_12512
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_hysteresis_amplitudes, only: three_cycle_amplitude
   use asperity_hysteresis_curves, only: cut_off, displacement_at, find_ultimate, outward, &
      peak_of, rises_from_zero
   use asperity_hysteresis_types, only: en_12512_numbers, hysteresis_amplitude, &
      hysteresis_settings, hysteresis_skeleton, initial_fraction, side_sign
   implicit none
   private
   public :: ductility_class, evaluate_en_12512

   !> Least ductility of the classes medium and high: 4 and 6, which EN 1998-1 asks of the zones
   !> that dissipate energy in timber structures of the classes M and H
   real(wp), parameter :: least_medium = 4.0_wp, least_high = 6.0_wp
   !> Displacement in mm that ends a test
   real(wp), parameter :: largest_displacement = 30.0_wp
   !> Slope of the tangent over that of the first line
   real(wp), parameter :: tangent_share = 1.0_wp/6.0_wp
   !> Points, evenly spaced along the skeleton, that two lines are fitted to, and the fewest of a
   !> line
   integer, parameter :: points = 200, fewest = 10
   !> Two lines are clear if the points lie so near to them, by root mean square over the peak
   !> force, and if the second has at most this share of the slope of the first. Exponential curves
   !> are at 0.02 to 0.04, a parabola at 0.017, a knee that is rounded a little below 0.01
   real(wp), parameter :: nearness = 0.01_wp, most_slope = 0.5_wp
   !> Round-off by which a yield point may lie beyond the peak
   real(wp), parameter :: round_off = 1.0e-9_wp

   !> A straight line
   type :: line_type
      real(wp) :: slope = 0.0_wp, at_zero = 0.0_wp
      !> Sum of squares of the distances in force
      real(wp) :: squares = 0.25_wp*huge(1.0_wp)
   end type line_type

contains

   !> Evaluate the skeleton of a side, or the mean of both.
   pure subroutine evaluate_en_12512(side, settings, threshold, force_floor, amplitudes, skeleton)
      !> The side, the positive one for the mean
      integer, intent(in) :: side
      !> Shares of the peak force, and what a millimetre is
      type(hysteresis_settings), intent(in) :: settings
      !> Distance from zero that counts as zero
      real(wp), intent(in) :: threshold
      !> Forces up to this size are zero
      real(wp), intent(in) :: force_floor
      !> Cycles by amplitude; none for the mean
      type(hysteresis_amplitude), intent(in) :: amplitudes(:)
      !> Its points are known
      type(hysteresis_skeleton), intent(inout) :: skeleton
      real(wp), allocatable :: x(:), f(:)
      real(wp) :: last_x, last_f, area, held
      logical :: is_cut, reached
      integer :: peak

      if (size(skeleton%force) == 0) return
      associate (s => side_sign(side), n => skeleton%en_12512)
         call outward(s, skeleton, x, f)
         is_cut = .false.
         if (.not. is_none(settings%millimetre)) &
            call cut_off(largest_displacement*settings%millimetre, x, f, is_cut)
         if (.not. maxval(f) > force_floor) return
         peak = peak_of(f)
         n%peak_displacement = s*x(peak)
         n%peak_force = s*f(peak)
         call find_ultimate(x, f, peak, settings%ultimate_fraction, last_x, last_f, area, reached)
         n%ultimate_displacement = s*last_x
         n%ultimate_force = s*last_f
         n%ultimate_reason = 'end'
         if (is_cut) n%ultimate_reason = 'limit'
         if (reached) n%ultimate_reason = 'force'
         if (.not. rises_from_zero(x, f, peak, settings%elastic_fraction, threshold)) return
         call find_tangent(s, x, f, peak, settings%elastic_fraction, n)
         call find_two_lines(s, x, f, peak, n)
         held = three_cycle_amplitude(amplitudes, side, last_x)
         if (.not. is_none(n%two_lines_displacement)) then
            n%yield_method = 'two_lines'
            call add_ductility(last_x, held, abs(n%two_lines_displacement), n)
         else if (.not. is_none(n%tangent_displacement)) then
            n%yield_method = 'tangent'
            call add_ductility(last_x, held, abs(n%tangent_displacement), n)
         end if
      end associate
   end subroutine evaluate_en_12512

   !> Class of a ductility, `low`, `medium` or `high`; blank if it is not known.
   pure character(len=6) function ductility_class(ductility)
      !> Ultimate displacement, or one that three cycles hold, over yield displacement
      real(wp), intent(in) :: ductility

      ductility_class = ''
      if (is_none(ductility)) return
      ductility_class = 'low'
      if (ductility >= least_medium) ductility_class = 'medium'
      if (ductility >= least_high) ductility_class = 'high'
   end function ductility_class

   pure subroutine add_ductility(ultimate, held, yield, numbers)
      real(wp), intent(in) :: ultimate, held, yield
      type(en_12512_numbers), intent(inout) :: numbers

      if (.not. yield > 0.0_wp) return
      numbers%ductility = ultimate/yield
      if (.not. is_none(held)) numbers%three_cycle_ductility = held/yield
   end subroutine add_ductility

   !> Method b: the line through 0.1 and 0.4 of the peak force, and the tangent with a sixth of its
   !> slope, which is the one that lies above the whole skeleton.
   pure subroutine find_tangent(s, x, f, peak, share, numbers)
      real(wp), intent(in) :: s, x(0:), f(0:), share
      integer, intent(in) :: peak
      type(en_12512_numbers), intent(inout) :: numbers
      real(wp) :: first, second, slope, above, yield
      integer :: i

      first = displacement_at(x, f, initial_fraction*f(peak))
      second = displacement_at(x, f, share*f(peak))
      if (.not. second > first) return
      slope = (share - initial_fraction)*f(peak)/(second - first)
      above = 0.0_wp
      do i = 1, peak
         above = max(above, f(i) - tangent_share*slope*x(i))
      end do
      yield = (above - initial_fraction*f(peak) + slope*first)/((1.0_wp - tangent_share)*slope)
      ! a skeleton that stiffens meets the tangent beyond its peak, if at all
      if (yield > (1.0_wp + round_off)*x(peak)) return
      numbers%tangent_displacement = s*yield
      numbers%tangent_force = s*(above + tangent_share*slope*yield)
   end subroutine find_tangent

   !> Method a: two lines fitted to the skeleton between 0.1 of the peak force and the peak.
   pure subroutine find_two_lines(s, x, f, peak, numbers)
      real(wp), intent(in) :: s, x(0:), f(0:)
      integer, intent(in) :: peak
      type(en_12512_numbers), intent(inout) :: numbers
      type(line_type) :: first, second, best(2)
      real(wp) :: u(points), v(points), yield
      integer :: i

      call spread_points(x, f, peak, u, v)
      do i = fewest, points - fewest
         first = line_through(u(:i), v(:i))
         second = line_through(u(i + 1:), v(i + 1:))
         if (first%squares + second%squares < sum(best%squares)) best = [first, second]
      end do
      if (.not. sum(best%squares) <= points*nearness**2) return
      if (.not. best(2)%slope <= most_slope*best(1)%slope) return
      yield = (best(2)%at_zero - best(1)%at_zero)/(best(1)%slope - best(2)%slope)
      if (.not. (yield > u(1) .and. yield < 1.0_wp)) return
      numbers%two_lines_displacement = s*yield*x(peak)
      numbers%two_lines_force = s*(best(1)%at_zero + best(1)%slope*yield)*f(peak)
   end subroutine find_two_lines

   !> Points evenly spaced along a skeleton, as shares of its peak.
   pure subroutine spread_points(x, f, peak, u, v)
      real(wp), intent(in) :: x(0:), f(0:)
      integer, intent(in) :: peak
      real(wp), intent(out) :: u(:), v(:)
      real(wp) :: from(2), to(2), way, length, total
      integer :: i, n, pass

      total = 0.0_wp
      n = 0
      do pass = 1, 2
         from = [displacement_at(x, f, initial_fraction*f(peak))/x(peak), initial_fraction]
         way = 0.0_wp
         do i = 1, peak
            to = [x(i)/x(peak), f(i)/f(peak)]
            if (to(1) < from(1)) cycle
            length = norm2(to - from)
            do while (pass == 2 .and. n < size(u))
               associate (next => total*(real(n, wp)/real(size(u) - 1, wp)))
                  if (i < peak .and. next > way + length) exit
                  n = n + 1
                  u(n) = to(1)
                  v(n) = to(2)
                  if (.not. length > 0.0_wp) cycle
                  u(n) = from(1) + (to(1) - from(1))*min(1.0_wp, (next - way)/length)
                  v(n) = from(2) + (to(2) - from(2))*min(1.0_wp, (next - way)/length)
               end associate
            end do
            way = way + length
            from = to
         end do
         total = way
      end do
   end subroutine spread_points

   !> Line of least squares.
   pure type(line_type) function line_through(u, v) result(line)
      real(wp), intent(in) :: u(:), v(:)
      real(wp) :: mean_u, mean_v, width

      mean_u = sum(u)/size(u)
      mean_v = sum(v)/size(v)
      width = sum((u - mean_u)**2)
      if (.not. width > 0.0_wp) return
      line%slope = sum((u - mean_u)*(v - mean_v))/width
      line%at_zero = mean_v - line%slope*mean_u
      line%squares = sum((v - line%at_zero - line%slope*u)**2)
   end function line_through

end module asperity_hysteresis_en_12512
