!> stub
module asperity_solid_model_interface
   use asperity_contact_properties, only: contact_properties
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_model_settings, only: solid_settings
   implicit none
   private
   public :: new_interface_law
contains
   subroutine new_interface_law(law, properties, is_hard, settings)
      class(solid_law), allocatable, intent(out) :: law
      type(contact_properties), intent(in) :: properties
      logical, intent(in) :: is_hard
      type(solid_settings), intent(in) :: settings
   end subroutine
end module
