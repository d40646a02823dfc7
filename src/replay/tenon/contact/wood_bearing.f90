!> Bearing of the wood under a contact point: the tenon perpendicular to grain and the column
!> parallel to grain in series, each a spring up to its yield pressure, then hardening with a
!> permanent indentation. No tension.
!>
!> Deflection under a pressure p: p C + sum of max(u_p, (p - f)/H), with C the sum of 1/k and u_p
!> the permanent indentation of each. Without hardening p never passes the smallest such f: the cap.
module asperity_replay_tenon_contact_wood_bearing
   use asperity_base_kinds, only: wp
   use asperity_replay_tenon_settings, only: tenon_settings
   implicit none
   private
   public :: wood_bearing, new_wood_bearing, bearing_deflection, bearing_pressure, &
      bearing_indentation, bearing_plastic_work, layers

   !> Tenon and column
   integer, parameter :: layers = 2

   !> Wood under every point of a face.
   type :: wood_bearing
      !> Sum of 1/stiffness, mm/MPa
      real(wp) :: compliance = 0.0_wp
      !> Yield pressure, MPa, and hardening, MPa/mm, of each layer
      real(wp) :: yield(layers) = huge(1.0_wp), hardening(layers) = 1.0_wp
      !> Pressure that a layer without hardening does not pass, MPa, and that layer (0: none)
      real(wp) :: cap = huge(1.0_wp)
      integer :: capped = 0
   end type wood_bearing

contains

   !> The wood of a joint.
   pure function new_wood_bearing(settings) result(wood)
      !> Checked and complete settings
      type(tenon_settings), intent(in) :: settings
      type(wood_bearing) :: wood
      real(wp) :: stiffness(layers)
      logical :: gives(layers)
      integer :: i

      associate (w => settings%wood)
         stiffness = [w%young_moduli(2)/settings%bearing_depth, &
            w%young_moduli(1)/settings%column_depth]
         gives = [.true., settings%column /= 'rigid']
         wood%compliance = sum(1.0_wp/stiffness, mask=gives)
         if (w%criterion == 'none') return
         where (gives)
            wood%yield = [w%compression_strengths(2), w%compression_strengths(1)]
            wood%hardening = [w%hardening_across, w%hardening_along]*stiffness
         end where
      end associate
      do i = 1, layers
         if (wood%hardening(i) <= 0.0_wp .and. wood%yield(i) < wood%cap) then
            wood%cap = wood%yield(i)
            wood%capped = i
         end if
      end do
   end function new_wood_bearing

   !> Deflection under a pressure up to the cap, and its derivative.
   pure subroutine bearing_deflection(wood, indentation, pressure, deflection, slope)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Permanent indentation so far, mm
      real(wp), intent(in) :: indentation(layers)
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> Deflection, mm, and its derivative, mm/MPa
      real(wp), intent(out) :: deflection, slope
      integer :: i

      deflection = pressure*wood%compliance
      slope = wood%compliance
      do i = 1, layers
         if (pressure > wood%yield(i) + wood%hardening(i)*indentation(i) &
               .and. wood%hardening(i) > 0.0_wp) then
            deflection = deflection + (pressure - wood%yield(i))/wood%hardening(i)
            slope = slope + 1.0_wp/wood%hardening(i)
         else
            deflection = deflection + indentation(i)
         end if
      end do
   end subroutine bearing_deflection

   !> Pressure at a deflection, exactly, and its derivative; zero without contact.
   pure subroutine bearing_pressure(wood, indentation, deflection, pressure, slope)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Permanent indentation so far, mm
      real(wp), intent(in) :: indentation(layers)
      !> Deflection, mm
      real(wp), intent(in) :: deflection
      !> Pressure, MPa, and its derivative, MPa/mm
      real(wp), intent(out) :: pressure, slope
      real(wp) :: found, by_pressure, next
      integer :: i

      pressure = 0.0_wp
      slope = 0.0_wp
      if (deflection <= sum(indentation)) return
      slope = 1.0_wp/wood%compliance
      pressure = (deflection - sum(indentation))*slope
      if (any(pressure > wood%yield + wood%hardening*indentation)) then
         ! the deflection is piecewise linear and convex: from above, Newton ends in a step a layer
         do i = 1, layers + 1
            call bearing_deflection(wood, indentation, pressure, found, by_pressure)
            next = pressure - (found - deflection)/by_pressure
            slope = 1.0_wp/by_pressure
            if (.not. next < pressure) exit
            pressure = next
         end do
      end if
      if (pressure > wood%cap) then
         pressure = wood%cap
         slope = 0.0_wp
      end if
   end subroutine bearing_pressure

   !> Permanent indentation after a pressure at a deflection.
   pure function bearing_indentation(wood, start, pressure, deflection) result(indentation)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Permanent indentation before, mm
      real(wp), intent(in) :: start(layers)
      !> Pressure, MPa, and deflection, mm
      real(wp), intent(in) :: pressure, deflection
      real(wp) :: indentation(layers)
      integer :: i

      do i = 1, layers
         indentation(i) = start(i)
         if (wood%hardening(i) > 0.0_wp) &
            indentation(i) = max(start(i), (pressure - wood%yield(i))/wood%hardening(i))
      end do
      if (wood%capped > 0 .and. pressure >= wood%cap) then
         i = wood%capped
         indentation(i) = 0.0_wp
         indentation(i) = max(start(i), &
            deflection - pressure*wood%compliance - sum(indentation))
      end if
   end function bearing_indentation

   !> Plastic work per area between two indentations, N/mm; exact.
   pure real(wp) function bearing_plastic_work(wood, start, end)
      !> Wood
      type(wood_bearing), intent(in) :: wood
      !> Permanent indentation before and after, mm
      real(wp), intent(in) :: start(layers), end(layers)

      bearing_plastic_work = sum((wood%yield + 0.5_wp*wood%hardening*(start + end))*(end - start), &
         mask=end > start)
   end function bearing_plastic_work

end module asperity_replay_tenon_contact_wood_bearing
