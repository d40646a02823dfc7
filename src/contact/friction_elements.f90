!> Elastic-slip elements in parallel that make up the friction of a point: shear stress = sum of
!> stiffness times elastic slip, each within its radius.
module asperity_contact_friction_elements
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: default_stick_elements, &
      most_stick_elements, stick_summits
   use asperity_contact_friction_strength, only: find_friction_strength
   use asperity_contact_properties, only: contact_properties
   use asperity_contact_stick_elements, only: find_stick_elements, stick_elements
   implicit none
   private
   public :: friction_elements, find_friction_elements, stick_number

   !> The elements at a pressure. The first `n` count.
   type :: friction_elements
      integer :: n
      !> Stiffness along the grain, MPa/mm, and its derivative by overclosure
      real(wp) :: stiffness(most_stick_elements), stiffness_by(most_stick_elements)
      !> Largest elastic slip, at rest, mm, and its derivative by overclosure
      real(wp) :: radius(most_stick_elements), radius_by(most_stick_elements)
   end type friction_elements

contains

   !> One element with gcrit, or those of the summits.
   pure subroutine find_friction_elements(properties, overclosure, pressure, &
         pressure_by_overclosure, elements)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Overclosure, mm
      real(wp), intent(in) :: overclosure
      !> Pressure there, MPa, and its derivative, MPa/mm
      real(wp), intent(in) :: pressure, pressure_by_overclosure
      !> Result
      type(friction_elements), intent(out) :: elements
      real(wp) :: strength, by_pressure

      call find_friction_strength(properties, pressure, strength, by_pressure)
      if (properties%friction%stick == stick_summits) then
         call find_summits(properties, overclosure, pressure, pressure_by_overclosure, strength, &
            by_pressure, elements)
         return
      end if
      elements%n = 1
      elements%stiffness(1) = strength/properties%critical_slip
      elements%stiffness_by(1) = by_pressure/properties%critical_slip*pressure_by_overclosure
      elements%radius(1) = properties%critical_slip
      elements%radius_by(1) = 0.0_wp
   end subroutine find_friction_elements

   !> Elements of the summits: their stiffness is that of solids and does not depend on friction,
   !> their largest elastic slips are in proportion to its coefficient, strength over pressure.
   pure subroutine find_summits(properties, overclosure, pressure, pressure_by_overclosure, &
         strength, by_pressure, elements)
      type(contact_properties), intent(in) :: properties
      real(wp), intent(in) :: overclosure, pressure, pressure_by_overclosure
      !> Largest shear stress, MPa, and its derivative by pressure
      real(wp), intent(in) :: strength, by_pressure
      type(friction_elements), intent(out) :: elements
      type(stick_elements) :: summits
      real(wp) :: coefficient, coefficient_by
      integer :: j

      coefficient = properties%friction_coefficient
      coefficient_by = 0.0_wp
      if (pressure > 0.0_wp) then
         coefficient = strength/pressure
         coefficient_by = (by_pressure - coefficient)*(pressure_by_overclosure/pressure)
      end if
      call find_stick_elements(properties%normal, properties%friction%shear_modulus, &
         stick_number(properties), properties%initial_separation - overclosure, summits)
      elements%n = summits%n
      do j = 1, summits%n
         associate (share => summits%share(j), slip => summits%unit_slip(j), &
               share_by => summits%share_by_closure(j), slip_by => summits%unit_slip_by_closure(j))
            elements%stiffness(j) = pressure*share/slip
            elements%stiffness_by(j) = (pressure_by_overclosure*share &
               + pressure*(share_by - share*slip_by/slip))/slip
            elements%radius(j) = coefficient*slip
            elements%radius_by(j) = coefficient_by*slip + coefficient*slip_by
         end associate
      end do
   end subroutine find_summits

   !> How many elements the summits have.
   pure integer function stick_number(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      stick_number = properties%friction%stick_elements
      if (stick_number == 0) stick_number = default_stick_elements
   end function stick_number

end module asperity_contact_friction_elements
