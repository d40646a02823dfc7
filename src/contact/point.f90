!> The contact-point update: the only path from relative motion to tractions. UINTER, the replays
!> and every other host call it and nothing else.
!>
!> Within an increment the pressure changes first, at the elastic slip of the start, then the
!> point slips at the pressure of the end. If the point closes within the increment, only the
!> share of the motion after closing counts, for a straight path of the overclosure.
module asperity_contact_point
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: close_pressure_ratio, contact_properties, &
      rule_dissipative
   use asperity_contact_slip_path, only: integrate_slip, slip_path
   use asperity_contact_state, only: contact_response, contact_state, no_surface_limit, &
      status_open, status_slip, status_stick, status_unset
   use asperity_law_compiled_law, only: evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response, vanishing_separation
   implicit none
   private
   public :: update_contact_point, advance_contact_point, contact_tangent

contains

   !> Advance one contact point over one increment. Any finite input gives a finite result.
   pure function update_contact_point(properties, start, overclosure, slip_increment, rotation) &
         result(response)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the start of the increment
      type(contact_state), intent(in) :: start
      !> Overclosure at the end, mm; `no_opposite_surface` when there is none
      real(wp), intent(in) :: overclosure
      !> Relative tangential motion of the increment in the slip directions at the end, mm
      real(wp), intent(in) :: slip_increment(2)
      !> Rotation of the slip directions in the increment: a vector v becomes rotation v
      real(wp), intent(in) :: rotation(2, 2)
      type(contact_response) :: response

      call advance_contact_point(properties, start, overclosure, slip_increment, rotation, response)
   end function update_contact_point

   !> The same as a subroutine: copying the result of the function costs as much as the update.
   pure subroutine advance_contact_point(properties, start, overclosure, slip_increment, rotation, &
         response)
      !> As for `update_contact_point`
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip_increment(2), rotation(2, 2)
      !> Result
      type(contact_response), intent(out) :: response
      type(normal_response) :: normal

      call find_normal(properties, overclosure, normal)
      response%traction(1) = normal%pressure
      response%tangent(1, 1) = normal%stiffness
      response%normal_energy = normal%energy
      response%validity = normal%validity
      call slide(response, properties, start, overclosure, slip_increment, rotation)

      associate (state => response%state)
         state%status = response%status
         state%overclosure = overclosure
         state%pressure = normal%pressure
         state%normal_energy = normal%energy
         state%largest_closure = overclosure
         if (start%status /= status_unset) &
            state%largest_closure = max(overclosure, start%largest_closure)
         state%dissipation = start%dissipation + response%dissipation
         state%pressure_coupling = start%pressure_coupling + response%pressure_coupling
         state%validity = ior(start%validity, response%validity)
      end associate
   end subroutine advance_contact_point

   !> Tangential part of the update, at the pressure already found.
   pure subroutine slide(response, properties, start, overclosure, slip_increment, rotation)
      type(contact_response), intent(inout) :: response
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip_increment(2), rotation(2, 2)
      type(slip_path) :: path
      real(wp) :: gamma(2), gamma_by_pressure(2), energy, kept_energy, share, share_by_overclosure
      logical :: was_closed

      was_closed = start%status == status_stick .or. start%status == status_slip
      gamma = 0.0_wp
      if (was_closed) then
         gamma = matmul(rotation, start%elastic_slip)
         ! a rotation that is not quite one must not lengthen it
         gamma = gamma*(properties%critical_slip &
            /max(properties%critical_slip, hypot(gamma(1), gamma(2))))
      end if
      energy = elastic_energy(properties, start%pressure, gamma)

      associate (p => response%traction(1), r => response)
         ! the pressure changes at the slip of the start, as its rule says
         gamma_by_pressure = 0.0_wp
         if (properties%friction_rule == rule_dissipative .and. p > start%pressure) then
            gamma_by_pressure = -gamma*(start%pressure/p)/p
            gamma = gamma*(start%pressure/p)
         end if
         kept_energy = elastic_energy(properties, p, gamma)
         if (properties%friction_rule == rule_dissipative) then
            r%dissipation = max(energy - kept_energy, 0.0_wp)
         else
            r%pressure_coupling = kept_energy - energy
         end if
         if (is_open(properties, p, was_closed)) then
            r%status = status_open
            r%dissipation = r%dissipation + kept_energy
            return
         end if

         call share_after_closing(properties, start, overclosure, share, share_by_overclosure)
         path = integrate_slip(gamma, share*slip_increment, properties%critical_slip, &
            properties%slip_integration)
         r%status = merge(status_slip, status_stick, path%slips)
         r%state%elastic_slip = path%elastic_slip
         r%tangential_energy = elastic_energy(properties, p, path%elastic_slip)
         r%dissipation = r%dissipation + properties%friction_coefficient*p*path%slipped

         associate (scale => properties%friction_coefficient/properties%critical_slip)
            r%traction(2:3) = scale*p*path%elastic_slip
            r%tangent(2:3, 1) = scale*r%tangent(1, 1) &
               *(path%elastic_slip + p*matmul(path%by_start, gamma_by_pressure)) &
               + scale*p*share_by_overclosure*matmul(path%by_increment, slip_increment)
            r%tangent(2:3, 2:3) = scale*p*share*path%by_increment
         end associate
      end associate
   end subroutine slide

   !> Tangent about a state, for perturbations: sticking points stick, slipping points slip on, so
   !> they resist only across the slip direction. Nothing changes status.
   pure function contact_tangent(properties, state) result(tangent)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the base of the perturbation
      type(contact_state), intent(in) :: state
      !> d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm
      real(wp) :: tangent(3, 3)
      type(normal_response) :: normal
      real(wp) :: scale, across(2)

      tangent = 0.0_wp
      if (state%status == status_unset) return
      call find_normal(properties, state%overclosure, normal)
      tangent(1, 1) = normal%stiffness
      if (state%status == status_open) return
      scale = properties%friction_coefficient/properties%critical_slip
      tangent(2:3, 1) = scale*normal%stiffness*state%elastic_slip
      if (state%status == status_slip) then
         across = [-state%elastic_slip(2), state%elastic_slip(1)]/properties%critical_slip
         tangent(2:3, 2) = scale*normal%pressure*across*across(1)
         tangent(2:3, 3) = scale*normal%pressure*across*across(2)
      else
         tangent(2, 2) = scale*normal%pressure
         tangent(3, 3) = scale*normal%pressure
      end if
   end function contact_tangent

   !> The normal law at an overclosure, in the way the properties choose.
   pure subroutine find_normal(properties, overclosure, normal)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: overclosure
      type(normal_response), intent(out) :: normal

      associate (separation => properties%initial_separation - overclosure)
         if (separation > vanishing_separation*properties%normal%sigma) then
            ! open, as most points of a model are: no need to evaluate zeros
            normal%validity = properties%normal%validity
         else if (allocated(properties%compiled)) then
            call evaluate_compiled_law(properties%compiled, separation, normal%pressure, &
               normal%stiffness, energy=normal%energy, validity=normal%validity)
         else
            normal = evaluate_normal_law(properties%normal, separation)
         end if
      end associate
   end subroutine find_normal

   !> Open below p_open; an open point closes only above twice that.
   pure logical function is_open(properties, pressure, was_closed)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: pressure
      logical, intent(in) :: was_closed

      if (was_closed) then
         is_open = pressure < properties%p_open
      else
         is_open = .not. pressure > close_pressure_ratio*properties%p_open
      end if
   end function is_open

   !> Share of the increment that lies after closing, and its derivative by the overclosure.
   !> One for a point that was closed, and where nothing is known of the path.
   pure subroutine share_after_closing(properties, start, overclosure, share, by_overclosure)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure
      real(wp), intent(out) :: share, by_overclosure
      type(error_type), allocatable :: error
      real(wp) :: closing, travel

      share = 1.0_wp
      by_overclosure = 0.0_wp
      if (start%status /= status_open) return
      if (start%overclosure < no_surface_limit) return
      call separation_for_pressure(properties%normal, close_pressure_ratio*properties%p_open, &
         closing, error)
      closing = properties%initial_separation - closing
      travel = overclosure - start%overclosure
      if (allocated(error) .or. .not. (closing > start%overclosure .and. travel > 0.0_wp)) return
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

end module asperity_contact_point
