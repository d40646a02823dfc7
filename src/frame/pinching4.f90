!> OpenSees' Pinching4 without damage, as openseespy 3.7.1.2 has it, to round-off: its
!> documentation gives the four points of an envelope and of a half cycle.
module asperity_frame_pinching4
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_frame_history, only: frame_history, skeleton_force
   use asperity_frame_material, only: frame_command, frame_material
   use asperity_frame_pinching4_path, only: force_along, shape_path
   implicit none
   private
   public :: pinching4_material

   !> Its numbers; arrays of two hold the positive side first.
   type, extends(frame_material) :: pinching4_material
      !> Points of both envelopes, all above zero: ePd and ePf, eNd and eNf
      real(wp) :: displacement(4, 2) = 0.0_wp, force(4, 2) = 0.0_wp
      !> Where reloading begins, over the largest displacement so far and the force there: rDisp and
      !> rForce; force at the end of unloading over the largest of the envelope: uForce
      real(wp) :: reload_displacement(2) = 0.0_wp, reload_force(2) = 0.0_wp
      real(wp) :: unload_force(2) = 0.0_wp
      !> Skeletons to take forces from
      type(frame_history) :: history
   contains
      procedure :: parameters, apply, replay, commands
   end type pinching4_material

   !> So far, as a share of the way to the further one of both first points, envelopes have the
   !> larger stiffness of both
   real(wp), parameter :: beginning = 1.0e-4_wp
   !> Past its last point an envelope that has fallen rises to so much of its force there, so many
   !> times as far out
   real(wp), parameter :: far_force = 1.1_wp, far = 1.0e6_wp

contains

   !> Parameters with bounds. The unloading force stays below that of reloading at every amplitude,
   !> or pinching vanishes and cycles give energy.
   subroutine parameters(self, history, start, list)
      !> The material; its skeletons are set
      class(pinching4_material), intent(inout) :: self
      !> What it is fitted to
      type(frame_history), intent(in) :: history
      !> Which start
      integer, intent(in) :: start
      !> The parameters
      type(fit_parameter), allocatable, intent(out) :: list(:)
      ! the first point, as a share of the second; where reloading begins
      real(wp), parameter :: first(4) = [0.1_wp, 0.25_wp, 0.4_wp, 0.7_wp]
      real(wp), parameter :: reload(2, 3) = reshape([0.3_wp, 0.3_wp, 0.7_wp, 0.3_wp, &
         0.5_wp, 0.6_wp], [2, 3])
      character(len=9) :: mark
      integer :: side, n

      if (start > size(first)*size(reload, 2)) then
         allocate (list(0))
         return
      end if
      self%history = history
      allocate (list(9))
      list(1) = fit_parameter('displacement_1', '', &
         first(modulo(start - 1, size(first)) + 1), 0.01_wp, 0.99_wp)
      list(2) = fit_parameter('displacement_2', '', 0.5_wp, 0.02_wp, 0.99_wp)
      list(3) = fit_parameter('displacement_3', '', 0.6_wp, 0.02_wp, 0.99_wp)
      do side = 1, 2
         mark = merge('_positive', '_negative', side == 1)
         n = 3*side
         associate (r => reload(:, (start - 1)/size(first) + 1))
            list(n + 1) = fit_parameter('reload_displacement'//mark, '', r(1), 0.02_wp, 0.98_wp)
            list(n + 2) = fit_parameter('reload_force'//mark, '', r(2), 0.02_wp, 0.98_wp)
         end associate
         list(n + 3) = fit_parameter('unload_force'//mark, '', 0.5_wp, 0.0_wp, 0.98_wp)
      end do
   end subroutine parameters

   !> Set the numbers: displacements as shares of the next point's, the outermost that of the
   !> skeleton, whose forces are taken.
   pure subroutine apply(self, values)
      !> The material
      class(pinching4_material), intent(inout) :: self
      !> Values in the order of the parameters
      real(wp), intent(in) :: values(:)
      integer :: side, i

      do side = 1, 2
         self%displacement(4, side) = self%history%outermost(side)
         do i = 3, 1, -1
            self%displacement(i, side) = values(i)*self%displacement(i + 1, side)
         end do
         do i = 1, 4
            self%force(i, side) = skeleton_force(self%history, side, self%displacement(i, side))
         end do
         associate (v => values(3*side + 1:))
            self%reload_displacement(side) = v(1)
            self%reload_force(side) = v(2)
            self%unload_force(side) = v(3)*v(2)*minval(self%force(:, side)) &
               /maxval(self%force(:, side))
         end associate
      end do
   end subroutine apply

   !> Force along a path.
   pure subroutine replay(self, displacement, force, error)
      !> The material
      class(pinching4_material), intent(in) :: self
      !> Displacements
      real(wp), intent(in) :: displacement(:)
      !> Forces
      real(wp), intent(out) :: force(:)
      !> Never set
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: reached(2), x, last, before, px(4), pf(4)
      integer :: i, way, way_before, side
      logical :: is_curved

      reached = self%displacement(1, :)
      last = 0.0_wp
      before = 0.0_wp
      way_before = 0
      is_curved = .false.
      do i = 1, size(displacement)
         x = displacement(i)
         if (abs(x - last) > 0.0_wp) then
            way = nint(sign(1.0_wp, x - last))
            if (way_before == -way) then
               call turn(self, merge(1, 2, way < 0), -way*last, -way*before, reached, px, pf)
               is_curved = .true.
            end if
            way_before = way
         end if
         ! as the points lie, displacement falls
         if (is_curved .and. -way_before*x > px(4)) then
            force(i) = -way_before*force_along(px, pf, -way_before*x)
         else
            side = merge(1, 2, x > 0.0_wp)
            force(i) = sign(envelope_force(self, side, abs(x)), x)
         end if
         reached = max(reached, [x, -x])
         last = x
         before = force(i)
      end do
   end subroutine replay

   !> The four points from a turn on, to the largest displacement of the other side so far; seen so
   !> that displacement falls.
   pure subroutine turn(self, side, displacement, force, reached, px, pf)
      class(pinching4_material), intent(in) :: self
      !> Side that is left: 1 where displacement falls
      integer, intent(in) :: side
      real(wp), intent(in) :: displacement, force, reached(2)
      real(wp), intent(out) :: px(4), pf(4)
      real(wp) :: stiffness(2)
      integer :: other

      other = 3 - side
      stiffness = self%force(1, :)/self%displacement(1, :)
      px([1, 4]) = [displacement, -reached(other)]
      pf([1, 4]) = [force, -envelope_force(self, other, reached(other))]
      pf(2) = -self%unload_force(other) &
         *self%force(merge(4, 3, reached(other) > self%displacement(3, other)), other)
      px(3) = self%reload_displacement(other)*px(4)
      pf(3) = self%reload_force(other)*pf(4)
      call shape_path(px, pf, stiffness(side), stiffness(other), ends_negative=side == 1)
   end subroutine turn

   !> Force of an envelope, which goes on beyond its last point.
   pure real(wp) function envelope_force(self, side, displacement) result(force)
      class(pinching4_material), intent(in) :: self
      integer, intent(in) :: side
      real(wp), intent(in) :: displacement
      real(wp) :: x(0:6), f(0:6)
      integer :: i

      associate (d => self%displacement, p => self%force)
         x = [0.0_wp, beginning*maxval(d(1, :)), d(:, side), far*d(4, side)]
         f = [0.0_wp, x(1)*maxval(p(1, :)/d(1, :)), p(:, side), far_force*p(4, side)]
         if (p(4, side) > p(3, side)) f(6) = p(4, side) &
            + (p(4, side) - p(3, side))*(x(6) - x(5))/(x(5) - x(4))
      end associate
      do i = 1, 5
         if (displacement <= x(i)) exit
      end do
      force = f(i - 1) + (f(i) - f(i - 1))*(displacement - x(i - 1))/(x(i) - x(i - 1))
   end function envelope_force

   !> What OpenSees is told.
   pure subroutine commands(self, list)
      !> The material
      class(pinching4_material), intent(in) :: self
      !> The command
      type(frame_command), allocatable, intent(out) :: list(:)
      real(wp) :: points(16), none(15)
      integer :: side, i

      do side = 1, 2
         do i = 1, 4
            points(8*side + 2*i - 9:8*side + 2*i - 8) = merge(1.0_wp, -1.0_wp, side == 1) &
               *[self%force(i, side), self%displacement(i, side)]
         end do
      end do
      none = 0.0_wp
      allocate (list(1))
      list(1)%name = 'Pinching4'
      call list(1)%add('', [points, &
         (self%reload_displacement(i), self%reload_force(i), self%unload_force(i), i=1, 2), &
         none, 10.0_wp])
      call list(1)%add('cycle', none(:0))
   end subroutine commands

end module asperity_frame_pinching4
