!> The keys of old wood: factors of its properties over those of new wood. Faces take some of them,
!> wood the others; each is listed where it acts.
module asperity_program_commands_wood_ageing_keys
   use asperity_base_error, only: error_type
   use asperity_base_kinds, only: wp
   use asperity_program_input_key_list, only: key_list
   use asperity_wood_ageing, only: ageing_factors, ageing_names, ageing_values, check_ageing, &
      n_factors, set_ageing_values
   implicit none
   private
   public :: declare_ageing

   !> Places among `ageing_names` of what acts on faces, and on wood alone
   integer, parameter, public :: of_faces(4) = [1, 2, 4, 10], of_wood(6) = [3, 5, 6, 7, 8, 9]
   !> That of friction
   integer, parameter, public :: of_friction = 10

   !> What they are
   character(len=*), parameter :: helps(n_factors) = [character(len=67) :: &
      'Young''s modulus along the grain', 'Young''s moduli across the grain', &
      'shear moduli', 'hardness', &
      'strength in compression along the grain', 'strengths in compression across the grain', &
      'strength in tension along the grain', 'strengths in tension across the grain', &
      'strengths in shear', 'friction of faces whose coefficient is not given']

contains

   !> Declare some factors. A factor of 1 is not listed: it does not act. One that is refused is
   !> taken for 1.
   pure subroutine declare_ageing(ageing, keys, places, acts)
      !> The factors
      type(ageing_factors), intent(inout) :: ageing
      !> The keys
      type(key_list), intent(inout) :: keys
      !> Places among `ageing_names` of those that are declared
      integer, intent(in) :: places(:)
      !> Which of them act
      logical, intent(in) :: acts(:)
      type(error_type), allocatable :: error
      real(wp) :: values(n_factors)
      integer :: i

      values = ageing_values(ageing)
      values(places) = 1.0_wp
      do i = 1, size(places)
         associate (value => values(places(i)))
            call keys%real(trim(ageing_names(places(i))), value, '', &
               'old over new wood: '//trim(helps(places(i))))
            call keys%unused(.not. acts(i) .or. (value >= 1.0_wp .and. value <= 1.0_wp))
         end associate
      end do
      call set_ageing_values(ageing, values)
      call check_ageing(ageing, error)
      if (.not. allocated(error)) return
      call keys%refuse(error%message, error%subject)
      ageing = ageing_factors()
   end subroutine declare_ageing

end module asperity_program_commands_wood_ageing_keys
