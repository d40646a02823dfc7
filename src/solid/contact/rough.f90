!> The rough law, by the contact-point update.
module asperity_solid_contact_rough
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_point, only: update_contact_point
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state, no_rotation
   use asperity_solid_contact_law, only: solid_law
   implicit none
   private
   public :: rough_law

   !> Two rough faces.
   type, extends(solid_law) :: rough_law
      !> Normal law and friction
      type(contact_properties) :: properties
   contains
      procedure :: update
   end type rough_law

contains

   subroutine update(law, start, overclosure, slip, response, error)
      class(rough_law), intent(inout) :: law
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error

      call update_contact_point(law%properties, start, overclosure, slip, no_rotation, response)
   end subroutine update

end module asperity_solid_contact_rough
