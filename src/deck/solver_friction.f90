!> Friction as solvers have it, for contact that is not UINTER's: what they can say of friction
!> beyond one coefficient, and what they cannot.
module asperity_deck_solver_friction
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: slip_direction_of_stress, stick_summits
   use asperity_contact_friction_strength, only: find_friction_factor
   use asperity_contact_properties, only: contact_properties
   implicit none
   private
   public :: check_solver_friction, friction_parameters, friction_rows

   !> Rows of a power: factors 10^(1/rows_per_decade) of pressure apart, over the decades below the
   !> hardness; straight lines between them are within 0.3 % for an exponent of -0.3
   integer, parameter :: rows_per_decade = 10, decades = 5

contains

   !> Set `error` when a solver's own friction cannot be this one.
   pure subroutine check_solver_friction(properties, is_calculix, error)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      !> CalculiX, or ABAQUS
      logical, intent(in) :: is_calculix
      !> Set when the solver cannot
      type(error_type), allocatable, intent(out) :: error

      if (properties%friction_is_plain) return
      associate (f => properties%friction)
         if (is_calculix) then
            call refuse(error, 'friction of CalculiX has one coefficient', '')
         else if (f%stick == stick_summits) then
            call refuse(error, 'friction of ABAQUS has one elastic slip, not stick = summits', &
               'stick')
         else if (f%decay_slip > 0.0_wp) then
            call refuse(error, 'friction of ABAQUS decays with the slip rate, not with slip: '// &
               'decay_slip = '//to_text(f%decay_slip)//' mm', 'decay_slip')
         else if (f%static_friction_coefficient > 0.0_wp .and. &
               (f%friction_coefficient_across > 0.0_wp .or. varies(properties))) then
            call refuse(error, 'friction of ABAQUS that decays has one coefficient in all '// &
               'directions, at any pressure', 'static_friction_coefficient')
         else if (f%static_friction_coefficient > 0.0_wp &
               .and. .not. f%decay_slip_rate > 0.0_wp) then
            call refuse(error, 'friction of ABAQUS that decays needs decay_slip_rate', &
               'static_friction_coefficient')
         else if (f%shear_limit > 0.0_wp .and. max(f%static_friction_coefficient, &
               f%friction_coefficient_across) > 0.0_wp) then
            ! the law's falls with the coefficient as motion begins and across the grain
            call refuse(error, 'the shear limit of ABAQUS is one for rest and motion and for '// &
               'all directions: shear_limit = '//to_text(f%shear_limit)//' MPa', 'shear_limit')
         else if (f%friction_coefficient_across > 0.0_wp .and. &
               f%slip_direction == slip_direction_of_stress) then
            call refuse(error, 'friction of ABAQUS with two coefficients slips normal to the '// &
               'ellipse: slip_direction = stress', 'slip_direction')
         else if (f%friction_coefficient_across > 0.0_wp .and. abs(f%grain_angle) > 0.0_wp) then
            call refuse(error, 'friction of ABAQUS has its two coefficients along the slip '// &
               'directions: grain_angle = '//to_text(f%grain_angle)//' degrees', 'grain_angle')
         end if
      end associate
   end subroutine check_solver_friction

   pure subroutine refuse(error, why, subject)
      type(error_type), allocatable, intent(out) :: error
      character(len=*), intent(in) :: why, subject

      call fatal_error(error, why//'; leave it out, or use contact by UINTER', subject=subject)
   end subroutine refuse

   !> What stands after ELASTIC SLIP on the card *FRICTION of ABAQUS; nothing for plain friction.
   pure function friction_parameters(properties) result(text)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      character(len=:), allocatable :: text

      text = ''
      associate (f => properties%friction)
         if (f%static_friction_coefficient > 0.0_wp) text = text//', EXPONENTIAL DECAY'
         if (f%friction_coefficient_across > 0.0_wp) text = text//', ANISOTROPIC'
         if (f%shear_limit > 0.0_wp) text = text//', TAUMAX='//to_text(f%shear_limit)
      end associate
   end function friction_parameters

   !> Its data lines, one a row: the coefficient; those at rest and in motion and the coefficient of
   !> decay, s/mm; one or two coefficients, slip rate zero, and pressure, MPa.
   pure function friction_rows(properties) result(rows)
      !> Checked properties
      type(contact_properties), intent(in) :: properties
      real(wp), allocatable :: rows(:, :)
      real(wp), allocatable :: mu(:), pressures(:)
      real(wp) :: factor, slope
      integer :: i

      associate (f => properties%friction)
         allocate (mu, source=[properties%friction_coefficient])
         if (f%friction_coefficient_across > 0.0_wp) mu = [mu, f%friction_coefficient_across]
         if (f%static_friction_coefficient > 0.0_wp) mu = [f%static_friction_coefficient, mu, &
            1.0_wp/f%decay_slip_rate]
         if (.not. varies(properties)) then
            rows = reshape(mu, [1, size(mu)])
            return
         end if
         if (f%friction_points > 0) then
            allocate (pressures, source=f%friction_pressures(:f%friction_points))
         else
            allocate (pressures, source=[(properties%normal%hardness &
               *10.0_wp**(-real(i, wp)/rows_per_decade), i=rows_per_decade*decades, 0, -1)])
         end if
         allocate (rows(size(pressures), size(mu) + 2), source=0.0_wp)
         do i = 1, size(pressures)
            call find_friction_factor(f, max(pressures(i), tiny(1.0_wp)), factor, slope)
            rows(i, :size(mu)) = factor*mu
            rows(i, size(mu) + 2) = pressures(i)
         end do
      end associate
   end function friction_rows

   !> Whether coefficients depend on the pressure.
   pure logical function varies(properties)
      type(contact_properties), intent(in) :: properties

      varies = properties%friction%friction_points > 0 &
         .or. abs(properties%friction%pressure_exponent) > 0.0_wp
   end function varies

end module asperity_deck_solver_friction
