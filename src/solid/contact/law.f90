!> What a contact point of the solid joint does when it closes, slides and separates.
module asperity_solid_contact_law
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_response, contact_state
   implicit none
   private
   public :: solid_law

   !> The law of a pair of surfaces. All that it remembers of a point is the point's state.
   type, abstract :: solid_law
   contains
      !> Advance one point over one increment
      procedure(update), deferred :: update
   end type solid_law

   abstract interface
      !> Tractions, tangent, energies and state at the end of an increment.
      subroutine update(law, start, overclosure, slip, response, error)
         import :: contact_response, contact_state, error_type, solid_law, wp
         implicit none
         !> The law
         class(solid_law), intent(inout) :: law
         !> State at the start of the increment
         type(contact_state), intent(in) :: start
         !> Overclosure at its end, mm, `no_opposite_surface` when there is none, and slip within
         !> it, mm
         real(wp), intent(in) :: overclosure, slip(2)
         !> Result
         type(contact_response), intent(out) :: response
         !> Set when there is none
         type(error_type), allocatable, intent(out) :: error
      end subroutine update
   end interface

end module asperity_solid_contact_law
