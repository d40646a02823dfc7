!> What a fit takes from shear tests before it begins: their normal stress, and guesses of the
!> numbers.
module asperity_program_commands_fit_shear_tests
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_base_number_text, only: to_text
   use asperity_fit_shear_model, only: shear_critical_slip, shear_decay_slip, &
      shear_friction_coefficient, shear_pressure_exponent, shear_shear_compliance, &
      shear_static_friction_coefficient, shear_test
   use asperity_program_commands_fit_record_input, only: fit_record
   use asperity_program_record_names, only: find_meaning, holds_pressure
   use asperity_program_record_numbers, only: read_number
   use asperity_program_record_units, only: find_unit, unit_pressure
   use asperity_program_system_strings, only: add_line, string_type
   implicit none
   private
   public :: find_normal_stress, guess, remark_loaded

   !> Critical slip and decay over the way from end to end, coefficient at rest over that in motion
   real(wp), parameter :: slip_share = 0.05_wp, decay_share = 0.2_wp, rest_ratio = 1.2_wp
   !> A test that begins with more than this share of its largest stress was not free of it
   real(wp), parameter :: loaded_share = 0.05_wp

contains

   !> Normal stress of a test: that of a leading column, else the key.
   subroutine find_normal_stress(record, usual, normal_stress, error)
      !> The test
      type(fit_record), intent(in) :: record
      !> That of the key, `none` for none, and what was found, MPa
      real(wp), intent(in) :: usual
      real(wp), intent(out) :: normal_stress
      !> Set when nothing says it
      type(error_type), allocatable, intent(out) :: error
      integer :: holds, i, rank

      normal_stress = usual
      do i = 1, size(record%constants)
         associate (c => record%constants(i), unit => find_unit(record%constants(i)%unit))
            call find_meaning(c%name, holds, rank)
            if (holds /= holds_pressure) cycle
            call read_number(c%value, 'comma', normal_stress, error)
            if (allocated(error)) return
            if (unit%measures == unit_pressure) normal_stress = unit%factor*normal_stress
            return
         end associate
      end do
      if (is_none(normal_stress)) call fatal_error(error, 'nothing says the normal '// &
         'stress: give it in MPa by --fix normal_stress=, or as a leading column')
   end subroutine find_normal_stress

   !> A number to begin a search at.
   pure real(wp) function guess(tests, which)
      !> The tests
      type(shear_test), intent(in) :: tests(:)
      !> The number, one of `asperity_fit_shear_model`
      integer, intent(in) :: which
      real(wp) :: way, coefficient, stress, force
      integer :: i

      way = 0.0_wp
      coefficient = 0.0_wp
      stress = 0.0_wp
      force = 0.0_wp
      do i = 1, size(tests)
         associate (t => tests(i))
            way = max(way, maxval(t%displacement) - minval(t%displacement))
            coefficient = max(coefficient, maxval(abs(t%shear_stress)/t%normal_stress))
            stress = max(stress, maxval(abs(t%shear_stress)))
            if (allocated(t%area)) force = max(force, maxval(abs(t%shear_stress)*t%area))
         end associate
      end do
      select case (which)
      case (shear_friction_coefficient)
         guess = coefficient
      case (shear_static_friction_coefficient)
         guess = rest_ratio*coefficient
      case (shear_critical_slip)
         guess = slip_share*way
      case (shear_decay_slip)
         guess = decay_share*way
      case (shear_pressure_exponent)
         guess = 0.0_wp
      case (shear_shear_compliance)
         guess = slip_share*way/force
      case default
         guess = stress
      end select
   end function guess

   !> Say which tests begin under load.
   pure subroutine remark_loaded(tests, lines)
      !> The tests
      type(shear_test), intent(in) :: tests(:)
      !> One a test that does
      type(string_type), allocatable, intent(out) :: lines(:)
      integer :: i

      allocate (lines(0))
      do i = 1, size(tests)
         associate (stress => tests(i)%shear_stress)
            if (abs(stress(1)) > loaded_share*maxval(abs(stress))) call add_line(lines, &
               'Test '//to_text(i)//' begins with '//to_text(100.0_wp*abs(stress(1)) &
               /maxval(abs(stress)), 2)//' % of its largest shear stress, the model with none: '// &
               'is its zero off (--force-zero), or its beginning missing?')
         end associate
      end do
   end subroutine remark_loaded

end module asperity_program_commands_fit_shear_tests
