!> One "no value" of reals, for what was not measured, has no result, or is not given.
module asperity_base_no_value
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: is_none

   !> Stands for no value: a number, as comparing NaN may trap, and above every value, so that
   !> `value < none` says that there is one. Loops over the points of a map write it so, without a
   !> call a point; else `is_none` asks.
   real(wp), parameter, public :: none = huge(1.0_wp)

contains

   !> Whether there is no value; what is no number is none, either.
   pure elemental logical function is_none(value)
      !> A value, or `none`
      real(wp), intent(in) :: value

      is_none = .not. value < none
   end function is_none

end module asperity_base_no_value
