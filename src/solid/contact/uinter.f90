!> The rough law through UINTER, called as ABAQUS calls it.
module asperity_solid_contact_uinter
   use asperity_abaqus_statev, only: statev_from_state
   use asperity_abaqus_uinter_signature, only: uinter_interface
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_state, only: contact_response, contact_state, is_closed
   use asperity_replay_abaqus_host, only: host_point, host_response, new_host_point, refuse_cut, &
      try_increment
   use asperity_solid_contact_rough, only: rough_law
   implicit none
   private
   public :: uinter_law, new_uinter_law

   !> A host of UINTER that takes the place of one point after the other: what UINTER knows of a
   !> point is its STATEV.
   type, extends(rough_law) :: uinter_law
      type(host_point), private :: host
   contains
      procedure :: update
   end type uinter_law

   procedure(uinter_interface) :: uinter

contains

   !> A law for points of checked properties.
   subroutine new_uinter_law(law, properties)
      !> Result
      type(uinter_law), intent(out) :: law
      !> Normal law and friction
      type(contact_properties), intent(in) :: properties

      law%properties = properties
      call new_host_point(law%host, uinter, properties, keep_history=.false.)
   end subroutine new_uinter_law

   subroutine update(law, start, overclosure, slip, response, error)
      class(uinter_law), intent(inout) :: law
      type(contact_state), intent(in) :: start
      real(wp), intent(in) :: overclosure, slip(2)
      type(contact_response), intent(out) :: response
      type(error_type), allocatable, intent(out) :: error

      associate (host => law%host)
         call statev_from_state(start, host%start%statev)
         host%start%rdisp(1) = start%overclosure
         host%start%lopenclose = merge(1, 0, is_closed(start))
         host%trial = host%start
         call try_increment(host, overclosure, slip, 0.0_wp, error)
         if (.not. allocated(error)) call refuse_cut(host, error)
         if (.not. allocated(error)) response = host_response(host)
      end associate
   end subroutine update

end module asperity_solid_contact_uinter
