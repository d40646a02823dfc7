!> What every deck is told besides its model: solver, contact, element, size of the mesh.
module asperity_deck_options
   use asperity_base_checks, only: check_positive, check_range
   use asperity_base_error, only: error_type, fatal_error
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_replay_sizes, only: check_size
   implicit none
   private
   public :: deck_choice, check_deck_choice, check_mesh_size, for_calculix, element_kind

   !> Choices of a deck.
   type :: deck_choice
      !> `calculix` or `abaqus`
      character(len=16) :: solver = 'calculix'
      !> `uinter`, `table` or `hard`
      character(len=16) :: contact = 'uinter'
      !> `c3d8i`, `c3d8` or `c3d8r`
      character(len=16) :: element = 'c3d8i'
      !> What is written of all nodes in every increment: `contact` for displacement and contact,
      !> `all` for stress too
      character(len=16) :: field = 'contact'
      !> Length of an edge aimed at, mm
      real(wp) :: mesh_size = 0.0_wp
      !> The same at the rims of mortise and tenon, mm; as everywhere when not allocated. Edges grow
      !> from there, each by a factor over its neighbour, which is chosen
      real(wp), allocatable :: rim_mesh_size
      real(wp) :: mesh_growth = 1.5_wp
      !> Pressure over penetration of hard contact in CalculiX, MPa/mm; chosen
      real(wp) :: penalty = 100.0_wp
      !> Clearance up to which CalculiX with UINTER makes springs, mm
      real(wp) :: search_distance = 3.0_wp
      !> Relative error and most rows of the law table
      real(wp) :: tolerance = 0.01_wp
      integer :: rows = 200
      !> Pressure up to which that error holds, MPa; the hardness when not allocated
      real(wp), allocatable :: largest_pressure
      !> Pressure from which it holds, MPa; the opening pressure when not allocated
      real(wp), allocatable :: smallest_pressure
      !> Pressure whose stick slope a constant slope takes, MPa; the model's own when not allocated
      real(wp), allocatable :: stick_pressure
      !> The command that makes the deck
      character(len=:), allocatable :: command
   end type deck_choice

   !> Limits of the growth of edges: above 1, and less than what makes one element jump the others
   real(wp), parameter :: least_growth = 1.01_wp, most_growth = 4.0_wp

contains

   !> Whether the deck is for CalculiX.
   pure elemental logical function for_calculix(choice)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice

      for_calculix = choice%solver == 'calculix'
   end function for_calculix

   !> Name of the element, as both solvers write it.
   pure function element_kind(choice) result(name)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      character(len=len_trim(choice%element)) :: name
      integer :: i

      name = trim(choice%element)
      do i = 1, len(name)
         if (name(i:i) >= 'a') name(i:i) = achar(iachar(name(i:i)) - 32)
      end do
   end function element_kind

   !> `error` is set when a number is not allowed.
   pure subroutine check_deck_choice(choice, accept_sizes, error)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> Let sizes outside the ranges of `asperity_replay_sizes` pass
      logical, intent(in) :: accept_sizes
      !> Set when one of them is refused
      type(error_type), allocatable, intent(out) :: error

      call check_positive(error, 'mesh_size', choice%mesh_size, 'mm')
      if (.not. allocated(error)) call check_positive(error, 'penalty', choice%penalty, 'MPa/mm')
      if (.not. allocated(error)) &
         call check_positive(error, 'search_distance', choice%search_distance, 'mm')
      call check_size(error, 'mesh_size', choice%mesh_size, accept_sizes)
      call check_size(error, 'search_distance', choice%search_distance, accept_sizes)
      if (.not. allocated(error) .and. allocated(choice%rim_mesh_size)) &
         call check_grading(choice, accept_sizes, error)
      if (allocated(error) .or. .not. allocated(choice%stick_pressure)) return
      call check_positive(error, 'stick_pressure', choice%stick_pressure, 'MPa')
   end subroutine check_deck_choice

   !> `error` is set when sizes of a graded mesh are not allowed.
   pure subroutine check_grading(choice, accept_sizes, error)
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> As of `check_deck_choice`
      logical, intent(in) :: accept_sizes
      type(error_type), allocatable, intent(inout) :: error

      call check_positive(error, 'rim_mesh_size', choice%rim_mesh_size, 'mm')
      if (.not. allocated(error)) call check_range(error, 'mesh_growth', choice%mesh_growth, &
         least_growth, most_growth, '')
      call check_size(error, 'rim_mesh_size', choice%rim_mesh_size, accept_sizes)
      if (allocated(error)) return
      if (choice%rim_mesh_size > choice%mesh_size) call fatal_error(error, 'rim_mesh_size = '// &
         to_text(choice%rim_mesh_size)//' mm is larger than mesh_size, '// &
         to_text(choice%mesh_size)//' mm: elements are finest at the rims', subject='rim_mesh_size')
   end subroutine check_grading

   !> Set `error`, unless it is set, when the mesh is coarser than a part is large.
   pure subroutine check_mesh_size(error, choice, name, extent)
      !> Set when the mesh is too coarse
      type(error_type), allocatable, intent(inout) :: error
      !> Choices of the deck
      type(deck_choice), intent(in) :: choice
      !> What is measured, and how much it is, mm
      character(len=*), intent(in) :: name
      real(wp), intent(in) :: extent

      if (allocated(error)) return
      if (choice%mesh_size > extent*(1.0_wp + 1.0e-9_wp)) call fatal_error(error, &
         'mesh_size = '//to_text(choice%mesh_size)//' mm is larger than the part: '//name// &
         ' is '//to_text(extent)//' mm', subject='mesh_size')
   end subroutine check_mesh_size

end module asperity_deck_options
