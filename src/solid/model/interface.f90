!> The law of faces of the solid joint: hard contact, the rough law, or that through UINTER.
module asperity_solid_model_interface
   use asperity_contact_properties, only: contact_properties, without_summits
   use asperity_solid_contact_hard, only: hard_law
   use asperity_solid_contact_law, only: solid_law
   use asperity_solid_contact_rough, only: rough_law
   use asperity_solid_contact_uinter, only: new_uinter_law, uinter_law
   use asperity_solid_model_settings, only: solid_settings
   implicit none
   private
   public :: new_interface_law

contains

   !> Make the law of a pair of faces.
   subroutine new_interface_law(law, properties, is_hard, settings)
      !> Result
      class(solid_law), allocatable, intent(out) :: law
      !> Normal law, friction and datum of the faces
      type(contact_properties), intent(in) :: properties
      !> Whether contact is hard, with that friction
      logical, intent(in) :: is_hard
      !> Settings of the analysis
      type(solid_settings), intent(in) :: settings
      type(uinter_law), allocatable :: through

      if (is_hard) then
         allocate (law, source=hard_law(without_summits(properties), settings%penalty, &
            settings%soft_overclosure))
      else if (settings%through_uinter) then
         allocate (through)
         call new_uinter_law(through, properties)
         call move_alloc(through, law)
      else
         allocate (law, source=rough_law(properties))
      end if
   end subroutine new_interface_law

end module asperity_solid_model_interface
