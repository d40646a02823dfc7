!> Checks of numbers that a caller gives: each names the value, its unit and what is allowed.
module asperity_base_checks
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_finite, only: all_within, is_finite
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   implicit none
   private
   public :: all_positive, check_positive, check_range

   !> Range of a number above zero, wide of any system of units
   real(wp), parameter, public :: smallest_positive = 1.0e-20_wp, largest_positive = 1.0e20_wp

contains

   !> Whether `check_positive` passes every value.
   pure logical function all_positive(values)
      !> Any numbers
      real(wp), intent(in), contiguous :: values(:)

      all_positive = all_within(values, smallest_positive, largest_positive)
   end function all_positive

   !> Set `error` unless `value` is a number above zero (1e-20 to 1e20).
   pure subroutine check_positive(error, name, value, unit)
      !> Set when the value is refused
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value
      real(wp), intent(in) :: value
      !> Its unit, for the message
      character(len=*), intent(in) :: unit
      real(wp) :: values(1)

      values = value
      if (all_positive(values)) return
      call fatal_error(error, name//' = '//to_text(value)// &
         ' is not allowed: it must be a number above zero (1e-20 to 1e20), in '//unit, &
         subject=name)
   end subroutine check_positive

   !> Set `error` unless `value` is a number between two limits.
   pure subroutine check_range(error, name, value, lowest, highest, unit)
      !> Set when the value is refused
      type(error_type), allocatable, intent(inout) :: error
      !> Name of the property
      character(len=*), intent(in) :: name
      !> Its value and the limits
      real(wp), intent(in) :: value, lowest, highest
      !> Its unit with a blank before it, or nothing
      character(len=*), intent(in) :: unit

      if (is_finite(value)) then
         if (value >= lowest .and. value <= highest) return
      end if
      call fatal_error(error, name//' = '//to_text(value)//unit// &
         ' is not allowed: it must be a number between '//to_text(lowest)//' and '// &
         to_text(highest)//unit, subject=name)
   end subroutine check_range

end module asperity_base_checks
