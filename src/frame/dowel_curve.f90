!> Half a cycle of OpenSees' DowelType, from a turn to the envelope of the other side, seen so that
!> displacement falls. Its documentation gives the three lines and their stiffness; how Bezier
!> curves join them, and what happens where a line is not reached, was found by experiments with
!> openseespy 3.7.1.2, which this follows to round-off.
module asperity_frame_dowel_curve
   use asperity_base_kinds, only: wp
   use asperity_frame_dowel_envelope, only: bezier_parameter, bezier_value
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
      !> Largest displacement of the other side so far, and the envelope's force there
      real(wp) :: target_displacement = 0.0_wp, target_force = 0.0_wp
      !> Where the pinching line meets the other side's envelope
      real(wp) :: meeting = 0.0_wp
      !> The largest displacement of the side that is left is past the yield displacement
      logical :: is_past_yield = .false.
      !> Curvature, 0 to 2
      real(wp) :: curvature = 0.0_wp
   end type dowel_lines

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

   !> Draw half a cycle; `joining` asks for the envelope's force where the curve joins it.
   pure subroutine plan_curve(curve, lines, joining)
      !> The curve; where `joining` is true its last piece wants its end's force, f(4, n)
      type(dowel_curve), intent(out) :: curve
      !> What it is drawn from
      type(dowel_lines), intent(in) :: lines
      !> Whether the last piece ends on the envelope away from its target
      logical, intent(out) :: joining
      real(wp) :: start(2), unloaded(2), reloaded(2), middle(2), target(2), corner(2), x

      joining = .false.
      start = [lines%displacement, lines%force]
      target = -[lines%target_displacement, lines%target_force]
      ! where the pinching line meets the other two
      x = (lines%unloading*start(1) - start(2) - lines%intercept) &
         /(lines%unloading - lines%pinching)
      unloaded = [x, lines%pinching*x - lines%intercept]
      x = (target(2) + lines%reloading*lines%target_displacement + lines%intercept) &
         /(lines%pinching - lines%reloading)
      reloaded = [x, lines%pinching*x - lines%intercept]
      if (lines%target_displacement > 0.0_wp .and. reloaded(1) > unloaded(1)) then
         ! reloading before pinching
         x = (start(2) - lines%unloading*start(1) - target(2) + lines%reloading*target(1)) &
            /(lines%reloading - lines%unloading)
         corner = [x, start(2) + lines%unloading*(x - start(1))]
         call add_corner(curve, start, corner, target, lines%curvature)
         curve%last = target(1)
      else if (lines%target_displacement > 0.0_wp &
         .and. target(2) < lines%pinching*target(1) - lines%intercept) then
         middle = 0.5_wp*(unloaded + reloaded)
         call add_corner(curve, start, unloaded, middle, lines%curvature)
         call add_corner(curve, middle, reloaded, target, lines%curvature)
         curve%last = target(1)
      else
         ! onto an envelope that was not loaded so far
         corner = [0.0_wp, -lines%intercept]
         middle = 0.5_wp*(unloaded + corner)
         call add_corner(curve, start, unloaded, middle, lines%curvature)
         curve%last = -lines%meeting
         if (lines%is_past_yield) curve%last = curve%last + reloaded(1) + lines%target_displacement
         if (lines%is_past_yield) then
            call add_piece(curve, middle, corner, corner, [curve%last, 0.0_wp])
         else
            call add_piece(curve, middle, middle, middle, [curve%last, 0.0_wp])
         end if
         joining = .true.
      end if
   end subroutine plan_curve

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
