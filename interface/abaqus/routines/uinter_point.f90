!> What UINTER needs of a contact point in a call.
module asperity_abaqus_uinter_point
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state
   implicit none
   private
   public :: uinter_point

   !> Properties, state at the start and result, with their default values as one block each: flang
   !> would set them component by component by library calls, which take longer than the law.
   type :: uinter_point
      !> Properties, read from PROPS
      type(contact_properties) :: properties = contact_properties()
      !> State at the start, read from STATEV
      type(contact_state) :: start = contact_state()
      !> Result
      type(contact_response) :: response = contact_response()
   end type uinter_point

end module asperity_abaqus_uinter_point
