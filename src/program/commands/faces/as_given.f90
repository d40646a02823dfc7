!> Values of two faces that old wood leaves as they are, as they were given.
module asperity_program_commands_faces_as_given
   use asperity_base_kinds, only: wp
   use asperity_program_commands_faces_properties, only: face_properties, friction_coefficient, &
      hardness, modulus, n_properties
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: ageing_factors
   implicit none
   private
   public :: as_given_words

contains

   !> Which given values some factor of old wood would have acted on; empty for none.
   pure function as_given_words(ageing, key_places, keys) result(text)
      !> Factors of old wood
      type(ageing_factors), intent(in) :: ageing
      !> Places of the keys of the properties, zero for none
      integer, intent(in) :: key_places(n_properties)
      !> The keys
      type(key_list), intent(in) :: keys
      character(len=:), allocatable :: text
      integer, parameter :: places(3) = [modulus, hardness, friction_coefficient]
      real(wp) :: factors(3)
      integer :: i

      text = ''
      factors = [merge(ageing%stiffness_along, ageing%stiffness_across, &
         abs(ageing%stiffness_along - 1.0_wp) > 0.0_wp), ageing%hardness, ageing%friction]
      do i = 1, size(places)
         if (key_places(places(i)) == 0 .or. .not. abs(factors(i) - 1.0_wp) > 0.0_wp) cycle
         if (.not. keys%given(key_places(places(i)))) cycle
         if (text /= '') text = text//', '
         text = text//trim(face_properties(places(i))%name)
      end do
      if (text /= '') text = 'Old wood: as given, not aged: '//text
   end function as_given_words

end module asperity_program_commands_faces_as_given
