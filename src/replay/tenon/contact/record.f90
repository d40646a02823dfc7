!> What is known of one contact point of the tenon joint at the end of an increment.
module asperity_replay_tenon_contact_record
   use asperity_base_kinds, only: wp
   use asperity_contact_state, only: contact_response, contact_state, no_opposite_surface, &
      status_open, status_unset
   use asperity_replay_tenon_contact_wood_bearing, only: layers
   implicit none
   private
   public :: contact_record, keep_response, leave_surface

   !> A contact point at the end of an increment.
   type :: contact_record
      !> Number of the point in its joint
      integer :: point = 0
      !> Place in the mortise, mm, and slip since the start, mm
      real(wp) :: place(2) = 0.0_wp, slip(2) = 0.0_wp
      !> Share of the point's area that is in the mortise
      real(wp) :: weight = 0.0_wp
      !> Closure past first touch of the undeformed wood, mm
      real(wp) :: closure = no_opposite_surface
      !> Its overclosure, pressure, elastic slip, status: what the update remembers
      type(contact_state) :: state = contact_state()
      !> Permanent indentation of the wood, mm
      real(wp) :: indentation(layers) = 0.0_wp
      !> Shear stresses, MPa
      real(wp) :: shear(2) = 0.0_wp
      !> Derivatives of pressure and shear stress by closure, of shear stress by slip, MPa/mm
      real(wp) :: stiffness = 0.0_wp, shear_by_closure(2) = 0.0_wp, shear_by_slip(2, 2) = 0.0_wp
      !> Derivative of the overclosure by closure
      real(wp) :: overclosure_by_closure = 1.0_wp
      !> Stored tangential energy per area, N/mm; frictional dissipation, pressure coupling and
      !> plastic dissipation of the summits in the increment
      real(wp) :: tangential_energy = 0.0_wp, dissipation = 0.0_wp, pressure_coupling = 0.0_wp
      real(wp) :: plastic_dissipation = 0.0_wp
   end type contact_record

contains

   !> Keep what an update of the interface returned, with derivatives by closure.
   pure subroutine keep_response(record, response, closure, overclosure_by_closure)
      !> The point
      type(contact_record), intent(inout) :: record
      !> Result of the update
      type(contact_response), intent(in) :: response
      !> Closure, mm, and how the overclosure follows it
      real(wp), intent(in) :: closure, overclosure_by_closure

      record%closure = closure
      record%state = response%state
      record%shear = response%traction(2:)
      record%overclosure_by_closure = overclosure_by_closure
      record%stiffness = overclosure_by_closure*response%tangent(1, 1)
      record%shear_by_closure = overclosure_by_closure*response%tangent(2:, 1)
      record%shear_by_slip = response%tangent(2:, 2:)
      record%tangential_energy = response%tangential_energy
      record%dissipation = response%dissipation
      record%pressure_coupling = response%pressure_coupling
      record%plastic_dissipation = response%plastic_dissipation
   end subroutine keep_response

   !> Nothing is opposite to the point: it forgets its elastic slip, not its indentation nor how
   !> flat its summits are.
   pure subroutine leave_surface(start, trial)
      !> Point before and after
      type(contact_record), intent(in) :: start
      type(contact_record), intent(inout) :: trial
      type(contact_response) :: nothing

      nothing%state = contact_state(status=status_open, overclosure=no_opposite_surface, &
         largest_closure=no_opposite_surface, validity=start%state%validity)
      if (start%state%status /= status_unset) &
         nothing%state%largest_closure = start%state%largest_closure
      call keep_response(trial, nothing, no_opposite_surface, 1.0_wp)
      trial%weight = 0.0_wp
      trial%indentation = start%indentation
   end subroutine leave_surface

end module asperity_replay_tenon_contact_record
