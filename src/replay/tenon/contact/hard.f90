!> Hard contact: the interface does not close, so that the wood alone gives the pressure.
module asperity_replay_tenon_contact_hard
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_friction, only: slide
   use asperity_contact_state, only: contact_response
   use asperity_replay_tenon_contact_interface_law, only: interface_law
   use asperity_replay_tenon_contact_record, only: contact_record, keep_response
   use asperity_replay_tenon_contact_wood_bearing, only: bearing_indentation, bearing_pressure
   implicit none
   private
   public :: hard_law

   !> A rigid interface with the friction of the rough one.
   type, extends(interface_law) :: hard_law
   contains
      procedure :: close
   end type hard_law

contains

   !> The point is open while there is no pressure, and closes where the faces touch.
   subroutine close(law, start, closure, slip, trial, error)
      class(hard_law), intent(inout) :: law
      type(contact_record), intent(in) :: start
      real(wp), intent(in) :: closure, slip(2)
      type(contact_record), intent(inout) :: trial
      type(error_type), allocatable, intent(out) :: error
      type(contact_response) :: response

      associate (pressure => response%traction(1), touching => closure - sum(start%indentation))
         call bearing_pressure(law%wood, start%indentation, closure, pressure, &
            response%tangent(1, 1))
         call slide(response, law%faces, start%state, start%state%elastic_slip, touching, slip, &
            is_open=.not. pressure > 0.0_wp, closing=0.0_wp)
         response%state%overclosure = min(touching, 0.0_wp)
         trial%indentation = bearing_indentation(law%wood, start%indentation, pressure, closure)
      end associate
      call keep_response(trial, response, closure, 1.0_wp)
   end subroutine close

end module asperity_replay_tenon_contact_hard
