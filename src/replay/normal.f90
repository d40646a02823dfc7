!> The normal law at a contact point that a replay plays host to: with memory, or without.
module asperity_replay_normal
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_state
   use asperity_law_normal_law, only: evaluate_normal_law, normal_response
   use asperity_law_normal_properties, only: unloading_elastic
   use asperity_law_unloading_law, only: evaluate_unloading_law
   implicit none
   private
   public :: law_at

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

end module asperity_replay_normal
