!> What wood of three dimensions is refused: what cannot be, and what is in another unit.
module asperity_deck_check_wood
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_base_no_value, only: is_none
   use asperity_replay_sizes, only: check_size
   use asperity_wood_check, only: check_wood_properties
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_values, only: n_values, value_names, value_units, wood_values
   implicit none
   private
   public :: check_wood

contains

   !> `error` is set when a property is not allowed.
   pure subroutine check_wood(wood, accept_sizes, error)
      !> The wood
      type(wood_properties), intent(in) :: wood
      !> Let moduli and strengths outside the ranges of `asperity_replay_sizes` pass
      logical, intent(in) :: accept_sizes
      !> Set when one is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: values(n_values)
      integer :: i

      values = wood_values(wood)
      do i = 1, n_values
         if (value_units(i) == 'MPa' .and. .not. is_none(values(i))) &
            call check_size(error, trim(value_names(i)), values(i), accept_sizes)
      end do
      if (.not. allocated(error)) call check_wood_properties(wood, error)
   end subroutine check_wood

end module asperity_deck_check_wood
