!> The keys of friction beyond one coefficient and one critical slip. What is not given says
!> nothing; what does not act is hidden, and refused where it is given.
module asperity_program_commands_faces_friction_keys
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none, none
   use asperity_base_number_text, only: to_text
   use asperity_contact_friction_settings, only: default_stick_elements, friction_settings, &
      most_friction_points, stick_summits
   use asperity_program_commands_faces_shear_modulus, only: shear_modulus_of_pair
   use asperity_program_input_key_list, only: key_list
   implicit none
   private
   public :: declare_friction, declare_shear_modulus, friction_of_sides

contains

   !> Declare the keys.
   pure subroutine declare_friction(settings, keys, has_time, pair_key)
      !> The settings
      type(friction_settings), intent(out) :: settings
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether the command knows slip rates
      logical, intent(in) :: has_time
      !> Place of the key of the pair
      integer, intent(in) :: pair_key
      integer :: place
      logical :: has_rest, has_grain, has_power, has_summits

      call positive(keys, 'static_friction_coefficient', settings%static_friction_coefficient, '', &
         'coefficient at rest; friction_coefficient, that in motion, unless given')
      has_rest = keys%given()
      call positive(keys, 'decay_slip', settings%decay_slip, 'mm', &
         'slip over which the excess at rest falls to 1/e')
      call keys%needs(has_rest, 'needs static_friction_coefficient')
      if (has_time) then
         call positive(keys, 'decay_slip_rate', settings%decay_slip_rate, 'mm/s', &
            'slip rate at which the excess at rest is down to 1/e')
         call keys%needs(has_rest, 'needs static_friction_coefficient')
      end if

      call positive(keys, 'friction_coefficient_across', settings%friction_coefficient_across, '', &
         'coefficient in motion across the grain; as along it unless given')
      has_grain = keys%given()
      call keys%real('grain_angle', settings%grain_angle, 'degrees', &
         'angle from the first slip direction to the grain')
      call keys%needs(has_grain, 'needs friction_coefficient_across')
      place = settings%slip_direction + 1
      call keys%choice('slip_direction', place, 'associated stress', &
         'slip normal to the ellipse of shear stresses, or along the shear stress')
      call keys%needs(has_grain, 'needs friction_coefficient_across')
      settings%slip_direction = place - 1

      call positive(keys, 'pressure_exponent', settings%pressure_exponent, '', &
         'all coefficients times (p/reference_pressure)^pressure_exponent; above -1', &
         may_be_negative=.true.)
      has_power = keys%given()
      call positive(keys, 'reference_pressure', settings%reference_pressure, 'MPa', &
         'pressure at which the coefficients hold')
      call keys%needs(has_power, 'needs pressure_exponent')
      call declare_points(settings, keys)
      call positive(keys, 'shear_limit', settings%shear_limit, 'MPa', &
         'largest shear stress, along the grain and at rest')

      place = settings%stick + 1
      call keys%choice('stick', place, 'critical_slip summits', &
         'what sticks: the point up to critical_slip, or each summit (Mindlin)')
      settings%stick = place - 1
      call keys%unused(.not. keys%given())
      has_summits = settings%stick == stick_summits
      settings%stick_elements = default_stick_elements
      call keys%whole('stick_elements', settings%stick_elements, &
         'elements that stand for the summits, 4 to 16')
      call keys%needs(has_summits, 'needs stick = summits')
      call declare_shear_modulus('shear_modulus', settings%shear_modulus, keys, has_summits, &
         pair_key)
   end subroutine declare_friction

   !> Declare an equivalent shear modulus, which is that of a pair of the paper unless given.
   pure subroutine declare_shear_modulus(name, modulus, keys, has_summits, pair_key)
      !> Name of the key
      character(len=*), intent(in) :: name
      !> The modulus, MPa; zero where there is none
      real(wp), intent(out) :: modulus
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Whether summits stick
      logical, intent(in) :: has_summits
      !> Place of the key of the pair
      integer, intent(in) :: pair_key

      call positive(keys, name, modulus, 'MPa', &
         'equivalent shear modulus G* of the two faces, for stick = summits', &
         usual=shear_modulus_of_pair(keys%rows(pair_key)%text))
      call keys%given_by(pair_key)
      call keys%needs(has_summits, 'needs stick = summits')
   end subroutine declare_shear_modulus

   !> A number that is above zero where it is given, and zero or the usual one where not.
   pure subroutine positive(keys, name, value, unit, help, may_be_negative, usual)
      type(key_list), intent(inout) :: keys
      character(len=*), intent(in) :: name, unit, help
      real(wp), intent(out) :: value
      logical, intent(in), optional :: may_be_negative
      real(wp), intent(in), optional :: usual

      value = none
      if (present(usual)) value = usual
      call keys%real(name, value, unit, help)
      if (is_none(value)) then
         value = 0.0_wp
      else if (.not. value > 0.0_wp .and. .not. present(may_be_negative)) then
         call keys%refuse(name//' = '//to_text(value)//' is not allowed: it must be above '// &
            'zero, or left out', name)
      end if
   end subroutine positive

   !> Factors by pressure, in pairs.
   pure subroutine declare_points(settings, keys)
      type(friction_settings), intent(inout) :: settings
      type(key_list), intent(inout) :: keys
      real(wp), allocatable :: pairs(:)
      integer :: n

      call keys%list('friction_points', pairs, '', &
         'pressure, MPa, and factor on all coefficients there, in pairs; straight between')
      if (.not. allocated(pairs)) return
      n = size(pairs)/2
      if (modulo(size(pairs), 2) /= 0) then
         call keys%refuse('friction_points has '//to_text(size(pairs))// &
            ' numbers, not pairs of pressure and factor', 'friction_points')
      else if (n > most_friction_points) then
         call keys%refuse('friction_points has '//to_text(n)//' pairs; there may be '// &
            to_text(most_friction_points), 'friction_points')
      else
         settings%friction_points = n
         settings%friction_pressures(:n) = pairs(1::2)
         settings%friction_factors(:n) = pairs(2::2)
      end if
   end subroutine declare_points

   !> The same for faces of another coefficient in motion: those at rest and across are in the same
   !> ratio to it.
   pure function friction_of_sides(settings, ratio, shear_modulus) result(sides)
      !> Settings of the faces
      type(friction_settings), intent(in) :: settings
      !> Coefficient of the sides over that of the faces, and their own G*, MPa
      real(wp), intent(in) :: ratio, shear_modulus
      type(friction_settings) :: sides

      sides = settings
      sides%static_friction_coefficient = ratio*settings%static_friction_coefficient
      sides%friction_coefficient_across = ratio*settings%friction_coefficient_across
      sides%shear_modulus = shear_modulus
   end function friction_of_sides

end module asperity_program_commands_faces_friction_keys
