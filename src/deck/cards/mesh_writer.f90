!> Writes the parts of a model as decks of ABAQUS and of CalculiX share them: nodes, elements, sets,
!> surfaces, equations, sections, springs.
module asperity_deck_cards_mesh_writer
   use asperity_base_kinds, only: wp
   use asperity_base_number_text, only: to_text
   use asperity_deck_cards_card_writer, only: writer_type
   use asperity_deck_mesh_hexahedra, only: hex_mesh
   implicit none
   private
   public :: model_writer

   !> Figures of a coordinate, far more than a mesh needs
   integer, parameter :: figures = 10

   !> A deck under construction.
   type, extends(writer_type) :: model_writer
   contains
      !> Append the nodes of a part
      procedure :: nodes
      !> Append the elements of a part
      procedure :: elements
      !> Append a set of nodes
      procedure :: node_set
      !> Append a surface
      procedure :: surface
      !> Append equations that make nodes move as one of them
      procedure :: level
      !> Append a section of solid elements
      procedure :: section
      !> Append a spring to ground
      procedure :: grounded_spring
   end type model_writer

contains

   !> Append the nodes of a part.
   pure subroutine nodes(self, mesh, offset, set)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> The part
      type(hex_mesh), intent(in) :: mesh
      !> Number of the node before the first
      integer, intent(in) :: offset
      !> Set of all of them
      character(len=*), intent(in) :: set
      real(wp) :: place(3)
      integer :: i, j

      call self%line('*NODE, NSET='//set)
      do i = 1, size(mesh%nodes, 2)
         call self%add(to_text(offset + i))
         ! so that what is nearly nothing is nothing
         place = mesh%nodes(:, i)
         where (abs(place) < 1.0e-9_wp) place = 0.0_wp
         do j = 1, 3
            call self%add(', ')
            call self%real(place(j), figures)
         end do
         call self%line()
      end do
   end subroutine nodes

   !> Append the elements of a part.
   pure subroutine elements(self, mesh, element_offset, offset, kind, set)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> The part
      type(hex_mesh), intent(in) :: mesh
      !> Numbers of the element and of the node before the first
      integer, intent(in) :: element_offset, offset
      !> Kind of the elements, and set of all of them
      character(len=*), intent(in) :: kind, set
      integer :: i

      call self%line('*ELEMENT, TYPE='//kind//', ELSET='//set)
      do i = 1, size(mesh%elements, 2)
         call self%integers([element_offset + i, offset + mesh%elements(:, i)])
      end do
   end subroutine elements

   !> Append a set of nodes.
   pure subroutine node_set(self, name, numbers)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> Name of the set
      character(len=*), intent(in) :: name
      !> Numbers of the nodes
      integer, intent(in) :: numbers(:)

      call self%line('*NSET, NSET='//name)
      call self%integers(numbers)
   end subroutine node_set

   !> Append a surface.
   pure subroutine surface(self, name, faces)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> Name of the surface
      character(len=*), intent(in) :: name
      !> Element and number of each face
      integer, intent(in) :: faces(:, :)
      integer :: i

      call self%line('*SURFACE, NAME='//name//', TYPE=ELEMENT')
      do i = 1, size(faces, 2)
         call self%line(to_text(faces(1, i))//', S'//to_text(faces(2, i)))
      end do
   end subroutine surface

   !> Append equations that make nodes move as one of them in one direction.
   pure subroutine level(self, numbers, leader, direction)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> The nodes, and the one that leads
      integer, intent(in) :: numbers(:), leader
      !> 1, 2 or 3
      integer, intent(in) :: direction
      integer :: i

      call self%line('*EQUATION')
      do i = 1, size(numbers)
         if (numbers(i) == leader) cycle
         call self%line('2')
         call self%line(to_text(numbers(i))//', '//to_text(direction)//', 1.0, '// &
            to_text(leader)//', '//to_text(direction)//', -1.0')
      end do
   end subroutine level

   !> Append a section of solid elements.
   pure subroutine section(self, elements, material, axes)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> Names of the set of elements, of the material and of its local axes
      character(len=*), intent(in) :: elements, material, axes

      call self%line('*SOLID SECTION, ELSET='//elements//', MATERIAL='//material// &
         ', ORIENTATION='//axes)
   end subroutine section

   !> Append a spring to ground.
   pure subroutine grounded_spring(self, name, element, node, direction, stiffness)
      !> The deck
      class(model_writer), intent(inout) :: self
      !> Name of the set of its one element
      character(len=*), intent(in) :: name
      !> Numbers of the element and of the node; direction 1, 2 or 3
      integer, intent(in) :: element, node, direction
      !> Stiffness, N/mm
      real(wp), intent(in) :: stiffness

      call self%line('*ELEMENT, TYPE=SPRING1, ELSET='//name)
      call self%integers([element, node])
      call self%line('*SPRING, ELSET='//name)
      call self%integers([direction])
      call self%reals([stiffness])
   end subroutine grounded_spring

end module asperity_deck_cards_mesh_writer
