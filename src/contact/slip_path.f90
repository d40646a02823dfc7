!> The path of the elastic slip gamma, |gamma| <= gcrit (the regularisation of Table 3), in two
!> tangential directions; a second component of zero makes it one-dimensional. The pressure, which
!> scales the friction, does not matter here.
module asperity_contact_slip_path
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: slip_backward_euler
   implicit none
   private
   public :: slip_path, integrate_slip, is_longer

   !> End of a straight increment of relative motion.
   type :: slip_path
      !> Elastic slip at the end, mm
      real(wp) :: elastic_slip(2)
      !> Its derivative by the increment
      real(wp) :: by_increment(2, 2)
      !> Its derivative by the elastic slip at the start
      real(wp) :: by_start(2, 2)
      !> Frictional dissipation divided by mu p, mm; never negative
      real(wp) :: slipped
      !> Whether the point slips at the end
      logical :: slips
   end type slip_path

   real(wp), parameter :: identity(2, 2) = reshape([1.0_wp, 0.0_wp, 0.0_wp, 1.0_wp], [2, 2])

contains

   !> Elastic slip after a straight increment of relative motion.
   pure function integrate_slip(start, increment, critical_slip, slip_integration) result(path)
      !> Elastic slip at the start, mm; not longer than the critical slip
      real(wp), intent(in) :: start(2)
      !> Relative tangential motion, mm
      real(wp), intent(in) :: increment(2)
      !> Critical elastic slip gcrit, mm
      real(wp), intent(in) :: critical_slip
      !> `slip_exact` or `slip_backward_euler`
      integer, intent(in) :: slip_integration
      type(slip_path) :: path
      real(wp) :: length

      path%elastic_slip = start + increment
      path%slips = is_longer(path%elastic_slip, critical_slip)
      if (path%slips) then
         ! a start outside the circle by round-off must not count as slip when the motion turns back
         length = hypot(increment(1), increment(2))
         path%slips = length > epsilon(1.0_wp)**2*critical_slip
         if (path%slips) path%slips = dot_product(path%elastic_slip/critical_slip, &
            increment/length) > 0.0_wp
      end if
      if (.not. path%slips) then
         path%by_increment = identity
         path%by_start = identity
         path%slipped = 0.0_wp
      else if (slip_integration == slip_backward_euler) then
         call return_radially(path, critical_slip)
      else
         call follow_circle(path, start, increment, critical_slip)
      end if
   end function integrate_slip

   !> Whether a slip is longer than a length: without a root where both components are small.
   pure logical function is_longer(slip, length)
      !> Slip in two directions, and a length, mm
      real(wp), intent(in) :: slip(2), length
      real(wp), parameter :: surely_inside = 0.7_wp

      is_longer = max(abs(slip(1)), abs(slip(2))) > surely_inside*length
      if (is_longer) is_longer = hypot(slip(1), slip(2)) > length
   end function is_longer

   !> Backward Euler: the trial slip is scaled back to the circle. The path is the chord to the
   !> end point in stick, then slip at the end point.
   pure subroutine return_radially(path, critical_slip)
      type(slip_path), intent(inout) :: path
      real(wp), intent(in) :: critical_slip
      real(wp) :: length, direction(2), tangent(2)

      length = hypot(path%elastic_slip(1), path%elastic_slip(2))
      direction = path%elastic_slip/length
      tangent = [-direction(2), direction(1)]
      path%elastic_slip = critical_slip*direction
      call set_outer(tangent, tangent, path%by_increment)
      path%by_increment = critical_slip/length*path%by_increment
      path%by_start = path%by_increment
      path%slipped = length - critical_slip
   end subroutine return_radially

   !> Exact path: stick up to the circle |gamma| = gcrit = g, then slip along it, where the angle
   !> theta from the motion to gamma obeys tan(theta/2) = tan(theta0/2) exp(-s/g) and the
   !> dissipation is mu p g ln(sin theta0/sin theta). Written so that no direction is singular:
   !> e is the direction of motion, n normal to it, c = cos theta0, tan(theta/2) = (b/g) k.
   pure subroutine follow_circle(path, start, increment, critical_slip)
      type(slip_path), intent(inout) :: path
      real(wp), intent(in) :: start(2), increment(2), critical_slip
      real(wp) :: e(2), n(2), tangent(2), along(2), length, size, a, b, c, one_minus_c, inside
      real(wp) :: stick, x, q, one_minus_q, growth, k, t, cosine, sine, turn

      length = hypot(increment(1), increment(2))
      e = increment/length
      n(1) = -e(2)
      n(2) = e(1)
      associate (g => critical_slip)
         a = dot_product(start, e)
         b = min(max(dot_product(start, n), -g), g)
         size = hypot(start(1), start(2))
         inside = max((g - size)*(g + size), 0.0_wp)
         c = sqrt(a*a + inside)/g
         one_minus_c = (b/g)**2/(1.0_wp + c)
         if (a > 0.0_wp) then
            stick = inside/(g*c + a)
         else
            stick = g*c - a
         end if
         stick = min(stick, length)
         x = (length - stick)/g
         call decay_and_growth(x, c, q, one_minus_q, growth)
         k = q/(1.0_wp + c)
         t = b/g*k
         cosine = (1.0_wp - t)*(1.0_wp + t)/(1.0_wp + t*t)
         sine = 2.0_wp*t/(1.0_wp + t*t)
         path%elastic_slip = g*(cosine*e + sine*n)
         path%slipped = g*growth
         tangent = -sine*e + cosine*n
         turn = (one_minus_q*(1.0_wp - k*one_minus_c) + 2.0_wp*k*c*stick/g) &
            /(1.0_wp + t*t)
         along = -sine*e + turn*g/length*n
         call set_outer(tangent, along, path%by_increment)
         along = -sine*e + 2.0_wp*c*k/(1.0_wp + t*t)*n
         call set_outer(tangent, along, path%by_start)
      end associate
   end subroutine follow_circle

   !> q = exp(-x), 1 - q, and ln(sin theta0/sin theta) = ln(cosh x + c sinh x): without loss for a
   !> small x, where ln(1 + z) = 2 artanh(z/(2 + z)), and without overflow for a large one.
   pure subroutine decay_and_growth(x, c, q, one_minus_q, growth)
      real(wp), intent(in) :: x, c
      real(wp), intent(out) :: q, one_minus_q, growth
      real(wp) :: half_sinh, half_cosh, z

      if (x < 1.0_wp) then
         half_sinh = sinh(0.5_wp*x)
         half_cosh = sqrt(1.0_wp + half_sinh**2)
         q = (half_cosh - half_sinh)**2
         one_minus_q = 2.0_wp*half_sinh*(half_cosh - half_sinh)
         z = 2.0_wp*half_sinh*(half_sinh + c*half_cosh)
         growth = 2.0_wp*atanh(z/(2.0_wp + z))
      else
         q = exp(-x)
         one_minus_q = 1.0_wp - q
         growth = x + log(0.5_wp*((1.0_wp + c) + (1.0_wp - c)*q*q))
      end if
   end subroutine decay_and_growth

   !> The matrix u v^T; no function, as flang copies the array that one returns by a library call.
   pure subroutine set_outer(u, v, matrix)
      real(wp), intent(in) :: u(2), v(2)
      real(wp), intent(out) :: matrix(2, 2)

      matrix(:, 1) = u*v(1)
      matrix(:, 2) = u*v(2)
   end subroutine set_outer

end module asperity_contact_slip_path
