!> A pair of the paper whose wood is old.
module asperity_faces_aged_pair
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_law_normal_properties, only: equivalent_modulus
   use asperity_paper_pairs, only: pair_preset
   use asperity_wood_ageing, only: aged_wood, ageing_factors, ageing_values, check_aged_wood
   use asperity_wood_properties, only: wood_properties
   use asperity_wood_sections, only: section_constants, section_names
   implicit none
   private
   public :: age_pair

contains

   !> Multiply what age changes: hardness, friction, and E* by what Eq. 4 makes of its two sections
   !> when old over new, as the pairs of the paper have E* from elsewhere. Roughness stays. `error`
   !> is set when the wood cannot be, new or old, or the name of the pair has not two sections;
   !> neutral factors look at neither.
   pure subroutine age_pair(pair, wood, ageing, error)
      !> The pair
      type(pair_preset), intent(inout) :: pair
      !> Its wood when it is new
      type(wood_properties), intent(in) :: wood
      !> Old over new
      type(ageing_factors), intent(in) :: ageing
      !> Set when it is refused
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: new, old

      if (.not. any(abs(ageing_values(ageing) - 1.0_wp) > 0.0_wp)) return
      call check_aged_wood(wood, ageing, error)
      if (.not. allocated(error)) call modulus_by_sections(pair%name, wood, new, error)
      if (.not. allocated(error)) &
         call modulus_by_sections(pair%name, aged_wood(wood, ageing), old, error)
      if (allocated(error)) return
      pair%modulus = pair%modulus*(old/new)
      pair%hardness = pair%hardness*ageing%hardness
      pair%friction_coefficient = pair%friction_coefficient*ageing%friction
   end subroutine age_pair

   !> E* by Eq. 4 of the two sections that a pair is named by, MPa.
   pure subroutine modulus_by_sections(name, wood, modulus, error)
      character(len=*), intent(in) :: name
      type(wood_properties), intent(in) :: wood
      real(wp), intent(out) :: modulus
      type(error_type), allocatable, intent(out) :: error
      real(wp) :: young(2), poisson(2), hardness
      integer :: i, sections(2), dash

      dash = index(name, '-')
      sections = [findloc(section_names == name(:dash - 1), .true., 1), &
         findloc(section_names == name(dash + 1:), .true., 1)]
      modulus = 0.0_wp
      if (any(sections == 0)) then
         call fatal_error(error, 'pair = '''//trim(name)//''' has no sections in its name, as '// &
            'transverse-tangential has; make faces of old wood by face_of_wood of aged_wood', &
            subject='pair')
         return
      end if
      do i = 1, 2
         call section_constants(wood, sections(i), young(i), poisson(i), hardness, error)
         if (allocated(error)) return
      end do
      modulus = equivalent_modulus(young(1), poisson(1), young(2), poisson(2))
   end subroutine modulus_by_sections

end module asperity_faces_aged_pair
