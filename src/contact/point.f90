!> The contact-point update: the only path from relative motion to tractions. UINTER, the replays
!> and every other host call it and nothing else.
!>
!> Within an increment the pressure changes first, at the elastic slip of the start, then the
!> point slips at the pressure of the end. If the point closes within the increment, only the
!> share of the motion after closing counts, for a straight path of the overclosure.
module asperity_contact_point
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction, only: slide
   use asperity_contact_general_friction, only: add_friction_tangent
   use asperity_contact_properties, only: close_pressure_ratio, contact_properties
   use asperity_contact_slip_path, only: is_longer
   use asperity_contact_state, only: contact_response, contact_state, is_closed, may_close, &
      status_open, status_slip, status_unset
   use asperity_law_compiled_law, only: evaluate_compiled_law
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_pressure, normal_response
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_compiled_law, only: compiled_plastic_dissipation, &
      evaluate_compiled_unloading_law
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_branch, evaluate_virgin_pressure, &
      plastic_dissipation, unloading_stiffness
   implicit none
   private
   public :: update_contact_point, contact_tangent, contact_pressure, find_normal, &
      normal_values, overclosure_for

   !> What a contact point takes from the normal law. Without default values, which flang sets by
   !> library calls.
   type :: normal_values
      !> Pressure, MPa, and normal stiffness, MPa/mm
      real(wp) :: pressure, stiffness
      !> Stored (recoverable) energy per area, N/mm
      real(wp) :: energy
      !> Plastic dissipation per area since first touch, N/mm; zero without memory, and while the
      !> point is not closer than ever
      real(wp) :: plastic_dissipation
      !> `valid`, or flags
      integer :: validity
   end type normal_values

contains

   !> Advance one contact point over one increment. Any finite input gives a finite result.
   pure subroutine update_contact_point(properties, start, overclosure, slip_increment, rotation, &
         response, time_increment)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the start of the increment; no part of `response`
      type(contact_state), intent(in) :: start
      !> Overclosure at the end, mm; `no_opposite_surface` when there is none
      real(wp), intent(in) :: overclosure
      !> Relative tangential motion of the increment in the slip directions at the end, mm
      real(wp), intent(in) :: slip_increment(2)
      !> Rotation of the slip directions in the increment: a vector v becomes rotation v
      real(wp), intent(in) :: rotation(2, 2)
      !> Result; all of it is set
      type(contact_response), intent(inout) :: response
      !> Time of the increment, s, for friction that depends on the slip rate; without it, or where
      !> it is zero, friction is that of no rate
      real(wp), intent(in), optional :: time_increment
      type(normal_values) :: normal
      real(wp) :: elastic_slip(2), closing
      logical :: opens

      call find_normal(properties, start, overclosure, normal)
      response%traction(1) = normal%pressure
      response%tangent(1, 1) = normal%stiffness
      response%normal_energy = normal%energy
      response%validity = normal%validity
      response%plastic_dissipation = 0.0_wp
      if (normal%plastic_dissipation > 0.0_wp) response%plastic_dissipation = &
         max(normal%plastic_dissipation - dissipated_before(properties, start), 0.0_wp)
      elastic_slip = start%elastic_slip
      if (is_closed(start)) then
         elastic_slip = rotation(:, 1)*start%elastic_slip(1) + rotation(:, 2)*start%elastic_slip(2)
         ! a rotation that is not quite one must not lengthen it
         if (is_longer(elastic_slip, properties%critical_slip)) elastic_slip = elastic_slip &
            *(properties%critical_slip/hypot(elastic_slip(1), elastic_slip(2)))
      end if
      opens = is_open(properties, normal%pressure, is_closed(start))
      closing = 0.0_wp
      if (may_close(start) .and. .not. opens) closing = closing_overclosure(properties, start)
      call slide(response, properties, start, elastic_slip, overclosure, slip_increment, opens, &
         closing, rotation, time_increment)
   end subroutine update_contact_point

   !> Tangent about a state, for perturbations: sticking points stick, slipping points slip on, so
   !> they resist only across the slip direction. Nothing changes status. With memory a point at
   !> its largest closure parts: the stiffness is that of unloading.
   pure function contact_tangent(properties, state) result(tangent)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the base of the perturbation
      type(contact_state), intent(in) :: state
      !> d traction(i)/d (overclosure, slip 1, slip 2)(j), MPa/mm
      real(wp) :: tangent(3, 3)
      type(normal_values) :: normal
      real(wp) :: scale, across(2)

      tangent = 0.0_wp
      if (state%status == status_unset) return
      call find_normal(properties, state, state%overclosure, normal)
      if (properties%normal%unloading == unloading_elastic .and. normal%pressure > 0.0_wp &
         .and. .not. state%overclosure < state%largest_closure) normal%stiffness = &
         unloading_stiffness(properties%normal, properties%initial_separation - state%overclosure)
      tangent(1, 1) = normal%stiffness
      if (state%status == status_open) return
      if (.not. properties%friction_is_plain) then
         call add_friction_tangent(properties, state, normal%pressure, normal%stiffness, tangent)
         return
      end if
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

   !> Pressure of a state, MPa, from its overclosures, for hosts whose own has been rounded.
   pure real(wp) function contact_pressure(properties, state) result(pressure)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State of the point
      type(contact_state), intent(in) :: state
      type(normal_values) :: normal

      call find_normal(properties, state, state%overclosure, normal)
      pressure = normal%pressure
   end function contact_pressure

   !> The normal law at an overclosure, in the way the properties choose.
   pure subroutine find_normal(properties, start, overclosure, normal)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State at the start of the increment
      type(contact_state), intent(in) :: start
      !> Overclosure at its end, mm
      real(wp), intent(in) :: overclosure
      !> Its values
      type(normal_values), intent(out) :: normal

      normal = normal_values(0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, properties%normal%validity)
      associate (separation => properties%initial_separation - overclosure)
         ! open, as most points of a model are: no need to evaluate zeros
         if (separation > properties%normal%vanishing_separation) return
         if (properties%normal%unloading == unloading_elastic) then
            if (remembers(properties, start) .and. overclosure < start%largest_closure) then
               call find_with_memory(properties, properties%initial_separation &
                  - start%largest_closure, start%largest_closure - overclosure, normal)
            else
               call find_with_memory(properties, separation, 0.0_wp, normal)
            end if
         else if (allocated(properties%compiled)) then
            call evaluate_compiled_law(properties%compiled, separation, normal%pressure, &
               normal%stiffness, energy=normal%energy, validity=normal%validity)
         else
            call evaluate_pressure(properties%normal, separation, normal%pressure, &
               normal%stiffness, normal%energy, normal%validity)
         end if
      end associate
   end subroutine find_normal

   !> The law with memory, compiled or directly; no plastic dissipation on the unloading branch.
   pure subroutine find_with_memory(properties, closest_separation, retraction, normal)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: closest_separation, retraction
      type(normal_values), intent(inout) :: normal
      type(normal_response) :: law

      if (allocated(properties%compiled_unloading)) then
         call evaluate_compiled_unloading_law(properties%compiled_unloading, closest_separation, &
            retraction, normal%pressure, normal%stiffness, normal%energy, normal%validity)
         if (.not. retraction > 0.0_wp) normal%plastic_dissipation = &
            compiled_plastic_dissipation(properties%compiled_unloading, closest_separation)
      else if (retraction > 0.0_wp) then
         call evaluate_unloading_branch(properties%normal, closest_separation, retraction, law)
         normal = normal_values(law%pressure, law%stiffness, law%energy, 0.0_wp, law%validity)
      else
         call evaluate_virgin_pressure(properties%normal, closest_separation, normal%pressure, &
            normal%stiffness, normal%energy, normal%plastic_dissipation, normal%validity)
      end if
   end subroutine find_with_memory

   !> Whether a point was close enough before for its summits to have yielded.
   pure logical function remembers(properties, state)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: state

      remembers = .false.
      if (state%status /= status_unset) remembers = properties%initial_separation &
         - state%largest_closure <= properties%normal%vanishing_separation
   end function remembers

   !> Plastic dissipation since first touch up to the start of an increment, N/mm.
   pure real(wp) function dissipated_before(properties, start)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start

      dissipated_before = 0.0_wp
      if (.not. remembers(properties, start)) return
      associate (closest_separation => properties%initial_separation - start%largest_closure)
         if (allocated(properties%compiled_unloading)) then
            dissipated_before = compiled_plastic_dissipation(properties%compiled_unloading, &
               closest_separation)
         else
            dissipated_before = plastic_dissipation(properties%normal, closest_separation)
         end if
      end associate
   end function dissipated_before

   !> Overclosure at which a point comes to a pressure from the state that it is in: on the
   !> unloading branch where that has it, else on the virgin one. `error` is set when the law has no
   !> such pressure.
   pure subroutine overclosure_for(properties, state, pressure, overclosure, error)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State of the point
      type(contact_state), intent(in) :: state
      !> Pressure, MPa; above zero
      real(wp), intent(in) :: pressure
      !> Overclosure, mm
      real(wp), intent(out) :: overclosure
      !> Set when the pressure is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: separation, retraction

      if (properties%normal%unloading == unloading_elastic .and. remembers(properties, state)) then
         retraction = retraction_for_pressure(properties%normal, &
            properties%initial_separation - state%largest_closure, pressure)
         overclosure = state%largest_closure - retraction
         if (retraction > 0.0_wp) return
      end if
      call separation_for_pressure(properties%normal, pressure, separation, error)
      overclosure = properties%initial_separation - separation
   end subroutine overclosure_for

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

   !> Overclosure at which an open point closes, mm; far below any where that is not found.
   pure real(wp) function closing_overclosure(properties, start) result(overclosure)
      type(contact_properties), intent(in) :: properties
      type(contact_state), intent(in) :: start
      type(error_type), allocatable :: error

      call overclosure_for(properties, start, close_pressure_ratio*properties%p_open, &
         overclosure, error)
      if (allocated(error)) overclosure = -huge(1.0_wp)
   end function closing_overclosure

end module asperity_contact_point
