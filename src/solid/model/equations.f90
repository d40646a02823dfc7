!> Unknowns of a solid: which displacement of which node has which number.
module asperity_solid_model_equations
   use asperity_solid_mesh_joint, only: solid_mesh
   implicit none
   private
   public :: number_equations

   !> What stands for a displacement that is held, and for one that is moved by the programme
   integer, parameter, public :: held = 0, moved = -1

contains

   !> Number the displacements. The head of a column stays level: its nodes have one unknown.
   pure subroutine number_equations(mesh, holds_axially, numbers, n)
      !> The joint
      type(solid_mesh), intent(in) :: mesh
      !> Whether the axial node is held, and not on a spring
      logical, intent(in) :: holds_axially
      !> Number of each displacement, `held` or `moved`
      integer, allocatable, intent(out) :: numbers(:, :)
      !> How many unknowns there are
      integer, intent(out) :: n
      integer :: i, j

      allocate (numbers(3, size(mesh%nodes, 2)), source=1)
      numbers(:, mesh%foot) = held
      do i = 1, size(mesh%heads)
         numbers(1:2, mesh%heads(i)%nodes) = held
      end do
      numbers(2, mesh%middle) = held
      numbers(mesh%load_direction, mesh%load) = moved
      if (holds_axially) numbers(1, mesh%axial_node) = held
      do i = 1, size(mesh%heads)
         ! all of the head but its first node
         numbers(3, mesh%heads(i)%nodes(2:)) = held
      end do
      n = 0
      do i = 1, size(numbers, 2)
         do j = 1, 3
            if (numbers(j, i) /= 1) cycle
            n = n + 1
            numbers(j, i) = n
         end do
      end do
      do i = 1, size(mesh%heads)
         numbers(3, mesh%heads(i)%nodes) = numbers(3, mesh%heads(i)%nodes(1))
      end do
   end subroutine number_equations

end module asperity_solid_model_equations
