!> OpenSees' DowelType (-bezier, without the damage of beta and gamma) beside an elastic-plastic
!> slider (ElasticPP), which holds until friction gives way.
module asperity_frame_dowel_type
   use asperity_base_error, only: computation_error, error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_fit_parameter, only: fit_parameter
   use asperity_frame_dowel_curve, only: curve_force, dowel_curve, dowel_lines, plan_curve
   use asperity_frame_dowel_envelope, only: dowel_envelope
   use asperity_frame_history, only: frame_history
   use asperity_frame_material, only: frame_command, frame_material
   implicit none
   private
   public :: dowel_type_material

   !> Its numbers, called as OpenSees' documentation calls them, written out.
   type, extends(frame_material) :: dowel_type_material
      !> Force and stiffness of the pinching line, Fi and Kp
      real(wp) :: pinching_force = 0.0_wp, pinching_stiffness = 0.0_wp
      !> Unloading stiffness over the initial one, Ru; curvature, c
      real(wp) :: unloading_ratio = 1.0_wp, curvature = 0.0_wp
      !> How the pinching force rises with the envelope, eta; yield displacement, Dy
      real(wp) :: pinching_growth = 0.0_wp, yield_displacement = 1.0_wp
      !> Exponents of stiffness of pinching, unloading and reloading, alpha_p, alpha_u and alpha_r
      real(wp) :: softening(3) = 0.0_wp
      !> Envelopes of the positive and the negative side
      type(dowel_envelope) :: envelope(2)
      !> Stiffness and largest force of the slider; no slider where the force is zero
      real(wp) :: slider_stiffness = 0.0_wp, slider_force = 0.0_wp
   contains
      procedure :: parameters, apply, replay, commands
   end type dowel_type_material

   !> Parameters of the loops, and of an envelope
   integer, parameter :: n_loops = 11, n_envelope = 5
   !> Below this share of the largest force a skeleton has fallen
   real(wp), parameter :: fallen = 0.97_wp
   !> Cap of an envelope that does not fall, over the record's outermost displacement
   real(wp), parameter :: beyond = 1.25_wp

contains

   !> Parameters with bounds, in the record's largest displacement and force.
   subroutine parameters(self, history, start, list)
      !> The material; the caps are set
      class(dowel_type_material), intent(inout) :: self
      !> What it is fitted to
      type(frame_history), intent(in) :: history
      !> Which start
      integer, intent(in) :: start
      !> The parameters
      type(fit_parameter), allocatable, intent(out) :: list(:)
      ! pinching force and yield displacement as shares of the largest; shares of control points
      real(wp), parameter :: forces(2) = [0.03_wp, 0.03_wp], yields(2) = [0.03_wp, 0.1_wp]
      real(wp), parameter :: shares(4, 2) = reshape( &
         [0.35_wp, 0.6_wp, 0.9_wp, 0.6_wp, 0.2_wp, 0.95_wp, 0.97_wp, 0.85_wp], [4, 2])
      character(len=14), parameter :: points(4) = [character(len=14) :: 'displacement_2', &
         'displacement_1', 'force_2', 'force_1']
      integer :: side, i, n

      if (start > size(forces)) then
         allocate (list(0))
         return
      end if
      allocate (list(n_loops + 2*n_envelope))
      associate (d => history%largest_displacement, f => history%largest_force, &
            k => history%largest_force/history%largest_displacement)
         list(1) = ratio('pinching_force', f*forces(start), 1.0e-5_wp*f, f)
         list(2) = ratio('pinching_stiffness', 0.1_wp*k, 1.0e-5_wp*k, 10.0_wp*k)
         list(3) = ratio('unloading_ratio', 5.0_wp, 0.5_wp, 60.0_wp)
         list(4) = fit_parameter('curvature', '', 0.5_wp, 0.0_wp, 1.95_wp)
         list(5) = fit_parameter('pinching_growth', '', 0.15_wp, 0.0_wp, 1.0_wp)
         list(6) = ratio('yield_displacement', d*yields(start), 1.0e-3_wp*d, d)
         list(7) = fit_parameter('pinching_softening', '', 1.0_wp, 0.0_wp, 8.0_wp)
         list(8) = fit_parameter('unloading_softening', '', 0.1_wp, 0.0_wp, 3.0_wp)
         list(9) = fit_parameter('reloading_softening', '', 0.2_wp, 0.0_wp, 3.0_wp)
         list(10) = ratio('slider_stiffness', 3.0_wp*k, 0.01_wp*k, 100.0_wp*k)
         list(11) = ratio('slider_force', 0.05_wp*f, 1.0e-4_wp*f, 0.9_wp*f)
      end associate
      do side = 1, 2
         n = n_loops + n_envelope*(side - 1)
         do i = 1, 4
            list(n + i) = fit_parameter(trim(points(i))//mark(side), '', shares(i, start), &
               0.01_wp, 0.9999_wp)
         end do
         associate (f => history%strongest_force(side), e => self%envelope(side))
            list(n + 5) = ratio('force_3'//mark(side), f, 0.3_wp*f, 2.0_wp*f)
            if (history%outermost_force(side) < fallen*f) then
               e%displacement(3) = history%strongest(side)
               e%falling = (f - history%outermost_force(side)) &
                  /(history%outermost(side) - history%strongest(side))
            else
               e%displacement(3) = beyond*history%outermost(side)
               e%falling = f/e%displacement(3)
            end if
         end associate
      end do
   end subroutine parameters

   !> The end of a parameter's name that tells its side.
   pure character(len=9) function mark(side)
      integer, intent(in) :: side

      mark = merge('_positive', '_negative', side == 1)
   end function mark

   !> A parameter that is varied by ratios.
   pure type(fit_parameter) function ratio(name, start, lower, upper)
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: start, lower, upper

      ratio = fit_parameter(name, '', start, lower, upper, by_ratio=.true.)
   end function ratio

   !> Set the numbers.
   pure subroutine apply(self, values)
      !> The material
      class(dowel_type_material), intent(inout) :: self
      !> Values in the order of the parameters
      real(wp), intent(in) :: values(:)
      integer :: side

      self%pinching_force = values(1)
      self%pinching_stiffness = values(2)
      self%unloading_ratio = values(3)
      self%curvature = values(4)
      self%pinching_growth = values(5)
      self%yield_displacement = values(6)
      self%softening = values(7:9)
      self%slider_stiffness = values(10)
      self%slider_force = values(11)
      do side = 1, 2
         associate (v => values(n_loops + n_envelope*(side - 1) + 1:), e => self%envelope(side))
            e%displacement(2) = v(1)*e%displacement(3)
            e%displacement(1) = v(2)*e%displacement(2)
            e%force(3) = v(5)
            e%force(2) = v(3)*v(5)
            e%force(1) = v(4)*e%force(2)
         end associate
      end do
   end subroutine apply

   !> Force along a path.
   pure subroutine replay(self, displacement, force, error)
      !> The material
      class(dowel_type_material), intent(in) :: self
      !> Displacements
      real(wp), intent(in) :: displacement(:)
      !> Forces
      real(wp), intent(out) :: force(:)
      !> Set when the pinching line does not meet the envelope
      type(error_type), allocatable, intent(out) :: error
      type(dowel_curve) :: curve
      real(wp) :: reached(2), force_there(2), slider, dowel, x, last
      integer :: i, way, way_before, side
      logical :: is_curved

      reached = 0.0_wp
      force_there = 0.0_wp
      slider = 0.0_wp
      dowel = 0.0_wp
      last = 0.0_wp
      way_before = 0
      is_curved = .false.
      do i = 1, size(displacement)
         x = displacement(i)
         if (abs(x - last) > 0.0_wp) then
            way = nint(sign(1.0_wp, x - last))
            if (way_before == -way) then
               ! the side that is left
               side = merge(1, 2, way < 0)
               call turn(self, side, last, dowel, reached, force_there(side), curve, error)
               if (allocated(error)) return
               is_curved = .true.
            end if
            way_before = way
         end if
         ! as the curve is drawn, displacement falls
         if (is_curved .and. -way_before*x > curve%last) then
            dowel = -way_before*curve_force(curve, -way_before*x)
         else
            dowel = sign(self%envelope(merge(1, 2, x > 0.0_wp))%force_at(abs(x)), x)
         end if
         ! not that of the envelope where a curve has not come to it
         where ([x, -x] >= reached) force_there = [dowel, -dowel]
         reached = max(reached, [x, -x])
         slider = min(max(slider + self%slider_stiffness*(x - last), -self%slider_force), &
            self%slider_force)
         force(i) = dowel + slider
         last = x
      end do
   end subroutine replay

   !> The curve from a turn on.
   pure subroutine turn(self, side, displacement, force, reached, largest_force, curve, error)
      class(dowel_type_material), intent(in) :: self
      !> Side that is left: 1 where displacement falls
      integer, intent(in) :: side
      real(wp), intent(in) :: displacement, force, reached(2)
      !> Force at the largest displacement of the side that is left, positive outwards
      real(wp), intent(in) :: largest_force
      type(dowel_curve), intent(out) :: curve
      type(error_type), allocatable, intent(inout) :: error
      type(dowel_lines) :: lines
      logical :: meets

      associate (here => self%envelope(side), there => self%envelope(3 - side), &
            largest => reached(side), opposite => reached(3 - side), y => self%yield_displacement)
         lines%displacement = displacement*merge(1, -1, side == 1)
         lines%force = force*merge(1, -1, side == 1)
         lines%unloading = self%unloading_ratio*here%stiffness()*shrunk(self%softening(2), largest)
         lines%pinching = self%pinching_stiffness*shrunk(self%softening(1), maxval(reached))
         lines%reloading = there%stiffness()*shrunk(self%softening(3), opposite)
         lines%is_past_yield = lines%displacement > y
         lines%intercept = self%pinching_force*min(1.0_wp, largest/y)
         associate (yield => here%force_at(y))
            if (largest > y .and. abs(largest_force) > yield) lines%intercept = lines%intercept &
               + self%pinching_growth*(largest_force - yield)
         end associate
         lines%target_displacement = opposite
         lines%ahead = there
         if (.not. lines%pinching < min(lines%unloading, lines%reloading)) then
            call fatal_error(error, 'pinching is stiffer than reloading or unloading', &
               computation_error)
            return
         end if
         lines%curvature = self%curvature
         call plan_curve(curve, lines, meets)
         if (.not. meets) call fatal_error(error, &
            'the pinching line does not meet the envelope ahead', computation_error)
      end associate

   contains

      !> Stiffness left past the yield displacement.
      pure real(wp) function shrunk(exponent, at)
         real(wp), intent(in) :: exponent, at

         shrunk = 1.0_wp
         if (at > self%yield_displacement) shrunk = (self%yield_displacement/at)**exponent
      end function shrunk

   end subroutine turn

   !> What OpenSees is told.
   pure subroutine commands(self, list)
      !> The material
      class(dowel_type_material), intent(in) :: self
      !> The commands
      type(frame_command), allocatable, intent(out) :: list(:)
      integer :: side

      real(wp) :: caps(7, 2)

      do side = 1, 2
         associate (e => self%envelope(side), way => merge(1.0_wp, -1.0_wp, side == 1))
            caps(:, side) = [way*e%displacement(1), way*e%force(1), way*e%displacement(2), &
               way*e%force(2), way*e%displacement(3), way*e%force(3), e%falling]
         end associate
      end do
      allocate (list(merge(2, 1, self%slider_force > 0.0_wp)))
      list(1)%name = 'DowelType'
      call list(1)%add('', [self%pinching_force, self%pinching_stiffness, self%unloading_ratio, &
         self%curvature, 1.0_wp, 1.0_wp, self%pinching_growth, self%yield_displacement, &
         self%softening])
      call list(1)%add('-bezier', [caps(:, 1), caps(:, 2)])
      if (size(list) == 1) return
      list(2)%name = 'ElasticPP'
      call list(2)%add('', [self%slider_stiffness, self%slider_force/self%slider_stiffness])
   end subroutine commands

end module asperity_frame_dowel_type
