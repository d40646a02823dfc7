! UINTER is linked with what its host supplies; PROPS that are too few are refused
program abaqus
   use asperity_abaqus_prop_slots, only: n_props
   use asperity_abaqus_props, only: properties_from_props
   use asperity, only: contact_properties, error_type, wp
   use asperity_abaqus_uinter_signature, only: uinter_interface
   implicit none
   procedure(uinter_interface) :: uinter
   procedure(uinter_interface), pointer :: routine
   type(contact_properties) :: properties
   type(error_type), allocatable :: error

   routine => uinter
   if (.not. associated(routine) .or. n_props < 9) error stop 1
   call properties_from_props([0.5_wp], properties, error)
   if (.not. allocated(error)) error stop 2
   print '(2a)', 'abaqus: ', error%message
end program abaqus
