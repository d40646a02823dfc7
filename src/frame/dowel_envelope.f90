!> Envelope of OpenSees' DowelType with -bezier: a cubic Bezier curve from the origin to the cap,
!> then a straight line down. As its documentation has it.
module asperity_frame_dowel_envelope
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: bezier_parameter, bezier_value, dowel_envelope

   !> One side, all numbers above zero.
   type :: dowel_envelope
      !> Displacements and forces of the two control points and the cap
      real(wp) :: displacement(3) = 0.0_wp, force(3) = 0.0_wp
      !> Falling stiffness past the cap
      real(wp) :: falling = 0.0_wp
   contains
      !> Force at a displacement of this side
      procedure :: force_at
      !> Stiffness at the origin, and at a displacement of this side
      procedure :: stiffness, slope_at
      !> First displacement where it meets a line
      procedure :: meeting
   end type dowel_envelope

   !> Parts in which a meeting point is looked for
   integer, parameter :: parts = 200

contains

   !> Stiffness at the origin.
   elemental real(wp) function stiffness(self)
      !> The envelope
      class(dowel_envelope), intent(in) :: self

      stiffness = self%force(1)/self%displacement(1)
   end function stiffness

   !> Force at a displacement of this side.
   elemental real(wp) function force_at(self, displacement)
      !> The envelope
      class(dowel_envelope), intent(in) :: self
      !> Displacement, zero or above
      real(wp), intent(in) :: displacement
      real(wp) :: t

      associate (d => self%displacement, f => self%force)
         if (displacement > d(3)) then
            force_at = max(0.0_wp, f(3) - self%falling*(displacement - d(3)))
         else
            t = bezier_parameter([0.0_wp, d], displacement)
            force_at = bezier_value([0.0_wp, f], t)
         end if
      end associate
   end function force_at

   !> Stiffness at a displacement of this side.
   elemental real(wp) function slope_at(self, displacement)
      !> The envelope
      class(dowel_envelope), intent(in) :: self
      !> Displacement, zero or above
      real(wp), intent(in) :: displacement
      real(wp) :: t

      associate (d => self%displacement, f => self%force)
         slope_at = -self%falling
         if (displacement > d(3)) return
         t = bezier_parameter([0.0_wp, d], displacement)
         slope_at = bezier_slope([0.0_wp, f], t)/bezier_slope([0.0_wp, d], t)
      end associate
   end function slope_at

   !> First displacement where the envelope comes up to the line force + slope*displacement; below
   !> zero when it never does.
   pure real(wp) function meeting(self, force, slope)
      !> The envelope
      class(dowel_envelope), intent(in) :: self
      !> The line, force zero or above
      real(wp), intent(in) :: force, slope
      real(wp) :: p(4), low, high, middle
      integer :: i

      meeting = -1.0_wp
      p = [0.0_wp, self%force] - force - slope*[0.0_wp, self%displacement]
      do i = 1, parts
         high = real(i, wp)/real(parts, wp)
         if (bezier_value(p, high) >= 0.0_wp) exit
      end do
      if (i > parts) return
      low = real(i - 1, wp)/real(parts, wp)
      do i = 1, 60
         middle = 0.5_wp*(low + high)
         if (bezier_value(p, middle) >= 0.0_wp) then
            high = middle
         else
            low = middle
         end if
      end do
      meeting = bezier_value([0.0_wp, self%displacement], high)
   end function meeting

   !> Cubic Bezier curve of four controls.
   pure real(wp) function bezier_value(p, t)
      !> Controls
      real(wp), intent(in) :: p(4)
      !> 0 to 1
      real(wp), intent(in) :: t

      associate (s => 1.0_wp - t)
         bezier_value = s**3*p(1) + 3.0_wp*s*t*(s*p(2) + t*p(3)) + t**3*p(4)
      end associate
   end function bezier_value

   !> Its derivative by t.
   pure real(wp) function bezier_slope(p, t)
      !> Controls
      real(wp), intent(in) :: p(4)
      !> 0 to 1
      real(wp), intent(in) :: t

      associate (s => 1.0_wp - t)
         bezier_slope = 3.0_wp*(s**2*(p(2) - p(1)) + 2.0_wp*s*t*(p(3) - p(2)) &
            + t**2*(p(4) - p(3)))
      end associate
   end function bezier_slope

   !> Where a cubic Bezier curve that rises, or falls, has a value: Newton's way between bounds.
   pure real(wp) function bezier_parameter(p, value) result(t)
      !> Controls
      real(wp), intent(in) :: p(4)
      !> The value
      real(wp), intent(in) :: value
      real(wp) :: low, high, off, slope, rise
      integer :: i

      rise = p(4) - p(1)
      low = 0.0_wp
      high = 1.0_wp
      t = 0.5_wp
      if (abs(rise) > 0.0_wp) t = min(1.0_wp, max(0.0_wp, (value - p(1))/rise))
      do i = 1, 60
         off = bezier_value(p, t) - value
         if (abs(off) <= 1.0e-14_wp*abs(rise)) exit
         if (off*rise > 0.0_wp) then
            high = t
         else
            low = t
         end if
         slope = bezier_slope(p, t)
         if (abs(slope) > 1.0e-6_wp*abs(rise)) t = t - off/slope
         if (.not. (t > low .and. t < high)) t = 0.5_wp*(low + high)
      end do
   end function bezier_parameter

end module asperity_frame_dowel_envelope
