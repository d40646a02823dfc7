!> The normal law at a contact point that a replay plays host to: with memory, or without.
module asperity_replay_normal
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_state, status_unset
   use asperity_law_normal_inverse, only: separation_for_pressure
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_inverse, only: retraction_for_pressure
   use asperity_law_unloading_law, only: evaluate_unloading_law
   implicit none
   private
   public :: law_at, overclosure_for

contains

   !> Pressure, real area, shares and flags of a point.
   pure function law_at(properties, state) result(response)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> State of the point, updated before
      type(contact_state), intent(in) :: state
      type(normal_response) :: response

      associate (normal => properties%normal, d0 => properties%initial_separation)
         if (normal%unloading == unloading_elastic) then
            response = evaluate_unloading_law(normal, d0 - state%largest_closure, &
               state%largest_closure - state%overclosure)
         else
            response = evaluate_normal_law(normal, d0 - state%overclosure)
         end if
      end associate
   end function law_at

   !> Overclosure at which a point comes to a pressure from the state that it is in. `error` is set
   !> when the law has no such pressure.
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

      if (properties%normal%unloading == unloading_elastic .and. state%status /= status_unset) then
         retraction = retraction_for_pressure(properties%normal, &
            properties%initial_separation - state%largest_closure, pressure)
         overclosure = state%largest_closure - retraction
         if (retraction > 0.0_wp) return
      end if
      call separation_for_pressure(properties%normal, pressure, separation, error)
      overclosure = properties%initial_separation - separation
   end subroutine overclosure_for

end module asperity_replay_normal
