!> Half a cycle of OpenSees' DowelType, from a turn to the envelope of the other side, seen so that
!> displacement falls. Its documentation gives the three lines and their stiffness; how Bezier
!> curves join them, and what happens where a line is not reached, is that of version 3.7.1.2, which
!> this follows to round-off.
module asperity_frame_dowel_curve
   use asperity_base_kinds, only: wp
   use asperity_frame_dowel_envelope, only: bezier_parameter, bezier_value, dowel_envelope
   implicit none
   private
   public :: curve_force, dowel_curve, dowel_lines, plan_curve

   !> What half a cycle is drawn from.
   type :: dowel_lines
      !> Where it begins
      real(wp) :: displacement = 0.0_wp, force = 0.0_wp
      !> Stiffness of unloading, pinching and reloading
      real(wp) :: unloading = 0.0_wp, pinching = 0.0_wp, reloading = 0.0_wp
      !> Force of the pinching line at zero displacement, taken negative
      real(wp) :: intercept = 0.0_wp
      !> Largest displacement of the other side so far, and the envelope there
      real(wp) :: target_displacement = 0.0_wp
      type(dowel_envelope) :: ahead
      !> Whether it begins past the yield displacement
      logical :: is_past_yield = .false.
      !> Curvature, 0 to 2
      real(wp) :: curvature = 0.0_wp
   end type dowel_lines

   !> Controls may lie behind the next by this share of the way, which is rounding
   real(wp), parameter :: order = 1.0e-12_wp
   !> Most pieces of a curve
   integer, parameter :: most = 6

   !> Pieces, each a cubic Bezier curve; past the last is the envelope.
   type :: dowel_curve
      !> Controls: displacement and force, four of each piece
      real(wp) :: x(4, most) = 0.0_wp, f(4, most) = 0.0_wp
      !> Pieces
      integer :: n = 0
      !> The other side's envelope takes over below this displacement
      real(wp) :: last = 0.0_wp
   end type dowel_curve

contains

   !> Draw half a cycle.
   pure subroutine plan_curve(curve, lines, meets)
      !> The curve
      type(dowel_curve), intent(out) :: curve
      !> What it is drawn from
      type(dowel_lines), intent(in) :: lines
      !> Whether the pinching line meets the envelope ahead, if it has to, and all lines fall
      logical, intent(out) :: meets
      real(wp) :: start(2), unloaded(2), reloaded(2), middle(2), target(2), pinched(2), meeting
      real(wp) :: reloading, rounding(2)
      logical :: is_rounded

      meets = .true.
      is_rounded = .false.
      start = [lines%displacement, lines%force]
      pinched = [0.0_wp, -lines%intercept]
      reloading = lines%reloading
      target = on_envelope(-lines%target_displacement)
      unloaded = crossing(start, lines%unloading, pinched, lines%pinching)
      reloaded = crossing(target, reloading, pinched, lines%pinching)
      if (target(2) >= pinched(2) + lines%pinching*target(1)) then
         ! the pinching line goes on to an envelope that was not loaded so far
         meeting = lines%ahead%meeting(lines%intercept, lines%pinching)
         meets = meeting >= lines%target_displacement
         if (.not. meets) return
         is_rounded = lines%is_past_yield
         target = on_envelope(-meeting + merge(reloaded(1) - target(1), 0.0_wp, is_rounded))
         reloading = lines%pinching
         if (is_rounded) reloading = lines%ahead%slope_at(-target(1))
         reloaded = pinched
         meets = target(1) <= 0.0_wp
         if (.not. meets) return
      end if
      middle = 0.5_wp*(unloaded + reloaded)
      if (unloaded(1) < reloaded(1) .and. unloaded(1) <= start(1)) then
         ! pinching would lead back: from unloading to reloading
         reloaded = crossing(start, lines%unloading, target, reloading)
         unloaded = start
         middle = start
      else if (unloaded(1) > start(1)) then
         ! it begins beyond the pinching line: to reloading, along a line of pinching or at once
         unloaded = start
         middle = start
         if (reloaded(1) > start(1)) reloaded = start
         if (reloaded(1) < start(1) .and. reloaded(2) > start(2)) then
            reloaded = crossing(start, lines%pinching, target, reloading)
            if (reloaded(1) < target(1)) reloaded = start
         end if
      end if
      call add_corner(curve, start, unloaded, middle, lines%curvature)
      if (is_rounded) then
         ! it leaves along the envelope's tangent, but for one that begins below the corner
         rounding = [0.0_wp, min(target(2) - reloading*target(1), reloaded(2))]
         call add_piece(curve, middle, reloaded, rounding, target)
      else
         call add_corner(curve, middle, reloaded, target, lines%curvature)
      end if
      curve%last = target(1)
      ! where displacement turns on the way, no rule is known
      associate (x => curve%x(:, :curve%n))
         meets = all(x(2:, :) <= x(:3, :) + order*(start(1) - target(1)))
      end associate

   contains

      !> A point of the envelope ahead.
      pure function on_envelope(displacement) result(point)
         real(wp), intent(in) :: displacement
         real(wp) :: point(2)

         point = [displacement, -lines%ahead%force_at(-displacement)]
      end function on_envelope
   end subroutine plan_curve

   !> Where two lines meet, each given by a point and its slope; very far where they do not.
   pure function crossing(first, slope, second, other) result(point)
      real(wp), intent(in) :: first(2), slope, second(2), other
      real(wp) :: point(2)

      point = huge(1.0_wp)
      if (.not. abs(slope - other) > 0.0_wp) return
      point(1) = ((second(2) - other*second(1)) - (first(2) - slope*first(1)))/(slope - other)
      point(2) = second(2) + other*(point(1) - second(1))
   end function crossing

   !> From one point to another round a corner: straight, curved, straight; or curved all the way.
   pure subroutine add_corner(curve, from, corner, to, curvature)
      type(dowel_curve), intent(inout) :: curve
      real(wp), intent(in) :: from(2), corner(2), to(2), curvature
      real(wp) :: first(2), last(2)

      if (curvature < 1.0_wp) then
         first = corner + curvature*(from - corner)
         last = corner + curvature*(to - corner)
         call add_piece(curve, from, from, first, first)
         call add_piece(curve, first, corner, corner, last)
         call add_piece(curve, last, last, to, to)
      else
         call add_piece(curve, from, from + (2.0_wp - curvature)*(corner - from), &
            to + (2.0_wp - curvature)*(corner - to), to)
      end if
   end subroutine add_corner

   pure subroutine add_piece(curve, a, b, c, d)
      type(dowel_curve), intent(inout) :: curve
      real(wp), intent(in) :: a(2), b(2), c(2), d(2)

      curve%n = curve%n + 1
      curve%x(:, curve%n) = [a(1), b(1), c(1), d(1)]
      curve%f(:, curve%n) = [a(2), b(2), c(2), d(2)]
   end subroutine add_piece

   !> Force at a displacement above the last of the curve.
   pure real(wp) function curve_force(curve, displacement)
      !> The curve
      type(dowel_curve), intent(in) :: curve
      !> The displacement
      real(wp), intent(in) :: displacement
      integer :: i

      curve_force = curve%f(1, 1)
      do i = 1, curve%n
         if (displacement < curve%x(4, i) .and. i < curve%n) cycle
         if (curve%x(4, i) >= curve%x(1, i)) cycle
         curve_force = bezier_value(curve%f(:, i), bezier_parameter(curve%x(:, i), displacement))
         exit
      end do
   end function curve_force

end module asperity_frame_dowel_curve
