!> The key that an unknown name may mean: one that has had this name, or one that is spelt alike.
module asperity_program_input_nearest_key
   use asperity_program_input_key, only: name_length, option_name
   use asperity_program_system_strings, only: nearest_name
   implicit none
   private
   public :: nearest_key

   !> A key that has another name than it had.
   type :: renamed_key
      character(len=name_length) :: before, now
   end type renamed_key

   !> So that case files of older versions are told what to write; the old names do nothing
   type(renamed_key), parameter :: renamed(*) = [ &
      renamed_key('bearing_modulus', 'young_modulus_r'), &
      renamed_key('bearing_strength', 'compression_strength_r'), &
      renamed_key('hardening', 'hardening_across'), &
      renamed_key('column_modulus', 'young_modulus_l'), &
      renamed_key('column_strength', 'compression_strength_l'), &
      renamed_key('column_hardening', 'hardening_along'), &
      renamed_key('plasticity', 'criterion')]

contains

   !> The nearest of some names, empty when none is near.
   pure function nearest_key(mistyped, names) result(nearest)
      !> What the user wrote: a key or an option
      character(len=*), intent(in) :: mistyped
      !> Names known, of the same kind
      character(len=*), intent(in) :: names(:)
      character(len=:), allocatable :: nearest
      integer :: i

      do i = 1, size(renamed)
         if (mistyped == renamed(i)%before) nearest = trim(renamed(i)%now)
         if (mistyped == option_name(renamed(i)%before)) nearest = option_name(renamed(i)%now)
      end do
      if (allocated(nearest)) then
         if (any(names == nearest)) return
      end if
      nearest = nearest_name(mistyped, names)
   end function nearest_key

end module asperity_program_input_nearest_key
