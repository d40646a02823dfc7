!> Elastic-slip elements in parallel that make up the friction of a point: shear stress = sum of
!> stiffness times elastic slip, each within its radius.
module asperity_contact_friction_elements
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: most_stick_elements
   use asperity_contact_friction_strength, only: find_friction_strength
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: friction_elements, find_friction_elements

   !> The elements at a pressure. The first `n` count.
   type :: friction_elements
      integer :: n
      !> Stiffness along the grain, MPa/mm, and its derivative by overclosure
      real(wp) :: stiffness(most_stick_elements), stiffness_by(most_stick_elements)
      !> Largest elastic slip, at rest, mm, and its derivative by overclosure
      real(wp) :: radius(most_stick_elements), radius_by(most_stick_elements)
   end type friction_elements

contains

   !> One element with gcrit.
   pure subroutine find_friction_elements(properties, pressure, pressure_by_overclosure, elements)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa, and its derivative, MPa/mm
      real(wp), intent(in) :: pressure, pressure_by_overclosure
      !> Result
      type(friction_elements), intent(out) :: elements
      real(wp) :: strength, by_pressure

      call find_friction_strength(properties, pressure, strength, by_pressure)
      elements%n = 1
      elements%stiffness(1) = strength/properties%critical_slip
      elements%stiffness_by(1) = by_pressure/properties%critical_slip*pressure_by_overclosure
      elements%radius(1) = properties%critical_slip
      elements%radius_by(1) = 0.0_wp
   end subroutine find_friction_elements

end module asperity_contact_friction_elements
