!> The paths of test_friction.c once more, by the library in Fortran.
module fortran_twin
   use, intrinsic :: iso_c_binding, only: c_double, c_int
   use asperity, only: contact_properties, contact_response, contact_state, error_type, &
      friction_settings, heights_johnson, new_contact_properties, new_normal_properties, &
      normal_properties, rule_dissipative, slip_direction_of_stress, stick_summits, &
      update_contact_point
   implicit none
   private
   public :: advance_in_fortran

contains

   !> Tractions (3, steps) along a path of one point; zero where the properties are refused.
   subroutine advance_in_fortran(kind, steps, overclosure, slip, rotation, time_increment, &
         traction) bind(c)
      !> One of the kinds of test_friction.c, and the number of steps
      integer(c_int), value, intent(in) :: kind, steps
      !> Motion of each step; (steps), (2, steps), (2, 2, steps), (steps)
      real(c_double), intent(in) :: overclosure(steps), slip(2, steps), rotation(2, 2, steps), &
         time_increment(steps)
      real(c_double), intent(out) :: traction(3, steps)
      type(normal_properties) :: normal
      type(contact_properties) :: properties
      type(contact_response) :: response
      type(friction_settings) :: friction
      type(error_type), allocatable :: error
      integer :: i

      traction = 0.0_c_double
      if (kind == 0) then
         call new_normal_properties(normal, 206.0_c_double, 297.0_c_double, 0.1477_c_double, &
            24.53_c_double, 0.4_c_double, 0.0593_c_double, error, plastic_ratio=54.0_c_double, &
            height_distribution=heights_johnson, skewness=0.3_c_double, kurtosis=3.61_c_double)
      else
         call new_normal_properties(normal, 206.0_c_double, 297.0_c_double, 0.1477_c_double, &
            24.53_c_double, 0.4_c_double, 0.0593_c_double, error)
      end if
      if (allocated(error)) return
      select case (kind)
      case (1)
         friction = friction_settings(static_friction_coefficient=0.75_c_double, &
            decay_slip=0.125_c_double, decay_slip_rate=2.0_c_double)
      case (2)
         friction = friction_settings(friction_coefficient_across=0.25_c_double, &
            grain_angle=30.0_c_double, slip_direction=slip_direction_of_stress)
      case (3)
         friction = friction_settings(pressure_exponent=-0.25_c_double, &
            reference_pressure=2.0_c_double, shear_limit=0.5_c_double)
      case (4)
         friction = friction_settings(friction_points=2)
         friction%friction_pressures(:2) = [0.125_c_double, 1.5_c_double]
         friction%friction_factors(:2) = [1.25_c_double, 0.5_c_double]
      case (5)
         friction = friction_settings(stick=stick_summits, stick_elements=6, &
            shear_modulus=31.6_c_double)
      case default
         friction = friction_settings()
      end select
      call new_contact_properties(properties, normal, 0.5_c_double, 0.31_c_double, error, &
         friction_rule=rule_dissipative, friction=friction)
      if (allocated(error)) return
      response%state = contact_state()
      do i = 1, steps
         call update_contact_point(properties, (response%state), overclosure(i), slip(:, i), &
            rotation(:, :, i), response, time_increment(i))
         traction(:, i) = response%traction
      end do
   end subroutine advance_in_fortran

end module fortran_twin
