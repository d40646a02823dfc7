!> Coulomb friction with elastic slip: tau = mu p gamma/gcrit, |gamma| <= gcrit (Eq. 27 with the
!> regularisation of Table 3), in two tangential directions; a second component of zero makes it
!> one-dimensional. Whatever finds the pressure, `slide` is the only path from there to shear
!> stresses, their derivatives and ledgers; friction that is not plain it hands on.
module asperity_contact_friction
   use asperity_base_kinds, only: wp
   use asperity_contact_general_friction, only: slide_in_general
   use asperity_contact_properties, only: contact_properties, rule_dissipative
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_state, only: contact_response, contact_state, is_closed, may_close, &
      status_open, status_slip, status_stick, status_unset
   implicit none
   private
   public :: slide

contains

   !> Friction over one increment at a known pressure: first the pressure changes, at the elastic
   !> slip of the start and as its rule says, then the point slips at the pressure of the end.
   pure subroutine slide(response, properties, start, elastic_slip, overclosure, slip_increment, &
         is_open, closing, rotation, time_increment)
      !> Pressure, its derivative, normal energy, plastic dissipation and validity at the end; all
      !> the rest is set
      type(contact_response), intent(inout) :: response
      !> Friction
      type(contact_properties), intent(in) :: properties
      !> State at the start
      type(contact_state), intent(in) :: start
      !> Its elastic slip in the slip directions of the end, mm; used where it is closed
      real(wp), intent(in) :: elastic_slip(2)
      !> Overclosure at the end, mm, and relative tangential motion of the increment, mm
      real(wp), intent(in) :: overclosure, slip_increment(2)
      !> Whether the point is open at the end
      logical, intent(in) :: is_open
      !> Overclosure from which on a point is closed, mm; used where `may_close(start)`
      real(wp), intent(in) :: closing
      !> Rotation of the slip directions in the increment, none when absent, and its time, s: for
      !> friction that is not plain
      real(wp), intent(in), optional :: rotation(2, 2), time_increment
      type(slip_path) :: path
      real(wp) :: gamma(2), gamma_by_pressure(2), motion(2)
      real(wp) :: energy, kept_energy, share, share_by_overclosure
      integer :: i

      if (.not. properties%friction_is_plain) then
         share = 1.0_wp
         share_by_overclosure = 0.0_wp
         if (.not. is_open) &
            call share_after_closing(start, overclosure, closing, share, share_by_overclosure)
         call slide_in_general(response, properties, start, elastic_slip, overclosure, &
            slip_increment, is_open, share, share_by_overclosure, rotation, time_increment)
         call end_increment(response, start, overclosure)
         return
      end if
      gamma = 0.0_wp
      if (is_closed(start)) gamma = elastic_slip
      energy = elastic_energy(properties, start%pressure, gamma)
      associate (r => response, p => response%traction(1), &
            scale => properties%friction_coefficient/properties%critical_slip)
         gamma_by_pressure = 0.0_wp
         ! at rest as when it is pressed, as the stiffness of a law with memory is then
         if (properties%friction_rule == rule_dissipative .and. p >= start%pressure &
            .and. p > 0.0_wp) then
            gamma_by_pressure = -gamma*(start%pressure/p)/p
            gamma = gamma*(start%pressure/p)
         end if
         kept_energy = elastic_energy(properties, p, gamma)
         r%dissipation = 0.0_wp
         r%pressure_coupling = 0.0_wp
         r%tangential_energy = 0.0_wp
         r%state%elastic_slip = 0.0_wp
         do i = 2, 3
            r%traction(i) = 0.0_wp
            r%tangent(1, i) = 0.0_wp
            r%tangent(i, 1) = 0.0_wp
            r%tangent(i, 2) = 0.0_wp
            r%tangent(i, 3) = 0.0_wp
         end do
         if (properties%friction_rule == rule_dissipative) then
            r%dissipation = max(energy - kept_energy, 0.0_wp)
         else
            r%pressure_coupling = kept_energy - energy
         end if
         if (is_open) then
            r%status = status_open
            r%dissipation = r%dissipation + kept_energy
         else
            call share_after_closing(start, overclosure, closing, share, share_by_overclosure)
            motion = share*slip_increment
            path = integrate_slip(gamma, motion, properties%critical_slip, &
               properties%slip_integration)
            r%status = merge(status_slip, status_stick, path%slips)
            r%tangential_energy = elastic_energy(properties, p, path%elastic_slip)
            r%dissipation = r%dissipation + properties%friction_coefficient*p*path%slipped
            ! by component, as flang makes library calls of sections and of matmul
            do i = 1, 2
               r%state%elastic_slip(i) = path%elastic_slip(i)
               r%traction(1 + i) = scale*p*path%elastic_slip(i)
               r%tangent(1 + i, 1) = scale*r%tangent(1, 1)*(path%elastic_slip(i) + p &
                  *(path%by_start(i, 1)*gamma_by_pressure(1) &
                  + path%by_start(i, 2)*gamma_by_pressure(2))) &
                  + scale*p*share_by_overclosure*(path%by_increment(i, 1)*slip_increment(1) &
                  + path%by_increment(i, 2)*slip_increment(2))
               r%tangent(1 + i, 2) = scale*p*share*path%by_increment(i, 1)
               r%tangent(1 + i, 3) = scale*p*share*path%by_increment(i, 2)
            end do
         end if
      end associate
      call end_increment(response, start, overclosure)
   end subroutine slide

   !> What the point remembers of the increment.
   pure subroutine end_increment(response, start, overclosure)
      type(contact_response), intent(inout) :: response
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure

      associate (state => response%state)
         state%status = response%status
         state%overclosure = overclosure
         state%pressure = response%traction(1)
         state%normal_energy = response%normal_energy
         state%largest_closure = overclosure
         if (start%status /= status_unset) &
            state%largest_closure = max(overclosure, start%largest_closure)
         state%dissipation = start%dissipation + response%dissipation
         state%pressure_coupling = start%pressure_coupling + response%pressure_coupling
         state%validity = ior(start%validity, response%validity)
      end associate
   end subroutine end_increment

   !> Share of the increment that lies after closing, and its derivative by the overclosure, for a
   !> straight path of the overclosure. One for a point that was closed, and where nothing is known
   !> of the path.
   pure subroutine share_after_closing(start, overclosure, closing, share, by_overclosure)
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, closing
      real(wp), intent(out) :: share, by_overclosure
      real(wp) :: travel

      share = 1.0_wp
      by_overclosure = 0.0_wp
      if (.not. may_close(start)) return
      travel = overclosure - start%overclosure
      if (.not. (closing > start%overclosure .and. travel > 0.0_wp)) return
      share = min(max((overclosure - closing)/travel, 0.0_wp), 1.0_wp)
      by_overclosure = (closing - start%overclosure)/travel/travel
   end subroutine share_after_closing

   !> mu p gamma^2/(2 gcrit)
   pure real(wp) function elastic_energy(properties, pressure, elastic_slip)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: pressure, elastic_slip(2)

      elastic_energy = 0.5_wp*properties%friction_coefficient*pressure &
         *dot_product(elastic_slip, elastic_slip)/properties%critical_slip
   end function elastic_energy

end module asperity_contact_friction
