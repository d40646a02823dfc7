!> From the address behind a handle to the law or the states there. Their types have allocatable
!> components, which C has not: the address is one that `c_loc` gave for the same type, as the
!> standard asks. flang warns of it all the same, so this file alone is compiled without warnings.
module asperity_c_contents
   use, intrinsic :: iso_c_binding, only: c_f_pointer, c_ptr
   use asperity_contact_points, only: contact_states
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: content_at

   !> Associate a pointer with a law or with states.
   interface content_at
      procedure law_at
      procedure states_at
   end interface content_at

contains

   !> Content of a law's handle.
   subroutine law_at(address, content)
      !> Where it is; NULL for none
      type(c_ptr), intent(in) :: address
      !> The law
      type(contact_properties), pointer, intent(out) :: content

      call c_f_pointer(address, content)
   end subroutine law_at

   !> Content of a handle of states.
   subroutine states_at(address, content)
      !> Where it is; NULL for none
      type(c_ptr), intent(in) :: address
      !> The states
      type(contact_states), pointer, intent(out) :: content

      call c_f_pointer(address, content)
   end subroutine states_at

end module asperity_c_contents
