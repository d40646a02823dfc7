!> Checks of friction beyond one coefficient and one critical slip.
module asperity_contact_check_friction
   use asperity_base_checks, only: check_positive, check_range, largest_positive
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: fewest_stick_elements, friction_settings, &
      largest_friction, most_friction_points, most_stick_elements, slip_direction_associated, &
      slip_direction_of_stress, stick_critical_slip, stick_summits
   use asperity_law_normal_properties, only: heights_gaussian, normal_properties, &
      unloading_reversible
   implicit none
   private
   public :: check_friction, is_plain

   !> Largest pressure exponent; the smallest is -1, where the shear stress would not depend on the
   !> pressure, and is not allowed
   real(wp), parameter :: largest_exponent = 10.0_wp
   !> A full turn, degrees, either way
   real(wp), parameter :: largest_angle = 360.0_wp

contains

   !> Whether settings say nothing beyond one coefficient and one critical slip.
   pure logical function is_plain(settings)
      !> Any settings
      type(friction_settings), intent(in) :: settings

      associate (s => settings)
         is_plain = all([s%friction_points, s%stick] == 0) .and. .not. any(abs([ &
            s%static_friction_coefficient, s%decay_slip, s%decay_slip_rate, &
            s%friction_coefficient_across, s%pressure_exponent, s%shear_limit]) > 0.0_wp)
      end associate
   end function is_plain

   !> Set `error` when something is not allowed, with its name, value and what to do.
   pure subroutine check_friction(settings, friction_coefficient, normal, error)
      !> The settings
      type(friction_settings), intent(in) :: settings
      !> Coefficient in motion along the grain, checked
      real(wp), intent(in) :: friction_coefficient
      !> Checked properties of the normal law
      type(normal_properties), intent(in) :: normal
      !> Set when a setting is refused
      type(error_type), allocatable, intent(out) :: error

      call check_coefficients(settings, friction_coefficient, error)
      if (.not. allocated(error)) call check_grain(settings, error)
      if (.not. allocated(error)) call check_pressure(settings, error)
      if (.not. allocated(error)) call check_stick(settings, normal, error)
      if (allocated(error)) return
      if (.not. (friction_coefficient > 0.0_wp .or. is_plain(settings))) call fatal_error(error, &
         'friction_coefficient = 0 is not allowed with friction that depends on anything: it '// &
         'must be above zero, or leave out what it depends on', subject='friction_coefficient')
   end subroutine check_friction

   !> Rest and motion.
   pure subroutine check_coefficients(settings, friction_coefficient, error)
      type(friction_settings), intent(in) :: settings
      real(wp), intent(in) :: friction_coefficient
      type(error_type), allocatable, intent(inout) :: error

      associate (static => settings%static_friction_coefficient, slip => settings%decay_slip, &
            rate => settings%decay_slip_rate)
         call check_range(error, 'static_friction_coefficient', static, 0.0_wp, largest_friction, &
            '')
         if (.not. allocated(error)) call check_range(error, 'decay_slip', slip, 0.0_wp, &
            largest_positive, ' mm')
         if (.not. allocated(error)) call check_range(error, 'decay_slip_rate', rate, 0.0_wp, &
            largest_positive, ' mm/s')
         if (allocated(error)) return
         if (static > 0.0_wp .and. static < friction_coefficient) then
            call fatal_error(error, 'static_friction_coefficient = '//to_text(static)// &
               ' is not allowed: it must not be below friction_coefficient = '// &
               to_text(friction_coefficient)//', that in motion', &
               subject='static_friction_coefficient')
         else if (static > friction_coefficient .and. .not. max(slip, rate) > 0.0_wp) then
            call fatal_error(error, 'static_friction_coefficient = '//to_text(static)// &
               ' is above friction_coefficient = '//to_text(friction_coefficient)// &
               ', but nothing leads from one to the other: give decay_slip in mm, '// &
               'decay_slip_rate in mm/s, or both', subject='static_friction_coefficient')
         else if (slip > 0.0_wp .and. .not. static > 0.0_wp) then
            call fatal_error(error, 'decay_slip = '//to_text(slip)//' mm has no meaning '// &
               'without static_friction_coefficient: give that as well', subject='decay_slip')
         else if (rate > 0.0_wp .and. .not. static > 0.0_wp) then
            call fatal_error(error, 'decay_slip_rate = '//to_text(rate)//' mm/s has no '// &
               'meaning without static_friction_coefficient: give that as well', &
               subject='decay_slip_rate')
         end if
      end associate
   end subroutine check_coefficients

   !> Direction.
   pure subroutine check_grain(settings, error)
      type(friction_settings), intent(in) :: settings
      type(error_type), allocatable, intent(inout) :: error

      call check_range(error, 'friction_coefficient_across', &
         settings%friction_coefficient_across, 0.0_wp, largest_friction, '')
      if (allocated(error)) return
      if (settings%friction_coefficient_across > 0.0_wp) call check_range(error, &
         'friction_coefficient_across', settings%friction_coefficient_across, &
         1.0_wp/largest_friction, largest_friction, '')
      if (.not. allocated(error)) call check_range(error, 'grain_angle', settings%grain_angle, &
         -largest_angle, largest_angle, ' degrees')
      if (allocated(error)) return
      if (all(settings%slip_direction /= [slip_direction_associated, slip_direction_of_stress])) &
         call fatal_error(error, 'slip_direction = '//to_text(settings%slip_direction)// &
         ' is unknown: 0 is associated, 1 is stress', subject='slip_direction')
   end subroutine check_grain

   !> Pressure and shear limit.
   pure subroutine check_pressure(settings, error)
      type(friction_settings), intent(in) :: settings
      type(error_type), allocatable, intent(inout) :: error
      logical :: has_power
      integer :: i

      associate (s => settings, n => settings%friction_points)
         call check_range(error, 'pressure_exponent', s%pressure_exponent, -1.0_wp, &
            largest_exponent, '')
         if (.not. allocated(error)) call check_range(error, 'reference_pressure', &
            s%reference_pressure, 0.0_wp, largest_positive, ' MPa')
         if (.not. allocated(error)) call check_range(error, 'shear_limit', s%shear_limit, &
            0.0_wp, largest_positive, ' MPa')
         if (allocated(error)) return
         has_power = abs(s%pressure_exponent) > 0.0_wp
         if (.not. s%pressure_exponent > -1.0_wp) then
            call fatal_error(error, 'pressure_exponent = '//to_text(s%pressure_exponent)// &
               ' is not allowed: it must be above -1, as friction would not rise with the '// &
               'pressure; for a shear stress without it, use shear_limit', &
               subject='pressure_exponent')
         else if (has_power .and. .not. s%reference_pressure > 0.0_wp) then
            call fatal_error(error, 'pressure_exponent = '//to_text(s%pressure_exponent)// &
               ' needs reference_pressure: the pressure, MPa, at which the coefficients hold', &
               subject='pressure_exponent')
         else if (n < 0 .or. n > most_friction_points) then
            call fatal_error(error, 'friction_points = '//to_text(n)//' is not allowed: '// &
               'there are 0 to '//to_text(most_friction_points)//' points of pressure and factor', &
               subject='friction_points')
         else if (has_power .and. n > 0) then
            call fatal_error(error, 'friction_points and pressure_exponent = '// &
               to_text(s%pressure_exponent)//' exclude each other: give one of them', &
               subject='friction_points pressure_exponent')
         end if
         if (allocated(error)) return
         do i = 1, n
            call check_range(error, 'pressure '//to_text(i)//' of friction_points', &
               s%friction_pressures(i), 0.0_wp, largest_positive, ' MPa')
            if (.not. allocated(error)) call check_range(error, 'factor '//to_text(i)// &
               ' of friction_points', s%friction_factors(i), 1.0_wp/largest_friction, &
               largest_friction, '')
            if (allocated(error)) exit
         end do
         do i = 2, n
            if (allocated(error)) exit
            if (.not. s%friction_pressures(i) > s%friction_pressures(i - 1)) call fatal_error( &
               error, 'pressure '//to_text(i)//' of friction_points = '// &
               to_text(s%friction_pressures(i))//' MPa is not above the one before: '// &
               'pressures must rise')
         end do
         if (allocated(error)) then
            deallocate (error%subject)
            allocate (error%subject, source='friction_points')
         end if
      end associate
   end subroutine check_pressure

   !> What sticks before it slides.
   pure subroutine check_stick(settings, normal, error)
      type(friction_settings), intent(in) :: settings
      type(normal_properties), intent(in) :: normal
      type(error_type), allocatable, intent(inout) :: error

      associate (s => settings)
         if (s%stick == stick_critical_slip) return
         if (s%stick /= stick_summits) then
            call fatal_error(error, 'stick = '//to_text(s%stick)// &
               ' is unknown: 0 is critical_slip, 1 is summits', subject='stick')
            return
         end if
         if (s%stick_elements /= 0 .and. (s%stick_elements < fewest_stick_elements &
            .or. s%stick_elements > most_stick_elements)) call fatal_error(error, &
            'stick_elements = '//to_text(s%stick_elements)//' is not allowed: it must be '// &
            to_text(fewest_stick_elements)//' to '//to_text(most_stick_elements), &
            subject='stick_elements')
         if (allocated(error)) return
         if (abs(s%shear_modulus) > 0.0_wp) then
            call check_positive(error, 'shear_modulus', s%shear_modulus, 'MPa')
         else
            call fatal_error(error, 'stick = summits needs shear_modulus: the equivalent shear '// &
               'modulus G* of the two faces, MPa, 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2', &
               subject='shear_modulus')
         end if
         if (allocated(error)) return
         if (s%static_friction_coefficient > 0.0_wp) then
            call refuse_beside(error, 'static_friction_coefficient', s%static_friction_coefficient)
         else if (s%friction_coefficient_across > 0.0_wp) then
            call refuse_beside(error, 'friction_coefficient_across', s%friction_coefficient_across)
         else if (normal%unloading /= unloading_reversible) then
            call fatal_error(error, 'stick = summits is for summits without memory: use '// &
               'unloading = reversible, or stick = critical_slip', subject='stick')
         else if (normal%height_distribution /= heights_gaussian) then
            call fatal_error(error, 'stick = summits is for Gaussian heights: use '// &
               'height_distribution = gaussian, or stick = critical_slip', subject='stick')
         end if
      end associate
   end subroutine check_stick

   !> Something that summits cannot have.
   pure subroutine refuse_beside(error, name, value)
      type(error_type), allocatable, intent(inout) :: error
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: value

      call fatal_error(error, 'stick = summits is for one coefficient in all directions, at '// &
         'rest and in motion: leave out '//name//' = '//to_text(value)// &
         ', or use stick = critical_slip', subject='stick '//name)
   end subroutine refuse_beside

end module asperity_contact_check_friction
