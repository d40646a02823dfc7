!> Strength m of a closed point: the largest shear stress at rest, along the grain.
module asperity_contact_friction_strength
   use asperity_base_kinds, only: wp
   use asperity_contact_friction_settings, only: friction_settings
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: find_friction_strength, find_friction_factor, largest_shear_stress, &
      static_coefficient, motion_ratio

   !> Powers of e are kept finite for any pressure
   real(wp), parameter :: largest_power = 200.0_wp

contains

   !> m(p) = min(mu_s f(p) p, shear limit), with the coefficient at rest mu_s and the factor f by
   !> pressure.
   pure subroutine find_friction_strength(properties, pressure, strength, by_pressure)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> m, MPa, and its derivative
      real(wp), intent(out) :: strength, by_pressure
      real(wp) :: factor, factor_by_log_pressure, mu

      strength = 0.0_wp
      by_pressure = 0.0_wp
      if (.not. pressure > 0.0_wp) return
      call find_friction_factor(properties%friction, pressure, factor, factor_by_log_pressure)
      mu = static_coefficient(properties)
      strength = mu*factor*pressure
      by_pressure = mu*(factor + factor_by_log_pressure)
      if (properties%friction%shear_limit > 0.0_wp &
         .and. strength > properties%friction%shear_limit) then
         strength = properties%friction%shear_limit
         by_pressure = 0.0_wp
      end if
   end subroutine find_friction_strength

   !> Largest shear stress in any direction at a pressure, at rest or in motion, MPa.
   pure real(wp) function largest_shear_stress(properties, pressure, moves) result(stress)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> Pressure, MPa
      real(wp), intent(in) :: pressure
      !> Whether the point has slipped far
      logical, intent(in) :: moves
      real(wp) :: by_pressure

      call find_friction_strength(properties, pressure, stress, by_pressure)
      if (moves) stress = stress*motion_ratio(properties)
      stress = stress*max(1.0_wp, properties%friction%friction_coefficient_across &
         /max(properties%friction_coefficient, tiny(1.0_wp)))
   end function largest_shear_stress

   !> Coefficient in motion over that at rest.
   pure real(wp) function motion_ratio(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      motion_ratio = 1.0_wp
      if (properties%friction%static_friction_coefficient > properties%friction_coefficient) &
         motion_ratio = properties%friction_coefficient/static_coefficient(properties)
   end function motion_ratio

   !> Coefficient at rest, along the grain.
   pure real(wp) function static_coefficient(properties)
      !> Checked properties
      type(contact_properties), intent(in) :: properties

      static_coefficient = max(properties%friction%static_friction_coefficient, &
         properties%friction_coefficient)
   end function static_coefficient

   !> Factor on all coefficients: (p/reference)^exponent, straight lines between points, or one.
   pure subroutine find_friction_factor(settings, pressure, factor, by_log_pressure)
      !> Checked settings
      type(friction_settings), intent(in) :: settings
      !> Pressure, MPa; above zero
      real(wp), intent(in) :: pressure
      !> f, and p df/dp
      real(wp), intent(out) :: factor, by_log_pressure
      integer :: i

      factor = 1.0_wp
      by_log_pressure = 0.0_wp
      if (abs(settings%pressure_exponent) > 0.0_wp) then
         factor = exp(min(max(settings%pressure_exponent &
            *log(pressure/settings%reference_pressure), -largest_power), largest_power))
         by_log_pressure = settings%pressure_exponent*factor
      else if (settings%friction_points > 0) then
         associate (p => settings%friction_pressures, f => settings%friction_factors, &
               n => settings%friction_points)
            factor = f(1)
            do i = 2, n
               if (.not. pressure > p(i - 1)) exit
               if (pressure < p(i)) then
                  by_log_pressure = (f(i) - f(i - 1))/(p(i) - p(i - 1))*pressure
                  factor = f(i - 1) + (f(i) - f(i - 1))*((pressure - p(i - 1))/(p(i) - p(i - 1)))
               else
                  factor = f(i)
               end if
            end do
         end associate
      end if
   end subroutine find_friction_factor

end module asperity_contact_friction_strength
