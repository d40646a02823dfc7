!> The interactions of a deck that a UINTER serves: what the lines after
!>    *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=UINTER, PROPERTIES=n, DEPVAR=m, SEARCH DISTANCE=c
!> say. The deck is read on one thread, and nothing is changed afterwards.
module asperity_calculix_interactions
   use asperity_base_kinds, only: wp
   implicit none
   private
   public :: interaction_type, add_interaction, find_interaction, has_interactions, most_depvar, &
      all_interactions

   !> Stands in the solver's own constants of such an interaction, known after a restart
   real(wp), parameter, public :: mark = 20210047.0_wp

   !> One of them.
   type :: interaction_type
      !> Number of the material that the solver makes of it, 0 for none
      integer :: material = 0
      !> Properties
      real(wp), allocatable :: props(:)
      !> State variables that UINTER has
      integer :: depvar = 0
      !> Springs are made for slave nodes nearer than this, mm
      real(wp) :: search_distance = 0.0_wp
   end type interaction_type

   ! CalculiX' routines have no argument that could carry it
   type(interaction_type), allocatable, target :: interactions(:)

contains

   !> Keep an interaction, in place of an earlier one of the same material.
   subroutine add_interaction(interaction)
      !> The interaction
      type(interaction_type), intent(in) :: interaction

      if (.not. allocated(interactions)) allocate (interactions(0))
      interactions = [pack(interactions, interactions%material /= interaction%material), &
         interaction]
   end subroutine add_interaction

   !> The interaction of a material; not associated when UINTER does not serve it.
   function find_interaction(material) result(interaction)
      !> Number of the material
      integer, intent(in) :: material
      type(interaction_type), pointer :: interaction
      integer :: i

      interaction => null()
      if (.not. allocated(interactions)) return
      do i = 1, size(interactions)
         if (interactions(i)%material == material) interaction => interactions(i)
      end do
   end function find_interaction

   !> All of them.
   function all_interactions() result(list)
      type(interaction_type), allocatable :: list(:)

      allocate (list(0))
      if (allocated(interactions)) list = interactions
   end function all_interactions

   !> Whether there are any.
   logical function has_interactions()

      has_interactions = allocated(interactions)
   end function has_interactions

   !> Most state variables of all interactions.
   integer function most_depvar()

      most_depvar = 0
      if (allocated(interactions)) most_depvar = maxval([0, interactions%depvar])
   end function most_depvar

end module asperity_calculix_interactions
